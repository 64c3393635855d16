"""Gram and Schmidt's orthogonalisation of three vectors of space, in double-double."""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._double_double import ONE, divide, exact_sum, multiply, multiply_add, scaled, subtract
from affinecert.fast._kernel import Array, compiled
from affinecert.fast._numbers import Numbers, cross, dot, norm, shifted

# Axes and parts of vectors of size 1 carry errors of a few 2^-104.
UNIT = 2.0**-98


@compiled
def differences(vertices: Array) -> Numbers:
    """The edges from the first vertex, one a row, exactly."""
    count = vertices.shape[0] - 1
    edges = np.empty((count, 3), dtype=np.complex128)
    for i in range(count):
        for j in range(3):
            edges[i, j] = exact_sum(vertices[i + 1, j], -vertices[0, j])
    return edges


@compiled
def _reduced(x: Numbers) -> int:
    """Divides a vector by a power of two that makes its largest entry of size 1, and returns the exponent."""
    exponent = math.frexp(max(abs(x[0].real), abs(x[1].real), abs(x[2].real)))[1]
    for i in range(len(x)):
        x[i] = shifted(x[i], -exponent)
    return exponent


@compiled
def normalised(x: Numbers) -> complex:
    """Divides a vector by its length, which is returned."""
    exponent = _reduced(x)
    length = norm(x)
    for i in range(len(x)):
        x[i] = divide(x[i], length)
    return shifted(length, exponent)


@compiled
def reduced_by(axis: Numbers, x: Numbers) -> complex:
    """Takes from a vector its part along a unit vector, and returns the length of that part."""
    length = dot(axis, x)
    for i in range(len(x)):
        x[i] = subtract(x[i], multiply(length, axis[i]))
    return length


@compiled
def align(vectors: Numbers, orientation: float, axes: Numbers, parts: Numbers) -> float:
    """Writes unit axes q_i, and the parts x_i . q_j, j <= i, of three vectors x_i in the rows of a matrix.

    q_1 is along x_1, q_2 in the plane of x_1 and x_2, and q_3 is q_1 x q_2 times ``orientation``, 1 or -1. Returns the
    sign of x_3 . q_3, or 0 if it is not sure. Given two vectors only, q_3 stands for the third one.
    """
    first, second = vectors[0].copy(), vectors[1].copy()
    parts[0, 0] = normalised(first)
    exponent = _reduced(second)
    along = reduced_by(first, second)
    across = normalised(second)
    # Once more: what is left of a vector nearly along the first axis is not orthogonal to it.
    correction = reduced_by(first, second)
    parts[1, 0] = shifted(multiply_add(across, correction, along), exponent)
    parts[1, 1] = shifted(multiply(across, normalised(second)), exponent)
    third = cross(first, second)
    for i in range(len(third)):
        third[i] = scaled(third[i], orientation)
        axes[0, i], axes[1, i], axes[2, i] = first[i], second[i], third[i]
    parts[0, 1], parts[0, 2], parts[1, 2], parts[2, 0], parts[2, 1], parts[2, 2] = 0j, 0j, 0j, 0j, 0j, ONE
    # The second axis turns by a rounding over the sine of the angle between the first two vectors.
    error = UNIT * (1.0 + 1.0 / across.real)
    if len(vectors) == 2:
        return 1.0 if across.real > UNIT else 0.0
    rest = vectors[2].copy()
    exponent = _reduced(rest)
    parts[2, 0], parts[2, 1] = shifted(dot(rest, first), exponent), shifted(dot(rest, second), exponent)
    height = dot(rest, third)
    parts[2, 2] = shifted(height, exponent)
    return math.copysign(1.0, height.real) if abs(height.real) > error else 0.0


@compiled
def rows_aligned(linear: Numbers, rotation: Numbers, upper: Numbers) -> float:
    """Writes the upper triangular U and the rotation R with L = U R; returns the sign of det L, 0 if not sure."""
    reverse, parts = np.empty((3, 3), dtype=np.complex128), np.empty((3, 3), dtype=np.complex128)
    axes = np.empty((3, 3), dtype=np.complex128)
    size = len(linear)
    for i in range(size):
        for j in range(size):
            reverse[i, j] = linear[2 - i, j]
    sign = align(reverse, -1.0, axes, parts)
    for i in range(size):
        for j in range(size):
            rotation[i, j], upper[i, j] = axes[2 - i, j], parts[2 - i, 2 - j]
    return sign


@compiled
def edges_aligned(edges: Numbers, rotation: Numbers, upper: Numbers) -> float:
    """Writes the rotation R and the upper triangular U with R [e_1 e_2 e_3] = U; returns the sign of det U.

    The sign is 0 if it is not sure. Of two edges the third is their unit normal; 0 says then that they may be parallel.
    """
    parts = np.empty((3, 3), dtype=np.complex128)
    sign = align(edges, 1.0, rotation, parts)
    size = len(rotation)
    for i in range(size):
        for j in range(size):
            upper[i, j] = parts[j, i]
    return sign
