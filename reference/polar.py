"""The polar decomposition L = R S of linear maps of the plane and of space: a rotation after a stretch."""

from __future__ import annotations

from affinecert.reference import _domain
from affinecert.reference._exact import integers, product
from affinecert.reference._functions import power
from affinecert.reference._matrices import Array, Context, identity
from affinecert.reference._spectrum import Linear, extra_bits, interpolate


def decompose(ctx: Context, linear: Array) -> tuple[Array, Array]:
    """The rotation R and the symmetric positive definite S with L = R S, (d, d) -> (d, d), (d, d).

    S = (L^T L)^(1/2), R = L S^-1. Raises InputError if det L is not positive. Kaji and Ochiai, equation 3.
    """
    _domain.linear(ctx, "linear", linear)
    return factors(ctx, linear, gram(linear))


def gram(linear: Array) -> Linear:
    """The matrix L^T L, exactly."""
    n, exponent = integers(linear)
    return Linear(product(list(zip(*n, strict=True)), n), 1, 2 * exponent)


def factors(ctx: Context, linear: Array, square: Linear) -> tuple[Array, Array]:
    """The polar factors R and S, L^T L being given."""
    unit = identity(ctx, len(linear))
    with ctx.extraprec(2 * extra_bits(square)):
        half = ctx.one / 2
        stretch, inverse = interpolate(ctx, square, (power(ctx, half), unit), (power(ctx, -half), unit))
        return linear @ inverse, stretch
