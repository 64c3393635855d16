"""Vectors of pairs, (..., n, 2): products, lengths and directions, and sums over the rows of matrices."""

from __future__ import annotations

import numpy as np

from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array


def inner(a: Array, b: Array) -> Array:
    """The inner product, (..., 2)."""
    return wide.product(a[..., None, :, :], b[..., :, None, :])[..., 0, 0, :]


def cross(a: Array, b: Array) -> Array:
    """The vector product, (..., 3, 2)."""
    (a1, a2, a3), (b1, b2, b3) = (np.moveaxis(x, -2, 0) for x in (a, b))
    entries = ((a2, b3, a3, b2), (a3, b1, a1, b3), (a1, b2, a2, b1))
    return np.stack([wide.subtract(wide.multiply(p, q), wide.multiply(r, s)) for p, q, r, s in entries], axis=-2)


def cross_matrix(a: Array) -> Array:
    """The matrix [a] of the vector product with a, (..., 3, 3, 2)."""
    x, y, z = np.moveaxis(a, -2, 0)
    zero = np.zeros_like(x)
    rows = ((zero, -z, y), (z, zero, -x), (-y, x, zero))
    return np.stack([np.stack(row, axis=-2) for row in rows], axis=-3)


def direction(x: Array) -> tuple[Array, Array]:
    """Length and unit vector, however small or large; 0 and 0 of the vector 0."""
    exponent = np.frexp(np.abs(x[..., 0]).max(axis=-1))[1]
    scaled = np.ldexp(x, -exponent[..., None, None])
    length = wide.square_root(inner(scaled, scaled))
    some = length[..., 0] > 0.0
    unit = wide.divide(scaled, np.where(some[..., None], length, 1.0)[..., None, :])
    return np.ldexp(length, exponent[..., None]), np.where(some[..., None, None], unit, 0.0)


def row_sums(matrix: Array) -> Array:
    """The sums of the rows of matrices (..., k, l, 2), (..., k, 2)."""
    total = matrix[..., 0, :]
    for j in range(1, matrix.shape[-2]):
        total = wide.add(total, matrix[..., j, :])
    return total
