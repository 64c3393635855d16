"""torch itself on batches: `torch.linalg.matrix_exp`, a general matrix exponential, at the generators of each group.

torch has no matrix logarithm, no fractional power and no polar factors as functions.
"""

from __future__ import annotations

from typing import Any

import torch

from affinecert.subject import Subject
from affinecert.subjects.on_tensors import on_tensors

SHEAR_ROWS = (0, 1, 0, 1, 2)
SHEAR_COLUMNS = (1, 1, 2, 2, 2)
"""Where alpha_1 to alpha_5 stand in an element of G_A, [[1, α1, α3], [0, α2, α4], [0, 0, α5]]."""


def cross(omega: Any) -> Any:
    """The matrices (N, 3, 3) that take p to omega x p."""
    x, y, z = omega.unbind(-1)
    o = torch.zeros_like(x)
    return torch.stack([o, -z, y, z, o, -x, -y, x, o], dim=-1).reshape(-1, 3, 3)


@on_tensors
def so3_exp(omega: Any) -> Any:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3)."""
    return torch.linalg.matrix_exp(cross(omega))


@on_tensors
def se3_exp(twist: Any) -> Any:
    """The poses (N, 4, 4) of twists (N, 6)."""
    generator = twist.new_zeros(len(twist), 4, 4)
    generator[:, :3, :3] = cross(twist[:, :3])
    generator[:, :3, 3] = twist[:, 3:]
    return torch.linalg.matrix_exp(generator)


@on_tensors
def sim3_exp(tangent: Any) -> Any:
    """The similarities (N, 4, 4) of tangents (N, 7)."""
    generator = tangent.new_zeros(len(tangent), 4, 4)
    generator[:, :3, :3] = cross(tangent[:, :3]) + tangent[:, 6, None, None] * torch.eye(3, dtype=tangent.dtype)
    generator[:, :3, 3] = tangent[:, 3:6]
    return torch.linalg.matrix_exp(generator)


@on_tensors
def shear_exp(shear_twist: Any) -> Any:
    """The elements (N, 3, 3) of G_A from their logarithms (N, 5)."""
    generator = shear_twist.new_zeros(len(shear_twist), 3, 3)
    generator[:, SHEAR_ROWS, SHEAR_COLUMNS] = shear_twist
    return torch.linalg.matrix_exp(generator)


SNIPPETS = {
    "so3.exp": """import torch
x, y, z = {input0}
generator = torch.tensor([[0, -z, y], [z, 0, -x], [-y, x, 0]], dtype=torch.float64)
print(torch.linalg.matrix_exp(torch.stack([generator, generator]))[0].tolist())""",
    "se3.exp": """import torch
a, b, c, x, y, z = {input0}
generator = torch.tensor([[0, -c, b, x], [c, 0, -a, y], [-b, a, 0, z], [0, 0, 0, 0]], dtype=torch.float64)
print(torch.linalg.matrix_exp(torch.stack([generator, generator]))[0].tolist())""",
    "sim3.exp": """import torch
a, b, c, x, y, z, g = {input0}
generator = torch.tensor([[g, -c, b, x], [c, g, -a, y], [-b, a, g, z], [0, 0, 0, 0]], dtype=torch.float64)
print(torch.linalg.matrix_exp(torch.stack([generator, generator]))[0].tolist())""",
    "shear.exp": """import torch
a, b, c, d, e = {input0}
generator = torch.tensor([[0, a, c], [0, b, d], [0, 0, e]], dtype=torch.float64)
print(torch.linalg.matrix_exp(torch.stack([generator, generator]))[0].tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="torch_batch",
    version=torch.__version__,
    maps={"so3.exp": so3_exp, "se3.exp": se3_exp, "sim3.exp": sim3_exp, "shear.exp": shear_exp},
    conventions={
        "matrix exponential": "torch.linalg.matrix_exp at the generators that the adapter packs, all at once",
        "symmetric matrices": "not offered: matrix_exp takes any square matrix, and knows of no symmetric part",
    },
    snippets=SNIPPETS,
)
