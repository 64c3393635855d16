"""What so3 and se3 share: the coefficients of Rodrigues' formula, and the quaternion of the nearest rotation."""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._compensated import (
    Pair,
    Vector,
    dot,
    dot_plain,
    fma,
    quick_two_sum,
    quotient,
    square_root,
    two_sum,
)
from affinecert.fast._kernel import Array, compiled

Matrix = tuple[Vector, Vector, Vector]

NOT_ORTHOGONAL = "not a rotation: |R^T R - I| is above 1e-6 (Frobenius norm)"
REFLECTION = "not a rotation: its determinant is negative"

# Below this squared angle the terms of order angle^2 of cos and sin(x)/x are under 2^-54, half an ulp of 1.
TINY_SQUARE = 2.0**-54

# Above this angle, one ulp of it is above 2^-27, and the first-order correction for the rounding of the angle would be
# wrong by its square, 2^-54. No correction is due either: the condition number is as large as the angle.
LARGE_ANGLE = 2.0**26

# The limit on |R^T R - I|: of a rotation rounded to float32, nine entries wrong by 2^-25, it is at most 6 2^-25.
ORTHOGONALITY = 1e-6

# A quaternion's scalar part this small against its vector part is computed afresh, so that its sign is right.
NEARLY_PI = 2.0**-40

# pi is the sum of these two within 2^-106 of itself.
PI, PI_LOW = math.pi, 1.2246467991473532e-16

# Below this squared tangent of the half angle, r^4/5 of atan(r)/r = 1 - r^2/3 + r^4/5 - ... is under 2^-56.
SMALL_TANGENT_SQUARE = 2.0**-27


@compiled
def rodrigues(omega: Vector) -> tuple[Vector, float, Pair, Vector]:
    """The numbers (axis, length, square, (c, s, a)) in exp([omega]) = c I + s [axis] + a axis axis^T.

    The axis is omega itself, so that nothing is lost when it is tiny, and s = sin(angle) / angle and
    a = (1 - cos(angle)) / angle^2; beyond `LARGE_ANGLE` it is the unit vector, and s and a are sin and 1 - cos, so that
    nothing overflows. omega is ``length`` times the axis, and ``square`` is |axis|^2 as a pair. The coefficients are
    accurate relative to themselves, also where they vanish at multiples of 2 pi.
    """
    x, y, z = omega
    if max(abs(x), abs(y), abs(z)) > LARGE_ANGLE:
        # By 2^-520 the squares neither overflow nor underflow; by half of it back, nor does the half angle.
        x, y, z = x * 2.0**-520, y * 2.0**-520, z * 2.0**-520
        length = math.sqrt(x * x + y * y + z * z)
        half = length * 2.0**519
        sine = math.sin(half)
        a = 2.0 * sine * sine
        return (x / length, y / length, z / length), 2.0 * half, (1.0, 0.0), (1.0 - a, 2.0 * sine * math.cos(half), a)
    square, square_low = dot(omega, omega)
    if square < TINY_SQUARE:
        return omega, 1.0, (square, square_low), (1.0, 1.0, 0.5)
    angle, angle_low = square_root(square, square_low)
    sine, cosine = math.sin(angle), math.cos(angle)
    s, s_low = quotient(sine, angle_low * cosine, angle, angle_low)
    s += s_low
    c = fma(-angle_low, sine, cosine)
    # 1 - cos = sin^2 / (1 + cos) where the difference would cancel.
    a = s * s / (1.0 + c) if c > 0.5 else (1.0 - c) / square
    return omega, 1.0, (square, square_low), (c, s, a)


@compiled
def write_rotation(axis: Vector, coefficients: Vector, rotation: Array) -> None:
    """Rodrigues' formula, c I + s [axis] + a axis axis^T, written to the leading 3x3 block."""
    c, s, a = coefficients
    x, y, z = axis
    rotation[0, 0] = fma(a * x, x, c)
    rotation[1, 1] = fma(a * y, y, c)
    rotation[2, 2] = fma(a * z, z, c)
    rotation[0, 1] = fma(a * x, y, -s * z)
    rotation[1, 0] = fma(a * x, y, s * z)
    rotation[0, 2] = fma(a * x, z, s * y)
    rotation[2, 0] = fma(a * x, z, -s * y)
    rotation[1, 2] = fma(a * y, z, -s * x)
    rotation[2, 1] = fma(a * y, z, s * x)


