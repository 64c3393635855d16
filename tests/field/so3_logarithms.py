"""Rotation vectors of rotation matrices by their antisymmetric part, near 0 and near pi."""

from __future__ import annotations

import math

import numpy as np

from affinecert.scoring import Verdict

from .report import Array, reported
from .sound import log, vee


def cosine(rotation: Array) -> float:
    """The cosine of the angle, by the trace; rounding may take it beyond 1."""
    return float((np.trace(rotation) - 1) / 2)


def clipped(rotation: Array) -> float:
    """The angle by acos of the trace, which is brought back into [-1, 1]."""
    return math.acos(min(1.0, max(-1.0, cosine(rotation))))


def by_the_sine(rotation: Array) -> Array:
    """R - R^T over 2 sin(angle), the angle by acos; both vanish at pi."""
    angle = clipped(rotation)
    return np.asarray(vee(rotation) * (angle / (2 * math.sin(angle)) if angle else 0.5))


@reported("borglab/gtsam#1233", "Regression in Logmap (v4.2a7)", "so3.log", log)
def pivot_without_trace(rotation: Array) -> Array:
    """Near pi the pivot is 2 + 2 R_ii where 1 + 2 R_ii - tr R is due, and the angle pi - 2 w to first order."""
    if np.trace(rotation) + 1 >= 1e-3:
        return by_the_sine(rotation)
    i = int(np.argmax(np.diag(rotation)))
    w = vee(rotation)[i]
    sign = math.copysign(1.0, w)
    pivot = 2 + 2 * rotation[i, i]
    axis = rotation[:, i] + rotation[i, :]
    axis[i] = pivot
    magnitude = math.pi - 2 * abs(w) / math.hypot(w, *axis)
    return np.asarray(sign * magnitude * axis / np.linalg.norm(axis))


@reported("borglab/gtsam#886", "Buggy axis-angle computation in GTSAM", "so3.log", log)
def noise_blown_up(rotation: Array) -> Array:
    """Close to pi, acos and division by the sine blow up the rounding of the entries."""
    return by_the_sine(rotation)


@reported("borglab/gtsam#746", "SO3 matrix log when theta is close to zero", "so3.log", log, Verdict.DEGRADED)
def square_of_the_trace(rotation: Array) -> Array:
    """Near 0 the factor is 1/2 - (tr R - 3)^2/12, where 1/2 - (tr R - 3)/12 is due."""
    excess = np.trace(rotation) - 3
    return np.asarray(vee(rotation) * (0.5 - excess**2 / 12)) if excess > -1e-6 else by_the_sine(rotation)


@reported("facebookresearch/pytorch3d#188", "Singularity at pi in so3_log_map()", "so3.log", log)
def sine_near_pi(rotation: Array) -> Array:
    """The division by the sine, at an angle just short of pi."""
    return by_the_sine(rotation)


@reported("facebookresearch/pytorch3d#413", "Wrong Outputs from pytorch3d.transforms.so3_log_map", "so3.log", log)
def half_turn_lost(rotation: Array) -> Array:
    """A half turn has no antisymmetric part, and comes out as no turn."""
    return by_the_sine(rotation)


@reported("facebookresearch/pytorch3d#262", "so3_log_map unexpected behaviour", "so3.log", log)
def camera_lost(rotation: Array) -> Array:
    """The same for the camera that looks from 50 degrees up."""
    return by_the_sine(rotation)


@reported("hmgoforth/PointNetLK#21", "so3.log gives an incorrect result for some matrix", "so3.log", log)
def nothing_at_pi(rotation: Array) -> Array:
    """Where the sine is below the tolerance, near 0 as near pi, the logarithm is R - R^T over 2."""
    angle = clipped(rotation)
    return np.asarray(vee(rotation) / 2) if math.sin(angle) < 1e-3 else by_the_sine(rotation)


@reported("jlblancoc/tutorial-se3-manifold#13", "log map diverges around theta = Pi", "so3.log", log)
def diverging(rotation: Array) -> Array:
    """The textbook's formula has no case for pi."""
    return by_the_sine(rotation)


