"""SciPy: `scipy.spatial.transform` for rotations and rigid motions, `scipy.linalg` for functions of matrices.

Only what SciPy itself computes is held against the truth. The adapter packs twists into matrices and back, and hands on
a complex result as it is: where a real logarithm exists, a complex one is the finding.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import scipy
from scipy import linalg
from scipy.spatial.transform import RigidTransform, Rotation

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.preconditions import require_affine

SHEAR_ROWS = (0, 1, 0, 1, 2)
SHEAR_COLUMNS = (1, 1, 2, 2, 2)
"""Where alpha_1 to alpha_5 stand in an element of G_A, [[1, α1, α3], [0, α2, α4], [0, 0, α5]]."""

NEGLIGIBLE = 1e6 * np.finfo(np.float64).eps
"""An imaginary part so small is rounding: the tolerance of `linalg.logm`, here relative to the largest entry."""


def logm(matrix: Array) -> Any:
    """The matrix logarithms; the warning by which `linalg.logm` tells that a matrix is singular is its refusal."""
    with warnings.catch_warnings():
        warnings.filterwarnings("error", message="The logm input matrix is exactly singular")
        return linalg.logm(matrix)


def so3_exp(omega: Array) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return Rotation.from_rotvec(omega).as_matrix()


def so3_log(rotation: Array) -> Any:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return Rotation.from_matrix(rotation).as_rotvec()


def se3_exp(twist: Array) -> Any:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return RigidTransform.from_exp_coords(twist).as_matrix()


def se3_log(pose: Array) -> Any:
    """The twists (N, 6) of poses (N, 4, 4)."""
    return RigidTransform.from_matrix(pose).as_exp_coords()


def shear_exp(shear_twist: Array) -> Any:
    """The elements (N, 3, 3) of G_A from their logarithms (N, 5)."""
    generator = np.zeros((len(shear_twist), 3, 3))
    generator[:, SHEAR_ROWS, SHEAR_COLUMNS] = shear_twist
    return linalg.expm(generator)


def shear_log(shear: Array) -> Any:
    """The logarithms (N, 5) of elements (N, 3, 3) of G_A."""
    return logm(shear)[:, SHEAR_ROWS, SHEAR_COLUMNS]


def polar_decompose(linear: Array) -> tuple[Array, Array]:
    """Rotations and stretches (N, d, d) of linear maps (N, d, d); `linalg.polar` takes reflections for rotations."""
    if np.any(np.linalg.slogdet(linear)[0] <= 0):
        raise ValueError("the determinant is not positive")
    rotation, stretch = np.empty_like(linear), np.empty_like(linear)
    for item, turn, root in zip(linear, rotation, stretch, strict=True):
        turn[:], root[:] = linalg.polar(item)
    return rotation, stretch


def affine_lie_decompose(affine: Array) -> tuple[Array, Array, Array]:
    """Rigid (N, 4, 4), shear (N, 3, 3) and scale (N,) of affine maps (N, 4, 4), by LAPACK's RQ factorisation.

    RQ leaves the signs of the triangle's diagonal free; here they are made positive.
    """
    require_affine(affine)
    rigid = np.broadcast_to(np.eye(4), affine.shape).copy()
    shear = np.empty((len(affine), 3, 3))
    for item, pose, normal in zip(affine, rigid, shear, strict=True):
        triangle, rotation = linalg.rq(item[:3, :3])
        signs = np.copysign(1.0, np.diag(triangle))
        pose[:3, :3] = signs[:, None] * rotation
        normal[:] = triangle * signs
        pose[:3, 3] = linalg.solve_triangular(normal, item[:3, 3])
    scale = shear[:, 0, 0].copy()
    return rigid, shear / scale[:, None, None], scale


def sam_log(affine: Array) -> Any:
    """The logarithms (N, n, n) of affine maps (N, n, n)."""
    require_affine(affine)
    return logm(affine)


def sam_power(affine: Array, t: Array) -> Any:
    """The powers A^t (N, n, n) of affine maps (N, n, n).

    SciPy computes them in complex arithmetic wherever an eigenvalue is complex, and leaves the rounding in the
    imaginary part; that much is dropped, as everybody has to who uses it.
    """
    require_affine(affine)
    powers = [linalg.fractional_matrix_power(item, float(power)) for item, power in zip(affine, t, strict=True)]
    return np.stack(
        [power.real if np.max(np.abs(power.imag)) <= NEGLIGIBLE * np.max(np.abs(power)) else power for power in powers]
    )


def sam_velocity(affine: Array, point: Array) -> Any:
    """The velocities (N, n - 1) at points (N, n - 1) of the flow whose time-one map is A (N, n, n)."""
    generator = sam_log(affine)
    return (generator[:, :-1, :-1] @ point[:, :, None])[:, :, 0] + generator[:, :-1, -1]


SNIPPETS = {
    "so3.exp": """from scipy.spatial.transform import Rotation
