"""Shrinking: from an input that does badly to a simpler one that does as badly, for people to read.

Simple is what is short to write: zero, then one, small integers and short decimals, powers of two. Every accepted step
makes the input strictly simpler, so that shrinking ends.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import TypeVar

import numpy as np

from affinecert.map import Array

T = TypeVar("T")
Inputs = tuple[Array, ...]
Move = Callable[[T], Iterator[T]]
"""A way to simplify: the candidates it offers, the most daring first."""

DIGITS = range(1, 17)
"""Significant digits that a number may be rounded to; 17 are needed for any float64."""


def complexity(number: float) -> int:
    """How much there is to read in a number: 0 for zero, 1 for one, more for others; and a sign is one more.

    Other numbers count 2, and 1 for each decimal digit but leading and final zeros; a power of two counts as two digits
    at most, for it is short in hexadecimal.
    """
    size, sign = abs(number), int(math.copysign(1.0, number) < 0)
    if size in {0.0, 1.0}:
        return int(size) + sign
    digits = len(repr(size).partition("e")[0].replace(".", "").strip("0"))
    return 2 + (min(digits, 2) if math.frexp(size)[0] == 0.5 else digits) + sign


def total(inputs: Inputs) -> int:
    """The complexity of an input: the sum over its entries."""
    return sum(complexity(float(entry)) for array in inputs for entry in array.flat)


def descend(
    start: T, moves: Sequence[Move[T]], weight: Callable[[T], int], as_bad: Callable[[T], bool], limit: int
) -> tuple[T, int]:
    """The lightest found from ``start`` on by accepting, of each move in turn, the first lighter one that is as bad.

    Goes round the moves until none gives, or ``limit`` questions were put to ``as_bad``. Also returns their number.
    """
    current, asked, since = start, 0, 0
    for move in _endless(moves):
        since += 1
        for candidate in move(current):
            if weight(candidate) >= weight(current):
                continue
            if asked == limit:
                return current, asked
            asked += 1
            if as_bad(candidate):
                current, since = candidate, 0
                break
        if since >= len(moves):
            break
    return current, asked


def _endless(moves: Sequence[Move[T]]) -> Iterator[Move[T]]:
    while moves:
        yield from moves


def shrink(inputs: Inputs, as_bad: Callable[[Inputs], bool], limit: int) -> Inputs:
    """The simplest input found with ``limit`` questions to ``as_bad``, which holds for ``inputs``.

    An argument is rounded as a whole, which keeps it near its manifold; entries are simplified one by one.
    """
    return descend(inputs, _moves(inputs), total, as_bad, limit)[0]


def simpler(inputs: Inputs) -> list[Inputs]:
    """The simpler inputs that are one of `shrink`'s steps away, the simplest first."""
    limit = total(inputs)
    return sorted((found for move in _moves(inputs) for found in move(inputs) if total(found) < limit), key=total)


def _moves(inputs: Inputs) -> list[Move[Inputs]]:
    """Roundings of whole arguments, then simplifications of single entries."""
    whole = [partial(_rounded, number) for number in range(len(inputs))]
    single = [partial(_entry, number, place) for number, array in enumerate(inputs) for place in range(array.size)]
    return [*whole, *single]


def _replaced(inputs: Inputs, number: int, entries: Sequence[float]) -> Inputs:
    array = np.array(entries, dtype=np.float64).reshape(inputs[number].shape)
    return (*inputs[:number], array, *inputs[number + 1 :])


def _rounded(number: int, inputs: Inputs) -> Iterator[Inputs]:
    """The input with one argument rounded, to fewer and then to more digits after the point of its largest entry."""
    largest = float(np.max(np.abs(inputs[number]), initial=0.0))
    if largest == 0.0:
        return
    leading = math.floor(math.log10(largest))
    for digits in DIGITS:
        yield _replaced(inputs, number, [_round(float(entry), digits - leading) for entry in inputs[number].flat])


def _round(number: float, places: int) -> float:
    try:
        return round(number, places)
    except OverflowError:  # rounded up beyond the largest float64
        return number


def _entry(number: int, place: int, inputs: Inputs) -> Iterator[Inputs]:
    """The input with one entry made simpler."""
    entries = [float(entry) for entry in inputs[number].flat]
    for value in _simpler(entries[place]):
        yield _replaced(inputs, number, [*entries[:place], value, *entries[place + 1 :]])


def _simpler(number: float) -> Iterator[float]:
    """Numbers that may stand for this one, the simplest first."""
    size = abs(number)
    sizes = [0.0, 1.0, math.ldexp(0.5, math.frexp(size)[1]), *(float(f"{size:.{digits - 1}e}") for digits in DIGITS)]
    for value in dict.fromkeys([*sizes, size]):
        if math.isfinite(value):
            yield value
            yield math.copysign(value, number)
