"""Eigenvalues of real 2 x 2 and 3 x 3 matrices of positive determinant, and what their signs say of a logarithm.

The characteristic polynomial is computed in double-double, its constant term from the elimination of the largest entry,
which a relative error of 2^-100 in the matrix explains. In space the real root furthest from the mean of the three is
split off; it is simple unless all three are equal. The pair that is left is told by its mean m and delta, m +- sqrt
delta, so that equal roots need no case of their own: their errors are those of the polynomial's coefficients.

A real logarithm exists if no eigenvalue is negative, or a double one with two eigenvectors is (Culver, "On the
existence and uniqueness of the real logarithm of a matrix", 1966; Rossignac and Vinacua, section 5.1). Every sign is
held against a bound for its error; where it cannot be told, the answer is UNDECIDED.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._double_double import (
    add,
    divide,
    multiply,
    multiply_add,
    scaled,
    square_root,
    subtract,
    times,
)
from affinecert.fast._kernel import compiled
from affinecert.fast._numbers import Numbers

NONE, PRIMARY, HALF_TURN, UNDECIDED, NOT_ORIENTED = 0.0, 1.0, 2.0, 3.0, 4.0
"""No real logarithm; one, with eigenvalues off the negative axis; one, at a double negative eigenvalue with two
eigenvectors; not told in double-double; the determinant is not positive."""

Nodes = tuple[complex, complex, complex, complex]
"""The mean m of the pair of eigenvalues, delta, the product m^2 - delta of the two, and the third eigenvalue."""

# Each coefficient is the end of at most eight operations with relative errors of at most 2^-102.
UNIT = 2.0**-98
# What products lose by underflow, the largest entry being of size 1.
UNDERFLOW = 2.0**-1000

# Eigenvalues below this part of the largest entry are below the rounding of double-doubles; so no quotient overflows.
FLOOR = 2.0**-120
# A pair nearer to the negative axis than this, delta against m^2, is taken as this near: slopes, which are like
# 1 / sqrt delta, must not overflow, and their cubes occur.
VERGE = 2.0**-600

# Newton's steps from a bound at most twice the root: a factor 2/3 each at first, then quadratic.
MOST_STEPS = 60


@compiled
def minor(a: complex, b: complex, c: complex, d: complex) -> tuple[complex, float]:
    """The determinant a d - b c, and a bound for its error."""
    ad, bc = multiply(a, d), multiply(b, c)
    return subtract(ad, bc), UNIT * (abs(ad.real) + abs(bc.real)) + UNDERFLOW


@compiled
def determinant_of_space(a: Numbers) -> tuple[complex, float]:
    """The determinant of a 3 x 3 matrix by elimination of the largest entry, and a bound for its error."""
    size = a.shape[0]
    p, q = 0, 0
    for i in range(size):
        for j in range(size):
            if abs(a[i, j].real) > abs(a[p, q].real):
                p, q = i, j
    pivot = a[p, q]
    if pivot.real == 0.0:
        return 0j, 0.0
    rest, error = np.empty((size, size), dtype=np.complex128), np.empty((size, size))
    for i in range(size):
        ratio = divide(a[i, q], pivot)
        for j in range(size):
            taken = multiply(ratio, a[p, j])
            rest[i, j] = subtract(a[i, j], taken)
            error[i, j] = UNIT * (abs(a[i, j].real) + abs(taken.real)) + UNDERFLOW
    # In cyclic order, so that the sign is that of the determinant.
    i, j, r, s = (p + 1) % 3, (p + 2) % 3, (q + 1) % 3, (q + 2) % 3
    value, bound = minor(rest[i, r], rest[i, s], rest[j, r], rest[j, s])
    bound += error[i, r] * (abs(rest[j, s].real) + error[j, s]) + error[j, s] * abs(rest[i, r].real)
    bound += error[i, s] * (abs(rest[j, r].real) + error[j, r]) + error[j, r] * abs(rest[i, s].real)
    return multiply(pivot, value), abs(pivot.real) * (bound + UNIT * abs(value.real)) + UNDERFLOW


@compiled
def _plane(a: Numbers) -> tuple[float, Nodes]:
    """The answer on the logarithm, and the nodes, of a 2 x 2 matrix; the third one is only a stand-in."""
    determinant, determinant_error = minor(a[0, 0], a[0, 1], a[1, 0], a[1, 1])
    trace = add(a[0, 0], a[1, 1])
    trace_error = UNIT * (abs(a[0, 0].real) + abs(a[1, 1].real))
    half = scaled(subtract(a[0, 0], a[1, 1]), 0.5)
    delta, delta_error = minor(half, -a[0, 1], a[1, 0], half)
    nodes = (scaled(trace, 0.5), delta, determinant, square_root(determinant))
    if determinant.real < -determinant_error:
        return NOT_ORIENTED, nodes
    if determinant.real <= determinant_error:
        return UNDECIDED, nodes
    if delta.real < -delta_error or trace.real > trace_error:
        return PRIMARY, nodes
    if delta.real > delta_error and trace.real < -trace_error:
        return NONE, nodes
    return UNDECIDED, nodes


@compiled
def _outermost_root(p: float, q: float) -> float:
    """The real root of y^3 + p y + q of the largest modulus.

    It has the sign of -q; for q < 0 Newton's steps come down to it from any bound above, where the cubic is convex.
    """
    constant = abs(q)
    y = math.sqrt(max(-p, 0.0)) + math.pow(constant, 1.0 / 3.0)
    if p > 0.0:
        y = min(y, constant / p)
    for _ in range(MOST_STEPS):
        slope = 3.0 * y * y + p
        following = y - ((y * y + p) * y - constant) / slope if slope > 0.0 else y
        if not following < y:
            break
        y = following
    return -y if q > 0.0 else y


@compiled
def _split(trace: complex, minors: complex, determinant: complex, p: complex, q: complex, mean: complex) -> Nodes:
    """The nodes of x^3 - trace x^2 + minors x - determinant = y^3 + p y + q, y = x - mean."""
    root = _outermost_root(p.real, q.real)
    y = complex(root, 0.0)
    slope = 3.0 * root * root + p.real
    if slope > 0.0:
        for _ in range(2):
            value = multiply_add(add(multiply(y, y), p), y, q)
            y = add(y, complex(-value.real / slope, 0.0))
    third = add(mean, y)
    if abs(third.real) < 0.125 * abs(mean.real):
        # A small root, where the sum cancels: it is known to more digits from the small coefficients. The other two are
        # of the size of the mean, so that the slope is.
        for _ in range(4):
            value = subtract(multiply(multiply_add(subtract(third, trace), third, minors), third), determinant)
            slope = (3.0 * third.real - 2.0 * trace.real) * third.real + minors.real
            third = add(third, complex(-value.real / slope, 0.0))
    if abs(third.real) < FLOOR:
        third = complex(FLOOR, 0.0)
    if third.real * third.real * abs(third.real) >= determinant.real:
        # Large roots are split off from the constant term on, small ones from the leading one: so nothing cancels.
        product = divide(determinant, third)
        m = scaled(divide(subtract(minors, product), third), 0.5)
    else:
        m = scaled(subtract(trace, third), 0.5)
        product = subtract(minors, scaled(multiply(m, third), 2.0))
    return m, subtract(multiply(m, m), product), product, third


@compiled
def _space(a: Numbers) -> tuple[float, Nodes]:
    """The answer on the logarithm, and the nodes, of a 3 x 3 matrix."""
    determinant, determinant_error = determinant_of_space(a)
    trace = add(add(a[0, 0], a[1, 1]), a[2, 2])
    trace_error = UNIT * (abs(a[0, 0].real) + abs(a[1, 1].real) + abs(a[2, 2].real))
    minors, minors_error = 0j, 0.0
    for i in range(a.shape[0]):
        j = (i + 1) % 3
        value, error = minor(a[i, i], a[i, j], a[j, i], a[j, j])
        minors, minors_error = add(minors, value), minors_error + 2.0 * error
    mean = divide(trace, complex(3.0, 0.0))
    square = multiply(mean, mean)
    p = subtract(minors, times(square, 3.0))
    cube = multiply(mean, square)
    linear = multiply(mean, minors)
    q = subtract(subtract(linear, scaled(cube, 2.0)), determinant)
    nodes = _split(trace, minors, determinant, p, q, mean)
    if determinant.real < -determinant_error:
        return NOT_ORIENTED, nodes
    if determinant.real <= determinant_error:
        return UNDECIDED, nodes
    if trace.real > trace_error and minors.real > minors_error:
        return PRIMARY, nodes
    size, tilt = abs(p.real), abs(q.real)
    p_error = minors_error + 2.0 * abs(mean.real) * trace_error + UNIT * (abs(minors.real) + square.real)
    q_error = (
        determinant_error
        + abs(mean.real) * minors_error
        + (abs(minors.real) + 6.0 * square.real) * trace_error
        + UNIT * (abs(determinant.real) + abs(linear.real) + abs(cube.real))
    )
    discriminant = -add(scaled(multiply(multiply(p, p), p), 4.0), times(multiply(q, q), 27.0))
    error = 12.0 * (size + p_error) ** 2 * p_error + 54.0 * (tilt + q_error) * q_error
    error += UNIT * (4.0 * size**3 + 27.0 * tilt * tilt)
    if discriminant.real < -error:
        return PRIMARY, nodes
    if discriminant.real > error and (trace.real < -trace_error or minors.real < -minors_error):
        return NONE, nodes
    return UNDECIDED, nodes


@compiled
def spectrum(matrix: Numbers) -> tuple[float, Nodes]:
    """Whether a 2 x 2 or 3 x 3 matrix, its largest entry of size 1, has a real logarithm; and its nodes."""
    return _plane(matrix) if matrix.shape[0] == 2 else _space(matrix)


@compiled
def settled(nodes: Nodes) -> Nodes:
    """The nodes of a matrix with a real logarithm, moved, if need be, from where rounding has put them."""
    m, delta, determinant, mu = nodes
    if mu.real < FLOOR:
        mu = complex(FLOOR, 0.0)
    if determinant.real < FLOOR * FLOOR:
        determinant = complex(FLOOR * FLOOR, 0.0)
        delta = subtract(multiply(m, m), determinant)
    if m.real < 0.0 and delta.real > -VERGE * m.real * m.real:
        delta = complex(-VERGE * m.real * m.real, 0.0)
        determinant = subtract(multiply(m, m), delta)
    return m, delta, determinant, mu
