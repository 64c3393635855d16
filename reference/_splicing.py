"""The spliced cubic splines as exact weights of their data: the conditions on them, solved in rational numbers.

A spliced spline interpolates several sequences of points, its segments, one after the other, with knots at the whole
numbers. It may jump from the last point of a segment to the first one of the next, but its first and second
derivatives do not. Its second derivative is zero at both ends. All of it is linear in the points, and depends on
nothing else but the numbers of points of the segments. Source: Gallier, Allen-Blanchette, Leonardos, Motion
interpolation in SIM(3), section 8.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.object_]
"""Rational linear combinations, one in each row."""

Span = tuple[Rows, Rows, Rows, Rows]
"""The four Bezier points between two knots, each a row."""


class System(NamedTuple):
    """The equations ``unknown`` d = ``known`` x on the de Boor points d of a spline through the points x."""

    unknown: Rows
    known: Rows


class Weights(NamedTuple):
    """What each point of a spline counts for in its de Boor points, (controls, points), and Bezier points of each span.

    The latter are (spans, 4, points).
    """

    de_boor: Rows
    bezier: Rows


def spans(d: Rows, x: Rows) -> list[Span]:
    """The Bezier points of a segment with de Boor points d_0, ..., d_M and data points x_0, ..., x_M, M >= 2.

    Figures 14 and 15: the polygon of the de Boor points has corners at the inner ones only, and each inner side of it
    is divided in three; the first and the last one, which belong to spans at an end, in two.
    """
    last = len(x) - 2
    return [
        (
            x[i],
            d[0] if i == 0 else (d[i] + d[i + 1]) / 2 if i == last else (2 * d[i] + d[i + 1]) / 3,
            d[last + 1] if i == last else (d[i] + d[i + 1]) / 2 if i == 0 else (d[i] + 2 * d[i + 1]) / 3,
            x[i + 1],
        )
        for i in range(last + 1)
    ]


def _velocity_at_end(span: Span) -> Rows:
    """The derivative at the end of a span, over 3."""
    velocity: Rows = span[3] - span[2]
    return velocity


def _velocity_at_start(span: Span) -> Rows:
    velocity: Rows = span[1] - span[0]
    return velocity


def _acceleration_at_end(span: Span) -> Rows:
    """The second derivative at the end of a span, over 6."""
    acceleration: Rows = span[1] - 2 * span[2] + span[3]
    return acceleration


def _acceleration_at_start(span: Span) -> Rows:
    acceleration: Rows = span[0] - 2 * span[1] + span[2]
    return acceleration


def _segments(lengths: Sequence[int], rows: Rows) -> list[Rows]:
    return np.split(rows, np.cumsum(lengths)[:-1])


def system(lengths: Sequence[int]) -> System:
    """The conditions on the de Boor points of segments of these numbers of points, each 3 or more, in their order.

    A segment's de Boor points make its second derivative continuous by themselves; left to ask is that the first one
    is continuous at each inner knot, both at each junction, and that the second one is zero at both ends.
    """
    count = sum(lengths)
    symbols = np.array(Fraction(1) * np.eye(2 * count, dtype=int).astype(object))
    pieces = zip(_segments(lengths, symbols[:count]), _segments(lengths, symbols[count:]), strict=True)
    curves = [spans(d, x) for d, x in pieces]
    conditions = [_acceleration_at_start(curves[0][0])]
    for number, curve in enumerate(curves):
        if number:
            before, after = curves[number - 1][-1], curve[0]
            conditions.append(_velocity_at_end(before) - _velocity_at_start(after))
            conditions.append(_acceleration_at_end(before) - _acceleration_at_start(after))
        conditions += [_velocity_at_end(first) - _velocity_at_start(second) for first, second in pairwise(curve)]
    conditions.append(_acceleration_at_end(curves[-1][-1]))
    rows = np.array(conditions)
    return System(rows[:, :count], -rows[:, count:])


@lru_cache(maxsize=256)
def weights(lengths: tuple[int, ...]) -> Weights:
    """The weights for segments of these numbers of points; of a segment of two the average is inserted as its third."""
    given = np.array(Fraction(1) * np.eye(sum(lengths), dtype=int).astype(object))
    data = np.concatenate([_with_average(rows) for rows in _segments(lengths, given)])
    full = completed(lengths)
    conditions = system(full)
    de_boor = _solved(conditions.unknown, conditions.known @ data)
    pieces = zip(_segments(full, de_boor), _segments(full, data), strict=True)
    return Weights(de_boor, np.array([span for d, x in pieces for span in spans(d, x)]))


def completed(lengths: Sequence[int]) -> tuple[int, ...]:
    """The numbers of points with the averages inserted."""
    return tuple(max(length, 3) for length in lengths)


def _with_average(rows: Rows) -> Rows:
    return np.array([rows[0], (rows[0] + rows[1]) / 2, rows[1]]) if len(rows) == 2 else rows


def _solved(matrix: Rows, right: Rows) -> Rows:
    """The solution of linear equations by Gauss and Jordan; rational numbers need no pivot but one that is not zero."""
    size = len(matrix)
    rows = np.concatenate([matrix, right], axis=1)
    for i in range(size):
        pivot = next(k for k in range(i, size) if rows[k, i])
        rows[[i, pivot]] = rows[[pivot, i]]
        rows[i] = rows[i] / rows[i, i]
        for k in range(size):
            if k != i and rows[k, i]:
                rows[k] = rows[k] - rows[k, i] * rows[i]
    return rows[:, size:]
