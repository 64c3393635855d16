"""What the maps of SIM(3) share: the coefficients of V and of its inverse, and the scale and the turn of a similarity.

V is the sum of Gamma^k / (k + 1)!, Gamma = lambda I + [omega], lambda the growth and theta = |omega|. With
phi(z) = (e^z - 1) / z, it is phi(lambda) on the axis, and on the plane across the complex number phi(z), z = lambda + i
theta. As [n]^2 = n n^T - I for the unit axis n,

    V = Re phi(z) I + Im phi(z) [n] + (phi(lambda) - Re phi(z)) n n^T,

and its inverse is the same of 1/phi. Where |z| is small these are small differences of e^z, 1 and each other; so for
|z| <= 1 they come from the series of phi. A polynomial P divided by x^2 - 2 lambda x + |z|^2, whose roots are z and its
conjugate, leaves the rest s x + c with P(z) = s z + c, and (P(lambda) - Re P(z)) / theta^2 is the quotient at lambda.
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from affinecert.fast._compensated import (
    Pair,
    Vector,
    cross,
    dot_plain,
    fma,
    quick_two_sum,
    two_product,
    two_sum,
)
from affinecert.fast._kernel import compiled
from affinecert.fast._rotation import ORTHOGONALITY, Matrix, quaternion_along

Series = tuple[float, ...]
"""The coefficients of a polynomial, from that of x^0 on."""

# phi, cut after z^20: for |z| <= 1 the rest of its second divided difference is below 2^-59 of that.
PHI: Series = tuple(1.0 / math.factorial(k + 1) for k in range(21))


def _bernoulli(count: int) -> list[Fraction]:
    """The coefficients B_k / k! of z / (e^z - 1), k < count."""
    coefficients: list[Fraction] = []
    for k in range(count):
        rest = sum(c / math.factorial(k + 1 - j) for j, c in enumerate(coefficients))
        coefficients.append(Fraction(k == 0) - rest)
    return coefficients


# z / (e^z - 1) + z / 2 as a series in z^2, cut after z^24: the coefficients are below 2 (2 pi)^-k, so that for |z| <= 1
# the rest of its second divided difference is below 2^-56 of that.
INVERSE_PHI: Series = tuple(float(c) for c in _bernoulli(26)[::2])

# Beyond it 1 / lambda is all of V, for any angle up to `LARGE_ANGLE`, and the square of lambda may overflow.
HUGE_GROWTH = 2.0**500

# Below it squares underflow, or lose bits.
TINY = 2.0**-450

LN2 = math.log(2.0)


@compiled
def remainder(polynomial: Series, trace: float, norm: float, at: float) -> Vector:
    """The s, c and Q(at) in P(x) = (x^2 - trace x + norm) Q(x) + s x + c, for a polynomial P."""
    slope, older, quotient = 0.0, 0.0, 0.0
    for k in range(len(polynomial) - 1, 0, -1):
        quotient = fma(quotient, at, slope)
        slope, older = fma(trace, slope, fma(-norm, older, polynomial[k])), slope
    return slope, fma(-norm, older, polynomial[0]), quotient


@compiled
def shares(growth: float, angle: float) -> tuple[float, float]:
    """The quotients lambda / |z|^2 and theta / |z|^2, without overflow; z is not 0."""
    if abs(growth) > angle:
        ratio = angle / growth
        share = 1.0 / fma(ratio, angle, growth)
        return share, share * ratio
    ratio = growth / angle
    share = 1.0 / fma(ratio, growth, angle)
    return share * ratio, share


@compiled
def coefficients(growth: float, length: float, square: float, turn: Vector) -> tuple[bool, Vector]:
    """The p, q and r of V = p I + q [a] + r a a^T, for the axis a, length and turn (c, s, versine) of `rodrigues`.

    They are to be multiplied by e^lambda if the answer says true.
    """
    _, s, versine = turn
    if length == 1.0 and abs(growth) > HUGE_GROWTH:
        return growth > 0.0, (1.0 / abs(growth), 0.0, 0.0)
    size = fma(growth, growth, square)
    if length == 1.0 and size <= 1.0:
        slope, constant, quotient = remainder(PHI, 2.0 * growth, size, growth)
        return False, (fma(growth, slope, constant), slope, quotient)
    grows = growth > 0.0
    # e^lambda and e^lambda - 1, or 1 and 1 - e^-lambda.
    less = math.expm1(-abs(growth))
    factor, rise = (1.0, -less) if grows else (1.0 + less, less)
    along = -less / abs(growth) if growth != 0.0 else 1.0
    if length == 1.0:
        # The real part of e^z - 1, and its imaginary part over theta.
        real, imaginary = fma(-factor * square, versine, rise), factor * s
        return grows, (
            fma(growth, real, square * imaginary) / size,
            fma(growth, imaginary, -real) / size,
            fma(factor, fma(growth, versine, -s), along) / size,
        )
    real, imaginary = fma(-factor, versine, rise), factor * s
    first, second = shares(growth, length)
    p = fma(first, real, second * imaginary)
    return grows, (p, fma(first, imaginary, -second * real), along - p)


@compiled
def image(axis: Vector, p: float, q: float, r: float, v: Vector) -> Vector:
    """The vector p v + q a x v + r (a . v) a for the axis a."""
    turned, part = cross(axis, v), r * dot_plain(axis, v)
    return (
        fma(p, v[0], fma(part, axis[0], q * turned[0])),
        fma(p, v[1], fma(part, axis[1], q * turned[1])),
        fma(p, v[2], fma(part, axis[2], q * turned[2])),
    )


@compiled
def inverse_coefficients(growth: float, excess: float, angle: float, sine: float, versine: float) -> Vector:
    """The p, q and r of V^-1 = p I + q [n] + r n n^T for the unit axis n.

    ``excess`` is e^lambda - 1; sine and versine, 1 - cos, are those of the angle. The series is one in z^2, which is
    lambda^2 - theta^2 + 2 i lambda theta, and lambda^2 on the axis.
    """
    square, other = growth * growth, angle * angle
    if square + other <= 1.0:
        difference, norm = square - other, square + other
        slope, constant, quotient = remainder(INVERSE_PHI, 2.0 * difference, norm * norm, square)
        return (
            fma(-0.5, growth, fma(difference, slope, constant)),
            angle * fma(2.0 * growth, slope, -0.5),
            other * fma(fma(4.0, square, other), quotient, slope),
        )
    # e^z - 1 = real + i imaginary, over e^lambda where that is above 1.
    scale = 1.0 + excess
    factor, over = (1.0, 1.0 / scale) if growth > 0.0 else (scale, 1.0)
    rise = excess * over
    real, imaginary = fma(-factor, versine, rise), factor * sine
    if max(abs(real), abs(imaginary)) < TINY:
        real, imaginary, over = real / TINY, imaginary / TINY, over / TINY
    size = fma(real, real, imaginary * imaginary)
    p = fma(growth, real, angle * imaginary) / size * over
    q = fma(angle, real, -growth * imaginary) / size * over
    along = growth / excess if excess != 0.0 else 1.0
    return p, q, along - p


@compiled
def minor(a: float, b: float, c: float, d: float) -> Pair:
    """The difference a d - b c, as a pair."""
    first, first_low = two_product(a, d)
    second, second_low = two_product(b, c)
    high, low = two_sum(first, -second)
    return quick_two_sum(high, low + (first_low - second_low))


@compiled
def determinant(m: Matrix) -> Pair:
    """The determinant of a matrix, as a pair."""
    (a, b, c), (d, e, f), (g, h, i) = m
    total, total_low = 0.0, 0.0
    for x, (y, y_low) in ((a, minor(e, f, h, i)), (b, minor(f, d, i, g)), (c, minor(d, e, g, h))):
        high, low = two_product(x, y)
        total, rest = two_sum(total, high)
        total_low += rest + fma(x, y_low, low)
    return quick_two_sum(total, total_low)


@compiled
def cube_root(high: float, low: float) -> Pair:
    """The cube root of a positive pair, as a pair: one Newton step with the exact residual."""
    root = np.cbrt(high)
    square, square_low = two_product(root, root)
    cube, cube_low = two_product(square, root)
    rest = (high - cube) + (low - fma(square_low, root, cube_low))
    return quick_two_sum(root, rest / (3.0 * square))


@compiled
def growth_of(volume: float, volume_low: float, scale: float, exponent: int) -> tuple[float, float]:
    """Lambda and e^lambda - 1 for e^lambda the scale times 2^exponent; the volume is its cube over 2^(3 exponent).

    Both keep their relative accuracy where the scale is next to 1, and vanish if the volume is 1.
    """
    whole = math.ldexp(scale, exponent)
    if 0.5 < whole < 2.0:
        rest = (math.ldexp(volume, 3 * exponent) - 1.0) + math.ldexp(volume_low, 3 * exponent)
        excess = rest / fma(whole, whole, whole + 1.0)
        return math.log1p(excess), excess
    return fma(float(exponent), LN2, math.log(scale)), whole - 1.0


@compiled
def similarity(m: Matrix) -> tuple[int, Pair, Pair, Pair, Pair, float, float]:
    """A status, the quaternion of a similarity's turn as `quaternion_along` has it, lambda and e^lambda - 1.

    The scale e^lambda is the cube root of the determinant. The status is 1 where that is not positive, and 2 where M is
    no multiple of a rotation.
    """
    size = 0.0
    for row in m:
        size = max(size, abs(row[0]), abs(row[1]), abs(row[2]))
    exponent = math.frexp(size)[1]
    # By two factors, since that power of two may be beyond float64.
    half = exponent // 2
    f, g = math.ldexp(1.0, -half), math.ldexp(1.0, half - exponent)
    (m11, m12, m13), (m21, m22, m23), (m31, m32, m33) = m
    unit = (
        (m11 * f * g, m12 * f * g, m13 * f * g),
        (m21 * f * g, m22 * f * g, m23 * f * g),
        (m31 * f * g, m32 * f * g, m33 * f * g),
    )
    nothing = (0.0, 0.0)
    volume, volume_low = determinant(unit)
    if not volume > 0.0:
        return 1, nothing, nothing, nothing, nothing, 0.0, 0.0
    scale, scale_low = cube_root(volume, volume_low)
    first, second, third = unit
    over = 1.0 / (scale * scale)
    p = fma(over, dot_plain(first, first), -1.0)
    q = fma(over, dot_plain(second, second), -1.0)
    r = fma(over, dot_plain(third, third), -1.0)
    x, y, z = over * dot_plain(first, second), over * dot_plain(first, third), over * dot_plain(second, third)
    distance = p * p + q * q + r * r + 2.0 * (x * x + y * y + z * z)
    if not distance <= ORTHOGONALITY * ORTHOGONALITY:
        return 2, nothing, nothing, nothing, nothing, 0.0, 0.0
    # The nuclear norm over the scale is the sum of sqrt(1 + e), e the eigenvalues of M M^T / scale^2 - I, of which the
    # product of 1 + e is 1: it is 3 + sum e^2 / 8 up to the sum of |e|^3, 1e-18.
    total, total_low = two_product(3.0, scale)
    total_low += fma(3.0, scale_low, 0.125 * distance * scale)
    scalar, i, j, k = quaternion_along(unit, quick_two_sum(total, total_low))
    growth, excess = growth_of(volume, volume_low, scale, exponent)
    return 0, scalar, i, j, k, growth, excess
