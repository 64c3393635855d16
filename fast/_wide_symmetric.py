"""Exponential, logarithm and power of symmetric matrices, in double-double: one stage for all three.

f(A) = V f(D) V^T, with the eigenvalues D and eigenvectors V by Jacobi's method.
"""

from __future__ import annotations

import numpy as np

from affinecert.fast._double_double import add, multiply, multiply_add, scaled, times
from affinecert.fast._elementary import LOG_TWO, logarithm, split_exponential
from affinecert.fast._jacobi import eigenvectors
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._numbers import Numbers, numbers, reduced, shifted, store
from affinecert.fast._stages import run

EXPONENTIAL, LOGARITHM, POWER = 0.0, 1.0, 2.0
"""The functions of the stage."""

# A positive eigenvalue that came out not positive, by rounding, is below this part of the largest one.
HIDDEN = 2.0**-100


@compiled
def _logarithms(values: Numbers, exponent: int) -> None:
    """Takes the logarithms of eigenvalues times 2^exponent, all of them positive before rounding."""
    largest = 0.0
    for i in range(len(values)):
        largest = max(largest, values[i].real)
    for i in range(len(values)):
        positive = values[i] if values[i].real > 0.0 else complex(HIDDEN * largest, 0.0)
        values[i] = add(logarithm(positive), times(LOG_TWO, float(exponent)))


@compiled
def _exponentials(values: Numbers) -> int:
    """Takes the exponentials, divided by the power of two whose exponent is returned: the largest is of size 1."""
    exponents = np.empty(len(values), dtype=np.int64)
    for i in range(len(values)):
        values[i], exponents[i] = split_exponential(values[i])
    largest = int(max(exponents))
    for i in range(len(values)):
        values[i] = shifted(values[i], exponents[i] - largest)
    return largest


@kernel(inputs={"matrix": ("d", "d", 2), "t": (), "function": ()}, outputs=(("d", "d", 2),), sizes=(2, 3))
def _symmetric(matrix: Array, t: float, function: float, result: Array, _status: Array) -> None:
    diagonal = numbers(matrix)
    size = diagonal.shape[0]
    for i in range(size):
        for j in range(i):
            diagonal[j, i] = scaled(add(diagonal[i, j], diagonal[j, i]), 0.5)
    exponent = reduced(diagonal)
    vectors = eigenvectors(diagonal)
    values = np.empty(size, dtype=np.complex128)
    for i in range(size):
        values[i] = diagonal[i, i]
    if function == EXPONENTIAL:
        for i in range(size):
            values[i] = shifted(values[i], exponent)
    else:
        _logarithms(values, exponent)
    exponent = 0
    if function != LOGARITHM:
        for i in range(size):
            values[i] = times(values[i], t)
        exponent = _exponentials(values)
    answer = np.zeros((size, size), dtype=np.complex128)
    for i in range(size):
        for j in range(i + 1):
            for k in range(size):
                answer[i, j] = multiply_add(multiply(vectors[i, k], values[k]), vectors[j, k], answer[i, j])
            answer[i, j] = shifted(answer[i, j], exponent)
            answer[j, i] = answer[i, j]
    store(answer, result)


def symmetric_exponential(matrix: Array) -> Array:
    """The exponential of a symmetric matrix, pairs (..., d, d, 2), d = 2 or 3.

    An entry off the diagonal is the mean of the two that are given.
    """
    return run(_symmetric, matrix, np.array(1.0), np.array(EXPONENTIAL))[0]


def symmetric_logarithm(matrix: Array) -> Array:
    """The logarithm of a symmetric positive definite matrix, pairs (..., d, d, 2), d = 2 or 3."""
    return run(_symmetric, matrix, np.array(1.0), np.array(LOGARITHM))[0]


def symmetric_power(matrix: Array, t: Array) -> Array:
    """The power S^t = exp(t log S) of a symmetric positive definite matrix, pairs (..., d, d, 2), and a float64 t."""
    return run(_symmetric, matrix, t, np.array(POWER))[0]
