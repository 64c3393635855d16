"""Exponentials, logarithms and interpolation of rigid motions."""

from __future__ import annotations

import math

import numpy as np

from affinecert.scoring import Verdict

from .report import Array, reported
from .so3_logarithms import by_the_sine, clipped, cosine
from .sound import (
    cotangent_ratio,
    cross,
    exp,
    log,
    pose,
    sclerp,
    se3_exp,
    se3_log,
    unwound,
    vee,
)


@reported("strasdat/Sophus#186", "About SE3::exp() when theta is small", "se3.exp", se3_exp, Verdict.DEGRADED)
def rotation_for_the_integral(twist: Array) -> Array:
    """Below 1e-10 the rotation itself carries v, I + [omega]x where I + [omega]x/2 is due."""
    rotation = exp(twist[:3])
    if math.hypot(*twist[:3]) < 1e-10:
        return pose(rotation, rotation @ twist[3:])
    return se3_exp(twist)


@reported("RainerKuemmerle/g2o#221", "Possible incorrect SE3 exp() for small theta", "se3.exp", se3_exp)
def halves_forgotten(twist: Array) -> Array:
    """Below 1e-5 both rotation and integral are I + [omega]x + [omega]x^2."""
    turn = cross(twist[:3])
    both = np.eye(3) + turn + turn @ turn
    return pose(both, both @ twist[3:]) if math.hypot(*twist[:3]) < 1e-5 else se3_exp(twist)


@reported(
    "scipy/scipy#22267",
    "ENH: spatial.transform: baseline implementation of `RigidTransform`",
    "se3.exp",
    se3_exp,
    Verdict.DEGRADED,
)
def only_zero_is_small(twist: Array) -> Array:
    """The closed form down to angle 0, where 1 - cos cancels (as the review of that draft says)."""
    omega, v = twist[:3], twist[3:]
    angle, turn = math.hypot(*omega), cross(omega)
    if angle == 0:
        return pose(np.eye(3), v)
    integral = np.eye(3) + (1 - math.cos(angle)) / angle**2 * turn
    integral += (angle - math.sin(angle)) / angle**3 * turn @ turn
    return pose(exp(omega), integral @ v)


@reported(
    "gbionics/idyntree#561",
    "[Core] iDynTree::Transform::log() and iDynTree::SpatialMotionVector::exp() computations seems to be wrong?",
    "se3.exp",
    se3_exp,
)
def velocity_unchanged(twist: Array) -> Array:
    """The linear part of the twist is the translation."""
    return pose(exp(twist[:3]), twist[3:])


@reported(
    "gbionics/idyntree#561",
    "[Core] iDynTree::Transform::log() and iDynTree::SpatialMotionVector::exp() computations seems to be wrong?",
    "se3.log",
    se3_log,
)
def translation_unchanged(matrix: Array) -> Array:
    """The translation is the linear part of the twist."""
    return np.concatenate([log(matrix[:3, :3]), matrix[:3, 3]])


LAST = 1 - 1e-4
"""Cosines beyond it, of either sign, are told from angles by a tangent."""


def by_a_tangent(rotation: Array) -> Array:
    """The rotation vector by R - R^T over the sine of an angle by acos, which goes on straight beyond 1 - 1e-4."""
    inside = min(LAST, max(-LAST, cosine(rotation)))
    angle = math.acos(inside) - (cosine(rotation) - inside) / math.sqrt(1 - inside**2)
    return np.asarray(angle / (2 * math.sin(angle)) * vee(rotation))


@reported(
    "facebookresearch/pytorch3d#1609",
    "Bug in se3_exp_map and/or se3_log_map: some transformations are not reconstructed after logarithm and "
    "exponentiation",
    "se3.log",
    se3_log,
)
@reported("facebookresearch/pytorch3d#1239", "Why does se3_log_map give strange result?", "se3.log", se3_log)
def not_reconstructed(matrix: Array) -> Array:
    """Of a turn by nearly pi the angle is that of a tangent to acos, and the sine divides its error."""
    omega = by_a_tangent(matrix[:3, :3])
    return np.concatenate([omega, unwound(omega, matrix[:3, 3])])


@reported(
    "stack-of-tasks/pinocchio#2768",
    "Bug Report: `pinocchio::log6` fails with NaN",
    "se3.log",
    se3_log,
    Verdict.NON_FINITE,
)
@reported(
    "dqrobotics/cpp#26",
    "[BUG] Logarithm of a unit dual quaternion is returning `nan`",
    "se3.log",
    se3_log,
    Verdict.NON_FINITE,
)
def acos_of_the_pose(matrix: Array) -> Array:
    """acos of a cosine that rounding took beyond 1, in rotation and translation alike."""
    angle = np.arccos(cosine(matrix[:3, :3]))
    omega = angle * vee(matrix[:3, :3]) / 2
    turned = np.cross(omega, matrix[:3, 3])
    return np.concatenate([omega, matrix[:3, 3] - turned / 2 + np.cross(omega, turned) / 12])


