"""Jacobi's rotations, in double-double: the eigenvectors of symmetric matrices, and the polar factors of any.

Rotations of two coordinates at a time keep the small eigenvalues of a positive definite matrix as accurate as its
scaled form D A D, of unit diagonal, determines them (Demmel and Veselic, "Jacobi's method is more accurate than QR",
1992), and need no case of their own where eigenvalues meet. Matrices are 2 x 2 or 3 x 3, the largest entry of size 1.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._alignment import normalised, reduced_by
from affinecert.fast._double_double import (
    ONE,
    add,
    divide,
    multiply,
    multiply_add,
    scaled,
    square_root,
    subtract,
)
from affinecert.fast._kernel import compiled
from affinecert.fast._numbers import Numbers, cross, dot, shifted

# Coordinates whose coupling is below this part of the geometric mean of their diagonal entries are left alone: some
# eight units of 2^-106, what the products that make it may be wrong by.
UNCOUPLED = 2.0**-103

# From any 3 x 3 matrix five or six sweeps arrive; only one that is singular to 2^-100 never does.
MOST_SWEEPS = 12


@compiled
def identity(size: int) -> Numbers:
    """The identity matrix."""
    matrix = np.zeros((size, size), dtype=np.complex128)
    for i in range(size):
        matrix[i, i] = ONE
    return matrix


@compiled
def _tangent(difference: complex, coupling: complex) -> complex:
    """The tangent t, at most 1, of the rotation that uncouples two coordinates: t^2 + t difference / coupling = 1."""
    exponent = math.frexp(max(abs(difference.real), abs(coupling.real)))[1]
    difference, twice = shifted(difference, -exponent), shifted(coupling, 1 - exponent)
    root = square_root(multiply_add(difference, difference, multiply(twice, twice)))
    return divide(twice, add(difference, root) if difference.real >= 0.0 else subtract(difference, root))


@compiled
def _turn(matrix: Numbers, p: int, q: int, cosine: complex, sine: complex) -> None:
    """Rotates two rows into one another."""
    for i in range(matrix.shape[1]):
        x, y = matrix[p, i], matrix[q, i]
        matrix[p, i] = subtract(multiply(cosine, x), multiply(sine, y))
        matrix[q, i] = multiply_add(sine, x, multiply(cosine, y))


@compiled
def _uncoupled(x: complex, y: complex, coupling: complex) -> bool:
    """Whether a coupling of two coordinates is none, next to their diagonal entries."""
    return abs(coupling.real) <= UNCOUPLED * math.sqrt(abs(x.real)) * math.sqrt(abs(y.real))


@compiled
def eigenvectors(matrix: Numbers) -> Numbers:
    """The eigenvectors of a symmetric matrix, in rows; diagonalises the matrix, whose upper half counts."""
    size = matrix.shape[0]
    vectors = identity(size)
    for _ in range(MOST_SWEEPS):
        coupled = False
        for p in range(size - 1):
            for q in range(p + 1, size):
                x, y, coupling = matrix[p, p], matrix[q, q], matrix[p, q]
                if _uncoupled(x, y, coupling):
                    continue
                coupled = True
                tangent = _tangent(subtract(y, x), coupling)
                cosine = divide(ONE, square_root(multiply_add(tangent, tangent, ONE)))
                sine = multiply(tangent, cosine)
                moved = multiply(tangent, coupling)
                matrix[p, p], matrix[q, q], matrix[p, q] = subtract(x, moved), add(y, moved), 0j
                if size == 3:
                    r = 3 - p - q
                    first, second = (min(p, r), max(p, r)), (min(q, r), max(q, r))
                    x, y = matrix[first], matrix[second]
                    matrix[first] = subtract(multiply(cosine, x), multiply(sine, y))
                    matrix[second] = multiply_add(sine, x, multiply(cosine, y))
                _turn(vectors, p, q, cosine, sine)
        if not coupled:
            break
    return vectors


@compiled
def _orthogonal(columns: Numbers) -> Numbers:
    """The rotation V, in rows its columns, that makes the columns of L V orthogonal; those of L, in rows, become so."""
    vectors = identity(3)
    for _ in range(MOST_SWEEPS):
        coupled = False
        for p, q in ((0, 1), (0, 2), (1, 2)):
            x, y, coupling = dot(columns[p], columns[p]), dot(columns[q], columns[q]), dot(columns[p], columns[q])
            if _uncoupled(x, y, coupling):
                continue
            coupled = True
            tangent = _tangent(subtract(y, x), coupling)
            cosine = divide(ONE, square_root(multiply_add(tangent, tangent, ONE)))
            sine = multiply(tangent, cosine)
            _turn(columns, p, q, cosine, sine)
            _turn(vectors, p, q, cosine, sine)
        if not coupled:
            break
    return vectors


@compiled
def _size(x: Numbers) -> float:
    """The length of a vector."""
    return math.hypot(math.hypot(x[0].real, x[1].real), x[2].real)


@compiled
def _by_length(rows: Numbers) -> tuple[int, int, int]:
    """The numbers of three vectors, the longest first."""
    a, b, c = _size(rows[0]), _size(rows[1]), _size(rows[2])
    first = 0 if a >= b and a >= c else 1 if b >= c else 2
    p, q = (first + 1) % 3, (first + 2) % 3
    if _size(rows[p]) < _size(rows[q]):
        p, q = q, p
    return first, p, q


@compiled
def _across(first: Numbers, second: Numbers) -> None:
    """Makes the second of two vectors, the first of length 1, of length 1 too and at a right angle, or of any such."""
    if not abs(dot(first, second).real) < 0.5 * _size(second):
        # Rounding is all that is left of it, or nothing.
        x, y, z = first
        if abs(x.real) + abs(y.real) >= abs(z.real):
            second[0], second[1], second[2] = -y, x, 0j
        else:
            second[0], second[1], second[2] = 0j, -z, y
    # Twice: what is left of one nearly along the first is not orthogonal to it.
    for _ in range(2):
        normalised(second)
        reduced_by(first, second)
    normalised(second)


@compiled
def _rotation_of_space(linear: Numbers) -> Numbers:
    """The rotation U V^T next to L = U D V^T, det L > 0.

    With the columns of L V orthogonal, U is what Gram and Schmidt's method makes of the longer two, and their vector
    product: so the rotation is as accurate as it is determined, by the sum of the two smaller singular values.
    """
    columns = linear.T.copy()
    vectors = _orthogonal(columns)
    longest, middle, shortest = _by_length(columns)
    normalised(columns[longest])
    _across(columns[longest], columns[middle])
    normal = cross(columns[longest], columns[middle])
    # The order is cyclic, or it mirrors.
    parity = 1.0 if middle == (longest + 1) % 3 else -1.0
    for n in range(3):
        columns[shortest, n] = scaled(normal[n], parity)
    rotation = np.zeros((3, 3), dtype=np.complex128)
    for i in range(3):
        for j in range(3):
            for n in range(3):
                rotation[i, j] = multiply_add(columns[n, i], vectors[n, j], rotation[i, j])
    return rotation


@compiled
def _rotation_of_plane(linear: Numbers) -> Numbers:
    """The rotation next to L, det L > 0: by the angle of (l_11 + l_22, l_21 - l_12)."""
    cosine, sine = add(linear[0, 0], linear[1, 1]), subtract(linear[1, 0], linear[0, 1])
    exponent = math.frexp(max(abs(cosine.real), abs(sine.real)))[1]
    cosine, sine = shifted(cosine, -exponent), shifted(sine, -exponent)
    length = square_root(multiply_add(cosine, cosine, multiply(sine, sine)))
    cosine, sine = divide(cosine, length), divide(sine, length)
    rotation = np.empty((2, 2), dtype=np.complex128)
    rotation[0, 0], rotation[0, 1], rotation[1, 0], rotation[1, 1] = cosine, -sine, sine, cosine
    return rotation


@compiled
def polar_rotation(linear: Numbers) -> Numbers:
    """The rotation R with L = R S, S symmetric and positive definite, of a matrix of positive determinant."""
    if linear.shape[0] == 2:
        return _rotation_of_plane(linear)
    return _rotation_of_space(linear)
