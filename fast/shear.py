"""Shears, the group G_A of matrices [[1, a1, a3], [0, a2, a4], [0, 0, a5]] with a2, a5 > 0: exponential and logarithm.

A function f of a triangular matrix has on the diagonal the values of f, beside it the first divided differences of f
at the diagonal's entries, times the entry there, and in the corner a3 f[d1, d3] + a1 a4 f[d1, d2, d3]. The five
branches of Bansal and Tatu's formulas are the limits of these.
"""

from __future__ import annotations

import math

from numpy.typing import ArrayLike

from affinecert.fast._divided_differences import exp_first, exp_second, log_first, log_second, product
from affinecert.fast._kernel import Array, kernel


@kernel(inputs={"shear_twist": (5,)}, outputs=((3, 3),))
def _exp(shear_twist: Array, shear: Array, _status: Array) -> None:
    a1, a2, a3, a4, a5 = shear_twist[0], shear_twist[1], shear_twist[2], shear_twist[3], shear_twist[4]
    shear[1, 0] = shear[2, 0] = shear[2, 1] = 0.0
    shear[0, 0] = 1.0
    shear[0, 1] = exp_first(a1, 0.0, a2)
    shear[0, 2] = exp_first(a3, 0.0, a5) + exp_second(a1, a4, 0.0, a2, a5)
    shear[1, 1] = math.exp(a2)
    shear[1, 2] = exp_first(a4, a2, a5)
    shear[2, 2] = math.exp(a5)


def exp(shear_twist: ArrayLike) -> Array:
    """The shear of a twist (a1, ..., a5): the exponential of [[0, a1, a3], [0, a2, a4], [0, 0, a5]].

    shear_twist (..., 5); gives (..., 3, 3). Raises InputError for a wrong shape or dtype and for numbers that are not
    finite. Bansal and Tatu, A.2.3, whose five branches are one formula in divided differences.

    >>> exp([1.0, 0.0, 0.0, 2.0, 0.0])
    array([[1., 1., 1.],
           [0., 1., 2.],
           [0., 0., 1.]])
    """
    return _exp(shear_twist)[0]


@kernel(
    inputs={"shear": (3, 3)},
    outputs=((5,),),
    refusals=(
        ("shear", "not a shear: must be upper triangular with first column (1, 0, 0)"),
        ("shear", "diagonal of the shear is not positive"),
    ),
)
def _log(shear: Array, shear_twist: Array, status: Array) -> None:
    a1, a2, a3, a4, a5 = shear[0, 1], shear[1, 1], shear[0, 2], shear[1, 2], shear[2, 2]
    status[0] = 0
    if shear[0, 0] != 1.0 or shear[1, 0] != 0.0 or shear[2, 0] != 0.0 or shear[2, 1] != 0.0:
        status[0] = 1
        return
    if not (a2 > 0.0 and a5 > 0.0):
        status[0] = 2
        return
    shear_twist[0] = a1 * log_first(1.0, a2)
    shear_twist[1] = math.log(a2)
    shear_twist[2] = a3 * log_first(1.0, a5) + product(a1, a4, log_second(1.0, a2, a5))
    shear_twist[3] = a4 * log_first(a2, a5)
    shear_twist[4] = math.log(a5)


def log(shear: ArrayLike) -> Array:
    """The twist (a1, ..., a5) of a shear: its principal logarithm is [[0, a1, a3], [0, a2, a4], [0, 0, a5]].

    shear (..., 3, 3), of the form [[1, a1, a3], [0, a2, a4], [0, 0, a5]] with a2, a5 > 0; gives (..., 5). Raises
    InputError for a wrong shape or dtype, numbers that are not finite, another form, and a diagonal that is not
    positive. Bansal and Tatu, A.2.4, whose five branches are one formula in divided differences.
    """
    return _log(shear)[0]
