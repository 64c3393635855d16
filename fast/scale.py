"""Uniform scales: the positive numbers under multiplication, and their logarithms."""

from __future__ import annotations

import math

from numpy.typing import ArrayLike

from affinecert.fast._kernel import Array, kernel


@kernel(inputs={"log_scale": ()}, outputs=((),))
def _exp(log_scale: float, scale: Array, _status: Array) -> None:
    scale[0] = math.exp(log_scale)


def exp(log_scale: ArrayLike) -> Array:
    """The scale with the given natural logarithm, (...) -> (...).

    Infinity beyond the largest float64. Raises InputError for a wrong dtype and for numbers that are not finite.
    Bansal and Tatu, A.2.5.

    >>> exp([0.0, 1.0])
    array([1.        , 2.71828183])
    """
    return _exp(log_scale)[0]


@kernel(inputs={"scale": ()}, outputs=((),), refusals=(("scale", "not positive"),))
def _log(scale: float, log_scale: Array, status: Array) -> None:
    status[0] = 0 if scale > 0.0 else 1
    log_scale[0] = math.log(scale)


def log(scale: ArrayLike) -> Array:
    """The natural logarithm of a scale, (...) -> (...).

    Raises InputError for a wrong dtype, numbers that are not finite, and scales that are not positive. Bansal and Tatu,
    A.2.5.
    """
    return _log(scale)[0]
