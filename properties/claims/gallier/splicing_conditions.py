"""Section 8.1: the conditions where two splines meet, and what follows from them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.definitions import determinant
from affinecert.properties.claims.gallier.splice import Lengths, combination, equation, symbols
from affinecert.reference._splicing import spans


def _banded(corner: Fraction) -> Callable[[int], list[list[Fraction]]]:
    """The matrix of that system for M + 1 points, (M - 1, M - 1)."""

    def matrix(m: int) -> list[list[Fraction]]:
        rows = [[Fraction({0: 4, 1: 1}.get(abs(i - j), 0)) for j in range(m - 1)] for i in range(m - 1)]
        rows[0][0] = rows[-1][-1] = corner
        return rows

    return matrix


def _singular(matrix: Callable[[int], list[list[Fraction]]], m: int) -> int:
    return int(determinant(np.array(matrix(m), dtype=object)) == 0)


def _bezier_derivatives(points: Sequence[Fraction], t: int) -> tuple[Fraction, Fraction]:
    """The first and second derivative of the sum of binomial(3, k) t^k (1 - t)^(3 - k) b_k, by its coefficients."""
    b0, b1, b2, b3 = points
    _, first, second, third = b0, 3 * (b1 - b0), 3 * (b0 - 2 * b1 + b2), b3 - b0 + 3 * (b1 - b2)
    return first + 2 * second * t + 3 * third * t**2, 2 * second + 6 * third * t


def _bezier_form(order: int, factor: int, middle: int = 2) -> Callable[[Sequence[Fraction]], tuple[Fraction, Fraction]]:
    """The derivatives at 0 and at 1 as printed."""

    def printed(points: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
        b0, b1, b2, b3 = points
        if order == 1:
            return factor * (b1 - b0), factor * (b3 - b2)
        return factor * (b0 - middle * b1 + b2), factor * (b1 - middle * b2 + b3)

    return printed


def _bezier_gap(order: int) -> Callable[[Any, Sequence[Fraction]], float]:
    def deviation(form: Any, points: Sequence[Fraction]) -> float:
        truth = [_bezier_derivatives(points, t)[order - 1] for t in (0, 1)]
        return float(max(abs(a - b) for a, b in zip(form(points), truth, strict=True)))

    return deviation


def _control_points() -> tuple[tuple[Fraction, ...], ...]:
    chosen = (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (3, -1, 4, 7)
    return tuple(tuple(map(Fraction, points)) for points in chosen)


Derivative = tuple[int, str]
"""Which derivative is claimed, and its formula."""


def _at_junction(side: int) -> Callable[[Derivative, Lengths], float]:
    """How far a derivative is from the curve's, at the end of the first segment (side 0) or the start of the second."""

    def deviation(form: Derivative, lengths: Lengths) -> float:
        order, formula = form
        d, x = symbols(lengths)
        b = spans(d[side], x[side])[side - 1]
        if order == 1:
            truth = 3 * (b[1] - b[0]) if side else 3 * (b[3] - b[2])
        else:
            truth = 6 * (b[0] - 2 * b[1] + b[2]) if side else 6 * (b[1] - 2 * b[2] + b[3])
        return float(max(abs(each) for each in combination(formula, lengths) - truth))

    return deviation


def _two() -> tuple[Lengths, ...]:
    return (4, 4), (5, 4), (4, 6)


def _short() -> tuple[Lengths, ...]:
    return (3, 3), (3, 4), (5, 3), (4, 4)


def _derivative(
    name: str, side: int, order: int, printed: str, change: tuple[str, str], statement: str
) -> Claim[Any, Any]:
    right = printed.split(" = ")[1]
    return Claim(
        id=f"gallier.8.1.{name}",
        place="section 8.1, derivatives at x_M and y_0",
        statement=statement,
        printed=printed,
        verdict=Verdict.CONFIRMED,
        form=(order, right),
        cases=_short,
        deviation=_at_junction(side),
        copies=(Copy(f"{change[1]} for {change[0]}", (order, right.replace(*change, 1))),),
    )


def _misprinted(name: str, printed: str, change: tuple[str, str], statement: str) -> Claim[Any, Any]:
    """A second derivative that is printed with one prime."""
    right = printed.split(" = ")[1]
    return Claim(
        id=f"gallier.8.1.{name}",
        place="section 8.1, derivatives at x_M and y_0",
        statement=statement,
        printed=printed,
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=(1, right),
        cases=_short,
        deviation=_at_junction(0),
        correction=Correction(statement=printed.replace("S'", "S''"), form=(2, right)),
        copies=(Copy(f"{change[1]} for {change[0]}", (2, right.replace(*change, 1))),),
    )


