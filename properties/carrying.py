"""Errors carried through a map: what the errors of its arguments do to its outputs, to first order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from mpmath import MPContext

from affinecert.catalogue import find
from affinecert.errors import InputError
from affinecert.map import Array, Map
from affinecert.properties.answer import Answer
from affinecert.properties.inexact import CTX
from affinecert.properties.law import OutOfDomain

STEP = CTX.mpf(2) ** -64
"""The part of an error over which differences are taken, where the map is straight."""

PRECISION = 400
"""Bits for them: 53 for the error's smallness, 64 for the step's, 53 for the quotient, the rest for cancellation."""


def carried(name: str, arguments: Sequence[Array | Answer]) -> list[Any]:
    """For each output block of a map, the norm of the change that the errors of the arguments make."""
    entry = find(name)
    total = [CTX.zero for _ in entry.blocks]
    if not any(isinstance(argument, Answer) for argument in arguments):
        return total
    ctx = MPContext()
    ctx.prec = PRECISION
    arrays = [argument.array if isinstance(argument, Answer) else argument for argument in arguments]
    point = [np.vectorize(ctx.mpf, otypes=[object])(array) for array in arrays]
    base = several(entry.reference(ctx, *point))
    for number, argument in enumerate(arguments):
        if not isinstance(argument, Answer):
            continue
        for where, error in argument.parts.values():
            if error == 0:
                continue
            step = ctx.mpf(error * STEP)
            moved = [_moved(ctx, entry, base, point, number, index, step) for index in _indices(argument.array, where)]
            for place, block in enumerate(entry.blocks):
                output, at = block.output, block.where
                changes = [np.ravel(there[output][at] - base[output][at]) for there in moved]
                total[place] += CTX.mpf(ctx.norm(np.concatenate(changes).tolist())) / STEP
    return total


def _moved(
    ctx: Any, entry: Map, base: tuple[Any, ...], point: Sequence[Any], number: int, index: tuple[int, ...], step: Any
) -> tuple[Any, ...]:
    """The outputs with one entry of one argument moved, on the branch of ``base``."""
    there = [array.copy() for array in point]
    there[number][index] += step
    try:
        if entry.continuation is None:
            return several(entry.reference(ctx, *there))
        return several(entry.continuation(ctx, base if len(base) > 1 else base[0], *there))
    except InputError as error:
        raise OutOfDomain(f"within its error of what {entry.name} refuses: {error.reason}") from error


def several(outputs: Any) -> tuple[Any, ...]:
    """The outputs of a map as a tuple, be it of one."""
    return outputs if isinstance(outputs, tuple) else (outputs,)


def _indices(array: Array, where: Any) -> list[tuple[int, ...]]:
    chosen = np.zeros(array.shape, dtype=bool)
    chosen[where] = True
    return [tuple(map(int, index)) for index in np.argwhere(chosen)]