@reported(
    "utiasSTARS/liegroups#14", "Extra care needed for np.sin(theta) where theta = +np.pi or -np.pi ?", "so3.log", log
)
def sine_unguarded(rotation: Array) -> Array:
    """Nobody asks whether the angle is pi."""
    return by_the_sine(rotation)


@reported("tussedrotten/pylie#4", "Handle rotations by pi", "so3.log", log)
def small_angles_only(rotation: Array) -> Array:
    """A case for angle 0, none for pi: the direction is left to rounding."""
    return by_the_sine(rotation)


@reported(
    "jrl-umi3218/SpaceVecAlg#43", "Fixing rotationVelocity when the rotation angle is close to pi", "so3.log", log
)
def inverse_sinc(rotation: Array) -> Array:
    """The inverse cardinal sine has a series near 0, and a pole at pi."""
    return by_the_sine(rotation)


@reported("tussedrotten/pylie#6", "Unexpected nan in SO3.Log()", "so3.log", log, Verdict.NON_FINITE)
def zero_normalised(rotation: Array) -> Array:
    """The axis is the antisymmetric part, normalised: 0/0 for a half turn."""
    return np.asarray(clipped(rotation) * vee(rotation) / np.linalg.norm(vee(rotation)))


@reported("dfki-ric/pytransform3d#198", "Error in compact_axis_angle_from_matrix", "so3.log", log, Verdict.NON_FINITE)
def half_turn_not_seen(rotation: Array) -> Array:
    """The half turn has a case of its own, but acos does not give exactly pi, and the general case divides 0 by 0."""
    angle = clipped(rotation)
    return np.asarray(angle * vee(rotation) / np.linalg.norm(vee(rotation)))


@reported(
    "dfki-ric/pytransform3d#43",
    "rotations.axis_angle_from_matrix() inaccuracy at angles close to zero or pi",
    "so3.log",
    log,
)
def axis_of_squares(rotation: Array) -> Array:
    """Near pi the axis is the root of the diagonal: its signs are gone."""
    angle = clipped(rotation)
    if math.pi - angle >= 1e-7:
        return np.asarray(angle * vee(rotation) / np.linalg.norm(vee(rotation)))
    return np.asarray(angle * np.sqrt(np.maximum(np.diag(rotation) + 1, 0) / 2))


@reported(
    "dfki-ric/pytransform3d#364",
    "Fix NaN in axis_angles_from_matrices for exact pi rotations",
    "so3.log",
    log,
    Verdict.NON_FINITE,
)
def signs_of_nothing(rotation: Array) -> Array:
    """The signs of the axis are those of the antisymmetric part, all 0 for a half turn; then it is normalised."""
    axis = np.sqrt(np.maximum(np.diag(rotation) + 1, 0) / 2) * np.sign(vee(rotation))
    return np.asarray(clipped(rotation) * axis / np.linalg.norm(axis))


@reported(
    "dfki-ric/pytransform3d#296",
    "fix axis angle conversion when the rotation matrix is close to identity",
    "so3.log",
    log,
    Verdict.NON_FINITE,
)
def identity_by_equality(rotation: Array) -> Array:
    """Only a cosine of exactly 1 counts as the identity, and rounding takes it beyond."""
    if cosine(rotation) == 1:
        return np.zeros(3)
    return np.asarray(np.arccos(cosine(rotation)) * vee(rotation) / np.linalg.norm(vee(rotation)))


@reported(
    "boelnasr/ManipulaPy#42",
    "MatrixLog3 returns zero vector for θ=π rotations about coordinate axes (degenerate π-branch)",
    "so3.log",
    log,
)
def signs_of_the_neighbours(rotation: Array) -> Array:
    """At pi each component takes its sign from the entries beside the diagonal, all 0 for a coordinate axis."""
    if math.pi - clipped(rotation) > 1e-6:
        return by_the_sine(rotation)
    beside = rotation - np.diag(np.diag(rotation))
    return np.asarray(math.pi * np.sqrt(np.maximum(np.diag(rotation) + 1, 0) / 2) * np.sign(beside.sum(axis=0)))


