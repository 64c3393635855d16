"""Homotopies from the identity to a linear map of the plane (Kaji et al., section 3).

A = R S is the polar decomposition of a map of positive determinant: R the rotation by an angle theta in (-pi, pi], S
symmetric positive definite.
"""

from __future__ import annotations

from collections.abc import Callable

from affinecert.errors import InputError
from affinecert.reference import _domain
from affinecert.reference._exact import determinant_sign
from affinecert.reference._functions import divided_difference
from affinecert.reference._functions import power as scalar_power
from affinecert.reference._matrices import Array, Context, Number, array, identity, norm
from affinecert.reference._precision import span

Growth = Callable[[Context, Array, Number], Array]
"""What becomes of S in the time t."""


def linear(ctx: Context, linear: Array, t: Array) -> Array:
    """A^L = (1 - t) I + t A, (2, 2), () -> (2, 2); any A and t."""
    _domain.finite(ctx, "linear", linear)
    _domain.finite(ctx, "t", t)
    with ctx.extraprec(span(linear, t)):
        mixed: Array = identity(ctx, 2) * (1 - t[()]) + linear * t[()]
        return mixed


def polar(ctx: Context, linear: Array, t: Array) -> Array:
    """A^P = R_(t theta) ((1 - t) I + t S), (2, 2), () -> (2, 2); any t.

    Equation 2 (Alexa, Cohen-Or, Levin 2000). Raises InputError if det A is not positive.
    """
    return _homotopies(ctx, linear, t, _straight)[0]


def exponential(ctx: Context, linear: Array, t: Array) -> Array:
    """A^E = R_(t theta) S^t, S^t = exp(t log S), (2, 2), () -> (2, 2); any t.

    Equation 3. Raises InputError if det A is not positive.
    """
    return _homotopies(ctx, linear, t, _power)[0]


def continue_polar(ctx: Context, base: Array, linear: Array, t: Array) -> Array:
    """`polar` with that one of the angles theta + 2 pi k that brings it nearest to ``base``."""
    return _nearest(ctx, base, _homotopies(ctx, linear, t, _straight, (0, 1, -1)))


def continue_exponential(ctx: Context, base: Array, linear: Array, t: Array) -> Array:
    """`exponential` with that one of the angles theta + 2 pi k that brings it nearest to ``base``."""
    return _nearest(ctx, base, _homotopies(ctx, linear, t, _power, (0, 1, -1)))


def turned(ctx: Context, angle: Number) -> Array:
    """The rotation by an angle, (2, 2)."""
    cosine, sine = ctx.cos_sin(angle)
    return array([[cosine, -sine], [sine, cosine]])


def _homotopies(ctx: Context, linear: Array, t: Array, grow: Growth, turns: tuple[int, ...] = (0,)) -> list[Array]:
    """R_(t (theta + 2 pi k)) times what has grown of S, for each k of ``turns``."""
    _domain.finite(ctx, "linear", linear)
    _domain.finite(ctx, "t", t)
    if determinant_sign(linear) <= 0:
        raise InputError("linear", "determinant is not positive")
    time = t[()]
    with ctx.extraprec(2 * span(linear) + span(t) + 16):
        (a, b), (c, d) = linear
        # Of all rotations the one by theta has the largest trace(R^T A) = cos theta (a + d) + sin theta (c - b).
        angle = ctx.atan2(c - b, a + d)
        stretch = grow(ctx, turned(ctx, -angle) @ linear, time)
        return [turned(ctx, time * (angle + 2 * k * ctx.pi)) @ stretch for k in turns]


def _straight(ctx: Context, stretch: Array, t: Number) -> Array:
    grown: Array = identity(ctx, 2) * (1 - t) + stretch * t
    return grown


def _power(ctx: Context, stretch: Array, t: Number) -> Array:
    """S^t, as the polynomial in S that interpolates x^t at its eigenvalues."""
    (a, b), (_, d) = stretch
    larger = (a + d + norm(ctx, [a - d, 2 * b])) / 2
    smaller = (a * d - b * b) / larger
    f = scalar_power(ctx, t)
    slope = divided_difference(ctx, f, [smaller, larger], smaller)
    one = identity(ctx, 2)
    grown: Array = one * f(smaller, 0)[0] + (stretch - one * smaller) * slope
    return grown


def _nearest(ctx: Context, base: Array, candidates: list[Array]) -> Array:
    return min(candidates, key=lambda candidate: norm(ctx, (candidate - base).flat))
