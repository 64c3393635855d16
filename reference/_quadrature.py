"""Gauss and Legendre's quadrature to any precision."""

from __future__ import annotations

from functools import lru_cache

from affinecert.reference._matrices import Context, Number

_STEPS = 200  # Newton's steps double the digits, from 2: no context has 2**200 of them


@lru_cache(maxsize=64)
def _rule(ctx: Context, count: int, precision: int) -> tuple[tuple[Number, Number], ...]:
    """Half of the rule of an even count: its positive nodes, and their weights."""
    with ctx.workprec(precision + 16):
        return tuple(_node(ctx, count, index) for index in range(count // 2))


def _node(ctx: Context, count: int, index: int) -> tuple[Number, Number]:
    """A zero x of the Legendre polynomial P of that degree, by Newton's method, and 2 / ((1 - x^2) P'(x)^2)."""
    x = ctx.cos(ctx.pi * (4 * index + 3) / (4 * count + 2))
    for _ in range(_STEPS):
        before, value = ctx.one, x
        for k in range(2, count + 1):
            before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
        slope = count * (before - x * value) / (1 - x * x)
        step = value / slope
        x -= step
        if abs(step) <= ctx.ldexp(ctx.one, 8 - ctx.prec):
            break
    return x, 2 / ((1 - x * x) * slope * slope)


def gauss_legendre(ctx: Context, count: int, low: Number, high: Number) -> list[tuple[Number, Number]]:
    """Nodes and weights of the rule on [low, high], exact for polynomials of degree below 2 count; count is even."""
    middle, half = (low + high) / 2, (high - low) / 2
    return [(middle + sign * half * x, half * w) for x, w in _rule(ctx, count, ctx.prec) for sign in (1, -1)]
