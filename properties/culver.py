"""Culver's condition for a real logarithm: what negative eigenvalues a matrix has, decided in rational arithmetic."""

from __future__ import annotations

from enum import Enum
from typing import Any

import numpy as np

from affinecert.properties.inexact import determinant, exact
from affinecert.properties.law import OutOfDomain


class Negative(Enum):
    """What negative eigenvalues a matrix with a positive determinant has, by what they mean for its logarithm."""

    NONE = "none"
    HALF_TURN = "one of multiplicity two with two independent eigenvectors"
    PREVENTING = "two that differ, or one with a single eigenvector"


def negative_eigenvalues(linear: Any) -> Negative:
    """Decided from the characteristic polynomial, in rational arithmetic; (2, 2) or (3, 3), determinant positive."""
    if len(linear) == 2:
        return _in_the_plane(linear)
    trace, product = linear.trace(), determinant(linear)
    minors = (trace * trace - (linear @ linear).trace()) / 2
    # The discriminant of x^3 - trace x^2 + minors x - product.
    discriminant = (
        trace**2 * minors**2 - 4 * minors**3 - 4 * trace**3 * product + 18 * trace * minors * product - 27 * product**2
    )
    # With one real root, that is positive, as the product is. With three, Descartes' rule of signs is sharp.
    if discriminant < 0 or (trace > 0 and minors > 0):
        return Negative.NONE
    if discriminant > 0:
        return Negative.PREVENTING
    # Two roots a and one b: trace minors - 9 product = 2 a (a - b)^2, and trace^2 - 3 minors = (a - b)^2.
    double = (trace * minors - 9 * product) / (2 * (trace**2 - 3 * minors))
    unit = exact(np.eye(3))
    annihilated = (linear - double * unit) @ (linear - (trace - 2 * double) * unit)
    return Negative.PREVENTING if annihilated.any() else Negative.HALF_TURN


def _in_the_plane(linear: Any) -> Negative:
    trace = linear.trace()
    if trace >= 0 or trace * trace < 4 * determinant(linear):
        return Negative.NONE
    return Negative.PREVENTING if (linear - trace / 2 * exact(np.eye(2))).any() else Negative.HALF_TURN


def without_half_turns(linear: Any) -> None:
    """OutOfDomain if there are negative eigenvalues: their half turn has no direction that is its own."""
    if negative_eigenvalues(linear) is not Negative.NONE:
        raise OutOfDomain("a negative eigenvalue")
