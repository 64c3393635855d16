"""Morphs by spirals, the paths of the powers of similarities: see `affinecert.fast.morphs`."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast import _turns
from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array
from affinecert.fast._spirals import ComplexNumbers, complex_product, progress, spiral
from affinecert.fast._ways import affine_way, log_scale, mixed
from affinecert.fast._wide_polar import polar
from affinecert.fast._wide_rotation import angle
from affinecert.fast._wide_vectors import inner


def log_spiral(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """(Z_C Z_B^-1)^t Z_B ((1 - t) D_B + t D_C): a spiral of similarities, the rest of the poses in a straight line.

    Z_X is the similarity of the translation of X, rotation R_X and scale det(L_X)^(1/dim); D_X = Z_X^-1 X. Rossignac
    and Vinacua, section 2.4 (c).
    """
    way = affine_way(start, end, t)
    (first, first_stretch), (last, last_stretch) = polar(way.first), polar(way.last)
    first_log, last_log = log_scale(first_stretch), log_scale(last_stretch)
    rest = way.stretched(_scaled(first_stretch, -first_log), _scaled(last_stretch, -last_log))
    turn = _turns.logarithm(wide.product(last, wide.transposed(first)))
    turned = wide.product(_turns.exponential(wide.times(turn, way.t[..., None])), first)
    linear = _scaled(wide.product(turned, rest), mixed(first_log, last_log, way.t))
    moved = spiral(turn, wide.subtract(last_log, first_log), way.t, wide.subtract(way.goal, way.origin))
    return way.pose(linear, wide.add(way.origin, moved))


def three_spiral(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The mean of the spirals of the three sides of the standard triangle 0, e_1, e_2, for poses of the plane, n = 3.

    The similarity that takes a side of the triangle's image under B to that under C, z the complex ratio of the two,
    takes an end p of it to p' by way of p + (z^t - 1) / (z - 1) (p' - p). Each corner is the mean of where its two
    sides take it. A z on the negative axis turns by pi. Rossignac and Vinacua, section 2.4 (d), after Whited and
    others, BetweenIT (2010).
    """
    way = affine_way(start, end, t, (3,))
    first, last = (_sides(linear) for linear in (way.first, way.last))
    parts = [progress(*_logarithm_of_ratio(*pair), way.t) for pair in zip(first, last, strict=True)]
    shift, growth = wide.subtract(way.goal, way.origin), wide.subtract(way.last, way.first)
    ways = (shift, wide.add(shift, growth[..., 0, :]), wide.add(shift, growth[..., 1, :]))
    # A corner lies between the side that leads away from it, of its own number, and the one before.
    moved = [_multiple(ways[i], _mean(parts[i], parts[i - 1])) for i in range(3)]
    steps = np.stack([wide.subtract(corner, moved[0]) for corner in moved[1:]], axis=-2)
    return way.pose(wide.add(way.first, steps), wide.add(way.origin, moved[0]))


def _scaled(matrix: Array, log: Array) -> Array:
    """The matrix times the number of that logarithm."""
    return wide.multiply(matrix, wide.exponential(log)[..., None, None, :])


def _sides(linear: Array) -> list[Array]:
    """The sides e_1, e_2 - e_1 and -e_2 of the standard triangle's image, (..., 2, 2)."""
    first, second = linear[..., 0, :], linear[..., 1, :]
    return [first, wide.subtract(second, first), -second]


def _logarithm_of_ratio(before: Array, after: Array) -> ComplexNumbers:
    """The logarithm of the ratio of two vectors of the plane, as complex numbers: that of its size, and its angle."""
    (x, y), (u, v) = (np.moveaxis(side, -2, 0) for side in (before, after))
    real, imaginary = complex_product((u, v), (x, -y))
    multiple_of_rotation = np.stack(
        [np.stack([real, -imaginary], axis=-2), np.stack([imaginary, real], axis=-2)], axis=-3
    )
    square = wide.divide(inner(after, after), inner(before, before))
    return 0.5 * wide.logarithm(square), angle(multiple_of_rotation)


def _mean(a: ComplexNumbers, b: ComplexNumbers) -> ComplexNumbers:
    return 0.5 * wide.add(a[0], b[0]), 0.5 * wide.add(a[1], b[1])


def _multiple(x: Array, factor: ComplexNumbers) -> Array:
    """The vector x of the plane times a complex number."""
    return np.stack(complex_product(factor, (x[..., 0, :], x[..., 1, :])), axis=-2)
