"""SciPy: `scipy.spatial` for rotations and rigid motions, `scipy.linalg` for functions of matrices.

Only what SciPy itself computes is held against the truth; the functions of matrices are in `scipy_matrices`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy
from scipy.spatial import geometric_slerp
from scipy.spatial.transform import RigidTransform, Rotation

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects import scipy_matrices
from affinecert.subjects.rotors import normalised


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


def slerp(start: Array, end: Array, t: Array) -> Array:
    """The quaternions (N, 4) between quaternions (N, 4), normalised first; `geometric_slerp` goes to q or to -q."""
    p, q = normalised(start), normalised(end)
    nearer = np.where(np.sum(p * q, axis=-1, keepdims=True) < 0, -q, q)
    # Of equal ends it makes an array of one more axis.
    return np.stack([geometric_slerp(*item).reshape(4) for item in zip(p, nearer, t, strict=True)])


def sclerp(start: Array, end: Array, t: Array) -> Array:
    """The poses (N, 4, 4) on the screw motions between poses (N, 4, 4), by the power of rigid motions."""
    b, c = RigidTransform.from_matrix(start), RigidTransform.from_matrix(end)
    way = b.inv() * c
    return np.stack([(b[k] * way[k] ** float(time)).as_matrix() for k, time in enumerate(t)])


def dual_quaternion_linear(start: Array, end: Array, t: Array) -> Any:
    """The poses (N, 4, 4) of the normalised mixtures of the dual quaternions of poses (N, 4, 4)."""
    p, q = (RigidTransform.from_matrix(pose).as_dual_quat() for pose in (start, end))
    nearer = np.where(np.sum(p[:, :4] * q[:, :4], axis=-1, keepdims=True) < 0, -q, q)
    return RigidTransform.from_dual_quat((1 - t)[:, None] * p + t[:, None] * nearer).as_matrix()


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
    "quaternion.slerp": """import numpy as np
from scipy.spatial import geometric_slerp
p, q = (np.array(x) / np.linalg.norm(x, axis=-1) for x in ({input0}, {input1}))
print(geometric_slerp(p, q if p @ q >= 0 else -q, {input2}).ravel().tolist())""",
    "morphs.sclerp": """from scipy.spatial.transform import RigidTransform
b, c = RigidTransform.from_matrix({input0}), RigidTransform.from_matrix({input1})
print((b * (b.inv() * c) ** {input2}).as_matrix().tolist())""",
    "morphs.dual_quaternion_linear": """from scipy.spatial.transform import RigidTransform as T
p, q = (T.from_matrix(pose).as_dual_quat() for pose in ({input0}, {input1}))
q, t = q if p[:4] @ q[:4] >= 0 else -q, {input2}
print(T.from_dual_quat((1 - t) * p + t * q).as_matrix().tolist())""",
    **scipy_matrices.SNIPPETS,
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
        "quaternion.slerp": slerp,
        "morphs.sclerp": sclerp,
        "morphs.dual_quaternion_linear": dual_quaternion_linear,
        **scipy_matrices.MAPS,
    },
    conventions={
        "vectors": "columns; matrices act from the left; homogeneous matrices (4, 4) with last row 0 0 0 1",
        "rotations": "Rotation: rotation vectors in radians, angle in [0, pi]; kept as unit quaternions (x, y, z, w)",
        "branch at pi": "the sign of as_rotvec at exactly pi is that of the quaternion found, documented nowhere",
        "rotations off the manifold": "orthogonalised by from_matrix; ValueError if the determinant is not positive",
        "twists": "exponential coordinates (rx, ry, rz, vx, vy, vz): rotation first, as here",
        "slerp": "spatial.geometric_slerp of unit vectors; the adapter takes the nearer one of q and -q",
        "screw motion": "B (B^-1 C)^t: the power of RigidTransform is documented as a screw interpolation from I",
        "dual quaternions": "as_dual_quat and from_dual_quat, which normalises; the adapter mixes, on the nearer side",
        **scipy_matrices.CONVENTIONS,
    },
    policies={
        "not a rotation": "Rotation.from_matrix and RigidTransform.from_matrix orthogonalise what they are given",
        "off the manifold of similarities": "linalg.expm and logm take each matrix as it is",
        "off the manifold of symmetric": "linalg.expm, logm and fractional_matrix_power take each matrix as it is",
        "no single fixed point": "linalg.solve warns of an ill-conditioned matrix, and answers",
    },
    refusals=scipy_matrices.REFUSALS,
    snippets=SNIPPETS,
)
