"""The catalogue of Kaji and Ochiai's twelve parameters of an affine map of space, and of what is done in them."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from affinecert.catalogue import stretched_turns, stretches, turns
from affinecert.catalogue.parts import ENTRIES, LINEAR, LINEAR_BLOCKS, TIME, TRANSLATION
from affinecert.catalogue.stretched_turns import StretchedTurns
from affinecert.catalogue.stretches import Stretches
from affinecert.catalogue.turns import Turns
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Group, Map, Point, Regime
from affinecert.reference import kaji_ochiai as reference
from affinecert.sampling import half_turns, homogeneous, scalar, signed, vector, well_conditioned

Affine = tuple[Array, float]
"""An affine map of space, (4, 4), and its distance to what makes it difficult."""

MOVE, TURN, STRETCH = np.s_[:3,], np.s_[3:6,], np.s_[6:,]
"""Where the parameters of translation, rotation and stretch are."""

PARAMETERS = (Block("translation", 0, MOVE), Block("rotation_vector", 0, TURN), Block("log_stretch", 0, STRETCH))
AFFINE = Argument("affine", (4, 4), (Group(LINEAR), Group(TRANSLATION)), "1, length")

ALL_LINEAR, ALL_TRANSLATIONS = np.s_[..., :-1, :-1], np.s_[..., :-1, -1]
"""The same of several homogeneous matrices."""


def _poses(name: str, count: str) -> Argument:
    return Argument(name, (count, 4, 4), (Group(ALL_LINEAR), Group(ALL_TRANSLATIONS)), "1, length")


def parameters(translation: Array, omega: Array, logarithm: Array) -> Array:
    """The twelve parameters, (12,), of a symmetric logarithm (3, 3)."""
    return np.concatenate([translation, omega, logarithm[np.triu_indices(3)]])


def _of(kind: StretchedTurns) -> Callable[[Draw], Affine]:
    """Affine maps with such a linear part, and a translation of about its size."""

    def build(draw: Draw) -> Affine:
        linear, distance = kind.build(draw, 3)
        return homogeneous(linear, float(np.abs(linear).max()) * vector(draw)), distance

    return build


def _turned(kind: Turns, stretch: Stretches) -> Callable[[Draw], Affine]:
    """A stretch before a rotation, with the rotation's distance."""

    def build(draw: Draw) -> Affine:
        turn = kind.build(draw)
        return homogeneous(turn.matrix @ stretch.build(draw)[0], vector(draw)), turn.distance

    return build


def _at_pi(draw: Draw) -> Affine:
    """A rotation by pi exactly: of entries 0 and +-1, after a stretch that it permutes without rounding."""
    stretch, distance = draw.choice((stretches.GENERIC, stretches.ILL_CONDITIONED)).build(draw)
    return homogeneous(draw.choice(half_turns()) @ stretch, vector(draw)), distance


def _only_stretched(draw: Draw) -> Affine:
    """No rotation at all: a symmetric matrix."""
    stretch, distance = draw.choice((stretches.GENERIC, stretches.ILL_CONDITIONED, stretches.LAST_BITS)).build(draw)
    return homogeneous(stretch, vector(draw)), distance


def _tiny_next_to_huge(draw: Draw) -> Affine:
    size = draw.exponent(-100, 100)
    return homogeneous(well_conditioned(draw, 3), size * draw.direction(3)), size


def _outside(draw: Draw) -> Affine:
    """A reflection, a projection, or a matrix with another last row."""
    linear, distance = stretched_turns.OUTSIDE.build(draw, 3)
    if draw.choice((True, False)):
        return homogeneous(linear, vector(draw)), distance
    affine = homogeneous(well_conditioned(draw, 3), vector(draw))
    error = draw.exponent(-15, 0)
    affine[3, draw.choice(range(4))] += error
    return affine, error


Kind = tuple[str, str, Callable[[Draw], Affine]]

