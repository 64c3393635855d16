"""Curves at one parameter to some order: lists of Taylor coefficients, of numbers or of vectors of numbers."""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Any

from affinecert.reference._matrices import Context

Taylor = Sequence[Any]
"""The value, the derivative, half the second derivative, and so on; all lists of one length."""


def product(f: Taylor, g: Taylor, multiply: Callable[[Any, Any], Any] = operator.mul) -> list[Any]:
    """The product of two curves, of any bilinear kind."""
    return [sum((multiply(f[i], g[k - i]) for i in range(1, k + 1)), multiply(f[0], g[k])) for k in range(len(f))]


def total(f: Taylor, g: Taylor) -> list[Any]:
    """The sum of two curves."""
    return [a + b for a, b in zip(f, g, strict=True)]


def multiple(f: Taylor, factor: Any) -> list[Any]:
    """A curve times a constant."""
    return [a * factor for a in f]


def quotient(f: Taylor, g: Taylor) -> list[Any]:
    """A curve over a curve of numbers that is not 0 there."""
    found: list[Any] = []
    for k in range(len(f)):
        found.append(sum((-found[i] * g[k - i] for i in range(k)), f[k]) / g[0])
    return found


def square_root(ctx: Context, f: Taylor) -> list[Any]:
    """The square root of a curve of numbers that is positive there."""
    found: list[Any] = [ctx.sqrt(f[0])]
    for k in range(1, len(f)):
        found.append(sum((-found[i] * found[k - i] for i in range(1, k)), f[k]) / (2 * found[0]))
    return found
