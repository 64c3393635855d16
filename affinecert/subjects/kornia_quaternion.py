"""kornia's logarithm of quaternions, `quaternion_exp_to_log`, and its inverse: not used by its other conversions."""

from __future__ import annotations

from typing import Any

import kornia
import torch
from kornia.geometry import conversions

from affinecert.subject import Subject
from affinecert.subjects.on_tensors import on_tensors


@on_tensors
def so3_exp(omega: Any) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return conversions.quaternion_to_rotation_matrix(conversions.quaternion_log_to_exp(omega / 2))


@on_tensors
def so3_log(rotation: Any) -> Any:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    turn = conversions.rotation_matrix_to_quaternion(rotation)
    return 2 * conversions.quaternion_exp_to_log(torch.where(turn[:, :1] < 0, -turn, turn))


SNIPPETS = {
    "so3.exp": """import torch
from kornia.geometry.conversions import quaternion_log_to_exp, quaternion_to_rotation_matrix
q = quaternion_log_to_exp(torch.tensor({input0}, dtype=torch.float64) / 2)
print(quaternion_to_rotation_matrix(q).tolist())""",
    "so3.log": """import torch
from kornia.geometry.conversions import quaternion_exp_to_log, rotation_matrix_to_quaternion
q = rotation_matrix_to_quaternion(torch.tensor({input0}, dtype=torch.float64))
print((2 * quaternion_exp_to_log(q if q[0] >= 0 else -q)).tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="kornia_quaternion",
    version=kornia.__version__,
    maps={"so3.exp": so3_exp, "so3.log": so3_log},
    conventions={
        "quaternions": "(w, x, y, z); their logarithms are half the rotation vectors",
        "branch": "quaternion_exp_to_log keeps the sign of w, documented; the adapter takes the quaternion with w >= 0",
        "small quantities": "eps is left at its default, 1e-8",
    },
    policies={
        "not a rotation": "documented: by default the matrix is not checked (check_rotation=True would refuse it)",
        "off the manifold": "documented for rotation matrices; unchecked, their entries are taken as they are",
    },
    snippets=SNIPPETS,
)
