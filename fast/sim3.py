"""Similarities of space: exponential, logarithms by two strategies, and the condition of V.

A tangent is (omega, v, lambda), the rotation vector first; it stands for the matrix [[Gamma, v], [0, 0]], Gamma =
lambda I + [omega], [omega] the matrix of the vector product with omega.

Source: Gallier, Allen-Blanchette, Leonardos, "Motion interpolation in SIM(3)", sections 2 to 5.
"""

from __future__ import annotations

import math
import sys

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast._compensated import dot, dot_plain, fma, square_root
from affinecert.fast._kernel import Array, checked, kernel
from affinecert.fast._rotation import LARGE_ANGLE, entries, nearest_turns, rodrigues, write_rotation
from affinecert.fast._similarity import PHI, coefficients, image, inverse_coefficients, remainder, similarity
from affinecert.fast.so3 import write_vector

NOT_POSITIVE = "not a similarity: the determinant is not positive"
NOT_SIMILAR = "not a similarity: |L^T L - I| is above 1e-6 (Frobenius norm), for L of determinant 1"
LAST_ROW = "last row is not (0, 0, 0, 1)"
SINGULAR = "V is singular: whole turns of a pose that neither turns nor grows"

# Up to this e^lambda is 1 and something smaller.
SMALL_GROWTH = 0.5

# exp of half of this is still far from overflow.
LARGE_GROWTH = 700.0

# More turns than there are.
ANY = sys.float_info.max

NO_TANGENT = np.zeros(7)


@kernel(inputs={"tangent": (7,)}, outputs=((4, 4),))
def _exp(tangent: Array, pose: Array, _status: Array) -> None:
    growth = tangent[6]
    axis, length, square, turn = rodrigues((tangent[0], tangent[1], tangent[2]))
    grows, (p, q, r) = coefficients(growth, length, square[0], turn)
    # e^lambda, or its square root, to be applied twice, where it may overflow.
    small, large = abs(growth) < SMALL_GROWTH, abs(growth) > LARGE_GROWTH
    rise = math.expm1(growth) if small else 0.0
    factor = 1.0 + rise if small else math.exp(0.5 * growth if large else growth)
    c, s, a = turn
    write_rotation(axis, (factor * c, factor * s, factor * a), pose)
    if small and length == 1.0:
        # As 1 and what is little beside it the diagonal is rounded but once.
        for i in range(3):
            j, k = axis[(i + 1) % 3], axis[(i + 2) % 3]
            pose[i, i] = 1.0 + fma(-factor * a, fma(j, j, k * k), rise)
    translation = image(axis, p, q, r, (tangent[3], tangent[4], tangent[5]))
    for i in range(3):
        pose[i, 3] = translation[i] * factor if grows else translation[i]
        if large:
            for j in range(4 if grows else 3):
                pose[i, j] *= factor
    pose[3, 0] = pose[3, 1] = pose[3, 2] = 0.0
    pose[3, 3] = 1.0


def exp(tangent: ArrayLike) -> Array:
    """The similarity of a tangent (omega, v, lambda): the exponential of [[Gamma, v], [0, 0]].

    tangent (..., 7), omega in radians and of any length; gives (..., 4, 4), whose linear part is e^lambda times the
    `so3.exp` of omega and whose translation is V v, V the sum of Gamma^k / (k + 1)!. Raises InputError for a wrong
    shape or dtype and for numbers that are not finite. Propositions 2.1 and 2.2.

    >>> from math import log, pi
    >>> exp([0.0, 0.0, pi / 2, 0.0, 0.0, log(2.0), log(2.0)]).round(15) + 0.0  # a quarter turn, twice as large
    array([[ 0., -2.,  0.,  0.],
           [ 2.,  0.,  0.,  0.],
           [ 0.,  0.,  2.,  1.],
           [ 0.,  0.,  0.,  1.]])
    """
    return _exp(tangent)[0]


@kernel(
    inputs={"pose": (4, 4), "near": (7,), "least": (), "most": ()},
    outputs=((7,),),
    refusals=(("pose", NOT_POSITIVE), ("pose", NOT_SIMILAR), ("pose", LAST_ROW), ("near", SINGULAR)),
)
def _logarithm(pose: Array, near: Array, least: float, most: float, tangent: Array, status: Array) -> None:
    """The tangent whose rotation vector is nearest to another's, at least and at most that many turns off principal."""
    if pose[3, 0] != 0.0 or pose[3, 1] != 0.0 or pose[3, 2] != 0.0 or pose[3, 3] != 1.0:
        status[0] = 3
        return
    status[0], w, x, y, z, growth, excess = similarity(entries(pose))
    if status[0] != 0:
        return
    vector, goal = (x[0], y[0], z[0]), (near[0], near[1], near[2])
    axis, length, angle, turns = nearest_turns(w[0], vector, goal, least, most)
    over = 1.0 / length if length > 0.0 else 0.0
    axis = axis[0] * over, axis[1] * over, axis[2] * over
    # Of the quaternion, not normalised, the length of the vector part.
    part = dot_plain(axis, vector)
    square = fma(w[0], w[0], part * part)
    if turns == 0.0:
        write_vector(w, x, y, z, tangent)
        angle = dot_plain(axis, (tangent[0], tangent[1], tangent[2]))
    else:
        tangent[0], tangent[1], tangent[2] = angle * axis[0], angle * axis[1], angle * axis[2]
        if excess == 0.0 and part == 0.0:
            status[0] = 4
    p, q, r = inverse_coefficients(growth, excess, angle, 2.0 * w[0] * part / square, 2.0 * part * part / square)
    tangent[3], tangent[4], tangent[5] = image(axis, p, q, r, (pose[0, 3], pose[1, 3], pose[2, 3]))
    tangent[6] = growth


