"""Spliced cubic splines as one natural spline: a jump from segment to segment leaves all derivatives as they are.

Moved so that each segment starts where the one before it ends, the segments make an ordinary cubic spline, whose second
derivatives are continuous and 0 at both ends. It is found by its slopes m at the knots. With D the way of a span,

    2 m_0 + m_1 = 3 D_0,    m_(k-1) + 4 m_k + m_(k+1) = 3 (D_(k-1) + D_k),    m_(n-1) + 2 m_n = 3 D_(n-1):

each span adds its 2 m + m' = 3 D to the equations of its two knots. A leg leads from one given point to the next one of
a segment. It is a span, or two where it is a segment of its own, by way of the average; the slope in the middle is
(3 D - m - m') / 4, D now the way of the leg, and what such a leg adds is 7/4 m - 1/4 m' = 3/4 D.
"""

from __future__ import annotations

from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array

Mask = NDArray[np.bool_]

T = TypeVar("T", bound=np.generic)


class Legs(NamedTuple):
    """The legs of segments: pairs at their start and at their end, (..., legs, dims, 2), and which open a segment.

    Also the slopes at the start and at the end of each leg.
    """

    start: Array
    end: Array
    opens: Mask
    leaving: Array
    arriving: Array

    @property
    def closes(self) -> Mask:
        """Which legs end a segment, (..., legs)."""
        return _closing(self.opens)

    @property
    def alone(self) -> Mask:
        """Which legs are segments of their own, and take the time 2."""
        return np.asarray(self.opens & self.closes)

    @property
    def knots(self) -> Array:
        """The times at which the legs end, (..., legs)."""
        return np.cumsum(1.0 + self.alone, axis=-1)


class Cubic(NamedTuple):
    """A cubic on a span, the coefficients of powers of the time since its start, each (..., dims, 2)."""

    constant: Array
    linear: Array
    square: Array
    cube: Array

    @property
    def end(self) -> Array:
        """The value at the end of the span."""
        return wide.add(wide.add(self.constant, self.linear), wide.add(self.square, self.cube))

    def at(self, s: Array) -> Array:
        """The value at pairs s (..., 2)."""
        time = s[..., None, :]
        value = wide.add(self.square, wide.multiply(self.cube, time))
        value = wide.add(self.linear, wide.multiply(value, time))
        return wide.add(self.constant, wide.multiply(value, time))


def spliced(start: Array, end: Array, opens: Mask) -> Legs:
    """The legs with the slopes of the spliced spline."""
    slopes = _slopes(wide.subtract(end, start), np.asarray(opens & _closing(opens)))
    return Legs(start, end, opens, slopes[..., :-1, :, :], slopes[..., 1:, :, :])


def _closing(opens: Mask) -> Mask:
    """Which legs end a segment: those before one that opens one, and the last."""
    return np.concatenate([opens[..., 1:], np.ones_like(opens[..., :1])], axis=-1)


def _slopes(ways: Array, alone: Mask) -> Array:
    """The slopes at the knots between legs, by elimination from the first to the last; no pivot is below 3/2."""
    own, other = np.where(alone, 1.75, 2.0), np.where(alone, -0.25, 1.0)
    loads = wide.times(ways, np.where(alone, 0.75, 3.0)[..., None])
    nothing = np.zeros_like(own[..., :1])
    diagonal = np.concatenate([own, nothing], axis=-1) + np.concatenate([nothing, own], axis=-1)
    none = np.zeros_like(loads[..., :1, :, :])
    right = wide.add(np.concatenate([loads, none], axis=-3), np.concatenate([none, loads], axis=-3))
    pivots, rows = [wide.widen(diagonal[..., 0])], [right[..., 0, :, :]]
    for k in range(other.shape[-1]):
        beside = wide.widen(other[..., k])
        factor = wide.divide(beside, pivots[-1])
        pivots.append(wide.subtract(wide.widen(diagonal[..., k + 1]), wide.multiply(factor, beside)))
        rows.append(wide.subtract(right[..., k + 1, :, :], wide.multiply(rows[-1], factor[..., None, :])))
    slopes = [wide.divide(rows[-1], pivots[-1][..., None, :])]
    for k in range(other.shape[-1] - 1, -1, -1):
        rest = wide.subtract(rows[k], wide.times(slopes[-1], other[..., k, None]))
        slopes.append(wide.divide(rest, pivots[k][..., None, :]))
    return np.stack(slopes[::-1], axis=-3)


def halves(legs: Legs) -> tuple[Cubic, Cubic]:
    """The cubics on the first and, of those that have one, on the second span of the legs, (..., legs, dims, 2)."""
    way = wide.subtract(legs.end, legs.start)
    middle = 0.25 * wide.subtract(wide.times(way, 3.0), wide.add(legs.leaving, legs.arriving))
    half = 0.5 * way
    alone = legs.alone[..., None, None]
    first = _cubic(legs.start, np.where(alone, half, way), legs.leaving, np.where(alone, middle, legs.arriving))
    return first, _cubic(wide.add(legs.start, half), half, middle, legs.arriving)


def _cubic(start: Array, way: Array, leaving: Array, arriving: Array) -> Cubic:
    """The cubic with a given start, way and slopes at both ends."""
    both = wide.add(leaving, arriving)
    square = wide.subtract(wide.times(way, 3.0), wide.add(leaving, both))
    return Cubic(start, leaving, square, wide.subtract(both, 2.0 * way))


class Place(NamedTuple):
    """Where times lie: the leg, whether in its second half, and the time since that span's start, as a pair."""

    leg: NDArray[np.int64]
    second: Mask
    s: Array


def place(legs: Legs, t: Array) -> Place:
    """The places of times (...); at a knot the later span."""
    knots, alone = legs.knots, legs.alone
    leg = np.asarray((knots[..., :-1] <= t[..., None]).sum(axis=-1))
    began = pick(np.concatenate([np.zeros_like(knots[..., :1]), knots], axis=-1), leg)
    second = pick(alone, leg) & (t - began >= 1.0)
    return Place(leg, second, wide.subtract(wide.widen(t), wide.widen(began + second)))


def pick(items: NDArray[T], leg: NDArray[np.int64], behind: int = 0) -> NDArray[T]:
    """The items of single legs, of an array (..., legs) with so many axes behind."""
    axis = items.ndim - behind - 1
    batch = np.broadcast_shapes(items.shape[:axis], leg.shape)
    index = np.broadcast_to(leg, batch).reshape(*batch, *[1] * (behind + 1))
    spread = np.broadcast_to(items, (*batch, *items.shape[axis:]))
    return np.take_along_axis(spread, index, axis=len(batch)).squeeze(len(batch))


def kept(items: NDArray[T], keep: Mask, count: int, behind: int = 0) -> NDArray[T]:
    """The so many items to be kept of an array (..., items) with some axes behind."""
    order = np.argsort(~keep, axis=-1, kind="stable")[..., :count]
    axis = items.ndim - behind - 1
    batch = np.broadcast_shapes(items.shape[:axis], keep.shape[:-1])
    index = np.broadcast_to(order, (*batch, count)).reshape(*batch, count, *[1] * behind)
    return np.take_along_axis(np.broadcast_to(items, (*batch, *items.shape[axis:])), index, axis=len(batch))


def cubic_at(legs: Legs, at: Place) -> Cubic:
    """The cubics on the spans where times lie."""
    pairs = zip(*halves(legs), strict=True)
    second = at.second[..., None, None]
    return Cubic(*(np.where(second, pick(b, at.leg, 2), pick(a, at.leg, 2)) for a, b in pairs))
