"""kornia: `kornia.geometry.conversions` for rotations, `Se3` for rigid motions, `Quaternion` for slerp.

`So3`, which has other code than the conversions, is the subject `kornia_liegroup`.
"""

from __future__ import annotations

from typing import Any

import kornia
from kornia.geometry import conversions
from kornia.geometry.liegroup import Se3
from kornia.geometry.quaternion import Quaternion

from affinecert.subject import Subject
from affinecert.subjects.on_tensors import on_tensors


@on_tensors
def se3_exp(twist: Any) -> Any:
    """The poses (N, 4, 4) of twists (N, 6); kornia's have the translation first."""
    return Se3.exp(twist.roll(3, -1)).matrix()


@on_tensors
def se3_log(pose: Any) -> Any:
    """The twists (N, 6) of poses (N, 4, 4)."""
    return Se3.from_matrix(pose).log().roll(3, -1)


@on_tensors
def quaternion_slerp(start: Any, end: Any, t: Any) -> Any:
    """The quaternions (N, 4) at t (N,) between two."""
    return Quaternion(start).slerp(Quaternion(end), t).data


SNIPPETS = {
    "so3.exp": """import torch
from kornia.geometry.conversions import axis_angle_to_rotation_matrix
print(axis_angle_to_rotation_matrix(torch.tensor([{input0}], dtype=torch.float64))[0].tolist())""",
    "so3.log": """import torch
from kornia.geometry.conversions import rotation_matrix_to_axis_angle
print(rotation_matrix_to_axis_angle(torch.tensor([{input0}], dtype=torch.float64))[0].tolist())""",
    "se3.exp": """import torch
from kornia.geometry.liegroup import Se3
print(Se3.exp(torch.tensor([{input0}], dtype=torch.float64).roll(3, -1)).matrix()[0].tolist())""",
    "se3.log": """import torch
from kornia.geometry.liegroup import Se3
print(Se3.from_matrix(torch.tensor([{input0}], dtype=torch.float64)).log().roll(3, -1)[0].tolist())""",
    "quaternion.slerp": """import torch
from kornia.geometry.quaternion import Quaternion
p, q, t = (torch.tensor([x], dtype=torch.float64) for x in ({input0}, {input1}, {input2}))
print(Quaternion(p).slerp(Quaternion(q), t).data[0].tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="kornia",
    version=kornia.__version__,
    maps={
        "so3.exp": on_tensors(conversions.axis_angle_to_rotation_matrix),
        "so3.log": on_tensors(conversions.rotation_matrix_to_axis_angle),
        "se3.exp": se3_exp,
        "se3.log": se3_log,
        "quaternion.slerp": quaternion_slerp,
    },
    conventions={
        "quaternions": "(w, x, y, z), as here",
        "twists": "(v, omega): the adapter swaps the halves",
        "branch at pi": "documented: at real part exactly 0 the sign is that of the quaternion found",
        "slerp": "normalises both, goes the shorter way; either way where they are orthogonal to the last bit",
    },
    policies={
        "not a rotation": "documented: by default the matrix is not checked (check_rotation=True would refuse it)",
        "last row must be": "Se3.from_matrix: documented to check the rotation block only, and that if asked to",
        "off the manifold": "documented for rotation matrices; unchecked, their entries are taken as they are",
        "not a unit quaternion": "normalize_quaternion: divides by the length, and leaves 0, documented, as it is",
    },
    snippets=SNIPPETS,
)
