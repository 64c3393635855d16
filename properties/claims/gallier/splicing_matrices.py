"""Section 8: the matrices of the splicing equations, printed for some lists of sequences and told for all.

Every matrix is derived from the conditions on the spline, in rational numbers, and compared entry by entry.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.definitions import determinant
from affinecert.properties.claims.gallier.splice import Lengths, derived
from affinecert.reference._splicing import Rows, weights

Matrix = tuple[tuple[int, ...], ...]
"""The rows of a banded matrix, each about the diagonal; the first one from the diagonal on."""

FIRST, INNER, LAST = (4, 1), (1, 4, 1), (1, 4)
"""Rows of a first inner point, of one between others, and of a last one."""

BEFORE, BEHIND = (4, 15, -1), (-1, 15, 4)
"""Rows of the inner points next to a junction."""

THREE_FIRST, THREE, THREE_LAST = (15, -1), (-1, 14, -1), (-1, 15)
"""Rows of a sequence of three points: the first one, one between others, the last one."""


def _full(rows: Matrix) -> Rows:
    matrix = np.zeros((len(rows), len(rows)), dtype=object)
    for i, row in enumerate(rows):
        start = max(i - 1, 0)
        matrix[i, start : start + len(row)] = row[: len(rows) - start]
    return matrix


def _wrong_entries(rows: Matrix, lengths: Lengths) -> int:
    """How many entries differ from the matrix that is derived; a matrix of another size is wrong everywhere."""
    truth, _ = derived(lengths)
    return int((_full(rows) != truth).sum()) if len(rows) == len(truth) else truth.size


def _with_row(rows: Matrix, number: int, row: tuple[int, ...]) -> Matrix:
    return (*rows[:number], row, *rows[number + 1 :])


def _printed(
    name: str, place: str, lengths: Lengths, rows: Matrix, perturbed: tuple[int, tuple[int, ...]]
) -> Claim[Matrix, Lengths]:
    number, row = perturbed
    return Claim(
        id=f"gallier.{name}",
        place=place,
        statement=f"The matrix for sequences of {', '.join(map(str, lengths))} points.",
        printed=_told(rows),
        verdict=Verdict.CONFIRMED,
        form=rows,
        cases=lambda: (lengths,),
        deviation=_wrong_entries,
        copies=(Copy(f"row {number + 1} is {_told((row,))}", _with_row(rows, number, row)),),
    )


def _misprinted(name: str, place: str, lengths: Lengths, rows: Matrix) -> Claim[Matrix, Lengths]:
    """A matrix whose last two rows are printed wrong."""
    true = (*rows[:-2], THREE, THREE_LAST)
    return Claim(
        id=f"gallier.{name}",
        place=place,
        statement=f"The matrix for sequences of {', '.join(map(str, lengths))} points.",
        printed=_told(rows),
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=rows,
        cases=lambda: (lengths,),
        deviation=_wrong_entries,
        correction=Correction(
            statement="the last two rows are (-1, 14, -1) and (-1, 15), as the equations of case 3 say", form=true
        ),
        copies=(Copy("15 for 14 in the last row but one", _with_row(true, len(true) - 2, (-1, 15, -1))),),
        remark="As printed, the last row has its diagonal entry -1 and 15 beside it: the matrix is not diagonally "
        "dominant, and its solution is not the spline.",
    )


def _told(rows: Matrix) -> str:
    return "; ".join(" ".join(map(str, row)) for row in rows)


Rule = Callable[[Lengths], Matrix]


def _rule(before: tuple[int, ...] = BEFORE, three: tuple[int, ...] = THREE) -> Rule:
    """The rows by the kinds of their inner points, for any list of two sequences or more."""

    def rows(lengths: Lengths) -> Matrix:
        found: list[tuple[int, ...]] = []
        for number, length in enumerate(lengths):
            at_start, at_end = number == 0, number == len(lengths) - 1
            if length == 3:
                found.append(THREE_FIRST if at_start else THREE_LAST if at_end else three)
                continue
            found.append(FIRST if at_start else BEHIND)
            found += [INNER] * (length - 4)
            found.append(LAST if at_end else before)
        return tuple(found)

    return rows


def _wrong_by_rule(rule: Rule, lengths: Lengths) -> int:
    return _wrong_entries(rule(lengths), lengths)


def _lists(*points: int, most: int = 4) -> Callable[[], list[Lengths]]:
    """All lists of two to ``most`` sequences of these numbers of points."""
    return lambda: [each for count in range(2, most + 1) for each in product(points, repeat=count)]


def _dimension(form: Callable[[Lengths], int], lengths: Lengths) -> int:
    """How far the size told is from that of the derived matrix."""
    return abs(form(lengths) - len(derived(lengths)[0]))


def _size(each: int) -> Callable[[Lengths], int]:
    """M_1 + ... + M_K less ``each`` for every sequence."""
    return lambda lengths: sum(length - 1 - each for length in lengths)


Place = Callable[[Lengths, int], int]
"""The index, from 1, of a row by k."""


def _rows_at(entries: tuple[int, ...]) -> Callable[[Place, Lengths], int]:
    """How many junctions do not have the row with these entries at the place told."""

    def deviation(place: Place, lengths: Lengths) -> int:
        matrix, _ = derived(lengths)
        rows = [matrix[place(lengths, k) - 1] for k in range(1, len(lengths))]
        return sum(tuple(row[row != 0]) != entries for row in rows)

    return deviation


def _index(offset: int) -> Place:
    """M_1 + ... + M_k - k + offset."""
    return lambda lengths, k: sum(length - 1 for length in lengths[:k]) - k + offset


Ends = tuple[tuple[int, ...], tuple[int, ...]]


def _wrong_ends(ends: Ends, lengths: Lengths) -> int:
    matrix, _ = derived(lengths)
    return sum(tuple(row[row != 0]) != entries for row, entries in zip((matrix[0], matrix[-1]), ends, strict=True))


def _not_tridiagonal(reach: int, lengths: Lengths) -> int:
    """How many entries that are not 0 lie further from the diagonal than ``reach``."""
    matrix, _ = derived(lengths)
    return sum(1 for (i, j), entry in np.ndenumerate(matrix) if entry and abs(i - j) > reach)


def _not_dominant(rule: Rule, lengths: Lengths) -> int:
    """How many rows are not strictly dominated by their diagonal entry; all of them if the matrix is singular."""
    matrix = _full(rule(lengths))
    weak = sum(2 * abs(matrix[i, i]) <= sum(abs(matrix[i])) for i in range(len(matrix)))
    return weak or (0 if determinant(matrix) else len(matrix))


def _spliced(lengths: Lengths) -> Rows:
    """The Bezier points of the spans, as rows of weights of the data: (spans, 4, points)."""
    return weights(lengths).bezier


def _each_alone(lengths: Lengths) -> Rows:
    """The same of natural splines through each sequence by itself."""
    spans = np.zeros((sum(lengths) - len(lengths), 4, sum(lengths)), dtype=object)
    first_span = first_point = 0
    for length in lengths:
        spans[first_span : first_span + length - 1, :, first_point : first_point + length] = weights((length,)).bezier
        first_span, first_point = first_span + length - 1, first_point + length
    return spans


def _broken_spline(spline: Callable[[Lengths], Rows], lengths: Lengths) -> float:
    """The largest jump of a first or second derivative anywhere, or miss of a data point, in weights of the data."""
    spans = spline(lengths)
    velocities = spans[1:, 1] - spans[1:, 0] - (spans[:-1, 3] - spans[:-1, 2])
    accelerations = (spans[1:, 0] - 2 * spans[1:, 1] + spans[1:, 2]) - (
        spans[:-1, 1] - 2 * spans[:-1, 2] + spans[:-1, 3]
    )
    firsts = np.cumsum([0, *lengths])
    starts = [point for point in range(sum(lengths)) if point + 1 not in firsts]
    data = np.eye(sum(lengths), dtype=int).astype(object)
    misses = spans[:, 0] - data[starts], spans[:, 3] - data[[point + 1 for point in starts]]
    return float(max(abs(each) for rows in (velocities, accelerations, *misses) for each in rows.flat))


_NINE = (FIRST, BEFORE, BEHIND, BEFORE, BEHIND, BEFORE, BEHIND, INNER, LAST)
_EIGHT = (THREE_FIRST, BEHIND, INNER, BEFORE, BEHIND, INNER, BEFORE, THREE_LAST)
_ELEVEN = (FIRST, INNER, BEFORE, THREE, THREE, BEHIND, INNER, BEFORE, BEHIND, INNER, LAST)
_FIVE = (THREE_FIRST, THREE, THREE, BEHIND, INNER, BEFORE, BEHIND, INNER, LAST)
_SIX = (THREE_FIRST, THREE, THREE, BEHIND, INNER, BEFORE, BEHIND, INNER, BEFORE, THREE_LAST)
_WRONG_END = ((-1, 4, -1), (15, -1))
_SEVEN = (FIRST, INNER, BEFORE, THREE, THREE, BEHIND, INNER, BEFORE, BEHIND, INNER, BEFORE)
_EIGHT_SEQUENCES = (THREE_FIRST, BEHIND, BEFORE, THREE, THREE, BEHIND, INNER, BEFORE, BEHIND, INNER, BEFORE)

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.8.1.dimension",
        place="section 8.1, 'tridiagonal matrix of dimension'",
        statement="The system has M_1 + ... + M_K - K equations.",
        printed="M_1 + ... + M_K - K",
        verdict=Verdict.CONFIRMED,
        form=_size(1),
        cases=_lists(4, 5),
        deviation=_dimension,
        copies=(Copy("without - K", _size(0)),),
    ),
    Claim(
        id="gallier.8.1.tridiagonal",
        place="section 8.1, 'tridiagonal matrix of dimension'",
        statement="The matrix is tridiagonal, however many sequences there are.",
        verdict=Verdict.CONFIRMED,
        form=1,
        cases=_lists(4, 5),
        deviation=_not_tridiagonal,
        copies=(Copy("diagonal", 0),),
    ),
    Claim(
        id="gallier.8.1.rows_before_junctions",
        place="section 8.1, 'the row of index'",
        statement="The row of index M_1 + ... + M_k - k has the entries 4, 15, -1, for k = 1, ..., K - 1.",
        verdict=Verdict.CONFIRMED,
        form=_index(0),
        cases=_lists(4, 5),
        deviation=_rows_at(BEFORE),
        copies=(Copy("the index one less", _index(-1)),),
    ),
    Claim(
        id="gallier.8.1.rows_behind_junctions",
        place="section 8.1, 'the row of index'",
        statement="The row of index M_1 + ... + M_k - k + 1 has the entries -1, 15, 4, for k = 1, ..., K - 1.",
        verdict=Verdict.CONFIRMED,
        form=_index(1),
        cases=_lists(4, 5),
        deviation=_rows_at(BEHIND),
        copies=(Copy("the index one less", _index(0)),),
    ),
    Claim(
        id="gallier.8.1.end_rows",
        place="section 8.1, 'the first row contains'",
        statement="The first row has the entries 4, 1, and the last one 1, 4, with natural end conditions.",
        verdict=Verdict.CONFIRMED,
        form=(FIRST, LAST),
        cases=_lists(4, 5),
        deviation=_wrong_ends,
        copies=(Copy("15, -1 for the first row", (THREE_FIRST, LAST)),),
    ),
    Claim(
        id="gallier.8.1.dominant",
        place="section 8.1, 'row diagonally dominant'",
        statement="The matrices for sequences of four points or more are row diagonally dominant and regular.",
        verdict=Verdict.CONFIRMED,
        form=_rule(),
        cases=_lists(4, 5),
        deviation=_not_dominant,
        copies=(Copy("5 for 15 before junctions", _rule(before=(4, 5, -1))),),
    ),
    _printed("8.1.matrix", "section 8.1, 9 x 9 matrix", (4, 4, 4, 5), _NINE, (7, (1, 4, -1))),
    _printed("8.2.matrix", "section 8.2, 8 x 8 matrix", (3, 5, 5, 3), _EIGHT, (6, (4, 14, -1))),
    Claim(
        id="gallier.8.2.dominant",
        place="section 8.2, 'still row diagonally dominant'",
        statement="The matrices with sequences of three points at the ends are row diagonally dominant and regular.",
        verdict=Verdict.CONFIRMED,
        form=_rule(),
        cases=lambda: [(3, *inner, 3) for inner in _lists(4, 5, most=3)()] + [(3, 3), (3, 4), (5, 3)],
        deviation=_not_dominant,
        copies=(Copy("5 for 15 before junctions", _rule(before=(4, 5, -1))),),
    ),
    _printed("8.3.case_1.matrix", "section 8.3, case 1, 11 x 11 matrix", (5, 3, 3, 5, 5), _ELEVEN, (3, (-1, 15, -1))),
    _printed("8.3.case_2.matrix_5", "section 8.3, case 2, K = 5", (3, 3, 3, 5, 5), _FIVE, (0, (14, -1))),
    _printed("8.3.case_2.matrix_6", "section 8.3, case 2, K = 6", (3, 3, 3, 5, 5, 3), _SIX, (9, (-1, 14))),
    _misprinted("8.3.case_3.matrix_7", "section 8.3, case 3, K = 7", (5, 3, 3, 5, 5, 3, 3), _SEVEN + _WRONG_END),
    _misprinted(
        "8.3.case_3.matrix_8", "section 8.3, case 3, K = 8", (3, 4, 3, 3, 5, 5, 3, 3), _EIGHT_SEQUENCES + _WRONG_END
    ),
    _printed(
        "8.3.case_4.matrix",
        "section 8.3, case 4, K = 8",
        (3,) * 8,
        (THREE_FIRST, *[THREE] * 6, THREE_LAST),
        (7, (-1, 14)),
    ),
    Claim(
        id="gallier.8.3.case_4.all",
        place="section 8.3, case 4, for K sequences",
        statement="K sequences of three points give 15, 14, ..., 14, 15 on the diagonal, and -1 beside it.",
        verdict=Verdict.BOUND,
        domain="K >= 2; one sequence alone has both end conditions, and 8 d_1 = -2 x_0 + 12 x_1 - 2 x_2",
        form=_rule(),
        cases=lambda: [(3,) * count for count in range(2, 7)],
        outside=lambda: ((3,),),
        deviation=_wrong_by_rule,
        copies=(Copy("15 for 14", _rule(three=(-1, 15, -1))),),
    ),
    Claim(
        id="gallier.8.3.dominant",
        place="section 8.3, 'Such matrices are row diagonally dominant'",
        statement="The matrices with sequences of three points anywhere are row diagonally dominant and regular.",
        verdict=Verdict.CONFIRMED,
        form=_rule(),
        cases=_lists(3, 4, 5),
        deviation=_not_dominant,
        copies=(Copy("2 for 14", _rule(three=(-1, 2, -1))),),
    ),
    Claim(
        id="gallier.8.matrices_of_all_lists",
        place="section 8, all matrices",
        statement="For any list of two sequences or more, each of three points or more, the rows are those of the "
        "printed matrices by the kinds of their points.",
        verdict=Verdict.CONFIRMED,
        form=_rule(),
        cases=_lists(3, 4, 5),
        deviation=_wrong_by_rule,
        copies=(Copy("15 for 14", _rule(three=(-1, 15, -1))), Copy("14 for 15", _rule(before=(4, 14, -1)))),
        remark="`affinecert.fast.splines` solves them; a sequence of two points gets its middle as a third one.",
    ),
    Claim(
        id="gallier.8.3.figures_18_to_20",
        place="section 8.3, figures 18, 19 and 20",
        statement="Splices of 5 and 6, of 3, 4 and 5, and of 4, 3, 5 and 3 points go through all their data, and their "
        "first and second derivatives agree at inner points and at junctions.",
        verdict=Verdict.CONFIRMED,
        form=_spliced,
        cases=lambda: ((5, 6), (3, 4, 5), (4, 3, 5, 3)),
        deviation=_broken_spline,
        copies=(Copy("each sequence by itself", _each_alone),),
        remark="For any data, of which those of the figures are not printed.",
    ),
)
