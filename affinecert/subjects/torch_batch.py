"""torch itself on batches: `torch.linalg.matrix_exp` at the generators of each group, and `lerp`, `qr` and `det`.

torch has no matrix logarithm, no fractional power and no polar factors as functions.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import torch

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.generators import SHEAR_COLUMNS, SHEAR_ROWS
from affinecert.subjects.on_tensors import on_tensors
from affinecert.subjects.preconditions import require_affine, require_last_row, require_symmetric


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


@on_tensors
def matrix_exp(matrix: Any) -> Any:
    """The exponentials (N, 3, 3) of matrices (N, 3, 3)."""
    return torch.linalg.matrix_exp(matrix)


def sym3_exp(matrix: Array) -> Any:
    """The exponentials (N, 3, 3) of symmetric matrices (N, 3, 3)."""
    require_symmetric(matrix)
    return matrix_exp(matrix)


@on_tensors
def lerp(start: Any, end: Any, t: Any) -> Any:
    """(1 - t) B + t C of matrices (N, n, n) and times (N,)."""
    return torch.lerp(start, end, t[:, None, None])


def linear(start: Array, end: Array, t: Array) -> Any:
    """The poses (N, n, n) in between poses (N, n, n), entry by entry."""
    require_affine(start)
    require_affine(end)
    return lerp(start, end, t)


def homotopy(matrix: Array, t: Array) -> Any:
    """The matrices (N, 2, 2) in between the identity and matrices (N, 2, 2), entry by entry."""
    return lerp(np.broadcast_to(np.eye(2), matrix.shape).copy(), matrix, t)


@on_tensors
def triangle_and_rotation(linear: Any) -> Any:
    """K and Q (N, 3, 3) with L = K Q, K upper triangular of positive diagonal: J L^T J = Q' U, J the reversed axes."""
    turn, triangle = torch.linalg.qr(linear.mT.flip(-1, -2))
    signs = torch.where(triangle.diagonal(dim1=-2, dim2=-1) < 0, -1.0, 1.0).to(linear.dtype)
    return (signs[:, :, None] * triangle).mT.flip(-1, -2), (turn * signs[:, None, :]).mT.flip(-1, -2)


def affine_lie_decompose(affine: Array) -> tuple[Array, Array, Array]:
    """Rigid (N, 4, 4), shear (N, 3, 3) and scale (N,) of affine maps (N, 4, 4)."""
    require_affine(affine)
    triangle, rotation = triangle_and_rotation(affine[:, :3, :3])
    rigid = np.broadcast_to(np.eye(4), affine.shape).copy()
    rigid[:, :3, :3] = rotation
    rigid[:, :3, 3:] = np.linalg.solve(triangle, affine[:, :3, 3:])
    scale = triangle[:, 0, 0]
    return rigid, triangle / scale[:, None, None], scale


@on_tensors
def determinants(matrices: Any) -> Any:
    """The determinants (N, k) of matrices (N, k, n, n)."""
    return torch.linalg.det(matrices)


def volume(poses: Array) -> Any:
    """The determinants (N, k) of the linear parts of poses (N, k, n, n)."""
    for path in poses:
        require_last_row(path)
    return determinants(poses[:, :, :-1, :-1])


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
    "sym3.exp": """import torch
print(torch.linalg.matrix_exp(torch.tensor([{input0}, {input0}], dtype=torch.float64))[0].tolist())""",
    "scale.exp": """import torch
print(torch.exp(torch.tensor([{input0}] * 4, dtype=torch.float64))[0].item())""",
    "scale.log": """import torch
print(torch.log(torch.tensor([{input0}] * 4, dtype=torch.float64))[0].item())""",
    "affine_lie.decompose": """import numpy as np, torch
A = torch.tensor({input0}, dtype=torch.float64); Q, U = torch.linalg.qr(A[:3, :3].T.flip(0, 1))
s = U.diag().sign(); K = (s[:, None] * U).T.flip(0, 1).numpy(); R = (Q * s).T.flip(0, 1).numpy()
print([[*np.c_[R, np.linalg.solve(K, A[:3, 3])].tolist(), [0, 0, 0, 1]], (K / K[0, 0]).tolist(), float(K[0, 0])])""",
    "morphs.linear": """import torch
start, end = torch.tensor([{input0}, {input1}], dtype=torch.float64)
print(torch.lerp(start, end, {input2}).tolist())""",
    "homotopy2.linear": """import torch
print(torch.lerp(torch.eye(2, dtype=torch.float64), torch.tensor({input0}, dtype=torch.float64), {input1}).tolist())""",
    "measures.volume": """import torch
print(torch.linalg.det(torch.tensor({input0}, dtype=torch.float64)[:, :-1, :-1]).tolist())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="torch_batch",
    version=torch.__version__,
    maps={
        "so3.exp": so3_exp,
        "se3.exp": se3_exp,
        "sim3.exp": sim3_exp,
        "scale.exp": on_tensors(torch.exp),
        "scale.log": on_tensors(torch.log),
        "shear.exp": shear_exp,
        "sym3.exp": sym3_exp,
        "affine_lie.decompose": affine_lie_decompose,
        "morphs.linear": linear,
        "homotopy2.linear": homotopy,
        "measures.volume": volume,
    },
    conventions={
        "matrix exponential": "torch.linalg.matrix_exp at the generators that the adapter packs, all at once",
        "matrices": "any square one is taken; the adapter refuses what is outside the domain of each map",
        "interpolation": "torch.lerp, entry by entry",
        "triangular factor": "torch.linalg.qr of the transpose, axes reversed; the adapter makes the diagonal positive",
    },
    policies={"off the manifold of symmetric": "matrix_exp is of general matrices, and takes each as it is"},
    snippets=SNIPPETS,
)
