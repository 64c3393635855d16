"""RoMa: conversions of rotations, slerp of quaternions, and the nearest rotation for the polar factor."""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

import roma
import torch

from affinecert.subject import Subject
from affinecert.subjects.on_tensors import on_tensors


@on_tensors
def quaternion_slerp(start: Any, end: Any, t: Any) -> Any:
    """The quaternions (N, 4) at t (N,) between two; item by item, since RoMa crosses every step with every pair."""
    p, q = (roma.quat_normalize(roma.quat_wxyz_to_xyzw(item)) for item in (start, end))
    return roma.quat_xyzw_to_wxyz(torch.stack([roma.unitquat_slerp(*item) for item in zip(p, q, t, strict=True)]))


@on_tensors
def polar_decompose(linear: Any) -> Any:
    """Rotations R and stretches R^T L (N, d, d) of linear maps L (N, d, d)."""
    rotation = roma.special_procrustes(linear)
    return rotation, rotation.mT @ linear


SNIPPETS = {
    "so3.exp": """import roma, torch
omega = torch.tensor({input0}, dtype=torch.float64)
print(roma.rotvec_to_rotmat(omega).tolist())""",
    "so3.log": """import roma, torch
rotation = torch.tensor({input0}, dtype=torch.float64)
print(roma.rotmat_to_rotvec(rotation).tolist())""",
    "quaternion.slerp": """import roma, torch
quaternions = torch.tensor([{input0}, {input1}], dtype=torch.float64)
p, q = roma.quat_normalize(roma.quat_wxyz_to_xyzw(quaternions))
print(roma.quat_xyzw_to_wxyz(roma.unitquat_slerp(p, q, torch.tensor({input2}, dtype=torch.float64))).tolist())""",
    "polar.decompose": """import roma, torch
linear = torch.tensor({input0}, dtype=torch.float64)
rotation = roma.special_procrustes(linear)
print([rotation.tolist(), (rotation.mT @ linear).tolist()])""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="roma",
    version=version("roma"),
    maps={
        "so3.exp": on_tensors(roma.rotvec_to_rotmat),
        "so3.log": on_tensors(roma.rotmat_to_rotvec),
        "quaternion.slerp": quaternion_slerp,
        "polar.decompose": polar_decompose,
    },
    conventions={
        "quaternions": "(x, y, z, w), of unit length; the adapter reorders, and normalises by quat_normalize",
        "branch at pi": "rotmat_to_rotvec: the sign at exactly pi is documented nowhere",
        "polar factors": "special_procrustes gives R; the stretch is R^T L, by the adapter",
        "rigid motions": "classes without exponential and logarithm",
    },
    policies={
        "determinant is not positive": "special_procrustes: the rotation nearest to the matrix, whatever that is",
        "not a rotation": "rotmat_to_rotvec: documented for rotation matrices, which are not checked",
        "off the manifold": "rotmat_to_rotvec: documented for rotation matrices, a unit quaternion even slightly off",
        "not a unit quaternion": "quat_normalize: a copy of unit length of any quaternion but 0, which gives NaN",
    },
    snippets=SNIPPETS,
)
