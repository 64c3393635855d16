"""Morphs: motions from an affine pose B to an affine pose C, by the ways in which people interpolate such poses.

Every morph takes ``start`` B and ``end`` C, homogeneous (n, n), n = 3 in the plane and 4 in space (some know one of them
only), and ``t``, any real number, and gives the pose at t: B at 0 and C at 1. With b and c the translations of B and C,
L_X the linear part of a pose X, and L_X = R_X S_X its polar factors, a rotation and a symmetric positive definite
stretch. Powers and logarithms are principal; where a rotation is by pi exactly, in the plane its angle is pi and in
space the first non-zero component of its vector is positive. Given ``near``, of the values on the branches on both sides
of pi the one nearest to it is taken: so a morph is continued through pi. Each raises InputError if a last row is not
0 ... 0 1 or the determinant of a linear part is not positive, and for what it says besides.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import product
from types import MappingProxyType
from typing import Any

import numpy as np

from affinecert.reference import _domain, _turns, affine_lie, quaternion, sam, se3, sim3, so3
from affinecert.reference._branches import continued, nearest
from affinecert.reference._exact import determinant, integers
from affinecert.reference._functions import Function
from affinecert.reference._functions import exponential as scalar_exponential
from affinecert.reference._functions import logarithm as scalar_logarithm
from affinecert.reference._functions import power as scalar_power
from affinecert.reference._matrices import Array, Context, Number, array, cross, homogeneous, identity, norm
from affinecert.reference._precision import closeness, negligible, span
from affinecert.reference._spectrum import exactly, extra_bits, interpolate, ratio


def linear(ctx: Context, start: Array, end: Array, t: Array) -> Array:
    """The entries in straight lines: (1 - t) B + t C."""
    with _extra_precision(ctx, start, end, t):
        return _mixed(start, end, t)


def shoemake_duff(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """R_B (R_B^T R_C)^t ((1 - t) S_B + t S_C); the translation in a straight line.

    Shoemake and Duff, Matrix animation and polar decomposition (1992).
    """
    with _extra_precision(ctx, start, end, t):
        (first, first_stretch), (last, last_stretch) = _polar_factors(ctx, start, end)
        stretch = _mixed(first_stretch, last_stretch, t)
        translation = _mixed(start[:-1, -1], end[:-1, -1], t)
        turns = _turns.powers(ctx, first.T @ last, t[()])
        return nearest(ctx, near, (homogeneous(ctx, first @ turn @ stretch, translation) for turn in turns))


def arap(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """R^t ((1 - t) I + t S) L_B, where R S = L_C L_B^-1; the origin moves in a straight line.

    Alexa, Cohen-Or and Levin, As-rigid-as-possible shape interpolation (2000): the origin is the first vertex of the
    standard simplex, which stands for theirs.
    """
    with _extra_precision(ctx, start, end, t):
        translation = _mixed(start[:-1, -1], end[:-1, -1], t)
        linears = _rigid_as_possible(ctx, start, end, t)
        return nearest(ctx, near, (homogeneous(ctx, part, translation) for part in linears))


def rarap(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """The linear part of `arap`; the barycentre of the standard simplex 0, e_1, ..., e_n moves in a straight line.

    Rossignac and Vinacua, section 2.4 (b).
    """
    with _extra_precision(ctx, start, end, t):
        linears = _rigid_as_possible(ctx, start, end, t)
        return nearest(ctx, near, (_about_barycentre(ctx, start, end, t, part) for part in linears))


def asap(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """R^t S^t L_B, where R S = L_C L_B^-1; the barycentre of the standard simplex moves in a straight line.

    Rossignac and Vinacua, section 3.3.2; Kaji and others, equation 3, for the linear part.
    """
    with _extra_precision(ctx, start, end, t):
        rotation, stretch = _turns.factors(ctx, _quotient(ctx, end, start))
        grown = _of_symmetric(ctx, stretch, scalar_power(ctx, t[()])) @ start[:-1, :-1]
        turns = _turns.powers(ctx, rotation, t[()])
        return nearest(ctx, near, (_about_barycentre(ctx, start, end, t, turn @ grown) for turn in turns))


def alexa_2002(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """exp((1 - t) log B + t log C), with the logarithms of `sam.log`.

    Alexa, Linear combination of transformations (2002). Raises InputError, besides, if B or C has no real logarithm.
    """
    with _extra_precision(ctx, start, end, t):
        tangents = (
            _mixed(first, last, t)
            for first in sam.logarithms(ctx, "start", start)
            for last in sam.logarithms(ctx, "end", end)
        )
        return nearest(ctx, near, (sam.exponential(ctx, tangent) for tangent in tangents))


def sumner_2005(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """exp((1 - t) log R_B + t log R_C) ((1 - t) S_B + t S_C); the translation in a straight line.

    Sumner, Zwicker, Gotsman and Popovic, Mesh-based inverse kinematics (2005).
    """
    with _extra_precision(ctx, start, end, t):
        (first, first_stretch), (last, last_stretch) = _polar_factors(ctx, start, end)
        stretch = _mixed(first_stretch, last_stretch, t)
        translation = _mixed(start[:-1, -1], end[:-1, -1], t)
        turns = _mixed_turns(ctx, first, last, t)
        return nearest(ctx, near, (homogeneous(ctx, turn @ stretch, translation) for turn in turns))


def log_spiral(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """(Z_C Z_B^-1)^t Z_B ((1 - t) D_B + t D_C): a spiral of similarities, the rest of the poses in a straight line.

    Z_X is the similarity of the translation of X, rotation R_X and scale det(L_X)^(1/dim); D_X = Z_X^-1 X. Rossignac
    and Vinacua, section 2.4 (c).
    """
    with _extra_precision(ctx, start, end, t):
        (first, first_stretch), (last, last_stretch) = _polar_factors(ctx, start, end)
        first_scale, last_scale = _scale(ctx, start), _scale(ctx, end)
        rest = _mixed(first_stretch / first_scale, last_stretch / last_scale, t)
        way, log_ratio = end[:-1, -1] - start[:-1, -1], ctx.log(last_scale / first_scale)
        relative, scale = last @ first.T, first_scale * ctx.exp(log_ratio * t[()])

        def pose(turn: Array) -> Array:
            part = _turns.exponential(ctx, turn * t[()]) @ first @ rest * scale
            return homogeneous(ctx, part, start[:-1, -1] + _spiral(ctx, turn, log_ratio, t[()], way))

        return nearest(ctx, near, map(pose, _turns.logarithms(ctx, relative)))


def three_spiral(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """The mean of the spirals of the three sides of the standard triangle 0, e_1, e_2, (3, 3), (3, 3), () -> (3, 3).

    The similarity that takes a side of the triangle's image under B to that under C, z the complex ratio of the two,
    takes an end p of it to p' by way of p + (z^t - 1) / (z - 1) (p' - p). Each vertex is the mean of where its two sides
    take it. Rossignac and Vinacua, section 2.4 (d), after Whited and others, BetweenIT (2010). A z on the negative axis
    turns by pi.
    """
    with _extra_precision(ctx, start, end, t):
        (first, last), sides = (_corners(ctx, pose) for pose in (start, end)), ((0, 1), (1, 2), (2, 0))
        ratios = ((last[j] - last[i]) / (first[j] - first[i]) for i, j in sides)

        def pose(logs: tuple[Number, ...]) -> Array:
            progress = [_progress(ctx, log, t[()]) for log in logs]
            corners = [first[i] + (progress[i] + progress[i - 1]) / 2 * (last[i] - first[i]) for i in range(3)]
            columns = [corners[1] - corners[0], corners[2] - corners[0], corners[0]]
            return array([[z.real for z in columns], [z.imag for z in columns], [ctx.zero, ctx.zero, ctx.one]])

        return nearest(ctx, near, map(pose, product(*(_complex_logarithms(ctx, z) for z in ratios))))


def lie(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """From B Delta to C Delta as `affine_lie.interpolate_tetrahedra`, Delta the standard simplex 0, e_1, e_2, e_3.

    In the plane the same of its poses in space that leave the third coordinate alone. Bansal and Tatu, equation 4.
    """
    with _extra_precision(ctx, start, end, t):
        goal = None if near is None else _tetrahedron(ctx, near)
        solid = affine_lie.interpolate_tetrahedra(ctx, _tetrahedron(ctx, start), _tetrahedron(ctx, end), t, goal)
        size = len(start) - 1
        edges = (solid[1 : size + 1] - solid[0]).T
        return homogeneous(ctx, edges[:size], solid[0, :size])


def polar_exponential(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """exp((1 - t) log R_B + t log R_C) exp((1 - t) log S_B + t log S_C); the translation in a straight line.

    Kaji and Ochiai, equation 9, for two poses. In the plane log R is the angle.
    """
    with _extra_precision(ctx, start, end, t):
        (first, first_stretch), (last, last_stretch) = _polar_factors(ctx, start, end)
        logs = (_of_symmetric(ctx, stretch, scalar_logarithm(ctx)) for stretch in (first_stretch, last_stretch))
        stretch = _of_symmetric(ctx, _mixed(*logs, t), scalar_exponential(ctx))
        translation = _mixed(start[:-1, -1], end[:-1, -1], t)
        turns = _mixed_turns(ctx, first, last, t)
        return nearest(ctx, near, (homogeneous(ctx, turn @ stretch, translation) for turn in turns))


def sim(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """exp((1 - t) X + t Y), X = `sim3.log`(B) and Y = `sim3.log_next`(C, X), (4, 4), (4, 4), () -> (4, 4).

    Gallier, Allen-Blanchette and Leonardos, section 5. Raises InputError if B or C is no similarity to within 1e-6.
    """
    with _extra_precision(ctx, start, end, t):
        _similarity(ctx, "start", start)
        _similarity(ctx, "end", end)
        tangents = (
            _mixed(first, last, t)
            for first in _other_way_round(ctx, start, sim3.log(ctx, start))
            for last in _other_way_round(ctx, end, sim3.log_next(ctx, end, first))
        )
        return nearest(ctx, near, (sim3.exp(ctx, tangent) for tangent in tangents))


def sclerp(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """The screw motion B exp(t log(B^-1 C)) of rigid B and C, (4, 4), (4, 4), () -> (4, 4).

    Kavan, Collins, Zara and O'Sullivan, Geometric skinning with approximate dual quaternion blending (2008). B and C
    stand for the rigid motions of the nearest rotations. Raises InputError if one is no rigid motion to within 1e-6.
    """
    _domain.finite(ctx, "t", t)
    with ctx.extraprec(2 * span(t) + 2 * span(start[:-1, :-1], end[:-1, :-1]) + 16):
        (first, origin), (last, goal) = _rigid(ctx, "start", start), _rigid(ctx, "end", end)
        powers = se3.powers(ctx, first.T @ last, first.T @ (goal - origin), t[()])
        poses = (homogeneous(ctx, first @ turn, first @ way + origin) for turn, way in powers)
        return nearest(ctx, near, poses)


def dual_quaternion_linear(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """The normalised (1 - t) p + t s q of the unit dual quaternions p and q of rigid B and C, (4, 4), (4, 4), ().

    s = -1 if the inner product of their rotations' quaternions is negative, else 1. The quaternion of a rotation has
    w > 0, and w = 0 with the axis that `so3.log` takes. Kavan and others (2008), DLB. B and C as in `sclerp`.
    """
    _domain.finite(ctx, "t", t)
    with ctx.extraprec(2 * span(t) + 2 * span(start[:-1, :-1], end[:-1, :-1]) + 16):
        (first, origin), (last, goal) = _rigid(ctx, "start", start), _rigid(ctx, "end", end)
        p, q = quaternion.of_rotation(ctx, first), quaternion.of_rotation(ctx, last)
        inner = p @ q
        opposite = inner < 0 and not negligible(ctx, inner, ctx.one)

        def pose(sign: int) -> Array:
            # A unit dual quaternion is r + eps v r / 2, v the translation: of the sum v is the vector part of 2 d r* / |r|^2.
            real, dual = _mixed(p, q * sign, t), _mixed(_moved(ctx, origin, p), _moved(ctx, goal, q * sign), t)
            length = norm(ctx, real)
            way = quaternion.product(dual, quaternion.conjugate(real))[1:] / length**2
            return homogeneous(ctx, quaternion.matrix(real / length), way)

        return nearest(ctx, near, map(pose, (-1, 1) if opposite else (1, -1)))


def _extra_precision(ctx: Context, start: Array, end: Array, t: Array) -> Any:
    """Refuses what no morph takes; a context with the bits that sums and quotients of these inputs cancel."""
    _domain.affine(ctx, "start", start)
    _domain.affine(ctx, "end", end)
    _domain.finite(ctx, "t", t)
    lost = sum(extra_bits(exactly(pose[:-1, :-1])) for pose in (start, end))
    return ctx.extraprec(2 * span(t) + 2 * span(start, end) + lost)


def _mixed(first: Array, last: Array, t: Array) -> Array:
    """(1 - t) first + t last."""
    mixture: Array = first * (1 - t[()]) + last * t[()]
    return mixture


def _polar_factors(ctx: Context, *poses: Array) -> list[tuple[Array, Array]]:
    """Rotation and stretch of each pose."""
    return [_turns.factors(ctx, pose[:-1, :-1]) for pose in poses]


def _of_symmetric(ctx: Context, matrix: Array, f: Function) -> Array:
    """A function of a symmetric matrix."""
    return interpolate(ctx, exactly(matrix), (f, identity(ctx, len(matrix))))[0]


def _rigid_as_possible(ctx: Context, start: Array, end: Array, t: Array) -> Iterator[Array]:
    """The linear parts of `arap`."""
    rotation, stretch = _turns.factors(ctx, _quotient(ctx, end, start))
    grown = _mixed(identity(ctx, len(stretch)), stretch, t) @ start[:-1, :-1]
    return (turn @ grown for turn in _turns.powers(ctx, rotation, t[()]))


def _mixed_turns(ctx: Context, first: Array, last: Array, t: Array) -> Iterator[Array]:
    """The rotations exp((1 - t) log R_B + t log R_C)."""
    return (
        _turns.exponential(ctx, _mixed(one, other, t))
        for one in _turns.logarithms(ctx, first)
        for other in _turns.logarithms(ctx, last)
    )


def _quotient(ctx: Context, end: Array, start: Array) -> Array:
    """L_C L_B^-1."""
    return ratio(end[:-1, :-1], start[:-1, :-1]).numbers(ctx)


def _about_barycentre(ctx: Context, start: Array, end: Array, t: Array, part: Array) -> Array:
    """The pose of that linear part that moves the barycentre of the standard simplex in a straight line."""
    size = len(part)
    barycentre = array([ctx.one / (size + 1)] * size)
    first, last = (pose[:-1, :-1] @ barycentre + pose[:-1, -1] for pose in (start, end))
    return homogeneous(ctx, part, _mixed(first, last, t) - part @ barycentre)


def _scale(ctx: Context, pose: Array) -> Number:
    """det(L)^(1/dim)."""
    numerators, exponent = integers(pose[:-1, :-1])
    return ctx.ldexp(ctx.root(ctx.mpf(determinant(numerators)), len(numerators)), exponent)


def _spiral(ctx: Context, turn: Array, log_ratio: Number, t: Number, way: Array) -> Array:
    """Where a point gets by W^t that W takes along ``way``, W turning by the logarithm ``turn`` and scaling."""
    if len(turn) == 1:
        moved = _progress(ctx, ctx.mpc(log_ratio, turn[0]), t) * ctx.mpc(*way)
        return array([moved.real, moved.imag])
    angle = norm(ctx, turn)
    axis = turn / angle if angle else turn
    along = axis * (axis @ way)
    across = way - along
    grown, turned = _progress(ctx, log_ratio, t), _progress(ctx, ctx.mpc(log_ratio, angle), t)
    moved_across: Array = across * turned.real + cross(axis, across) * turned.imag
    return along * grown + moved_across


def _progress(ctx: Context, log: Number, t: Number) -> Number:
    """The quotient (z^t - 1) / (z - 1), z of that logarithm, real or complex; t for z = 1."""
    if not log:
        return t
    with ctx.extraprec(closeness(abs(log), ctx.one)):
        return (ctx.exp(log * t) - 1) / (ctx.exp(log) - 1)


def _complex_logarithms(ctx: Context, z: Number) -> Iterator[Number]:
    """The principal logarithm, of imaginary part pi on the negative axis; then, close to that axis, the next one."""
    on_axis = z.real < 0 and negligible(ctx, z.imag, z.real)
    principal = ctx.mpc(ctx.log(abs(z)), ctx.pi) if on_axis else ctx.log(z)
    yield principal
    if abs(principal.imag) > _turns.LARGE:
        yield principal - ctx.mpc(0, 2 * ctx.pi if principal.imag > 0 else -2 * ctx.pi)


def _corners(ctx: Context, pose: Array) -> list[Number]:
    """The corners of the standard triangle's image, as complex numbers."""
    first, second, origin = (ctx.mpc(x, y) for x, y in pose[:2].T)
    return [origin, origin + first, origin + second]


