"""Integer arithmetic on matrices of float64, exact: for the few items whose signs double-doubles cannot tell."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from affinecert.fast._kernel import Array

Integers = Sequence[Sequence[int]]


def integers(matrix: Array) -> Integers:
    """The matrix times the least power of two that makes it integer."""
    ratios = [[float(x).as_integer_ratio() for x in row] for row in matrix]
    unit = max(denominator for row in ratios for _, denominator in row)
    return [[numerator * (unit // denominator) for numerator, denominator in row] for row in ratios]


def integers_of_sum(high: Array, low: Array) -> Integers:
    """The sum of two matrices times the least power of two that makes them integer."""
    rows = integers(np.concatenate([high, low]))
    return [
        [x + y for x, y in zip(*both, strict=True)] for both in zip(rows[: len(high)], rows[len(high) :], strict=True)
    ]


def cofactor(a: Integers, i: int, j: int) -> int:
    """The cofactor of an entry of a 3 x 3 matrix."""
    p, q, r, s = (i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3
    return a[p][r] * a[q][s] - a[p][s] * a[q][r]


def adjugate(a: Integers) -> Integers:
    """The adjugate of a 2 x 2 or 3 x 3 matrix."""
    if len(a) == 2:
        return [[a[1][1], -a[0][1]], [-a[1][0], a[0][0]]]
    return [[cofactor(a, j, i) for j in range(3)] for i in range(3)]


def product(a: Integers, b: Integers) -> Integers:
    """The product of two matrices."""
    return [[sum(x * y for x, y in zip(row, column, strict=True)) for column in zip(*b, strict=True)] for row in a]


def determinant(a: Integers) -> int:
    """The determinant of a 2 x 2 or 3 x 3 matrix."""
    return product(a[:1], adjugate(a))[0][0]


def orientation(linear: Array) -> float:
    """1 if the determinant of a matrix is positive, else -1."""
    return 1.0 if determinant(integers(linear)) > 0 else -1.0


def definiteness(matrix: Array) -> float:
    """1 if the symmetric part of a matrix is positive definite, by the signs of its leading minors; else -1."""
    n = integers(matrix)
    twice = [
        [x + y for x, y in zip(row, column, strict=True)] for row, column in zip(n, zip(*n, strict=True), strict=True)
    ]
    minors = [twice[0][0], *(determinant([row[:k] for row in twice[:k]]) for k in range(2, len(n) + 1))]
    return 1.0 if min(minors) > 0 else -1.0


def half_turn(linear: Array, axis: Array) -> list[bool] | None:
    """Whether the rotation of the polar factors of a matrix (3, 3) is by pi, and then which entries of its axis are 0.

    Its axis, if it is, is known roughly. The quaternion of the rotation is an eigenvector of [[tr L, z^T], [z, M]], z
    the vector of L - L^T and M = L + L^T - tr L I; it is (0, x) if x is an eigenvector of M across z.
    """
    n = integers(linear)
    trace = n[0][0] + n[1][1] + n[2][2]
    m = [[n[i][j] + n[j][i] - trace * (i == j) for j in range(3)] for i in range(3)]
    if not _is_across(m, axis, [n[2][1] - n[1][2], n[0][2] - n[2][0], n[1][0] - n[0][1]]):
        return None
    return [_is_across(m, axis, [int(i == j) for j in range(3)]) for i in range(3)]


def _is_across(m: Integers, axis: Array, z: Sequence[int]) -> bool:
    """Whether the eigenvector of a symmetric matrix next to an axis is at a right angle to a vector z.

    Then z, M z and M^2 z lie in a plane, and it is normal to that if they span it; if M z is along z, it is across z.
    """
    if not any(z):
        return True
    once = [sum(x * y for x, y in zip(row, z, strict=True)) for row in m]
    twice = [sum(x * y for x, y in zip(row, once, strict=True)) for row in m]
    normal = [z[i - 2] * once[i - 1] - z[i - 1] * once[i - 2] for i in range(3)]
    if sum(x * y for x, y in zip(normal, twice, strict=True)):
        return False
    return _cosine(normal, axis) > 0.5 if any(normal) else _cosine(z, axis) < 0.5


def _cosine(x: Sequence[int], y: Array) -> float:
    """The cosine of the angle between two lines."""
    largest = max(map(abs, x))
    unit = np.array([entry / largest for entry in x])
    return float(abs(unit @ y) / np.sqrt((unit @ unit) * (y @ y)))


def orientation_of_vertices(vertices: Array) -> float:
    """1 if a tetrahedron (4, 3) has positive volume, or a triangle (3, 3) an area; else -1."""
    first, *others = integers(vertices)
    edges = [[x - y for x, y in zip(row, first, strict=True)] for row in others]
    if len(edges) == 2:
        edges.append([cofactor([[0, 0, 0], *edges], 0, j) for j in range(3)])
    return 1.0 if determinant(edges) > 0 else -1.0


def fixed_point(affine: Array) -> list[float] | None:
    """The fixed point (I - L)^-1 t of an affine map, rounded; None if there is none, or more than one."""
    rows = integers(affine)
    size, unit = len(rows) - 1, rows[-1][-1]
    difference = [[unit * (i == j) - rows[i][j] for j in range(size)] for i in range(size)]
    divisor = determinant(difference)
    if divisor == 0:
        return None
    numerators = product(adjugate(difference), [row[-1:] for row in rows[:-1]])
    return [float(Fraction(numerator, divisor)) for (numerator,) in numerators]
