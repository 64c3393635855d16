"""Symmetric matrices of space: exponential, and logarithm and powers of the positive definite ones.

A matrix is taken for its symmetric part. Everything is computed in double-double arithmetic, by eigenvalues and
eigenvectors, and rounded once.

Source: Kaji and Ochiai, "A concise parametrisation of affine transformation", 2016, equations 6 and 7.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from affinecert.fast._exact import definiteness
from affinecert.fast._kernel import Array, checked
from affinecert.fast._stages import refuse, settle
from affinecert.fast._wide import rounded, widen
from affinecert.fast._wide_symmetric import (
    ALWAYS,
    EXPONENTIAL,
    LOGARITHM,
    NOT_DEFINITE,
    NOT_SYMMETRIC,
    POWER,
    UNDECIDED,
    function_of,
)

ASYMMETRY = "not symmetric: A - A^T is further than 1e-6 |A| from 0"
INDEFINITE = "not positive definite"


def exp(matrix: ArrayLike) -> Array:
    """The exponential of a symmetric matrix (equation 6).

    matrix Y (..., 3, 3) with |Y - Y^T| <= 1e-6 |Y| in the Frobenius norm; gives (..., 3, 3), exactly symmetric, with
    infinity where an entry is beyond the largest float64. Raises InputError for a wrong shape or dtype, numbers that
    are not finite, and matrices that are not symmetric.

    >>> import numpy as np
    >>> exp(np.diag([0.0, 1.0, np.log(2.0)])).round(15)
    array([[1.        , 0.        , 0.        ],
           [0.        , 2.71828183, 0.        ],
           [0.        , 0.        , 2.        ]])
    """
    (given,), _, _ = checked({"matrix": (3, 3)}, (matrix,))
    return _function(given, ALWAYS, EXPONENTIAL)


def log(matrix: ArrayLike) -> Array:
    """The symmetric logarithm of a symmetric positive definite matrix (equation 7).

    matrix S (..., 3, 3) as in `exp`, its symmetric part positive definite; gives (..., 3, 3), exactly symmetric. Raises
    InputError as `exp` does, and for matrices that are not positive definite, however little they are off.
    """
    (given,), _, _ = checked({"matrix": (3, 3)}, (matrix,))
    return _function(given, ALWAYS, LOGARITHM)


def power(matrix: ArrayLike, t: ArrayLike) -> Array:
    """The power S^t = exp(t log S) of a symmetric positive definite matrix.

    matrix S (..., 3, 3) as in `log` and t (...), any number; gives (..., 3, 3), exactly symmetric: exactly I at t = 0,
    and the symmetric part of S at t = 1. Raises InputError as `log` does, and for a t that is not finite.
    """
    (given, time), _, _ = checked({"matrix": (3, 3), "t": ()}, (matrix, t))
    return _function(given, time, POWER)


def _function(matrix: Array, t: Array, function: float) -> Array:
    """A function of the stage, rounded; refuses what is outside its domain."""
    result, kind = function_of(widen(matrix), t, function)
    own = matrix.shape[:-2]
    refuse(kind, NOT_SYMMETRIC, "matrix", ASYMMETRY, own)
    if function != EXPONENTIAL:
        settle(kind, UNDECIDED, definiteness, matrix)
        refuse(kind, NOT_DEFINITE, "matrix", INDEFINITE, own)
    return rounded(result)
