"""Morphs: factors in the wrong order, the quotient on the wrong side, angles beyond pi, and one morph for another."""

from __future__ import annotations

import numpy as np

from affinecert.fast import affine_lie, morphs, sam, se3, sim3, so3

from .defect import Array, block, column, homogeneous, parts, seeded


def polar(linear: Array) -> tuple[Array, Array]:
    """Rotation and stretch, by singular values."""
    left, values, right = np.linalg.svd(linear)
    return left @ right, np.swapaxes(right, -1, -2) * values[:, None, :] @ right


def transposed(matrix: Array) -> Array:
    return np.swapaxes(matrix, -1, -2)


def angle(rotation: Array) -> Array:
    """The angles of rotations of the plane."""
    return np.arctan2(rotation[:, 1, 0], rotation[:, 0, 0])


def turn(angles: Array) -> Array:
    """The rotations of the plane by angles."""
    cosine, sine = np.cos(angles), np.sin(angles)
    return np.stack([cosine, -sine, sine, cosine], axis=-1).reshape(-1, 2, 2)


def power(rotation: Array, t: Array) -> Array:
    """The powers of rotations of the plane."""
    return turn(angle(rotation) * t)


def mixed(first: Array, last: Array, t: Array) -> Array:
    """(1 - t) first + t last, of vectors or of matrices."""
    times_of = column if first.ndim == 2 else block
    return np.asarray(times_of(1 - t) * first + times_of(t) * last)


def straight(start: Array, end: Array, t: Array) -> Array:
    """The translation in a straight line."""
    return mixed(parts(start)[1], parts(end)[1], t)


def about(point: Array, start: Array, end: Array, t: Array, linear: Array) -> Array:
    """The poses of those linear parts that move a point in a straight line."""
    first, last = (parts(pose)[0] @ point + parts(pose)[1] for pose in (start, end))
    return homogeneous(linear, mixed(first, last, t) - linear @ point)


def quotient(start: Array, end: Array) -> Array:
    """The linear parts of C B^-1."""
    return np.asarray(parts(end)[0] @ np.linalg.inv(parts(start)[0]))


@seeded("morphs.linear", "generic-2d")
def from_end_to_start(start: Array, end: Array, t: Array) -> Array:
    """t B + (1 - t) C."""
    return mixed(end, start, t)


@seeded("morphs.linear", "extrapolation-2d")
def time_clamped(start: Array, end: Array, t: Array) -> Array:
    """Times outside [0, 1] are taken for its ends."""
    return mixed(start, end, np.clip(t, 0.0, 1.0))


@seeded("morphs.shoemake_duff", "generic-2d")
def stretched_after_turning(start: Array, end: Array, t: Array) -> Array:
    """S R for R S."""
    (first, first_stretch), (last, last_stretch) = polar(parts(start)[0]), polar(parts(end)[0])
    turned = first @ power(transposed(first) @ last, t)
    return homogeneous(mixed(first_stretch, last_stretch, t) @ turned, straight(start, end, t))


@seeded("morphs.shoemake_duff", "generic-2d")
def rotations_in_a_straight_line(start: Array, end: Array, t: Array) -> Array:
    """The entries of the rotations are interpolated."""
    (first, first_stretch), (last, last_stretch) = polar(parts(start)[0]), polar(parts(end)[0])
    return homogeneous(mixed(first, last, t) @ mixed(first_stretch, last_stretch, t), straight(start, end, t))


@seeded("morphs.shoemake_duff", "near-pi-2d")
def angles_beyond_pi(start: Array, end: Array, t: Array) -> Array:
    """The angle goes from that of B to that of C, be it the long way."""
    (first, first_stretch), (last, last_stretch) = polar(parts(start)[0]), polar(parts(end)[0])
    turned = turn((1 - t) * (angle(first) % (2 * np.pi)) + t * (angle(last) % (2 * np.pi)))
    return homogeneous(turned @ mixed(first_stretch, last_stretch, t), straight(start, end, t))


