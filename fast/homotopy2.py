"""Homotopies from the identity to a linear map of the plane: linear, polar and exponential.

A = R S is the polar decomposition of a map of positive determinant: R the rotation by an angle theta in (-pi, pi], S
symmetric positive definite. Everything is computed in double-double arithmetic and rounded once.

Source: Kaji, Hirose, Sakata, Mizoguchi, Anjyo, "Mathematical analysis on affine maps for 2D shape interpolation", 2012,
section 3.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast import _homotopy
from affinecert.fast._homotopy import ONE, Factors, Growth
from affinecert.fast._kernel import Array, checked
from affinecert.fast._stages import refuse
from affinecert.fast._wide import add, determinant_sign, multiply, rounded, subtract, times, widen

ARGUMENTS = {"linear": (2, 2), "t": ()}

DETERMINANT = "the determinant is not positive"


def linear(linear: ArrayLike, t: ArrayLike) -> Array:
    """The linear homotopy A^L = (1 - t) I + t A.

    linear (..., 2, 2) and t (...), any number; gives (..., 2, 2): exactly I at t = 0 and A at t = 1. In between it may
    be singular: at A = -I and t = 1/2 nothing is left. Raises InputError for a wrong shape or dtype and for numbers
    that are not finite.
    """
    (matrix, time), _, _ = checked(ARGUMENTS, (linear, t))
    rest = subtract(ONE, widen(time))
    mixed = add(multiply(widen(np.eye(2)), rest[..., None, None, :]), times(widen(matrix), time[..., None, None]))
    return _at_the_ends(matrix, time, rounded(mixed))


def polar(linear: ArrayLike, t: ArrayLike) -> Array:
    """The polar homotopy A^P = R_(t theta) ((1 - t) I + t S) (equation 2; Alexa, Cohen-Or and Levin 2000).

    linear (..., 2, 2) and t (...), any number; gives (..., 2, 2): exactly I at t = 0 and A at t = 1. Its determinant is
    (1 + t (x - 1)) (1 + t (y - 1)), x and y the singular values of A: positive in [0, 1], but not everywhere. Raises
    InputError for a wrong shape or dtype, numbers that are not finite, and a determinant that is not positive.
    """
    return _interpolated(linear, t, _homotopy.linear)


def exponential(linear: ArrayLike, t: ArrayLike) -> Array:
    """The exponential homotopy A^E = R_(t theta) S^t, S^t = exp(t log S) (equation 3).

    linear (..., 2, 2) and t (...), any number; gives (..., 2, 2): exactly I at t = 0 and A at t = 1. Its determinant is
    (det A)^t: never 0, and monotone. Raises InputError as `polar` does.

    >>> exponential([[0.0, -9.0], [4.0, 0.0]], 0.5)
    array([[ 1.41421356, -2.12132034],
           [ 1.41421356,  2.12132034]])
    """
    return _interpolated(linear, t, _homotopy.exponential)


def _interpolated(linear: ArrayLike, t: ArrayLike, grow: Callable[[Factors, Array], Growth]) -> Array:
    (matrix, time), batches, _ = checked(ARGUMENTS, (linear, t))
    sign = determinant_sign(widen(matrix))
    refuse(np.maximum(sign, 0.0), 0.0, "linear", DETERMINANT, batches[0])
    known = _factors(matrix)
    a, b = _homotopy.turned(known, grow(known, widen(time)), widen(time))
    (a_real, a_imaginary), (b_real, b_imaginary) = (np.moveaxis(number, -2, 0) for number in (a, b))
    entries = [
        [add(a_real, b_real), subtract(b_imaginary, a_imaginary)],
        [add(a_imaginary, b_imaginary), subtract(a_real, b_real)],
    ]
    moved = np.stack([np.stack([rounded(entry) for entry in row], axis=-1) for row in entries], axis=-2)
    return _at_the_ends(matrix, time, moved)


def _factors(matrix: Array) -> Factors:
    """The polar factors of a linear map, (..., 2, 2)."""
    exponent = np.frexp(np.abs(matrix).max(axis=(-2, -1)))[1]
    entries = np.moveaxis(widen(np.ldexp(matrix, -exponent[..., None, None])), (-3, -2), (0, 1))
    (first, second), (third, fourth) = entries
    a = 0.5 * np.stack([add(first, fourth), subtract(third, second)], axis=-2)
    b = 0.5 * np.stack([subtract(first, fourth), add(third, second)], axis=-2)
    determinant = subtract(multiply(first, fourth), multiply(second, third))
    known = _homotopy.shifted(_homotopy.factors(a, b, determinant), exponent)
    # The side on which a turn by nearly pi is may have underflowed.
    backwards = (matrix[..., 1, 0] < matrix[..., 0, 1])[..., None]
    return known._replace(angle=np.where(backwards & (known.angle[..., :1] > 0.0), -known.angle, known.angle))


def _at_the_ends(matrix: Array, time: Array, between: Array) -> Array:
    """The identity at t = 0, the matrix itself at t = 1, and what is given in between."""
    at = time[..., None, None]
    return np.where(at == 0.0, np.eye(2), np.where(at == 1.0, matrix, between))
