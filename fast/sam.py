"""Steady affine motions of the plane and of space: logarithm, powers, morphs, fixed point and velocity.

Homogeneous matrices are (..., 3, 3) in the plane and (..., 4, 4) in space, with L the linear part and t the
translation: A = [[L, t], [0, 1]]. Everything is computed in double-double arithmetic and rounded once.

Source: Rossignac and Vinacua, "Steady affine motions and morphs", 2011.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from affinecert.errors import InputError
from affinecert.fast import _exact
from affinecert.fast import _sam_stages as stages
from affinecert.fast._existence import (
    START_NOT_ORIENTED,
    kind_of_matrix,
    kind_of_quotient,
    part,
    parting_of_matrix,
    parting_of_quotient,
)
from affinecert.fast._growth import logarithms, powers
from affinecert.fast._kernel import Array, checked
from affinecert.fast._spectrum import NONE, NOT_ORIENTED, PRIMARY, UNDECIDED
from affinecert.fast._stages import refuse, run, settle

AFFINE, SIZES = ("n", "n"), (3, 4)
"""The shape of one homogeneous matrix, and what n may be."""

DETERMINANT = "the determinant of the linear part is not positive"
NO_FIXED_POINT = "degenerate: no unique fixed point, 1 is an eigenvalue of the linear part"
NO_LOGARITHM = "no real logarithm: a negative eigenvalue, not double with two eigenvectors"


class _Logarithm(NamedTuple):
    """A linear part, and log(x) and log(x) / (x - 1) on its eigenvalues, as the stages have them."""

    linear: Array
    exponent: Array
    existence: Array
    setting: Array
    log: Array
    ratio: Array


def _existence(affine: Array, linear: Array) -> tuple[Array, Array]:
    """The eigenvalues of a linear part, and what there is of a logarithm; refuses what is not oriented."""
    nodes, existence = run(stages.eigenvalues, linear)
    doubtful = existence == UNDECIDED
    settle(existence, UNDECIDED, kind_of_matrix, affine[..., :-1, :-1])
    refuse(existence, NOT_ORIENTED, "affine", DETERMINANT, existence.shape)
    part(nodes, doubtful & (existence == PRIMARY), parting_of_matrix, affine[..., :-1, :-1])
    return nodes, existence


def _logarithm(affine: Array) -> _Logarithm:
    linear, exponent = stages.linear_part(affine)
    nodes, existence = _existence(affine, linear)
    refuse(existence, NONE, "affine", NO_LOGARITHM, existence.shape)
    log, ratio, setting = run(logarithms, nodes, exponent, existence)
    return _Logarithm(linear, exponent, existence, setting, log, ratio)


def _move(known: _Logarithm, start: Array, end: Array, t: Array) -> Array:
    power, quotient = run(powers, known.exponent, known.existence, known.log, known.ratio, known.setting, t)
    parts = (known.linear, known.exponent, known.existence, known.setting, power, quotient)
    return run(stages.motion, start, end, t, *parts)[0]


def exists(affine: ArrayLike) -> NDArray[np.bool_]:
    """Whether an affine map has a real logarithm (Culver 1966; section 5.1).

    It has one if L has no negative eigenvalue, or a double one with two independent eigenvectors. affine (..., n, n),
    n = 3 or 4; gives (...). Always right: what double-double arithmetic cannot tell is decided in integers. Raises
    InputError for a wrong shape or dtype, numbers that are not finite, a last row other than 0 ... 0 1, and a
    determinant that is not positive.

    >>> exists([np.diag([-1.0, -1.0, 1.0]), np.diag([-1.0, -2.0, 1.0])])
    array([ True, False])
    """
    (matrix,) = checked({"affine": AFFINE}, (affine,), SIZES)[0]
    linear, _ = stages.linear_part(matrix)
    return np.asarray(_existence(matrix, linear)[1] != NONE)


def log(affine: ArrayLike) -> Array:
    """The real logarithm of an affine map: [[log L, v], [0, 0]] (equation 2).

    affine (..., n, n), n = 3 or 4; gives (..., n, n), v being log(L) (L - I)^-1 t. The principal logarithm, whose
    eigenvalues have imaginary parts in (-pi, pi). At a double eigenvalue -s with two eigenvectors it is log(s) I + pi J
    on their plane, J the turn by pi/2: [[0, -1], [1, 0]] in the plane; in space [n], n the unit normal of their plane
    whose first component not 0 is positive. Raises InputError as `exists` does, and where there is no real logarithm.
    """
    (matrix,) = checked({"affine": AFFINE}, (affine,), SIZES)[0]
    known = _logarithm(matrix)
    return run(stages.tangent, matrix, known.linear, known.existence, known.setting, known.log, known.ratio)[0]


def power(affine: ArrayLike, t: ArrayLike) -> Array:
    """The power A^t = exp(t log A) of an affine map (equations 1 and 2).

    affine (..., n, n), n = 3 or 4, and t (...), any number; gives (..., n, n): exactly I at t = 0 and A at t = 1.
    Raises InputError as `log` does, and for a t that is not finite.

    >>> power([[4.0, 0.0, 3.0], [0.0, 9.0, 8.0], [0.0, 0.0, 1.0]], 0.5)
    array([[2., 0., 1.],
           [0., 3., 2.],
           [0., 0., 1.]])
    """
    matrix, time = checked({"affine": AFFINE, "t": ()}, (affine, t), SIZES)[0]
    return _move(_logarithm(matrix), np.eye(matrix.shape[-1]), matrix, time)


def morph(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The steady affine morph A^t B, A = C B^-1, from the pose B to the pose C (section 2.2).

    start B and end C (..., n, n), n = 3 or 4, and t (...), any number; gives (..., n, n): exactly B at t = 0 and C at
    t = 1. Raises InputError as `log` does, for B, for C, and (told of the end) for a C B^-1 without a real logarithm.
    """
    first, last, time = checked({"start": AFFINE, "end": AFFINE, "t": ()}, (start, end, t), SIZES)[0]
    linear, exponent, sign = stages.quotient(first, last)
    nodes, existence = run(stages.eigenvalues, linear)
    existence[sign == 0.0] = UNDECIDED
    existence[sign < 0.0] = START_NOT_ORIENTED
    doubtful = existence == UNDECIDED
    settle(existence, UNDECIDED, kind_of_quotient, first[..., :-1, :-1], last[..., :-1, :-1])
    refuse(existence, START_NOT_ORIENTED, "start", DETERMINANT, first.shape[:-2])
    refuse(existence, NOT_ORIENTED, "end", DETERMINANT, last.shape[:-2])
    refuse(existence, NONE, "end", NO_LOGARITHM, last.shape[:-2])
    part(nodes, doubtful & (existence == PRIMARY), parting_of_quotient, first[..., :-1, :-1], last[..., :-1, :-1])
    log, ratio, setting = run(logarithms, nodes, exponent, existence)
    return _move(_Logarithm(linear, exponent, existence, setting, log, ratio), first, last, time)


