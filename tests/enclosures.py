"""Numbers of an mpmath context, and balls of Arb that enclose what is true of them."""

from __future__ import annotations

from typing import Any

import flint
import mpmath
import numpy as np
from numpy.typing import NDArray

Numbers = NDArray[np.object_]


def context(bits: int = 400) -> Any:
    """An mpmath context of that precision."""
    ctx = mpmath.MPContext()
    ctx.prec = bits
    return ctx


def numbers(ctx: Any, values: Any) -> Numbers:
    """Float64 values, or numbers of a context, as an object array of the context's numbers."""
    values = np.asarray(values)
    return np.array([ctx.mpf(x) for x in values.ravel().tolist()], dtype=object).reshape(values.shape)


def length(ctx: Any, values: Numbers) -> Any:
    """The Frobenius norm."""
    return ctx.sqrt(ctx.fsum(np.ravel(values), squared=True))


def ball(number: Any) -> Any:
    """An mpf as an exact ball."""
    mantissa, exponent = number.man_exp
    with flint.ctx.workprec(mantissa.bit_length() + 64):
        return (-1 if number < 0 else 1) * flint.arb(int(mantissa)) * flint.arb(2) ** int(exponent)


def distance(ctx: Any, balls: Any, matrix: Numbers) -> Any:
    """An upper bound of the Frobenius distance between the matrix and anything that the balls enclose."""
    square = sum(((balls[i, j] - ball(x)) ** 2 for (i, j), x in np.ndenumerate(matrix)), start=flint.arb(0))
    return ctx.sqrt(_upper(ctx, square))


def balls(matrix: Numbers) -> Any:
    """A matrix as exact balls."""
    return flint.arb_mat([[ball(x) for x in row] for row in matrix])


def exponential(matrix: Numbers, bits: int = 2000) -> Any:
    """Balls that enclose the exponential of a matrix."""
    with flint.ctx.workprec(bits):
        return balls(matrix).exp()


def _upper(ctx: Any, enclosed: Any) -> Any:
    mantissa, exponent = enclosed.abs_upper().man_exp()
    return ctx.ldexp(ctx.mpf(int(mantissa)), int(exponent))