@seeded("morphs.arap", "generic-2d")
def quotient_from_the_left(start: Array, end: Array, t: Array) -> Array:
    """L_B R^t ((1 - t) I + t S) with R S = L_B^-1 L_C."""
    first, last = parts(start)[0], parts(end)[0]
    rotation, stretch = polar(np.linalg.solve(first, last))
    grown = mixed(np.broadcast_to(np.eye(2), stretch.shape), stretch, t)
    return homogeneous(first @ power(rotation, t) @ grown, straight(start, end, t))


@seeded("morphs.arap", "generic-2d")
def turned_before_it_is_stretched(start: Array, end: Array, t: Array) -> Array:
    """((1 - t) I + t S) R^t for R^t ((1 - t) I + t S)."""
    rotation, stretch = polar(quotient(start, end))
    grown = mixed(np.broadcast_to(np.eye(2), stretch.shape), stretch, t)
    return homogeneous(grown @ power(rotation, t) @ parts(start)[0], straight(start, end, t))


@seeded("morphs.arap", "generic-3d")
def start_forgotten(start: Array, end: Array, t: Array) -> Array:
    """R^t ((1 - t) I + t S) of the end alone."""
    whole = np.broadcast_to(np.eye(4), start.shape)
    return np.asarray(morphs.arap(whole, end, t))


@seeded("morphs.rarap", "generic-2d")
def mean_without_the_origin(start: Array, end: Array, t: Array) -> Array:
    """The mean of e_1 and e_2 for the barycentre of the simplex."""
    return about(np.array([0.5, 0.5]), start, end, t, parts(morphs.arap(start, end, t))[0])


@seeded("morphs.rarap", "generic-3d")
def origin_in_a_straight_line(start: Array, end: Array, t: Array) -> Array:
    """The origin instead of the barycentre moves straight."""
    return np.asarray(morphs.arap(start, end, t))


@seeded("morphs.asap", "generic-2d")
def stretch_in_a_straight_line(start: Array, end: Array, t: Array) -> Array:
    """(1 - t) I + t S for S^t."""
    return np.asarray(morphs.rarap(start, end, t))


@seeded("morphs.asap", "generic-2d")
def powers_of_the_entries(start: Array, end: Array, t: Array) -> Array:
    """S^t entry by entry."""
    rotation, stretch = polar(quotient(start, end))
    grown = np.sign(stretch) * np.abs(stretch) ** block(t)
    return about(np.array([1 / 3, 1 / 3]), start, end, t, power(rotation, t) @ grown @ parts(start)[0])


@seeded("morphs.alexa_2002", "generic-2d")
def steady(start: Array, end: Array, t: Array) -> Array:
    """exp(t log(C B^-1)) B, which is the same only if B and C commute."""
    return np.asarray(sam.morph(start, end, t))


@seeded("morphs.alexa_2002", "generic-3d")
def translation_apart(start: Array, end: Array, t: Array) -> Array:
    """The logarithms of the linear parts, and the translation in a straight line."""
    first, last = (homogeneous(parts(pose)[0], 0 * parts(pose)[1]) for pose in (start, end))
    return homogeneous(parts(morphs.alexa_2002(first, last, t))[0], straight(start, end, t))


@seeded("morphs.sumner_2005", "generic-3d")
def relative_rotation(start: Array, end: Array, t: Array) -> Array:
    """R_B (R_B^T R_C)^t for exp of the mixed logarithms."""
    return np.asarray(morphs.shoemake_duff(start, end, t))


@seeded("morphs.sumner_2005", "generic-3d")
def product_of_powers(start: Array, end: Array, t: Array) -> Array:
    """R_B^(1 - t) R_C^t, as if they commuted."""
    (first, first_stretch), (last, last_stretch) = polar(parts(start)[0]), polar(parts(end)[0])
    turned = so3.exp(column(1 - t) * so3.log(first)) @ so3.exp(column(t) * so3.log(last))
    return homogeneous(turned @ mixed(first_stretch, last_stretch, t), straight(start, end, t))


