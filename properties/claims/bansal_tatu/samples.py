"""Affine maps and tetrahedra that the claims are tried on, from simple to complex, and what they are made of."""

from __future__ import annotations

from functools import cache

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.draws import affine, arrays, rotations
from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference._matrices import Array, Number, array, homogeneous, identity, scalar

CANONICAL: Array = exactly([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]])
"""The canonical tetrahedron of section 3, a vertex a row."""

REGULAR: Array = exactly([[1, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]])
"""A regular tetrahedron about the origin, positively oriented, in a sphere of radius sqrt 3."""

TIMES = (mp.mpf(1) / 4, mp.mpf(5) / 8)
"""Times within (0, 1) that are no special ones."""


QUARTER_TURN: Array = exactly([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
"""The turn by pi / 2 about z."""

HALF_TURN: Array = exactly([[-1, 0, 0], [0, -1, 0], [0, 0, 1]])
"""The turn by pi about z."""


@cache
def maps() -> tuple[Array, ...]:
    """Orientation-preserving affine maps T, (4, 4); none with a turn by pi in it."""
    drawn = arrays("affine maps", 12, (3, 4), -2, 2)
    oriented = [each for each in drawn if definitions.determinant(each[:, :3]) > 0][:4]
    simple = (
        affine(identity(mp, 3), (1, 0, 0)),
        affine(2 * identity(mp, 3), (0, 1, 0)),
        affine(QUARTER_TURN, (1, 0, 2)),
        affine([[1, 1, 0], [0, 1, 1], [0, 0, 1]]),
        affine([[1, 1, 0], [1, 2, 0], [0, 1, 3]], (1, -1, 2)),
    )
    return (*simple, *(homogeneous(mp, each[:, :3], each[:, 3]) for each in oriented))


@cache
def rigid_maps() -> tuple[Array, ...]:
    """Rigid motions E, (4, 4), by angles up to 0.9 pi."""
    turns = rotations("rigid maps", 4, mp.pi * 9 / 10)
    shifts = arrays("shifts", 4, (3,), -2, 2)
    drawn = (homogeneous(mp, turn, shift) for turn, shift in zip(turns, shifts, strict=True))
    return (affine(QUARTER_TURN), affine(QUARTER_TURN, (1, 0, 2)), *drawn)


@cache
def tetrahedra() -> tuple[Array, ...]:
    """Positively oriented tetrahedra, a vertex a row, (4, 3)."""
    drawn = arrays("tetrahedra", 16, (4, 3), -3, 3)
    oriented = [each for each in drawn if definitions.determinant(each[1:] - each[0]) > 0][:4]
    return (CANONICAL, exactly([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]), REGULAR, *oriented)


def tetrahedron_pairs() -> list[tuple[Array, Array]]:
    """Each tetrahedron with the next one."""
    solids = tetrahedra()
    return list(zip(solids, (*solids[1:], solids[0]), strict=True))


def mirrored(tetrahedron: Array) -> Array:
    """The tetrahedron with two vertices exchanged: negatively oriented if it was positively."""
    return tetrahedron[[0, 2, 1, 3]]


def columns(tetrahedron: Array) -> Array:
    """The homogeneous coordinates of the vertices as columns, (4, 4), as the paper has them."""
    return np.concatenate([tetrahedron.T, np.full((1, 4), mp.one, dtype=object)])


def moved(pose: Array, tetrahedron: Array) -> Array:
    """The vertices moved by an affine map, a vertex a row."""
    vertices: Array = tetrahedron @ pose[:3, :3].T + pose[:3, 3]
    return vertices


def between(source: Array, target: Array) -> Array:
    """The affine map from one tetrahedron to another."""
    edges = definitions.inverse(mp, source[1:] - source[0])
    linear = (edges @ (target[1:] - target[0])).T
    return homogeneous(mp, linear, target[0] - linear @ source[0])


def embedded(linear: Array) -> Array:
    """A linear map as a homogeneous matrix."""
    return homogeneous(mp, linear, array([mp.zero] * 3))


def scaling(s: Number) -> Array:
    """The matrix S of the scaling by s."""
    return embedded(identity(mp, 3) * s)


def at(t: object) -> Array:
    """A time, as the maps of the reference take it."""
    return scalar(exactly(t))


def inverse(matrix: Array) -> Array:
    """The inverse of a matrix."""
    return definitions.inverse(mp, matrix)
