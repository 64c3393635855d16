"""Morphs: motions from an affine pose B to an affine pose C, by the ways in which people interpolate such poses.

Every morph takes ``start`` B and ``end`` C, homogeneous (..., n, n), n = 3 in the plane and 4 in space (some know one of
them only), and ``t`` (...), any number, and gives the pose at t, (..., n, n): exactly B at t = 0 and C at t = 1. b and c
are the translations of B and C, L_X is the linear part of a pose X, and L_X = R_X S_X are its polar factors, a rotation
and a symmetric positive definite stretch. Powers and logarithms are principal; where a rotation is by pi exactly, in the
plane its angle is pi and in space the first component of its vector that is not 0 is positive. Everything is computed in
double-double arithmetic and rounded once.

Each raises InputError for a wrong shape or dtype, numbers that are not finite, a last row other than 0 ... 0 1, a
determinant of a linear part that is not positive, and for what it says besides.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast import _turns, affine_lie, sam
from affinecert.fast import _quaternions as quaternions
from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array, checked
from affinecert.fast._rotation import ORTHOGONALITY
from affinecert.fast._spirals import complex_product, direction, progress, spiral, velocity
from affinecert.fast._spectrum import NONE
from affinecert.fast._stages import refuse
from affinecert.fast._wide_affine import affine_exponential, affine_logarithm
from affinecert.fast._wide_polar import polar
from affinecert.fast._wide_rotation import PI, ROUNDING, TWO_PI, nearest_rotation, require_rotation
from affinecert.fast._wide_symmetric import symmetric_exponential, symmetric_logarithm, symmetric_power

DETERMINANT = "the determinant of the linear part is not positive"
LAST_ROW = "the last row is not 0 ... 0 1"
NOT_SIMILAR = "not a similarity: L^T L is further than 1e-6 from I, for L of determinant 1"


class _Way(NamedTuple):
    """Start and end and the time, as they are given; and the linear parts and translations of both, as pairs."""

    start: Array
    end: Array
    t: Array
    first: Array
    last: Array
    origin: Array
    goal: Array

    @property
    def translation(self) -> Array:
        """The translation in a straight line, as pairs."""
        return _mixed(self.origin, self.goal, self.t[..., None])

    def stretched(self, first: Array, last: Array) -> Array:
        """The matrix between two matrices, as pairs, in a straight line."""
        return _mixed(first, last, self.t[..., None, None])

    def pose(self, linear: Array, translation: Array) -> Array:
        """The pose of a linear part and a translation, as pairs, rounded; the ends as they are given."""
        pose = wide.rounded(wide.homogeneous(linear, translation))
        t = self.t[..., None, None]
        return np.where(t == 0.0, self.start, np.where(t == 1.0, self.end, pose))

    def about_barycentre(self, linear: Array) -> Array:
        """The pose of that linear part that moves the barycentre of the standard simplex in a straight line."""
        size = linear.shape[-2]
        first, last = (
            wide.add(_sum(part), wide.times(place, float(size + 1)))
            for part, place in ((self.first, self.origin), (self.last, self.goal))
        )
        moved = wide.subtract(_mixed(first, last, self.t[..., None]), _sum(linear))
        divisor = wide.widen(np.array(size + 1.0))
        return self.pose(linear, wide.divide(moved, divisor))


def _way(start: ArrayLike, end: ArrayLike, t: ArrayLike, sizes: tuple[int, ...] = (3, 4)) -> _Way:
    """The arguments of a morph; refuses poses that are not affine of positive determinant."""
    first, last, time = checked({"start": ("n", "n"), "end": ("n", "n"), "t": ()}, (start, end, t), sizes)[0]
    for name, pose in (("start", first), ("end", last)):
        _require_last_row(name, pose)
        sign = wide.determinant_sign(wide.widen(pose[..., :-1, :-1]))
        refuse((sign > 0.0).astype(np.float64), 0.0, name, DETERMINANT, sign.shape)
    return _from(first, last, time)


def _from(first: Array, last: Array, time: Array) -> _Way:
    b, c = wide.widen(first), wide.widen(last)
    parts = wide.linear_part(b), wide.linear_part(c), wide.translation(b), wide.translation(c)
    return _Way(first, last, time, *parts)


def _require_last_row(name: str, pose: Array) -> None:
    good = (pose[..., -1, :] == np.eye(pose.shape[-1])[-1]).all(axis=-1)
    refuse(good.astype(np.float64), 0.0, name, LAST_ROW, good.shape)


def _mixed(first: Array, last: Array, t: Array) -> Array:
    """(1 - t) first + t last, pairs; t broadcasts against their entries."""
    return wide.add(first, wide.times(wide.subtract(last, first), t))


def _sum(matrix: Array) -> Array:
    """The sums of the rows of matrices of pairs."""
    total = matrix[..., 0, :]
    for j in range(1, matrix.shape[-2]):
        total = wide.add(total, matrix[..., j, :])
    return total


def linear(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The entries in straight lines: (1 - t) B + t C.

    >>> linear(np.eye(3), np.diag([3.0, 5.0, 1.0]), 0.5)
    array([[2., 0., 0.],
           [0., 3., 0.],
           [0., 0., 1.]])
    """
    way = _way(start, end, t)
    return way.pose(way.stretched(way.first, way.last), way.translation)


