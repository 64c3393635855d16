"""The reference, rounded to float64: what a perfect implementation answers. It has no findings."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import version

import numpy as np

from affinecert.catalogue import CATALOGUE
from affinecert.errors import InputError
from affinecert.map import Array, Map
from affinecert.subject import Subject
from affinecert.truths import value


def rounded(entry: Map) -> Callable[..., tuple[Array, ...]]:
    """The map as a batch callable that gives the float64 nearest to the truth of each item."""

    def evaluate(*inputs: Array) -> tuple[Array, ...]:
        items = []
        for index, item in enumerate(zip(*inputs, strict=True)):
            truth = value(entry, tuple(np.asarray(array) for array in item))
            if truth.refusal is not None:
                raise InputError(entry.arguments[0].name, truth.refusal, (index,))
            items.append(truth.high)
        return tuple(np.stack(outputs) for outputs in zip(*items, strict=True))

    return evaluate


subject = Subject(
    name="reference",
    version=version("affinecert"),
    maps={name: rounded(entry) for name, entry in CATALOGUE.items()},
    conventions={"all": "those of the catalogue: the definitions, in arbitrary precision, rounded once"},
)
