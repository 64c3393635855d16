"""Curves through many poses, and curves and patterns that steady affine morphs are cascaded to.

The first five maps are the C1 curves of Bansal and Tatu (section 4.1, after Li and Hao 2006), in the groups G_A, G_S
and SE(3) and composed; the others the constructions of Rossignac and Vinacua (sections 5.3 and 7), n being 3 in the
plane and 4 in space, in which SAM(B, t, C) = (C B^-1)^t B is `sam.morph`. Key number i of a curve through keys has the
time i; before the first key the first segment goes on, and after the last key the last one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from affinecert.errors import InputError
from affinecert.reference import _domain, affine_lie, sam, se3, so3
from affinecert.reference._groups import RIGID, SCALES, SHEARS
from affinecert.reference._li_hao import Group, curve, segment, with_midpoints
from affinecert.reference._matrices import Array, Context, Number, array, dot, homogeneous, norm, scalar
from affinecert.reference._precision import negligible
from affinecert.reference._steady import between, carried, morph, quotient

COPIES = 4
"""How many steps a regular pattern has where nothing else is said."""


def shear_curve(ctx: Context, shears: Array, t: Array) -> Array:
    """The C1 curve through shears, (keys, 3, 3), () -> (3, 3); any real t.

    Raises InputError for fewer than two keys and for a matrix outside G_A.
    """
    _keyed(ctx, "shears", shears, t)
    for matrix in shears:
        _domain.shear(ctx, "shears", matrix)
    return curve(ctx, SHEARS, list(shears), t[()])


def scale_curve(ctx: Context, scales: Array, t: Array) -> Array:
    """The C1 curve through scales, (keys,), () -> (); any real t.

    The logarithms are joined by a quadratic spline. Raises InputError for fewer than two keys and for a scale that is
    not positive.
    """
    _keyed(ctx, "scales", scales, t)
    for number in scales:
        _domain.positive("scales", number)
    return scalar(curve(ctx, SCALES, list(scales[:, None, None]), t[()])[0, 0])


def rigid_curve(ctx: Context, poses: Array, t: Array) -> Array:
    """The C1 curve through rigid motions, (keys, 4, 4), () -> (4, 4); any real t.

    Rotation parts are replaced by the nearest rotations; logarithms are principal, as `se3.log` has them. Raises
    InputError for fewer than two keys, a last row other than 0 0 0 1, and a rotation part that is no rotation to within
    1e-6.
    """
    _keyed(ctx, "poses", poses, t)
    parts = [se3.parts(ctx, "poses", pose) for pose in poses]
    keys = [homogeneous(ctx, so3.project(ctx, "poses", rotation), moved) for rotation, moved in parts]
    return curve(ctx, RIGID, keys, t[()])


def affine_curve(ctx: Context, affines: Array, t: Array) -> Array:
    """The C1 curve through affine maps T_i = A_i S_i E_i, (keys, 4, 4), () -> (4, 4); any real t.

    It is N^A(t) N^S(t) N^E(t), the curves through the A_i, the S_i and the E_i composed in the order of equation 1. The
    paper prints N^E N^S N^A, which passes through E_i S_i A_i and not through the keys. Raises InputError for fewer
    than two keys, a last row other than 0 0 0 1, and a determinant of the linear part that is not positive.
    """
    return _composed(ctx, affines, t, lambda group, keys: curve(ctx, group, keys, t[()]))


def subdivided_curve(ctx: Context, affines: Array, t: Array) -> Array:
    """`affine_curve` through the keys and the poses half way between each two, (keys, 4, 4), () -> (4, 4); any real t.

    Half way in the sense of equation 4, which joins each two keys by A_i exp(t log(A_i^-1 A_(i+1))) in each group
    (sections 4.1 and 6.3, figure 8). Key i keeps the time i. Raises InputError as `affine_curve` does.
    """

    def through(group: Group, keys: Sequence[Array]) -> Array:
        return curve(ctx, group, with_midpoints(ctx, group, keys), 2 * t[()])

    return _composed(ctx, affines, t, through)


def poly_sam(ctx: Context, poses: Array, t: Array) -> Array:
    """The steady morphs from each pose to the next, one after the other, (keys, n, n), () -> (n, n); any real t.

    Section 5.3. Raises InputError for fewer than two keys, a last row other than 0 ... 0 1, a determinant of a linear
    part that is not positive, and where the morph that holds t does not exist (as `sam.log`).
    """
    _keyed(ctx, "poses", poses, t)
    _oriented(ctx, poses=poses)
    index, time = segment(ctx, t[()], len(poses))
    return morph(ctx, "poses", poses[index], poses[index + 1], time)


def bezier_quadratic(ctx: Context, pose_a: Array, pose_b: Array, pose_c: Array, t: Array) -> Array:
    """SAM(SAM(A, t, B), t, SAM(B, t, C)), (n, n) thrice, () -> (n, n); any real t. Section 5.3.

    Raises InputError for a last row other than 0 ... 0 1, a determinant of a linear part that is not positive, and
    where one of the three morphs does not exist (as `sam.log`; for the one between computed poses a half turn counts as
    none, for rounding hides whether it is one).
    """
    _domain.finite(ctx, "t", t)
    _oriented(ctx, pose_a=pose_a, pose_b=pose_b, pose_c=pose_c)
    return _quadratic(ctx, pose_a, pose_b, pose_c, t[()])


def bezier_cubic(ctx: Context, pose_a: Array, pose_b: Array, pose_c: Array, pose_d: Array, t: Array) -> Array:
    """SAM of the quadratic curves of A, B, C and of B, C, D, (n, n) four times, () -> (n, n), section 7.3; any real t.

    Raises InputError as `bezier_quadratic` does.
    """
    _domain.finite(ctx, "t", t)
    _oriented(ctx, pose_a=pose_a, pose_b=pose_b, pose_c=pose_c, pose_d=pose_d)
    time = t[()]
    ab, bc, cd = (
        morph(ctx, name, start, end, time)
        for name, start, end in (("pose_b", pose_a, pose_b), ("pose_c", pose_b, pose_c), ("pose_d", pose_c, pose_d))
    )
    abc, bcd = between(ctx, "pose_c", ab, bc, time), between(ctx, "pose_d", bc, cd, time)
    return between(ctx, "pose_d", abc, bcd, time)


def biarc(ctx: Context, pose_a: Array, pose_b: Array, pose_c: Array, t: Array) -> Array:
    """The C1 curve through A at 0, B at 1/2 and C at 1, of two quadratic Bezier curves, (n, n) thrice, () -> (n, n).

    For t <= 1/2 it has the poses A, L, B, after that B, R, C; any real t. With L = leftControl(A, B, C) as printed in
    section 5.3 and R = leftControl(C, B, A), both B L^-1 and R B^-1 are (B A^-1)^(1/4) (C B^-1)^(1/4): B is half way
    from L to R, and the velocity continuous. Raises InputError as `bezier_quadratic` does.
    """
    _domain.finite(ctx, "t", t)
    _oriented(ctx, pose_a=pose_a, pose_b=pose_b, pose_c=pose_c)
    first = 2 * t[()] <= 1
    start, end, time = (pose_a, pose_c, 2 * t[()]) if first else (pose_c, pose_a, 2 - 2 * t[()])
    names = ("pose_b", "pose_c") if first else ("pose_c", "pose_b")
    quarter = ctx.mpf(1) / 4
    three_quarters = morph(ctx, names[0], start, pose_b, 3 * quarter)
    control = carried(ctx, names[1], three_quarters, end, pose_b, quarter)
    # The second half is the first one of C, B, A, run backwards.
    legs = between(ctx, "pose_b", start, control, time), between(ctx, "pose_b", control, pose_b, time)
    return between(ctx, "pose_b", *legs, time)


def four_point(ctx: Context, poses: Array) -> Array:
    """The poses with a new one between each two, (keys, n, n) -> (2 keys - 1, n, n): a step of four-point subdivision.

    The new pose is half way from the right prediction left(P_(i+1), P_i, P_(i-1)) to the left prediction
    left(P_i, P_(i+1), P_(i+2)), and in the first and the last span the only prediction; left as printed in section 7.3.
    Raises InputError for fewer than three keys, a last row other than 0 ... 0 1, a determinant of a linear part that is
    not positive, and where one of the morphs does not exist (as `bezier_quadratic`).
    """
    if len(poses) < 3:
        raise InputError("poses", f"shape: {len(poses)} keys where at least three are due")
    _oriented(ctx, poses=poses)
    eighth = ctx.mpf(1) / 8

    def left(start: Array, middle: Array, end: Array) -> Array:
        near = morph(ctx, "poses", start, middle, 5 * eighth)
        return carried(ctx, "poses", near, end, middle, eighth)

    lefts = [left(*poses[i : i + 3]) for i in range(len(poses) - 2)]
    rights = [left(*poses[i : i + 3][::-1]) for i in range(len(poses) - 2)]
    half = ctx.mpf(1) / 2
    means = [between(ctx, "poses", *pair, half) for pair in zip(rights, lefts[1:], strict=False)]
    inserted = [lefts[0], *means, rights[-1]]
    return array([pose.tolist() for pair in zip(poses, inserted, strict=False) for pose in pair] + [poses[-1].tolist()])


def patch(ctx: Context, pose_a: Array, pose_b: Array, pose_c: Array, pose_d: Array, s: Array, t: Array) -> Array:
    """SAM(SAM(A, s, B), t, SAM(C, s, D)), (n, n) four times, (), () -> (n, n); any real s and t.

    The SAM patch of section 7.3 and figure 11. Raises InputError as `bezier_quadratic` does.
    """
    _domain.finite(ctx, "s", s)
    _domain.finite(ctx, "t", t)
    _oriented(ctx, pose_a=pose_a, pose_b=pose_b, pose_c=pose_c, pose_d=pose_d)
    top, bottom = morph(ctx, "pose_b", pose_a, pose_b, s[()]), morph(ctx, "pose_d", pose_c, pose_d, s[()])
    return between(ctx, "pose_c", top, bottom, t[()])


def regular_pattern(ctx: Context, start: Array, end: Array, copies: int = COPIES) -> Array:
    """The poses (C B^-1)^(k/copies) B for k = 0, ..., copies, (n, n), (n, n) -> (copies + 1, n, n). Section 7.1.

    Raises InputError as `sam.morph` does.
    """
    step = quotient(ctx, sam.morph(ctx, start, end, scalar(ctx.one / copies)), start)
    poses = [start]
    for _ in range(copies):
        poses.append(step @ poses[-1])
    return array([pose.tolist() for pose in poses])


def grazing_parameter(ctx: Context, affine: Array, point: Array, tangent: Array, normal: Array) -> Array:
    """The s at which the velocity of the point q + s t of a line is orthogonal to n, (n, n), (n-1,) thrice -> ().

    For the motion A^s, log A = [[log L, v], [0, 0]]: s = -n . (log(L) q + v) / n . log(L) t. Equation 8 prints it
    without the sign, and with an origin that is fixed by A, so that v = 0 (section 7.2). Raises InputError as `sam.log`
    does, and where n . log(L) t is zero.
    """
    for name, vector in (("point", point), ("tangent", tangent), ("normal", normal)):
        _domain.finite(ctx, name, vector)
    generator = sam.log(ctx, affine)
    turn = generator[:-1, :-1]
    change = dot(ctx, normal, turn @ tangent)
    if negligible(ctx, change, norm(ctx, turn.flat) * norm(ctx, tangent) * norm(ctx, normal)):
        raise InputError("tangent", "degenerate: the velocity across the normal is the same along all of the line")
    return scalar(-dot(ctx, normal, turn @ point + generator[:-1, -1]) / change)


def _keyed(ctx: Context, name: str, keys: Array, t: Array) -> None:
    """Refuses what is not finite, and fewer than two keys."""
    _domain.finite(ctx, name, keys)
    _domain.finite(ctx, "t", t)
    if len(keys) < 2:
        raise InputError(name, f"shape: {len(keys)} keys where at least two are due")


def _oriented(ctx: Context, **arguments: Array) -> None:
    """Refuses what is no orientation-preserving affine map, among one pose (n, n) or several (count, n, n)."""
    for name, poses in arguments.items():
        for pose in poses.reshape(-1, *poses.shape[-2:]):
            _domain.affine(ctx, name, pose)


def _quadratic(ctx: Context, pose_a: Array, pose_b: Array, pose_c: Array, time: Number) -> Array:
    ab, bc = morph(ctx, "pose_b", pose_a, pose_b, time), morph(ctx, "pose_c", pose_b, pose_c, time)
    return between(ctx, "pose_c", ab, bc, time)


def _composed(ctx: Context, affines: Array, t: Array, through: Callable[[Group, Sequence[Array]], Array]) -> Array:
    """The product of the points on the curves ``through(group, keys)`` in G_A, G_S and SE(3), for T_i = A_i S_i E_i."""
    _keyed(ctx, "affines", affines, t)
    _oriented(ctx, affines=affines)
    last, _ = segment(ctx, t[()], len(affines))
    # What follows the segment that holds t has no part in it.
    factors = [affine_lie.decompose(ctx, affine) for affine in affines[: last + 2]]
    rigids, shears, scales = zip(*factors, strict=True)
    upper = through(SHEARS, shears) * through(SCALES, [scale.reshape(1, 1) for scale in scales])[0, 0]
    rigid = through(RIGID, rigids)
    return homogeneous(ctx, upper @ rigid[:3, :3], upper @ rigid[:3, 3])
