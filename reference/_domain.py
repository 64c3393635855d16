"""The checks of domain that several maps share; each raises InputError."""

from __future__ import annotations

from affinecert.errors import InputError
from affinecert.reference._exact import determinant_sign
from affinecert.reference._matrices import Array, Context, Number

# A matrix counts as a rotation up to this distance ||R^T R - I||_F: rounding to float32 leaves under 3e-7.
ROTATION_TOLERANCE = 1e-6


def finite(ctx: Context, name: str, argument: Array) -> None:
    """Refuse infinities and NaN."""
    if not all(ctx.isfinite(x) for x in argument.flat):
        raise InputError(name, "not finite")


def last_row(name: str, matrix: Array) -> None:
    """Refuse a homogeneous matrix whose last row is not exactly 0 ... 0 1."""
    if any(x != 0 for x in matrix[-1, :-1]) or matrix[-1, -1] != 1:
        raise InputError(name, "last row must be 0 ... 0 1")


def positive(name: str, number: Number) -> None:
    """Refuse a number that is zero or negative."""
    if not number > 0:
        raise InputError(name, "not positive")


def rotation(ctx: Context, name: str, matrix: Array, gram: Array) -> None:
    """Refuse a 3x3 matrix R, given with R^T R, that is no rotation within `ROTATION_TOLERANCE`."""
    defect = sum((gram[i, j] - (i == j)) ** 2 for i in range(3) for j in range(3))
    if defect > ctx.mpf(ROTATION_TOLERANCE) ** 2 or determinant_sign(matrix) <= 0:
        raise InputError(name, "not a rotation: R^T R is further than 1e-6 from I, or the determinant is negative")


def similarity(ctx: Context, name: str, gram: Array, determinant: Number) -> None:
    """Refuse a 3x3 matrix L, given by L^T L and det L, that is no positive multiple of a rotation.

    It counts as one where, divided by the cube root of its determinant, it is one within `ROTATION_TOLERANCE`.
    """
    if determinant <= 0:
        raise InputError(name, "not a similarity: the determinant is not positive")
    square = ctx.cbrt(determinant) ** 2
    defect = sum((gram[i, j] / square - (i == j)) ** 2 for i in range(3) for j in range(3))
    if defect > ctx.mpf(ROTATION_TOLERANCE) ** 2:
        raise InputError(name, "not a similarity: L^T L is further than 1e-6 from I, for L of determinant 1")


def affine(ctx: Context, name: str, matrix: Array) -> None:
    """Refuse a homogeneous matrix that is no orientation-preserving affine map."""
    finite(ctx, name, matrix)
    last_row(name, matrix)
    if determinant_sign(matrix[:-1, :-1]) <= 0:
        raise InputError(name, "determinant of the linear part is not positive")


def shear(ctx: Context, name: str, matrix: Array) -> None:
    """Refuse a 3x3 matrix outside G_A."""
    finite(ctx, name, matrix)
    if matrix[0, 0] != 1 or any(matrix[i, j] != 0 for i, j in ((1, 0), (2, 0), (2, 1))):
        raise InputError(name, "not a shear: must be upper triangular with first column 1 0 0")
    if not (matrix[1, 1] > 0 and matrix[2, 2] > 0):
        raise InputError(name, "diagonal of the shear is not positive")