def fixed_point(affine: ArrayLike) -> Array:
    """The fixed point q = L q + t of an affine map (appendix A.1 and A.4).

    affine (..., n, n), n = 3 or 4; gives (..., n - 1). Raises InputError as `exists` does, and where 1 is an eigenvalue
    of L, so that no point or more than one is fixed.
    """
    (matrix,) = checked({"affine": AFFINE}, (affine,), SIZES)[0]
    linear, _ = stages.linear_part(matrix)
    _existence(matrix, linear)
    point, sure = run(stages.fixed, matrix)
    for index in map(tuple, np.argwhere(sure == 0.0)):
        exact = _exact.fixed_point(matrix[index])
        if exact is None:
            raise InputError("affine", NO_FIXED_POINT, tuple(int(i) for i in index))
        point[index] = exact
    return point


def velocity(affine: ArrayLike, point: ArrayLike) -> Array:
    """The velocity log(L) p + v, log A = [[log L, v], [0, 0]], of the motion A^t at the point p: the same at all times.

    affine (..., n, n), n = 3 or 4, and point (..., n - 1); gives (..., n - 1), in units of length per unit of t
    (section 6.2). Raises InputError as `log` does, and for a point of a wrong shape or dtype or that is not finite.
    """
    matrix, place = checked({"affine": AFFINE, "point": ("n-1",)}, (affine, point), SIZES)[0]
    known = _logarithm(matrix)
    parts = (known.linear, known.existence, known.setting, known.log, known.ratio)
    return run(stages.rate, matrix, place, *parts)[0]
