"""Rotations by the distance of their angle to 0, pi and 2 pi, and of their axis to a coordinate axis."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from affinecert.draw import Draw
from affinecert.map import Array, Point, Regime
from affinecert.sampling import off_by_ulps, quaternion_matrix, signed


@dataclass(frozen=True)
class Turn:
    """One rotation, as its vector (angle times axis) and as its matrix, with its distance to what is difficult."""

    axis: Array
    vector: Array
    matrix: Array
    distance: float


@dataclass(frozen=True)
class Turns:
    """What a regime draws its rotations from; ``name`` and ``distance`` become the regime's."""

    name: str
    distance: str
    build: Callable[[Draw], Turn]


def regimes(kinds: Iterable[Turns], inputs: Callable[[Draw, Turn], tuple[Array, ...]]) -> tuple[Regime, ...]:
    """A regime for each kind of rotation; ``inputs`` makes the inputs of the map from one."""

    def regime(kind: Turns) -> Regime:
        def build(draw: Draw) -> Point:
            turn = kind.build(draw)
            return Point(inputs(draw, turn), turn.distance)

        return Regime(kind.name, build, kind.distance)

    return tuple(regime(kind) for kind in kinds)


def about(axis: Array, angle: float, distance: float) -> Turn:
    """The rotation by ``angle`` about the unit vector ``axis``."""
    x, y, z = math.sin(angle / 2) * axis
    return Turn(axis, angle * axis, quaternion_matrix(math.cos(angle / 2), x, y, z), distance)


def short_of_pi(axis: Array, gap: float, distance: float) -> Turn:
    """The rotation by pi - gap; the matrix is right to the last bit of the gap, and exactly symmetric where it is 0."""
    x, y, z = math.cos(gap / 2) * axis
    return Turn(axis, (math.pi - gap) * axis, quaternion_matrix(math.sin(gap / 2), x, y, z), distance)


def coordinate_axis(draw: Draw) -> Array:
    """One of the six unit vectors along the coordinate axes."""
    return draw.choice((1.0, -1.0)) * draw.choice(tuple(np.eye(3)))


def lopsided_axis(draw: Draw, tiny: float) -> Array:
    """A unit vector one component of which is ``tiny``."""
    return np.insert(draw.direction(2), draw.choice((0, 1, 2)), tiny)


DIAGONALS = tuple(
    np.array(signs) / math.sqrt(sum(map(abs, signs)))
    for signs in product((-1, 0, 1), repeat=3)
    if sum(map(abs, signs)) > 1
)
"""The unit vectors two or three of whose components are equal up to sign, the rest zero: pivots tie there."""


def _generic(draw: Draw) -> Turn:
    angle = draw.uniform(0.0, math.pi)
    return about(draw.direction(3), angle, angle)


def _small(low: float, high: float) -> Callable[[Draw], Turn]:
    def build(draw: Draw) -> Turn:
        angle = draw.exponent(low, high)
        return about(draw.direction(3), angle, angle)

    return build


def _near_pi(draw: Draw) -> Turn:
    gap = draw.exponent(-16, 0)
    return short_of_pi(draw.direction(3), gap, gap)


def _at_pi(draw: Draw) -> Turn:
    axis = draw.direction(3)
    return short_of_pi(axis, 0.0, float(np.min(np.abs(axis))))


def _near_two_pi(draw: Draw) -> Turn:
    gap = signed(draw, -15, 0)
    return about(draw.direction(3), 2 * math.pi + gap, abs(gap))


def _near_multiple_of_pi(draw: Draw) -> Turn:
    gap = signed(draw, -10, 0)
    return about(draw.direction(3), draw.choice(range(3, 1000)) * math.pi + gap, abs(gap))


def _one_tiny_component(draw: Draw) -> Turn:
    tiny = signed(draw, -300, -8)
    return about(lopsided_axis(draw, tiny), draw.uniform(0.0, math.pi), abs(tiny))


def _one_tiny_component_at_pi(draw: Draw) -> Turn:
    tiny = signed(draw, -300, -8)
    return short_of_pi(lopsided_axis(draw, tiny), 0.0, abs(tiny))


def _coordinate_axis(draw: Draw) -> Turn:
    angle = draw.exponent(-300, 0.49)
    return about(coordinate_axis(draw), angle, angle)


def _coordinate_axis_near_pi(draw: Draw) -> Turn:
    gap = draw.exponent(-300, 0)
    return short_of_pi(coordinate_axis(draw), gap, gap)