ANY: Kind = ("generic", "ratio of the extreme singular values", _of(stretched_turns.GENERIC))
NEAR_PI: Kind = ("near-pi", "pi - angle", _turned(turns.NEAR_PI, stretches.GENERIC))
NEAR_IDENTITY: Kind = ("near-identity", "angle", _turned(turns.NEAR_IDENTITY, stretches.NEAR_IDENTITY))
HUGE_OR_TINY: Kind = ("huge-or-tiny", "scale", _of(stretched_turns.HUGE_OR_TINY))
RIGID: Kind = ("rigid", "distance from a rotation", _of(stretched_turns.ROTATION))
NEARLY_SINGULAR: Kind = ("nearly-singular", "smallest singular value", _of(stretched_turns.NEARLY_SINGULAR))
AT_PI: Kind = ("at-pi", "ratio of the extreme singular values", _at_pi)
ONLY_STRETCHED: Kind = ("only-stretched", "ratio of the extreme singular values", _only_stretched)
OUTSIDE: Kind = ("outside", "size of what is wrong", _outside)

AFFINES: tuple[Kind, ...] = (
    ANY,
    NEAR_IDENTITY,
    RIGID,
    NEAR_PI,
    AT_PI,
    ONLY_STRETCHED,
    NEARLY_SINGULAR,
    ("nearly-rank-one", "sum of the smallest singular values", _of(stretched_turns.NEARLY_RANK_ONE)),
    ("meeting", "half the gap of two singular values", _of(stretched_turns.MEETING)),
    ("last-bits", "determinant over the cube of the norm", _of(stretched_turns.LAST_BITS)),
    HUGE_OR_TINY,
    ("tiny-next-to-huge", "length of the translation", _tiny_next_to_huge),
    OUTSIDE,
)
"""What the parametrisation is tried on."""


def _regime(kind: Kind, more: Callable[[Draw], tuple[Array, ...]] | None = None, share: float = 0.5) -> Regime:
    """The regime of such an affine map, and what is drawn with it."""
    name, distance, affine = kind

    def build(draw: Draw) -> Point:
        matrix, gap = affine(draw)
        return Point((matrix, *(more(draw) if more else ())), gap)

    return Regime(name, build, distance, share)


def _any_goal(draw: Draw) -> tuple[Array, ...]:
    """Other parameters, their rotation vector up to five turns long."""
    return (
        parameters(vector(draw), draw.uniform(0.0, 30.0) * draw.direction(3), stretches.SYMMETRIC[0].build(draw)[0]),
    )


def _short_goal(draw: Draw) -> tuple[Array, ...]:
    """The same, less than half a turn long: what has no rotation stays without."""
    return (parameters(vector(draw), draw.uniform(0.0, 3.0) * draw.direction(3), np.zeros((3, 3))),)


def _turns_on(draw: Draw) -> Point:
    """A motion of several turns, and parameters of a little before on its way: what algorithm 1 is for."""
    turn, whole = turns.GENERIC.build(draw), 2 * math.pi * draw.choice((-3, -2, -1, 1, 2, 3))
    goal = turn.vector + whole * turn.axis + draw.exponent(-3, 0.4) * draw.direction(3)
    affine = homogeneous(turn.matrix @ stretches.GENERIC.build(draw)[0], vector(draw))
    return Point((affine, parameters(vector(draw), goal, np.zeros((3, 3)))), turn.distance)


def _halfway(draw: Draw) -> Point:
    """Parameters next to halfway between two rotation vectors that will do."""
    turn, gap = turns.GENERIC.build(draw), signed(draw, -12, -1)
    halfway = turn.vector + (draw.choice((-3, -1, 1, 3)) * math.pi + gap) * turn.axis
    affine = homogeneous(turn.matrix @ stretches.GENERIC.build(draw)[0], vector(draw))
    return Point((affine, parameters(vector(draw), halfway, np.zeros((3, 3)))), abs(gap))


def _parameters_of(
    omega: Callable[[Draw], Array], stretch: Stretches, lengths: tuple[float, float] = (-3, 3)
) -> Callable[[Draw], Point]:
    """Parameters of that rotation vector and that logarithm of a stretch."""

    def build(draw: Draw) -> Point:
        logarithm, distance = stretch.build(draw)
        return Point((parameters(vector(draw, *lengths), omega(draw), logarithm),), distance)

    return build


def _vector_of(kind: Turns) -> Callable[[Draw], Array]:
    return lambda draw: kind.build(draw).vector


_LOGARITHMS = {kind.name: kind for kind in stretches.SYMMETRIC}


