"""Spliced cubic splines through points, and through similarities of space by their logarithms.

Points come in segments, one after the other; the lengths are their numbers of points, 2 or more. The curve may jump
from the last point of a segment to the first one of the next, but its first and second derivatives do not. The knots
are the whole numbers: a segment of M + 1 points takes the time M, and the next one starts when it ends. A segment of
two points gets their average as a third, and takes the time 2. Everything is computed in double-double arithmetic and
rounded once.

Source: Gallier, Allen-Blanchette, Leonardos, "Motion interpolation in SIM(3)", sections 5, 6 and 8.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array, Shape, checked
from affinecert.fast._splicing import Cubic, Legs, Mask, Place, cubic_at, halves, kept, pick, place, spliced
from affinecert.fast._stages import require
from affinecert.fast._wide_rotation import PI, ROUNDING
from affinecert.fast._wide_similarity import (
    axis_angle,
    dot,
    exponential,
    logarithms,
    multiple,
    turned_back,
    turned_back_curve,
)

POINTS: dict[str, Shape] = {"points": ("points", "dims"), "lengths": ("segments",)}
POSES: dict[str, Shape] = {"poses": ("keys", 4, 4)}
TIME: dict[str, Shape] = {"t": ()}

THREE = np.array([3.0, 0.0])

NO_LENGTHS = "not whole numbers from 2 on"
OTHER_SUM = "their sum is not the number of points"
RAGGED = "segments of two points are more in one item of the batch than in another"


def de_boor(points: ArrayLike, lengths: ArrayLike) -> Array:
    """The de Boor points of the spliced spline through points, whose second derivative is 0 at both ends (section 8).

    points (..., points, dims) and lengths (..., segments); gives (..., controls, dims): for the points x_0, ..., x_M of
    a segment d_0, ..., d_M, the first and the last of which are the Bezier points next to x_0 and x_M. A segment of two
    points has three of them, so that the items of a batch must have equally many such segments. Raises InputError for
    a wrong shape or dtype, numbers that are not finite, and lengths that are no whole numbers from 2 on or whose sum is
    not the number of points.

    >>> de_boor([[0.0], [1.0], [0.0]], [3])[:, 0]
    array([0.5, 1.5, 0.5])
    """
    (places, numbers), _, sizes = checked(POINTS, (points, lengths))
    legs = _legs(places, numbers)
    first, second = halves(legs)
    third = wide.divide(legs.arriving, THREE)
    alone, closes = legs.alone[..., None, None], legs.closes[..., None, None]
    inner = _inner(Cubic(*(np.where(alone, b, a) for a, b in zip(first, second, strict=True))))
    rows = (
        wide.add(legs.start, wide.divide(legs.leaving, THREE)),
        _inner(first),
        np.where(closes, wide.subtract(legs.end, third), inner),
    )
    keep = np.stack([legs.opens, legs.alone, np.ones_like(legs.alone)], axis=-1)
    return wide.rounded(_in_order(np.stack(rows, axis=-3), keep, sizes["points"], 2))


def bezier_points(points: ArrayLike, lengths: ArrayLike) -> Array:
    """The Bezier points of the spliced spline on each span from knot to knot.

    points (..., points, dims) and lengths (..., segments); gives (..., spans, 4, dims). Raises InputError as `de_boor`.
    """
    legs = _legs(*checked(POINTS, (points, lengths))[0])
    spans = np.stack([_polygon(cubic) for cubic in halves(legs)], axis=-4)
    keep = np.stack([np.ones_like(legs.alone), legs.alone], axis=-1)
    return wide.rounded(_in_order(spans, keep, legs.opens.shape[-1], 3))


def evaluate(points: ArrayLike, lengths: ArrayLike, t: ArrayLike) -> Array:
    """The spliced spline at the time t.

    points (..., points, dims), lengths (..., segments) and t (...), any number; gives (..., dims): at a junction the
    first point of the later segment. Before the first and after the last knot the cubics there go on. Raises InputError
    as `de_boor` does, except that the items of a batch need not have equally many segments of two points.

    >>> evaluate([[0.0], [1.0], [5.0], [6.0]], [2, 2], [0.0, 1.5, 2.0, 4.0])[:, 0]
    array([0.  , 0.75, 5.  , 6.  ])
    """
    (places, numbers, time), _, _ = checked(POINTS | TIME, (points, lengths, t))
    legs = _legs(places, numbers)
    at = place(legs, time)
    return wide.rounded(cubic_at(legs, at).at(at.s))


def select_logarithms(poses: ArrayLike) -> tuple[Array, Array]:
    """The logarithms (omega, v, lambda) of similarities for a spline, by strategy 1 of section 5.

    poses (keys, 4, 4), one sequence, since the number of points depends on it; gives points (points, 7) and lengths
    (segments,). With X_i the principal logarithm of pose i, Y_(i+1) is that of the next pose whose rotation vector is
    nearest to that of X_i: the principal one w, also in a tie, or -(2 pi - |w|) w / |w|. A segment ends with Y_i where
    it is not X_i, and the next one starts with X_i. Raises InputError for a wrong shape or dtype, fewer than two poses,
    numbers that are not finite, and a pose that is no similarity to within 1e-6.
    """
    (matrices,), (batch,), _ = checked(POSES, (poses,))
    if batch:
        raise InputError("poses", f"shape {matrices.shape} where (keys, 4, 4) is due")
    legs = _selected(matrices)
    ends = np.stack([legs.start, legs.end], axis=-3)
    keep = np.stack([legs.opens, np.ones_like(legs.opens)], axis=-1)
    counts = np.diff([*np.flatnonzero(legs.opens), len(legs.opens)])
    return wide.rounded(_in_order(ends, keep, len(matrices), 2)), counts + 1.0


def key_times(poses: ArrayLike) -> Array:
    """The times at which `motion` and `smooth_motion` pass through the poses.

    poses (..., keys, 4, 4); gives (..., keys), from 0 on: 1 apart, or 2 where the logarithms of two poses make a
    segment of their own. Raises InputError as `motion` does.
    """
    knots = _selected(checked(POSES, (poses,))[0][0]).knots
    return np.concatenate([np.zeros_like(knots[..., :1]), knots], axis=-1)


def motion(poses: ArrayLike, t: ArrayLike) -> Array:
    """The motion e^c(t) through similarities, c the spliced spline through their `select_logarithms` (section 5).

    poses (..., keys, 4, 4) and t (...), any number; gives (..., 4, 4), which are the poses at `key_times`. It is
    continuous, but at a junction not C^2, as section 5 says, nor C^1, unless it is a screw motion about one axis there.
    In the example of section 7, four poses, the origin comes to the junction with the velocity (-4.07, -5.82, 2.45) and
    leaves it with (-3.89, -0.79, 0.40). `smooth_motion` mends that. Scales and translations may be between 1e-140 and
    1e140. Raises InputError for a wrong shape or dtype, fewer than two poses, numbers that are not finite, and a pose
    that is no similarity to within 1e-6.
    """
    return _moved(poses, t, _selected, _spliced)


def smooth_motion(poses: ArrayLike, t: ArrayLike) -> Array:
    """The motion e^c(t) through similarities whose velocity and acceleration on the group are continuous.

    poses (..., keys, 4, 4) and t (...), any number; gives (..., 4, 4), which are the poses at `key_times`. At a
    junction c jumps from one logarithm Y of a pose to another one, X. That c' and c'' do not is not what makes e^c
    smooth, for the derivative of the exponential is not the same at X and at Y. The curve must go on as phi(c) does,
    where phi takes a logarithm of any similarity next to Y to the one next to X, so that e^phi(c) = e^c. So here c is
    the spliced spline, but for the first span after each junction: there a quintic takes its place, which starts with
    the derivatives of phi(c), and ends with the value and the derivatives of the spline. Where there is no junction, or
    a screw motion through it, nothing changes. Raises InputError as `motion` does.
    """
    return _moved(poses, t, _selected, _smoothed)


def principal_motion(poses: ArrayLike, t: ArrayLike) -> Array:
    """The motion e^c(t), c the one cubic spline through the principal logarithms: the long way round through pi.

    poses (..., keys, 4, 4) and t (...), any number; gives (..., 4, 4). What figure 7 warns of. Raises InputError as
    `motion` does.
    """
    return _moved(poses, t, _principal, _spliced)


def _legs(points: Array, lengths: Array) -> Legs:
    """The legs between the points of segments; refuses bad lengths."""
    count, segments = points.shape[-2], lengths.shape[-1]
    whole = ((lengths >= 2.0) & (lengths == np.rint(lengths))).all(axis=-1) & (segments > 0)
    require("lengths", whole, NO_LENGTHS)
    require("lengths", lengths.sum(axis=-1) == count, OTHER_SUM)
    ends = np.cumsum(lengths, axis=-1)[..., None] - 1.0
    last = (ends == np.arange(count)).any(axis=-2)
    first = np.concatenate([np.ones_like(last[..., :1]), last[..., :-1]], axis=-1)
    legs = count - segments
    start, end = kept(points, ~last, legs, 1), kept(points, ~first, legs, 1)
    return spliced(wide.widen(start), wide.widen(end), kept(first, ~last, legs))


def _in_order(rows: Array, keep: Mask, least: int, behind: int) -> Array:
    """The rows to be kept of all legs, (..., legs, rows) with some axes behind: at least so many in each item."""
    counts = keep.sum(axis=(-2, -1))
    count = int(counts.max(initial=least))
    require("lengths", counts == count, RAGGED)
    axis = rows.ndim - behind - 2
    flat = rows.reshape(*rows.shape[:axis], rows.shape[axis] * rows.shape[axis + 1], *rows.shape[axis + 2 :])
    return kept(flat, keep.reshape(*keep.shape[:-2], keep.shape[-2] * keep.shape[-1]), count, behind)


def _inner(cubic: Cubic) -> Array:
    """The de Boor point of the inner knot at which a cubic ends: its value less a sixth of its second derivative."""
    return wide.subtract(cubic.end, wide.add(wide.divide(cubic.square, THREE), cubic.cube))


def _polygon(cubic: Cubic) -> Array:
    """The four Bezier points of a cubic, (..., 4, dims, 2)."""
    second = wide.add(cubic.constant, wide.divide(cubic.linear, THREE))
    third = wide.add(second, wide.divide(wide.add(cubic.linear, cubic.square), THREE))
    return np.stack([cubic.constant, second, third, cubic.end], axis=-3)


def _selected(poses: Array) -> Legs:
    """The legs between the logarithms of strategy 1."""
    logs = _logarithms(poses)
    here, there = logs[..., :-1, :, :], logs[..., 1:, :, :]
    axis, angle = axis_angle(there[..., :3, :])
    # The middle of the two rotation vectors is at the angle |w| - pi from 0, along w.
    beyond = wide.subtract(wide.subtract(angle, PI), dot(axis, here[..., :3, :]))[..., 0]
    jumps = beyond > ROUNDING
    end = there.copy()
    if jumps.any():
        end[jumps] = turned_back(there[jumps])
    opens = np.concatenate([np.ones_like(jumps[..., :1]), jumps[..., :-1]], axis=-1)
    return spliced(here, end, opens)


def _principal(poses: Array) -> Legs:
    """The legs between the principal logarithms, in one segment."""
    logs = _logarithms(poses)
    opens = np.broadcast_to(np.arange(logs.shape[-3] - 1) == 0, (*logs.shape[:-3], logs.shape[-3] - 1))
    return spliced(logs[..., :-1, :, :], logs[..., 1:, :, :], opens)


def _logarithms(poses: Array) -> Array:
    if poses.shape[-3] < 2:
        raise InputError("poses", f"shape {poses.shape}: two or more are due")
    return logarithms("poses", poses)


def _moved(
    poses: ArrayLike, t: ArrayLike, select: Callable[[Array], Legs], curve: Callable[[Legs, Place], Array]
) -> Array:
    (matrices, time), _, _ = checked(POSES | TIME, (poses, t))
    legs = select(matrices)
    return wide.rounded(exponential(curve(legs, place(legs, time))))


def _spliced(legs: Legs, at: Place) -> Array:
    return cubic_at(legs, at).at(at.s)


def _smoothed(legs: Legs, at: Place) -> Array:
    """The spliced spline with (1 - s)^3 (s p + s^2 (3 p + q)) added on the first span after each junction.

    That has the value 0, the derivative p and half the second derivative q at s = 0, and three zeros at s = 1.
    """
    cubic = cubic_at(legs, at)
    value = cubic.at(at.s)
    behind = pick(legs.opens, at.leg) & (at.leg > 0) & ~at.second
    if not behind.any():
        return value
    before = pick(legs.end, np.maximum(at.leg - 1, 0), 2)[behind]
    slope, half, s = cubic.linear[behind], cubic.square[behind], at.s[behind]
    _, due, due_twice = turned_back_curve((before, slope, 2.0 * half))
    p, q = wide.subtract(due, slope), wide.subtract(0.5 * due_twice, half)
    rest = wide.subtract(np.array([1.0, 0.0]), s)
    factor = wide.multiply(s, wide.multiply(rest, wide.multiply(rest, rest)))
    inner = wide.add(p, multiple(s, wide.add(wide.times(p, 3.0), q)))
    value[behind] = wide.add(value[behind], multiple(factor, inner))
    return value
