"""torch itself, one matrix a call: for a single matrix `torch.linalg.matrix_exp` has other code than for a batch."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects import torch_batch


def one_by_one(batched: Callable[..., Any]) -> Callable[..., Array]:
    """The function of a batch, called with batches of one."""
    return lambda *arrays: np.concatenate(
        [batched(*(array[i : i + 1] for array in arrays)) for i in range(len(arrays[0]))]
    )


SNIPPETS = {
    "so3.exp": """import torch
x, y, z = {input0}
generator = torch.tensor([[0, -z, y], [z, 0, -x], [-y, x, 0]], dtype=torch.float64)
print(torch.linalg.matrix_exp(generator).tolist())""",
    "se3.exp": """import torch
a, b, c, x, y, z = {input0}
generator = torch.tensor([[0, -c, b, x], [c, 0, -a, y], [-b, a, 0, z], [0, 0, 0, 0]], dtype=torch.float64)
print(torch.linalg.matrix_exp(generator).tolist())""",
    "sim3.exp": """import torch
a, b, c, x, y, z, g = {input0}
generator = torch.tensor([[g, -c, b, x], [c, g, -a, y], [-b, a, g, z], [0, 0, 0, 0]], dtype=torch.float64)
print(torch.linalg.matrix_exp(generator).tolist())""",
    "shear.exp": """import torch
a, b, c, d, e = {input0}
generator = torch.tensor([[0, a, c], [0, b, d], [0, 0, e]], dtype=torch.float64)
print(torch.linalg.matrix_exp(generator).tolist())""",
    "sym3.exp": """import torch
print(torch.linalg.matrix_exp(torch.tensor({input0}, dtype=torch.float64)).tolist())""",
    "scale.exp": """import torch
print(torch.exp(torch.tensor({input0}, dtype=torch.float64)).item())""",
    "scale.log": """import torch
print(torch.log(torch.tensor({input0}, dtype=torch.float64)).item())""",
}
"""How the maps are called without affinecert: the templates of `Subject.snippets`."""

subject = Subject(
    name="torch",
    version=torch_batch.subject.version,
    maps={name: one_by_one(torch_batch.subject.maps[name]) for name in SNIPPETS},
    conventions={
        **torch_batch.subject.conventions,
        "matrix exponential": "torch.linalg.matrix_exp at the generator that the adapter packs, one by one",
    },
    policies={"off the manifold of symmetric": "matrix_exp is of general matrices, and takes each as it is"},
    snippets=SNIPPETS,
)
