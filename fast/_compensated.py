"""Double arithmetic with its rounding errors kept: exact sums and products, and what is short to build from them.

An exact result is a pair (high, low): high is the rounded value, low what rounding took away. Pairs last for a few
operations only, where a plain rounding would be magnified; the last step rounds once. The names are the usual ones
(Ogita, Rump, Oishi, "Accurate sum and dot product", 2005).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, cast

from numba.core import types
from numba.extending import intrinsic

from affinecert.fast._kernel import compiled

Pair = tuple[float, float]
Vector = tuple[float, float, float]


@intrinsic
def _fma(_context: Any, x: Any, y: Any, z: Any) -> Any:
    if (x, y, z) != (types.float64,) * 3:
        return None

    def generate(_context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        return builder.fma(*arguments)

    return types.float64(x, y, z), generate


fma = cast(Callable[[float, float, float], float], _fma)
"""Fused multiply-add: x y + z, rounded once."""


@compiled
def two_sum(x: float, y: float) -> Pair:
    """The sum x + y exactly (Knuth)."""
    high = x + y
    part = high - x
    return high, (x - (high - part)) + (y - part)


@compiled
def quick_two_sum(x: float, y: float) -> Pair:
    """The sum x + y exactly, for |x| >= |y| or x = 0 (Dekker)."""
    high = x + y
    return high, y - (high - x)


@compiled
def two_product(x: float, y: float) -> Pair:
    """The product x y exactly."""
    high = x * y
    return high, fma(x, y, -high)


@compiled
def difference_of_products(a: float, b: float, c: float, d: float) -> float:
    """The difference a b - c d within 1.5 units in the last place, however much cancels (Kahan).

    Jeannerod, Louvet, Muller, "Further analysis of Kahan's algorithm", 2013, prove the bound.
    """
    product = c * d
    return fma(a, b, -product) + fma(-c, d, product)


@compiled
def cross(a: Vector, b: Vector) -> Vector:
    """The vector product, each entry within 1.5 units in its last place."""
    return (
        difference_of_products(a[1], b[2], a[2], b[1]),
        difference_of_products(a[2], b[0], a[0], b[2]),
        difference_of_products(a[0], b[1], a[1], b[0]),
    )


@compiled
def dot(a: Vector, b: Vector) -> Pair:
    """The inner product as a pair, computed as if in twice the precision (Ogita, Rump, Oishi, algorithm 5.3)."""
    p, p_low = two_product(a[0], b[0])
    q, q_low = two_product(a[1], b[1])
    r, r_low = two_product(a[2], b[2])
    s, s_low = two_sum(p, q)
    t, t_low = two_sum(s, r)
    return quick_two_sum(t, (p_low + q_low) + (r_low + s_low) + t_low)


@compiled
def dot_plain(a: Vector, b: Vector) -> float:
    """The inner product in plain double arithmetic."""
    return fma(a[0], b[0], fma(a[1], b[1], a[2] * b[2]))


@compiled
def square_root(high: float, low: float) -> Pair:
    """The square root of a positive pair, as a pair: one Newton step with the exact residual."""
    root = math.sqrt(high)
    return root, (fma(-root, root, high) + low) / (2.0 * root)


@compiled
def quotient(high: float, low: float, by: float, by_low: float) -> Pair:
    """The quotient of two pairs, as a pair: one Newton step with the exact residual."""
    inverse = 1.0 / by
    ratio = high * inverse
    return ratio, (fma(-ratio, by, high) + (low - ratio * by_low)) * inverse
