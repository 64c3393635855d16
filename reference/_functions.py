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


def turned_logarithm(ctx: Context) -> Function:
    """The logarithm less 2 pi i, as an x given as mpc, above the negative axis or on it, has it on the other branch."""
    principal = logarithm(ctx)

    def coefficients(x: Number, n: int) -> list[Number]:
        value, *rest = principal(x, n)
        return [value - ctx.mpc(0, 2 * ctx.pi) if isinstance(x, ctx.mpc) else value, *rest]

    return coefficients


def power(ctx: Context, t: Number) -> Function:
    """The function x^t = exp(t log x), its coefficients binomial(t, k) x^(t - k)."""

    def coefficients(x: Number, n: int) -> list[Number]:
        values = [ctx.exp(t * ctx.log(x))]
        for k in range(n):
            values.append(values[-1] * (t - k) / ((k + 1) * x))
        return values

    return coefficients


def quotient(ctx: Context, f: Function, node: int = 1) -> Function:
    """The difference quotient g(x) = f[p, x] = (f(x) - f(p)) / (x - p), which is smooth at the node p.

    Comparing Taylor coefficients in f(x) = f(p) + (x - p) g(x): g_k = (f_k - g_(k-1)) / (x - p), with f(p) for g_-1,
    and g_k = f_(k+1) at p itself.
    """

    def coefficients(x: Number, n: int) -> list[Number]:
        if x == node:
            return f(ctx.mpf(node), n + 1)[1:]
        with ctx.extraprec((n + 1) * closeness(abs(x - node), ctx.one)):
            values, last = [], f(ctx.mpf(node), 0)[0]
            for coefficient in f(x, n):
                last = (coefficient - last) / (x - node)
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