def _coordinate_axis_at_pi(draw: Draw) -> Turn:
    return short_of_pi(coordinate_axis(draw), 0.0, math.pi)


def _equal_components(draw: Draw) -> Turn:
    gap = draw.exponent(-16, 0)
    return draw.choice((about, short_of_pi))(draw.choice(DIAGONALS), gap, gap)


def _off_by_ulps(draw: Draw) -> Turn:
    angle = draw.choice((draw.uniform(0.0, math.pi), draw.exponent(-8, 0)))
    turn = about(draw.direction(3), angle, angle)
    return replace(turn, matrix=off_by_ulps(draw, turn.matrix, 4))


def _off_manifold(draw: Draw) -> Turn:
    turn = _generic(draw)
    # |R^T R - I| is at most 2 |noise| + |noise|^2, below the 1e-6 that a rotation is allowed.
    noise = draw.exponent(-16, -7)
    return replace(turn, matrix=turn.matrix + noise * draw.direction(9).reshape(3, 3), distance=noise)


def _from_float32(draw: Draw) -> Turn:
    gap = draw.exponent(-7, 0)
    turn = draw.choice((about, short_of_pi))(draw.direction(3), gap, gap)
    return replace(turn, matrix=turn.matrix.astype(np.float32).astype(np.float64))


GENERIC = Turns("generic", "angle", _generic)
NEAR_IDENTITY = Turns("near-identity", "angle", _small(-16, 0))
TINY = Turns("tiny", "angle", _small(-300, -16))
NEAR_PI = Turns("near-pi", "pi - angle", _near_pi)
AT_PI = Turns("at-pi", "smallest component of the axis", _at_pi)
NEAR_TWO_PI = Turns("near-2pi", "|angle - 2 pi|", _near_two_pi)
NEAR_MULTIPLE_OF_PI = Turns("near-multiple-of-pi", "|angle - k pi|", _near_multiple_of_pi)
HUGE_ANGLE = Turns("huge-angle", "angle", _small(1, 15))
ONE_TINY_COMPONENT = Turns("one-tiny-component", "tiny component of the axis", _one_tiny_component)
ONE_TINY_COMPONENT_AT_PI = Turns("one-tiny-component-at-pi", "tiny component of the axis", _one_tiny_component_at_pi)
COORDINATE_AXIS = Turns("coordinate-axis", "angle", _coordinate_axis)
COORDINATE_AXIS_NEAR_PI = Turns("coordinate-axis-near-pi", "pi - angle", _coordinate_axis_near_pi)
COORDINATE_AXIS_AT_PI = Turns("coordinate-axis-at-pi", "angle", _coordinate_axis_at_pi)
EQUAL_COMPONENTS = Turns("equal-components", "distance of the angle from 0 or pi", _equal_components)
OFF_BY_ULPS = Turns("off-by-ulps", "angle", _off_by_ulps)
OFF_MANIFOLD = Turns("off-manifold", "distance from the rotations", _off_manifold)
FROM_FLOAT32 = Turns("from-float32", "distance of the angle from 0 or pi", _from_float32)

MATRICES = (
    GENERIC,
    NEAR_IDENTITY,
    TINY,
    NEAR_PI,
    AT_PI,
    ONE_TINY_COMPONENT,
    ONE_TINY_COMPONENT_AT_PI,
    COORDINATE_AXIS,
    COORDINATE_AXIS_NEAR_PI,
    COORDINATE_AXIS_AT_PI,
    EQUAL_COMPONENTS,
    OFF_BY_ULPS,
    OFF_MANIFOLD,
    FROM_FLOAT32,
)
"""What a logarithm is tried on."""

VECTORS = (
    GENERIC,
    NEAR_IDENTITY,
    TINY,
    NEAR_PI,
    AT_PI,
    NEAR_TWO_PI,
    NEAR_MULTIPLE_OF_PI,
    HUGE_ANGLE,
    ONE_TINY_COMPONENT,
    COORDINATE_AXIS,
    EQUAL_COMPONENTS,
)
"""What an exponential is tried on."""


def no_rotation(draw: Draw) -> Turn:
    """No rotation at all: stretched by more than rounding explains, or a reflection."""
    turn = _generic(draw)
    # A column stretched by 1 + d takes |R^T R - I| to 2 d at least, ten times what is allowed or more.
    stretch = draw.exponent(-5, 1)
    columns = draw.choice(((1 + stretch, 1.0, 1.0), (1 + stretch,) * 3, (1.0, 1.0, -1.0), (0.0, 1.0, 1.0)))
    return replace(turn, matrix=turn.matrix * np.array(columns), distance=stretch)