def log(pose: ArrayLike) -> Array:
    """The principal tangent (omega, v, lambda) of a similarity.

    pose (..., 4, 4) with last row (0, 0, 0, 1) and a linear part that, divided by the cube root of its determinant, is
    a rotation within 1e-6; gives (..., 7). lambda is the logarithm of that cube root, omega the `so3.log` of the
    nearest rotation, and v solves V v = translation, V as in `exp`: it exists for every similarity (Theorem 3.2).
    Raises InputError for a wrong shape or dtype, numbers that are not finite, another last row, and a part that is not
    a similarity.
    """
    return _logarithm(pose, NO_TANGENT, 0.0, 0.0)[0]


def log_next(pose: ArrayLike, previous: ArrayLike) -> Array:
    """The tangent of a similarity next to a previous one: strategy 1 of section 5.

    pose (..., 4, 4) as in `log`, previous (..., 7); gives (..., 7), whose rotation vector is the principal one w or
    -(2 pi - |w|) w / |w|, whichever is nearer to that of ``previous``: w in a tie, and 0 where there is no rotation.
    Raises InputError as `log` does.
    """
    (matrix, goal), _, _ = checked({"pose": (4, 4), "previous": (7,)}, (pose, previous))
    return _logarithm(matrix, goal, -1.0, 0.0)[0]


def log_near(pose: ArrayLike, near: ArrayLike) -> Array:
    """The tangent of a similarity near another one: strategy 2 of section 5.

    pose (..., 4, 4) as in `log`, near (..., 7); gives (..., 7), whose rotation vector is the `so3.log_near` of the
    rotation and that of ``near``. Raises InputError as `log` does, and where this asks for whole turns of a pose that
    neither turns nor grows: V is singular then (Proposition 3.1).
    """
    (matrix, goal), _, _ = checked({"pose": (4, 4), "near": (7,)}, (pose, near))
    return _logarithm(matrix, goal, -ANY, ANY)[0]


@kernel(inputs={"tangent": (7,)}, outputs=((),))
def _condition(tangent: Array, ratio: Array, _status: Array) -> None:
    x, y, z, growth = tangent[0], tangent[1], tangent[2], abs(tangent[6])
    largest = max(abs(x), abs(y), abs(z))
    exponent = math.frexp(largest)[1]
    omega = math.ldexp(x, -exponent), math.ldexp(y, -exponent), math.ldexp(z, -exponent)
    length, length_low = square_root(*dot(omega, omega)) if largest > 0.0 else (0.0, 0.0)
    half, low = math.ldexp(length, exponent - 1), math.ldexp(length_low, exponent - 1)
    angle = 2.0 * half
    # What keeps it from being 1 is the part of the angle by which 2 sin(theta / 2) (lambda / 2) / sinh(lambda / 2) is
    # shorter.
    if half < 1.0 and growth < 2.0:
        shorter = half * half * remainder(PHI, 0.0, half * half, 0.0)[2]
        square = 0.25 * growth * growth
        rise = square * remainder(PHI, 0.0, -square, 0.0)[2]
        shorter += rise / (1.0 + rise) * (1.0 - shorter)
        size = math.hypot(growth, angle * (1.0 - shorter))
        share = angle / size if size > 0.0 else 0.0
        ratio[0] = math.sqrt(1.0 + share * share * shorter * (2.0 - shorter))
        return
    chord = 2.0 * (fma(low, math.cos(half), math.sin(half)) if half < LARGE_ANGLE else math.sin(half))
    if growth > 0.0:
        chord *= math.exp(-0.5 * growth) * growth / -math.expm1(-growth)
    ratio[0] = math.hypot(growth, angle) / math.hypot(growth, chord)


def condition(tangent: ArrayLike) -> Array:
    """The condition number of V in the 2-norm.

    tangent (..., 7), (omega, v, lambda) of any length; gives (...): |z| / |lambda + 2 i sin(theta / 2) c| for z =
    lambda + i theta and c = (lambda / 2) / sinh(lambda / 2). It would be infinite for lambda = 0 and whole turns, which
    no float64 are (Proposition 3.1). Raises InputError for a wrong shape or dtype and numbers that are not finite.
    """
    return _condition(tangent)[0]
