"""Morphs of rigid motions of space: see `affinecert.fast.morphs`."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast import _quaternions as quaternions
from affinecert.fast import _turns
from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array
from affinecert.fast._spirals import spiral
from affinecert.fast._ways import mixed, rigid_way
from affinecert.fast._wide_rotation import ROUNDING
from affinecert.fast._wide_vectors import inner


def sclerp(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The screw motion B exp(t log(B^-1 C)) of rigid B and C, n = 4.

    Kavan, Collins, Zara and O'Sullivan, Geometric skinning with approximate dual quaternion blending (2008). B and C
    stand for the rigid motions of the nearest rotations, which the ends are then. Raises InputError if one is no rigid
    motion to within 1e-6.
    """
    way = rigid_way(start, end, t)
    back = wide.transposed(way.first)
    turn = _turns.logarithm(wide.product(back, way.last))
    there = wide.image(back, wide.subtract(way.goal, way.origin))
    moved = spiral(turn, np.zeros(2), way.t, there)
    linear = wide.product(way.first, _turns.exponential(wide.times(turn, way.t[..., None])))
    return wide.rounded(wide.homogeneous(linear, wide.add(way.origin, wide.image(way.first, moved))))


def dual_quaternion_linear(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The normalised (1 - t) p + t s q of the unit dual quaternions p and q of rigid B and C, n = 4.

    s = -1 if the inner product of their rotations' quaternions is negative, else 1. The quaternion of a rotation has
    w > 0, and w = 0 with the axis that `so3.log` takes. Kavan and others (2008), DLB. B and C as in `sclerp`.
    """
    way = rigid_way(start, end, t)
    p, q = quaternions.of_rotation(way.first), quaternions.of_rotation(way.last)
    q = np.where((inner(p, q)[..., 0] < -ROUNDING)[..., None, None], -q, q)
    real = mixed(p, q, way.t[..., None])
    # A unit dual quaternion is r + eps v r / 2, v the translation; of the sum v is the vector part of 2 d r* / |r|^2.
    dual = mixed(quaternions.moved(way.origin, p), quaternions.moved(way.goal, q), way.t[..., None])
    square = inner(real, real)[..., None, :]
    translation = wide.divide(quaternions.product(dual, quaternions.conjugate(real))[..., 1:, :], square)
    unit = wide.divide(real, wide.square_root(square))
    return wide.rounded(wide.homogeneous(quaternions.matrix(unit), translation))
