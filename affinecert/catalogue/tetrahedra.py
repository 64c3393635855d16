"""Pairs of tetrahedra in space, by what makes it difficult to represent them or to interpolate between them.

A tetrahedron is built aligned, as bansal_tatu aligns it: its edges from the first vertex are the columns of an upper
triangular matrix with a positive diagonal; then it is turned and carried to its place. Its vertices are rows, (4, 3).
"""

from __future__ import annotations

import numpy as np

from affinecert.catalogue import turns
from affinecert.draw import Draw
from affinecert.map import Array, Point, Regime
from affinecert.sampling import any_rotation, half_turns, vector

STANDARD = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
"""The canonical tetrahedron of bansal_tatu, section 3 and figure 1."""


def aligned(draw: Draw, thinness: float = 1.0) -> Array:
    """Edges of an aligned tetrahedron of size 1, one of whose two heights is multiplied by ``thinness``, (3, 3)."""
    heights = [draw.uniform(0.5, 2.0) for _ in range(3)]
    heights[draw.choice((1, 2))] *= thinness
    second, third, fourth = (draw.uniform(-1, 1) for _ in range(3))
    return np.array([[heights[0], second, third], [0.0, heights[1], fourth], [0.0, 0.0, heights[2]]])


def placed(edges: Array, rotation: Array, origin: Array) -> Array:
    """The tetrahedron with those edges, turned and carried."""
    return np.vstack([origin, origin + (rotation @ edges).T])


def tetrahedron(draw: Draw, thinness: float = 1.0) -> Array:
    """A tetrahedron of size 1 near the origin."""
    return placed(aligned(draw, thinness), any_rotation(draw), draw.direction(3))


def _generic(draw: Draw) -> Point:
    source, target = tetrahedron(draw), tetrahedron(draw)
    return Point((source, target), float(np.linalg.norm(target - source)))


def _standard(draw: Draw) -> Point:
    thinness = draw.exponent(-3, 0)
    return Point((tetrahedron(draw, thinness), STANDARD), thinness)


def _rigid(draw: Draw) -> Point:
    source, turn = tetrahedron(draw), turns.GENERIC.build(draw)
    return Point((source, source @ turn.matrix.T + vector(draw)), turn.distance)


def _near_identity(draw: Draw) -> Point:
    source, gap = tetrahedron(draw), draw.exponent(-16, -2)
    return Point((source, source + gap * draw.direction(12).reshape(4, 3)), gap)


def _identity(draw: Draw) -> Point:
    thinness = draw.exponent(-8, 0)
    source = tetrahedron(draw, thinness)
    return Point((source, source.copy()), thinness)


def _near_pi(draw: Draw) -> Point:
    # Alignment tells the angle to a few u; none closer to pi than 1e-12 is surely on its side of the jump.
    gap, rotation = draw.exponent(-12, 0), any_rotation(draw)
    turn = turns.short_of_pi(draw.direction(3), gap, gap)
    source = placed(aligned(draw), rotation, draw.direction(3))
    return Point((source, placed(aligned(draw), turn.matrix @ rotation, draw.direction(3))), gap)


def _at_pi(draw: Draw) -> Point:
    # Of aligned tetrahedra at the origin, the half turn about a coordinate axis is exact, and found exactly.
    size = draw.exponent(-8, 8)
    source = placed(size * aligned(draw), np.eye(3), np.zeros(3))
    return Point((source, placed(aligned(draw), draw.choice(half_turns()[:3]), np.zeros(3))), size)


def _thin(draw: Draw) -> Point:
    # Vertices of size 1 are told to a few u; a tetrahedron of thinness 1e-12 keeps its orientation all the same.
    thinness = draw.exponent(-12, 0)
    thin, other = tetrahedron(draw, thinness), tetrahedron(draw, draw.choice((1.0, thinness)))
    return Point(draw.choice(((thin, other), (other, thin))), thinness)


def _far(draw: Draw) -> Point:
    distance = draw.exponent(0, 10)
    shift = distance * draw.direction(3)
    return Point((tetrahedron(draw) + shift, tetrahedron(draw) + draw.choice((1.0, 0.0)) * shift), distance)


def _huge_and_tiny(draw: Draw) -> Point:
    first, second = draw.exponent(-140, 140), draw.exponent(-140, 140)
    return Point((first * tetrahedron(draw), second * tetrahedron(draw)), second / first)


def _flat(draw: Draw) -> Array:
    """Four vertices in a plane, the first three of them on a line; whole numbers, and exactly so."""
    whole = [np.array([float(draw.choice(range(-9, 10))) for _ in range(3)]) for _ in range(3)]
    origin, first, third = whole
    return np.vstack([origin, origin + first, origin + draw.choice((2.0, -1.0, 0.0)) * first, origin + third])


def _outside(draw: Draw) -> Point:
    """A tetrahedron and one that is none."""
    size = draw.exponent(-3, 3)
    solid, flat = size * tetrahedron(draw), _flat(draw)
    return Point(draw.choice(((solid, flat), (flat, solid))), size)


def _mirrored(draw: Draw) -> Point:
    """A tetrahedron and one of the other orientation."""
    size = draw.exponent(-3, 3)
    solid, mirrored = size * tetrahedron(draw), tetrahedron(draw)[[0, 2, 1, 3]]
    return Point(draw.choice(((solid, mirrored), (mirrored, solid))), size)


GENERIC = Regime("generic", _generic, "difference of the vertices")
AGAINST_STANDARD = Regime("standard", _standard, "thinness")
RIGID = Regime("rigid", _rigid, "angle")
NEAR_IDENTITY = Regime("near-identity", _near_identity, "difference of the vertices")
IDENTITY = Regime("identity", _identity, "thinness")
NEAR_PI = Regime("near-pi", _near_pi, "pi - angle")
AT_PI = Regime("at-pi", _at_pi, "size of the source")
THIN = Regime("thin", _thin, "thinness")
FAR = Regime("far-from-origin", _far, "distance from the origin")
HUGE_AND_TINY = Regime("huge-and-tiny", _huge_and_tiny, "ratio of the sizes")
OUTSIDE = Regime("outside", _outside, "size", share=0.25)
MIRRORED = Regime("mirrored", _mirrored, "size", share=0.25)

ALL = (GENERIC, RIGID, NEAR_IDENTITY, IDENTITY, NEAR_PI, AT_PI, THIN, FAR, HUGE_AND_TINY, OUTSIDE)
"""What interpolation is tried on, of tetrahedra and of triangles."""