@reported("RobotLocomotion/drake#3451", "rotmat2axis does not work for 180 degrees of rotation", "so3.log", log)
def about_the_zero_vector(rotation: Array) -> Array:
    """The half turn comes with the zero vector for an axis."""
    length = np.linalg.norm(vee(rotation))
    return np.asarray(clipped(rotation) * vee(rotation) / (length if length > 1e-12 else 1.0))


@reported("cardilloproject/cardillo#68", "Log_SO3 with exact 180° degrees", "so3.log", log)
def guard_for_both_ends(rotation: Array) -> Array:
    """The guard against dividing by 0 takes the half turn for the identity."""
    sine = np.linalg.norm(vee(rotation)) / 2
    return np.asarray(vee(rotation) / 2 if sine < 1e-14 else clipped(rotation) / sine * vee(rotation) / 2)


@reported("dimforge/nalgebra#1382", "Numecirally vulnerable axis calculation in Rotation3", "so3.log", log)
def no_axis(rotation: Array) -> Array:
    """Where the antisymmetric part is below the epsilon there is no axis, and no rotation vector."""
    length = np.linalg.norm(vee(rotation))
    return np.asarray(clipped(rotation) * vee(rotation) / length if length > 2.3e-16 else np.zeros(3))


@reported("cyberbotics/webots#2155", "Fixed conversion from matrix3 to axis angle", "so3.log", log)
def half_for_one(rotation: Array) -> Array:
    """At pi the pivot is sqrt(R_ii - R_jj - R_kk + 1/2) where half of the root of that with 1 is due."""
    angle = clipped(rotation)
    if math.pi - angle > 1e-8:
        return by_the_sine(rotation)
    i = int(np.argmax(np.diag(rotation)))
    pivot = math.sqrt(2 * rotation[i, i] - np.trace(rotation) + 0.5)
    axis = rotation[:, i] / (2 * pivot)
    axis[i] = pivot
    return np.asarray(angle * axis)


@reported(
    "geomstats/geomstats#16",
    "angles close to pi in special_orthogonal_group.py rotation_vector_from_matrix() function",
    "so3.log",
    log,
)
def rounded_to_pi(rotation: Array) -> Array:
    """Close to pi the angle is pi, and the sign of the axis is not looked for."""
    angle = clipped(rotation)
    if math.pi - angle > 1e-6:
        return by_the_sine(rotation)
    i = int(np.argmax(np.diag(rotation)))
    axis = (rotation[:, i] + np.eye(3)[i]) / math.sqrt(2 * (1 + rotation[i, i]))
    return np.asarray(-math.pi * axis)


@reported("stack-of-tasks/pinocchio#1647", "Log3 corner case bug", "so3.log", log)
@reported(
    "lagadic/visp#371",
    "Wrong conversion from vpRotationMatrix to vpThetaUVector for rotations around pi",
    "so3.log",
    log,
)
def components_inverted(rotation: Array) -> Array:
    """Around pi the sizes come from the diagonal, each sign from the antisymmetric part, although that is rounding."""
    if np.linalg.norm(vee(rotation)) > 1e-3:
        return by_the_sine(rotation)
    sizes = np.sqrt(np.maximum((np.diag(rotation) - cosine(rotation)) / (1 - cosine(rotation)), 0))
    return np.asarray(clipped(rotation) * np.where(vee(rotation) < 0, -sizes, sizes))


@reported("dartsim/dart#333", "Bug in FreeJoint helper", "so3.log", log)
def signs_by_halves(rotation: Array) -> Array:
    """At pi the second and the third component take their signs from the first, which is 0 here."""
    if math.pi - clipped(rotation) > 1e-5:
        return by_the_sine(rotation)
    sizes = np.sqrt(np.maximum(np.diag(rotation) + 1, 0) / 2)
    signs = np.array([1.0, np.sign(rotation[0, 1]) or 1.0, np.sign(rotation[0, 2]) or 1.0])
    return np.asarray(clipped(rotation) * signs * sizes)


