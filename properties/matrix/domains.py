"""What a law may hold on: classes of pairs of poses B and C, in words that a reader understands and as predicates.

A predicate tells of float64 pairs, (pairs, n, n) each, which belong to the class, up to rounding; on the borders of a
class it says no.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from affinecert.map import Array
from affinecert.properties.matrix.algebra import Mask, inverse, linear, size, unlike_rotation

ROUNDING = 1e-10
"""Far above what rounding of poses of size 1 leaves, and far below what anybody would call another pose."""

CLEAR = 0.02
"""Angles, and parts of a norm, by which a pair is clear of a border."""


@dataclass(frozen=True)
class Domain:
    """A class of pairs: its name in tables, what it is, and who belongs to it.

    ``trivial`` says that nearly every law holds there, so that it tells nothing of a morph.
    """

    name: str
    words: str
    holds: Callable[[Array, Array], Mask]
    trivial: bool = False


def _everything(start: Array, end: Array) -> Mask:
    return np.ones(len(start), dtype=np.bool_)


def step(start: Array, end: Array) -> Array:
    """The linear part of C B^-1."""
    return linear(end @ inverse(start))


def _upright(matrix: Array) -> Mask:
    """Whether x . L x is positive for all x."""
    symmetric = (matrix + np.swapaxes(matrix, -1, -2)) / 2
    return np.asarray(np.linalg.eigvalsh(symmetric)[..., 0] > CLEAR * size(matrix))


def _rotation(matrix: Array) -> Array:
    """The rotations of polar factors."""
    u, _, v = np.linalg.svd(matrix)
    return np.asarray(u @ v)


def _angle(rotation: Array) -> Array:
    """The angles of rotations, in [0, pi]."""
    trace = np.trace(rotation, axis1=-2, axis2=-1) - (rotation.shape[-1] - 2)
    return np.asarray(np.arccos(np.clip(trace / 2, -1.0, 1.0)))


def _aligned(matrix: Array) -> Array:
    """The rotations Q of L = Q U, U upper triangular of positive diagonal: of the edges that are aligned in turn."""
    q, r = np.linalg.qr(matrix)
    return np.asarray(q * np.sign(np.diagonal(r, axis1=-2, axis2=-1))[..., None, :])


def _side_angles(matrix: Array) -> Iterator[Array]:
    """The directions of the sides of the standard triangle's image."""
    for x, y in ((1.0, 0.0), (0.0, 1.0), (1.0, -1.0)):
        yield np.arctan2(*np.moveaxis(matrix[..., :2] @ np.array([x, y]), -1, 0)[1::-1])


def _turns(start: Array, end: Array) -> Iterator[Array]:
    """The angles of the turns that morphs see in B, in C or between them."""
    first, last, between = linear(start), linear(end), step(start, end)
    for matrix in (first, last, between):
        yield _angle(_rotation(matrix))
    yield _angle(np.swapaxes(_rotation(first), -1, -2) @ _rotation(last))
    for order in (permuted(start, end, 0), permuted(start, end, 1), (start, end)):
        one, other = (_aligned(linear(pose)) for pose in order)
        yield _angle(one @ np.swapaxes(other, -1, -2))
    if first.shape[-1] == 2:
        for one, other in zip(_side_angles(first), _side_angles(last), strict=True):
            yield np.abs(np.angle(np.exp(1j * (one - other))))


def permuted(start: Array, end: Array, number: int) -> tuple[Array, Array]:
    """The poses after one of the even re-orderings of the simplex that are tried."""
    reordering = REORDERINGS[start.shape[-1] - 1][number]
    return start @ reordering, end @ reordering


def _moving(vertices: tuple[int, ...]) -> Array:
    """The affine map that takes vertex i of the simplex 0, e_1, ..., e_n to vertex ``vertices[i]``."""
    corners = np.concatenate([np.zeros((1, len(vertices) - 1)), np.eye(len(vertices) - 1)])[list(vertices)]
    matrix = np.eye(len(vertices))
    matrix[:-1, :-1] = (corners[1:] - corners[0]).T
    matrix[:-1, -1] = corners[0]
    return matrix


