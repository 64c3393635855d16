"""Morphs of rigid motions of space: see `affinecert.reference.morphs`."""

from __future__ import annotations

from contextlib import AbstractContextManager

from affinecert.reference import _domain, _ways, quaternion, se3
from affinecert.reference._branches import nearest
from affinecert.reference._matrices import Array, Context, array, homogeneous, norm
from affinecert.reference._precision import negligible, span
from affinecert.reference._ways import mixed


def sclerp(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """The screw motion B exp(t log(B^-1 C)) of rigid B and C, (4, 4), (4, 4), () -> (4, 4).

    Kavan, Collins, Zara and O'Sullivan, Geometric skinning with approximate dual quaternion blending (2008). B and C
    stand for the rigid motions of the nearest rotations. Raises InputError if one is no rigid motion to within 1e-6.
    """
    with _extra_precision(ctx, start, end, t):
        (first, origin), (last, goal) = _ways.rigid(ctx, "start", start), _ways.rigid(ctx, "end", end)
        powers = se3.powers(ctx, first.T @ last, first.T @ (goal - origin), t[()])
        poses = (homogeneous(ctx, first @ turn, first @ way + origin) for turn, way in powers)
        return nearest(ctx, near, poses)


def dual_quaternion_linear(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """The normalised (1 - t) p + t s q of the unit dual quaternions p and q of rigid B and C, (4, 4), (4, 4), ().

    s = -1 if the inner product of their rotations' quaternions is negative, else 1. The quaternion of a rotation has
    w > 0, and w = 0 with the axis that `so3.log` takes. Kavan and others (2008), DLB. B and C as in `sclerp`.
    """
    with _extra_precision(ctx, start, end, t):
        (first, origin), (last, goal) = _ways.rigid(ctx, "start", start), _ways.rigid(ctx, "end", end)
        p, q = quaternion.of_rotation(ctx, first), quaternion.of_rotation(ctx, last)
        inner = p @ q
        opposite = inner < 0 and not negligible(ctx, inner, ctx.one)

        def pose(sign: int) -> Array:
            # A unit dual quaternion is r + eps v r / 2, v the translation; so v is the vector part of 2 d r* / |r|^2.
            real = mixed(p, q * sign, t)
            twice_dual = mixed(_moved(ctx, origin, p), _moved(ctx, goal, q * sign), t)
            length = norm(ctx, real)
            translation = quaternion.product(twice_dual, quaternion.conjugate(real))[1:] / length**2
            return homogeneous(ctx, quaternion.matrix(real / length), translation)

        return nearest(ctx, near, map(pose, (-1, 1) if opposite else (1, -1)))


def _extra_precision(ctx: Context, start: Array, end: Array, t: Array) -> AbstractContextManager[None]:
    """The context with the bits that products of these inputs cancel."""
    for name, argument in (("start", start), ("end", end), ("t", t)):
        _domain.finite(ctx, name, argument)
    precision: AbstractContextManager[None] = ctx.extraprec(2 * span(t) + 2 * span(start, end) + 16)
    return precision


def _moved(ctx: Context, translation: Array, q: Array) -> Array:
    """The product of a translation, as a quaternion, and q."""
    return quaternion.product(array([ctx.zero, *translation]), q)
