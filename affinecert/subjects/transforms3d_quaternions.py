"""transforms3d by quaternions: `transforms3d.quaternions`, rotations as exponentials and logarithms in there.

The exponential of the quaternion (0, omega / 2) turns by the rotation vector omega.
"""

from __future__ import annotations

from importlib.metadata import version

import numpy as np
from transforms3d.quaternions import mat2quat, qexp, qlog, quat2mat

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.preconditions import require_rotations


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return np.stack([quat2mat(qexp([0.0, *(item / 2)])) for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    require_rotations(rotation)
    return np.stack([2 * qlog(mat2quat(item))[1:] for item in rotation])


SNIPPETS = {
    "so3.exp": """import numpy as np
from transforms3d.quaternions import qexp, quat2mat
print(quat2mat(qexp([0, *(np.array({input0}) / 2)])).tolist())""",
    "so3.log": """import numpy as np
from transforms3d.quaternions import mat2quat, qlog
print((2 * qlog(mat2quat(np.array({input0})))[1:]).tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="transforms3d_quaternions",
    version=version("transforms3d"),
    maps={"so3.exp": so3_exp, "so3.log": so3_log},
    conventions={
        "vectors": "columns; matrices act from the left",
        "quaternions": "(w, x, y, z); mat2quat gives w >= 0",
        "branch at pi": "w = 0: the sign of the axis is that of LAPACK's eigenvector",
        "domain": "mat2quat takes any matrix, and documents the nearest rotation for one that is none",
        "rotations off the manifold": "the adapter refuses them beyond 1e-6",
    },
    snippets=SNIPPETS,
)
