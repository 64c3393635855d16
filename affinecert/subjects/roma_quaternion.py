"""RoMa by quaternions: rotation vectors to them and on to matrices, and the polar factor as an eigenvector.

From matrices to rotation vectors there is no second way: `rotmat_to_rotvec` goes by quaternions, in `roma` here.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

import roma
import torch

from affinecert.subject import Subject
from affinecert.subjects.on_tensors import on_tensors


@on_tensors
def so3_exp(omega: Any) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return roma.unitquat_to_rotmat(roma.rotvec_to_unitquat(omega))


@on_tensors
def polar_decompose(linear: Any) -> Any:
    """Rotations R and stretches R^T L (N, d, d) of linear maps L (N, d, d).

    The library takes those of space alone; a map L of the plane is given as (L, 0; 0, l), l its largest entry.
    """
    size = linear.shape[-1]
    solid = linear.abs().amax((1, 2))[:, None, None] * torch.eye(3, dtype=linear.dtype)
    solid[:, :size, :size] = linear
    rotation = roma.unitquat_to_rotmat(roma.special_procrustes_unitquat(solid))[:, :size, :size]
    return rotation, rotation.mT @ linear


SNIPPETS = {
    "so3.exp": """import roma, torch
omega = torch.tensor({input0}, dtype=torch.float64)
print(roma.unitquat_to_rotmat(roma.rotvec_to_unitquat(omega)).tolist())""",
    "polar.decompose": """import roma, torch
L = torch.tensor({input0}, dtype=torch.float64); n = len(L); M = L.abs().max() * torch.eye(3).double(); M[:n, :n] = L
rotation = roma.unitquat_to_rotmat(roma.special_procrustes_unitquat(M))[:n, :n]
print([rotation.tolist(), (rotation.mT @ L).tolist()])""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="roma_quaternion",
    version=version("roma"),
    maps={"so3.exp": so3_exp, "polar.decompose": polar_decompose},
    conventions={
        "quaternions": "(x, y, z, w), of unit length",
        "polar factors": "special_procrustes_unitquat gives R, of space alone; the stretch is R^T L, by the adapter",
    },
    policies={
        "determinant is not positive": "special_procrustes_unitquat: the rotation nearest to the matrix, whatever it is"
    },
    snippets=SNIPPETS,
)
