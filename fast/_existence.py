"""Whether a matrix has a real logarithm, and of what kind, exactly.

Source: Culver 1966, as Rossignac and Vinacua state it in section 5.1.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from affinecert.fast._exact import Integers, adjugate, cofactor, determinant, integers, integers_of_sum, product
from affinecert.fast._kernel import Array
from affinecert.fast._spectrum import HALF_TURN, NONE, NOT_ORIENTED, PRIMARY, VERGE

START_NOT_ORIENTED = 5.0
"""Of a quotient C B^-1: the determinant of B is not positive."""

UNTOLD = 2.0**-60
"""Delta against m^2 below which a pair is as good as double in `parting_of_matrix`, yet far above what is doubtful."""


def _discriminant(trace: int, minors: int, volume: int) -> int:
    """The discriminant of x^3 - trace x^2 + minors x - volume: of its roots, the product of the squared differences."""
    symmetric = (trace * minors) ** 2 - 4 * minors**3 - 4 * trace**3 * volume
    return symmetric + 18 * trace * minors * volume - 27 * volume**2


def _double_root(trace: int, minors: int, volume: int) -> tuple[int, int]:
    """The double root of that cubic, if there is one, as numerator and denominator."""
    return trace * minors - 9 * volume, 2 * (trace * trace - 3 * minors)


def _parting(a: Integers) -> float:
    """The quotient delta / m^2 of a pair of eigenvalues m +- sqrt delta that all but coincide, rounded once.

    The discriminant is 4 delta in the plane; in space it is 4 delta (mu - m)^4, up to a relative error of delta.
    """
    volume, trace = determinant(a), sum(a[i][i] for i in range(len(a)))
    if len(a) == 2:
        return float(Fraction(trace * trace - 4 * volume, trace * trace))
    minors = sum(cofactor(a, i, i) for i in range(3))
    numerator, denominator = _double_root(trace, minors, volume)
    spread = trace * trace - 3 * minors
    return float(Fraction(_discriminant(trace, minors, volume) * denominator**2, 4 * (spread * numerator) ** 2))


def _kind(a: Integers) -> float:
    """What there is of a logarithm, as a constant of `affinecert.fast._spectrum`, for a multiple of the matrix."""
    volume, trace = determinant(a), sum(a[i][i] for i in range(len(a)))
    if volume <= 0:
        return NOT_ORIENTED
    if len(a) == 2:
        if trace >= 0 or trace * trace < 4 * volume:
            return PRIMARY
        return HALF_TURN if a[0][0] == a[1][1] and a[0][1] == a[1][0] == 0 else NONE
    minors = sum(cofactor(a, i, i) for i in range(3))
    # The negative eigenvalues are -y for the positive roots y of y^3 + trace y^2 + minors y + volume.
    if trace >= 0 and minors >= 0:
        return PRIMARY
    discriminant = _discriminant(trace, minors, volume)
    if discriminant:
        return PRIMARY if discriminant < 0 else NONE
    # The double eigenvalue is numerator / denominator. It has two eigenvectors if the matrix less it has rank one.
    numerator, denominator = _double_root(trace, minors, volume)
    rest = [[denominator * x - numerator * (i == j) for j, x in enumerate(row)] for i, row in enumerate(a)]
    return NONE if any(any(row) for row in adjugate(rest)) else HALF_TURN


def kind_of_matrix(linear: Array) -> float:
    """What there is of a logarithm of a matrix, (2, 2) or (3, 3)."""
    return _kind(integers(linear))


def kind_of_sum(high: Array, low: Array) -> float:
    """The same for the sum of two matrices."""
    return _kind(integers_of_sum(high, low))


def parting_of_matrix(linear: Array) -> float:
    """Delta / m^2 of a matrix whose pair of eigenvalues double-doubles cannot tell from a double one."""
    return _parting(integers(linear))


def parting_of_sum(high: Array, low: Array) -> float:
    """The same for the sum of two matrices."""
    return _parting(integers_of_sum(high, low))


def parting_of_quotient(start: Array, end: Array) -> float:
    """The same for the quotient C B^-1 of two matrices, C the end and B the start."""
    return _parting(product(integers(end), adjugate(integers(start))))


def kind_of_quotient(start: Array, end: Array) -> float:
    """The same for the quotient C B^-1 of two matrices, C the end and B the start, either of which may be singular."""
    divisor = integers(start)
    if determinant(divisor) <= 0:
        return START_NOT_ORIENTED
    return _kind(product(integers(end), adjugate(divisor)))


def part(nodes: Array, doubtful: NDArray[np.bool_], parting: Callable[..., float], *matrices: Array) -> None:
    """Sets delta of the negative pairs that only integers could tell from a double eigenvalue."""
    for index in map(tuple, np.argwhere(doubtful & (nodes[..., 0, 0] < 0.0))):
        ratio = parting(*(np.broadcast_to(matrix, doubtful.shape + matrix.shape[-2:])[index] for matrix in matrices))
        if abs(ratio) < UNTOLD:
            nodes[index][1] = min(ratio, -VERGE) * nodes[index][0, 0] ** 2, 0.0
