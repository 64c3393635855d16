"""Exact integer arithmetic on binary numbers: every float64 and every mpf is an integer times a power of two."""

from __future__ import annotations

from collections.abc import Sequence

from affinecert.reference._matrices import Array

Integers = Sequence[Sequence[int]]


def integers(matrix: Array) -> tuple[Integers, int]:
    """The integer matrix N and the exponent e with matrix = N 2**e, for a matrix of mpf."""
    pairs = [[(x, *x.man_exp) for x in row] for row in matrix]
    exponent = min((e for row in pairs for _, m, e in row if m), default=0)
    return [[int(-m if x < 0 else m) << (e - exponent) if m else 0 for x, m, e in row] for row in pairs], exponent


def float_integers(rows: Sequence[Sequence[float]]) -> Integers:
    """A matrix of float64 times the least power of two that makes all of it integer."""
    ratios = [[x.as_integer_ratio() for x in row] for row in rows]
    unit = max(d for row in ratios for _, d in row)
    return [[n * (unit // d) for n, d in row] for row in ratios]


def determinant(n: Integers) -> int:
    """The determinant of a 2x2 or 3x3 integer matrix."""
    if len(n) == 2:
        return n[0][0] * n[1][1] - n[0][1] * n[1][0]
    (a, b, c), (d, e, f), (g, h, i) = n
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def adjugate(n: Integers) -> Integers:
    """The adjugate of a 2x2 or 3x3 integer matrix N: N adj N = det N I."""
    if len(n) == 2:
        return [[n[1][1], -n[0][1]], [-n[1][0], n[0][0]]]
    (a, b, c), (d, e, f), (g, h, i) = n
    return [
        [e * i - f * h, c * h - b * i, b * f - c * e],
        [f * g - d * i, a * i - c * g, c * d - a * f],
        [d * h - e * g, b * g - a * h, a * e - b * d],
    ]


def product(m: Integers, n: Integers) -> Integers:
    """The product of two integer matrices."""
    return [[sum(x * y for x, y in zip(row, column, strict=True)) for column in zip(*n, strict=True)] for row in m]


def determinant_sign(matrix: Array) -> int:
    """The sign of the determinant of a 2x2 or 3x3 matrix of mpf: -1, 0 or 1."""
    value = determinant(integers(matrix)[0])
    return (value > 0) - (value < 0)