def similarities(pose: Array, exponent: float) -> Array:
    """The similarities of translation, rotation and scale det(L)^exponent of poses of the plane."""
    linear, translation = parts(pose)
    return homogeneous(block(np.linalg.det(linear) ** exponent) * polar(linear)[0], translation)


@seeded("morphs.log_spiral", "generic-2d")
def residue_from_the_right(start: Array, end: Array, t: Array) -> Array:
    """D_X = X Z_X^-1, applied after the similarity."""
    first, last = similarities(start, 0.5), similarities(end, 0.5)
    rest = mixed(start @ np.linalg.inv(first), end @ np.linalg.inv(last), t)
    return np.asarray(rest @ sam.morph(first, last, t))


@seeded("morphs.log_spiral", "generic-2d")
def area_for_scale(start: Array, end: Array, t: Array) -> Array:
    """det(L) for its square root."""
    first, last = similarities(start, 1.0), similarities(end, 1.0)
    return np.asarray(sam.morph(first, last, t) @ mixed(np.linalg.solve(first, start), np.linalg.solve(last, end), t))


def by_sides(start: Array, end: Array, t: Array, shares: tuple[float, float], scaled: bool = True) -> Array:
    """The three spirals, each vertex with those shares of the side that leads away and of the one before."""
    first, last = (
        np.stack([z[:, 2], z[:, 2] + z[:, 0], z[:, 2] + z[:, 1]])
        for z in (x[:, 0] + 1j * x[:, 1] for x in (start, end))
    )
    ratio = (np.roll(last, -1, axis=0) - last) / (np.roll(first, -1, axis=0) - first)
    grown = ratio**t if scaled else (1 - t + t * np.abs(ratio)) * np.exp(1j * t * np.angle(ratio))
    share = (grown - 1) / (ratio - 1)
    corners = first + (shares[0] * share + shares[1] * np.roll(share, 1, axis=0)) * (last - first)
    columns = np.stack([corners[1] - corners[0], corners[2] - corners[0]], axis=-1)
    return homogeneous(
        np.stack([columns.real, columns.imag], axis=1), np.stack([corners[0].real, corners[0].imag], axis=-1)
    )


@seeded("morphs.three_spiral", "generic-2d")
def one_side_a_vertex(start: Array, end: Array, t: Array) -> Array:
    """Each vertex follows only the side that leads away from it."""
    return by_sides(start, end, t, (1.0, 0.0))


@seeded("morphs.three_spiral", "generic-2d")
def scale_in_a_straight_line(start: Array, end: Array, t: Array) -> Array:
    """(1 - t + t |z|) e^(i t arg z) for z^t."""
    return by_sides(start, end, t, (0.5, 0.5), scaled=False)


@seeded("morphs.lie", "generic-3d")
def quotient_interpolated(start: Array, end: Array, t: Array) -> Array:
    """The affine map C B^-1 is interpolated by equation 2, and applied to B."""
    return np.asarray(affine_lie.interpolate(end @ np.linalg.inv(start), t) @ start)


@seeded("morphs.lie", "generic-3d")
def other_order_of_the_vertices(start: Array, end: Array, t: Array) -> Array:
    """The coordinates are cycled, which changes what is aligned first."""
    cycle = np.eye(4)[[1, 2, 0, 3]]
    return np.asarray(morphs.lie(start @ cycle, end @ cycle, t) @ cycle.T)


@seeded("morphs.polar_exponential", "generic-3d")
def stretch_mixed_linearly(start: Array, end: Array, t: Array) -> Array:
    """(1 - t) S_B + t S_C for the exponential of the mixed logarithms."""
    return np.asarray(morphs.sumner_2005(start, end, t))