def _realised(name: str, kind: Turns, logarithm: str, distance: str, lengths: tuple[float, float] = (-3, 3)) -> Regime:
    return Regime(name, _parameters_of(_vector_of(kind), _LOGARITHMS[logarithm], lengths), distance, 0.5)


def _several(kind: Kind, count: int) -> Callable[[Draw], tuple[Array, float]]:
    """One affine map of a kind among others, (count, 4, 4), and its distance."""

    def build(draw: Draw) -> tuple[Array, float]:
        affine, gap = kind[2](draw)
        rest = [ANY[2](draw)[0] for _ in range(count - 1)]
        rest.insert(draw.choice(range(count)), affine)
        return np.stack(rest), gap

    return build


def _all(kind: Kind, count: int) -> Callable[[Draw], tuple[Array, float]]:
    """Affine maps of one kind, (count, 4, 4), and the smallest of their distances."""

    def build(draw: Draw) -> tuple[Array, float]:
        affines, gaps = zip(*(kind[2](draw) for _ in range(count)), strict=True)
        return np.stack(affines), min(gaps)

    return build


def _all_huge_or_tiny(draw: Draw) -> tuple[Array, float]:
    """Affine maps that are huge or tiny alike, for they are perturbed together."""
    affines, _ = _all(ANY, 3)(draw)
    scale = draw.exponent(-100, 100)
    affines[:, :3] *= scale
    return affines, scale


def _average(draw: Draw, count: int) -> Array:
    """Positive weights, of sum 1 but for rounding."""
    weights = np.array([draw.uniform(0.0, 1.0) for _ in range(count)])
    return weights / max(float(weights.sum()), 0.1)


def _any_weights(draw: Draw, count: int) -> Array:
    return np.array([draw.uniform(-1.0, 2.0) for _ in range(count)])


def _one_alone(draw: Draw, count: int) -> Array:
    weights = np.zeros(count)
    weights[draw.choice(range(count))] = 1.0
    return weights


Weights = Callable[[Draw, int], Array]
Several = Callable[[Draw], tuple[Array, float]]

BLENDED: tuple[tuple[str, str, Several, Weights], ...] = (
    ("generic", ANY[1], _all(ANY, 3), _average),
    ("rigid", RIGID[1], _all(RIGID, 3), _average),
    ("near-identity", NEAR_IDENTITY[1], _all(NEAR_IDENTITY, 3), _average),
    ("near-pi", NEAR_PI[1], _several(NEAR_PI, 3), _average),
    ("at-pi", AT_PI[1], _several(AT_PI, 3), _average),
    ("nearly-singular", NEARLY_SINGULAR[1], _several(NEARLY_SINGULAR, 3), _average),
    ("huge-or-tiny", HUGE_OR_TINY[1], _all_huge_or_tiny, _average),
    ("extrapolation", ANY[1], _all(ANY, 3), _any_weights),
    ("one-alone", ANY[1], _all(ANY, 3), _one_alone),
    ("outside", OUTSIDE[1], _several(OUTSIDE, 3), _average),
)


def _blended(name: str, distance: str, affines: Several, weights: Weights) -> Regime:
    def build(draw: Draw) -> Point:
        matrices, gap = affines(draw)
        return Point((matrices, weights(draw, len(matrices))), gap)

    return Regime(name, build, distance, share=0.2)


def _steps(draw: Draw, count: int) -> Array:
    """Knots, a distance of 1/2 to 2 apart."""
    return np.cumsum([draw.uniform(0.5, 2.0) for _ in range(count)]) - 1.0


def _uneven_steps(draw: Draw, count: int) -> Array:
    """Knots at distances of 1/30 to 10; a wider range would make splines swing beyond that of the exponential."""
    return np.cumsum([draw.exponent(-1.5, 1) for _ in range(count)])


def _between(draw: Draw, knots: Array) -> float:
    return draw.uniform(float(knots[0]), float(knots[-1]))


def _beyond(draw: Draw, knots: Array) -> float:
    away = draw.uniform(0.0, 1.0)
    return draw.choice((float(knots[0]) - away, float(knots[-1]) + away))


def _at_a_knot(draw: Draw, knots: Array) -> float:
    return float(draw.choice(tuple(knots)))


