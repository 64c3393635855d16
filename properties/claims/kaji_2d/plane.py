"""Linear maps of the plane: what the claims about them share. Numbers are mpf or rationals."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.draws import arrays, plane_rotation
from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference._matrices import Array, Number, array

J: Array = array([[0, -1], [1, 0]])
"""The quarter turn."""

IDENTITY: Array = array([[1, 0], [0, 1]])


def determinant(matrix: Array) -> Number:
    """The determinant of a (2, 2) matrix."""
    (a, b), (c, d) = matrix
    return a * d - b * c


def inverse(matrix: Array) -> Array:
    """The inverse of a (2, 2) matrix, exact for rationals."""
    (a, b), (c, d) = matrix
    inverted: Array = array([[d, -b], [-c, a]]) / determinant(matrix)
    return inverted


def inner(a: Array, b: Array) -> Number:
    """The scalar product tr(A Bᵀ) of two matrices, or of two vectors."""
    return (a * b).sum()


def square(a: Array) -> Number:
    """The squared Frobenius norm of a matrix, or length of a vector."""
    return inner(a, a)


def edges(triangle: Array) -> Array:
    """The edges from the first of three vertices, (3, 2), to the others, as columns."""
    return array([triangle[1] - triangle[0], triangle[2] - triangle[0]]).T


def singular_values(matrix: Array) -> tuple[Number, Number]:
    """The singular values of a map of positive determinant, the larger one first: roots of eigenvalues of AᵀA."""
    (p, q), (_, r) = matrix.T @ matrix
    middle, spread = (p + r) / 2, mp.hypot((p - r) / 2, q)
    larger = mp.sqrt(middle + spread)
    return larger, determinant(matrix) / larger


def angle(matrix: Array) -> Number:
    """The angle in (-π, π] of the rotation nearest to a map, the one with the largest tr(RᵀA)."""
    (a, b), (c, d) = matrix
    return mp.atan2(c - b, a + d)


def built(theta: Number, growth: Array) -> Array:
    """The map R_θ exp(L), L symmetric: polar factors that are known beforehand."""
    product: Array = plane_rotation(theta) @ definitions.exponential(mp, growth)
    return product


def growths(name: str, count: int) -> list[Array]:
    """So many symmetric matrices."""
    return [array([[a, b], [b, c]]) for a, b, c in arrays(name, count, (3,), -1, 1)]


def maps(name: str, count: int) -> list[Array]:
    """Maps of positive determinant, the simplest first: stretches, turns, a shear, and that many drawn ones."""
    simple = ([[2, 0], [0, 1]], [[0, -1], [1, 0]], [[1, 1], [0, 1]], [[0, -2], [1, 0]], [[-1, 0], [0, -3]])
    drawn = [each for each in arrays(name, 4 * count, (2, 2), -2, 2) if determinant(each) > 0]
    return [*map(exactly, simple), *drawn[:count]]


def zero_or_one(false: Any) -> int:
    """The deviation of a statement that is true or false: 1 if it is false."""
    return int(bool(false))
