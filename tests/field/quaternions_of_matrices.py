"""Rotation vectors by way of the quaternion: signs, pivots, and the choice between q and -q."""

from __future__ import annotations

import math

import numpy as np

from affinecert.scoring import Verdict

from .report import Array, reported
from .sound import log, proper, quaternion, shortest, vee


def real_part(rotation: Array) -> float:
    """The quaternion's real part by the trace."""
    return math.sqrt(max(0.0, float(1 + np.trace(rotation)))) / 2


def sizes(rotation: Array) -> Array:
    """The sizes of the quaternion's imaginary parts, by the diagonal."""
    return np.asarray(np.sqrt(np.maximum(1 + 2 * np.diag(rotation) - np.trace(rotation), 0)) / 2)


def any_angle(q: Array) -> Array:
    """2 atan2(|v|, w) v/|v|, beyond pi where w is negative."""
    sine = math.hypot(*q[1:])
    return np.asarray(2 * math.atan2(sine, q[0]) / sine * q[1:])


@reported("decargroup/pymlg#23", "Division by zero in SO3.to_quat()", "so3.log", log, Verdict.RAISED)
def divided_by_the_real_part(rotation: Array) -> Array:
    """The imaginary part is R - R^T over 4 w, and w is 0 for a half turn."""
    w = real_part(rotation)
    return shortest(np.array([w, *(x / (4 * w) for x in vee(rotation).tolist())]))


@reported(
    "modelica/ModelicaStandardLibrary#3588",
    "Quaternions.from_T returns error for valid matrix",
    "so3.log",
    log,
    Verdict.RAISED,
)
def root_of_the_trace(rotation: Array) -> Array:
    """An assertion that 1 + tr R is positive, though there are four pivots to choose from."""
    if 1 + np.trace(rotation) <= 0:
        raise ValueError("the trace is -1")
    return log(rotation)


@reported(
    "ebassi/graphene#287", "graphene_quaternion_init_from_matrix not handling case when trace is -1", "so3.log", log
)
@reported("sgorsten/linalg#8", "rotation_quat fails in some cases", "so3.log", log)
@reported(
    "facebookresearch/pytorch3d#646", "Sign issue about quaternion_to_matrix and matrix_to_quaternion", "so3.log", log
)
def signs_copied(rotation: Array) -> Array:
    """Four roots, and signs copied from R - R^T: all positive for a half turn."""
    return shortest(np.array([real_part(rotation), *np.copysign(sizes(rotation), vee(rotation))]))


@reported(
    "orocos/orocos_kinematics_dynamics#32",
    "Fixes GetQuaternion non-zero matrix trace check",
    "so3.log",
    log,
    Verdict.DEGRADED,
)
def trace_plus_one(rotation: Array) -> Array:
    """Divides by w as long as 1 + tr R is above 1e-12, where w is made of rounding."""
    if 1 + np.trace(rotation) <= 1e-12:
        return log(rotation)
    w = real_part(rotation)
    return shortest(np.array([w, *vee(rotation) / (4 * w)]))


@reported("ungerik/go3d#37", "Bug in mat4.Quaternion()", "so3.log", log)
def trace_of_the_homogeneous(rotation: Array) -> Array:
    """The trace is that of the 4 x 4 matrix, 1 too much, and no other pivot is known."""
    w = math.sqrt(2 + np.trace(rotation)) / 2
    q = np.array([w, *vee(rotation) / (4 * w)])
    return shortest(q / np.linalg.norm(q))


@reported("rbdl/rbdl#107", "fromMatrix() may incorrectly return the conjugate of the quaternion", "so3.log", log)
def conjugate(rotation: Array) -> Array:
    """With a negative trace the real part comes out positive, whatever the sign of the pivot."""
    q = quaternion(rotation)
    return shortest(np.array([abs(q[0]), *q[1:]]))


@reported(
    "cgohlke/transformations#1",
    "quaternion_from_matrix return q[0] < 0 if isprecise is True",
    "so3.log",
    log,
    Verdict.OTHER_BRANCH,
)
@reported(
    "facebookresearch/pytorch3d#1703",
    "Matrix to Quaternion function requires quaternion standardization at the end.",
    "so3.log",
    log,
    Verdict.OTHER_BRANCH,
)
@reported(
    "facebookresearch/pytorch3d#1331",
    "Norm of output from `pytorch3d.transforms.rotation_conversions.matrix_to_axis_angle` is not in [0,pi]",
    "so3.log",
    log,
    Verdict.OTHER_BRANCH,
)
@reported("gaschler/rotationconverter#13", "Math Error", "so3.log", log, Verdict.OTHER_BRANCH)
def pivot_positive(rotation: Array) -> Array:
    """The pivot is positive, so that w may be negative: the long way round."""
    return any_angle(quaternion(proper(rotation)))