def _twisting(draw: Draw) -> tuple[Array, float]:
    """Poses that turn on about one axis by up to 3 radians from one to the next: several turns together."""
    axis, angle, poses, largest = draw.direction(3), 0.0, [], 0.0
    for _ in range(4):
        turn = turns.about(axis, angle, 0.0)
        poses.append(homogeneous(turn.matrix @ stretches.GENERIC.build(draw)[0], vector(draw, -1, 1)))
        step = draw.uniform(1.0, 3.0)
        angle, largest = angle + step, max(largest, step)
    return np.stack(poses), math.pi - largest


INTERPOLATED: tuple[tuple[str, str, Several, Callable[[Draw, int], Array], Callable[[Draw, Array], float]], ...] = (
    ("generic", ANY[1], _all(ANY, 4), _steps, _between),
    ("rigid", RIGID[1], _all(RIGID, 3), _steps, _between),
    ("two-keys", ANY[1], _all(ANY, 2), _steps, _between),
    ("twisting", "pi - largest step", _twisting, _steps, _between),
    ("near-pi", NEAR_PI[1], _several(NEAR_PI, 3), _steps, _between),
    ("uneven-knots", ANY[1], _all(ANY, 3), _uneven_steps, _between),
    ("extrapolation", ANY[1], _all(ANY, 3), _steps, _beyond),
    ("at-a-knot", ANY[1], _all(ANY, 3), _steps, _at_a_knot),
)


def _interpolated(
    name: str,
    distance: str,
    poses: Several,
    knots: Callable[[Draw, int], Array],
    time: Callable[[Draw, Array], float],
) -> Regime:
    def build(draw: Draw) -> Point:
        matrices, gap = poses(draw)
        places = knots(draw, len(matrices))
        return Point((matrices, places, scalar(time(draw, places))), gap)

    return Regime(name, build, distance, share=0.15)


def _no_sequence(draw: Draw) -> Point:
    """A pose outside, or knots two of which are equal or the wrong way round."""
    knots, gap = _steps(draw, 3), draw.choice((0.0, draw.exponent(-16, 0)))
    time = scalar(_between(draw, knots))
    if draw.choice((True, False)):
        poses, wrong = _several(OUTSIDE, 3)(draw)
        return Point((poses, knots, time), wrong)
    knots[2] = knots[1] - gap
    return Point((_all(ANY, 3)(draw)[0], knots, time), gap)


def _deformed(name: str, distance: str, probes: Several, weights: Weights, far: float = 0.0) -> Regime:
    def build(draw: Draw) -> Point:
        matrices, gap = probes(draw)
        points = np.stack([vector(draw, far - 1, far + 1) for _ in range(2)])
        return Point((points, matrices, np.stack([weights(draw, len(matrices)) for _ in points])), gap)

    return Regime(name, build, distance, share=0.15)


CONDITION = "poses are perturbed by the norm of all linear parts together, and of all translations"

