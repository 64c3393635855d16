"""The catalogue of SE(3): exponential and logarithm of rigid motions, scored apart in rotation and translation."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from affinecert.catalogue import turns
from affinecert.catalogue.parts import LINEAR, TRANSLATION
from affinecert.catalogue.turns import Turn, Turns
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Group, Map, Point, Regime
from affinecert.reference import se3 as reference
from affinecert.sampling import homogeneous, vector

POSE = Argument("pose", (4, 4), (Group(LINEAR, "entries"), Group(TRANSLATION)), "1, length", manifold="rotations")

OMEGA = np.s_[:3,]
V = np.s_[3:,]

Motion = tuple[Turn, Array, float]
"""A rotation, a translation (or the v of a twist), and the distance to what makes them difficult."""


def _screw(draw: Draw) -> Motion:
    turn = draw.choice((turns.GENERIC, turns.NEAR_TWO_PI, turns.NEAR_PI)).build(draw)
    off_axis = draw.exponent(-16, 0)
    return turn, draw.exponent(-3, 3) * (turn.axis + off_axis * np.cross(turn.axis, draw.direction(3))), off_axis


def _tiny_next_to_huge(draw: Draw) -> Motion:
    turn = draw.choice((turns.TINY, turns.NEAR_IDENTITY, turns.GENERIC, turns.NEAR_PI)).build(draw)
    size = draw.choice((draw.exponent(8, 150), draw.exponent(-150, -8)))
    return turn, size * draw.direction(3), size


def _no_rotation(draw: Draw) -> Motion:
    size = draw.exponent(-290, 290)
    return Turn(np.zeros(3), np.zeros(3), np.eye(3), 0.0), size * draw.direction(3), size


def _regimes(kinds: Iterable[Turns], join: Callable[[Turn, Array], Array]) -> tuple[Regime, ...]:
    """Regimes of twists or of poses, as ``join`` makes them of a rotation and a translation."""

    def motions(build: Callable[[Draw], Motion]) -> Callable[[Draw], Point]:
        def point(draw: Draw) -> Point:
            turn, translation, distance = build(draw)
            return Point((join(turn, translation),), distance)

        return point

    return (
        *turns.regimes(kinds, lambda draw, turn: (join(turn, vector(draw)),)),
        Regime("screw", motions(_screw), "part of the translation off the axis"),
        Regime("tiny-next-to-huge", motions(_tiny_next_to_huge), "length of the translation"),
        Regime("no-rotation", motions(_no_rotation), "length of the translation"),
    )


def _outside(draw: Draw) -> Point:
    turn = turns.no_rotation(draw)
    matrix = homogeneous(turn.matrix, vector(draw))
    if draw.choice((True, False)):
        matrix = homogeneous(np.eye(3), vector(draw))
        matrix[3, draw.choice(range(4))] += turn.distance
    return Point((matrix,), turn.distance)


MAPS = (
    Map(
        name="se3.exp",
        definition="exp [[ [omega]x, v ], [0, 0]], the rigid motion of the twist (omega, v)",
        source="bansal_tatu, A.2.1",
        domain="every twist in R^6",
        arguments=(Argument("twist", (6,), (Group(OMEGA), Group(V)), "radian, length"),),
        outputs=((4, 4),),
        blocks=(Block("rotation", 0, LINEAR), Block("translation", 0, TRANSLATION)),
        regimes=_regimes(turns.VECTORS, lambda turn, v: np.concatenate([turn.vector, v])),
        reference=reference.exp,
        inverse="se3.log",
        cost=2.0,
    ),
    Map(
        name="se3.log",
        definition="the twist (omega, v) with exp(omega, v) = E, omega the so3.log of the rotation",
        source="bansal_tatu, A.2.2",
        domain="rotation within 1e-6 of SO(3), the nearest one counts; last row 0 0 0 1",
        arguments=(POSE,),
        outputs=((6,),),
        blocks=(Block("omega", 0, OMEGA), Block("v", 0, V)),
        regimes=(
            *_regimes(turns.MATRICES, lambda turn, translation: homogeneous(turn.matrix, translation)),
            Regime("outside", _outside, "stretch, or error of the last row", share=0.5),
        ),
        reference=reference.log,
        continuation=reference.continue_log,
        inverse="se3.exp",
        cost=4.0,
    ),
)
