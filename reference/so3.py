"""SO(3): rotations of space and their rotation vectors."""

from __future__ import annotations

from affinecert.reference import _domain
from affinecert.reference._matrices import (
    Array,
    Context,
    Number,
    array,
    cross,
    cross_matrix,
    dot,
    identity,
    norm,
)
from affinecert.reference._precision import negligible, span
from affinecert.reference._stumpff import stumpff


def exp(ctx: Context, omega: Array) -> Array:
    """The rotation about omega by its length in radians, exp [omega]x, (3,) -> (3, 3).

    Bansal and Tatu, A.2.1. The series sum_j [omega]x^j / j!, whose powers are summed to Stumpff functions.
    """
    _domain.finite(ctx, "omega", omega)
    with ctx.extraprec(2 * span(omega) + 16):  # an angle of 2**e radians needs e bits more to be reduced
        return exponential_series(ctx, omega, 0)


def exponential_series(ctx: Context, omega: Array, k: int) -> Array:
    """The sum of [omega]x^j / (j + k)!, (3,) -> (3, 3), for k = 0, 1, 2; k = 0 is the exponential.

    As [omega]x^2 = omega omega^T - theta^2 I, it is c_k I + c_(k+1) [omega]x + c_(k+2) omega omega^T, c_k the Stumpff
    functions of theta^2.
    """
    c = stumpff(ctx, dot(ctx, omega, omega))
    outer = omega[:, None] * omega[None, :]
    rotation: Array = identity(ctx, 3) * c[k] + cross_matrix(ctx, omega) * c[k + 1] + outer * c[k + 2]
    return rotation


def log(ctx: Context, rotation: Array, argument: str = "rotation") -> Array:
    """The principal rotation vector of the rotation nearest to the given matrix, (3, 3) -> (3,).

    Its length is in [0, pi]; at exactly pi its first non-zero component is positive. Raises InputError if R^T R is
    further than 1e-6 from I in the Frobenius norm, or det R < 0; it blames ``argument``.
    """
    _domain.finite(ctx, argument, rotation)
    with ctx.extraprec(2 * span(rotation) + 16):
        axis, angle = axis_angle(ctx, project(ctx, argument, rotation))
        omega: Array = axis * angle
        return omega


def log_near(ctx: Context, rotation: Array, near: Array) -> Array:
    """Among all rotation vectors of the nearest rotation the one nearest to ``near``, (3, 3), (3,) -> (3,).

    They are (theta + 2 pi k) n for integer k. Where two are equally near, the shorter; where these are equally long,
    the principal one. The identity has all axes: its n is the direction of ``near``. Raises InputError as `log` does.
    """
    _domain.finite(ctx, "rotation", rotation)
    _domain.finite(ctx, "near", near)
    with ctx.extraprec(2 * span(rotation, near) + 16):
        return vector_near(ctx, *axis_angle(ctx, project(ctx, "rotation", rotation)), near)


def vector_near(ctx: Context, axis: Array, angle: Number, near: Array) -> Array:
    """Among the rotation vectors (angle + 2 pi k) axis the one nearest to ``near``, with the conventions of `log_near`.

    The axis of an angle of 0 is the direction of ``near``.
    """
    if angle == 0:
        length = norm(ctx, near)
        axis = near / length if length else axis
    omega: Array = axis * _nearest_angle(ctx, angle, dot(ctx, axis, near))
    return omega


def continue_log(ctx: Context, base: Array, rotation: Array) -> Array:
    """The rotation vector nearest to ``base``: `log`, continued through angle pi."""
    return log_near(ctx, rotation, base)


def continue_log_near(ctx: Context, base: Array, rotation: Array, near: Array) -> Array:
    """`log_near`, continued: the rotation vector nearest to its value ``base``; at the identity its axis is near's."""
    if not any(continued := log(ctx, rotation)):
        return near * (norm(ctx, base) / norm(ctx, near)) if any(near) else continued
    return log_near(ctx, rotation, base)


