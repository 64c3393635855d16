"""Kernels in a row: a map's stages hand arrays to one another, so that maps share them and each is compiled once."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from affinecert.errors import InputError
from affinecert.fast._kernel import Array, Kernel, resolve


def run(stage: Kernel, *arrays: Array) -> tuple[Array, ...]:
    """The outputs of a stage for inputs that earlier stages made, or checked: they are not checked again."""
    sizes: dict[str, int] = {}
    batches = []
    for shape, array in zip(stage.inputs.values(), arrays, strict=True):
        cut = array.ndim - len(shape)
        batches.append(array.shape[:cut])
        sizes |= {name: size for name, size in zip(shape, array.shape[cut:], strict=True) if isinstance(name, str)}
    batch = np.broadcast_shapes(*batches)
    outputs = tuple(np.empty(batch + tuple(int(resolve(spec, sizes)) for spec in shape)) for shape in stage.outputs)
    with np.errstate(all="ignore"):
        stage.gufunc(*arrays, *outputs, out=np.zeros(batch, dtype=np.uint8))
    return outputs


def settle(answers: Array, undecided: float, decide: Callable[..., float], *matrices: Array) -> None:
    """Replaces the undecided among the answers on batches of matrices by what ``decide`` says of each item."""
    indices = np.argwhere(answers == undecided)
    if len(indices):
        wide = [np.broadcast_to(matrix, answers.shape + matrix.shape[-2:]) for matrix in matrices]
        for index in map(tuple, indices):
            answers[index] = decide(*(matrix[index] for matrix in wide))


def refuse(answers: Array, answer: float, argument: str, reason: str, batch: tuple[int, ...]) -> None:
    """Raises InputError for the first item of that answer, naming its index in the argument's own batch."""
    found = np.argwhere(answers == answer)
    if len(found):
        index = found[0][answers.ndim - len(batch) :]
        own = tuple(int(i) if size > 1 else 0 for i, size in zip(index, batch, strict=True))
        raise InputError(argument, reason, own)


def require(argument: str, good: NDArray[np.bool_], reason: str) -> None:
    """Raises InputError for the first item of an argument's batch that is not good."""
    refuse(good.astype(np.float64), 0.0, argument, reason, good.shape)