rotation = Rotation.from_rotvec({input0})
print(rotation.as_matrix().tolist())""",
    "so3.log": """from scipy.spatial.transform import Rotation
rotation = Rotation.from_matrix({input0})
print(rotation.as_rotvec().tolist())""",
    "se3.exp": """from scipy.spatial.transform import RigidTransform
pose = RigidTransform.from_exp_coords({input0})
print(pose.as_matrix().tolist())""",
    "se3.log": """from scipy.spatial.transform import RigidTransform
pose = RigidTransform.from_matrix({input0})
print(pose.as_exp_coords().tolist())""",
    "shear.exp": """from scipy.linalg import expm
a, b, c, d, e = {input0}
print(expm([[0, a, c], [0, b, d], [0, 0, e]]).tolist())""",
    "shear.log": """from scipy.linalg import logm
logarithm = logm({input0})
print(logarithm[[0, 1, 0, 1, 2], [1, 1, 2, 2, 2]].tolist())""",
    "polar.decompose": """from scipy.linalg import polar
rotation, stretch = polar({input0})
print([rotation.tolist(), stretch.tolist()])""",
    "affine_lie.decompose": """import numpy as np, scipy
A = np.array({input0}); K, Q = scipy.linalg.rq(A[:3, :3]); s = np.copysign(1.0, np.diag(K)); K = K * s
rigid = [*np.c_[s[:, None] * Q, scipy.linalg.solve_triangular(K, A[:3, 3])].tolist(), [0.0, 0.0, 0.0, 1.0]]
print([rigid, (K / K[0, 0]).tolist(), K[0, 0].tolist()])""",
    "sam.log": """from scipy.linalg import logm
affine = {input0}
print(logm(affine).tolist())""",
    "sam.power": """from scipy.linalg import fractional_matrix_power
power = fractional_matrix_power({input0}, {input1})
print((power.real if abs(power.imag).max() <= 2.2e-10 * abs(power).max() else power).tolist())""",
    "sam.velocity": """import scipy
generator = scipy.linalg.logm({input0})
print((generator[:-1, :-1] @ {input1} + generator[:-1, -1]).tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="scipy",
    version=scipy.__version__,
    maps={
        "so3.exp": so3_exp,
        "so3.log": so3_log,
        "se3.exp": se3_exp,
        "se3.log": se3_log,
        "shear.exp": shear_exp,
        "shear.log": shear_log,
        "polar.decompose": polar_decompose,
        "affine_lie.decompose": affine_lie_decompose,
        "sam.log": sam_log,
        "sam.power": sam_power,
        "sam.velocity": sam_velocity,
    },
    conventions={
        "vectors": "columns; matrices act from the left; homogeneous matrices (4, 4) with last row 0 0 0 1",
        "rotations": "Rotation: rotation vectors in radians, angle in [0, pi]; kept as unit quaternions (x, y, z, w)",
        "branch at pi": "the sign of as_rotvec at exactly pi is that of the quaternion found, documented nowhere",
        "rotations off the manifold": "orthogonalised by from_matrix; ValueError if the determinant is not positive",
        "twists": "exponential coordinates (rx, ry, rz, vx, vy, vz): rotation first, as here",
        "matrix logarithm": "linalg.logm: principal, so complex if an eigenvalue is negative; warning is refusal",
        "matrix power": "linalg.fractional_matrix_power: principal; an imaginary part below 2e-10 is dropped",
        "polar factors": "linalg.polar: stretch on the right; the adapter refuses what preserves no orientation",
        "affine maps": "scipy.linalg takes any square matrix; the adapter refuses what preserves no orientation",
        "triangular factor": "linalg.rq: signs of the diagonal are LAPACK's; the adapter makes them positive",
    },
    policies={
        "not a rotation": "Rotation.from_matrix and RigidTransform.from_matrix orthogonalise what they are given"
    },
    snippets=SNIPPETS,
)
