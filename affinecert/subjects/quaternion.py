"""numpy-quaternion: rotation vectors and matrices by way of quaternions, and slerp."""

from __future__ import annotations

import numpy as np
import quaternion

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.rotors import normalised


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return np.asarray(quaternion.as_rotation_matrix(quaternion.from_rotation_vector(omega)))


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return np.asarray(quaternion.as_rotation_vector(quaternion.from_rotation_matrix(rotation)))


def slerp(start: Array, end: Array, t: Array) -> Array:
    """The quaternions (N, 4) between quaternions (N, 4), normalised first: slerp is one of rotors."""
    rotors = (quaternion.as_quat_array(normalised(item)) for item in (start, end))
    return np.asarray(quaternion.as_float_array(quaternion.slerp(*rotors, 0.0, 1.0, t)))


SNIPPETS = {
    "so3.exp": """import quaternion
turn = quaternion.from_rotation_vector({input0})
print(quaternion.as_rotation_matrix(turn).tolist())""",
    "so3.log": """import numpy as np, quaternion
turn = quaternion.from_rotation_matrix(np.array({input0}))
print(quaternion.as_rotation_vector(turn).tolist())""",
    "quaternion.slerp": """import numpy as np, quaternion
p, q = (quaternion.quaternion(*(np.array(x) / np.linalg.norm(x, axis=-1))) for x in ({input0}, {input1}))
print(quaternion.slerp(p, q, 0.0, 1.0, {input2}).components.tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="quaternion",
    version=quaternion.__version__,
    maps={"so3.exp": so3_exp, "so3.log": so3_log, "quaternion.slerp": slerp},
    conventions={
        "quaternions": "(w, x, y, z); rotors are those of unit length, to which the adapter sees",
        "rotations": "m @ v.vec == q * v * q.conjugate(): columns, matrices act from the left",
        "branch": "as_rotation_vector takes the quaternion as it is: the angle is up to 2 pi where w < 0",
        "slerp": "along the shorter arc; times t1 = 0 and t2 = 1 here",
    },
    policies={"not a rotation": 'from_rotation_matrix: if not orthogonal, the "closest" orthogonal matrix is used'},
    snippets=SNIPPETS,
)
