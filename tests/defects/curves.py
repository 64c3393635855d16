"""Curves through poses: conjugations on the wrong side, factors in the wrong order, and listings misread."""

from __future__ import annotations

import numpy as np

from affinecert.fast import affine_lie, curves, sam, se3, shear

from .defect import Array, block, column, homogeneous, parts, seeded, times


def segment(t: Array, keys: Array) -> tuple[Array, Array]:
    """The segments that hold the times, and the times since their starts."""
    index = np.clip(np.floor(t), 0, keys.shape[1] - 2).astype(int)
    return index, t - index


def pair(keys: Array, index: Array) -> tuple[Array, Array]:
    """The keys at the two ends of the segments."""
    items = np.arange(len(keys))
    return keys[items, index], keys[items, index + 1]


def algebra(twist: Array) -> Array:
    """The matrices of shear twists (N, 5)."""
    matrix = np.zeros((len(twist), 3, 3))
    matrix[:, [0, 1, 0, 1, 2], [1, 1, 2, 2, 2]] = twist
    return matrix


def coordinates(matrix: Array) -> Array:
    """The shear twists of matrices."""
    return matrix[:, [0, 1, 0, 1, 2], [1, 1, 2, 2, 2]]


def triangular(matrix: Array) -> Array:
    """The matrices in the exact form of shears."""
    form = np.triu(matrix)
    form[:, 0, 0] = 1.0
    return form


def sheared(shears: Array, t: Array, inwards: float, bends: float) -> Array:
    """The curve through shears with B_(i+1) = exp(-inwards C) B exp(inwards C) + bends C."""
    index, time = segment(t, shears)
    steps = np.linalg.inv(shears[:, :-1]) @ shears[:, 1:]
    rate = shear.log(triangular(steps[:, 0]))
    bend = np.zeros_like(rate)
    rates, curvatures = [rate], [bend]
    for i in range(1, shears.shape[1] - 1):
        turn = shear.exp(inwards * bend)
        carried = coordinates(np.linalg.inv(turn) @ algebra(rate) @ turn)
        rate = carried + bends * bend
        bend = shear.log(triangular(shear.exp(-rate) @ steps[:, i]))
        rates.append(rate)
        curvatures.append(bend)
    items = np.arange(len(t))
    b, c = np.stack(rates, axis=1)[items, index], np.stack(curvatures, axis=1)[items, index]
    moved: Array = shears[items, index] @ shear.exp(column(time) * b) @ shear.exp(column(time**2) * c)
    return moved


@seeded("curves.shear_curve", "generic")
def velocity_not_carried_along(shears: Array, t: Array) -> Array:
    """B + 2 C, without the conjugation: the velocity in the frame where the bend began."""
    return sheared(shears, t, 0.0, 2.0)


@seeded("curves.shear_curve", "generic")
def conjugated_the_other_way(shears: Array, t: Array) -> Array:
    """exp(C) B exp(-C) for exp(-C) B exp(C)."""
    return sheared(shears, t, -1.0, 2.0)


@seeded("curves.shear_curve", "generic")
def derivative_of_the_square_forgotten(shears: Array, t: Array) -> Array:
    """B + C for B + 2 C."""
    return sheared(shears, t, 1.0, 1.0)


@seeded("curves.scale_curve", "generic")
def scales_in_straight_lines(scales: Array, t: Array) -> Array:
    """Powers from each scale to the next, with a kink at every key."""
    index, time = segment(t, scales)
    start, end = pair(scales, index)
    return np.asarray(start * (end / start) ** time)


@seeded("curves.scale_curve", "at-keys")
def time_of_the_whole_curve(scales: Array, t: Array) -> Array:
    """The curve is thought to run from 0 to 1."""
    return np.asarray(curves.scale_curve(scales, t * (scales.shape[1] - 1)))


@seeded("curves.rigid_curve", "generic")
def screws_one_after_another(poses: Array, t: Array) -> Array:
    """The screw motion from each pose to the next, with a jump of velocity at every key."""
    index, time = segment(t, poses)
    start, end = pair(poses, index)
    return np.asarray(start @ se3.exp(column(time) * se3.log(np.linalg.inv(start) @ end)))


@seeded("curves.rigid_curve", "generic")
def rotation_and_translation_apart(poses: Array, t: Array) -> Array:
    """The rotation as it should be, the translation in straight lines."""
    index, time = segment(t, poses)
    start, end = pair(poses, index)
    moved = np.array(curves.rigid_curve(poses, t))
    moved[:, :3, 3] = column(1 - time) * start[:, :3, 3] + column(time) * end[:, :3, 3]
    return moved


@seeded("curves.rigid_curve", "off-manifold")
def rotations_as_they_are(poses: Array, t: Array) -> Array:
    """Keys that are nearly rotations are given back as they are at the first key."""
    return np.where(block(t) < 1.0, poses[:, 0], np.asarray(curves.rigid_curve(poses, t)))


