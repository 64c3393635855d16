"""G_S: uniform scales, the positive numbers under multiplication."""

from __future__ import annotations

from affinecert.reference import _domain
from affinecert.reference._matrices import Array, Context, scalar


def exp(ctx: Context, log_scale: Array) -> Array:
    """The scale that is the exponential of log_scale, () -> (). Bansal and Tatu, A.2.5."""
    _domain.finite(ctx, "log_scale", log_scale)
    return scalar(ctx.exp(log_scale[()]))


def log(ctx: Context, scale: Array) -> Array:
    """The natural logarithm of a scale, () -> (). Raises InputError if it is not positive. Bansal and Tatu, A.2.5."""
    _domain.finite(ctx, "scale", scale)
    _domain.positive("scale", scale[()])
    return scalar(ctx.log(scale[()]))
