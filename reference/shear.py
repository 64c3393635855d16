"""G_A: the shears [[1, a1, a3], [0, a2, a4], [0, 0, a5]] with a2, a5 > 0, and their twists (a1, ..., a5).

Bansal and Tatu print the exponential and the logarithm in five branches each (A.2.3, A.2.4). They are one formula: a
function f of an upper triangular matrix has off its diagonal the entries of the matrix times divided differences of f
at the diagonal's entries, and in the corner a3 f[d1, d3] + a1 a4 f[d1, d2, d3].
"""

from __future__ import annotations

from affinecert.reference import _domain
from affinecert.reference._functions import Function, divided_difference, exponential, logarithm
from affinecert.reference._matrices import Array, Context, Number, array


def exp(ctx: Context, shear_twist: Array) -> Array:
    """The shear exp [[0, a1, a3], [0, a2, a4], [0, 0, a5]], (5,) -> (3, 3)."""
    _domain.finite(ctx, "shear_twist", shear_twist)
    return matrix(ctx, _apply(ctx, exponential(ctx), ctx.zero, shear_twist), ctx.one)


def log(ctx: Context, shear: Array) -> Array:
    """The twist (a1, ..., a5) of the principal logarithm of a shear, (3, 3) -> (5,).

    Raises InputError if the matrix has another shape than G_A's or a diagonal entry that is not positive.
    """
    _domain.shear(ctx, "shear", shear)
    return _apply(ctx, logarithm(ctx), ctx.one, parameters(shear))


def matrix(ctx: Context, alpha: Array, first: Number) -> Array:
    """The matrix [[first, a1, a3], [0, a2, a4], [0, 0, a5]]."""
    a1, a2, a3, a4, a5 = alpha
    return array([[first, a1, a3], [ctx.zero, a2, a4], [ctx.zero, ctx.zero, a5]])


def parameters(shear: Array) -> Array:
    """The (a1, ..., a5) of a matrix of that form."""
    return shear[[0, 1, 0, 1, 2], [1, 1, 2, 2, 2]]


def _apply(ctx: Context, f: Function, first: Number, alpha: Array) -> Array:
    """The parameters of f([[first, a1, a3], [0, a2, a4], [0, 0, a5]]); first = 0 for exp, 1 for log."""
    a1, a2, a3, a4, a5 = alpha

    def difference(*nodes: Number) -> Number:
        # exp changes over a distance of 1; the logarithm over the size of the node, the distance to its singularity.
        ordered = sorted(nodes)
        return divided_difference(ctx, f, ordered, ctx.one if first == 0 else ordered[-1])

    corner = a3 * difference(first, a5)
    if a1 and a4:
        corner += a1 * a4 * difference(first, a2, a5)
    return array([a1 * difference(first, a2), f(a2, 0)[0], corner, a4 * difference(a2, a5), f(a5, 0)[0]])
