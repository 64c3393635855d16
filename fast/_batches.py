"""Batches of what is no kernel: maps whose items are solved one after another."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast._kernel import Array, Shape, checked, resolve


def each(
    inputs: Mapping[str, Shape],
    arguments: Sequence[ArrayLike],
    varying: str,
    prepare: Callable[..., Callable[[Array], Array]],
    output: Shape,
) -> Array:
    """The answers for a batch, (..., *output), item by item.

    ``prepare`` takes all arguments but the ``varying`` one, and gives what takes that: it is called once for
    successive items that have the others in common. An InputError is told with the index in the argument's own batch.
    """
    arrays, batches, sizes = checked(inputs, arguments)
    batch = np.broadcast_shapes(*batches)
    answers = np.empty((*batch, *(int(resolve(size, sizes)) for size in output)))
    names = list(inputs)
    last: tuple[Any, Callable[[Array], Array]] | None = None
    for index in np.ndindex(*batch):
        places = {name: _own(index, own) for name, own in zip(names, batches, strict=True)}
        items = {name: array[places[name]] for name, array in zip(names, arrays, strict=True)}
        key = [places[name] for name in names if name != varying]
        try:
            if last is None or last[0] != key:
                last = key, prepare(*(items[name] for name in names if name != varying))
            answers[index] = last[1](items[varying])
        except InputError as error:
            raise InputError(error.argument, error.reason, places[error.argument]) from None
    return answers


def _own(index: tuple[int, ...], batch: tuple[int, ...]) -> tuple[int, ...]:
    """An index of the broadcast batch in the batch of one argument."""
    tail = index[len(index) - len(batch) :]
    return tuple(i if size > 1 else 0 for i, size in zip(tail, batch, strict=True))
