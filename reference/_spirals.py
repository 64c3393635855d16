"""How far a point gets on a spiral: powers of complex numbers, and of similarities of the plane and of space."""

from __future__ import annotations

from collections.abc import Iterator

from affinecert.reference._matrices import Array, Context, Number, array, cross, norm
from affinecert.reference._precision import closeness, negligible
from affinecert.reference._turns import LARGE


def progress(ctx: Context, log: Number, t: Number) -> Number:
    """The quotient (z^t - 1) / (z - 1), z of that logarithm, real or complex; t for z = 1."""
    if not log:
        return t
    with ctx.extraprec(closeness(abs(log), ctx.one)):
        return (ctx.exp(log * t) - 1) / (ctx.exp(log) - 1)


def spiral(ctx: Context, turn: Array, log_ratio: Number, t: Number, way: Array) -> Array:
    """How W^t moves a point that W moves by ``way``, (d,), W turning by the logarithm ``turn`` and scaling.

    turn is an angle (1,) or a rotation vector (3,); log_ratio the logarithm of the scale. W p = p + d gives
    W^t p = p + (z^t - 1) / (z - 1) d, z the scale along the axis, and as a complex number across it W's scale and turn.
    """
    if len(turn) == 1:
        moved = progress(ctx, ctx.mpc(log_ratio, turn[0]), t) * ctx.mpc(*way)
        return array([moved.real, moved.imag])
    angle = norm(ctx, turn)
    axis = turn / angle if angle else turn
    along = axis * (axis @ way)
    across = way - along
    grown, turned = progress(ctx, log_ratio, t), progress(ctx, ctx.mpc(log_ratio, angle), t)
    step: Array = along * grown + across * turned.real + cross(axis, across) * turned.imag
    return step


def logarithms(ctx: Context, z: Number) -> Iterator[Number]:
    """The principal logarithm, of imaginary part pi on the negative axis; then, close to that axis, the next one."""
    on_axis = z.real < 0 and negligible(ctx, z.imag, z.real)
    principal = ctx.mpc(ctx.log(abs(z)), ctx.pi) if on_axis else ctx.log(z)
    yield principal
    if abs(principal.imag) > LARGE:
        yield principal - ctx.mpc(0, 2 * ctx.pi if principal.imag > 0 else -2 * ctx.pi)
