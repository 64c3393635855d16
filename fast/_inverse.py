"""Inverses of matrices in double-double, by Gauss and Jordan's elimination with complete pivoting.

Rows and columns are divided by powers of two first, so that entries are of size 1.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._double_double import divide, multiply_add
from affinecert.fast._kernel import compiled
from affinecert.fast._linear_equations import Exponents, exponents_of
from affinecert.fast._numbers import Numbers, shifted

# Entries of size 1 are wrong by 2^-100 or so when they become a pivot; one above this has its sign for sure.
SURE = 2.0**-90

UNUSED = -1


@compiled
def _pivot(matrix: Numbers, row_of: Exponents, column_of: Exponents) -> tuple[int, int]:
    """The place of the largest entry in rows and columns that have had no pivot."""
    row, column, largest = UNUSED, UNUSED, -1.0
    for i in range(len(row_of)):
        for j in range(len(row_of)):
            if column_of[i] == UNUSED and row_of[j] == UNUSED and abs(matrix[i, j].real) > largest:
                row, column, largest = i, j, abs(matrix[i, j].real)
    return row, column


@compiled
def _eliminate(matrix: Numbers, row: int, column: int) -> None:
    """Makes a column that of the unit matrix by operations on rows."""
    pivot = matrix[row, column]
    for j in range(matrix.shape[1]):
        matrix[row, j] = divide(matrix[row, j], pivot)
    for i in range(len(matrix)):
        if i != row:
            factor = -matrix[i, column]
            for j in range(matrix.shape[1]):
                matrix[i, j] = multiply_add(factor, matrix[row, j], matrix[i, j])


@compiled
def matrix_inverse(matrix: Numbers) -> tuple[Numbers, float]:
    """The inverse, and the sign of the determinant, 0 if not sure; not finite if a pivot is 0."""
    size = len(matrix)
    rows = exponents_of(matrix, np.zeros(size, dtype=np.int64), False)
    columns = exponents_of(matrix, rows, True)
    # The matrix, and the unit matrix next to it.
    both = np.zeros((size, 2 * size), dtype=np.complex128)
    row_of, column_of = np.empty(size, dtype=np.int64), np.empty(size, dtype=np.int64)
    sign = 1.0
    for i in range(size):
        row_of[i] = column_of[i] = UNUSED
        both[i, size + i] = 1.0
        for j in range(size):
            both[i, j] = shifted(matrix[i, j], -rows[i] - columns[j])
    for _ in range(size):
        i, j = _pivot(both, row_of, column_of)
        column_of[i], row_of[j] = j, i
        sign *= math.copysign(1.0, both[i, j].real) if abs(both[i, j].real) > SURE else 0.0
        _eliminate(both, i, j)
    inverse = np.empty((size, size), dtype=np.complex128)
    for j in range(size):
        for k in range(size):
            inverse[j, k] = shifted(both[row_of[j], size + k], -columns[j] - rows[k])
            if k < j and row_of[k] > row_of[j]:
                sign = -sign
    return inverse, sign


@compiled
def linear_size(matrix: Numbers) -> int:
    """The size of the linear part of a homogeneous matrix; of another the size of the whole."""
    size = len(matrix) - 1
    good = bool(matrix[size, size] == 1.0)
    for j in range(size):
        good = good and bool(matrix[size, j] == 0.0)
    return size if good else size + 1


@compiled
def homogeneous_inverse(matrix: Numbers) -> tuple[Numbers, float]:
    """The same for a matrix that may be homogeneous, its last row 0 ... 0 1; then that of the inverse is so too."""
    size = linear_size(matrix)
    linear = np.empty((size, size), dtype=np.complex128)
    for i in range(size):
        for j in range(size):
            linear[i, j] = matrix[i, j]
    linear, sign = matrix_inverse(linear)
    result = np.zeros(matrix.shape, dtype=np.complex128)
    for i in range(len(matrix)):
        result[i, i] = 1.0
    for i in range(size):
        for j in range(size):
            result[i, j] = linear[i, j]
            if size < len(matrix):
                result[i, size] = multiply_add(-linear[i, j], matrix[j, size], result[i, size])
    return result, sign
