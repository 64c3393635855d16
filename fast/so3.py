"""Rotations of space: exponential and logarithms.

The rotation vector omega stands for the rotation by |omega| radians about it; [omega] is the matrix of the vector
product with it.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast._compensated import Pair, dot, dot_plain, fma
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._rotation import (
    NOT_ORTHOGONAL,
    REFLECTION,
    angle_over_sine,
    entries,
    nearest_quaternion,
    rodrigues,
    write_rotation,
)

REFUSALS = (("rotation", NOT_ORTHOGONAL), ("rotation", REFLECTION))

# pi is the sum of these two within 2^-106 of itself.
PI, PI_LOW = math.pi, 1.2246467991473532e-16


@compiled
def write_vector(w: Pair, x: Pair, y: Pair, z: Pair, vector: Array) -> None:
    """The principal rotation vector of the quaternion (w, x, y, z), w >= 0."""
    (factor, factor_low), _ = angle_over_sine(w, x, y, z)
    for i, (high, low) in enumerate((x, y, z)):
        vector[i] = 2.0 * fma(factor, high, fma(factor, low, factor_low * high))


@kernel(inputs={"omega": (3,)}, outputs=((3, 3),))
def _exp(omega: Array, rotation: Array, _status: Array) -> None:
    axis, _, _, coefficients = rodrigues((omega[0], omega[1], omega[2]))
    write_rotation(axis, coefficients, rotation)


def exp(omega: ArrayLike) -> Array:
    """The rotation by the rotation vector omega, the exponential of [omega] as the sum of [omega]^k / k!.

    omega (..., 3) in radians, of any length; gives (..., 3, 3). Computed by Rodrigues' formula, the angle being kept in
    twice the precision. Raises InputError for a wrong shape or dtype and for numbers that are not finite.

    >>> exp([0.0, 0.0, np.pi / 2]).round(15) + 0.0
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    """
    return _exp(omega)[0]


@kernel(inputs={"rotation": (3, 3)}, outputs=((3,),), refusals=REFUSALS)
def _log(rotation: Array, vector: Array, status: Array) -> None:
    status[0], w, x, y, z = nearest_quaternion(entries(rotation))
    write_vector(w, x, y, z, vector)


def log(rotation: ArrayLike) -> Array:
    """The rotation vector of angle in [0, pi] whose exponential is the rotation nearest to the given matrix.

    rotation (..., 3, 3) with |R^T R - I| <= 1e-6 in the Frobenius norm; gives (..., 3) in radians. At angle pi exactly,
    where two vectors serve, the one whose first entry other than 0 is positive. The nearest rotation is the orthogonal
    polar factor; for a matrix rounded from a rotation it makes the logarithm accurate to the last bits at every angle.
    Raises InputError for a wrong shape or dtype, numbers that are not finite, and matrices that are not rotations.

    >>> log(np.diag([-1.0, -1.0, 1.0])) + 0.0  # at pi: the first non-zero component is positive
    array([0.        , 0.        , 3.14159265])
    """
    return _log(rotation)[0]


@kernel(inputs={"rotation": (3, 3), "near": (3,)}, outputs=((3,),), refusals=REFUSALS)
def _log_near(rotation: Array, near: Array, vector: Array, status: Array) -> None:
    status[0], w, x, y, z = nearest_quaternion(entries(rotation))
    size = max(abs(x[0]), abs(y[0]), abs(z[0]))
    if size == 0.0:
        # No rotation at all: whole turns about any axis, so about that of ``near``.
        largest = max(abs(near[0]), abs(near[1]), abs(near[2]))
        over = 1.0 / largest if largest > 0.0 else 0.0
        axis = near[0] * over, near[1] * over, near[2] * over
        length = math.sqrt(dot_plain(axis, axis))
        turns = np.rint(largest * (length / (2.0 * PI)))
        angle = 2.0 * PI * turns
    else:
        # (x, y, z) in units of a power of 2 near its size, so that its square does not underflow.
        exponent = -math.frexp(size)[1]
        axis = math.ldexp(x[0], exponent), math.ldexp(y[0], exponent), math.ldexp(z[0], exponent)
        length = math.sqrt(dot_plain(axis, axis))
        short_of_pi = 2.0 * math.atan2(w[0], math.ldexp(length, -exponent))
        along = dot((near[0], near[1], near[2]), axis)[0] / length
        # Halfway between theta + 2 pi (k - 1) and theta + 2 pi k lies 2 pi k - (pi - theta).
        turns = np.floor((along + short_of_pi) / (2.0 * PI))
        odd = 2.0 * turns + 1.0
        angle = fma(PI, odd, fma(PI_LOW, odd, -short_of_pi))
    if turns == 0.0:
        write_vector(w, x, y, z, vector)
    else:
        factor = angle / length
        for i in range(3):
            vector[i] = factor * axis[i]


def log_near(rotation: ArrayLike, near: ArrayLike) -> Array:
    """Of all vectors whose exponential is the rotation nearest to the given matrix, the one nearest to ``near``.

    rotation (..., 3, 3) as in `log`, near (..., 3) in radians; gives (..., 3). The vectors are (theta + 2 pi k) n, with
    theta and n the principal angle and axis and k any integer; of two that are equally near, the shorter, and the
    principal one at angle pi. Without any rotation the axis is that of ``near``. Raises InputError as `log` does.
    """
    return _log_near(rotation, near)[0]
