"""Vectors and matrices of double-doubles: their products, and float64 arrays of pairs (high, low) for them."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from affinecert.fast._double_double import multiply, multiply_add, square_root, subtract
from affinecert.fast._kernel import Array, compiled

Numbers = NDArray[np.complex128]
"""An array of double-doubles."""


@compiled
def shifted(a: complex, exponent: int) -> complex:
    """The product of a double-double and a power of two."""
    return complex(math.ldexp(a.real, exponent), math.ldexp(a.imag, exponent))


@compiled
def numbers(pairs: Array) -> Numbers:
    """The matrix of pairs (k, l, 2)."""
    matrix = np.empty((pairs.shape[0], pairs.shape[1]), dtype=np.complex128)
    for i in range(pairs.shape[0]):
        for j in range(pairs.shape[1]):
            matrix[i, j] = complex(pairs[i, j, 0], pairs[i, j, 1])
    return matrix


@compiled
def vector(pairs: Array) -> Numbers:
    """The vector of pairs (k, 2)."""
    entries = np.empty(pairs.shape[0], dtype=np.complex128)
    for i in range(pairs.shape[0]):
        entries[i] = complex(pairs[i, 0], pairs[i, 1])
    return entries


@compiled
def store(matrix: Numbers, pairs: Array) -> None:
    """Writes a matrix as pairs (k, l, 2)."""
    for i in range(matrix.shape[0]):
        for j in range(matrix.shape[1]):
            pairs[i, j, 0], pairs[i, j, 1] = matrix[i, j].real, matrix[i, j].imag


@compiled
def store_vector(entries: Numbers, pairs: Array) -> None:
    """Writes a vector as pairs (k, 2)."""
    for i in range(len(entries)):
        pairs[i, 0], pairs[i, 1] = entries[i].real, entries[i].imag


@compiled
def reduced(matrix: Numbers) -> int:
    """Divides a matrix by a power of two that makes its largest entry of size 1, and returns the exponent."""
    largest = 0.0
    for i in range(matrix.shape[0]):
        for j in range(matrix.shape[1]):
            largest = max(largest, abs(matrix[i, j].real))
    exponent = math.frexp(largest)[1]
    for i in range(matrix.shape[0]):
        for j in range(matrix.shape[1]):
            matrix[i, j] = shifted(matrix[i, j], -exponent)
    return exponent


@compiled
def image(matrix: Numbers, x: Numbers) -> Numbers:
    """The product of a square matrix and a vector."""
    size = len(x)
    y = np.zeros(size, dtype=np.complex128)
    for i in range(size):
        for j in range(size):
            y[i] = multiply_add(matrix[i, j], x[j], y[i])
    return y


@compiled
def inverse_image(matrix: Numbers, x: Numbers) -> Numbers:
    """The product of the transposed of a square matrix, of a rotation its inverse, and a vector."""
    size = len(x)
    y = np.zeros(size, dtype=np.complex128)
    for i in range(size):
        for j in range(size):
            y[i] = multiply_add(matrix[j, i], x[j], y[i])
    return y


@compiled
def dot(x: Numbers, y: Numbers) -> complex:
    """The inner product."""
    total = 0j
    for i in range(len(x)):
        total = multiply_add(x[i], y[i], total)
    return total


@compiled
def norm(x: Numbers) -> complex:
    """The length of a vector whose entries are not so small that their squares vanish."""
    return square_root(dot(x, x))


@compiled
def cross(x: Numbers, y: Numbers) -> Numbers:
    """The vector product."""
    z = np.empty(3, dtype=np.complex128)
    for i in range(len(z)):
        j, k = (i + 1) % 3, (i + 2) % 3
        z[i] = subtract(multiply(x[j], y[k]), multiply(x[k], y[j]))
    return z
