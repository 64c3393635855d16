"""Pinocchio: SO(3) and SE(3) by quaternions, which is other code than that of `pinocchio` here, by matrices."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from pinocchio import liegroups

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.rotors import normalised

ROTATIONS, MOTIONS = liegroups.SO3(), liegroups.SE3()


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return np.stack([pin.Quaternion(pin.exp3_quat(item)).matrix() for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    return np.stack([pin.log3(pin.Quaternion(item).coeffs()) for item in rotation])


def se3_exp(twist: Array) -> Array:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return np.stack([pin.XYZQUATToSE3(pin.exp6_quat(np.roll(item, 3))).homogeneous for item in twist])


def se3_log(pose: Array) -> Array:
    """The twists (N, 6) of poses (N, 4, 4)."""
    return np.stack([np.roll(pin.log6_quat(pin.SE3ToXYZQUAT(pin.SE3(item))).vector, 3) for item in pose])


def slerp(start: Array, end: Array, t: Array) -> Array:
    """The quaternions (N, 4) between quaternions (N, 4), normalised first, as the group asks."""
    triples = zip(np.roll(normalised(start), -1, axis=-1), np.roll(normalised(end), -1, axis=-1), t, strict=True)
    between = [ROTATIONS.interpolate(p, q, float(time)) for p, q, time in triples]
    return np.roll(np.stack(between), 1, axis=-1)


def sclerp(start: Array, end: Array, t: Array) -> Array:
    """The poses (N, 4, 4) on the screw motions between poses (N, 4, 4)."""
    ends = [[pin.SE3ToXYZQUAT(pin.SE3(item)) for item in items] for items in (start, end)]
    between = [MOTIONS.interpolate(b, c, float(time)) for b, c, time in zip(*ends, t, strict=True)]
    return np.stack([pin.XYZQUATToSE3(item).homogeneous for item in between])


SNIPPETS = {
    "so3.exp": """import numpy as np
import pinocchio as pin
print(pin.Quaternion(pin.exp3_quat(np.array({input0}))).matrix().tolist())""",
    "so3.log": """import numpy as np
import pinocchio as pin
print(pin.log3(pin.Quaternion(np.array({input0})).coeffs()).tolist())""",
    "se3.exp": """import numpy as np
import pinocchio as pin
print(pin.XYZQUATToSE3(pin.exp6_quat(np.roll({input0}, 3))).homogeneous.tolist())""",
    "se3.log": """import numpy as np
import pinocchio as pin
print(np.roll(pin.log6_quat(pin.SE3ToXYZQUAT(pin.SE3(np.array({input0})))).vector, 3).tolist())""",
    "quaternion.slerp": """import numpy as np
import pinocchio as pin
p, q = (np.roll(np.array(x) / np.linalg.norm(x, axis=-1), -1) for x in ({input0}, {input1}))
print(np.roll(pin.liegroups.SO3().interpolate(p, q, {input2}), 1).tolist())""",
    "morphs.sclerp": """import numpy as np
import pinocchio as pin
b, c = (pin.SE3ToXYZQUAT(pin.SE3(np.array(pose))) for pose in ({input0}, {input1}))
print(pin.XYZQUATToSE3(pin.liegroups.SE3().interpolate(b, c, {input2})).homogeneous.tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="pinocchio_quaternion",
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
        "rotations": "exp3_quat, log3, exp6_quat, log6_quat: unit quaternions (x, y, z, w); angle in [0, pi]",
        "branch at pi": "the sign at exactly pi is that of the quaternion found, documented nowhere",
        "twists": "Motion: (vx, vy, vz, omega_x, omega_y, omega_z), translation first, swapped here",
        "interpolation": "liegroups.SO3().interpolate is a slerp, liegroups.SE3().interpolate the screw motion",
    },
    policies={
        "not a rotation": "documented for rotation matrices, which are not checked",
        "last row must be": "SE3(M) is for homogeneous matrices, whose last row it does not look at",
        "off the manifold": "Quaternion(R) is Eigen's, for rotation matrices, and takes what is nearly one as it is",
    },
    snippets=SNIPPETS,
)
