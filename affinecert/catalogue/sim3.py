"""The catalogue of SIM(3): exponential, logarithms by both strategies, and the condition of V."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import replace

import numpy as np

from affinecert.catalogue import similarities
from affinecert.catalogue.parts import LINEAR, LINEAR_BLOCKS, TRANSLATION, WHOLE
from affinecert.catalogue.similarities import Similarities, Similarity
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Group, Map, Point, Regime
from affinecert.reference import sim3 as reference
from affinecert.sampling import homogeneous, signed, vector

OMEGA = np.s_[:3,]
V = np.s_[3:6,]
GROWTH = np.s_[6:,]

TANGENT = Argument("tangent", (7,), (Group(OMEGA), Group(V), Group(GROWTH)), "radian, length, 1")
POSE = Argument("pose", (4, 4), (Group(LINEAR, "entries"), Group(TRANSLATION)), "1, length", manifold="similarities")
BLOCKS = (Block("omega", 0, OMEGA), Block("v", 0, V), Block("growth", 0, GROWTH))

POSES = (
    similarities.GENERIC,
    similarities.GRID,
    similarities.RATIO,
    similarities.TINY,
    similarities.NO_GROWTH,
    similarities.NO_TURN,
    similarities.LARGE_GROWTH,
    similarities.NEAR_PI,
    similarities.AT_PI,
    similarities.OFF_BY_ULPS,
    similarities.OFF_MANIFOLD,
)
"""What a logarithm is tried on."""

TANGENTS = (
    *POSES[:8],
    similarities.NEAR_TWO_PI,
    similarities.MANY_TURNS,
    similarities.HUGE_ANGLE,
)
"""What an exponential is tried on."""


def _regimes(
    kinds: Iterable[Similarities], inputs: Callable[[Draw, Similarity], tuple[Array, ...]]
) -> tuple[Regime, ...]:
    """A regime for each kind of similarity; ``inputs`` makes the inputs of the map from one."""

    def regime(kind: Similarities) -> Regime:
        def build(draw: Draw) -> Point:
            similarity = kind.build(draw)
            return Point(inputs(draw, similarity), similarity.distance)

        return Regime(kind.name, build, kind.distance)

    return tuple(regime(kind) for kind in kinds)


def _translated(join: Callable[[Similarity, Array], Array]) -> tuple[Regime, ...]:
    """The regimes about the translation, or about v; ``join`` makes a pose or a tangent of it."""

    def screw(draw: Draw) -> Point:
        similarity = draw.choice((similarities.GENERIC, similarities.GRID, similarities.NEAR_PI)).build(draw)
        axis, off_axis = similarity.turn.axis, draw.exponent(-16, 0)
        size = draw.exponent(-3, 3)
        return Point((join(similarity, size * (axis + off_axis * np.cross(axis, draw.direction(3)))),), off_axis)

    def tiny_next_to_huge(draw: Draw) -> Point:
        similarity = draw.choice((similarities.GENERIC, similarities.GRID, similarities.TINY)).build(draw)
        size = draw.choice((draw.exponent(8, 150), draw.exponent(-150, -8)))
        return Point((join(similarity, size * draw.direction(3)),), size)

    return (
        Regime("screw", screw, "part of the translation off the axis"),
        Regime("tiny-next-to-huge", tiny_next_to_huge, "length of the translation"),
    )


def _no_similarity(draw: Draw) -> Array:
    """A pose that is none: its linear part stretched one way, mirrored or singular, or another last row; (4, 4)."""
    similarity = similarities.GENERIC.build(draw)
    pose = similarity.pose(vector(draw))
    # Of a column stretched by 1 + d, d^2 is what its L^T L differs from I by, at least, for L of determinant 1.
    stretch = draw.exponent(-5, 1)
    if draw.choice((True, False)):
        pose[:3, 0] *= draw.choice((1.0 + stretch, 1.0 / (1.0 + stretch), -1.0, 0.0))
    else:
        pose[3, draw.choice(range(4))] += stretch
    return pose


def _tangent_at(draw: Draw, omega: Array) -> Array:
    """A tangent with that rotation vector, whatever else it is."""
    return np.concatenate([omega, vector(draw), [draw.uniform(-2.0, 2.0)]])


def _with(draw: Draw, similarity: Similarity, omega: Array) -> tuple[Array, Array]:
    """The pose, and a tangent of that rotation vector; of none where the pose neither turns nor grows."""
    still = similarity.growth == 0.0 and not np.any(similarity.turn.vector)
    return similarity.pose(vector(draw)), _tangent_at(draw, np.zeros(3) if still else omega)


def _along(draw: Draw, similarity: Similarity, along: float) -> tuple[Array, Array]:
    """The pose, and a tangent so far along its axis, and anywhere across."""
    axis = similarity.turn.axis
    return _with(draw, similarity, along * axis + np.cross(axis, draw.direction(3)) * draw.exponent(-3, 1))


def _any_other(draw: Draw, similarity: Similarity) -> tuple[Array, Array]:
    return _with(draw, similarity, vector(draw, -2, 1))


def _far(draw: Draw, similarity: Similarity) -> tuple[Array, Array]:
    return _with(draw, similarity, vector(draw, 2, 8))


def _origin(draw: Draw, similarity: Similarity) -> tuple[Array, Array]:
    return similarity.pose(vector(draw)), np.zeros(7)


def _beyond_pi(draw: Draw, similarity: Similarity) -> tuple[Array, Array]:
    """Nearer to the vector on the other side of pi, which is so where (angle - pi) - along is positive."""
    angle = float(np.linalg.norm(similarity.turn.vector))
    return _along(draw, similarity, angle - math.pi - draw.exponent(-3, 1))


def _whole_turns(draw: Draw, similarity: Similarity) -> tuple[Array, Array]:
    """One to three turns off the principal logarithm."""
    turns_off = draw.choice((-3, -2, -1, 1, 2, 3))
    return _along(draw, similarity, 2 * math.pi * turns_off + signed(draw, -8, math.log10(3)))


def _some_turns(draw: Draw, similarity: Similarity) -> tuple[Array, Array]:
    angle = float(np.linalg.norm(similarity.turn.vector))
    turns_off = draw.choice(range(-3, 4))
    return _along(draw, similarity, angle + 2 * math.pi * turns_off + signed(draw, -8, math.log10(3)))


def _tie(halves: Iterable[int]) -> Callable[[Draw], Point]:
    """Almost as near to one logarithm as to another; ``halves`` are the odd multiples of pi between the two."""

    def build(draw: Draw) -> Point:
        similarity = similarities.GENERIC.build(draw)
        # Told to about 1e-15, as for so3.log_near: a tie closer than 1e-10 would be a guess.
        gap = signed(draw, -10, 0)
        angle = float(np.linalg.norm(similarity.turn.vector))
        return Point(_along(draw, similarity, angle + draw.choice(tuple(halves)) * math.pi + gap), abs(gap))

    return build


def _identity_and_whole_turns(draw: Draw) -> Point:
    omega = draw.uniform(3.5, 30.0) * draw.direction(3)
    return Point((homogeneous(np.eye(3), vector(draw)), _tangent_at(draw, omega)), 0.0)


def _outside(build: Callable[[Draw], Point]) -> Regime:
    return Regime("outside", build, "stretch, or error of the last row", share=0.25)


def _refused_with_another(draw: Draw) -> Point:
    return Point((_no_similarity(draw), _tangent_at(draw, vector(draw))), 0.0)


def _refused_or_singular(draw: Draw) -> Point:
    return draw.choice((_refused_with_another, _identity_and_whole_turns))(draw)


MAPS = (
    Map(
        name="sim3.exp",
        definition="exp [[ lambda I + [omega]x, v ], [0, 0]], the similarity of the tangent (omega, v, lambda)",
        source="gallier, section 2, Propositions 2.1 and 2.2 and Theorem 2.3",
        domain="every tangent in R^7",
        arguments=(TANGENT,),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=(
            *_regimes(TANGENTS, lambda draw, similarity: (similarity.tangent(vector(draw)),)),
            *_translated(lambda similarity, v: similarity.tangent(v)),
        ),
        reference=reference.exp,
        inverse="sim3.log",
        cost=3.0,
    ),
    Map(
        name="sim3.log",
        definition="(omega, v, lambda) with exp(omega, v, lambda) = A, omega principal, lambda = log(det A) / 3",
        source="gallier, sections 3 and 4, Theorem 3.2",
        domain="linear part a multiple of a rotation within 1e-6 of it, the nearest one counts; last row 0 0 0 1",
        arguments=(POSE,),
        outputs=((7,),),
        blocks=BLOCKS,
        regimes=(
            *_regimes(POSES, lambda draw, similarity: (similarity.pose(vector(draw)),)),
            *_translated(lambda similarity, translation: similarity.pose(translation)),
            _outside(lambda draw: Point((_no_similarity(draw),), 0.0)),
        ),
        reference=reference.log,
        continuation=reference.continue_log,
        inverse="sim3.exp",
        cost=6.0,
    ),
    Map(
        name="sim3.log_next",
        definition="the log of A whose omega, the principal w or (1 - 2 pi / |w|) w, is nearer to that of `previous`",
        source="gallier, section 5, strategy 1",
        domain="A as for sim3.log; every `previous` in R^7",
        arguments=(POSE, Argument("previous", (7,), (), "radian, length, 1")),
        outputs=((7,),),
        blocks=BLOCKS,
        regimes=(
            *_regimes((similarities.GENERIC, similarities.GRID), _any_other),
            *_regimes((replace(similarities.NEAR_PI, name="beyond-pi"),), _beyond_pi),
            *_regimes((replace(similarities.RATIO, name="the-long-way"),), _beyond_pi),
            *_regimes((replace(similarities.AT_PI, name="principal-at-pi"),), _origin),
            *_regimes((replace(similarities.GROWING, name="at-identity"),), _any_other),
            Regime("near-tie", _tie((-1,)), "distance from a tie"),
            _outside(_refused_with_another),
        ),
        reference=reference.log_next,
        continuation=reference.continue_log_next,
        cost=6.0,
        remark="the choice does not change under perturbation: the condition is that of the logarithm chosen",
    ),
    Map(
        name="sim3.log_near",
        definition="of all logs of A the one whose rotation vector is nearest to that of `near`; the shorter in a tie",
        source="gallier, section 5, strategy 2",
        domain="A as for sim3.log; every `near` in R^7, but no whole turns where A neither turns nor grows",
        arguments=(POSE, Argument("near", (7,), (Group(OMEGA),), "radian, length, 1")),
        outputs=((7,),),
        blocks=BLOCKS,
        regimes=(
            *_regimes((similarities.GENERIC, similarities.NO_GROWTH, similarities.LARGE_GROWTH), _some_turns),
            *_regimes((similarities.NEAR_PI, similarities.AT_PI), _some_turns),
            *_regimes((replace(similarities.RATIO, name="whole-turns"),), _whole_turns),
            *_regimes((replace(similarities.GROWING, name="at-identity"),), _any_other),
            *_regimes((replace(similarities.GENERIC, name="huge-near"),), _far),
            Regime("near-tie", _tie(range(-5, 6, 2)), "distance from a tie"),
            _outside(_refused_or_singular),
        ),
        reference=reference.log_near,
        continuation=reference.continue_log_near,
        cost=6.0,
    ),
    Map(
        name="sim3.condition",
        definition="the condition number of V = sum (lambda I + [omega]x)^k / (k + 1)! in the 2-norm",
        source="gallier, section 3, Proposition 3.1, and section 5",
        domain="every tangent in R^7: no float64 is a multiple of pi, so that V is never singular",
        arguments=(replace(TANGENT, groups=(Group(OMEGA), Group(GROWTH))),),
        outputs=((),),
        blocks=(Block("condition", 0, WHOLE),),
        regimes=_regimes(TANGENTS, lambda draw, similarity: (similarity.tangent(vector(draw)),)),
        reference=reference.condition,
        cost=2.0,
    ),
)