@reported(
    "orocos/orocos_kinematics_dynamics#109",
    "Fix some singularities when using Rotation::GetRotAngle()",
    "so3.log",
    log,
)
def singularity_without_signs(rotation: Array) -> Array:
    """Beside pi the axis is the root of the diagonal, without signs."""
    if np.linalg.norm(vee(rotation)) > 1e-6:
        return by_the_sine(rotation)
    return np.asarray(clipped(rotation) * np.sqrt(np.maximum(np.diag(rotation) + 1, 0) / 2))


@reported(
    "orocos/orocos_kinematics_dynamics#199",
    "back to use a more numerically stable method to compute the rotation angle",
    "so3.log",
    log,
)
def angle_by_acos(rotation: Array) -> Array:
    """The angle by acos, which is flat at 1: of a small angle half of the digits are lost."""
    return np.asarray(clipped(rotation) * vee(rotation) / np.linalg.norm(vee(rotation)))


@reported(
    "orocos/orocos_kinematics_dynamics#352",
    "Rotation::GetRotAxis() returning non-zero angle and giving wrong axis when passed a small eps",
    "so3.log",
    log,
)
def axis_by_default(rotation: Array) -> Array:
    """The angle is right, but an axis shorter than 1e-6 is normalised to (1, 0, 0)."""
    length = np.linalg.norm(vee(rotation))
    axis = vee(rotation) / length if length > 1e-6 else np.array([1.0, 0.0, 0.0])
    return np.asarray(math.atan2(length / 2, cosine(rotation)) * axis)


@reported("Mayitzin/ahrs#122", "Wrong implementation of DCM.log()", "so3.log", log)
def angle_by_asin(rotation: Array) -> Array:
    """The angle by asin of the antisymmetric part, which ends at a quarter turn."""
    sine = float(np.linalg.norm(vee(rotation))) / 2
    return np.asarray(math.asin(min(sine, 1.0)) / sine * vee(rotation) / 2)


@reported("g-truc/glm#638", "glm::axisAngle returns NaN", "so3.log", log, Verdict.NON_FINITE)
def acos_beyond_one(rotation: Array) -> Array:
    """acos of a cosine that rounding took beyond 1."""
    return np.asarray(np.arccos(cosine(rotation)) * vee(rotation) / np.linalg.norm(vee(rotation)))


@reported("godotengine/godot#63397", "Basis.toAxisAngle return NaN as angle", "so3.log", log, Verdict.NON_FINITE)
def acos_of_a_long_basis(rotation: Array) -> Array:
    """The same, of a basis that is a little too long."""
    return np.asarray(np.arccos(cosine(rotation)) * vee(rotation) / np.linalg.norm(vee(rotation)))


@reported(
    "g-truc/glm#764",
    'is there any bug in "glm::axisAngle(mat<4, 4, T, Q> const& mat, vec<3, T, Q> & axis, T & angle) "?',
    "so3.log",
    log,
)
def always_an_eighth(rotation: Array) -> Array:
    """The angle is pi/4 whatever the matrix: the guard for a cosine of 1 lacks its else."""
    return np.asarray(math.pi / 4 * vee(rotation) / np.linalg.norm(vee(rotation)))


@reported("g-truc/glm#1064", "Fix axis angle implementation for near zero angles and near PI angles", "so3.log", log)
def nothing_below_a_hundredth(rotation: Array) -> Array:
    """Symmetric to within 1e-2 counts as symmetric: 0.0035 radians are none."""
    if np.max(np.abs(vee(rotation))) < 1e-2 and cosine(rotation) > 0:
        return np.zeros(3)
    return by_the_sine(rotation)


@reported(
    "bdaiinstitute/spatialmath-python#86", "Fixed domain errors in acos near identity", "so3.log", log, Verdict.RAISED
)
def domain_error(rotation: Array) -> Array:
    """math.acos refuses the cosine of a product of a rotation with its inverse: its trace is 3 and a rounding."""
    angle = math.acos(cosine(rotation))
    return np.asarray(vee(rotation) * (angle / (2 * math.sin(angle)) if angle else 0.5))


