"""Exact arithmetic on float64 arrays that carries along, to first order, the error that each of them may have.

A law is an identity between computed arrays. Products, inverses and differences are taken in rational arithmetic, so
that they add no error of their own; what the identity may miss by is what the errors of its parts cause.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from gmpy2 import mpq
from mpmath import MPContext

from affinecert.map import Array
from affinecert.properties.law import BadAnswer, OutOfDomain

CTX = MPContext()
CTX.prec = 120  # for norms and logarithms of rationals, whose relative error is thus far below u = 2^-53

UNIT = CTX.mpf(2) ** -53

UNDECIDED = 16
"""A number within so many of its own errors of zero may come out with the other sign."""


def exact(array: Any) -> Any:
    """The array with each float64 as the rational number that it is."""
    return np.vectorize(lambda number: mpq(float(number)), otypes=[object])(array)


def real(number: Any) -> Any:
    """A rational as an mpf, which neither overflows nor underflows."""
    return CTX.mpf(number.numerator) / CTX.mpf(number.denominator)


def norm(array: Any) -> Any:
    """The Frobenius norm of an array of rationals, as an mpf."""
    return CTX.sqrt(real(sum((number * number for number in np.ravel(array)), mpq(0))))


def ratio(distance: Any, allowed: Any) -> float:
    """A distance over what is allowed of it; 0/0 is 0."""
    if distance <= 0:
        return 0.0
    return float(distance / allowed) if allowed > 0 else math.inf


@dataclass(frozen=True)
class Inexact:
    """An array of rationals, and the norm of the error that it may have."""

    value: Any
    error: Any = CTX.zero

    def __matmul__(self, other: Inexact) -> Inexact:
        error = norm(self.value) * other.error + self.error * norm(other.value)
        return Inexact(self.value @ other.value, error)

    def __mul__(self, other: Inexact) -> Inexact:
        """A number, as an array of one entry, times an array."""
        error = norm(self.value) * other.error + self.error * norm(other.value)
        return Inexact(self.value.item() * other.value, error)

    def __add__(self, other: Inexact) -> Inexact:
        return Inexact(self.value + other.value, self.error + other.error)

    @property
    def T(self) -> Inexact:
        """The transpose."""
        return Inexact(self.value.T, self.error)

    def inverse(self) -> Inexact:
        """The inverse of a matrix; its error is that of -M^-1 dM M^-1."""
        value = cofactors(self.value).T / determinant(self.value)
        return Inexact(value, norm(value) ** 2 * self.error)

    def misfit(self, other: Inexact) -> float:
        """The distance to an array that should be equal, over the one that the errors of both account for."""
        return ratio(norm(self.value - other.value), self.error + other.error)


def precisely(array: Any) -> Inexact:
    """An array of float64 that is what it is."""
    return Inexact(exact(array))


@dataclass(frozen=True)
class Affine:
    """An affine map x -> linear x + translation."""

    linear: Inexact
    translation: Inexact

    def __matmul__(self, other: Affine) -> Affine:
        return Affine(self.linear @ other.linear, self(other.translation))

    def __call__(self, point: Inexact) -> Inexact:
        """The image of a point."""
        return self.linear @ point + self.translation

    def then(self, scale: Inexact, linear: Inexact) -> Affine:
        """Followed by a scaling, then a linear map."""
        return Affine(linear @ (scale * self.linear), linear @ (scale * self.translation))

    def inverse(self) -> Affine:
        """The inverse map."""
        linear = self.linear.inverse()
        origin = linear @ self.translation
        return Affine(linear, Inexact(-origin.value, origin.error))

    def misfit(self, other: Affine) -> float:
        """The greater of the misfits of the two parts."""
        return max(self.linear.misfit(other.linear), self.translation.misfit(other.translation))


def affine(matrix: Array) -> Affine:
    """A homogeneous matrix that is what it is."""
    return Affine(precisely(matrix[:-1, :-1]), precisely(matrix[:-1, -1]))


def determinant(matrix: Any) -> Any:
    """The determinant of a matrix of rationals."""
    if len(matrix) == 0:
        return mpq(1)
    minors = (np.delete(matrix[1:], column, axis=1) for column in range(len(matrix)))
    return sum((-1) ** column * matrix[0, column] * determinant(minor) for column, minor in enumerate(minors))


def cofactors(matrix: Any) -> Any:
    """The matrix of cofactors: its transpose over the determinant is the inverse."""
    size = len(matrix)
    result = np.empty((size, size), dtype=object)
    for row, column in np.ndindex(size, size):
        minor = np.delete(np.delete(matrix, row, axis=0), column, axis=1)
        result[row, column] = (-1) ** (row + column) * determinant(minor)
    return result


def log_determinant(matrix: Inexact) -> tuple[Any, Any]:
    """The logarithm of a determinant, and its error, that of trace(M^-1 dM), as mpf.

    OutOfDomain if the determinant is not positive, but might be within its error; BadAnswer if it cannot be.
    """
    volume = determinant(matrix.value)
    error = norm(cofactors(matrix.value)) * matrix.error
    if volume <= 0:
        if UNDECIDED * error >= abs(real(volume)):
            raise OutOfDomain("singular to within its error")
        raise BadAnswer(f"a determinant of {float(volume)}")
    return CTX.log(real(volume)), error / real(volume)