def _tetrahedron(ctx: Context, pose: Array) -> Array:
    """The image of the standard simplex, vertices in rows, (4, 3); in the plane that of the pose in space."""
    size = len(pose) - 1
    edges, origin = identity(ctx, 3), array([ctx.zero] * 3)
    edges[:size, :size], origin[:size] = pose[:-1, :-1], pose[:-1, -1]
    return np.concatenate([origin[None], edges.T + origin])


def _similarity(ctx: Context, name: str, pose: Array) -> None:
    """Refuses a pose that is no similarity."""
    linear = pose[:3, :3]
    _domain.similarity(ctx, name, linear.T @ linear, linear[0] @ cross(linear[1], linear[2]))


def _other_way_round(ctx: Context, pose: Array, tangent: Array) -> Iterator[Array]:
    """A logarithm of a similarity, and then the one that turns less than 2 pi the other way round."""
    yield tangent
    angle = norm(ctx, tangent[:3])
    if angle:
        yield sim3.log_near(ctx, pose, tangent * (1 - 2 * ctx.pi / angle))


def _rigid(ctx: Context, name: str, pose: Array) -> tuple[Array, Array]:
    """Rotation and translation of a rigid motion."""
    rotation, translation = se3.parts(ctx, name, pose)
    return so3.project(ctx, name, rotation), translation


def _moved(ctx: Context, translation: Array, q: Array) -> Array:
    """The product of a translation, as a quaternion, and q."""
    return quaternion.product(array([ctx.zero, *translation]), q)


MORPHS: Mapping[str, Callable[..., Array]] = MappingProxyType(
    {
        "linear": linear,
        "shoemake_duff": shoemake_duff,
        "arap": arap,
        "rarap": rarap,
        "asap": asap,
        "alexa_2002": alexa_2002,
        "sumner_2005": sumner_2005,
        "log_spiral": log_spiral,
        "three_spiral": three_spiral,
        "lie": lie,
        "polar_exponential": polar_exponential,
        "sim": sim,
        "sclerp": sclerp,
        "dual_quaternion_linear": dual_quaternion_linear,
        "sam": sam.morph,
    }
)
"""The morphs by name, the steady one with them."""

CONTINUATIONS: Mapping[str, Callable[..., Array]] = MappingProxyType(
    {name: continued(morph) for name, morph in MORPHS.items() if name not in {"linear", "sam"}}
)
"""The morphs as maps of the value that they are to stay near, and of their inputs."""