def project(ctx: Context, name: str, matrix: Array) -> Array:
    """The rotation nearest to a matrix that is one to within 1e-6, (3, 3) -> (3, 3); InputError for any other."""
    gram = matrix.T @ matrix
    _domain.rotation(ctx, name, matrix, gram)
    return nearest_rotation(ctx, matrix, gram)


def nearest_rotation(ctx: Context, matrix: Array, gram: Array) -> Array:
    """The rotation nearest in the Frobenius norm to a matrix B near a multiple of one, given with B^T B, (3, 3).

    It is the orthogonal polar factor of B. Markley, Attitude determination using vector observations: a fast optimal
    matrix algorithm (1993): with lambda, the sum of the singular values, the largest root of
    (x^2 - ||B||^2)^2 - 8 x det B - 4 ||adj B||^2, the rotation is
    ((kappa + ||B||^2) B + lambda adj(B)^T - B B^T B) / (kappa lambda - det B), kappa = (lambda^2 - ||B||^2) / 2.
    """
    cofactors = array([cross(matrix[1], matrix[2]), cross(matrix[2], matrix[0]), cross(matrix[0], matrix[1])])
    square, determinant = gram.trace(), dot(ctx, matrix[0], cofactors[0])
    total = _sum_of_singular_values(ctx, square, determinant, dot(ctx, cofactors.flat, cofactors.flat))
    kappa = (total * total - square) / 2
    multiple = matrix * (kappa + square) + cofactors * total - matrix @ gram
    rotation: Array = multiple / (kappa * total - determinant)
    return rotation


def _sum_of_singular_values(ctx: Context, square: Number, determinant: Number, cofactor_square: Number) -> Number:
    """The largest root of (x^2 - square)^2 - 8 x determinant - 4 cofactor_square, from above by Newton's method.

    From sqrt(3 square), which no sum of three numbers of that sum of squares exceeds, the steps only go down, and
    quadratically, for that root is simple where the singular values are nearly equal.
    """
    x = ctx.sqrt(3 * square)
    tolerance = ctx.ldexp(x, 4 - ctx.prec)
    while True:
        gap = x * x - square
        step = (gap * gap - 8 * x * determinant - 4 * cofactor_square) / (4 * x * gap - 8 * determinant)
        x -= step
        if step <= tolerance:
            return x


def axis_angle(ctx: Context, rotation: Array) -> tuple[Array, Number]:
    """The unit axis and the angle in [0, pi] of an exact rotation matrix, through its quaternion.

    At the identity the axis is 0; at exactly pi its first non-zero component is positive. The quaternion is a column
    of 4 q q^T, the one with the largest diagonal entry, and loses nothing at any angle.
    """
    (a, b, c), (d, e, f), (g, h, i) = rotation
    columns = [
        [1 + a + e + i, h - f, c - g, d - b],
        [h - f, 1 + a - e - i, b + d, c + g],
        [c - g, b + d, 1 - a + e - i, f + h],
        [d - b, c + g, f + h, 1 - a - e + i],
    ]
    w, *vector = max((columns[k] for k in range(4)), key=lambda column: norm(ctx, column))
    length = norm(ctx, vector)
    if negligible(ctx, length, w):
        return array([ctx.zero] * 3), ctx.zero
    if negligible(ctx, w, length):
        first = next(x for x in vector if not negligible(ctx, x, length))
        return array(vector) / (length if first > 0 else -length), +ctx.pi
    return array(vector) / (length if w > 0 else -length), 2 * ctx.atan2(length, abs(w))


def _nearest_angle(ctx: Context, angle: Number, near: Number) -> Number:
    """The angle + 2 pi k nearest to ``near``; of two equally near ones the smaller in size, then the positive one."""
    turn = 2 * ctx.pi
    below = angle + turn * ctx.floor((near - angle) / turn)
    above = below + turn
    excess = (near - below) - (above - near)
    if negligible(ctx, excess, turn):
        return below if abs(below) < abs(above) and not negligible(ctx, above + below, turn) else above
    return below if excess < 0 else above
