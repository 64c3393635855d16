"""What the morphs from a pose B to a pose C share: their domain, and straight lines between things."""

from __future__ import annotations

from contextlib import AbstractContextManager

from affinecert.reference import _domain, se3, so3
from affinecert.reference._matrices import Array, Context, array, homogeneous
from affinecert.reference._precision import span
from affinecert.reference._spectrum import exactly, extra_bits


def affine(ctx: Context, start: Array, end: Array, t: Array) -> AbstractContextManager[None]:
    """Refuses what is no affine pose; the context with the bits that sums and quotients of these inputs cancel."""
    _domain.affine(ctx, "start", start)
    _domain.affine(ctx, "end", end)
    _domain.finite(ctx, "t", t)
    lost = sum(extra_bits(exactly(pose[:-1, :-1])) for pose in (start, end))
    precision: AbstractContextManager[None] = ctx.extraprec(2 * span(t) + 2 * span(start, end) + lost)
    return precision


def rigid(ctx: Context, name: str, pose: Array) -> tuple[Array, Array]:
    """The nearest rotation and the translation of a rigid motion; refuses what is none."""
    rotation, translation = se3.parts(ctx, name, pose)
    return so3.project(ctx, name, rotation), translation


def mixed(first: Array, last: Array, t: Array) -> Array:
    """(1 - t) first + t last."""
    mixture: Array = first * (1 - t[()]) + last * t[()]
    return mixture


def straight(start: Array, end: Array, t: Array) -> Array:
    """The translation in a straight line."""
    return mixed(start[:-1, -1], end[:-1, -1], t)


def about_barycentre(ctx: Context, start: Array, end: Array, t: Array, linear: Array) -> Array:
    """The pose of that linear part that moves the barycentre of the standard simplex in a straight line."""
    size = len(linear)
    barycentre = array([ctx.one / (size + 1)] * size)
    first, last = (pose[:-1, :-1] @ barycentre + pose[:-1, -1] for pose in (start, end))
    return homogeneous(ctx, linear, mixed(first, last, t) - linear @ barycentre)
