"""pytransform3d, the functions of batches: `pytransform3d.batch_rotations` and `pytransform3d.trajectories`.

They check nothing: that is left to the functions of single items, here as in the library's documentation.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

import numpy as np
from pytransform3d import batch_rotations, rotations, trajectories, transformations

from affinecert.map import Array
from affinecert.subject import Subject


def so3_exp(omega: Array) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return batch_rotations.matrices_from_compact_axis_angles(omega)


def so3_log(rotation: Array) -> Any:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    for item in rotation:
        rotations.check_matrix(item)
    axes_and_angles = batch_rotations.axis_angles_from_matrices(rotation)
    return axes_and_angles[:, 3:] * axes_and_angles[:, :3]


def se3_exp(twist: Array) -> Any:
    """The poses (N, 4, 4) of twists (N, 6)."""
    return trajectories.transforms_from_exponential_coordinates(twist)


def se3_log(pose: Array) -> Any:
    """The twists (N, 6) of poses (N, 4, 4)."""
    for item in pose:
        transformations.check_transform(item)
    return trajectories.exponential_coordinates_from_transforms(pose)


def slerp(start: Array, end: Array, t: Array) -> Array:
    """The quaternions (N, 4) between quaternions (N, 4): the library has batches of times, for one pair each."""
    items = zip(start, end, t, strict=True)
    return np.stack(
        [
            batch_rotations.quaternion_slerp_batch(
                rotations.check_quaternion(p), rotations.check_quaternion(q), time[None], shortest_path=True
            )[0]
            for p, q, time in items
        ]
    )


def sclerp(start: Array, end: Array, t: Array) -> Any:
    """The poses (N, 4, 4) between poses (N, 4, 4), by powers of dual quaternions."""
    for item in (*start, *end):
        transformations.check_transform(item)
    origin = trajectories.dual_quaternions_from_transforms(start)
    goal = trajectories.dual_quaternions_from_transforms(end)
    # The library leaves it to its user to take the nearer one of the two dual quaternions of a pose.
    goal[np.sum(origin[:, :4] * goal[:, :4], axis=-1) < 0] *= -1
    return trajectories.transforms_from_dual_quaternions(trajectories.dual_quaternions_sclerp(origin, goal, t))


SNIPPETS = {
    "so3.exp": """import numpy as np
from pytransform3d.batch_rotations import matrices_from_compact_axis_angles
print(matrices_from_compact_axis_angles(np.array([{input0}]))[0].tolist())""",
    "so3.log": """import numpy as np
from pytransform3d.batch_rotations import axis_angles_from_matrices
((*axis, angle),) = axis_angles_from_matrices(np.array([{input0}]))
print((angle * np.array(axis)).tolist())""",
    "se3.exp": """import numpy as np
from pytransform3d.trajectories import transforms_from_exponential_coordinates
print(transforms_from_exponential_coordinates(np.array([{input0}]))[0].tolist())""",
    "se3.log": """import numpy as np
from pytransform3d.trajectories import exponential_coordinates_from_transforms
print(exponential_coordinates_from_transforms(np.array([{input0}]))[0].tolist())""",
    "quaternion.slerp": """import numpy as np
from pytransform3d import batch_rotations, rotations
p, q = rotations.check_quaternion({input0}), rotations.check_quaternion({input1})
print(batch_rotations.quaternion_slerp_batch(p, q, np.array([{input2}]), shortest_path=True)[0].tolist())""",
    "morphs.sclerp": """import numpy as np
from pytransform3d import trajectories as tr
p, q = tr.dual_quaternions_from_transforms(np.array([{input0}, {input1}])); q = -q if p[:4] @ q[:4] < 0 else q
print(tr.transforms_from_dual_quaternions(tr.dual_quaternions_sclerp(p[None], q[None], [{input2}]))[0].tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="pytransform3d_batch",
    version=version("pytransform3d"),
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
        "rotations": "axis-angles in radians; quaternions (w, x, y, z)",
        "twists": "exponential coordinates (omega, v): rotation first, as here",
        "branch at pi": "angles in [0, pi]; the axis at exactly pi is documented nowhere",
        "rotations off the manifold": "not checked in batches; the adapter calls check_matrix and check_transform",
        "slerp": "shortest_path=True; the adapter normalises by check_quaternion, as the function of single items does",
        "sclerp": "dual_quaternions_sclerp; the adapter turns the end's sign where the real parts' product is negative",
    },
    policies={
        "not a unit quaternion": "check_quaternion normalises: unit=True is its default",
        "off the manifold": "documented for rotation matrices, which are not checked in batches but taken as they are",
    },
    snippets=SNIPPETS,
)