@compiled
def entries(matrix: Array) -> Matrix:
    """The rows of the leading 3x3 block."""
    m = matrix
    return (m[0, 0], m[0, 1], m[0, 2]), (m[1, 0], m[1, 1], m[1, 2]), (m[2, 0], m[2, 1], m[2, 2])


@compiled
def defect(m: Matrix) -> tuple[float, float]:
    """The trace of M M^T - I, compensated, and its squared Frobenius norm; they are those of M^T M - I too."""
    (a, b, c), (d, e, f), (g, h, i) = m
    p, p_low = dot((a, b, c), (a, b, c))
    q, q_low = dot((d, e, f), (d, e, f))
    r, r_low = dot((g, h, i), (g, h, i))
    # Each of p, q, r is within 1e-6 of 1, or else the matrix is refused; so these differences are exact.
    p, q, r = p - 1.0, q - 1.0, r - 1.0
    x, y, z = a * d + b * e + c * f, a * g + b * h + c * i, d * g + e * h + f * i
    return (p + q + r) + (p_low + q_low + r_low), p * p + q * q + r * r + 2.0 * (x * x + y * y + z * z)


@compiled
def determinant(m: Matrix) -> float:
    """The determinant, for its sign only: that of a nearly orthogonal matrix is near 1 or near -1."""
    (a, b, c), (d, e, f), (g, h, i) = m
    return a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)


@compiled
def tangent_of_half(m: Matrix, total: Pair) -> tuple[Pair, Pair, Pair]:
    """The vector part over the scalar part of the quaternion of the rotation nearest to M, each entry a pair.

    ``total`` is lambda, the nuclear norm of M, a multiple of a rotation but for rounding. The quaternion (w, x) of the
    nearest rotation is the top eigenvector, to the eigenvalue lambda, of Davenport's matrix [[tr, z^T], [z, M + M^T -
    tr I]], where tr is the trace of M and z its skew part doubled (Davenport 1968). The lower rows say B p = z for
    p = x / w, where B = (lambda + tr) I - M - M^T. Solved in double, then once more for the compensated residual. For
    |w| >= 1/2, B is well-conditioned; and z is a single difference of entries, so that p keeps its relative accuracy
    near 0.
    """
    (m11, m12, m13), (m21, m22, m23), (m31, m32, m33) = m
    # z, the sums of opposite entries, and the diagonal of B, as pairs.
    z1, z1_low = two_sum(m32, -m23)
    z2, z2_low = two_sum(m13, -m31)
    z3, z3_low = two_sum(m21, -m12)
    s1, s1_low = two_sum(m32, m23)
    s2, s2_low = two_sum(m13, m31)
    s3, s3_low = two_sum(m21, m12)
    b1, b1_low = diagonal(m22, m33, m11, total)
    b2, b2_low = diagonal(m33, m11, m22, total)
    b3, b3_low = diagonal(m11, m22, m33, total)
    # The inverse of B = [[b1, -s3, -s2], [-s3, b2, -s1], [-s2, -s1, b3]], by cofactors.
    c11, c22, c33 = b2 * b3 - s1 * s1, b1 * b3 - s2 * s2, b1 * b2 - s3 * s3
    c12, c13, c23 = s1 * s2 + s3 * b3, s1 * s3 + s2 * b2, s2 * s3 + s1 * b1
    over = 1.0 / (b1 * c11 - s3 * c12 - s2 * c13)
    p1 = (c11 * z1 + c12 * z2 + c13 * z3) * over
    p2 = (c12 * z1 + c22 * z2 + c23 * z3) * over
    p3 = (c13 * z1 + c23 * z2 + c33 * z3) * over
    r1 = residual(z1, z1_low, (-b1, s3, s2), (-b1_low, s3_low, s2_low), (p1, p2, p3))
    r2 = residual(z2, z2_low, (s3, -b2, s1), (s3_low, -b2_low, s1_low), (p1, p2, p3))
    r3 = residual(z3, z3_low, (s2, s1, -b3), (s2_low, s1_low, -b3_low), (p1, p2, p3))
    return (
        quick_two_sum(p1, (c11 * r1 + c12 * r2 + c13 * r3) * over),
        quick_two_sum(p2, (c12 * r1 + c22 * r2 + c23 * r3) * over),
        quick_two_sum(p3, (c13 * r1 + c23 * r2 + c33 * r3) * over),
    )


