"""Polar decomposition L = R S of linear maps of the plane and of space, in double-double and rounded once.

Source: Kaji and Ochiai, "A concise parametrisation of affine transformation", 2016, equation 3 and section 6.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast._kernel import Array, checked
from affinecert.fast._stages import refuse
from affinecert.fast._wide import determinant_sign, rounded, widen
from affinecert.fast._wide_polar import polar

DETERMINANT = "the determinant is not positive"


class Factors(NamedTuple):
    """The factors of L = R S: ``rotation`` R and ``stretch`` S, (..., d, d)."""

    rotation: Array
    stretch: Array


def decompose(linear: ArrayLike) -> Factors:
    """The one rotation R and symmetric positive definite S with L = R S: S = (L^T L)^(1/2), R = L S^-1.

    linear (..., d, d), d 2 or 3; gives R and S of that shape, S exactly symmetric. R is the rotation nearest to L, and
    as sharply told by L as the two smaller singular values are large together; S is so for any L. Raises InputError for
    a wrong shape or dtype, numbers that are not finite, and a determinant that is not positive.

    >>> rotation, stretch = decompose([[0.0, -2.0], [3.0, 0.0]])
    >>> rotation + 0.0
    array([[ 0., -1.],
           [ 1.,  0.]])
    >>> stretch
    array([[3., 0.],
           [0., 2.]])
    """
    (given,), _, _ = checked({"linear": ("d", "d")}, (linear,), (2, 3))
    pairs = widen(given)
    sign = determinant_sign(pairs)
    refuse(np.maximum(sign, 0.0), 0.0, "linear", DETERMINANT, sign.shape)
    rotation, stretch = polar(pairs)
    return Factors(rounded(rotation), rounded(stretch))
