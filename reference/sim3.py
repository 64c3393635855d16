"""SIM(3): similarities of space and their tangents (omega, v, lambda).

The tangent stands for the matrix [[Gamma, v], [0, 0]], Gamma = lambda I + [omega]x; e^lambda is the scale. Source:
Gallier, Allen-Blanchette, Leonardos, Motion interpolation in SIM(3), sections 2 to 5.
"""

from __future__ import annotations

import numpy as np

from affinecert.errors import InputError
from affinecert.reference import _domain, so3
from affinecert.reference._matrices import Array, Context, Number, cross, dot, homogeneous, norm, scalar
from affinecert.reference._precision import magnitude, negligible, span

# The series of V is summed for a Gamma of norm below 2**-REDUCED, where each term adds that many bits and more.
_REDUCED = 8


def exp(ctx: Context, tangent: Array) -> Array:
    """The similarity exp [[Gamma, v], [0, 0]] of a tangent (omega, v, lambda), (7,) -> (4, 4).

    Propositions 2.1 and 2.2: the linear part is e^lambda e^[omega]x, the translation V v, V the sum of
    Gamma^k / (k + 1)!. A Gamma that grows is turned around, V(Gamma) = e^Gamma V(-Gamma), so that V stays bounded.
    """
    _domain.finite(ctx, "tangent", tangent)
    omega, v, growth = tangent[:3], tangent[3:6], tangent[6]
    with ctx.extraprec(2 * _reach(growth, dot(ctx, omega, omega)) + 16):
        linear = so3.exponential_series(ctx, omega, 0) * ctx.exp(growth)
        if growth > 0:
            return homogeneous(ctx, linear, linear @ _image(ctx, -omega, -growth, v))
        return homogeneous(ctx, linear, _image(ctx, omega, growth, v))


def log(ctx: Context, pose: Array) -> Array:
    """The principal tangent (omega, v, lambda) of a similarity, (4, 4) -> (7,); section 4, Theorem 3.2.

    3 lambda is the logarithm of the determinant of the linear part, omega the `so3.log` of the rotation nearest to
    that, and v solves V v = translation. Raises InputError if the last row is not 0 0 0 1 or the linear part, divided
    by the cube root of its determinant, is no rotation to within 1e-6.
    """
    _check(ctx, pose)
    with ctx.extraprec(2 * span(pose[:3, :3]) + 16):
        axis, angle, growth = _turn_and_growth(ctx, pose)
        return _tangent(ctx, axis * angle, growth, pose)


def log_next(ctx: Context, pose: Array, previous: Array) -> Array:
    """The tangent of a similarity by strategy 1 of section 5, (4, 4), (7,) -> (7,).

    Its rotation vector is the principal one w or -(2 pi - |w|) w / |w|, whichever is nearer to that of ``previous``; w
    in a tie, and 0 where there is no rotation. Raises InputError as `log` does.
    """
    _check(ctx, pose)
    _domain.finite(ctx, "previous", previous)
    with ctx.extraprec(2 * span(pose[:3, :3], previous[:3]) + 16):
        axis, angle, growth = _turn_and_growth(ctx, pose)
        beyond = angle - ctx.pi - dot(ctx, axis, previous[:3])  # the middle of the two is at the angle - pi
        if angle and beyond > 0 and not negligible(ctx, beyond, ctx.pi):
            angle -= 2 * ctx.pi
        return _tangent(ctx, axis * angle, growth, pose)


def log_near(ctx: Context, pose: Array, near: Array) -> Array:
    """The tangent of a similarity by strategy 2 of section 5, (4, 4), (7,) -> (7,).

    Its rotation vector is the `so3.log_near` of the rotation and the rotation vector of ``near``. Raises InputError as
    `log` does, and where this asks for whole turns of a pose that neither turns nor grows: V is singular then
    (Proposition 3.1).
    """
    return _log_near(ctx, pose, near, near)


def condition(ctx: Context, tangent: Array) -> Array:
    """The condition number of V in the 2-norm for a tangent (omega, v, lambda), (7,) -> ().

    V is normal: it is the ratio of the absolute values of two eigenvalues, that on the axis and that on the plane
    across, the latter never being larger. It is the same for -Gamma, since e^Gamma is a multiple of a rotation. V is
    singular where lambda = 0 and the angle is a multiple of 2 pi other than 0, which no finite binary number is.
    """
    _domain.finite(ctx, "tangent", tangent)
    square, growth = dot(ctx, tangent[:3], tangent[:3]), -abs(tangent[6])
    with ctx.extraprec(2 * _reach(growth, square) + 16):
        first, second, third = _v(ctx, growth, square)
        return scalar(first / ctx.hypot(first - third * square, second * ctx.sqrt(square)))


def continue_log(ctx: Context, base: Array, pose: Array) -> Array:
    """`log` with the rotation vector nearest to that of the tangent ``base``: continued through angle pi."""
    return log_near(ctx, pose, base)


def continue_log_next(ctx: Context, base: Array, pose: Array, previous: Array) -> Array:
    """`log_next` with the rotation vector nearest to that of its value ``base``."""
    return log_near(ctx, pose, base)


