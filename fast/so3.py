"""Rotations of space: exponential and logarithms.

The rotation vector omega stands for the rotation by |omega| radians about it; [omega] is the matrix of the vector
product with it.
"""

from __future__ import annotations

import math

from numpy.typing import ArrayLike

from affinecert.fast._compensated import Pair, fma
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._rotation import (
    NOT_ORTHOGONAL,
    REFLECTION,
    angle_over_sine,
    entries,
    nearest_quaternion,
    nearest_turns,
    rodrigues,
    write_rotation,
)

REFUSALS = (("rotation", NOT_ORTHOGONAL), ("rotation", REFLECTION))


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

    >>> from math import pi
    >>> exp([0.0, 0.0, pi / 2]).round(15) + 0.0
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

    >>> log([[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]) + 0.0  # at pi: first component positive
    array([0.        , 0.        , 3.14159265])
    """
    return _log(rotation)[0]


@kernel(inputs={"rotation": (3, 3), "near": (3,)}, outputs=((3,),), refusals=REFUSALS)
def _log_near(rotation: Array, near: Array, vector: Array, status: Array) -> None:
    status[0], w, x, y, z = nearest_quaternion(entries(rotation))
    goal = near[0], near[1], near[2]
    axis, length, angle, turns = nearest_turns(w[0], (x[0], y[0], z[0]), goal, -math.inf, math.inf)
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
