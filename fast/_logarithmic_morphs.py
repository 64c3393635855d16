"""Morphs in a Lie group, by logarithms of poses: see `affinecert.fast.morphs`."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast import _turns, affine_lie, sam
from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array
from affinecert.fast._rotation import ORTHOGONALITY
from affinecert.fast._spectrum import NONE
from affinecert.fast._spirals import velocity
from affinecert.fast._stages import refuse
from affinecert.fast._ways import affine_way, log_scale, mixed
from affinecert.fast._wide_affine import affine_exponential, affine_logarithm
from affinecert.fast._wide_polar import polar
from affinecert.fast._wide_rotation import PI, ROUNDING, TWO_PI
from affinecert.fast._wide_vectors import cross_matrix, direction, inner

NOT_SIMILAR = "not a similarity: L^T L is further than 1e-6 from I, for L of determinant 1"


def alexa_2002(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """exp((1 - t) log B + t log C), with the logarithms of `sam.log`.

    Alexa, Linear combination of transformations (2002). Raises InputError, besides, if B or C has no real logarithm.
    """
    way = affine_way(start, end, t)
    first, last = (_logarithm(name, pose) for name, pose in (("start", way.start), ("end", way.end)))
    moved = affine_exponential(way.stretched(first, last))
    return way.pose(wide.linear_part(moved), wide.translation(moved))


def lie(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """From B Delta to C Delta as `affine_lie.interpolate_tetrahedra`, Delta the standard simplex 0, e_1, e_2, e_3.

    In the plane the same of its poses in space that leave the third coordinate alone. Half a turn is by +pi from C
    back to B, and so by -pi from B to C. Bansal and Tatu, equation 4.
    """
    way = affine_way(start, end, t)
    size = way.start.shape[-1] - 1
    first, last = (_vertices(pose) for pose in (way.start, way.end))
    edges, origin = affine_lie.interpolate_edges(first, last, way.t)
    linear = np.swapaxes(edges, -1, -2)
    return way.pose(wide.widen(linear[..., :size, :size]), wide.widen(origin[..., :size]))


def sim(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """exp((1 - t) X + t Y) for similarities B and C of space, n = 4: X = `sim3.log`(B), Y = `sim3.log_next`(C, X).

    Gallier, Allen-Blanchette and Leonardos, section 5. B and C stand for the similarities of the nearest rotations,
    which the ends are then. Raises InputError if one is no similarity to within 1e-6.
    """
    way = affine_way(start, end, t, (4,))
    first, first_growth = _turn_and_growth("start", way.first)
    last, last_growth = _turn_and_growth("end", way.last)
    last = _next(last, first)
    turn, growth = mixed(first, last, way.t[..., None]), mixed(first_growth, last_growth, way.t)
    velocities = velocity(first, first_growth, way.origin), velocity(last, last_growth, way.goal)
    linear = wide.add(cross_matrix(turn), wide.multiply(wide.widen(np.eye(3)), growth[..., None, None, :]))
    return wide.rounded(affine_exponential(wide.tangent(linear, mixed(*velocities, way.t[..., None]))))


def _logarithm(name: str, pose: Array) -> Array:
    """The logarithm of a pose, as pairs; refuses one that has none."""
    logarithm, existence = affine_logarithm(wide.widen(pose))
    refuse(existence, NONE, name, sam.NO_LOGARITHM, existence.shape)
    return logarithm


def _vertices(pose: Array) -> tuple[Array, Array]:
    """The edges of the standard simplex's image in space, in rows, (..., 3, 3), and its first vertex (..., 3)."""
    size = pose.shape[-1] - 1
    edges, origin = np.zeros((*pose.shape[:-2], 3, 3)), np.zeros((*pose.shape[:-2], 3))
    edges[..., 2, 2] = 1.0
    edges[..., :size, :size] = np.swapaxes(pose[..., :-1, :-1], -1, -2)
    origin[..., :size] = pose[..., :-1, -1]
    return edges, origin


def _turn_and_growth(name: str, linear: Array) -> tuple[Array, Array]:
    """The principal rotation vector of a similarity, and the logarithm of its scale; refuses what is none."""
    rotation, stretch = polar(linear)
    growth = log_scale(stretch)
    unit = wide.multiply(stretch, wide.exponential(-growth)[..., None, None, :])
    defect = wide.product(unit, unit)[..., 0] - np.eye(3)
    good = (defect * defect).sum(axis=(-2, -1)) <= ORTHOGONALITY**2
    refuse(good.astype(np.float64), 0.0, name, NOT_SIMILAR, good.shape)
    return _turns.logarithm(rotation), growth


def _next(turn: Array, previous: Array) -> Array:
    """Of a principal rotation vector and the one of the same rotation the other way round, the one nearer to another.

    The principal one in a tie.
    """
    angle, axis = direction(turn)
    # The middle of the two is at the angle - pi.
    beyond = wide.subtract(wide.subtract(angle, PI), inner(axis, previous))[..., 0]
    other = wide.multiply(axis, wide.subtract(angle, TWO_PI)[..., None, :])
    return np.where(((angle[..., 0] > 0.0) & (beyond > ROUNDING))[..., None, None], other, turn)