REORDERINGS = {2: (_moving((1, 2, 0)), _moving((2, 0, 1))), 3: (_moving((1, 2, 0, 3)), _moving((1, 0, 3, 2)))}
"""Even re-orderings of the vertices of the standard simplex, in the plane and in space."""


def _double_negative(matrix: Array) -> Mask:
    """Whether there is a double negative eigenvalue, or nearly so."""
    values = np.linalg.eigvals(matrix)
    gaps = np.abs(values[..., :, None] - values[..., None, :]) + 1e9 * np.eye(values.shape[-1])
    near = gaps.min(axis=-1) < CLEAR * np.abs(values)
    return np.asarray((near & (values.real < 0) & (np.abs(values.imag) < CLEAR * np.abs(values))).any(axis=-1))


def _short_of_pi(start: Array, end: Array) -> Mask:
    good = np.all([angle < np.pi - CLEAR for angle in _turns(start, end)], axis=0)
    for matrix in (linear(start), linear(end), step(start, end)):
        good &= ~_double_negative(matrix)
    return np.asarray(good)


def _similar(matrix: Array) -> Mask:
    return np.asarray(unlike_rotation(matrix, scaled=True) < ROUNDING)


def _rigid(matrix: Array) -> Mask:
    return np.asarray(unlike_rotation(matrix) < ROUNDING)


def _stretch(matrix: Array) -> Mask:
    return np.asarray((size(matrix - np.swapaxes(matrix, -1, -2)) < ROUNDING) & _upright(matrix))


def _identity(matrix: Array) -> Mask:
    return np.asarray(size(matrix - np.eye(matrix.shape[-1])) < ROUNDING)


def _of_step(test: Callable[[Array], Mask]) -> Callable[[Array, Array], Mask]:
    return lambda start, end: test(step(start, end))


def _of_both(test: Callable[[Array], Mask]) -> Callable[[Array, Array], Mask]:
    return lambda start, end: test(linear(start)) & test(linear(end))


def _of_the_plane(start: Array, end: Array) -> Mask:
    return np.full(len(start), start.shape[-1] == 3)


ALL = Domain("all", "all pairs", _everything)
NO_HALF_TURN = Domain("not pi", "there is no turn by exactly pi in B, in C or between them", _short_of_pi)
PLANE = Domain("plane", "B and C are poses of the plane", _of_the_plane)
MILD = Domain("mild", "C B^-1 turns no direction by a right angle or more", _of_step(_upright))
UPRIGHT = Domain("upright", "neither B nor C turns a direction by a right angle or more", _of_both(_upright))
FROM_IDENTITY = Domain("from I", "B = I", lambda start, end: np.asarray(size(start - np.eye(start.shape[-1])) == 0))
SIMILAR = Domain("similar", "C B^-1 is a similarity", _of_step(_similar))
SIMILARITIES = Domain("both sim", "B and C are similarities", _of_both(_similar))
RIGID = Domain("rigid", "C B^-1 is rigid", _of_step(_rigid))
RIGID_POSES = Domain("both rig", "B and C are rigid", _of_both(_rigid))
STRETCH = Domain("stretch", "C B^-1 stretches along orthogonal axes", _of_step(_stretch))
SHIFT = Domain("shift", "C B^-1 is a translation", _of_step(_identity), trivial=True)

DOMAINS = (
    ALL,
    NO_HALF_TURN,
    PLANE,
    MILD,
    UPRIGHT,
    FROM_IDENTITY,
    SIMILAR,
    SIMILARITIES,
    RIGID,
    RIGID_POSES,
    STRETCH,
    SHIFT,
)
"""From wide to narrow: none is within a later one; `trial` finds out which are within an earlier one."""


def holding(start: Array, end: Array) -> dict[str, Any]:
    """For each domain, by name, which of the pairs belong to it."""
    return {domain.name: domain.holds(start, end) for domain in DOMAINS}
