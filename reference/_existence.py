"""Whether a matrix of positive determinant has a real logarithm, decided exactly on integer multiples of it.

Culver, On the existence and uniqueness of the real logarithm of a matrix (1966), as Rossignac and Vinacua state it in
section 5.1: if there is a negative eigenvalue, it must be double, with two independent eigenvectors.
"""

from __future__ import annotations

from enum import Enum

from affinecert.reference._exact import Integers


class Logarithm(Enum):
    """Which real logarithm there is: none, the principal one, or one that turns the plane of -s, -s by pi."""

    NONE = 0
    PRINCIPAL = 1
    HALF_TURN = 2


def characteristic(n: Integers) -> tuple[int, ...]:
    """Trace and determinant of a 2x2 matrix; trace, sum of the principal minors and determinant of a 3x3 matrix."""
    if len(n) == 2:
        (a, b), (c, d) = n
        return a + d, a * d - b * c
    (a, b, c), (d, e, f), (g, h, i) = n
    first, second, third = e * i - f * h, a * i - c * g, a * e - b * d
    return a + e + i, first + second + third, a * first - b * (d * i - f * g) + c * (d * h - e * g)


def logarithm(n: Integers) -> Logarithm:
    """The kind of real logarithm of a 2x2 or 3x3 matrix whose determinant is positive."""
    return _plane(n) if len(n) == 2 else _space(n)


def _plane(n: Integers) -> Logarithm:
    (a, b), (c, d) = n
    if a + d >= 0 or (a - d) ** 2 + 4 * b * c < 0:  # with det > 0: two positive eigenvalues, or a complex pair
        return Logarithm.PRINCIPAL
    return Logarithm.HALF_TURN if b == 0 == c and a == d else Logarithm.NONE


def _space(n: Integers) -> Logarithm:
    c2, c1, c0 = characteristic(n)
    # The negative eigenvalues are the positive roots -x of x^3 + c2 x^2 + c1 x + c0: by Descartes none, or, with two
    # changes of sign, two if all roots are real.
    if c2 >= 0 and c1 >= 0:
        return Logarithm.PRINCIPAL
    discriminant = (c2 * c2 - 4 * c1) * c1 * c1 + (18 * c1 * c2 - 4 * c2**3 - 27 * c0) * c0
    if discriminant < 0:
        return Logarithm.PRINCIPAL
    if discriminant > 0:
        return Logarithm.NONE
    # Of two negative roots and a positive one, the negative ones are the equal ones.
    numerator, denominator = double_root(c2, c1, c0)
    rows = [[denominator * x - (numerator if i == j else 0) for j, x in enumerate(row)] for i, row in enumerate(n)]
    return Logarithm.HALF_TURN if _rank_at_most_one(rows) else Logarithm.NONE


def double_root(c2: int, c1: int, c0: int) -> tuple[int, int]:
    """Numerator and denominator of the double, not triple, root of x^3 - c2 x^2 + c1 x - c0."""
    return c1 * c2 - 9 * c0, 2 * (c2 * c2 - 3 * c1)


def _rank_at_most_one(rows: Integers) -> bool:
    (a, b, c), (d, e, f), (g, h, i) = rows
    minors = (a * e - b * d, a * f - c * d, b * f - c * e, a * h - b * g, a * i - c * g, b * i - c * h)
    return not any(minors) and not any((d * h - e * g, d * i - f * g, e * i - f * h))