def continue_log_near(ctx: Context, base: Array, pose: Array, near: Array) -> Array:
    """`log_near` with the rotation vector nearest to that of its value ``base``; the axis of no rotation is near's."""
    return _log_near(ctx, pose, base, near)


def _log_near(ctx: Context, pose: Array, near: Array, axis_of_none: Array) -> Array:
    """The tangent nearest to ``near``, with the axis of another one where there is no rotation."""
    _check(ctx, pose)
    _domain.finite(ctx, "near", near)
    with ctx.extraprec(2 * span(pose[:3, :3], near[:3], axis_of_none[:3]) + 16):
        axis, angle, growth = _turn_and_growth(ctx, pose)
        goal, other = near[:3], axis_of_none[:3]
        if not angle and any(other):
            goal = other * (norm(ctx, goal) / norm(ctx, other))
        omega = so3.vector_near(ctx, axis, angle, goal)
        if not angle and not growth and any(omega):
            raise InputError("near", "V is singular: whole turns of a pose that neither turns nor grows")
        return _tangent(ctx, omega, growth, pose)


def _check(ctx: Context, pose: Array) -> None:
    _domain.finite(ctx, "pose", pose)
    _domain.last_row("pose", pose)


def _turn_and_growth(ctx: Context, pose: Array) -> tuple[Array, Number, Number]:
    """The unit axis and the principal angle of the nearest rotation, and lambda; refuses what is no similarity."""
    linear = pose[:3, :3]
    gram, determinant = linear.T @ linear, dot(ctx, linear[0], cross(linear[1], linear[2]))
    _domain.similarity(ctx, "pose", gram, determinant)
    axis, angle = so3.axis_angle(ctx, so3.nearest_rotation(ctx, linear, gram))
    return axis, angle, ctx.log(determinant) / 3


def _tangent(ctx: Context, omega: Array, growth: Number, pose: Array) -> Array:
    """The tangent with that rotation vector and lambda that moves the origin to the translation of ``pose``.

    V = a I + b Omega + c Omega^2 is a on the axis and, on the plane across, where Omega^2 = -theta^2, the complex
    number a - c theta^2 + i b theta; V^-1 is the polynomial in Omega that has the inverse values.
    """
    translation, square = pose[:3, 3], dot(ctx, omega, omega)
    with ctx.extraprec(2 * _reach(growth, square) + 16):
        a, b, c = _v(ctx, growth, square)
        across = a - c * square
        size = across * across + b * b * square
        once = cross(omega, translation)
        v = translation / a - once * (b / size) + cross(omega, once) * ((b * b - c * across) / (a * size))
        return np.concatenate([omega, v, [growth]])


def _image(ctx: Context, omega: Array, growth: Number, v: Array) -> Array:
    """The vector V v."""
    a, b, c = _v(ctx, growth, dot(ctx, omega, omega))
    once = cross(omega, v)
    image: Array = v * a + once * b + cross(omega, once) * c
    return image


def _v(ctx: Context, growth: Number, square: Number) -> tuple[Number, Number, Number]:
    """The a, b, c of V = a I + b Omega + c Omega^2, the sum of Gamma^k / (k + 1)!, Omega = [omega]x, theta^2 = square.

    Gamma is halved until it is small and the series summed by Omega^3 = -theta^2 Omega; then V is doubled as often,
    V(2 Gamma) = (I + e^Gamma) V / 2 = V + Gamma V^2 / 2. All this in whole numbers of 2**-bits; a doubling takes up to
    two bits of c Omega^2, and rounding two more.
    """
    halvings = max(0, _exponent(growth, square) + _REDUCED)
    bits = ctx.prec + 4 * halvings + 16
    x, y = int(ctx.ldexp(growth, bits - halvings)), int(ctx.ldexp(square, bits - 2 * halvings))
    a, b, c = p, q, r = 1 << bits, 0, 0
    k = 1
    while abs(p) + abs(q) + abs(r) > 3:
        k += 1
        p, q, r = (x * p >> bits) // k, (p + (x * q - y * r >> bits)) // k, (q + (x * r >> bits)) // k
        a, b, c = a + p, b + q, c + r
    for _ in range(halvings):
        p = a * a >> bits
        q = 2 * (a * b - (y * b >> bits) * c) >> bits
        r = 2 * a * c + b * b - (y * c >> bits) * c >> bits
        a, b, c = a + (x * p >> bits + 1), b + (p + (x * q - y * r >> bits) >> 1), c + (q + (x * r >> bits) >> 1)
        b, c, x, y = b >> 1, c >> 2, x << 1, y << 2
    return ctx.ldexp(a, -bits), ctx.ldexp(b, -bits), ctx.ldexp(c, -bits)


def _exponent(growth: Number, square: Number) -> int:
    """An e with |lambda| < 2**e and theta < 2**e, where theta^2 = square."""
    bounds = [e + 1 >> 1 for number in (growth * growth, square) if (e := magnitude(number)) is not None]
    return max(bounds, default=-_REDUCED)


def _reach(growth: Number, square: Number) -> int:
    """The bits that lambda or theta have before the point."""
    return max(0, _exponent(growth, square))
