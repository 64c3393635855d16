"""Sections 5 and 6: the average of two points, and the points of the cubics."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, mp, size
from affinecert.reference._matrices import Array, Number, array


def _polygons() -> list[tuple[Array, Number]]:
    return [(polygon, mp.mpf(k + 1) / 5) for k, polygon in enumerate(arrays("polygons", 4, (4, 7), -3, 3))]


def _subdivided(polygon: Array, t: Number, last: Number | None = None) -> list[Array]:
    """De Casteljau's scheme, level by level; the last level with another number if so said."""
    levels = [polygon]
    for level in range(3):
        s = t if last is None or level < 2 else last
        levels.append((1 - s) * levels[-1][:-1] + s * levels[-1][1:])
    return levels


def _de_casteljau(polygon: Array, t: Number) -> Array:
    point: Array = _subdivided(polygon, t)[3][0]
    return point


def _bernstein(polygon: Array, t: Number) -> Array:
    a, b, c, d = polygon
    point: Array = a * (1 - t) ** 3 + 3 * b * t * (1 - t) ** 2 + 3 * c * t**2 * (1 - t) + d * t**3
    return point


def _polygon_misses(form: Any, case: tuple[Array, Number]) -> Number:
    return difference(form(*case), _bernstein(*case))


def _halves(polygon: Array) -> list[Array]:
    """The control polygons of both halves."""
    levels = _subdivided(polygon, mp.mpf(1) / 2)
    return [array([level[0] for level in levels]), array([level[-1] for level in reversed(levels)])]


def _bend(polygon: Array) -> Number:
    """The largest second difference of a polygon, which bounds how far it is from its curve."""
    return size(polygon[:-2] - 2 * polygon[1:-1] + polygon[2:])


def _far(form: Number, case: tuple[Array, Number]) -> Number:
    """By how much more than the factor given the polygons of the halves are bent."""
    polygon, _ = case
    return max(max(map(_bend, _halves(polygon))) - form * _bend(polygon), mp.zero)


def _conditions(lengths: tuple[int, ...]) -> Any:
    """The conditions on the coefficients of cubics, rows of numbers, with no point inserted in segments of two.

    Values at both ends of each span, continuous derivatives from span to span, and natural ends.
    """
    count = sum(length - 1 for length in lengths)
    place = np.eye(4 * count).reshape(4 * count, count, 4)
    coefficients = place.transpose(1, 2, 0)
    rows: list[Any] = []
    for span, (a, b, c, d) in enumerate(coefficients):
        rows += [a, a + b + c + d]
        if span:
            _, b0, c0, d0 = coefficients[span - 1]
            rows += [b0 + 2 * c0 + 3 * d0 - b, 2 * c0 + 6 * d0 - 2 * c]
    first, last = coefficients[0], coefficients[-1]
    return np.array([*rows, 2 * first[2], 2 * last[2] + 6 * last[3]])


def _solvable_misses(form: Any, lengths: tuple[int, ...]) -> int:
    """Whether it is told wrongly that the conditions on a spline have one solution."""
    conditions = _conditions(lengths)
    rank = np.linalg.matrix_rank(conditions)
    return int(form(lengths) != bool(rank == len(conditions) == conditions.shape[1]))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.5.average",
        place="section 5 and section 6",
        statement="A sequence of two logarithms needs a third point, their average, to be interpolated by a spline.",
        printed="in order to be able to do spline interpolation, we insert the average of X_i and Y_{i+1} as a third "
        "data point",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=lambda lengths: 2 not in lengths,
        cases=lambda: [(3,), (4, 3), (2,), (2, 3), (3, 2, 2)],
        deviation=_solvable_misses,
        correction=Correction(
            statement="The conditions determine the spline without it: one cubic between the two points, with both "
            "derivatives continuous at its junctions.",
            form=lambda lengths: True,
        ),
        copies=(Copy("a sequence of two by itself only", lambda lengths: 2 not in lengths or lengths == (2,)),),
        remark="The de Boor points of section 8, one for each data point and spans of three kinds, do need it. With it "
        "the way between the two poses takes the time 2.",
    ),
    Claim(
        id="gallier.6.de_casteljau",
        place="section 6, the third stage",
        statement="Points of the cubics can be had by Bernstein polynomials or by de Casteljau's algorithm in R^7.",
        verdict=Verdict.CONFIRMED,
        form=_de_casteljau,
        cases=_polygons,
        deviation=_polygon_misses,
        copies=(Copy("1-t for t in the last step", lambda polygon, t: _subdivided(polygon, t, 1 - t)[3][0]),),
    ),
    Claim(
        id="gallier.6.close",
        place="section 6, the third stage",
        statement="The intermediate control points are close to the curve: halving a cubic makes the second "
        "differences of its control polygons a quarter at most.",
        verdict=Verdict.CONFIRMED,
        form=mp.mpf(1) / 4,
        cases=_polygons,
        deviation=_far,
        copies=(Copy("a fifth", mp.mpf(1) / 5),),
        remark="The factor is ours. The points are in R^7: it is their exponentials that are close to the motion.",
    ),
    Claim(
        id="gallier.6.faster",
        place="section 6, the third stage",
        statement="De Casteljau's algorithm with its intermediate points appears to be faster than Bernstein "
        "polynomials.",
        verdict=Verdict.UNCHECKABLE,
        reason="a statement on the time that their programs took, without numbers",
    ),
)
