"""Steady affine morphs between poses that are computed themselves, and so are not known exactly."""

from __future__ import annotations

from affinecert.errors import InputError
from affinecert.reference import sam
from affinecert.reference._exact import adjugate, determinant
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, scalar
from affinecert.reference._precision import negligible
from affinecert.reference._spectrum import exactly, nodes


def morph(ctx: Context, name: str, start: Array, end: Array, t: Number) -> Array:
    """SAM(B, t, C) = (C B^-1)^t B between given poses of positive determinant; blames ``name`` if there is none."""
    try:
        return sam.morph(ctx, start, end, scalar(t))
    except InputError as error:
        raise InputError(name, error.reason) from error


def between(ctx: Context, name: str, start: Array, end: Array, t: Number) -> Array:
    """`morph` between computed poses.

    A negative eigenvalue that is double, as far as half the precision can tell, is refused: whether it has one
    eigenvector, or two and a logarithm, is lost in rounding.
    """
    matrix = quotient(ctx, end, start)
    with ctx.workprec(64):
        at = nodes(ctx, exactly(matrix[:-1, :-1]))
    if at.a < 0 and negligible(ctx, at.b2, at.a**2):
        raise InputError(name, "no real logarithm that is determined: a double negative eigenvalue on the way")
    try:
        pose: Array = sam.power(ctx, matrix, scalar(t)) @ start
    except InputError as error:
        raise InputError(name, f"{error.reason} (on the way)") from error
    return pose


def carried(ctx: Context, name: str, pose: Array, start: Array, end: Array, t: Number) -> Array:
    """SAM(F_X, B, t, C): the pose F_X (``pose``) carried along the motion from B to C for the time t, (C B^-1)^t F_X.

    It is not the product of F_X and the pose SAM(B, t, C): in section 7.3 SAM(F_C, F_A, 1, F_B) completes a regular
    pattern, in which F_D F_C^-1 = F_B F_A^-1.
    """
    moved: Array = quotient(ctx, morph(ctx, name, start, end, t), start) @ pose
    return moved


def quotient(ctx: Context, end: Array, start: Array) -> Array:
    """The affine map C B^-1 from the pose B to the pose C."""
    numbers = start[:-1, :-1]
    rows = numbers.tolist()
    inverse = array(adjugate(rows)) / determinant(rows)
    linear = end[:-1, :-1] @ inverse
    return homogeneous(ctx, linear, end[:-1, -1] - linear @ start[:-1, -1])
