"""Sizes of arrays and their ratios, without overflow, underflow or NaN on the way."""

from __future__ import annotations

import math
import sys

import numpy as np

from affinecert.map import Array


def length(array: Array) -> float:
    """The Frobenius norm, without overflow or underflow on the way; at most the largest float64, or infinite.

    It is infinite where an entry is, or is NaN.
    """
    if np.iscomplexobj(array):
        array = np.stack([array.real, array.imag])
    largest = float(np.max(np.abs(array), initial=0.0))
    if largest == 0.0:
        return 0.0
    if not math.isfinite(largest):
        return math.inf
    exponent = math.frexp(largest)[1]
    with np.errstate(over="ignore", under="ignore"):
        norm = np.ldexp(np.linalg.norm(np.ldexp(array, -exponent)), exponent)
    return min(float(norm), sys.float_info.max)


def quotient(numerator: float, denominator: float) -> float:
    """The ratio of two non-negative numbers; 0/0 is 0, anything else over 0 infinite, and infinity over anything."""
    if numerator in {0.0, math.inf}:
        return numerator
    return numerator / denominator if denominator > 0.0 else math.inf
