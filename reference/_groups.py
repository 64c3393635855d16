"""The groups G_A, G_S and SE(3) as groups of matrices, for the curves of `affinecert.reference._li_hao`."""

from __future__ import annotations

from affinecert.reference import se3, shear
from affinecert.reference._alignment import divide
from affinecert.reference._li_hao import Group
from affinecert.reference._matrices import (
    Array,
    Context,
    array,
    cross,
    cross_matrix,
    dot,
    homogeneous,
    identity,
    tangent,
)
from affinecert.reference._stumpff import stumpff


def _shear_exp(ctx: Context, element: Array) -> Array:
    return shear.exp(ctx, shear.parameters(element))


def _shear_log(ctx: Context, matrix: Array) -> Array:
    return shear.matrix(ctx, shear.log(ctx, matrix), ctx.zero)


def _shear_inverse(ctx: Context, matrix: Array) -> Array:
    return divide(ctx, identity(ctx, 3), matrix)


def _scale_exp(ctx: Context, element: Array) -> Array:
    return array([[ctx.exp(number) for number in row] for row in element])


def _scale_log(ctx: Context, matrix: Array) -> Array:
    return array([[ctx.log(number) for number in row] for row in matrix])


def _scale_inverse(_: Context, matrix: Array) -> Array:
    inverse: Array = 1 / matrix
    return inverse


def _rigid_exp(ctx: Context, element: Array) -> Array:
    omega, v = element[[2, 0, 1], [1, 2, 0]], element[:3, 3]
    # The series of `so3.exponential_series`, for k = 0, and for k = 1 times v.
    c = stumpff(ctx, dot(ctx, omega, omega))
    rotation = identity(ctx, 3) * c[0] + element[:3, :3] * c[1] + omega[:, None] * omega[None, :] * c[2]
    return homogeneous(ctx, rotation, v * c[1] + cross(omega, v) * c[2] + omega * (dot(ctx, omega, v) * c[3]))


def _rigid_log(ctx: Context, pose: Array) -> Array:
    twist = se3.principal_twist(ctx, pose[:3, :3], pose[:3, 3])
    return tangent(ctx, cross_matrix(ctx, twist[:3]), twist[3:])


def _rigid_inverse(ctx: Context, pose: Array) -> Array:
    back = pose[:3, :3].T
    return homogeneous(ctx, back, -(back @ pose[:3, 3]))


SHEARS = Group(_shear_exp, _shear_log, _shear_inverse)
"""G_A: (3, 3)."""

SCALES = Group(_scale_exp, _scale_log, _scale_inverse)
"""G_S: a scale as the (1, 1) matrix of it."""

RIGID = Group(_rigid_exp, _rigid_log, _rigid_inverse)
"""SE(3): (4, 4), rotations exact to the context's precision."""
