"""Scalar functions by their Taylor coefficients, and divided differences of them at nodes however close."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence

from affinecert.reference._matrices import Context, Number
from affinecert.reference._precision import closeness

# f(x, n) is the list of f(x), f'(x), f''(x) / 2!, ..., f^(n)(x) / n!, x an mpf or an mpc.
Function = Callable[[Number, int], list[Number]]


def exponential(ctx: Context) -> Function:
    """The function exp x."""

    def coefficients(x: Number, n: int) -> list[Number]:
        value = ctx.exp(x)
        return [value / ctx.factorial(k) if k > 1 else value for k in range(n + 1)]

    return coefficients


def logarithm(ctx: Context) -> Function:
    """The principal log x, its coefficients -(-x)^-k / k."""

    def coefficients(x: Number, n: int) -> list[Number]:
        return [ctx.log(x), *(-((-x) ** -k) / k for k in range(1, n + 1))]

    return coefficients


def power(ctx: Context, t: Number) -> Function:
    """The function x^t = exp(t log x), its coefficients binomial(t, k) x^(t - k)."""

    def coefficients(x: Number, n: int) -> list[Number]:
        values = [ctx.exp(t * ctx.log(x))]
        for k in range(n):
            values.append(values[-1] * (t - k) / ((k + 1) * x))
        return values

    return coefficients


def quotient(ctx: Context, f: Function) -> Function:
    """The difference quotient g(x) = f[1, x] = (f(x) - f(1)) / (x - 1), which is smooth at 1.

    Comparing Taylor coefficients in f(x) = f(1) + (x - 1) g(x): g_k = (f_k - g_(k-1)) / (x - 1), with f(1) for g_-1,
    and g_k = f_(k+1) at 1 itself.
    """

    def coefficients(x: Number, n: int) -> list[Number]:
        if x == 1:
            return f(ctx.one, n + 1)[1:]
        with ctx.extraprec((n + 1) * closeness(abs(x - 1), ctx.one)):
            values, last = [], f(ctx.one, 0)[0]
            for coefficient in f(x, n):
                last = (coefficient - last) / (x - 1)
                values.append(last)
            return values

    return coefficients


def divided_difference(ctx: Context, f: Function, nodes: Sequence[Number], scale: Number) -> Number:
    """The divided difference f[x_0, ..., x_n] at real nodes in ascending order, equal ones allowed.

    ``scale`` is the distance over which f changes: what the gaps between nodes are small against.
    """
    gaps = [b - a for a, b in itertools.pairwise(nodes)]
    with ctx.extraprec(sum(closeness(gap, scale) for gap in [*gaps, nodes[-1] - nodes[0]])):
        return _difference(f, nodes)


def _difference(f: Function, nodes: Sequence[Number]) -> Number:
    if nodes[0] == nodes[-1]:
        return f(nodes[0], len(nodes) - 1)[-1]
    return (_difference(f, nodes[1:]) - _difference(f, nodes[:-1])) / (nodes[-1] - nodes[0])
