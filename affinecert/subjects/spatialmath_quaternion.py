"""spatialmath-python's `UnitQuaternion`: rotations by its exponential and logarithm of quaternions."""

from __future__ import annotations

from importlib.metadata import version

import numpy as np
from spatialmath import Quaternion, UnitQuaternion, base

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.preconditions import require_rotations


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return np.stack([Quaternion.Pure(item / 2).exp().R for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    require_rotations(rotation)
    return np.stack([2 * UnitQuaternion(base.r2q(item, shortest=True)).log().v for item in rotation])


SNIPPETS = {
    "so3.exp": """import numpy as np
from spatialmath import Quaternion
print(Quaternion.Pure(np.array({input0}) / 2).exp().R.tolist())""",
    "so3.log": """import numpy as np
from spatialmath import UnitQuaternion, base
print((2 * UnitQuaternion(base.r2q(np.array({input0}), shortest=True)).log().v).tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="spatialmath_quaternion",
    version=version("spatialmath-python"),
    maps={"so3.exp": so3_exp, "so3.log": so3_log},
    conventions={
        "vectors": "columns; matrices act from the left",
        "quaternions": "(w, x, y, z); r2q with shortest=True gives w >= 0",
        "rotations off the manifold": "r2q does not check, as documented; the adapter refuses beyond 1e-6",
        "slerp": "UnitQuaternion.interp has the formulas of base.qslerp, which is in `spatialmath`",
    },
    policies={"off the manifold": "r2q: 'There is no check that the passed matrix is a valid rotation matrix.'"},
    snippets=SNIPPETS,
)
