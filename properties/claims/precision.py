"""The numbers that claims are checked with: 70 digits, of which 50 must agree."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np

from affinecert.reference._matrices import Number, array

mp: Any = mpmath.MPContext()
"""The context of all checks, apart from mpmath's global one."""

mp.dps = 70

HOLDS = mp.mpf(10) ** -50
"""Greatest deviation of what is true: 20 digits are left for rounding and cancellation."""

FAILS = mp.mpf(10) ** -12
"""Least deviation of what is false. What lies between the two is neither, and the check has to be made sharper."""


def exactly(value: Any, context: Any = mp) -> Any:
    """A number, or nested sequences of numbers, as a number or object array of a context; hexadecimal strings too.

    >>> exactly([1, 0.5])
    array([mpf('1.0'), mpf('0.5')], dtype=object)
    """
    if isinstance(value, str):
        return context.mpf(float.fromhex(value))
    if np.ndim(value) == 0:
        return context.convert(value)
    given = np.asarray(value, dtype=object)
    return array([exactly(each, context) for each in given.flat]).reshape(given.shape)


def size(value: Any) -> Number:
    """The largest absolute value of a number, or in an array or sequence of them; 0 of an empty one."""
    if isinstance(value, np.ndarray):
        return max((abs(each) for each in value.flat), default=mp.zero)
    if isinstance(value, list | tuple):
        return max((size(each) for each in value), default=mp.zero)
    return abs(value)


def difference(a: Any, b: Any) -> Number:
    """The largest difference between the numbers of two values of one structure. Raises ValueError for two shapes."""
    if isinstance(a, list | tuple):
        return max((difference(x, y) for x, y in zip(a, b, strict=True)), default=mp.zero)
    if np.shape(a) != np.shape(b):
        raise ValueError(f"shapes {np.shape(a)} and {np.shape(b)} cannot be compared")
    return size(np.asarray(a, dtype=object) - np.asarray(b, dtype=object))


def distance(value: Any, truth: Any) -> Number:
    """The largest difference, relative to the largest number of the truth; absolute where the truth is 0.

    Of a tuple or list each member counts by itself, so that a large one does not hide a small one.

    >>> distance((exactly([3, 4]), 7), (exactly([3, 8]), 7))
    mpf('0.5')
    """
    if isinstance(truth, list | tuple):
        return max((distance(v, t) for v, t in zip(value, truth, strict=True)), default=mp.zero)
    scale = size(truth)
    gap = mp.convert(difference(value, truth))
    return gap / mp.convert(scale) if scale else gap


def equals(truth: Any) -> Any:
    """The deviation of formulas ``form(m, *case)`` from the function ``truth(m, *case)``, both over a context m."""

    def deviation(form: Any, case: tuple[Any, ...]) -> Number:
        return distance(form(mp, *case), truth(mp, *case))

    return deviation


def rounded(printed: str, truth: Any) -> Number:
    """How far a number as printed is from the truth beyond its last digit, relative to that digit; 0 if it is right.

    >>> float(rounded("3.1", 3.125)), float(rounded("3.3", 3.125))
    (0.0, 1.25)
    """
    last = mp.mpf(10) ** -len(printed.partition(".")[2])
    return max(abs(mp.mpf(printed) - truth) / last - mp.mpf(0.5), mp.zero)
