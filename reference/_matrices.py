"""Small vectors and matrices as NumPy object arrays of an mpmath context's numbers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Context = Any  # an mpmath.MPContext; mpmath carries no types
Number = Any  # an mpf of that context, or an mpc where said
Array = NDArray[np.object_]


def array(numbers: Sequence[Any]) -> Array:
    """The numbers (nested sequences for a matrix) as an object array."""
    return np.array(numbers, dtype=object)


def scalar(number: Number) -> Array:
    """One number as an object array of shape ()."""
    return np.array(number, dtype=object)


def identity(ctx: Context, size: int) -> Array:
    """The identity matrix, (size, size)."""
    return array([[ctx.one if row == column else ctx.zero for column in range(size)] for row in range(size)])


def dot(ctx: Context, a: Iterable[Number], b: Iterable[Number]) -> Number:
    """The scalar product of two vectors, rounded once."""
    return ctx.fdot(a, b)


def norm(ctx: Context, a: Iterable[Number]) -> Number:
    """The Euclidean length of a vector."""
    return ctx.sqrt(ctx.fsum(a, squared=True))


def cross(a: Array, b: Array) -> Array:
    """The vector product of two 3-vectors."""
    return array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def cross_matrix(ctx: Context, a: Array) -> Array:
    """The skew matrix [a]x with [a]x b = a x b."""
    x, y, z = a
    return array([[ctx.zero, -z, y], [z, ctx.zero, -x], [-y, x, ctx.zero]])


def homogeneous(ctx: Context, linear: Array, translation: Array) -> Array:
    """The homogeneous matrix [[linear, translation], [0, 1]]."""
    size = len(translation)
    return _bordered(linear, translation, [ctx.zero] * size + [ctx.one])


def tangent(ctx: Context, linear: Array, translation: Array) -> Array:
    """The derivative of homogeneous matrices, [[linear, translation], [0, 0]]."""
    return _bordered(linear, translation, [ctx.zero] * (len(translation) + 1))


def _bordered(linear: Array, translation: Array, last: list[Number]) -> Array:
    matrix = np.empty((len(last), len(last)), dtype=object)
    matrix[:-1, :-1] = linear
    matrix[:-1, -1] = translation
    matrix[-1] = last
    return matrix