@reported(
    "ceres-solver/ceres-solver#66", "QuaternionToAngleAxis - Unwanted result", "so3.log", log, Verdict.OTHER_BRANCH
)
@reported(
    "ethz-asl/two_state_information_filter#22",
    "log() output different for negated quaternions",
    "so3.log",
    log,
    Verdict.OTHER_BRANCH,
)
@reported(
    "Yellow-Dog-Man/Resonite-Issues#3440",
    "ToAxisAngle returns different values for inputs with w<0 (Bug or intended?)",
    "so3.log",
    log,
    Verdict.OTHER_BRANCH,
)
def negated(rotation: Array) -> Array:
    """The quaternion with w < 0 is as good as its negative, but its angle is beyond pi."""
    q = quaternion(rotation)
    return any_angle(-q if q[0] > 0 else q)


@reported("pypose/pypose#172", "SO3 Log incorrect for small values", "so3.log", log)
def no_real_part(rotation: Array) -> Array:
    """Where w is 0 the factor 2 atan(|v|/w)/|v| is 0."""
    q = quaternion(rotation)
    sine = math.hypot(*q[1:])
    return np.asarray(2 * math.atan(sine / q[0]) / sine * q[1:] if abs(q[0]) > 1e-16 else np.zeros(3))


@reported("PX4/PX4-Matrix#117", "Fix AngleAxis constructors", "so3.log", log)
def twice_acos(rotation: Array) -> Array:
    """The angle is 2 acos(w), the length of the imaginary part its sine: both by a w that is flat there."""
    q = quaternion(rotation)
    angle = 2 * math.acos(min(1.0, q[0]))
    sine = math.sin(angle / 2)
    return np.asarray(angle / sine * q[1:] if sine > 0 else np.zeros(3))


@reported("JOML-CI/JOML#202", "NaN after `new AxisAngle`", "so3.log", log, Verdict.NON_FINITE)
def root_of_one_less_square(rotation: Array) -> Array:
    """The axis is the imaginary part over sqrt(1 - w^2), which is 0 long before the imaginary part is."""
    q = quaternion(rotation)
    return np.asarray(2 * np.arccos(q[0]) * q[1:] / np.sqrt(1 - q[0] ** 2))


@reported(
    "Yellow-Dog-Man/Resonite-Issues#4728",
    "To Axis Angle returns NaN when the input's W value is slightly over 1",
    "so3.log",
    log,
    Verdict.NON_FINITE,
)
@reported("toji/gl-matrix#502", "Clamp getAxisAngle acos argument to avoid NaN", "so3.log", log, Verdict.NON_FINITE)
def real_part_beyond_one(rotation: Array) -> Array:
    """acos of a real part beyond 1, as the trace of a matrix that is a little too long gives it."""
    w = np.sqrt(1 + np.trace(rotation)) / 2
    return np.asarray(2 * np.arccos(w) * vee(rotation) / np.linalg.norm(vee(rotation)))


@reported(
    "raysan5/raylib#2586",
    "[raymath] `QuaternionFromMatrix()` not returning expected result",
    "so3.log",
    log,
    Verdict.NON_FINITE,
)
@reported("laurentkneip/opengv#99", "Quaternion of unit matrix gives wrong result", "so3.log", log, Verdict.NON_FINITE)
@reported(
    "nicklockwood/VectorMath#12",
    "Initialize Quaternion from identity Matrix4 yields nan values",
    "so3.log",
    log,
    Verdict.NON_FINITE,
)
def pivot_of_nothing(rotation: Array) -> Array:
    """An imaginary pivot for the identity, where all of these are 0 (the reports tell the symptom only)."""
    x = np.sqrt(np.maximum(1 + 2 * rotation[0, 0] - np.trace(rotation), 0.0)) / 2
    w, y, z = vee(rotation)[0], rotation[0, 1] + rotation[1, 0], rotation[0, 2] + rotation[2, 0]
    q = np.array([w / (4 * x), x, y / (4 * x), z / (4 * x)])
    return any_angle(q)


@reported("ros/geometry#102", "Quaternion::getAngleShortestPath", "so3.log", log)
def angle_of_the_negative(rotation: Array) -> Array:
    """The angle is that of the negated real part, the axis is not negated."""
    q = quaternion(rotation)
    return np.asarray(2 * math.acos(-q[0]) * q[1:] / math.hypot(*q[1:]))


@reported("google/vector_math.dart#272", "Axis calculation of quaternions from small angles", "so3.log", log)
def axis_above_a_threshold(rotation: Array) -> Array:
    """No axis below 1 - w^2 = 5e-4, which is an angle of 2.56 degrees."""
    q = quaternion(rotation)
    return shortest(q) if 1 - q[0] ** 2 >= 5e-4 else np.zeros(3)
