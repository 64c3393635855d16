"""Morphs by spirals, the paths of the powers of similarities: see `affinecert.reference.morphs`."""

from __future__ import annotations

from itertools import product

from affinecert.reference import _turns, _ways
from affinecert.reference._branches import nearest
from affinecert.reference._exact import determinant, integers
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous
from affinecert.reference._spirals import logarithms, progress, spiral
from affinecert.reference._ways import mixed


def log_spiral(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """(Z_C Z_B^-1)^t Z_B ((1 - t) D_B + t D_C): a spiral of similarities, the rest of the poses in a straight line.

    Z_X is the similarity of the translation of X, rotation R_X and scale det(L_X)^(1/dim); D_X = Z_X^-1 X. Rossignac
    and Vinacua, section 2.4 (c).
    """
    with _ways.affine(ctx, start, end, t):
        (first, first_stretch), (last, last_stretch) = (_turns.factors(ctx, pose[:-1, :-1]) for pose in (start, end))
        first_scale, last_scale = _scale(ctx, start), _scale(ctx, end)
        rest = mixed(first_stretch / first_scale, last_stretch / last_scale, t)
        origin, log_ratio = start[:-1, -1], ctx.log(last_scale / first_scale)
        scale = first_scale * ctx.exp(log_ratio * t[()])

        def pose(turn: Array) -> Array:
            linear = _turns.exponential(ctx, turn * t[()]) @ first @ rest * scale
            return homogeneous(ctx, linear, origin + spiral(ctx, turn, log_ratio, t[()], end[:-1, -1] - origin))

        return nearest(ctx, near, map(pose, _turns.logarithms(ctx, last @ first.T)))


def three_spiral(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """The mean of the spirals of the three sides of the standard triangle 0, e_1, e_2, (3, 3), (3, 3), () -> (3, 3).

    The similarity that takes a side of the triangle's image under B to that under C, z the complex ratio of the two,
    takes an end p of it to p' by way of p + (z^t - 1) / (z - 1) (p' - p). Each corner is the mean of where its two
    sides take it. A z on the negative axis turns by pi. Rossignac and Vinacua, section 2.4 (d), after Whited and
    others, BetweenIT (2010).
    """
    with _ways.affine(ctx, start, end, t):
        first, last = _corners(ctx, start), _corners(ctx, end)
        ratios = [(last[j] - last[i]) / (first[j] - first[i]) for i, j in ((0, 1), (1, 2), (2, 0))]

        def pose(logs: tuple[Number, ...]) -> Array:
            parts = [progress(ctx, log, t[()]) for log in logs]
            # A corner lies between the side that leads away from it, of its own number, and the one before.
            corners = [first[i] + (parts[i] + parts[i - 1]) / 2 * (last[i] - first[i]) for i in range(3)]
            columns = [corners[1] - corners[0], corners[2] - corners[0], corners[0]]
            return array([[z.real for z in columns], [z.imag for z in columns], [ctx.zero, ctx.zero, ctx.one]])

        return nearest(ctx, near, map(pose, product(*(logarithms(ctx, z) for z in ratios))))


def _scale(ctx: Context, pose: Array) -> Number:
    """det(L)^(1/dim)."""
    numerators, exponent = integers(pose[:-1, :-1])
    return ctx.ldexp(ctx.root(ctx.mpf(determinant(numerators)), len(numerators)), exponent)


def _corners(ctx: Context, pose: Array) -> list[Number]:
    """The corners of the standard triangle's image, as complex numbers."""
    first, second, origin = (ctx.mpc(x, y) for x, y in pose[:2].T)
    return [origin, origin + first, origin + second]
