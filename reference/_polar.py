"""Polar factors."""

from __future__ import annotations

from affinecert.reference._matrices import Array, Context, array, cross, dot, norm
from affinecert.reference.so3 import _sum_of_singular_values


def factors(ctx: Context, linear: Array) -> tuple[Array, Array]:
    """The rotation R and the symmetric positive definite S with L = R S."""
    if len(linear) == 2:
        (a, b), (c, d) = linear
        x, y = a + d, c - b
        length = norm(ctx, (x, y))
        rotation = array([[x, -y], [y, x]]) / length
    else:
        gram = linear.T @ linear
        cofactors = array([cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1])])
        square, determinant = gram.trace(), dot(ctx, linear[0], cofactors[0])
        total = _sum_of_singular_values(ctx, square, determinant, dot(ctx, cofactors.flat, cofactors.flat))
        kappa = (total * total - square) / 2
        rotation = (linear * (kappa + square) + cofactors * total - linear @ gram) / (kappa * total - determinant)
    stretch = rotation.T @ linear
    return rotation, (stretch + stretch.T) / 2
