"""Rotations that bring vectors into triangular form, and the algebra of the triangular matrices that remain."""

from __future__ import annotations

from affinecert.reference import scale, shear
from affinecert.reference._matrices import Array, Context, Number, array, cross, dot, norm, scalar


def align_edges(ctx: Context, edges: Array) -> tuple[Array, Array]:
    """The rotation R and upper triangular U of positive diagonal with R [e_1 e_2 e_3] = U (a QR factorisation).

    The edges are the rows of a (3, 3) array, positively oriented; or of a (2, 3) array, the sides of a triangle, whose
    third edge is then its unit normal. R brings the first edge to the x axis, the second into the xy plane
    (Bansal and Tatu, section 3).
    """
    normal = cross(edges[0], edges[1])
    rotation = _frame(ctx, edges[0], normal)
    third = edges[2] if len(edges) == 3 else rotation[2]
    return rotation, _upper(ctx, array([[dot(ctx, axis, edge) for edge in (*edges[:2], third)] for axis in rotation]))


def align_rows(ctx: Context, linear: Array) -> tuple[Array, Array]:
    """The upper triangular U of positive diagonal and the rotation R with L = U R (an RQ factorisation), det L > 0."""
    rotation = _frame(ctx, cross(linear[1], linear[2]), linear[2])
    return _upper(ctx, linear @ rotation.T), rotation


def divide(ctx: Context, upper: Array, by: Array) -> Array:
    """The quotient U P^-1 of two upper triangular 3x3 matrices."""
    q11, q22, q33 = (upper[i, i] / by[i, i] for i in range(3))
    q12 = (upper[0, 1] - q11 * by[0, 1]) / by[1, 1]
    q23 = (upper[1, 2] - q22 * by[1, 2]) / by[2, 2]
    q13 = (upper[0, 2] - q11 * by[0, 2] - q12 * by[1, 2]) / by[2, 2]
    return array([[q11, q12, q13], [ctx.zero, q22, q23], [ctx.zero, ctx.zero, q33]])


def split(ctx: Context, upper: Array) -> tuple[Array, Array]:
    """The shear A and the scale s with s A the given upper triangular matrix."""
    s = upper[0, 0]
    quotient = upper / s
    quotient[0, 0] = ctx.one
    return quotient, scalar(s)


def power(ctx: Context, upper: Array, t: Number) -> Array:
    """(s A)^t = exp(t log s) exp(t log A), for an upper triangular matrix of positive diagonal."""
    matrix, s = split(ctx, upper)
    growth = scale.exp(ctx, scalar(scale.log(ctx, s)[()] * t))
    product: Array = shear.exp(ctx, shear.log(ctx, matrix) * t) * growth[()]
    return product


def _frame(ctx: Context, first: Array, third: Array) -> Array:
    """The rotation whose rows are the unit vectors along two orthogonal ones and, between them, that across both."""
    x, z = first / norm(ctx, first), third / norm(ctx, third)
    return array([x, cross(z, x), z])


def _upper(ctx: Context, matrix: Array) -> Array:
    """The matrix with exact zeros below its diagonal, where only rounding is left."""
    matrix[[1, 2, 2], [0, 0, 1]] = ctx.zero
    return matrix
