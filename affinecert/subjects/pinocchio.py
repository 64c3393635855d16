"""Pinocchio: SO(3) and SE(3) by matrices. Its code for quaternions is another, and `pinocchio_quaternion` here."""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.rotors import normalised


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return np.stack([pin.exp3(item) for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return np.stack([pin.log3(item) for item in rotation])


def se3_exp(twist: Array) -> Array:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return np.stack([pin.exp6(np.roll(item, 3)).homogeneous for item in twist])


def se3_log(pose: Array) -> Array:
    """The twists (N, 6) of poses (N, 4, 4)."""
    return np.stack([np.roll(pin.log6(item).vector, 3) for item in pose])


def slerp(start: Array, end: Array, t: Array) -> Array:
    """The quaternions (N, 4) between quaternions (N, 4): Eigen's, which Pinocchio's Python package wraps."""
    ends = [[pin.Quaternion(*item) for item in normalised(items)] for items in (start, end)]
    between = [p.slerp(float(time), q).coeffs() for p, q, time in zip(*ends, t, strict=True)]
    return np.roll(np.stack(between), 1, axis=-1)


def sclerp(start: Array, end: Array, t: Array) -> Array:
    """The poses (N, 4, 4) on the screw motions between poses (N, 4, 4)."""
    triples = zip(start, end, t, strict=True)
    return np.stack([pin.SE3.Interpolate(pin.SE3(b), pin.SE3(c), float(time)).homogeneous for b, c, time in triples])


SNIPPETS = {
    "so3.exp": """import numpy as np
import pinocchio as pin
print(pin.exp3(np.array({input0})).tolist())""",
    "so3.log": """import numpy as np
import pinocchio as pin
print(pin.log3(np.array({input0})).tolist())""",
    "se3.exp": """import numpy as np
import pinocchio as pin
print(pin.exp6(np.roll({input0}, 3)).homogeneous.tolist())""",
    "se3.log": """import numpy as np
import pinocchio as pin
print(np.roll(pin.log6(np.array({input0})).vector, 3).tolist())""",
    "quaternion.slerp": """import numpy as np
import pinocchio as pin
p, q = (pin.Quaternion(*(np.array(x) / np.linalg.norm(x, axis=-1))) for x in ({input0}, {input1}))
print(np.roll(p.slerp({input2}, q).coeffs(), 1).tolist())""",
    "morphs.sclerp": """import numpy as np
import pinocchio as pin
start, end = pin.SE3(np.array({input0})), pin.SE3(np.array({input1}))
print(pin.SE3.Interpolate(start, end, {input2}).homogeneous.tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="pinocchio",
    version=pin.__version__,
    maps={
        "so3.exp": so3_exp,
        "so3.log": so3_log,
        "se3.exp": se3_exp,
        "se3.log": se3_log,
        "quaternion.slerp": slerp,
        "morphs.sclerp": sclerp,
    },
    conventions={
        "vectors": "columns; matrices act from the left; homogeneous matrices (4, 4) with last row 0 0 0 1",
        "rotations": "log3: angle in [0, pi]",
        "branch at pi": "the sign of log3 at exactly pi is that of R[2,1] - R[1,2] or the like, documented nowhere",
        "twists": "Motion: (vx, vy, vz, omega_x, omega_y, omega_z), translation first, swapped here",
        "slerp": "Quaternion.slerp is Eigen's; for t in [0, 1]; lengths are not looked at, so the adapter normalises",
        "screw motion": "SE3.Interpolate(B, C, t) = B exp6(t log6(B^-1 C))",
        "planar groups": "liegroups.SO2 and SE2 are left out: the catalogue has no rigid motions of the plane alone",
    },
    policies={
        "not a rotation": "documented for rotation matrices, which are not checked",
        "last row must be": "SE3(M) is for homogeneous matrices, whose last row it does not look at",
        "off the manifold": "log3 and log6 are for rotation matrices, and take what is nearly one as it is",
    },
    snippets=SNIPPETS,
)
