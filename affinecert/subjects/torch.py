"""torch itself, one matrix a call: for a single matrix `torch.linalg.matrix_exp` has other code than for a batch."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects import torch_batch


def one_by_one(batched: Callable[..., Any]) -> Callable[[Array], Array]:
    """The function of a batch, called with batches of one."""
    return lambda generators: np.concatenate([batched(generators[i : i + 1]) for i in range(len(generators))])


subject = Subject(
    name="torch",
    version=torch_batch.subject.version,
    maps={name: one_by_one(batched) for name, batched in torch_batch.subject.maps.items()},
    conventions={
        **torch_batch.subject.conventions,
        "matrix exponential": "torch.linalg.matrix_exp at the generator that the adapter packs, one by one",
    },
)
