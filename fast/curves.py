"""Curves through many poses, and curves and patterns that steady affine morphs are cascaded to.

The C1 curves through keys of the groups G_A, G_S and SE(3), and composed through affine maps of space, are those of
Bansal and Tatu, "Affine interpolation in a Lie group framework", 2019, section 4.1 (after Li and Hao 2006). The others
are the constructions of Rossignac and Vinacua, "Steady affine motions and morphs", 2011, sections 5.3 and 7, in the
plane (n = 3) and in space (n = 4): SAM(B, t, C) = (C B^-1)^t B is `sam.morph`.

Key number i of a curve through keys has the time i, and any number of keys from two on will do; before the first key
the first segment goes on, and after the last key the last one. Everything is computed in double-double arithmetic and
rounded once. Each function raises InputError for a wrong shape or dtype, numbers that are not finite, and for what it
says besides.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast import _affine_stages, sam
from affinecert.fast import _wide as wide
from affinecert.fast._groups import RIGID, SCALES, SHEARS
from affinecert.fast._kernel import Array, as_float64, checked
from affinecert.fast._li_hao import Group, chosen, curve, segments, with_midpoints
from affinecert.fast._spectrum import NONE, NOT_ORIENTED
from affinecert.fast._stages import refuse, run
from affinecert.fast._steady import (
    DETERMINANT,
    NO_LOGARITHM,
    between,
    carried,
    morph,
    require,
    require_last_row,
    require_morph,
    require_poses,
)
from affinecert.fast._wide_affine import affine_logarithm
from affinecert.fast._wide_rotation import nearest_rotation, require_rotation

AFFINE, SIZES = ("n", "n"), (3, 4)

COPIES = 4
"""How many steps a regular pattern has where nothing else is said."""

# The logarithm and the products with it are good to some 2^-96 of their sizes; what is not above that may be zero.
NOTHING = 2.0**-90

NOT_A_SHEAR = "not a shear: must be upper triangular with first column 1 0 0"
NO_GRAZING = "degenerate: the velocity across the normal is the same along all of the line"


def _through(name: str, keys: ArrayLike, item: tuple[int | str, ...], t: ArrayLike) -> tuple[Array, Array]:
    """The keys and the times as float64 arrays; refuses fewer than two keys."""
    several = _several(name, keys, item, 2)
    arrays, _, _ = checked({name: several, "t": ()}, (keys, t), SIZES)
    return arrays[0], arrays[1]


def _several(name: str, keys: ArrayLike, item: tuple[int | str, ...], least: int) -> tuple[int | str, ...]:
    """The shape of the keys, their number being the one that is given."""
    shape = as_float64(name, keys).shape
    count: int | str = shape[-len(item) - 1] if len(shape) > len(item) else "keys"
    if isinstance(count, int) and count < least:
        raise InputError(name, f"shape {shape} where at least {least} keys are due")
    return (count, *item)


def shear_curve(shears: ArrayLike, t: ArrayLike) -> Array:
    """The C1 curve A_i exp(s B_i) exp(s^2 C_i), s = t - i, through shears A_0, A_1, ... (equations 5 and 6).

    shears (..., keys, 3, 3) and t (...), any number; gives (..., 3, 3). C_i = log(exp(-B_i) A_i^-1 A_(i+1)),
    B_0 = log(A_0^-1 A_1), B_(i+1) = exp(-C_i) B_i exp(C_i) + 2 C_i. Refuses matrices that are not in G_A.
    """
    keys, time = _through("shears", shears, (3, 3), t)
    batch = keys.shape[:-3]
    require(
        (keys[..., 0, 0] == 1.0)[..., None] & (keys[..., [1, 2, 2], [0, 0, 1]] == 0.0), "shears", NOT_A_SHEAR, batch
    )
    require(keys[..., [1, 2], [1, 2]] > 0.0, "shears", "diagonal of the shear is not positive", batch)
    point = np.triu(wide.rounded(curve(SHEARS, wide.widen(keys), time)))
    point[..., 0, 0] = 1.0
    return point


def scale_curve(scales: ArrayLike, t: ArrayLike) -> Array:
    """`shear_curve` for scales (..., keys): the exponential of the quadratic spline of their logarithms.

    t (...), any number; gives (...). Refuses scales that are not positive.

    >>> scale_curve([1.0, 2.0, 16.0], [0.0, 1.0, 1.5, 2.0])
    array([ 1.,  2.,  4., 16.])
    """
    keys, time = _through("scales", scales, (), t)
    require(keys > 0.0, "scales", "not positive", keys.shape[:-1])
    return np.asarray(wide.rounded(curve(SCALES, wide.widen(keys)[..., None, None, :], time))[..., 0, 0])


def rigid_curve(poses: ArrayLike, t: ArrayLike) -> Array:
    """`shear_curve` for rigid motions (..., keys, 4, 4), with logarithms as `se3.log` has them.

    t (...), any number; gives (..., 4, 4). The rotations nearest to the linear parts count. Refuses a last row other
    than 0 0 0 1, and linear parts that are no rotations to within 1e-6.
    """
    keys, time = _through("poses", poses, (4, 4), t)
    require_last_row("poses", keys, keys.shape[:-3])
    _require_rotations(keys[..., :3, :3])
    rotations = nearest_rotation(keys[..., :3, :3])
    return wide.rounded(curve(RIGID, wide.homogeneous(rotations, wide.widen(keys[..., :3, 3])), time))


def _require_rotations(linear: Array) -> None:
    """Refuses keys (..., keys, 3, 3) that are no rotations, naming the index of the curve."""
    try:
        require_rotation("poses", linear)
    except InputError as error:
        raise InputError("poses", error.reason, error.index[:-1]) from error


def affine_curve(affines: ArrayLike, t: ArrayLike) -> Array:
    """The C1 curve N^A(t) N^S(t) N^E(t) through affine maps T_i = A_i S_i E_i, `affine_lie.decompose` (section 4.1).

    affines (..., keys, 4, 4) and t (...), any number; gives (..., 4, 4). The paper prints the factors in the opposite
    order, which misses the keys. Refuses a last row other than 0 0 0 1 and determinants that are not positive.
    """
    keys, time = _through("affines", affines, (4, 4), t)
    return _composed(keys, lambda group, factors: curve(group, factors, time))


def subdivided_curve(affines: ArrayLike, t: ArrayLike) -> Array:
    """`affine_curve` through the keys and, between each two, the pose half way on the path of equation 4 (section 6.3).

    affines (..., keys, 4, 4) and t (...), any number, key i keeping the time i; gives (..., 4, 4). In each group that
    pose is A_i exp(log(A_i^-1 A_(i+1)) / 2). Refuses what `affine_curve` does.
    """
    keys, time = _through("affines", affines, (4, 4), t)
    return _composed(keys, lambda group, factors: curve(group, with_midpoints(group, factors), 2.0 * time))


def _composed(keys: Array, through: Callable[[Group, Array], Array]) -> Array:
    """The product of the points on the curves ``through(group, keys)`` in the three groups."""
    require_poses("affines", keys, keys.shape[:-3])
    rotation, upper, displacement, _ = run(_affine_stages.factors, keys)
    scale = upper[..., :1, :1, :]
    sheared, scaled = through(SHEARS, wide.divide(upper, scale)), through(SCALES, scale)
    linear = wide.homogeneous(wide.multiply(sheared, scaled), np.zeros((3, 2)))
    return wide.rounded(wide.product(linear, through(RIGID, wide.homogeneous(rotation, displacement))))


def poly_sam(poses: ArrayLike, t: ArrayLike) -> Array:
    """The steady morphs from each pose to the next, one after the other (section 5.3).

    poses (..., keys, n, n) and t (...), any number; gives (..., n, n): `sam.morph` from pose i to pose i + 1 at the
    time t - i. Refuses a last row other than 0 ... 0 1, determinants that are not positive, and poses between which
    there is no steady morph where t asks for it.
    """
    keys, time = _through("poses", poses, AFFINE, t)
    batch = keys.shape[:-3]
    require_poses("poses", keys, batch)
    index, since = segments(time, keys.shape[-3])
    start, end = (chosen(keys, index + step, 2) for step in (0, 1))
    require_morph("poses", start, end, batch)
    return sam.morph(start, end, since)


def bezier_quadratic(pose_a: ArrayLike, pose_b: ArrayLike, pose_c: ArrayLike, t: ArrayLike) -> Array:
    """The quadratic Bezier curve SAM(SAM(A, t, B), t, SAM(B, t, C)) of steady morphs (section 5.3).

    pose_a, pose_b and pose_c (..., n, n) and t (...), any number; gives (..., n, n). Refuses a last row other than
    0 ... 0 1, determinants that are not positive, and poses between which there is no steady morph. Between poses that
    are computed a half turn counts as none.
    """
    (a, b, c), (time,) = _poses({"pose_a": pose_a, "pose_b": pose_b, "pose_c": pose_c}, {"t": t})
    first, second = _leg("pose_b", a, b, time), _leg("pose_c", b, c, time)
    return wide.rounded(between("pose_c", first, second, time, c.shape[:-2]))


def bezier_cubic(pose_a: ArrayLike, pose_b: ArrayLike, pose_c: ArrayLike, pose_d: ArrayLike, t: ArrayLike) -> Array:
    """The cubic Bezier curve: the steady morph between the quadratic ones of A, B, C and of B, C, D (section 7.3).

    pose_a, ..., pose_d (..., n, n) and t (...), any number; gives (..., n, n). Refuses what `bezier_quadratic` does.
    """
    given = {"pose_a": pose_a, "pose_b": pose_b, "pose_c": pose_c, "pose_d": pose_d}
    (a, b, c, d), (time,) = _poses(given, {"t": t})
    legs = _leg("pose_b", a, b, time), _leg("pose_c", b, c, time), _leg("pose_d", c, d, time)
    first = between("pose_c", legs[0], legs[1], time, c.shape[:-2])
    second = between("pose_d", legs[1], legs[2], time, d.shape[:-2])
    return wide.rounded(between("pose_d", first, second, time, d.shape[:-2]))


def biarc(pose_a: ArrayLike, pose_b: ArrayLike, pose_c: ArrayLike, t: ArrayLike) -> Array:
    """The C1 curve through A at t = 0, B at 1/2 and C at 1, made of two quadratic Bezier curves (section 5.3).

    pose_a, pose_b and pose_c (..., n, n) and t (...), any number; gives (..., n, n): the curve of A, L, B at 2 t, from
    t = 1/2 on that of B, R, C at 2 t - 1. As the paper's leftControl makes them, L = (B C^-1)^(1/4) SAM(A, 3/4, B) and
    R = (B A^-1)^(1/4) SAM(C, 3/4, B), so that B is half way from L to R. Refuses what `bezier_quadratic` does.
    """
    (a, b, c), (time,) = _poses({"pose_a": pose_a, "pose_b": pose_b, "pose_c": pose_c}, {"t": t})
    require_morph("pose_b", a, b, b.shape[:-2])
    require_morph("pose_c", b, c, c.shape[:-2])
    # The second half is the first one of C, B, A, run backwards.
    second = (time > 0.5)[..., None, None]
    start, middle, end = wide.widen(np.where(second, c, a)), wide.widen(b), wide.widen(np.where(second, a, c))
    since = np.where(time > 0.5, 2.0 - 2.0 * time, 2.0 * time)
    batch = b.shape[:-2]
    control = carried(morph(start, middle, np.array(0.75)), end, middle, np.array(0.25))
    first, last = (between("pose_b", *leg, since, batch) for leg in ((start, control), (control, middle)))
    return wide.rounded(between("pose_b", first, last, since, batch))


def four_point(poses: ArrayLike) -> Array:
    """The poses with a new one between each two, by one step of four-point subdivision (section 7.3).

    poses (..., keys, n, n), at least three; gives (..., 2 keys - 1, n, n). The new pose is half way from the prediction
    left(P_(i+1), P_i, P_(i-1)) to the prediction left(P_i, P_(i+1), P_(i+2)), in the first and the last span the only
    one of these that there is; left(A, B, C) = (B C^-1)^(1/8) SAM(A, 5/8, B). Refuses what `bezier_quadratic` does.
    """
    (keys,), _, _ = checked({"poses": _several("poses", poses, AFFINE, 3)}, (poses,), SIZES)
    batch = keys.shape[:-3]
    require_poses("poses", keys, batch)
    for i in range(keys.shape[-3] - 1):
        require_morph("poses", keys[..., i, :, :], keys[..., i + 1, :, :], batch)
    given = wide.widen(keys)
    a, b, c = (given[..., i : i + keys.shape[-3] - 2, :, :, :] for i in range(3))
    eighth, five_eighths, half = (np.array(k / 8) for k in (1, 5, 4))
    lefts = carried(morph(a, b, five_eighths), c, b, eighth)
    rights = carried(morph(c, b, five_eighths), a, b, eighth)
    refined = np.empty((*batch, 2 * keys.shape[-3] - 1, *keys.shape[-2:]))
    refined[..., ::2, :, :] = keys
    refined[..., 1, :, :] = wide.rounded(lefts[..., 0, :, :, :])
    refined[..., -2, :, :] = wide.rounded(rights[..., -1, :, :, :])
    for i in range(keys.shape[-3] - 3):
        mean = between("poses", rights[..., i, :, :, :], lefts[..., i + 1, :, :, :], half, batch)
        refined[..., 2 * i + 3, :, :] = wide.rounded(mean)
    return refined


def patch(
    pose_a: ArrayLike, pose_b: ArrayLike, pose_c: ArrayLike, pose_d: ArrayLike, s: ArrayLike, t: ArrayLike
) -> Array:
    """The patch SAM(SAM(A, s, B), t, SAM(C, s, D)) between four poses (section 7.3, figure 11).

    pose_a, ..., pose_d (..., n, n), s (...) and t (...), any numbers; gives (..., n, n). Refuses what
    `bezier_quadratic` does.
    """
    given = {"pose_a": pose_a, "pose_b": pose_b, "pose_c": pose_c, "pose_d": pose_d}
    (a, b, c, d), (along, across) = _poses(given, {"s": s, "t": t})
    top, bottom = _leg("pose_b", a, b, along), _leg("pose_d", c, d, along)
    return wide.rounded(between("pose_c", top, bottom, across, c.shape[:-2]))


def regular_pattern(start: ArrayLike, end: ArrayLike, copies: int = COPIES) -> Array:
    """The poses (C B^-1)^(k / copies) B for k = 0, ..., copies, each the one before times the same affine map.

    start B and end C (..., n, n); gives (..., copies + 1, n, n). Refuses what `sam.morph` does, and fewer than one copy
    (section 7.1).

    >>> regular_pattern(np.eye(3), np.diag([16.0, 81.0, 1.0]))[:, [0, 1], [0, 1]]
    array([[ 1.,  1.],
           [ 2.,  3.],
           [ 4.,  9.],
           [ 8., 27.],
           [16., 81.]])
    """
    if copies < 1:
        raise InputError("copies", f"{copies} where at least one is due")
    (first, last), _ = _poses({"start": start, "end": end}, {})
    require_morph("end", first, last, last.shape[:-2])
    times = np.arange(copies + 1.0) / copies
    return sam.morph(first[..., None, :, :], last[..., None, :, :], times)


def grazing_parameter(affine: ArrayLike, point: ArrayLike, tangent: ArrayLike, normal: ArrayLike) -> Array:
    """The s at which the velocity of the point q + s t of a line is orthogonal to n, in the steady motion of A.

    affine A (..., n, n), point q, tangent t and normal n (..., n - 1); gives (...). With log A = [[log L, v], [0, 0]],
    s = -n . (log(L) q + v) / n . log(L) t: equation 8 lacks the sign, and takes the origin to be fixed. Refuses what
    `sam.log` does, and lines along which n . velocity is the same.
    """
    inputs = {"affine": AFFINE, "point": ("n-1",), "tangent": ("n-1",), "normal": ("n-1",)}
    (matrix, q, along, n), _, _ = checked(inputs, (affine, point, tangent, normal), SIZES)
    batch = matrix.shape[:-2]
    require_last_row("affine", matrix, batch)
    generator, existence = affine_logarithm(wide.widen(matrix))
    refuse(existence, NOT_ORIENTED, "affine", DETERMINANT, batch)
    refuse(existence, NONE, "affine", NO_LOGARITHM, batch)
    turn = wide.linear_part(generator)
    rate, change = (
        wide.product(wide.widen(n)[..., None, :, :], velocity[..., None, :])[..., 0, 0, :]
        for velocity in (
            wide.add(wide.image(turn, wide.widen(q)), wide.translation(generator)),
            wide.image(turn, wide.widen(along)),
        )
    )
    size = np.sqrt((turn[..., 0] ** 2).sum(axis=(-2, -1)))
    largest = size * np.linalg.norm(along, axis=-1) * np.linalg.norm(n, axis=-1)
    found = np.asarray(np.abs(change[..., 0]) > NOTHING * largest, dtype=np.float64)
    refuse(found, 0.0, "tangent", NO_GRAZING, along.shape[:-1])
    return wide.rounded(wide.divide(-rate, change))


def _poses(poses: Mapping[str, ArrayLike], numbers: Mapping[str, ArrayLike]) -> tuple[list[Array], list[Array]]:
    """The poses and the numbers as float64 arrays; refuses what is no orientation-preserving affine map."""
    inputs = dict.fromkeys(poses, AFFINE) | dict.fromkeys(numbers, ())
    arrays, _, _ = checked(inputs, (*poses.values(), *numbers.values()), SIZES)
    given, rest = arrays[: len(poses)], arrays[len(poses) :]
    for name, pose in zip(poses, given, strict=True):
        require_poses(name, pose, pose.shape[:-2])
    return given, rest


def _leg(name: str, start: Array, end: Array, t: Array) -> Array:
    """The steady morph between given poses, in pairs; blames the argument ``name``, the end, if there is none."""
    require_morph(name, start, end, end.shape[:-2])
    return morph(wide.widen(start), wide.widen(end), t)
