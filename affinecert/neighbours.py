"""Neighbours: inputs that rounding cannot tell from a given one, where a map that jumps may take its other value.

Between two orthogonal quaternions both arcs are as short, between poses half a turn apart both ways round: the value is
one of two, by a convention and by the last bit of the input. A subject that answers with the other one is no worse.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from affinecert import truths
from affinecert.arithmetic import Arithmetic
from affinecert.map import Array, Map
from affinecert.scoring import Answer, block_score, length

ROUNDINGS = 4
"""By how many units, relative to the length of its argument, an entry is moved: as much as an inner product loses."""


def nudged(inputs: tuple[Array, ...], unit: float) -> Iterator[tuple[Array, ...]]:
    """The inputs with one entry moved by a few roundings, up or down, for each entry."""
    for place, argument in enumerate(inputs):
        step = ROUNDINGS * unit * max(length(argument), 1.0)
        for entry in range(argument.size):
            for change in (step, -step):
                moved = np.array(argument)
                moved.flat[entry] += change
                yield (*inputs[:place], moved, *inputs[place + 1 :])


def right_nearby(
    map: Map, inputs: tuple[Array, ...], answer: Answer, sensitivity: tuple[float, ...], arithmetic: Arithmetic
) -> bool:
    """Whether the answer, of finite numbers in the right shapes, is within the bound of the value at a neighbour."""
    for neighbour in nudged(inputs, arithmetic.unit):
        there = truths.value(map, neighbour)
        if there.refusal is None and all(
            block_score(
                block.name,
                (answer.outputs or ())[block.output][block.where],
                there.high[block.output][block.where],
                there.low[block.output][block.where],
                allowed,
                arithmetic,
            ).scaled
            <= map.bound
            for block, allowed in zip(map.blocks, sensitivity, strict=True)
        ):
            return True
    return False
