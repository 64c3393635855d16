"""What the subjects on torch share: their maps take and return tensors, in float64 and on one thread."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

import torch

from affinecert.map import Array

# Certifying runs one process a core already; torch's own threads would only wait for each other.
torch.set_num_threads(1)


def on_tensors(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function of tensors as one of arrays; no gradient is kept."""

    @wraps(function)
    def of_arrays(*arrays: Array) -> Any:
        with torch.no_grad():
            result = function(*(torch.from_numpy(array) for array in arrays))
        return tuple(part.numpy() for part in result) if isinstance(result, tuple) else result.numpy()

    return of_arrays