@compiled
def diagonal(added: float, too: float, less: float, total: Pair) -> Pair:
    """The sum total + added + too - less, as a pair."""
    first, first_low = two_sum(added, too)
    second, second_low = two_sum(first, -less)
    third, third_low = two_sum(total[0], second)
    return quick_two_sum(third, third_low + second_low + first_low + total[1])


@compiled
def residual(z: float, z_low: float, row: Vector, row_low: Vector, p: Vector) -> float:
    """The sum z + row . p of pairs, which all but vanishes."""
    product, product_low = dot(row, p)
    low = fma(row_low[0], p[0], fma(row_low[1], p[1], row_low[2] * p[2]))
    return (z + product) + (product_low + z_low + low)


@compiled
def nearest_quaternion(m: Matrix) -> tuple[int, Pair, Pair, Pair, Pair]:
    """A status, and the quaternion (w, x, y, z), w >= 0, along the rotation nearest to M, as `quaternion_along` has it.

    The status is 1 where M is not orthogonal enough, 2 where it is a reflection.
    """
    trace_excess, distance = defect(m)
    nothing = (0.0, 0.0)
    if not distance <= ORTHOGONALITY * ORTHOGONALITY:
        return 1, nothing, nothing, nothing, nothing
    if determinant(m) < 0.0:
        return 2, nothing, nothing, nothing, nothing
    # The nuclear norm, sum of sqrt(1 + e) over the eigenvalues e of M^T M - I; the next term is under 1e-18 / 16.
    excess = 0.5 * trace_excess - 0.125 * distance
    w, x, y, z = quaternion_along(m, (3.0, excess))
    return 0, w, x, y, z


@compiled
def quaternion_along(m: Matrix, total: Pair) -> tuple[Pair, Pair, Pair, Pair]:
    """The quaternion (w, x, y, z), w >= 0, along the rotation nearest to M, whose nuclear norm is ``total``.

    It is not normalised; M is a multiple of a rotation but for rounding, and of size 1. At angle pi exactly (w = 0) the
    first entry of (x, y, z) that is not 0 is positive.
    """
    (m11, m12, m13), (m21, m22, m23), (m31, m32, m33) = m
    # The largest of 4 w^2, 4 x^2, 4 y^2, 4 z^2 is 1 more than the largest of these traces. To make its root the scalar
    # part, turn by pi about that axis first, that is, change the sign of two columns.
    t0, t1, t2, t3 = m11 + m22 + m33, m11 - m22 - m33, m22 - m11 - m33, m33 - m11 - m22
    pivot, largest = 0, t0
    for k, trace in ((1, t1), (2, t2), (3, t3)):
        if trace > largest:
            pivot, largest = k, trace
    f = 1.0 if pivot in (0, 1) else -1.0
    g = 1.0 if pivot in (0, 2) else -1.0
    h = f * g
    turned = (f * m11, g * m12, h * m13), (f * m21, g * m22, h * m23), (f * m31, g * m32, h * m33)
    p, q, r = tangent_of_half(turned, total)
    if pivot == 0:
        return (1.0, 0.0), p, q, r
    if pivot == 1:
        w, x, y, z = negative(p), (1.0, 0.0), r, negative(q)
    elif pivot == 2:
        w, x, y, z = negative(q), negative(r), (1.0, 0.0), p
    else:
        w, x, y, z = negative(r), q, negative(p), (1.0, 0.0)
    sign = w[0]
    if abs(sign) < NEARLY_PI:
        # The first row of the eigenvalue equation, w (lambda - tr) = z . x, gives the sign of a w of any size: the
        # entries of z are single differences. By 2^512 no product underflows.
        skew = (
            2.0**512 * (m32 - m23),
            2.0**512 * (m13 - m31),
            2.0**512 * (m21 - m12),
        )
        sign = dot(skew, (x[0], y[0], z[0]))[0]
        w = (sign * 2.0**-512 / (total[0] - t0), 0.0)
        if sign == 0.0:
            sign = x[0] if x[0] != 0.0 else y[0] if y[0] != 0.0 else z[0]
    if sign < 0.0:
        return negative(w), negative(x), negative(y), negative(z)
    return w, x, y, z


