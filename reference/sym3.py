"""sym(3): the symmetric matrices of space, and the positive definite ones, which are their exponentials.

Kaji and Ochiai, section 4 and appendix B: f(Y) is a polynomial of degree two in Y, the one that interpolates f at the
eigenvalues. A matrix is taken for its symmetric part.
"""

from __future__ import annotations

from affinecert.reference import _domain
from affinecert.reference._functions import Function, exponential, logarithm
from affinecert.reference._functions import power as scalar_power
from affinecert.reference._matrices import Array, Context, identity
from affinecert.reference._precision import closeness, span
from affinecert.reference._spectrum import Linear, exactly, extra_bits, interpolate


def exp(ctx: Context, matrix: Array) -> Array:
    """The exponential of a symmetric matrix, (3, 3) -> (3, 3).

    Raises InputError if ||Y - Y^T||_F > 1e-6 ||Y||_F. Kaji and Ochiai, equation 6.
    """
    _domain.symmetric(ctx, "matrix", matrix)
    linear = exactly((matrix + matrix.T) / 2)
    # Entries next to those that are far larger are told by as many bits more, and a huge one by its own.
    with ctx.extraprec(4 * span(matrix)):
        return of_symmetric(ctx, linear, exponential(ctx))


def log(ctx: Context, matrix: Array) -> Array:
    """The symmetric logarithm of a symmetric positive definite matrix, (3, 3) -> (3, 3).

    Raises InputError if ||S - S^T||_F > 1e-6 ||S||_F or the symmetric part is not positive definite. Kaji and Ochiai,
    equation 7.
    """
    return of_symmetric(ctx, _positive_definite(ctx, matrix), logarithm(ctx))


def power(ctx: Context, matrix: Array, t: Array) -> Array:
    """The power S^t = exp(t log S) of a symmetric positive definite matrix, (3, 3), () -> (3, 3), for any real t.

    Raises InputError as `log` does.
    """
    linear = _positive_definite(ctx, matrix)
    _domain.finite(ctx, "t", t)
    with ctx.extraprec(span(t)):
        return of_symmetric(ctx, linear, scalar_power(ctx, t[()]))


def of_symmetric(ctx: Context, linear: Linear, f: Function) -> Array:
    """The function f of a symmetric matrix, given exactly."""
    unit = identity(ctx, len(linear.numerators))
    # Next to the identity the logarithm is as small as S - I.
    nearness = closeness(max(abs(x) for x in (linear.numbers(ctx) - unit).flat), ctx.one)
    with ctx.extraprec(extra_bits(linear) + nearness):
        return interpolate(ctx, linear, (f, unit))[0]


def _positive_definite(ctx: Context, matrix: Array) -> Linear:
    _domain.symmetric(ctx, "matrix", matrix)
    part = (matrix + matrix.T) / 2
    _domain.positive_definite("matrix", part)
    return exactly(part)
