"""pytransform3d, the functions of single items: `pytransform3d.rotations` and `pytransform3d.transformations`.

The functions of batches are other code: `affinecert.subjects.pytransform3d_batch`.
"""

from __future__ import annotations

from importlib.metadata import version

import numpy as np
from pytransform3d import rotations, transformations

from affinecert.map import Array
from affinecert.subject import Subject


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return np.stack([rotations.matrix_from_compact_axis_angle(item) for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return np.stack([rotations.compact_axis_angle_from_matrix(item) for item in rotation])


def se3_exp(twist: Array) -> Array:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return np.stack([transformations.transform_from_exponential_coordinates(item) for item in twist])


def se3_log(pose: Array) -> Array:
    """The twists (N, 6) of poses (N, 4, 4)."""
    return np.stack([transformations.exponential_coordinates_from_transform(item) for item in pose])


def slerp(start: Array, end: Array, t: Array) -> Array:
    """The quaternions (N, 4) between quaternions (N, 4)."""
    items = zip(start, end, t, strict=True)
    return np.stack([rotations.quaternion_slerp(p, q, time, shortest_path=True) for p, q, time in items])


def sclerp(start: Array, end: Array, t: Array) -> Array:
    """The poses (N, 4, 4) between poses (N, 4, 4), by transform_power."""
    items = zip(start, end, t, strict=True)
    return np.stack([transformations.transform_sclerp(pose, other, time) for pose, other, time in items])


def polar_decompose(linear: Array) -> tuple[Array, Array]:
    """Rotations and stretches (N, d, d) of linear maps (N, d, d).

    The library gives the rotation alone, of space; a map L of the plane is taken as (L, 0; 0, 1).
    """
    size = linear.shape[-1]
    if np.any(np.linalg.slogdet(linear)[0] <= 0):
        raise ValueError("the determinant is not positive")
    solid = np.broadcast_to(np.eye(3), (len(linear), 3, 3)).copy()
    solid[:, :size, :size] = linear
    rotation = np.stack([rotations.robust_polar_decomposition(item) for item in solid])[:, :size, :size]
    return rotation, np.swapaxes(rotation, 1, 2) @ linear


SNIPPETS = {
    "so3.exp": """import numpy as np
from pytransform3d.rotations import matrix_from_compact_axis_angle
print(matrix_from_compact_axis_angle(np.array({input0})).tolist())""",
    "so3.log": """import numpy as np
from pytransform3d.rotations import compact_axis_angle_from_matrix
print(compact_axis_angle_from_matrix(np.array({input0})).tolist())""",
    "se3.exp": """import numpy as np
from pytransform3d.transformations import transform_from_exponential_coordinates
print(transform_from_exponential_coordinates(np.array({input0})).tolist())""",
    "se3.log": """import numpy as np
from pytransform3d.transformations import exponential_coordinates_from_transform
print(exponential_coordinates_from_transform(np.array({input0})).tolist())""",
    "quaternion.slerp": """import numpy as np
from pytransform3d.rotations import quaternion_slerp
print(quaternion_slerp(np.array({input0}), np.array({input1}), {input2}, shortest_path=True).tolist())""",
    "morphs.sclerp": """import numpy as np
from pytransform3d.transformations import transform_sclerp
print(transform_sclerp(np.array({input0}), np.array({input1}), {input2}).tolist())""",
    "polar.decompose": """import numpy as np
from pytransform3d.rotations import robust_polar_decomposition
L = np.array({input0}); n = len(L); solid = np.eye(3); solid[:n, :n] = L; R = robust_polar_decomposition(solid)[:n, :n]
print([R.tolist(), (R.T @ L).tolist()])""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="pytransform3d",
    version=version("pytransform3d"),
    maps={
        "so3.exp": so3_exp,
        "so3.log": so3_log,
        "se3.exp": se3_exp,
        "se3.log": se3_log,
        "quaternion.slerp": slerp,
        "morphs.sclerp": sclerp,
        "polar.decompose": polar_decompose,
    },
    conventions={
        "vectors": "columns; matrices act from the left; homogeneous matrices (4, 4) with last row 0 0 0 1",
        "rotations": "compact axis-angles in radians; quaternions (w, x, y, z), normalised by slerp",
        "twists": "exponential coordinates (omega, v): rotation first, as here",
        "branch at pi": "angles in (-pi, pi] by documentation; the axis at exactly pi is documented nowhere",
        "rotations off the manifold": "ValueError further than 1e-6 from R R^T = 1, entry by entry",
        "slerp": "shortest_path=True; documented for t in [0, 1], computed for every t",
        "polar factors": "robust_polar_decomposition, with its default of 20 steps; the adapter multiplies out R^T L",
    },
    policies={
        "not a unit quaternion": "quaternion_slerp normalises: check_quaternion has unit=True as default",
        "off the manifold": "check_matrix has a tolerance of 1e-6, within which a matrix is taken as it is",
    },
    snippets=SNIPPETS,
)
