"""Rigid motions of space: exponential and logarithm.

A twist is (omega, v), the rotation vector first; [omega] is the matrix of the vector product with omega.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from affinecert.fast._compensated import Pair, Vector, cross, dot, dot_plain, fma, quotient, two_product, two_sum
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

# Below this squared angle the part of v along the axis needs no telling apart, and is not divided out.
NEGLIGIBLE = 2.0**-54


@compiled
def translate(axis: Vector, length: float, square: Pair, coefficients: Vector, v: Vector) -> Vector:
    """The translation V v of exp([[[omega], v], [0, 0]]), from the numbers that `rodrigues` gives.

    V v = s v + (1 - s) (n . v) n + a omega x v, n = omega / angle. No term cancels another: the part along n comes
    from s and 1 - s, whose errors do cancel, and the parts across are at right angles, with coefficients that keep
    their relative accuracy where they vanish, at angle 2 pi. With an axis other than omega, of ``length`` radians, s
    and a are divided by that length.
    """
    _, s, a = coefficients
    s, a = s / length, a / length
    turned = cross(axis, v)
    along, along_low = dot(axis, v)
    if square[0] > NEGLIGIBLE:
        along, along_low = quotient(along, along_low, square[0], square[1])
    rest, rest_low = two_sum(1.0, -s)
    part, part_low = two_product(rest, along)
    part_low += rest * along_low + rest_low * along
    return (
        fma(s, v[0], fma(part, axis[0], fma(a, turned[0], part_low * axis[0]))),
        fma(s, v[1], fma(part, axis[1], fma(a, turned[1], part_low * axis[1]))),
        fma(s, v[2], fma(part, axis[2], fma(a, turned[2], part_low * axis[2]))),
    )


@kernel(inputs={"twist": (6,)}, outputs=((4, 4),))
def _exp(twist: Array, pose: Array, _status: Array) -> None:
    axis, length, square, coefficients = rodrigues((twist[0], twist[1], twist[2]))
    translation = translate(axis, length, square, coefficients, (twist[3], twist[4], twist[5]))
    write_rotation(axis, coefficients, pose)
    pose[0, 3], pose[1, 3], pose[2, 3] = translation
    pose[3, 0] = pose[3, 1] = pose[3, 2] = 0.0
    pose[3, 3] = 1.0


def exp(twist: ArrayLike) -> Array:
    """The rigid motion of a twist (omega, v): the exponential of [[[omega], v], [0, 0]].

    twist (..., 6), omega in radians and of any length; gives (..., 4, 4), whose rotation is `so3.exp` of omega and
    whose translation is V v, V the sum of [omega]^k / (k + 1)!. Raises InputError for a wrong shape or dtype and for
    numbers that are not finite. Bansal and Tatu, section 3.1.

    >>> from math import pi
    >>> exp([0.0, 0.0, pi, 0.0, pi / 2, 0.0])[:3, 3].round(15) + 0.0  # half a turn about (-1/2, 0, 0)
    array([-1.,  0.,  0.])
    """
    return _exp(twist)[0]


@kernel(
    inputs={"pose": (4, 4)},
    outputs=((6,),),
    refusals=(("pose", NOT_ORTHOGONAL), ("pose", REFLECTION), ("pose", "last row is not (0, 0, 0, 1)")),
)
def _log(pose: Array, twist: Array, status: Array) -> None:
    if pose[3, 0] != 0.0 or pose[3, 1] != 0.0 or pose[3, 2] != 0.0 or pose[3, 3] != 1.0:
        status[0] = 3
        return
    status[0], w, x, y, z = nearest_quaternion(entries(pose))
    (factor, factor_low), (square, square_low) = angle_over_sine(w, x, y, z)
    # With q = (x, y, z), angle theta and F = (theta/2) / |q|: omega = 2 F q, and as (theta/2) cot(theta/2) = F w,
    # V^-1 t = F (w t - q x t) + (1 - F w) (q . t) q / |q|^2.
    t = pose[0, 3], pose[1, 3], pose[2, 3]
    rows = (
        ((w[0], z[0], -y[0]), (w[1], z[1], -y[1])),
        ((-z[0], w[0], x[0]), (-z[1], w[1], x[1])),
        ((y[0], -x[0], w[0]), (y[1], -x[1], w[1])),
    )
    q, q_low = (x[0], y[0], z[0]), (x[1], y[1], z[1])
    along, along_low = dot(q, t)
    along_low += dot_plain(q_low, t)
    if square > NEGLIGIBLE:
        along, along_low = quotient(along, along_low, square, square_low)
    rest = fma(-factor, w[0], 1.0) - fma(factor, w[1], factor_low * w[0])
    part, part_low = two_product(rest, along)
    part_low += rest * along_low
    for i in range(3):
        twist[i] = 2.0 * fma(factor, q[i], fma(factor, q_low[i], factor_low * q[i]))
        row, row_low = rows[i]
        high, low = dot(row, t)
        low = fma(factor, low + dot_plain(row_low, t), fma(factor_low, high, fma(part_low, q[i], part * q_low[i])))
        twist[3 + i] = fma(factor, high, fma(part, q[i], low))


def log(pose: ArrayLike) -> Array:
    """The twist (omega, v) of a rigid motion, omega being the principal logarithm of its rotation.

    pose (..., 4, 4) with last row (0, 0, 0, 1) and a rotation within 1e-6; gives (..., 6). omega is `so3.log` of the
    rotation part, with its conventions; v solves V v = translation, V as in `exp`, and the translation is taken as it
    stands. Raises InputError for a wrong shape or dtype, numbers that are not finite, another last row, and a part that
    is not a rotation. Bansal and Tatu, section 3.1.
    """
    return _log(pose)[0]
