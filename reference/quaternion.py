"""Unit quaternions (w, x, y, z)."""

from __future__ import annotations

from affinecert.errors import InputError
from affinecert.reference import _domain, so3
from affinecert.reference._branches import continued, nearest
from affinecert.reference._matrices import Array, Context, array, cross, dot, norm
from affinecert.reference._precision import closeness, span

# A quaternion counts as a unit one up to this distance of its length from 1: rounding to float32 leaves under 2e-7.
UNIT_TOLERANCE = 1e-6


def slerp(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """The point at t on the shorter great arc from p (start) to q (end) or -q, (4,), (4,), () -> (4,); any real t.

    Shoemake, Animating rotation with quaternion curves (1985): (sin((1 - t) a) p + sin(t a) q) / sin a, a the angle
    between unit quaternions. A negative p . q takes -q for q, one that is exactly 0 q as it is. Both are normalised
    first. Given ``near``, q or -q is taken, whichever brings the result nearer to it. Raises InputError if a length is
    further than 1e-6 from 1.
    """
    _domain.finite(ctx, "t", t)
    with ctx.extraprec(2 * span(start, end) + 2 * span(t) + 16):
        p, q = _unit(ctx, "start", start), _unit(ctx, "end", end)
        signs = (1, -1) if dot(ctx, start, end) >= 0 else (-1, 1)
        return nearest(ctx, near, (_on_arc(ctx, p, q * sign, t) for sign in signs))


continue_slerp = continued(slerp)


def of_rotation(ctx: Context, rotation: Array) -> Array:
    """The unit quaternion of an exact rotation, (3, 3) -> (4,), with w >= 0; with w = 0 as `so3.log` has the axis."""
    axis, angle = so3.axis_angle(ctx, rotation)
    cosine, sine = ctx.cos_sin(angle / 2)
    if angle == ctx.pi:
        cosine, sine = ctx.zero, ctx.one
    return array([cosine, *(axis * sine)])


def product(p: Array, q: Array) -> Array:
    """The quaternion product p q."""
    vector = q[1:] * p[0] + p[1:] * q[0] + cross(p[1:], q[1:])
    return array([p[0] * q[0] - p[1:] @ q[1:], *vector])


def conjugate(q: Array) -> Array:
    """The conjugate (w, -x, -y, -z)."""
    return array([q[0], *(-q[1:])])


def matrix(q: Array) -> Array:
    """The rotation x -> q x q* of a unit quaternion, (4,) -> (3, 3)."""
    w, x, y, z = q
    return array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _unit(ctx: Context, name: str, q: Array) -> Array:
    """The quaternion divided by its length; refuses one that is no unit quaternion."""
    _domain.finite(ctx, name, q)
    length = norm(ctx, q)
    if abs(length - 1) > UNIT_TOLERANCE:
        raise InputError(name, "not a unit quaternion: its length is further than 1e-6 from 1")
    unit: Array = q / length
    return unit


def _on_arc(ctx: Context, p: Array, q: Array, t: Array) -> Array:
    """The point at t on the arc from p to q, unit quaternions that are not opposite."""
    apart = norm(ctx, p - q)
    angle = 2 * ctx.atan2(apart, norm(ctx, p + q))
    if not angle:
        return p
    # Of p and q that all but coincide the weights are quotients of small sines, each good to its last bits.
    with ctx.extraprec(closeness(apart, ctx.one)):
        first, second = ctx.sin((1 - t[()]) * angle), ctx.sin(t[()] * angle)
        arc: Array = (p * first + q * second) / ctx.sin(angle)
        return arc