def three_curves(affines: Array, t: Array) -> tuple[Array, Array, Array]:
    """The points on the curves of the rigid, the shear and the scale factors, as (N, 4, 4)."""
    factors = affine_lie.decompose(affines)
    zero = np.zeros((len(t), 3))
    bent = homogeneous(np.asarray(curves.shear_curve(factors.shear, t)), zero)
    grown = homogeneous(block(curves.scale_curve(factors.scale, t)) * np.eye(3), zero)
    return np.asarray(curves.rigid_curve(factors.rigid, t)), bent, grown


@seeded("curves.affine_curve", "generic")
def printed_order(affines: Array, t: Array) -> Array:
    """E S A, as the paper prints the product of the three curves."""
    rigid, bent, grown = three_curves(affines, t)
    return rigid @ grown @ bent


@seeded("curves.affine_curve", "generic")
def pair_by_pair(affines: Array, t: Array) -> Array:
    """T_i exp(t log A) exp(t log S) exp(t log E) with T_i^-1 T_(i+1) = A S E, segment by segment."""
    index, time = segment(t, affines)
    start, end = pair(affines, index)
    return np.asarray(start @ affine_lie.interpolate(np.linalg.inv(start) @ end, time))


@seeded("curves.subdivided_curve", "generic")
def not_subdivided(affines: Array, t: Array) -> Array:
    """The curve through the keys alone."""
    return np.asarray(curves.affine_curve(affines, t))


@seeded("curves.subdivided_curve", "generic")
def time_not_doubled(affines: Array, t: Array) -> Array:
    """The refined keys at the times 0, 1, 2, ..., as if there were no more of them."""
    return np.asarray(curves.subdivided_curve(affines, t / 2))


@seeded("curves.poly_sam", "generic-2d")
def one_segment_late(poses: Array, t: Array) -> Array:
    """The segments are counted from 1."""
    index = np.clip(np.floor(t) + 1, 0, poses.shape[1] - 2).astype(int)
    return np.asarray(sam.morph(*pair(poses, index), t - index))


@seeded("curves.poly_sam", "extrapolation-2d")
def time_clamped(poses: Array, t: Array) -> Array:
    """Beyond the keys the curve stands still."""
    return np.asarray(curves.poly_sam(poses, np.clip(t, 0.0, poses.shape[1] - 1)))


@seeded("curves.bezier_quadratic", "generic-2d")
def entries_by_de_casteljau(pose_a: Array, pose_b: Array, pose_c: Array, t: Array) -> Array:
    """The quadratic Bezier curve of each entry."""
    weight = block(t)
    return np.asarray((1 - weight) ** 2 * pose_a + 2 * weight * (1 - weight) * pose_b + weight**2 * pose_c)


@seeded("curves.bezier_quadratic", "generic-3d")
def last_morph_backwards(pose_a: Array, pose_b: Array, pose_c: Array, t: Array) -> Array:
    """The morph between the two legs is run at 1 - t."""
    return np.asarray(sam.morph(sam.morph(pose_a, pose_b, t), sam.morph(pose_b, pose_c, t), 1 - t))


@seeded("curves.bezier_cubic", "generic-2d")
def middle_control_twice(pose_a: Array, pose_b: Array, pose_c: Array, pose_d: Array, t: Array) -> Array:
    """The second quadratic curve is of B, B, D."""
    first, second = (
        curves.bezier_quadratic(pose_a, pose_b, pose_c, t),
        curves.bezier_quadratic(pose_b, pose_b, pose_d, t),
    )
    return np.asarray(sam.morph(first, second, t))


@seeded("curves.bezier_cubic", "generic-2d")
def morph_of_quadratics_by_entries(pose_a: Array, pose_b: Array, pose_c: Array, pose_d: Array, t: Array) -> Array:
    """The last step is a mean of entries."""
    first, second = (
        curves.bezier_quadratic(pose_a, pose_b, pose_c, t),
        curves.bezier_quadratic(pose_b, pose_c, pose_d, t),
    )
    return np.asarray((1 - block(t)) * first + block(t) * second)


def arcs(pose_a: Array, pose_b: Array, pose_c: Array, t: Array, left: Array, right: Array) -> Array:
    """The two quadratic curves of a biarc with the control poses given."""
    first = block(t) <= 0.5
    poses = np.where(first, pose_a, pose_b), np.where(first, left, right), np.where(first, pose_b, pose_c)
    return np.asarray(curves.bezier_quadratic(*poses, np.where(t <= 0.5, 2 * t, 2 * t - 1)))


