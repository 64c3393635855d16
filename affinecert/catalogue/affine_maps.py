"""Affine maps of space, T = A S E, by what makes their decomposition and interpolation difficult."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from affinecert.catalogue import shears, tetrahedra, turns
from affinecert.catalogue.shears import Shears
from affinecert.draw import Draw
from affinecert.map import Array, Point, Regime
from affinecert.sampling import any_rotation, half_turns, homogeneous, quarter_turns, vector, well_conditioned


def _composed(draw: Draw, rotation: Array, shear: Array) -> Array:
    """A S E of that A and that rotation, with a power of two for scale and any translation."""
    return homogeneous(2.0 ** draw.choice(range(-3, 4)) * shear @ rotation, vector(draw))


def _generic(draw: Draw) -> Point:
    linear = well_conditioned(draw, 3)
    return Point((homogeneous(linear, vector(draw)),), float(np.linalg.norm(linear - np.eye(3))))


def _near_identity(draw: Draw) -> Point:
    # Perturbed by less than 0.4, the identity stays invertible.
    gap = draw.exponent(-16, -0.5)
    return Point((homogeneous(np.eye(3) + gap * draw.direction(9).reshape(3, 3), vector(draw, -16, 1)),), gap)


def _rigid(draw: Draw) -> Point:
    turn = draw.choice((turns.GENERIC, turns.NEAR_IDENTITY, turns.COORDINATE_AXIS)).build(draw)
    return Point((homogeneous(turn.matrix, vector(draw)),), turn.distance)


def _near_pi(draw: Draw) -> Point:
    # The factorisation tells the angle to a few u; none closer to pi than 1e-12 is surely on its side of the jump.
    gap = draw.exponent(-12, 0)
    turn = turns.short_of_pi(draw.direction(3), gap, gap)
    return Point((_composed(draw, turn.matrix, shears.matrix(shears.GENERIC, draw)[0]),), gap)


def _sheared(kind: Shears, rotations: tuple[Array, ...] = ()) -> Callable[[Draw], Point]:
    """A shear of that kind after any rotation, or after one with entries 0 and +-1, which keeps it to the last bit."""

    def build(draw: Draw) -> Point:
        shear, distance = shears.matrix(kind, draw)
        rotation = draw.choice(rotations) if rotations else any_rotation(draw)
        return Point((_composed(draw, rotation, shear),), distance)

    return build


def _thin(draw: Draw) -> Point:
    # Rounding moves a row by a few u; a map of thinness 1e-12 keeps its orientation all the same.
    thinness = draw.exponent(-12, 0)
    thin = any_rotation(draw) @ tetrahedra.aligned(draw, thinness) @ any_rotation(draw)
    return Point((homogeneous(thin, vector(draw)),), thinness)


def _uneven_rows(draw: Draw) -> Point:
    sizes = np.array([draw.exponent(-100, 100) for _ in range(3)])
    linear = sizes[:, None] * well_conditioned(draw, 3)
    return Point((homogeneous(linear, vector(draw)),), float(min(sizes) / max(sizes)))


def _huge_or_tiny(draw: Draw) -> Point:
    scale = draw.exponent(-150, 150)
    return Point((homogeneous(scale * well_conditioned(draw, 3), scale * vector(draw)),), scale)


def _tiny_next_to_huge(draw: Draw) -> Point:
    size = draw.exponent(-140, 140)
    return Point((homogeneous(well_conditioned(draw, 3), size * draw.direction(3)),), size)


def _outside(draw: Draw) -> Point:
    """A reflection, a projection, or a matrix with another last row."""
    point = _generic(draw)
    (affine,) = point.inputs
    fault = draw.choice(("reflection", "projection", "last row"))
    if fault == "last row":
        affine[3, draw.choice(range(4))] += draw.exponent(-15, 0)
    else:
        affine[draw.choice(range(3)), :3] *= -1.0 if fault == "reflection" else 0.0
    return point


GENERIC = Regime("generic", _generic, "distance from the identity")
NEAR_IDENTITY = Regime("near-identity", _near_identity, "distance from the identity")
RIGID = Regime("rigid", _rigid, "angle")
SHEAR = Regime("shear", _sheared(shears.GENERIC, (np.eye(3),)), shears.GENERIC.distance)
COALESCING = Regime("coalescing", _sheared(shears.ALL_COALESCING, quarter_turns()), shears.ALL_COALESCING.distance)
DEFECTIVE = Regime("defective", _sheared(shears.DEFECTIVE, quarter_turns()), shears.DEFECTIVE.distance)
NEAR_PI = Regime("near-pi", _near_pi, "pi - angle")
AT_PI = Regime("at-pi", _sheared(shears.GENERIC, half_turns()[:3]), shears.GENERIC.distance)
THIN = Regime("thin", _thin, "thinness")
UNEVEN_ROWS = Regime("uneven-rows", _uneven_rows, "ratio of the rows' sizes")
HUGE_OR_TINY = Regime("huge-or-tiny", _huge_or_tiny, "scale")
TINY_NEXT_TO_HUGE = Regime("tiny-next-to-huge", _tiny_next_to_huge, "length of the translation")
OUTSIDE = Regime("outside", _outside, "distance from the identity", share=0.5)

FACTORED = (GENERIC, NEAR_IDENTITY, RIGID, SHEAR, THIN, UNEVEN_ROWS, HUGE_OR_TINY, TINY_NEXT_TO_HUGE, OUTSIDE)
"""What the decomposition is tried on."""

INTERPOLATED = (*FACTORED, NEAR_PI, AT_PI, COALESCING, DEFECTIVE)
"""What the interpolation is tried on."""