def shoemake_duff(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """R_B (R_B^T R_C)^t ((1 - t) S_B + t S_C); the translation in a straight line.

    Shoemake and Duff, Matrix animation and polar decomposition (1992).
    """
    way = _way(start, end, t)
    (first, first_stretch), (last, last_stretch) = polar(way.first), polar(way.last)
    turned = wide.product(first, _turns.power(wide.product(wide.transposed(first), last), way.t))
    return way.pose(wide.product(turned, way.stretched(first_stretch, last_stretch)), way.translation)


def _rigid_as_possible(way: _Way) -> Array:
    """The linear part of `arap`."""
    rotation, stretch = polar(wide.right_quotient(way.last, way.first))
    grown = way.stretched(wide.widen(np.eye(stretch.shape[-2])), stretch)
    return wide.product(_turns.power(rotation, way.t), wide.product(grown, way.first))


def arap(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """R^t ((1 - t) I + t S) L_B, where R S = L_C L_B^-1; the origin moves in a straight line.

    Alexa, Cohen-Or and Levin, As-rigid-as-possible shape interpolation (2000): the origin is the first vertex of the
    standard simplex, which stands for theirs.
    """
    way = _way(start, end, t)
    return way.pose(_rigid_as_possible(way), way.translation)


def rarap(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The linear part of `arap`; the barycentre of the standard simplex 0, e_1, ..., e_n moves in a straight line.

    Rossignac and Vinacua, section 2.4 (b).
    """
    way = _way(start, end, t)
    return way.about_barycentre(_rigid_as_possible(way))


def asap(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """R^t S^t L_B, where R S = L_C L_B^-1; the barycentre of the standard simplex moves in a straight line.

    Rossignac and Vinacua, section 3.3.2; Kaji and others, equation 3, for the linear part.
    """
    way = _way(start, end, t)
    rotation, stretch = polar(wide.right_quotient(way.last, way.first))
    grown = wide.product(symmetric_power(stretch, way.t), way.first)
    return way.about_barycentre(wide.product(_turns.power(rotation, way.t), grown))


def _mixed_turns(way: _Way, first: Array, last: Array) -> Array:
    """The rotation exp((1 - t) log R_B + t log R_C)."""
    return _turns.exponential(_mixed(_turns.logarithm(first), _turns.logarithm(last), way.t[..., None]))


def sumner_2005(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """exp((1 - t) log R_B + t log R_C) ((1 - t) S_B + t S_C); the translation in a straight line.

    Sumner, Zwicker, Gotsman and Popovic, Mesh-based inverse kinematics (2005).
    """
    way = _way(start, end, t)
    (first, first_stretch), (last, last_stretch) = polar(way.first), polar(way.last)
    stretch = way.stretched(first_stretch, last_stretch)
    return way.pose(wide.product(_mixed_turns(way, first, last), stretch), way.translation)


def polar_exponential(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """exp((1 - t) log R_B + t log R_C) exp((1 - t) log S_B + t log S_C); the translation in a straight line.

    Kaji and Ochiai, equation 9, for two poses. In the plane log R is the angle.
    """
    way = _way(start, end, t)
    (first, first_stretch), (last, last_stretch) = polar(way.first), polar(way.last)
    logs = symmetric_logarithm(first_stretch), symmetric_logarithm(last_stretch)
    stretch = symmetric_exponential(way.stretched(*logs))
    return way.pose(wide.product(_mixed_turns(way, first, last), stretch), way.translation)


def _log_scale(stretch: Array) -> Array:
    """log det(S) / dim, the mean of the diagonal of log S."""
    logarithm, size = symmetric_logarithm(stretch), stretch.shape[-2]
    total = _sum(logarithm[..., None, range(size), range(size), :])[..., 0, :]
    return wide.divide(total, wide.widen(np.array(float(size))))


def alexa_2002(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """exp((1 - t) log B + t log C), with the logarithms of `sam.log`.

    Alexa, Linear combination of transformations (2002). Raises InputError, besides, if B or C has no real logarithm.
    """
    way = _way(start, end, t)
    first, last = (_logarithm(name, pose) for name, pose in (("start", way.start), ("end", way.end)))
    moved = affine_exponential(way.stretched(first, last))
    return way.pose(wide.linear_part(moved), wide.translation(moved))


def _logarithm(name: str, pose: Array) -> Array:
    """The logarithm of a pose, as pairs; refuses one that has none."""
    logarithm, existence = affine_logarithm(wide.widen(pose))
    refuse(existence, NONE, name, sam.NO_LOGARITHM, existence.shape)
    return logarithm


def log_spiral(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """(Z_C Z_B^-1)^t Z_B ((1 - t) D_B + t D_C): a spiral of similarities, the rest of the poses in a straight line.

    Z_X is the similarity of the translation of X, rotation R_X and scale det(L_X)^(1/dim); D_X = Z_X^-1 X. Rossignac
    and Vinacua, section 2.4 (c).
    """
    way = _way(start, end, t)
    (first, first_stretch), (last, last_stretch) = polar(way.first), polar(way.last)
    logs = _log_scale(first_stretch), _log_scale(last_stretch)
    log_ratio = wide.subtract(logs[1], logs[0])
    scale = wide.exponential(_mixed(*logs, way.t))
    rest = way.stretched(
        *(
            wide.multiply(stretch, wide.exponential(-log)[..., None, None, :])
            for stretch, log in zip((first_stretch, last_stretch), logs, strict=True)
        )
    )
    turn = _turns.logarithm(wide.product(last, wide.transposed(first)))
    turned = wide.product(_turns.exponential(wide.times(turn, way.t[..., None])), first)
    linear = wide.multiply(wide.product(turned, rest), scale[..., None, None, :])
    moved = spiral(turn, log_ratio, way.t, wide.subtract(way.goal, way.origin))
    return way.pose(linear, wide.add(way.origin, moved))


def three_spiral(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The mean of the spirals of the three sides of the standard triangle 0, e_1, e_2, for poses of the plane, n = 3.

    The similarity that takes a side of the triangle's image under B to that under C, z the complex ratio of the two,
    takes an end p of it to p' by way of p + (z^t - 1) / (z - 1) (p' - p). Each vertex is the mean of where its two sides
    take it. Rossignac and Vinacua, section 2.4 (d), after Whited and others, BetweenIT (2010). A z on the negative axis
    turns by pi.
    """
    way = _way(start, end, t, (3,))
    first, last = (_sides(linear) for linear in (way.first, way.last))
    grown = [progress(*_complex_logarithm(before, after), way.t) for before, after in zip(first, last, strict=True)]
    # A vertex lies between the side that leads to it, the one before it, and the one that leads away.
    vertices = [_halved(grown[i], grown[i - 1]) for i in range(3)]
    origin = wide.subtract(way.goal, way.origin)
    columns = [wide.subtract(way.last[..., j, :], way.first[..., j, :]) for j in range(2)]
    moved = [_turned_by(vertices[0], origin)]
    moved += [
        _turned_by(vertex, wide.add(origin, column)) for vertex, column in zip(vertices[1:], columns, strict=True)
    ]
    steps = [wide.subtract(corner, moved[0]) for corner in moved[1:]]
    linear = wide.add(way.first, np.stack(steps, axis=-2))
    return way.pose(linear, wide.add(way.origin, moved[0]))


def _sides(linear: Array) -> list[Array]:
    """The sides e_1, e_2 - e_1 and -e_2 of the standard triangle's image, (..., 2, 2)."""
    first, second = linear[..., 0, :], linear[..., 1, :]
    return [first, wide.subtract(second, first), -second]


def _complex_logarithm(before: Array, after: Array) -> tuple[Array, Array]:
    """The logarithm of the ratio of two vectors of the plane as complex numbers: of its size, and its angle."""
    x, y = (before[..., k, :] for k in range(2))
    u, v = (after[..., k, :] for k in range(2))
    real, imaginary = complex_product((u, v), (x, -y))
    squares = (wide.add(wide.multiply(p, p), wide.multiply(q, q)) for p, q in ((u, v), (x, y)))
    return 0.5 * wide.logarithm(wide.divide(*squares)), _turns.logarithm(_multiple_of_rotation(real, imaginary))[
        ..., 0, :
    ]


def _multiple_of_rotation(real: Array, imaginary: Array) -> Array:
    """The matrix of a complex number, which multiplies vectors of the plane as that does."""
    return np.stack([np.stack([real, -imaginary], axis=-2), np.stack([imaginary, real], axis=-2)], axis=-3)


def _halved(a: tuple[Array, Array], b: tuple[Array, Array]) -> tuple[Array, Array]:
    """The mean of two complex numbers."""
    return 0.5 * wide.add(a[0], b[0]), 0.5 * wide.add(a[1], b[1])


def _turned_by(factor: tuple[Array, Array], x: Array) -> Array:
    """The product of a complex number and a vector of the plane."""
    return np.stack(complex_product(factor, (x[..., 0, :], x[..., 1, :])), axis=-2)


def lie(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """From B Delta to C Delta as `affine_lie.interpolate_tetrahedra`, Delta the standard simplex 0, e_1, e_2, e_3.

    In the plane the same of its poses in space that leave the third coordinate alone. Bansal and Tatu, equation 4.
    """
    way = _way(start, end, t)
    size = way.start.shape[-1] - 1
    first, last = (_vertices(pose) for pose in (way.start, way.end))
    edges, origin = affine_lie.interpolate_edges(first, last, way.t)
    linear = np.swapaxes(edges, -1, -2)
    return way.pose(wide.widen(linear[..., :size, :size]), wide.widen(origin[..., :size]))


def _vertices(pose: Array) -> tuple[Array, Array]:
    """The edges of the standard simplex's image in space, in rows, (..., 3, 3), and its first vertex (..., 3)."""
    size = pose.shape[-1] - 1
    edges, origin = np.zeros((*pose.shape[:-2], 3, 3)), np.zeros((*pose.shape[:-2], 3))
    edges[..., 2, 2] = 1.0
    edges[..., :size, :size] = np.swapaxes(pose[..., :-1, :-1], -1, -2)
    origin[..., :size] = pose[..., :-1, -1]
    return edges, origin


def sim(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """exp((1 - t) X + t Y) for similarities B and C of space, n = 4: X = `sim3.log`(B), Y = `sim3.log_next`(C, X).

    Gallier, Allen-Blanchette and Leonardos, section 5. B and C stand for the similarities of the nearest rotations,
    which the ends are then. Raises InputError if one is no similarity to within 1e-6.
    """
    way = _way(start, end, t, (4,))
    (first, first_log), (last, last_log) = (
        _turn_and_growth(*pair) for pair in (("start", way.first), ("end", way.last))
    )
    last = _next(last, first)
    turn = _mixed(first, last, way.t[..., None])
    velocities = velocity(first, first_log, way.origin), velocity(last, last_log, way.goal)
    growth = _mixed(first_log, last_log, way.t)
    linear = wide.add(_cross_matrix(turn), wide.multiply(wide.widen(np.eye(3)), growth[..., None, None, :]))
    return wide.rounded(affine_exponential(wide.tangent(linear, _mixed(*velocities, way.t[..., None]))))


def _turn_and_growth(name: str, linear: Array) -> tuple[Array, Array]:
    """The principal rotation vector of a similarity, and the logarithm of its scale; refuses what is none."""
    rotation, stretch = polar(linear)
    log_scale = _log_scale(stretch)
    unit = wide.multiply(stretch, wide.exponential(-log_scale)[..., None, None, :])
    defect = wide.product(unit, unit)[..., 0] - np.eye(3)
    good = (defect * defect).sum(axis=(-2, -1)) <= ORTHOGONALITY**2
    refuse(good.astype(np.float64), 0.0, name, NOT_SIMILAR, good.shape)
    return _turns.logarithm(rotation), log_scale


def _next(turn: Array, previous: Array) -> Array:
    """Of a principal rotation vector and the one of the same rotation the other way round, the one nearer to another.

    The principal one in a tie.
    """
    angle, axis = direction(turn)
    # The middle of the two is at the angle - pi.
    beyond = wide.subtract(wide.subtract(angle, PI), quaternions.inner(axis, previous))[..., 0]
    other = wide.multiply(axis, wide.subtract(angle, TWO_PI)[..., None, :])
    return np.where(((angle[..., 0] > 0.0) & (beyond > ROUNDING))[..., None, None], other, turn)


def _cross_matrix(x: Array) -> Array:
    """The matrices [x] of the vector product with x."""
    x, y, z = np.moveaxis(x, -2, 0)
    zero = np.zeros_like(x)
    rows = ((zero, -z, y), (z, zero, -x), (-y, x, zero))
    return np.stack([np.stack(row, axis=-2) for row in rows], axis=-3)


def _rigid_way(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> _Way:
    """The arguments of a morph of rigid motions of space, their linear parts replaced by the nearest rotations."""
    first, last, time = checked({"start": (4, 4), "end": (4, 4), "t": ()}, (start, end, t))[0]
    for name, pose in (("start", first), ("end", last)):
        _require_last_row(name, pose)
        require_rotation(name, pose[..., :-1, :-1])
    way = _from(first, last, time)
    return way._replace(first=nearest_rotation(first[..., :-1, :-1]), last=nearest_rotation(last[..., :-1, :-1]))


def sclerp(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The screw motion B exp(t log(B^-1 C)) of rigid B and C, n = 4.

    Kavan, Collins, Zara and O'Sullivan, Geometric skinning with approximate dual quaternion blending (2008). B and C
    stand for the rigid motions of the nearest rotations, which the ends are then. Raises InputError if one is no rigid
    motion to within 1e-6.
    """
    way = _rigid_way(start, end, t)
    back = wide.transposed(way.first)
    turn = _turns.logarithm(wide.product(back, way.last))
    there = wide.image(back, wide.subtract(way.goal, way.origin))
    moved = spiral(turn, np.zeros(2), way.t, there)
    linear = wide.product(way.first, _turns.exponential(wide.times(turn, way.t[..., None])))
    return wide.rounded(wide.homogeneous(linear, wide.add(way.origin, wide.image(way.first, moved))))


def dual_quaternion_linear(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The normalised (1 - t) p + t s q of the unit dual quaternions p and q of rigid B and C, n = 4.

    s = -1 if the inner product of their rotations' quaternions is negative, else 1. The quaternion of a rotation has
    w > 0, and w = 0 with the axis that `so3.log` takes. Kavan and others (2008), DLB. B and C as in `sclerp`.
    """
    way = _rigid_way(start, end, t)
    p, q = quaternions.of_rotation(way.first), quaternions.of_rotation(way.last)
    q = np.where((quaternions.inner(p, q)[..., 0] < -ROUNDING)[..., None, None], -q, q)
    real = _mixed(p, q, way.t[..., None])
    # A unit dual quaternion is r + eps v r / 2, v the translation; of the sum v is the vector part of 2 d r* / |r|^2.
    dual = _mixed(quaternions.moved(way.origin, p), quaternions.moved(way.goal, q), way.t[..., None])
    square = quaternions.inner(real, real)[..., None, :]
    translation = wide.divide(quaternions.product(dual, quaternions.conjugate(real))[..., 1:, :], square)
    unit = wide.divide(real, wide.square_root(square))
    return wide.rounded(wide.homogeneous(quaternions.matrix(unit), translation))


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