@compiled
def negative(pair: Pair) -> Pair:
    """The pair with its sign changed."""
    return -pair[0], -pair[1]


@compiled
def angle_over_sine(w: Pair, x: Pair, y: Pair, z: Pair) -> tuple[Pair, Pair]:
    """F = (theta/2) / |q| and |q|^2 for the quaternion (w, q), as pairs.

    It lies along a rotation of angle theta in [0, pi]: w >= 0, and w = 1 where q = (x, y, z) is small.
    """
    vector = (x[0], y[0], z[0])
    s, s_low = dot(vector, vector)
    s_low += 2.0 * (x[0] * x[1] + y[0] * y[1] + z[0] * z[1])
    if s < SMALL_TANGENT_SQUARE:
        # atan(r)/r = 1 - r^2/3 + r^4/5.
        return quick_two_sum(1.0, -s / 3.0), (s, s_low)
    root, root_low = square_root(s, s_low)
    half = math.atan2(root, w[0])
    half_low = (w[0] * root_low - root * w[1]) / fma(w[0], w[0], s)
    return quotient(half, half_low, root, root_low), (s, s_low)


@compiled
def nearest_turns(
    w: float, vector: Vector, near: Vector, least: float, most: float
) -> tuple[Vector, float, float, float]:
    """Of the rotation vectors of the quaternion (w, vector), w >= 0, the one nearest to ``near``.

    Told as (axis, length, angle, turns): it is the axis times angle over length, and from ``least`` to ``most`` whole
    turns away from the principal one, whose angle is not told. Where there is no rotation the axis is that of ``near``.
    """
    x, y, z = vector
    size = max(abs(x), abs(y), abs(z))
    if size == 0.0:
        # No rotation at all: whole turns about any axis, so about that of ``near``.
        largest = max(abs(near[0]), abs(near[1]), abs(near[2]))
        over = 1.0 / largest if largest > 0.0 else 0.0
        axis = near[0] * over, near[1] * over, near[2] * over
        length = math.sqrt(dot_plain(axis, axis))
        turns = min(max(np.rint(largest * (length / (2.0 * PI))), least), most)
        return axis, length, 2.0 * PI * turns, turns
    # In units of a power of 2 near its size, so that its square does not underflow.
    exponent = -math.frexp(size)[1]
    axis = math.ldexp(x, exponent), math.ldexp(y, exponent), math.ldexp(z, exponent)
    length = math.sqrt(dot_plain(axis, axis))
    if least == most == 0.0:
        return axis, length, 0.0, 0.0
    short_of_pi = 2.0 * math.atan2(w, math.ldexp(length, -exponent))
    along = dot(near, axis)[0] / length
    # Halfway between theta + 2 pi (k - 1) and theta + 2 pi k lies 2 pi k - (pi - theta).
    turns = min(max(np.floor((along + short_of_pi) / (2.0 * PI)), least), most)
    odd = 2.0 * turns + 1.0
    return axis, length, fma(PI, odd, fma(PI_LOW, odd, -short_of_pi)), turns
