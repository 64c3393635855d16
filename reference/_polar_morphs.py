"""Morphs by polar factors, those of both poses or those of the way between them: see `affinecert.reference.morphs`."""

from __future__ import annotations

from collections.abc import Iterator

from affinecert.reference import _turns, _ways
from affinecert.reference._branches import nearest
from affinecert.reference._functions import exponential, logarithm, power
from affinecert.reference._matrices import Array, Context, homogeneous, identity
from affinecert.reference._spectrum import exactly, ratio
from affinecert.reference._ways import about_barycentre, mixed, straight
from affinecert.reference.sym3 import of_symmetric


def shoemake_duff(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """R_B (R_B^T R_C)^t ((1 - t) S_B + t S_C); the translation in a straight line.

    Shoemake and Duff, Matrix animation and polar decomposition (1992).
    """
    with _ways.affine(ctx, start, end, t):
        (first, first_stretch), (last, last_stretch) = _factors(ctx, start, end)
        stretch, translation = mixed(first_stretch, last_stretch, t), straight(start, end, t)
        turns = _turns.powers(ctx, first.T @ last, t[()])
        return nearest(ctx, near, (homogeneous(ctx, first @ turn @ stretch, translation) for turn in turns))


def arap(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """R^t ((1 - t) I + t S) L_B, where R S = L_C L_B^-1; the origin moves in a straight line.

    Alexa, Cohen-Or and Levin, As-rigid-as-possible shape interpolation (2000): the origin is the first vertex of the
    standard simplex, which stands for theirs.
    """
    with _ways.affine(ctx, start, end, t):
        linears, translation = _as_rigid_as_possible(ctx, start, end, t), straight(start, end, t)
        return nearest(ctx, near, (homogeneous(ctx, linear, translation) for linear in linears))


def rarap(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """The linear part of `arap`; the barycentre of the standard simplex 0, e_1, ..., e_n moves in a straight line.

    Rossignac and Vinacua, section 2.4 (b).
    """
    with _ways.affine(ctx, start, end, t):
        linears = _as_rigid_as_possible(ctx, start, end, t)
        return nearest(ctx, near, (about_barycentre(ctx, start, end, t, linear) for linear in linears))


def asap(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """R^t S^t L_B, where R S = L_C L_B^-1; the barycentre of the standard simplex moves in a straight line.

    Rossignac and Vinacua, section 3.3.2; Kaji and others, equation 3, for the linear part.
    """
    with _ways.affine(ctx, start, end, t):
        rotation, stretch = _turns.factors(ctx, _quotient(ctx, end, start))
        grown = of_symmetric(ctx, exactly(stretch), power(ctx, t[()])) @ start[:-1, :-1]
        turns = _turns.powers(ctx, rotation, t[()])
        return nearest(ctx, near, (about_barycentre(ctx, start, end, t, turn @ grown) for turn in turns))


def sumner_2005(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """exp((1 - t) log R_B + t log R_C) ((1 - t) S_B + t S_C); the translation in a straight line.

    Sumner, Zwicker, Gotsman and Popovic, Mesh-based inverse kinematics (2005).
    """
    with _ways.affine(ctx, start, end, t):
        (first, first_stretch), (last, last_stretch) = _factors(ctx, start, end)
        stretch, translation = mixed(first_stretch, last_stretch, t), straight(start, end, t)
        turns = _mixed_turns(ctx, first, last, t)
        return nearest(ctx, near, (homogeneous(ctx, turn @ stretch, translation) for turn in turns))


def polar_exponential(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """exp((1 - t) log R_B + t log R_C) exp((1 - t) log S_B + t log S_C); the translation in a straight line.

    Kaji and Ochiai, equation 9, for two poses. In the plane log R is the angle.
    """
    with _ways.affine(ctx, start, end, t):
        (first, first_stretch), (last, last_stretch) = _factors(ctx, start, end)
        one, other = (of_symmetric(ctx, exactly(stretch), logarithm(ctx)) for stretch in (first_stretch, last_stretch))
        stretch = of_symmetric(ctx, exactly(mixed(one, other, t)), exponential(ctx))
        turns, translation = _mixed_turns(ctx, first, last, t), straight(start, end, t)
        return nearest(ctx, near, (homogeneous(ctx, turn @ stretch, translation) for turn in turns))


def _factors(ctx: Context, *poses: Array) -> list[tuple[Array, Array]]:
    """Rotation and stretch of each pose."""
    return [_turns.factors(ctx, pose[:-1, :-1]) for pose in poses]


def _quotient(ctx: Context, end: Array, start: Array) -> Array:
    """L_C L_B^-1."""
    return ratio(end[:-1, :-1], start[:-1, :-1]).numbers(ctx)


def _as_rigid_as_possible(ctx: Context, start: Array, end: Array, t: Array) -> Iterator[Array]:
    """The linear parts of `arap`."""
    rotation, stretch = _turns.factors(ctx, _quotient(ctx, end, start))
    grown = mixed(identity(ctx, len(stretch)), stretch, t) @ start[:-1, :-1]
    return (turn @ grown for turn in _turns.powers(ctx, rotation, t[()]))


def _mixed_turns(ctx: Context, first: Array, last: Array, t: Array) -> Iterator[Array]:
    """The rotations exp((1 - t) log R_B + t log R_C)."""
    return (
        _turns.exponential(ctx, mixed(one, other, t))
        for one in _turns.logarithms(ctx, first)
        for other in _turns.logarithms(ctx, last)
    )
