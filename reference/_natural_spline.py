"""Natural cubic splines: piecewise cubic, twice differentiable, with second derivatives 0 at both ends."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from affinecert.errors import InputError
from affinecert.reference._matrices import Array, Number


def require_knots(knots: Array) -> None:
    """Refuse fewer than two knots, and knots that do not increase."""
    if len(knots) < 2:
        raise InputError("knots", "fewer than two")
    if any(b <= a for a, b in itertools.pairwise(knots)):
        raise InputError("knots", "not strictly increasing")


def natural_spline(knots: Array, values: Sequence[Array], t: Number) -> Array:
    """The natural cubic spline of those values, arrays, at the knots; outside of them the cubic of the nearest span.

    By its slopes m_i, for which the second derivatives on both sides of a knot agree, and vanish at the ends; on each
    span it is Hermite's cubic.
    """
    widths = [b - a for a, b in itertools.pairwise(knots)]
    slopes = _slopes(widths, [(b - a) / h for a, b, h in zip(values[:-1], values[1:], widths, strict=True)])
    i = max(0, sum(1 for knot in knots[1:-1] if knot <= t))
    h = widths[i]
    s, r = (t - knots[i]) / h, (knots[i + 1] - t) / h
    result: Array = values[i] * (r * r * (1 + 2 * s)) + values[i + 1] * (s * s * (1 + 2 * r))
    return result + (slopes[i] * r - slopes[i + 1] * s) * (h * s * r)


def _slopes(widths: Sequence[Number], secants: Sequence[Array]) -> list[Array]:
    """The slopes at the knots, from the widths of the spans and the slopes of the chords."""
    last = len(widths)
    # Rows (below, diagonal, above, right), from the second derivative at the first knot to that at the last.
    rows = [(0, 2, 1, secants[0] * 3)]
    for i in range(1, last):
        g, h = widths[i - 1], widths[i]
        rows.append((h, 2 * (g + h), g, (secants[i - 1] * h + secants[i] * g) * 3))
    rows.append((1, 2, 0, secants[-1] * 3))
    # Gauss' elimination, downwards and back; the matrix is diagonally dominant.
    above, right = [rows[0][2] / rows[0][1] if last else 0], [rows[0][3] / rows[0][1]]
    for below, diagonal, next_one, known in rows[1:]:
        pivot = diagonal - below * above[-1]
        above.append(next_one / pivot)
        right.append((known - right[-1] * below) / pivot)
    slopes = [right[-1]]
    for factor, known in zip(above[-2::-1], right[-2::-1], strict=True):
        slopes.insert(0, known - slopes[0] * factor)
    return slopes
