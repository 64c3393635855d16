"""pytransform3d by quaternions and dual quaternions: other code than that of `pytransform3d` here, by matrices.

The logarithm of a pose is read off the screw parameters of its dual quaternion.
"""

from __future__ import annotations

from importlib.metadata import version

import numpy as np
from pytransform3d import rotations as pr
from pytransform3d import transformations as pt

from affinecert.map import Array
from affinecert.subject import Subject


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return np.stack([pr.matrix_from_quaternion(pr.quaternion_from_compact_axis_angle(item)) for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return np.stack([pr.compact_axis_angle_from_quaternion(pr.quaternion_from_matrix(item)) for item in rotation])


def pose_from_twist(twist: Array) -> Array:
    """The pose (4, 4) of a twist (6,)."""
    axis, theta = pt.screw_axis_from_exponential_coordinates(twist)
    screw = pt.screw_parameters_from_screw_axis(axis) if theta > 0 else (np.zeros(3), np.eye(3)[0], np.inf)
    return np.asarray(pt.transform_from_dual_quaternion(pt.dual_quaternion_from_screw_parameters(*screw, theta)))


def twist_from_pose(pose: Array) -> Array:
    """The twist (6,) of a pose (4, 4)."""
    *screw, theta = pt.screw_parameters_from_dual_quaternion(pt.dual_quaternion_from_transform(pose))
    return np.asarray(pt.screw_axis_from_screw_parameters(*screw) * theta)


def se3_exp(twist: Array) -> Array:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return np.stack([pose_from_twist(item) for item in twist])


def se3_log(pose: Array) -> Array:
    """The twists (N, 6) of poses (N, 4, 4)."""
    return np.stack([twist_from_pose(item) for item in pose])


def ends(start: Array, end: Array) -> tuple[Array, Array]:
    """The dual quaternions (8,) of two poses (4, 4), the second one of the sign that is nearer to the first."""
    p, q = pt.dual_quaternion_from_transform(start), pt.dual_quaternion_from_transform(end)
    return p, pt.dual_quaternion_double(q) if p[:4] @ q[:4] < 0 else q


def sclerp(start: Array, end: Array, t: Array) -> Array:
    """The poses (N, 4, 4) on the screw motions between poses (N, 4, 4)."""
    items = zip(start, end, t, strict=True)
    return np.stack([pt.transform_from_dual_quaternion(pt.dual_quaternion_sclerp(*ends(b, c), s)) for b, c, s in items])


def blended(start: Array, end: Array, time: float) -> Array:
    """The dual quaternion (8,) of the normalised mixture of those of two poses (4, 4)."""
    p, q = ends(start, end)
    return np.asarray(pt.norm_dual_quaternion((1 - time) * p + time * q))


def dual_quaternion_linear(start: Array, end: Array, t: Array) -> Array:
    """The poses (N, 4, 4) of the normalised mixtures of the dual quaternions of poses (N, 4, 4)."""
    items = zip(start, end, t, strict=True)
    return np.stack([pt.transform_from_dual_quaternion(blended(*item)) for item in items])


SNIPPETS = {
    "so3.exp": """import numpy as np
from pytransform3d.rotations import matrix_from_quaternion, quaternion_from_compact_axis_angle
print(matrix_from_quaternion(quaternion_from_compact_axis_angle(np.array({input0}))).tolist())""",
    "so3.log": """import numpy as np
from pytransform3d.rotations import compact_axis_angle_from_quaternion, quaternion_from_matrix
print(compact_axis_angle_from_quaternion(quaternion_from_matrix(np.array({input0}))).tolist())""",
    "se3.exp": """import numpy as np, pytransform3d.transformations as pt
axis, theta = pt.screw_axis_from_exponential_coordinates(np.array({input0}))
screw = pt.screw_parameters_from_screw_axis(axis) if theta > 0 else (np.zeros(3), np.eye(3)[0], np.inf)
print(pt.transform_from_dual_quaternion(pt.dual_quaternion_from_screw_parameters(*screw, theta)).tolist())""",
    "se3.log": """import numpy as np, pytransform3d.transformations as pt
dq = pt.dual_quaternion_from_transform(np.array({input0}))
*screw, theta = pt.screw_parameters_from_dual_quaternion(dq)
print((pt.screw_axis_from_screw_parameters(*screw) * theta).tolist())""",
    "morphs.sclerp": """import numpy as np, pytransform3d.transformations as pt
p, q = (pt.dual_quaternion_from_transform(np.array(pose)) for pose in ({input0}, {input1}))
q = pt.dual_quaternion_double(q) if p[:4] @ q[:4] < 0 else q
print(pt.transform_from_dual_quaternion(pt.dual_quaternion_sclerp(p, q, {input2})).tolist())""",
    "morphs.dual_quaternion_linear": """import numpy as np, pytransform3d.transformations as pt
p, q = (pt.dual_quaternion_from_transform(np.array(pose)) for pose in ({input0}, {input1}))
q, t = pt.dual_quaternion_double(q) if p[:4] @ q[:4] < 0 else q, {input2}
print(pt.transform_from_dual_quaternion(pt.norm_dual_quaternion((1 - t) * p + t * q)).tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="pytransform3d_quaternions",
    version=version("pytransform3d"),
    maps={
        "so3.exp": so3_exp,
        "so3.log": so3_log,
        "se3.exp": se3_exp,
        "se3.log": se3_log,
        "morphs.sclerp": sclerp,
        "morphs.dual_quaternion_linear": dual_quaternion_linear,
    },
    conventions={
        "vectors": "columns; matrices act from the left; homogeneous matrices (4, 4) with last row 0 0 0 1",
        "rotations": "quaternions (w, x, y, z), from compact axis-angles in radians and back",
        "twists": "screw parameters (q, s, h, theta), h infinite for a translation; (omega, v) by the library",
        "branch at pi": "angles in [0, pi]; the axis at exactly pi is documented nowhere",
        "rotations off the manifold": "ValueError further than 1e-6 from R R^T = 1, entry by entry",
        "sclerp": "dual_quaternion_sclerp; the adapter turns the end's sign where the real parts' product is negative",
        "blending": "norm_dual_quaternion of (1 - t) p + t q, likewise",
    },
    policies={"off the manifold": "check_matrix has a tolerance of 1e-6, within which a matrix is taken as it is"},
    snippets=SNIPPETS,
)
