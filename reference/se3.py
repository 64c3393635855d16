"""SE(3): rigid motions of space and their twists (omega, v)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from affinecert.reference import _domain, so3
from affinecert.reference._matrices import Array, Context, Number, cross, dot, homogeneous
from affinecert.reference._precision import span
from affinecert.reference._stumpff import stumpff


def exp(ctx: Context, twist: Array) -> Array:
    """The rigid motion exp [[ [omega]x, v ], [0, 0]] of a twist (omega, v), (6,) -> (4, 4).

    Bansal and Tatu, A.2.1. The translation is V v, V = sum_j [omega]x^j / (j + 1)!.
    """
    _domain.finite(ctx, "twist", twist)
    omega, v = twist[:3], twist[3:]
    with ctx.extraprec(2 * span(omega) + 16):
        rotation = so3.exponential_series(ctx, omega, 0)
        return homogeneous(ctx, rotation, so3.exponential_series(ctx, omega, 1) @ v)


def log(ctx: Context, pose: Array) -> Array:
    """The principal twist (omega, v) of a rigid motion, (4, 4) -> (6,).

    The rotation part is replaced by the nearest rotation; omega is its `so3.log`, and v solves V v = translation.
    Raises InputError if the last row is not 0 0 0 1 or the rotation part is no rotation to within 1e-6.
    """
    rotation, translation = parts(ctx, "pose", pose)
    return _twist(ctx, so3.log(ctx, rotation, "pose"), translation)


def continue_log(ctx: Context, base: Array, pose: Array) -> Array:
    """`log` with the rotation vector nearest to that of the twist ``base``: continued through angle pi."""
    rotation, translation = parts(ctx, "pose", pose)
    return _twist(ctx, so3.log_near(ctx, rotation, base[:3]), translation)


def parts(ctx: Context, name: str, pose: Array) -> tuple[Array, Array]:
    """The rotation block and the translation of a rigid motion; refuses a matrix that is none but for its rotation."""
    _domain.finite(ctx, name, pose)
    _domain.last_row(name, pose)
    return pose[:3, :3], pose[:3, 3]


def _twist(ctx: Context, omega: Array, translation: Array) -> Array:
    """The twist with rotation vector omega that moves the origin to ``translation``.

    V^-1 = I - [omega]x / 2 + c [omega]x^2 with c = (c_3 - 2 c_4) / (2 c_2) in Stumpff functions of theta^2, as
    (c_1 I + c_2 [omega]x + c_3 omega omega^T) V^-1 = I shows; nothing cancels in it for theta < 2 pi.
    """
    c = stumpff(ctx, dot(ctx, omega, omega))
    once = cross(omega, translation)
    twice = cross(omega, once)
    return np.concatenate([omega, translation - once / 2 + twice * ((c[3] - 2 * c[4]) / (2 * c[2]))])


def powers(ctx: Context, rotation: Array, translation: Array, t: Number) -> Iterator[tuple[Array, Array]]:
    """Rotation and translation of E^t = exp(t log E), for a rotation that is exact to the context's precision.

    First by the principal logarithm; then, for an angle near pi, by the one on the other side of pi.
    """
    axis, angle = so3.axis_angle(ctx, rotation)
    for theta in (angle, angle - 2 * ctx.pi) if angle > 3 else (angle,):
        twist = _twist(ctx, axis * theta, translation) * t
        omega, v = twist[:3], twist[3:]
        yield so3.exponential_series(ctx, omega, 0), so3.exponential_series(ctx, omega, 1) @ v


def principal_twist(ctx: Context, rotation: Array, translation: Array) -> Array:
    """`log` of a rigid motion whose rotation is exact to the context's precision, (3, 3), (3,) -> (6,)."""
    axis, angle = so3.axis_angle(ctx, rotation)
    return _twist(ctx, axis * angle, translation)