@seeded("curves.biarc", "generic-2d")
def image_taken_for_a_product(pose_a: Array, pose_b: Array, pose_c: Array, t: Array) -> Array:
    """SAM(F_X, F_A, t, F_B) read as the product of the pose SAM(F_A, t, F_B) and F_X."""
    left = sam.morph(pose_c, pose_b, 0.25) @ sam.morph(pose_a, pose_b, 0.75)
    right = sam.morph(pose_a, pose_b, 0.25) @ sam.morph(pose_c, pose_b, 0.75)
    return arcs(pose_a, pose_b, pose_c, t, left, right)


@seeded("curves.biarc", "generic-2d")
def three_quarters_along_the_legs(pose_a: Array, pose_b: Array, pose_c: Array, t: Array) -> Array:
    """Control poses on the legs, which makes a corner at B."""
    left, right = sam.morph(pose_a, pose_b, 0.75), sam.morph(pose_c, pose_b, 0.75)
    return arcs(pose_a, pose_b, pose_c, t, left, right)


@seeded("curves.biarc", "regular-2d")
def halves_not_rescaled(pose_a: Array, pose_b: Array, pose_c: Array, t: Array) -> Array:
    """The first half is run at t for 2 t."""
    return np.asarray(curves.biarc(pose_a, pose_b, pose_c, np.where(t <= 0.5, t / 2, t)))


def with_inserted(poses: Array, inserted: Array) -> Array:
    """The poses with others between them."""
    refined = np.empty((len(poses), 2 * poses.shape[1] - 1, *poses.shape[2:]))
    refined[:, ::2], refined[:, 1::2] = poses, inserted
    return refined


@seeded("curves.four_point", "generic-2d")
def half_way_between_neighbours(poses: Array) -> Array:
    """The new poses are half way from one to the next."""
    return with_inserted(poses, np.asarray(sam.morph(poses[:, :-1], poses[:, 1:], 0.5)))


@seeded("curves.four_point", "generic-2d")
def left_prediction_alone(poses: Array) -> Array:
    """Inner spans take the prediction from the left for the mean of two."""
    refined = np.array(curves.four_point(poses))
    for i in range(1, poses.shape[1] - 2):
        refined[:, 2 * i + 1] = curves.four_point(poses[:, i:])[:, 1]
    return refined


@seeded("curves.patch", "generic-2d")
def parameters_swapped(pose_a: Array, pose_b: Array, pose_c: Array, pose_d: Array, s: Array, t: Array) -> Array:
    """The columns first, then the rows."""
    return np.asarray(curves.patch(pose_a, pose_c, pose_b, pose_d, t, s))


@seeded("curves.patch", "generic-2d")
def corners_in_a_ring(pose_a: Array, pose_b: Array, pose_c: Array, pose_d: Array, s: Array, t: Array) -> Array:
    """The corners are taken in the order A, B, D, C."""
    return np.asarray(curves.patch(pose_a, pose_b, pose_d, pose_c, s, t))


@seeded("curves.regular_pattern", "generic-2d")
def one_step_short(start: Array, end: Array) -> Array:
    """The steps are counted as the poses are."""
    steps = np.arange(curves.COPIES + 1.0) / (curves.COPIES + 1)
    return np.asarray(sam.morph(start[:, None], end[:, None], steps))


@seeded("curves.regular_pattern", "generic-3d")
def steps_on_the_other_side(start: Array, end: Array) -> Array:
    """B (C B⁻¹)^(k/n) for (C B⁻¹)^(k/n) B."""
    steps = np.arange(curves.COPIES + 1.0) / curves.COPIES
    quotient = end @ np.linalg.inv(start)
    quotient[:, -1] = end[:, -1]
    return np.asarray(start[:, None] @ sam.power(quotient[:, None], steps))


@seeded("curves.grazing_parameter", "generic-2d")
def printed_sign(affine: Array, point: Array, tangent: Array, normal: Array) -> Array:
    """Equation 8 as it is printed, without the sign."""
    return -np.asarray(curves.grazing_parameter(affine, point, tangent, normal))


@seeded("curves.grazing_parameter", "generic-3d")
def origin_taken_to_be_fixed(affine: Array, point: Array, tangent: Array, normal: Array) -> Array:
    """log(L) q for the velocity at q, as equation 8 has it."""
    return np.asarray(curves.grazing_parameter(homogeneous(parts(affine)[0], 0 * point), point, tangent, normal))


@seeded("curves.grazing_parameter", "generic-2d")
def displacement_for_velocity(affine: Array, point: Array, tangent: Array, normal: Array) -> Array:
    """The point whose displacement A p - p, not whose velocity, is along the line."""
    linear, translation = parts(affine)
    across = np.sum(normal * (times(linear, point) + translation - point), axis=-1)
    return np.asarray(-across / np.sum(normal * (times(linear, tangent) - tangent), axis=-1))