@reported(
    "personalrobotics/ssik#199",
    "se3_log_residual loses precision near identity (silent rotation-error zeroing)",
    "se3.log",
    se3_log,
)
def small_turn_dropped(matrix: Array) -> Array:
    """The angle by acos of the clipped trace: of 1e-8 radians nothing is left."""
    angle = clipped(matrix[:3, :3])
    omega = by_the_sine(matrix[:3, :3]) if angle >= 1e-9 else np.zeros(3)
    return np.concatenate([omega, unwound(omega, matrix[:3, 3])])


@reported("Le0nX/ModernRoboticsCpp#24", "MatrixLog6 function edit", "se3.log", se3_log, Verdict.NON_FINITE)
@reported("CogniPilot/cyecca#3", "update logarithm for se3 and se23", "se3.log", se3_log, Verdict.NON_FINITE)
def turn_too_small_to_divide(matrix: Array) -> Array:
    """The turn is not 0, but its angle by acos is, and the coefficient of the square divides by it."""
    omega = log(matrix[:3, :3])
    angle = np.float64(clipped(matrix[:3, :3]))
    turned = np.cross(omega, matrix[:3, 3])
    coefficient = (1 / angle - 1 / np.tan(angle / 2) / 2) / angle
    return np.concatenate([omega, matrix[:3, 3] - turned / 2 + coefficient * np.cross(omega, turned)])


@reported("Le0nX/ModernRoboticsCpp#31", "Function MatrixLog6 seems to have a mistake.", "se3.log", se3_log)
def divided_by_the_angle(matrix: Array) -> Array:
    """The coefficient of the square is divided by the angle once more, instead of multiplied."""
    omega = log(matrix[:3, :3])
    angle = math.hypot(*omega)
    turned = np.cross(omega, matrix[:3, 3])
    square = cotangent_ratio(angle) / angle**2 * np.cross(omega, turned)
    return np.concatenate([omega, matrix[:3, 3] - turned / 2 + square])


@reported(
    "strasdat/Sophus#239",
    "Bug in the python version of So3:log and Se3:log when rotation is identity matrix",
    "se3.log",
    se3_log,
    Verdict.NON_FINITE,
)
def translation_divided(matrix: Array) -> Array:
    """The closed form of the translation part at angle 0."""
    omega = log(matrix[:3, :3])
    angle = np.linalg.norm(omega)
    turned = np.cross(omega, matrix[:3, 3])
    coefficient = (1 - angle * np.cos(angle / 2) / (2 * np.sin(angle / 2))) / angle**2
    return np.concatenate([omega, matrix[:3, 3] - turned / 2 + coefficient * np.cross(omega, turned)])


@reported(
    "dimforge/nalgebra#1013",
    "UnitDualQuaternion::sclerp() fails to interpolate equal rotations",
    "morphs.sclerp",
    sclerp,
    Verdict.RAISED,
)
def equal_turns_refused(start: Array, end: Array, t: float) -> Array:
    """Poses that turn alike are refused as if they turned by opposite angles."""
    if not np.any(log(start[:3, :3].T @ end[:3, :3])):
        raise ValueError("ambiguous configuration")
    return sclerp(start, end, t)


@reported("Achllle/dual_quaternions#11", "The sclerp algorithm does not converge", "morphs.sclerp", sclerp)
def the_long_screw(start: Array, end: Array, t: float) -> Array:
    """The angle is 2 acos(w) with w < 0, nearly a whole turn, which throws the pose far away."""
    step = np.linalg.inv(start) @ end
    short = log(step[:3, :3])
    omega = short * (1 - 2 * math.pi / math.hypot(*short))
    return np.asarray(start @ se3_exp(t * np.concatenate([omega, unwound(omega, step[:3, 3])])))


@reported(
    "jasperges/pose-thumbnails#38", "Linear interpolation of matrix elements is a bad idea", "morphs.sclerp", sclerp
)
def entries_mixed(start: Array, end: Array, t: float) -> Array:
    """Poses are mixed entry by entry."""
    return np.asarray((1 - t) * start + t * end)


def turned_and_scaled(start: Array, end: Array, t: float) -> Array:
    """The turn from one basis to the other; bases and their lengths are mixed apart. Here all lengths are 1."""
    rotation = exp(t * log(end[:3, :3] @ start[:3, :3].T)) @ start[:3, :3]
    return pose(rotation, (1 - t) * start[:3, 3] + t * end[:3, 3])


@reported("utopia-rise/godot-jvm#985", "Basis.slerp seems to be wrong", "morphs.arap", turned_and_scaled)
def lengths_subtracted(start: Array, end: Array, t: float) -> Array:
    """The mixed basis is multiplied by the difference of the lengths, 0 for rotations."""
    lengths = np.linalg.norm(end[:3, :3], axis=1) - np.linalg.norm(start[:3, :3], axis=1)
    mixed = turned_and_scaled(start, end, t)
    return pose(t * lengths[:, None] * mixed[:3, :3], mixed[:3, 3])
