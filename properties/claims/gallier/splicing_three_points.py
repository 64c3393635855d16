"""Sections 8.2 and 8.3: the equations where a sequence has three points only."""

from __future__ import annotations

from functools import partial
from itertools import product
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.gallier.splice import Lengths, equation, without_ends


def _first() -> tuple[Lengths, ...]:
    return (3, 4), (3, 5)


def _last() -> tuple[Lengths, ...]:
    return (4, 3), (5, 3)


def _both() -> tuple[Lengths, ...]:
    return ((3, 3),)


def _middle() -> tuple[Lengths, ...]:
    return (3, 3, 3), (4, 3, 4), (5, 3, 3)


def _inner() -> tuple[Lengths, ...]:
    """A run of three sequences of three points between longer ones; the first segment of the run is the second."""
    return (4, 3, 3, 3, 4), (5, 3, 3, 3, 4)


def _leading() -> tuple[Lengths, ...]:
    return (3, 3, 3, 4), (3, 3, 3, 5)


def _trailing() -> tuple[Lengths, ...]:
    return (4, 3, 3, 3), (5, 3, 3, 3)


def _only() -> tuple[Lengths, ...]:
    return ((3, 3, 3, 3),)


_second = partial(equation, section="8.2")
_third = partial(equation, section="8.3")


def _three_point_relation(index: int, lengths: Lengths) -> float:
    """Whether the relation of three data points holds for a sequence of M_j + 1 points, M_j = ``index``."""
    return without_ends("d_0 + 2 d_1 + d_2 = 4 x_1", (index + 1, *lengths))


Rule = dict[str, Any]
"""The conditions of the four cases, by name, on K, k, m and the lists M_1, ..., M_K (from index 1)."""


def _cases(least_at_end: int) -> Rule:
    return {
        "case 1": lambda n, k, m, length: k >= 2 and k + m - 1 <= n - 1,
        "case 2": lambda n, k, m, length: k == 1 and least_at_end <= m <= n - 1,
        "case 3": lambda n, k, m, length: k == n - m + 1 and least_at_end <= m <= n - 1,
        "case 4": lambda n, k, m, length: k == 1 and m == n,
        "section 8.2, first": lambda n, k, m, length: k == 1 and m == 1 and n > 1,
        "section 8.2, last": lambda n, k, m, length: k == n and m == 1 and n > 1,
    }


def _runs(lengths: Lengths) -> list[tuple[int, int]]:
    """The maximal runs of sequences of three points: the number k of the first one, from 1, and how many they are."""
    found: list[tuple[int, int]] = []
    for number, length in enumerate(lengths, start=1):
        if length == 3:
            if found and sum(found[-1]) == number:
                found[-1] = (found[-1][0], found[-1][1] + 1)
            else:
                found.append((number, 1))
    return found


def _not_in_one_case(rule: Rule, lengths: Lengths) -> int:
    """How many runs are in no case, or in several."""
    return sum(sum(holds(len(lengths), k, m, lengths) for holds in rule.values()) != 1 for k, m in _runs(lengths))


