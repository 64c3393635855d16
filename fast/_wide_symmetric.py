"""Exponential, logarithm and power of symmetric matrices, in double-double: one stage for all three.

f(A) = V f(D) V^T, with the eigenvalues D and eigenvectors V by Jacobi's method.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._double_double import ONE, add, multiply, multiply_add, scaled, subtract, times
from affinecert.fast._elementary import LOG_2, logarithm, split_exponential
from affinecert.fast._jacobi import eigenvectors
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._numbers import Numbers, numbers, reduced, shifted, store
from affinecert.fast._stages import run

EXPONENTIAL, LOGARITHM, POWER = 0.0, 1.0, 2.0
"""The functions of the stage."""

ALWAYS = np.array(1.0)
"""The time of what has none."""

UNDECIDED, DEFINITE, NOT_DEFINITE, NOT_SYMMETRIC = 0.0, 1.0, -1.0, -2.0
"""What a matrix is: positive definite, surely or surely not, or not symmetric at all."""

# Exponentials are kept below 2^LARGE until the last step, lest products overflow that are small again in the end.
LARGE = 900
# Beyond it the exponential is infinite even then, below its negative 0: the largest stands for all that are.
MOST_EXPONENT = 1300.0

# A - A^T may be this part of A in the Frobenius norm: rounding to float32 leaves under 9e-8.
SYMMETRY = 1e-6

# Eigenvalues carry errors below this part of the largest one: a few units of 2^-104 from each of some 18 rotations.
HIDDEN = 2.0**-98


@compiled
def _logarithms(values: Numbers, exponent: int) -> None:
    """Takes the logarithms of eigenvalues times 2^exponent, of which all are positive but for their errors."""
    largest = 0.0
    for i in range(len(values)):
        largest = max(largest, values[i].real)
    for i in range(len(values)):
        positive = values[i] if values[i].real > 0.0 else complex(HIDDEN * largest, 0.0)
        values[i] = add(logarithm(positive), times(LOG_2, float(exponent)))


@compiled
def _exponentials(values: Numbers) -> int:
    """Takes the exponentials, divided by a power of two that keeps the largest in bounds; its exponent is returned."""
    exponents, largest = np.empty(len(values), dtype=np.int64), -math.inf
    for i in range(len(values)):
        largest = max(largest, values[i].real)
    for i in range(len(values)):
        if MOST_EXPONENT < largest < math.inf:
            values[i] = add(subtract(values[i], complex(largest, 0.0)), complex(MOST_EXPONENT, 0.0))
        if not abs(values[i].real) < MOST_EXPONENT:
            values[i] = complex(math.copysign(MOST_EXPONENT, values[i].real), 0.0)
        values[i], exponents[i] = split_exponential(values[i])
    excess = max(int(max(exponents)) - LARGE, 0)
    for i in range(len(values)):
        values[i] = shifted(values[i], exponents[i] - excess)
    return excess


@compiled
def _symmetrised(matrix: Numbers) -> bool:
    """Puts the means of the entries off the diagonal above it; whether they are as near as a symmetric matrix's."""
    square = skew = 0.0
    for i in range(matrix.shape[0]):
        square += matrix[i, i].real ** 2
        for j in range(i):
            square += matrix[i, j].real ** 2 + matrix[j, i].real ** 2
            skew += 2.0 * subtract(matrix[i, j], matrix[j, i]).real ** 2
            matrix[j, i] = scaled(add(matrix[i, j], matrix[j, i]), 0.5)
    return skew <= SYMMETRY**2 * square


@compiled
def _definiteness(values: Numbers) -> float:
    """What the eigenvalues of a symmetric matrix make of it."""
    smallest, largest = math.inf, 0.0
    for i in range(len(values)):
        smallest, largest = min(smallest, values[i].real), max(largest, abs(values[i].real))
    if abs(smallest) <= HIDDEN * largest:
        return UNDECIDED
    return DEFINITE if smallest > 0.0 else NOT_DEFINITE


@kernel(inputs={"matrix": ("d", "d", 2), "t": (), "function": ()}, outputs=(("d", "d", 2), (), ()), sizes=(2, 3))
def symmetric(
    matrix: Array, t: float, function: float, result: Array, scale: Array, kind: Array, _status: Array
) -> None:
    """The function of a matrix, but for a power of two, whose exponent is the scale; and what the matrix is.

    For `POWER` it is the t-th power, exact at 0 and 1.
    """
    diagonal = numbers(matrix)
    size = diagonal.shape[0]
    exponent = reduced(diagonal)
    near = _symmetrised(diagonal)
    part = diagonal.copy()
    vectors = eigenvectors(diagonal)
    values = np.empty(size, dtype=np.complex128)
    for i in range(size):
        values[i] = diagonal[i, i]
    kind[0] = _definiteness(values) if near else NOT_SYMMETRIC
    if function == EXPONENTIAL:
        for i in range(size):
            values[i] = shifted(values[i], exponent)
    else:
        _logarithms(values, exponent)
    power = 0
    if function == POWER:
        for i in range(size):
            values[i] = times(values[i], t)
    if function != LOGARITHM:
        power = _exponentials(values)
    answer = np.zeros((size, size), dtype=np.complex128)
    for i in range(size):
        for j in range(i + 1):
            for k in range(size):
                answer[i, j] = multiply_add(multiply(vectors[k, i], values[k]), vectors[k, j], answer[i, j])
            if function == POWER and t == 0.0:
                answer[i, j] = ONE if i == j else 0j
            elif function == POWER and t == 1.0:
                answer[i, j] = shifted(part[j, i], exponent - power)
            answer[j, i] = answer[i, j]
    store(answer, result)
    scale[0] = power


def function_of(matrix: Array, t: Array, function: float) -> tuple[Array, Array]:
    """A function of symmetric matrices, and what the matrices are."""
    result, scale, kind = run(symmetric, matrix, t, np.array(function))
    return _rescaled(result, scale), kind


@np.errstate(over="ignore", under="ignore")
def _rescaled(result: Array, scale: Array) -> Array:
    return np.ldexp(result, scale.astype(np.int64)[..., None, None, None]) if scale.any() else result


def reduced_exponential(matrix: Array) -> tuple[Array, Array]:
    """The exponential of a symmetric matrix but for a power of two beyond the range, and that one's exponent (...)."""
    result, scale, _ = run(symmetric, matrix, ALWAYS, np.array(EXPONENTIAL))
    return result, scale.astype(np.int64)


def symmetric_exponential(matrix: Array) -> Array:
    """The exponential of a symmetric matrix, pairs (..., d, d, 2), d = 2 or 3.

    An entry off the diagonal is the mean of the two that are given.
    """
    return function_of(matrix, ALWAYS, EXPONENTIAL)[0]


def symmetric_logarithm(matrix: Array) -> Array:
    """The logarithm of a symmetric positive definite matrix, pairs (..., d, d, 2), d = 2 or 3."""
    return function_of(matrix, ALWAYS, LOGARITHM)[0]


def symmetric_power(matrix: Array, t: Array) -> Array:
    """The power S^t = exp(t log S) of a symmetric positive definite matrix, pairs (..., d, d, 2), for a float64 t."""
    return function_of(matrix, t, POWER)[0]
