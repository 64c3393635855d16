"""Rotations of the plane and of space by their logarithms: the angle, (1,), or the rotation vector, (3,).

Close to a half turn a rotation has two short logarithms, the principal one first; elsewhere one.
"""

from __future__ import annotations

from collections.abc import Iterator

from affinecert.reference import so3
from affinecert.reference._matrices import Array, Context, Number, array, norm
from affinecert.reference._precision import negligible

# An angle above this has its other logarithm, of 2 pi less, close by.
LARGE = 3


def factors(ctx: Context, linear: Array) -> tuple[Array, Array]:
    """The polar factors R and S of a linear map L = R S, det L > 0: the nearest rotation, and the symmetric rest.

    Closed forms, at less than half the time of the roots of L^T L in `polar.factors`.
    """
    rotation = (
        _nearest_of_plane(ctx, linear) if len(linear) == 2 else so3.nearest_rotation(ctx, linear, linear.T @ linear)
    )
    stretch = rotation.T @ linear
    return rotation, (stretch + stretch.T) / 2


def logarithms(ctx: Context, rotation: Array) -> Iterator[Array]:
    """The principal logarithm; then, next to a half turn, the one on the other side of pi.

    The rotation, (2, 2) or (3, 3), is exact to the context's precision. At a half turn the principal angle is pi, and
    the principal vector the one whose first non-zero component is positive.
    """
    axis, angle = _angle(ctx, rotation) if len(rotation) == 2 else so3.axis_angle(ctx, rotation)
    yield axis * angle
    if angle > LARGE:
        yield axis * (angle - 2 * ctx.pi)


def exponential(ctx: Context, turn: Array) -> Array:
    """The rotation of an angle or of a rotation vector."""
    if len(turn) == 1:
        cosine, sine = ctx.cos_sin(turn[0])
        return array([[cosine, -sine], [sine, cosine]])
    return so3.exponential_series(ctx, turn, 0)


def powers(ctx: Context, rotation: Array, t: Number) -> Iterator[Array]:
    """The principal power R^t, and the one of the other logarithm."""
    return (exponential(ctx, turn * t) for turn in logarithms(ctx, rotation))


def _nearest_of_plane(ctx: Context, linear: Array) -> Array:
    """The rotation that is a multiple of L + adj(L)^T, (2, 2)."""
    (a, b), (c, d) = linear
    length = norm(ctx, (a + d, c - b))
    cosine, sine = (a + d) / length, (c - b) / length
    return array([[cosine, -sine], [sine, cosine]])


def _angle(ctx: Context, rotation: Array) -> tuple[Array, Number]:
    """The sense of a rotation of the plane, +-1, and its angle in [0, pi]; the sense of a half turn is positive."""
    cosine, sine = rotation[:, 0]
    if cosine < 0 and negligible(ctx, sine, cosine):
        return array([ctx.one]), +ctx.pi
    return array([ctx.one if sine >= 0 else -ctx.one]), ctx.atan2(abs(sine), cosine)