def _lists() -> list[Lengths]:
    return [lengths for count in range(1, 6) for lengths in product((3, 4), repeat=count) if 3 in lengths]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    _second(
        name="three_points",
        place="first equation",
        statement="The de Boor points of a cubic spline through three points have one relation.",
        printed="d_0 + 2 d_1 + d_2 = 4 x_1",
        changes=(("2 d_1", "3 d_1"),),
        cases=lambda: ((3,), (3, 4)),
    ),
    _second(
        name="first_d_2",
        place="the first spline has 3 points, 'equation (**) still holds'",
        statement="The last de Boor point of a first sequence of three points.",
        printed="d_2 = 5/6 x_2 + 1/6 y_0 + 1/6 d_1 - 1/6 f_1",
        changes=(("5/6", "4/6"),),
        cases=_first,
    ),
    _second(
        name="first_f_0",
        place="the first spline has 3 points, using (*)",
        statement="The first de Boor point behind a first sequence of three points.",
        printed="f_0 = 1/6 x_2 + 5/6 y_0 - 1/6 d_1 + 1/6 f_1",
        changes=(("- 1/6 d_1", "+ 1/6 d_1"),),
        cases=_first,
    ),
    _second(
        name="first_in_sixths",
        place="the first spline has 3 points, 'we get'",
        statement="The relation of three points with d_2 eliminated.",
        printed="d_0 + 2 d_1 = 4 x_1 - 5/6 x_2 - 1/6 y_0 - 1/6 d_1 + 1/6 f_1",
        changes=(("+ 1/6 f_1", "- 1/6 f_1"),),
        cases=_first,
    ),
    _second(
        name="first_with_13",
        place="the first spline has 3 points, 'which yields'",
        statement="The first equation before an end condition is put in.",
        printed="6 d_0 + 13 d_1 - f_1 = 24 x_1 - 5 x_2 - y_0",
        changes=(("13", "12"), ("5 x_2", "6 x_2")),
        cases=_first,
    ),
    _second(
        name="behind_first",
        place="the first spline has 3 points, 'becomes'",
        statement="The equation of the first inner point behind a sequence of three points.",
        printed="-d_1 + 15 f_1 + 4 f_2 = -x_2 - 5 y_0 + 24 y_1",
        changes=(("15", "14"),),
        cases=_first,
    ),
    _second(
        name="natural_start",
        place="natural end condition for d_0",
        statement="The second derivative at the start vanishes for this d_0.",
        printed="d_0 = 2/3 x_0 + 1/3 d_1",
        changes=(("2/3 x_0 + 1/3 d_1", "1/3 x_0 + 2/3 d_1"),),
        cases=lambda: ((3,), (4,), (3, 4)),
        natural=True,
    ),
    _second(
        name="natural_end",
        place="natural end condition for f_N",
        statement="The second derivative at the end vanishes for this f_N.",
        printed="f_N = 1/3 f_{N-1} + 2/3 y_N",
        changes=(("1/3 f_{N-1} + 2/3 y_N", "2/3 f_{N-1} + 1/3 y_N"),),
        cases=_first,
        natural=True,
    ),
    _second(
        name="first_natural",
        place="the first spline has 3 points, with the natural end condition",
        statement="The first equation of the system.",
        printed="15 d_1 - f_1 = -4 x_0 + 24 x_1 - 5 x_2 - y_0",
        changes=(("15", "14"), ("4 x_0", "5 x_0")),
        cases=_first,
        natural=True,
    ),
    _second(
        name="last_natural",
        place="the first spline has 3 points, the last equation",
        statement="The last equation of the system, with the natural end condition at the end.",
        printed="f_{N-2} + 4 f_{N-1} = 6 y_{N-1} - y_N",
        changes=(("4 f", "7/2 f"),),
        cases=lambda: ((3, 5), (3, 6)),
        natural=True,
    ),
    _second(
        name="last_f_0",
        place="the last spline has 3 points, equation (*)",
        statement="The first de Boor point of a last sequence of three points.",
        printed="f_0 = 1/6 x_M + 5/6 y_0 - 1/6 d_{M-1} + 1/6 f_1",
        changes=(("5/6", "4/6"),),
        cases=_last,
    ),
    _second(
        name="last_in_sixths",
        place="the last spline has 3 points, 'we get'",
        statement="The relation of three points with f_0 eliminated.",
        printed="2 f_1 + f_2 = 4 y_1 - 1/6 x_M - 5/6 y_0 + 1/6 d_{M-1} - 1/6 f_1",
        changes=(("- 1/6 f_1", "+ 1/6 f_1"),),
        cases=_last,
    ),
    _second(
        name="last_with_13",
        place="the last spline has 3 points, 'which yields'",
        statement="The last equation before an end condition is put in.",
        printed="-d_{M-1} + 13 f_1 + 6 f_2 = -x_M - 5 y_0 + 24 y_1",
        changes=(("13", "12"),),
        cases=_last,
    ),
    _second(
        name="before_last",
        place="the last spline has 3 points, using (**)",
        statement="The equation of the last inner point before a sequence of three points.",
        printed="4 d_{M-2} + 15 d_{M-1} - f_1 = 24 x_{M-1} - 5 x_M - y_0",
        changes=(("15", "14"),),
        cases=_last,
    ),
    _second(
        name="natural_f_2",
        place="the last spline has 3 points, natural end condition",
        statement="The second derivative at the end of a last sequence of three points vanishes for this f_2.",
        printed="f_2 = 1/3 f_1 + 2/3 y_2",
        changes=(("1/3 f_1", "2/3 f_1"),),
        cases=_last,
        natural=True,
    ),
    _second(
        name="last_three_natural",
        place="the last spline has 3 points, with the natural end condition",
        statement="The last equation of the system.",
        printed="-d_{M-1} + 15 f_1 = -x_M - 5 y_0 + 24 y_1 - 4 y_2",
        changes=(("15", "14"), ("4 y_2", "5 y_2")),
        cases=_last,
        natural=True,
    ),
    _second(
        name="first_of_four",
        place="the last spline has 3 points, 'the first equation of our system'",
        statement="The first equation of a sequence of five points or more, with the natural end condition.",
        printed="4 d_1 + d_2 = 6 x_1 - x_0",
        changes=(("4 d_1", "7/2 d_1"),),
        cases=lambda: ((5, 3), (6, 3)),
        natural=True,
    ),
    _second(
        name="only_three_points",
        place="the special case M = N = 2",
        statement="The two equations of two sequences of three points each.",
        printed="15 d_1 - f_1 = -4 x_0 + 24 x_1 - 5 x_2 - y_0; -d_1 + 15 f_1 = -x_2 - 5 y_0 + 24 y_1 - 4 y_2",
        changes=(("15 d_1", "14 d_1"), ("4 y_2", "5 y_2")),
        cases=_both,
        natural=True,
    ),
    _third(
        name="middle_ends",
        place="first equations",
        statement="The outer de Boor points of a sequence of three points between two others.",
        printed="f_0 = 1/6 x_M + 5/6 y_0 - 1/6 d_{M-1} + 1/6 f_1; f_2 = 5/6 y_2 + 1/6 z_0 + 1/6 f_1 - 1/6 g_1",
        changes=(("5/6 y_2", "4/6 y_2"),),
        cases=_middle,
    ),
    _third(
        name="middle",
        place="'we obtain'",
        statement="The equation of a sequence of three points between two others.",
        printed="-d_{M-1} + 14 f_1 - g_1 = -x_M - 5 y_0 + 24 y_1 - 5 y_2 - z_0",
        changes=(("14", "15"), ("5 y_2", "4 y_2")),
        cases=_middle,
    ),
    Claim(
        id="gallier.8.3.index_of_three_points",
        place="section 8.3, 'with M_j = 3'",
        statement="The sequences of three data points, of M_j + 1 points each, have M_j = 3.",
        printed="M_j = 3 for j = k, ..., k + m - 1",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=3,
        cases=lambda: ((4,), (3, 4)),
        deviation=_three_point_relation,
        correction=Correction(statement="M_j = 2 for j = k, ..., k + m - 1, as case 1 has it", form=2),
    ),
    Claim(
        id="gallier.8.3.four_cases",
        place="section 8.3, cases 1 to 4",
        statement="Every maximal run of sequences of three points is in exactly one of the four cases; one "
        "sequence alone at an end, in one of the two of section 8.2.",
        verdict=Verdict.CONFIRMED,
        form=_cases(2),
        cases=_lists,
        deviation=_not_in_one_case,
        copies=(Copy("1 for the least m of cases 2 and 3", _cases(1)), Copy("3 for it", _cases(3))),
    ),
    _third(
        name="case_1",
        place="case 1, intermediate equations",
        statement="The equations of a run of three sequences between longer ones; the last is printed with x_1 of the "
        "sequence before.",
        printed="-d^1_{M-1} + 14 d^2_1 - d^3_1 = -x^1_M - 5 x^2_0 + 24 x^2_1 - 5 x^2_2 - x^3_0; "
        "-d^2_1 + 14 d^3_1 - d^4_1 = -x^2_2 - 5 x^3_0 + 24 x^3_1 - 5 x^3_2 - x^4_0; "
        "-d^3_1 + 14 d^4_1 - d^5_1 = -x^3_1 - 5 x^4_0 + 24 x^4_1 - 5 x^4_2 - x^5_0",
        changes=(("14 d^4_1", "15 d^4_1"),),
        misprint=("-x^3_1 ", "-x^3_2 "),
        cases=_inner,
    ),
    _third(
        name="case_1_borders",
        place="case 1, first and last equation",
        statement="The equations next to a run of sequences of three points.",
        printed="4 d^1_{M-2} + 15 d^1_{M-1} - d^2_1 = 24 x^1_{M-1} - 5 x^1_M - x^2_0; "
        "-d^4_1 + 15 d^5_1 + 4 d^5_2 = -x^4_2 - 5 x^5_0 + 24 x^5_1",
        changes=(("15 d^5_1", "14 d^5_1"), ("- x^2_0", "+ x^2_0")),
        cases=_inner,
    ),
    _third(
        name="case_1_outer_points",
        place="case 1, 'We compute the de Boor points'",
        statement="The outer de Boor points at every junction, from (*) and (**).",
        printed="d^2_M = 5/6 x^2_M + 1/6 x^3_0 + 1/6 d^2_{M-1} - 1/6 d^3_1; "
        "d^3_0 = 1/6 x^2_M + 5/6 x^3_0 - 1/6 d^2_{M-1} + 1/6 d^3_1",
        changes=(("5/6 x^3_0", "4/6 x^3_0"),),
        cases=_inner,
    ),
    _third(
        name="case_2",
        place="case 2",
        statement="The equations of a run of three sequences at the start.",
        printed="15 d^1_1 - d^2_1 = -4 x^1_0 + 24 x^1_1 - 5 x^1_2 - x^2_0; "
        "-d^1_1 + 14 d^2_1 - d^3_1 = -x^1_2 - 5 x^2_0 + 24 x^2_1 - 5 x^2_2 - x^3_0; "
        "-d^2_1 + 14 d^3_1 - d^4_1 = -x^2_2 - 5 x^3_0 + 24 x^3_1 - 5 x^3_2 - x^4_0; "
        "-d^3_1 + 15 d^4_1 + 4 d^4_2 = -x^3_2 - 5 x^4_0 + 24 x^4_1",
        changes=(("14 d^2_1", "15 d^2_1"), ("-4 x^1_0", "-5 x^1_0")),
        cases=_leading,
        natural=True,
    ),
    _third(
        name="case_3",
        place="case 3",
        statement="The equations of a run of three sequences at the end; the last but one is printed with x_1 of the "
        "sequence before.",
        printed="4 d^1_{M-2} + 15 d^1_{M-1} - d^2_1 = 24 x^1_{M-1} - 5 x^1_M - x^2_0; "
        "-d^1_{M-1} + 14 d^2_1 - d^3_1 = -x^1_M - 5 x^2_0 + 24 x^2_1 - 5 x^2_2 - x^3_0; "
        "-d^2_1 + 14 d^3_1 - d^4_1 = -x^2_1 - 5 x^3_0 + 24 x^3_1 - 5 x^3_2 - x^4_0",
        changes=(("14 d^3_1", "15 d^3_1"),),
        misprint=("-x^2_1 ", "-x^2_2 "),
        cases=_trailing,
    ),
    _third(
        name="case_3_last",
        place="case 3, last equation",
        statement="The last equation of a run at the end, with the natural end condition.",
        printed="-d^3_1 + 15 d^4_1 = -x^3_2 - 5 x^4_0 + 24 x^4_1 - 4 x^4_2",
        changes=(("15", "14"), ("4 x^4_2", "5 x^4_2")),
        cases=_trailing,
        natural=True,
    ),
    _third(
        name="case_4",
        place="case 4",
        statement="The equations where every sequence has three points; the last but one is printed with x_2 of the "
        "sequence before for its own.",
        printed="15 d^1_1 - d^2_1 = -4 x^1_0 + 24 x^1_1 - 5 x^1_2 - x^2_0; "
        "-d^1_1 + 14 d^2_1 - d^3_1 = -x^1_2 - 5 x^2_0 + 24 x^2_1 - 5 x^2_2 - x^3_0; "
        "-d^2_1 + 14 d^3_1 - d^4_1 = -x^2_2 - 5 x^3_0 + 24 x^3_1 - 5 x^2_2 - x^4_0; "
        "-d^3_1 + 15 d^4_1 = -x^3_2 - 5 x^4_0 + 24 x^4_1 - 4 x^4_2",
        changes=(("15 d^4_1", "14 d^4_1"),),
        misprint=("24 x^3_1 - 5 x^2_2", "24 x^3_1 - 5 x^3_2"),
        cases=_only,
        natural=True,
    ),
)
