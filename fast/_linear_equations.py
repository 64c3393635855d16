"""Quotients of matrices and solutions of linear equations in double-double, for rows and columns of any sizes.

Rows and columns are divided by powers of two first, so that entries are of size 1; then the adjugate is used, divided
by the determinant.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from affinecert.fast._double_double import divide, multiply_add
from affinecert.fast._kernel import Array, compiled
from affinecert.fast._numbers import Numbers, shifted
from affinecert.fast._spectrum import determinant_of_space, minor

Exponents = NDArray[np.int64]

# Below the exponent of every float64: a row of zeros stays one.
NO_EXPONENT = -9999


@compiled
def exponents_of(matrix: Numbers, others: Exponents, of_columns: bool) -> Exponents:
    """The exponent of the largest entry of each row (or column), the columns (or rows) being divided by 2^others."""
    size = len(others)
    exponents = np.empty(size, dtype=np.int64)
    for i in range(size):
        exponents[i] = NO_EXPONENT
        for j in range(size):
            entry = matrix[j, i].real if of_columns else matrix[i, j].real
            if entry != 0.0:
                exponents[i] = max(exponents[i], math.frexp(entry)[1] - others[j])
    return exponents


@compiled
def _divided(matrix: Numbers, rows: Exponents, columns: Exponents) -> Numbers:
    """The matrix with its rows and columns divided by powers of two."""
    size = len(rows)
    divided = np.empty((size, size), dtype=np.complex128)
    for i in range(size):
        for j in range(size):
            divided[i, j] = shifted(matrix[i, j], -rows[i] - columns[j])
    return divided


@compiled
def _adjugate(b: Numbers) -> tuple[Numbers, complex, bool]:
    """The adjugate and the determinant of a matrix, (2, 2) or (3, 3), and whether the latter's sign is sure."""
    size = b.shape[0]
    adjugate = np.empty((size, size), dtype=np.complex128)
    if size == 2:
        adjugate[0, 0], adjugate[0, 1], adjugate[1, 0], adjugate[1, 1] = b[1, 1], -b[0, 1], -b[1, 0], b[0, 0]
        determinant, error = minor(b[0, 0], b[0, 1], b[1, 0], b[1, 1])
    else:
        for i in range(size):
            p, q = (i + 1) % 3, (i + 2) % 3
            for j in range(size):
                r, s = (j + 1) % 3, (j + 2) % 3
                adjugate[j, i] = minor(b[p, r], b[p, s], b[q, r], b[q, s])[0]
        determinant, error = determinant_of_space(b)
    return adjugate, determinant, abs(determinant.real) > error


@compiled
def matrix_quotient(c: Numbers, b: Numbers, quotient: Array) -> tuple[int, float]:
    """Writes C B^-1 without an even power of two; returns its exponent, and the sign of det B, 0 if not sure.

    Writes zero if B is singular.
    """
    size = len(b)
    rows = exponents_of(b, np.zeros(size, dtype=np.int64), False)
    columns = exponents_of(b, rows, True)
    adjugate, determinant, sure = _adjugate(_divided(b, rows, columns))
    tops = exponents_of(c, columns, False)
    numerator = _divided(c, tops, columns)
    singular = determinant.real == 0.0
    result = np.zeros((size, size), dtype=np.complex128)
    exponent = NO_EXPONENT
    for i in range(size):
        for j in range(size):
            for k in range(size):
                result[i, j] = multiply_add(numerator[i, k], adjugate[k, j], result[i, j])
            if result[i, j].real != 0.0 and not singular:
                result[i, j] = divide(result[i, j], determinant)
                exponent = max(exponent, math.frexp(result[i, j].real)[1] + tops[i] - rows[j])
    exponent = 0 if exponent == NO_EXPONENT else exponent + (exponent & 1)
    for i in range(size):
        for j in range(size):
            entry = 0j if singular else shifted(result[i, j], tops[i] - rows[j] - exponent)
            quotient[i, j, 0], quotient[i, j, 1] = entry.real, entry.imag
    return exponent, math.copysign(1.0, determinant.real) if sure else 0.0


@compiled
def solution(a: Numbers, b: Numbers, x: Array) -> bool:
    """Writes the solution of a x = b; false if the determinant may be zero."""
    size = len(b)
    rows = exponents_of(a, np.zeros(size, dtype=np.int64), False)
    columns = exponents_of(a, rows, True)
    adjugate, determinant, sure = _adjugate(_divided(a, rows, columns))
    for j in range(size):
        total = 0j
        for i in range(size):
            total = multiply_add(adjugate[j, i], shifted(b[i], -rows[i]), total)
        x[j] = shifted(divide(total, determinant), -columns[j]).real
    return sure