MAPS = (
    Map(
        name="kaji_ochiai.parametrise",
        definition="psi(A) = (translation, log(L S^-1), log S), S = sqrt(L^T L); the rotation's logarithm is principal",
        source="kaji_ochiai, equation 3",
        domain="affine maps of space of positive determinant; last row 0 0 0 1",
        arguments=(AFFINE,),
        outputs=((12,),),
        blocks=PARAMETERS,
        regimes=tuple(_regime(kind) for kind in AFFINES),
        reference=reference.parametrise,
        continuation=reference.continue_parametrise,
        inverse="kaji_ochiai.realise",
        accuracy=8.0,
        cost=10.0,
    ),
    Map(
        name="kaji_ochiai.parametrise_near",
        definition="psi(A) with the rotation vector nearest to that of given parameters",
        source="kaji_ochiai, section 4.3 and algorithm 1",
        domain="A as for kaji_ochiai.parametrise; any twelve parameters, of which the rotation vector counts",
        arguments=(AFFINE, Argument("near", (12,), (Group(TURN),), "length, radian, 1")),
        outputs=((12,),),
        blocks=PARAMETERS,
        regimes=(
            *(_regime(kind, _any_goal, 0.3) for kind in (ANY, RIGID, NEAR_PI, AT_PI, NEARLY_SINGULAR, HUGE_OR_TINY)),
            _regime(ONLY_STRETCHED, _short_goal, 0.3),
            Regime("several-turns", _turns_on, "angle", 0.3),
            Regime("halfway", _halfway, "distance from halfway", 0.3),
            _regime(OUTSIDE, _any_goal, 0.3),
        ),
        reference=reference.parametrise_near,
        continuation=reference.continue_parametrise_near,
        accuracy=8.0,
        cost=10.0,
    ),
    Map(
        name="kaji_ochiai.realise",
        definition="phi(l, x, y) = the translation by l after exp([x]) exp(Y)",
        source="kaji_ochiai, equation 2",
        domain="any twelve parameters",
        arguments=(Argument("parameters", (12,), (Group(MOVE), Group(TURN), Group(STRETCH)), "length, radian, 1"),),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=(
            _realised("generic", turns.GENERIC, "generic", "largest logarithm of a stretch"),
            _realised("near-identity", turns.NEAR_IDENTITY, "near-zero", "size of the logarithm"),
            _realised("tiny", turns.TINY, "tiny", "size of the logarithm", (-300, -16)),
            _realised("meeting", turns.NEAR_PI, "meeting", "half the gap of two logarithms"),
            _realised("triple", turns.NEAR_TWO_PI, "triple", "spread of the logarithms"),
            _realised("huge-angle", turns.HUGE_ANGLE, "generic", "largest logarithm of a stretch"),
            _realised("huge-stretch", turns.GENERIC, "huge", "largest logarithm of a stretch"),
            _realised("huge-translation", turns.GENERIC, "generic", "largest logarithm of a stretch", (3, 300)),
        ),
        reference=reference.realise,
        inverse="kaji_ochiai.parametrise",
        accuracy=8.0,
        cost=8.0,
    ),
    Map(
        name="kaji_ochiai.blend",
        definition="phi(w_1 psi(A_1) + ... + w_n psi(A_n))",
        source="kaji_ochiai, equation 9",
        domain="A_1, ..., A_n as for kaji_ochiai.parametrise; any weights",
        arguments=(_poses("affines", "count"), Argument("weights", ("count",), (ENTRIES,), "1")),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=tuple(_blended(*kind) for kind in BLENDED),
        reference=reference.blend,
        continuation=reference.continue_blend,
        accuracy=8.0,
        cost=40.0,
        remark=CONDITION,
    ),
    Map(
        name="kaji_ochiai.interpolate",
        definition="phi of the natural cubic spline through psi(A_1), ..., psi(A_m), each nearest to the one before",
        source="kaji_ochiai, section 5.4",
        domain="poses as for kaji_ochiai.parametrise, two or more; increasing knots; every t",
        arguments=(_poses("poses", "keys"), Argument("knots", ("keys",), (ENTRIES,), "1"), TIME),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=(
            *(_interpolated(*kind) for kind in INTERPOLATED),
            Regime("outside", _no_sequence, "size of what is wrong", share=0.15),
        ),
        reference=reference.interpolate,
        continuation=reference.continue_interpolate,
        accuracy=8.0,
        cost=60.0,
        remark=CONDITION,
    ),
    Map(
        name="kaji_ochiai.deform",
        definition="u_k -> blend of the probes A_i with the weights w_ki, applied to u_k",
        source="kaji_ochiai, section 5.2",
        domain="probes as for kaji_ochiai.parametrise; any points and weights",
        arguments=(
            Argument("points", ("points", 3), (ENTRIES,), "length"),
            _poses("probes", "probes"),
            Argument("weights", ("points", "probes"), (ENTRIES,), "1"),
        ),
        outputs=(("points", 3),),
        blocks=(Block("points", 0, (...,)),),
        regimes=(
            _deformed("generic", ANY[1], _all(ANY, 2), _average),
            _deformed("rigid", RIGID[1], _all(RIGID, 2), _average),
            _deformed("near-pi", NEAR_PI[1], _several(NEAR_PI, 2), _average),
            _deformed("one-alone", ANY[1], _all(ANY, 2), _one_alone),
            _deformed("far-away", ANY[1], _all(ANY, 2), _average, far=6.0),
            _deformed("outside", OUTSIDE[1], _several(OUTSIDE, 2), _average),
        ),
        reference=reference.deform,
        continuation=reference.continue_deform,
        accuracy=8.0,
        cost=22.0,
        remark=CONDITION,
    ),
)
