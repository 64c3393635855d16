"""Functions of a matrix, given on its eigenvalues, applied to vectors."""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._double_double import divide, multiply, multiply_add, scaled, subtract
from affinecert.fast._kernel import compiled
from affinecert.fast._numbers import Numbers, cross, image, norm
from affinecert.fast._three_nodes import Values

# Entries of a matrix of rank one below this part of its largest row are rounding: its entries carry 2^-100 or so.
ROUNDING = 2.0**-90


@compiled
def _normal(matrix: Numbers, m: complex) -> Numbers:
    """The unit normal of the plane of a double eigenvalue m with two eigenvectors.

    It is the left eigenvector of the third eigenvalue; L - m I being of rank one, any of its rows will do. Its first
    component that is not 0 is positive.
    """
    rest = matrix.copy()
    best, longest = 0, 0.0
    for i in range(3):
        rest[i, i] = subtract(matrix[i, i], m)
        square = rest[i, 0].real ** 2 + rest[i, 1].real ** 2 + rest[i, 2].real ** 2
        if square > longest:
            best, longest = i, square
    normal: Numbers = rest[best]
    length = norm(normal)
    sign = 0.0
    for i in range(3):
        if abs(normal[i].real) <= ROUNDING * length.real:
            normal[i] = 0j
        if sign == 0.0:
            sign = math.copysign(1.0, normal[i].real) if normal[i].real != 0.0 else 0.0
        normal[i] = scaled(divide(normal[i], length), sign)
    return normal


@compiled
def _turned(matrix: Numbers, m: complex, x: Numbers) -> Numbers:
    """A vector of the plane of a double eigenvalue m, turned by pi/2: [[0, -1], [1, 0]], in space about the normal."""
    if len(x) == 3:
        return cross(_normal(matrix, m), x)
    turned = np.empty(2, dtype=np.complex128)
    turned[0], turned[1] = -x[1], x[0]
    return turned


@compiled
def applied(
    matrix: Numbers, nodes: tuple[complex, complex, complex], half_turn: bool, values: Values, x: Numbers, y: Numbers
) -> Numbers:
    """The product f(L) x, given y = L x, the eigenvalues m +- sqrt delta and mu of L, and the values of f on them.

    Newton's form; or at a half turn, the double eigenvalue m having two eigenvectors: mean times the part of x in their
    plane, slope times that part turned by pi/2, and single times the rest.
    """
    m, delta, mu = nodes
    mean, slope, single, bend = values
    size = len(x)
    rest, result = np.empty(size, dtype=np.complex128), np.empty(size, dtype=np.complex128)
    if half_turn:
        for i in range(size):
            if size == 3:
                rest[i] = divide(subtract(y[i], multiply(mu, x[i])), subtract(m, mu))
            else:
                rest[i] = x[i]
            result[i] = multiply_add(mean, rest[i], multiply(single, subtract(x[i], rest[i])))
        turned = _turned(matrix, m, rest)
        for i in range(size):
            result[i] = multiply_add(slope, turned[i], result[i])
        return result
    for i in range(size):
        rest[i] = subtract(y[i], multiply(m, x[i]))
        result[i] = multiply_add(slope, rest[i], multiply(mean, x[i]))
    if size == 3:
        again = image(matrix, rest)
        for i in range(size):
            square = subtract(again[i], multiply_add(m, rest[i], multiply(delta, x[i])))
            result[i] = multiply_add(bend, square, result[i])
    return result
