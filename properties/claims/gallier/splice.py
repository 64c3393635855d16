"""What the equations of section 8 are held against: the conditions on a spliced spline, in rational numbers.

An equation between de Boor points and data points is text, as printed: "7/2 f_1 + f_2 = 6 y_1 - 3/2 f_0", several of
them with semicolons between. The points of the first three segments are d, f, g and x, y, z; those of the k-th
segment, counted from 1, are d^k and x^k too. M stands for the last index of a segment, N too. An equation is true if it
follows from the conditions that define the spline.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.precision import size
from affinecert.reference._splicing import Rows, system

Lengths = tuple[int, ...]
"""The numbers of data points of the segments, M + 1 for each."""

_TERM = re.compile(
    r"(?P<sign>[+-]?)\s*(?P<factor>\d+(?:/\d+)?)?\s*"
    r"(?:\((?P<group>[^()]*)\)|(?P<letter>[dfgxyz])(?:\^(?P<segment>\d+))?_\{?(?P<index>\d+|[MN](?:-\d)?)\}?)"
)


def symbols(lengths: Lengths) -> tuple[list[Rows], list[Rows]]:
    """The rows that stand for the de Boor points and for the data points, segment by segment."""
    count = sum(lengths)
    units = np.array(Fraction(1) * np.eye(2 * count, dtype=int).astype(object))
    places = np.cumsum(lengths)[:-1]
    return np.split(units[:count], places), np.split(units[count:], places)


def combination(text: str, lengths: Lengths) -> Rows:
    """The row of a linear combination of points, written out."""
    d, x = symbols(lengths)
    total: Rows = np.zeros(2 * sum(lengths), dtype=object) + Fraction(0)
    end = 0
    for term in _TERM.finditer(text):
        if text[end : term.start()].strip():
            break
        end = term.end()
        factor = Fraction(term["factor"] or 1)
        if term["group"]:
            row = combination(term["group"], lengths)
        else:
            points = d if term["letter"] in "dfg" else x
            segment = points[int(term["segment"]) - 1 if term["segment"] else "dfgxyz".index(term["letter"]) % 3]
            index = term["index"]
            row = segment[len(segment) - 1 + int(index[1:] or 0) if index[0] in "MN" else int(index)]
        total = total + (-factor if term["sign"] == "-" else factor) * row
    if text[end:].strip():
        raise ValueError(f"{text!r} is no linear combination from {text[end:]!r} on")
    return total


def _claimed(equations: str, lengths: Lengths) -> Rows:
    """Left less right sides, a row an equation."""
    sides = (equation.split("=") for equation in equations.split(";"))
    return np.array([combination(left, lengths) - combination(right, lengths) for left, right in sides])


@cache
def _conditions(lengths: Lengths, natural: bool) -> tuple[Rows, tuple[int, ...]]:
    """The conditions of continuity, and those at both ends if ``natural``, reduced; and the columns of their pivots."""
    unknown, known = system(lengths)
    rows = np.concatenate([unknown, -known], axis=1)
    return _reduced(rows if natural else rows[1:-1])


def _reduced(rows: Rows) -> tuple[Rows, tuple[int, ...]]:
    rows = rows.copy()
    pivots: list[int] = []
    for column in range(rows.shape[1]):
        done = len(pivots)
        found = next((k for k in range(done, len(rows)) if rows[k, column]), None)
        if found is None:
            continue
        rows[[done, found]] = rows[[found, done]]
        rows[done] = rows[done] / rows[done, column]
        for k in range(len(rows)):
            if k != done and rows[k, column]:
                rows[k] = rows[k] - rows[k, column] * rows[done]
        pivots.append(column)
    return rows[: len(pivots)], tuple(pivots)


def _rest(equations: str, lengths: Lengths, *, natural: bool) -> float:
    rows, pivots = _conditions(lengths, natural)
    claimed = _claimed(equations, lengths)
    for row, pivot in zip(rows, pivots, strict=True):
        claimed = claimed - claimed[:, [pivot]] * row
    return float(size(claimed))


def without_ends(equations: str, lengths: Lengths) -> float:
    """What the conditions of continuity leave of equations: the largest coefficient."""
    return _rest(equations, lengths, natural=False)


def with_ends(equations: str, lengths: Lengths) -> float:
    """What is left of equations when the second derivative vanishes at both ends as well."""
    return _rest(equations, lengths, natural=True)


def equation(
    *,
    section: str,
    name: str,
    place: str,
    statement: str,
    printed: str,
    changes: Sequence[tuple[str, str]],
    cases: Callable[[], Sequence[Lengths]],
    natural: bool = False,
    misprint: tuple[str, str] | None = None,
) -> Claim[str, Lengths]:
    """The claim that equations hold, at all ends or, if ``natural``, where the second derivative vanishes at both.

    In each perturbed copy the first occurrence of a text is replaced by another one. A ``misprint`` is
    what stands in the printed equations, and what has to stand there.
    """
    true = printed.replace(*misprint) if misprint else printed
    return Claim(
        id=f"gallier.{section}.{name}",
        place=f"section {section}, {place}",
        statement=statement,
        printed=printed,
        verdict=Verdict.REFUTED if misprint else Verdict.CONFIRMED,
        fault=Fault.SLIP if misprint else None,
        form=printed,
        cases=cases,
        deviation=with_ends if natural else without_ends,
        correction=Correction(statement=true, form=true) if misprint else None,
        copies=tuple(Copy(f"{new} for {old}", true.replace(old, new, 1)) for old, new in changes),
    )


@cache
def derived(lengths: Lengths) -> tuple[Rows, Rows]:
    """The equations that are left for the inner de Boor points, as coprime integers: left and right sides.

    Each says that the first derivative is continuous at an inner knot. The outer points d_0 and d_M of the segments are
    eliminated by the conditions at ends and junctions.
    """
    unknown, known = system(lengths)
    rows = np.concatenate([unknown, -known], axis=1)
    last = np.cumsum(lengths) - 1
    outer = sorted([*(last - np.array(lengths) + 1), *last])
    # The conditions stand in the order of their knots: those at ends and junctions where their outer points do.
    order = [*outer, *(k for k in range(rows.shape[1]) if k not in outer)]
    solved, pivots = _reduced(rows[outer][:, order])
    solved = solved[:, np.argsort(order)]
    rest = np.delete(rows, outer, axis=0)
    for row, pivot in zip(solved, pivots, strict=True):
        rest = rest - rest[:, [order[pivot]]] * row
    inner = [k for k in range(len(unknown)) if k not in outer]
    whole = np.array([_coprime(row, row[k]) for row, k in zip(rest, inner, strict=True)])
    return whole[:, inner], -whole[:, len(unknown) :]


def _coprime(row: Rows, positive: Fraction) -> Rows:
    """The multiple of a row that has coprime integers, the one given positive."""
    denominator = math.lcm(*(each.denominator for each in row))
    factor = Fraction(denominator, math.gcd(*(int(each * denominator) for each in row)))
    multiple: Rows = row * (factor if positive > 0 else -factor)
    return multiple