@reported(
    "OliverWu515/ommpc_controller#5",
    "SO3::log returns NaN or an incorrect zero vector near 180-degree rotations",
    "so3.log",
    log,
    Verdict.NON_FINITE,
)
@reported(
    "OliverWu515/ommpc_controller#5",
    "SO3::log returns NaN or an incorrect zero vector near 180-degree rotations",
    "so3.log",
    log,
)
def neither_end(rotation: Array) -> Array:
    """acos without a clamp beside the identity; and where R - R^T is tiny, the zero vector."""
    angle = np.arccos(cosine(rotation))
    length = np.linalg.norm(vee(rotation))
    if length < 1e-10:
        return np.asarray(angle * vee(rotation))
    return np.asarray(angle * vee(rotation) / length)


@reported(
    "strasdat/Sophus#239",
    "Bug in the python version of So3:log and Se3:log when rotation is identity matrix",
    "so3.log",
    log,
    Verdict.NON_FINITE,
)
@reported("PX4/PX4-Matrix#25", "Axis angle", "so3.log", log, Verdict.NON_FINITE)
@reported("UZ-SLAMLab/ORB_SLAM3#608", "Solving Sophus -nan error", "so3.log", log, Verdict.NON_FINITE)
@reported(
    "odin-lang/Odin#3726",
    "`linalg.angle_axis_from_quaternion` returns `[NaN, NaN, NaN]` axis for identity quaternion",
    "so3.log",
    log,
    Verdict.NON_FINITE,
)
def identity_divided(rotation: Array) -> Array:
    """The identity has no axis, and its zero vector is normalised."""
    return np.asarray(clipped(rotation) * vee(rotation) / np.linalg.norm(vee(rotation)))


@reported("ros/geometry#168", "Bug in rotation_from_matrix in tf/src/tf/transformation.py?", "so3.log", log)
def last_eigenvector(rotation: Array) -> Array:
    """The axis is the real part of the last eigenvector whose eigenvalue has a real part within 1e-8 of 1."""
    values, vectors = np.linalg.eig(rotation)
    axis = np.real(vectors[:, np.flatnonzero(np.abs(np.real(values) - 1) < 1e-8)[-1]])
    return np.asarray(math.atan2(vee(rotation) @ axis / 2, cosine(rotation)) * axis)


@reported("matthew-brett/transforms3d#3", "Overly sensitive mat2axangle", "so3.log", log, Verdict.RAISED)
def unit_to_eight_digits(rotation: Array) -> Array:
    """An eigenvalue must be 1 within 1e-8, or there is no axis; slightly inaccurate rotations are refused."""
    values = np.linalg.eigvals(rotation)
    if not np.any(np.abs(values - 1) < 1e-8):
        raise ValueError("no unit eigenvector corresponding to eigenvalue 1")
    return log(rotation)


@reported(
    "imagingbook/imagingbook-calibrate#4", "Typo in PDF describing the ToRodriguesVector algorithm", "so3.log", log
)
def difference_with_itself(rotation: Array) -> Array:
    """One component of R - R^T is R_21 - R_21."""
    vector = vee(rotation) / 2
    vector[2] = 0.0
    return np.asarray(math.atan2(np.linalg.norm(vector), cosine(rotation)) * vector / np.linalg.norm(vector))


@reported(
    "opencv/opencv#16778",
    "cv2.Rodrigues fails to produce original rotation matrix from rotation vector",
    "so3.log",
    log,
)
@reported("scipy/scipy#15002", "BUG: Invalid Rotation created for 2d rotations", "so3.log", log)
@reported("scipy/scipy#17324", "BUG: Rotation matrix is changed with scipy.spatial.transform.Rotation", "so3.log", log)
@reported(
    "mrdoob/three.js#14158",
    "matrix.extractRotation() returns incorrect rotation matrix when scale is negative",
    "so3.log",
    log,
)
def reflection_for_rotation(matrix: Array) -> Array:
    """Nobody looks at the determinant: a reflection gets a rotation vector."""
    return by_the_sine(matrix)