@seeded("morphs.polar_exponential", "generic-2d")
def stretch_from_the_left(start: Array, end: Array, t: Array) -> Array:
    """S R for R S."""
    linear, translation = parts(morphs.polar_exponential(start, end, t))
    rotation, stretch = polar(linear)
    return homogeneous(stretch @ rotation, translation)


@seeded("morphs.sim", "one-pose-near-pi-3d")
def principal_logarithms(start: Array, end: Array, t: Array) -> Array:
    """The principal logarithm of C, however far from that of B."""
    return np.asarray(sim3.exp(mixed(sim3.log(start), sim3.log(end), t)))


@seeded("morphs.sim", "generic-3d")
def product_of_exponentials(start: Array, end: Array, t: Array) -> Array:
    """exp(t Y) exp((1 - t) X), as if they commuted."""
    first = sim3.log(start)
    last = sim3.log_next(end, first)
    return np.asarray(sim3.exp(column(t) * last) @ sim3.exp(column(1 - t) * first))


@seeded("morphs.sclerp", "generic-3d")
def motion_of_the_world(start: Array, end: Array, t: Array) -> Array:
    """B exp(t log(C B^-1)) for B exp(t log(B^-1 C))."""
    return np.asarray(start @ se3.exp(column(t) * se3.log(end @ np.linalg.inv(start))))


@seeded("morphs.sclerp", "generic-3d")
def translation_in_a_straight_line(start: Array, end: Array, t: Array) -> Array:
    """The rotation of the screw, the translation straight."""
    return homogeneous(parts(morphs.sclerp(start, end, t))[0], straight(start, end, t))


def quaternion(rotation: Array) -> Array:
    """The unit quaternions of rotation vectors."""
    omega = so3.log(rotation)
    half = column(np.linalg.norm(omega, axis=-1)) / 2
    return np.concatenate([np.cos(half), omega * np.sinc(half / np.pi) / 2], axis=-1)


def product(p: Array, q: Array) -> Array:
    """The quaternion products."""
    scalar = p[:, 0] * q[:, 0] - np.sum(p[:, 1:] * q[:, 1:], axis=-1)
    vector = p[:, :1] * q[:, 1:] + q[:, :1] * p[:, 1:] + np.cross(p[:, 1:], q[:, 1:])
    return np.concatenate([column(scalar), vector], axis=-1)


def by_dual_quaternions(start: Array, end: Array, t: Array, sign: Array, power_of_length: int) -> Array:
    """The mixed dual quaternions, the dual part divided by a power of the length of the real one."""
    real, dual = [], []
    for pose, weight in ((start, 1 - t), (end, t * sign)):
        linear, translation = parts(pose)
        real.append(column(weight) * quaternion(linear))
        dual.append(product(np.pad(translation, ((0, 0), (1, 0))) / 2, real[-1]))
    length = column(np.linalg.norm(sum(real), axis=-1))
    unit = sum(real) / length
    way = 2 * product(sum(dual) / length**power_of_length, unit * np.array([1.0, -1.0, -1.0, -1.0]))[:, 1:]
    w, x, y, z = unit.T
    omega = 2 * column(np.arctan2(np.linalg.norm(unit[:, 1:], axis=-1), w))
    axis = unit[:, 1:] / column(np.linalg.norm(np.stack([x, y, z]), axis=0))
    return homogeneous(so3.exp(omega * axis), way)


@seeded("morphs.dual_quaternion_linear", "near-pi-3d")
def sign_forgotten(start: Array, end: Array, t: Array) -> Array:
    """q is taken as it is, also where -q is nearer."""
    return by_dual_quaternions(start, end, t, np.ones_like(t), 1)


@seeded("morphs.dual_quaternion_linear", "generic-3d")
def dual_part_not_normalised(start: Array, end: Array, t: Array) -> Array:
    """Only the real part is divided by its length."""
    inner = np.sum(quaternion(parts(start)[0]) * quaternion(parts(end)[0]), axis=-1)
    return by_dual_quaternions(start, end, t, np.where(inner < 0.0, -1.0, 1.0), 0)
