"""spatialmath-python: `spatialmath.base`, the functions that its classes SO3, SE3 and Twist3 call."""

from __future__ import annotations

from importlib.metadata import version

import numpy as np
from spatialmath import base

from affinecert.map import Array
from affinecert.subject import Subject


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return np.stack([base.trexp(item) for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return np.stack([base.trlog(item, twist=True) for item in rotation])


def se3_exp(twist: Array) -> Array:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return np.stack([base.trexp(np.roll(item, 3)) for item in twist])


def se3_log(pose: Array) -> Array:
    """The twists (N, 6) of poses (N, 4, 4)."""
    return np.stack([np.roll(base.trlog(item, twist=True), 3) for item in pose])


def normalised(quaternions: Array) -> Array:
    """The quaternions (N, 4) divided by their lengths, which are to be 1: qslerp takes that for granted."""
    lengths = np.linalg.norm(quaternions, axis=-1, keepdims=True)
    if not np.all(np.abs(lengths - 1) <= 1e-6):
        raise ValueError("not a unit quaternion")
    return np.asarray(quaternions / lengths)


def slerp(start: Array, end: Array, t: Array) -> Array:
    """The quaternions (N, 4) between quaternions (N, 4), of the sign that the start has."""
    values = []
    for p, q, time in zip(normalised(start), normalised(end), t, strict=True):
        value = base.qslerp(p, q, float(time), shortest=True)
        # For the shorter arc it turns the start round, though not at the time 0.
        values.append(-value if np.dot(p, q) < 0 and time != 0 else value)
    return np.stack(values)


SNIPPETS = {
    "so3.exp": """import numpy as np
from spatialmath import base
print(base.trexp(np.array({input0})).tolist())""",
    "so3.log": """import numpy as np
from spatialmath import base
print(base.trlog(np.array({input0}), twist=True).tolist())""",
    "se3.exp": """import numpy as np
from spatialmath import base
print(base.trexp(np.roll({input0}, 3)).tolist())""",
    "se3.log": """import numpy as np
from spatialmath import base
print(np.roll(base.trlog(np.array({input0}), twist=True), 3).tolist())""",
    "quaternion.slerp": """import numpy as np
from spatialmath import base
p, q, t = *(np.array(x) / np.linalg.norm(x, axis=-1) for x in ({input0}, {input1})), {input2}
print((base.qslerp(p, q, t, shortest=True) * (-1 if p @ q < 0 and t != 0 else 1)).tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="spatialmath",
    version=version("spatialmath-python"),
    maps={"so3.exp": so3_exp, "so3.log": so3_log, "se3.exp": se3_exp, "se3.log": se3_log, "quaternion.slerp": slerp},
    conventions={
        "vectors": "columns; matrices act from the left; homogeneous matrices (4, 4) with last row 0 0 0 1",
        "twists": "(v, omega): translation first; the adapter swaps",
        "branch at pi": "the sign of the axis at exactly pi is documented nowhere",
        "quaternions": "(w, x, y, z), taken for unit ones; the adapter normalises them (qunit would change signs)",
        "slerp": "shortest=True; where p . q < 0 it goes from -p to q, the same rotations; the adapter takes the sign "
        "back",
    },
    refusals={
        "s must be in the interval [0,1]": "qslerp 'raises ValueError: s is outside interval [0, 1]'",
        "Expect SO(3) or SE(3) matrix": "trlog: 'check that matrix is valid', to tol=20 units of eps",
    },
    snippets=SNIPPETS,
)
