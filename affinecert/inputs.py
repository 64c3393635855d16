"""The inputs of a map as people give them: read, and checked against the map's arguments."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from affinecert import catalogue, truths
from affinecert.case import from_hex
from affinecert.errors import InputError
from affinecert.map import Argument, Array, Map
from affinecert.truths import Truth

Shape = tuple[int | str, ...]
"""Sizes, and names of sizes."""


def truth(name: str, *inputs: ArrayLike) -> Truth:
    """The truth of the map of that name at one input: its arguments in order, without a batch axis.

    The value of output k is ``high[k] + low[k]``, good to 106 bits; ``sensitivity`` holds, for each output block of
    the map, its condition number times its norm; ``refusal`` says why there is no value, outside the map's domain.
    Raises UnknownNameError for the map, InputError for inputs that are not numbers, not finite, or of another shape.

    >>> found = truth("so3.log", [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> found.high[0], found.sensitivity, found.refusal
    (array([0., 0., 0.]), (0.0,), None)
    """
    entry = catalogue.find(name)
    arrays = []
    for argument, value in zip(entry.arguments, inputs, strict=False):
        try:
            arrays.append(np.asarray(value, dtype=np.float64))
        except (TypeError, ValueError) as error:
            raise InputError(argument.name, f"not an array of numbers: {error}") from error
        if not np.all(np.isfinite(arrays[-1])):
            raise InputError(argument.name, "not finite")
    check_shapes(entry, [*arrays, *([np.empty(0)] * (len(inputs) - len(arrays)))])
    return truths.compute(entry, tuple(arrays))


def read_inputs(entry: Map, text: str) -> tuple[Array, ...]:
    """The inputs of a map from JSON: a list of its arguments, or its one argument alone.

    Numbers may be decimal or, as strings, hexadecimal ("0x1.8p+1"). Raises InputError that names the argument.
    """
    try:
        value = json.loads(text)
    except json.JSONDecodeError as error:
        raise InputError("INPUT", f"not JSON: {error}") from error
    if len(entry.arguments) == 1 and _depth(value) <= len(entry.arguments[0].shape):
        value = [value]
    if not isinstance(value, list) or len(value) != len(entry.arguments):
        names = ", ".join(argument.name for argument in entry.arguments)
        raise InputError("INPUT", f"a list of {len(entry.arguments)} is due: {names}")
    arrays = tuple(map(_array, entry.arguments, value))
    check_shapes(entry, arrays)
    return arrays


def check_shapes(entry: Map, inputs: Sequence[Array]) -> None:
    """Raises InputError unless the inputs have the shapes of the map's arguments, all of the plane or all of space."""
    if len(inputs) != len(entry.arguments):
        raise InputError("inputs", f"{len(inputs)} arguments where {len(entry.arguments)} are due")
    shapes = [array.shape for array in inputs]
    fitting = [_shapes(entry, shapes, plane_or_space) for plane_or_space in ({"n": 3, "d": 2}, {"n": 4, "d": 3})]
    # The reading that fits furthest is the one that was meant; what is due at its first misfit is told.
    furthest = max(_misfit(shapes, due) for due in fitting)
    if furthest < len(shapes):
        choice = dict.fromkeys(_told(due[furthest]) for due in fitting if _misfit(shapes, due) == furthest)
        reason = f"shape {shapes[furthest]} where {' or '.join(choice)} is due"
        raise InputError(entry.arguments[furthest].name, reason)


def _misfit(shapes: Sequence[Shape], due: Sequence[Shape]) -> int:
    """The first place where two lists of shapes differ; their length if they do not."""
    return next((place for place, pair in enumerate(zip(shapes, due, strict=True)) if pair[0] != pair[1]), len(due))


def _told(shape: Shape) -> str:
    """A shape as it is written, names of sizes without quotes."""
    return str(shape).replace("'", "")


def _depth(value: Any) -> int:
    """How deeply lists are nested, along the first entries."""
    return 1 + _depth(value[0]) if isinstance(value, list) and value else int(isinstance(value, list))


def _array(argument: Argument, value: Any) -> Array:
    try:
        array = from_hex(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(argument.name, f"not an array of numbers: {error}") from error
    if not np.all(np.isfinite(array)):
        raise InputError(argument.name, "not finite")
    return array


def _shapes(entry: Map, shapes: Sequence[Shape], known: Mapping[str, int]) -> list[Shape]:
    """The shapes of a map's arguments, as far as these tell: a name of a size is settled where it first stands alone.

    A size is a number, a name, or a name and what is added or taken away ("n-1", "keys+1").
    """
    sizes = dict(known)
    for argument, shape in zip(entry.arguments, shapes, strict=True):
        for written, found in zip(argument.shape, shape, strict=False):
            if isinstance(written, str) and written.isidentifier() and isinstance(found, int):
                sizes.setdefault(written, found)
    return [tuple(extent(size, sizes) for size in argument.shape) for argument in entry.arguments]


def extent(written: int | str, sizes: Mapping[str, int]) -> int | str:
    """A size of a shape as a number, or as it is written while its name is not settled."""
    if isinstance(written, int):
        return written
    name = re.split("[+-]", written)[0]
    return sizes[name] + int(written.removeprefix(name) or 0) if name in sizes else written