_equation = partial(equation, section="8.1", cases=_two)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    _equation(
        name="system",
        place="first system",
        printed="7/2 d_1 + d_2 = 6 x_1 - 3/2 d_0; d_1 + 4 d_2 + d_3 = 6 x_2; "
        "d_{M-2} + 7/2 d_{M-1} = 6 x_{M-1} - 3/2 d_M",
        changes=(
            ("7/2", "4"),
            ("4 d_2", "5 d_2"),
        ),
        statement="The inner de Boor points of a cubic spline through M + 1 points, M at least 4, solve a tridiagonal "
        "system with 7/2 in the corners.",
        cases=lambda: ((5,), (6,), (7,)),
    ),
    _equation(
        name="system_of_four_points",
        place="system for M = 3",
        printed="7/2 d_1 + d_2 = 6 x_1 - 3/2 d_0; d_1 + 7/2 d_2 = 6 x_2 - 3/2 d_3",
        changes=(("7/2 d_2", "4 d_2"),),
        statement="For four data points the system has two rows, with 7/2 on the diagonal.",
        cases=lambda: ((4,),),
    ),
    Claim(
        id="gallier.8.1.free_points",
        place="section 8.1",
        statement="d_0 and d_M are free, and the system gives the other de Boor points: its matrix is regular.",
        verdict=Verdict.CONFIRMED,
        form=_banded(Fraction(7, 2)),
        cases=lambda: tuple(range(3, 9)),
        deviation=_singular,
        copies=(Copy("1 for 7/2 in the corners", _banded(Fraction(1))),),
    ),
    Claim(
        id="gallier.8.1.bezier_first_derivatives",
        place="section 8.1, derivatives of a Bézier curve",
        statement="The velocity of a cubic Bézier curve at its ends is three times its first and last side.",
        printed="C'(0) = 3 (b_1 - b_0), C'(1) = 3 (b_3 - b_2)",
        verdict=Verdict.CONFIRMED,
        form=_bezier_form(1, 3),
        cases=_control_points,
        deviation=_bezier_gap(1),
        copies=(Copy("2 for 3", _bezier_form(1, 2)),),
    ),
    Claim(
        id="gallier.8.1.bezier_second_derivatives",
        place="section 8.1, derivatives of a Bézier curve",
        statement="The second derivative of a cubic Bézier curve at its ends is six times a second difference.",
        printed="C''(0) = 6 (b_0 - 2 b_1 + b_2), C''(1) = 6 (b_1 - 2 b_2 + b_3)",
        verdict=Verdict.CONFIRMED,
        form=_bezier_form(2, 6),
        cases=_control_points,
        deviation=_bezier_gap(2),
        copies=(Copy("3 for 6", _bezier_form(2, 3)), Copy("3 for 2 in the middle", _bezier_form(2, 6, middle=3))),
    ),
    _derivative(
        "velocity_at_end",
        0,
        1,
        "S'_1(x_M) = 3 (x_M - d_M)",
        ("d_M", "d_{M-1}"),
        "The first spline ends with velocity three times the last side of its control polygon.",
    ),
    _derivative(
        "velocity_at_start",
        1,
        1,
        "S'_2(y_0) = 3 (f_0 - y_0)",
        ("3", "2"),
        "The second spline starts with velocity three times the first side of its control polygon.",
    ),
    _misprinted(
        "acceleration_at_end",
        "S'_1(x_M) = 6 (1/2 d_{M-1} + 1/2 d_M - 2 d_M + x_M)",
        ("1/2 d_M", "d_M"),
        "The second derivative at the end of the first spline; the left side is printed with one prime.",
    ),
    _derivative(
        "acceleration_at_start",
        1,
        2,
        "S''_2(y_0) = 6 (y_0 - 2 f_0 + 1/2 f_0 + 1/2 f_1)",
        ("1/2 f_0", "f_0"),
        "The second derivative at the start of the second spline.",
    ),
    _misprinted(
        "acceleration_at_end_simplified",
        "S'_1(x_M) = 6 (1/2 d_{M-1} - 3/2 d_M + x_M)",
        ("3/2", "5/2"),
        "The second derivative at the end, with d_M collected; again with one prime.",
    ),
    _derivative(
        "acceleration_at_start_simplified",
        1,
        2,
        "S''_2(y_0) = 6 (y_0 - 3/2 f_0 + 1/2 f_1)",
        ("3/2", "5/2"),
        "The second derivative at the start, with f_0 collected.",
    ),
    _equation(
        name="velocities_agree",
        place="conditions",
        printed="x_M - d_M = f_0 - y_0",
        changes=(("f_0 - y_0", "y_0 - f_0"),),
        statement="Velocities agree where the last side of one polygon is the first side of the next.",
        cases=_short,
    ),
    _equation(
        name="accelerations_agree",
        place="conditions",
        printed="1/2 d_{M-1} - 3/2 d_M + x_M = y_0 - 3/2 f_0 + 1/2 f_1",
        changes=(("3/2 f_0", "f_0"),),
        statement="The condition for second derivatives to agree.",
        cases=_short,
    ),
    _equation(
        name="midpoints",
        place="geometric meaning",
        printed="1/2 (d_M + f_0) = 1/2 (x_M + y_0)",
        changes=(("d_M", "d_{M-1}"),),
        statement="The midpoints of (d_M, f_0) and (x_M, y_0) coincide.",
        cases=_short,
    ),
    _equation(
        name="substituted",
        place="'we get'",
        printed="d_{M-1} - 3 (x_M + y_0 - f_0) + 2 x_M = 2 y_0 - 3 f_0 + f_1",
        changes=(("2 x_M", "3 x_M"),),
        statement="The second condition after d_M = x_M + y_0 - f_0 is put in.",
        cases=_short,
    ),
    _equation(
        name="star",
        place="equation (*)",
        printed="f_0 = 1/6 x_M + 5/6 y_0 - 1/6 d_{M-1} + 1/6 f_1",
        changes=(
            ("5/6", "4/6"),
            ("- 1/6 d", "+ 1/6 d"),
        ),
        statement="The first de Boor point behind a junction, from its neighbours.",
    ),
    _equation(
        name="double_star",
        place="equation (**)",
        printed="d_M = 5/6 x_M + 1/6 y_0 + 1/6 d_{M-1} - 1/6 f_1",
        changes=(
            ("5/6", "4/6"),
            ("- 1/6 f", "+ 1/6 f"),
        ),
        statement="The last de Boor point before a junction, from its neighbours.",
    ),
    _equation(
        name="stars_of_three_points",
        place="after (**)",
        printed="f_0 = 1/6 x_M + 5/6 y_0 - 1/6 d_{M-1} + 1/6 f_1; d_M = 5/6 x_M + 1/6 y_0 + 1/6 d_{M-1} - 1/6 f_1",
        changes=(
            ("5/6 y_0", "4/6 y_0"),
            ("5/6 x_M", "4/6 x_M"),
        ),
        statement="Equations (*) and (**) also hold where one of the sequences, or both, have three points.",
        cases=lambda: ((3, 3), (3, 4), (5, 3)),
    ),
    _equation(
        name="inner_equations",
        place="'we also have'",
        printed="d_{M-2} + 7/2 d_{M-1} = 6 x_{M-1} - 3/2 d_M; 7/2 f_1 + f_2 = 6 y_1 - 3/2 f_0",
        changes=(("3/2 f_0", "1/2 f_0"),),
        statement="The last row of the first system and the first row of the second one.",
    ),
    _equation(
        name="before_junction_in_quarters",
        place="'From the first equation and (**)'",
        printed="d_{M-2} + 7/2 d_{M-1} = 6 x_{M-1} - 5/4 x_M - 1/4 y_0 - 1/4 d_{M-1} + 1/4 f_1",
        changes=(
            ("5/4", "4/4"),
            ("+ 1/4 f", "- 1/4 f"),
        ),
        statement="The last row of the first system with d_M eliminated.",
    ),
    _equation(
        name="behind_junction_in_quarters",
        place="'From the second equation and (*)'",
        printed="7/2 f_1 + f_2 = 6 y_1 - 1/4 x_M - 5/4 y_0 + 1/4 d_{M-1} - 1/4 f_1",
        changes=(
            ("5/4", "4/4"),
            ("+ 1/4 d", "- 1/4 d"),
        ),
        statement="The first row of the second system with f_0 eliminated.",
    ),
    _equation(
        name="before_junction",
        place="'In summary'",
        printed="4 d_{M-2} + 15 d_{M-1} - f_1 = 24 x_{M-1} - 5 x_M - y_0",
        changes=(
            ("15", "14"),
            ("5 x_M", "4 x_M"),
        ),
        statement="The equation of the last inner point before a junction.",
    ),
    _equation(
        name="behind_junction",
        place="'In summary'",
        printed="-d_{M-1} + 15 f_1 + 4 f_2 = -x_M - 5 y_0 + 24 y_1",
        changes=(
            ("15", "14"),
            ("5 y_0", "4 y_0"),
        ),
        statement="The equation of the first inner point behind a junction.",
    ),
)
