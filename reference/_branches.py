"""Multi-valued maps: of the values on neighbouring branches the principal one, or the one nearest to a given value."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from affinecert.reference._matrices import Array, Context, norm


def nearest(ctx: Context, near: Array | None, candidates: Iterable[Array]) -> Array:
    """The first candidate, the principal value; or given ``near``, the one nearest to it."""
    if near is None:
        return next(iter(candidates))
    return min(candidates, key=lambda candidate: norm(ctx, (candidate - near).flat))


def continued(function: Callable[..., Array]) -> Callable[..., Array]:
    """A map that takes ``near``, as a map whose first argument after the context is the value to stay near."""
    return lambda ctx, base, *inputs: function(ctx, *inputs, near=base)
