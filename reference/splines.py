"""Spliced cubic splines through points, and through similarities by their logarithms.

The points come in segments, whose numbers of points are the lengths; the curve may jump from one segment to the next,
but its first and second derivatives do not. The knots are the whole numbers: a segment of M + 1 points takes the time
M, and the next one starts where it ends. A segment of two points gets their average as a third, and takes the time 2.
Source: Gallier, Allen-Blanchette, Leonardos, Motion interpolation in SIM(3), sections 5, 6 and 8.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from affinecert.errors import InputError
from affinecert.reference import _domain, sim3
from affinecert.reference._matrices import Array, Context, Number, array, cross, dot, norm
from affinecert.reference._precision import negligible
from affinecert.reference._splicing import Rows, completed, weights
from affinecert.reference._taylor import Taylor, multiple, product, quotient, square_root, total

# How close to a tie, in radians, a choice of logarithms is continued to the other side of it: far below what float64
# can tell from one, far above the steps by which truths are differentiated.
_TIE = 2.0**-80


def de_boor(ctx: Context, points: Array, lengths: Array) -> Array:
    """The de Boor points of the spliced spline, (points, dims), (segments,) -> (points, dims).

    Section 8: those of a segment with data points x_0, ..., x_M are d_0, ..., d_M, with d_0 and d_M next to its ends.
    A segment of two points has three of them. Raises InputError if the lengths are not whole numbers from 2 on whose
    sum is the number of points.
    """
    return _combined(ctx, _numbers(ctx, weights(_lengths(ctx, points, lengths)).de_boor), points)


def bezier_points(ctx: Context, points: Array, lengths: Array) -> Array:
    """The four Bezier points of the spliced spline on each span from knot to knot, (spans, 4, dims)."""
    spans = weights(_lengths(ctx, points, lengths)).bezier
    return array([_combined(ctx, _numbers(ctx, span), points) for span in spans])


def evaluate(ctx: Context, points: Array, lengths: Array, t: Array) -> Array:
    """The spliced spline at the time t, (points, dims), (segments,), () -> (dims,).

    At a junction it is the first point of the later segment; before the first and after the last knot the cubics there
    go on. Raises InputError as `de_boor` does.
    """
    _domain.finite(ctx, "t", t)
    return _spliced(ctx, points, _lengths(ctx, points, lengths), t[()])


def select_logarithms(ctx: Context, poses: Array) -> tuple[Array, Array]:
    """The logarithms of similarities by strategy 1, (keys, 4, 4) -> points (points, 7) and lengths (segments,).

    Section 5. With X_i the principal logarithm of pose i, Y_(i+1) is `sim3.log_next` of the next pose and X_i. A
    segment ends with Y_i where it is not X_i, and the next one starts with X_i. Raises InputError for fewer than two
    poses and as `sim3.log` does.
    """
    points, lengths = _segments(_chosen(ctx, poses))
    return points, array([ctx.mpf(length) for length in lengths])


def key_times(ctx: Context, poses: Array) -> Array:
    """The times at which `motion` passes through the poses, (keys, 4, 4) -> (keys,).

    They are one apart, but two where the logarithms of two poses make a segment of their own.
    """
    _, lengths = _segments(_chosen(ctx, poses))
    times = [0]
    for length in lengths:
        times += [times[-1] + 2] if length == 2 else range(times[-1] + 1, times[-1] + length)
    return array([ctx.mpf(time) for time in times])


def motion(ctx: Context, poses: Array, t: Array) -> Array:
    """The motion e^c, c the spliced spline through `select_logarithms`, (keys, 4, 4), () -> (4, 4).

    Section 5; it passes through the poses at `key_times`. Raises InputError as `select_logarithms` does.
    """
    return _moved(ctx, _chosen(ctx, poses), t, _spliced)


def smooth_motion(ctx: Context, poses: Array, t: Array) -> Array:
    """The motion e^c whose velocity and acceleration on the group are continuous, (keys, 4, 4), () -> (4, 4).

    At a junction from Y to X, logarithms of one pose, the curves c before it and phi(c) after it have the same
    exponentials, phi taking a logarithm of a similarity next to Y to the one next to X (`_turned_back`). So e^c is as
    smooth as need be if the derivatives after the junction are those of phi(c). This is `motion` but for the first span
    after each junction, where a quintic takes the place of the cubic: with the derivatives of phi(c) at its start, and
    the same value and derivatives as the cubic at its end.
    """
    return _moved(ctx, _chosen(ctx, poses), t, _smooth)


def principal_motion(ctx: Context, poses: Array, t: Array) -> Array:
    """The motion e^c, c the one cubic spline through the principal logarithms, (keys, 4, 4), () -> (4, 4).

    What figure 7 shows: it takes the long way wherever the rotation passes through pi. Raises InputError as `motion`.
    """
    choices = [_Choice(log, log, False) for log in _logarithms(ctx, poses)]
    return _moved(ctx, choices, t, _spliced)


def continue_motion(ctx: Context, base: Array, poses: Array, t: Array) -> Array:
    """`motion` with the logarithms whose choice is undecided taken so that it is nearest to ``base``."""
    return _nearest(ctx, base, poses, t, _spliced)


def continue_smooth_motion(ctx: Context, base: Array, poses: Array, t: Array) -> Array:
    """`smooth_motion`, likewise."""
    return _nearest(ctx, base, poses, t, _smooth)


def _lengths(ctx: Context, points: Array, lengths: Array) -> tuple[int, ...]:
    _domain.finite(ctx, "points", points)
    _domain.finite(ctx, "lengths", lengths)
    numbers = tuple(map(int, lengths))
    if not numbers or any(n < 2 or n != length for n, length in zip(numbers, lengths, strict=True)):
        raise InputError("lengths", "not whole numbers from 2 on")
    if sum(numbers) != len(points):
        raise InputError("lengths", f"their sum is not the number of points, {len(points)}")
    return numbers


def _numbers(ctx: Context, rows: Rows) -> Array:
    return array([[ctx.mpf(x.numerator) / x.denominator for x in row] for row in rows])


def _combined(ctx: Context, rows: Array, points: Array) -> Array:
    """The combinations of points with given weights, (rows, points), (points, dims) -> (rows, dims)."""
    return array([[dot(ctx, row, column) for column in points.T] for row in rows])


def _place(ctx: Context, lengths: Sequence[int], t: Number) -> tuple[int, Number]:
    """The span in which the time t lies, the later one at a knot, and the time since its start."""
    last = sum(completed(lengths)) - len(lengths) - 1
    span = min(max(int(ctx.floor(t)), 0), last)
    return span, t - span


@lru_cache(maxsize=256)
def _bezier_weights(ctx: Context, _precision: int, lengths: tuple[int, ...], span: int) -> Array:
    """The weights of a span's Bezier points, kept as a truth asks for them again and again."""
    return _numbers(ctx, weights(lengths).bezier[span])


def _polynomial(ctx: Context, points: Array, lengths: tuple[int, ...], span: int) -> list[Array]:
    """The coefficients of the cubic on one span, in powers of the time since its start."""
    a, b, c, d = _combined(ctx, _bezier_weights(ctx, ctx.prec, lengths, span), points)
    return [a, 3 * (b - a), 3 * (a - 2 * b + c), d - a + 3 * (b - c)]


def _at(coefficients: Sequence[Any], s: Number) -> Any:
    """The value of a polynomial, by Horner's rule."""
    value = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        value = value * s + coefficient
    return value


class _Choice(NamedTuple):
    """The logarithms of one pose with which the curve arrives at it and leaves it; ``jumps`` if they are not one."""

    arrival: Array
    departure: Array
    jumps: bool


def _logarithms(ctx: Context, poses: Array) -> list[Array]:
    """The principal logarithms of the poses."""
    if len(poses) < 2:
        raise InputError("poses", "fewer than two")
    return [_logarithm(ctx, ctx.prec, tuple(pose.flat)) for pose in poses]


@lru_cache(maxsize=64)
def _logarithm(ctx: Context, _precision: int, entries: tuple[Number, ...]) -> Array:
    """The principal logarithm of a pose, kept: truths move one pose a little at a time, and the others stay."""
    try:
        return sim3.log(ctx, array(entries).reshape(4, 4))
    except InputError as error:
        raise InputError("poses", error.reason) from error


def _chosen(ctx: Context, poses: Array) -> list[_Choice]:
    """The logarithms of strategy 1."""
    return next(_ways(ctx, _logarithms(ctx, poses), 0.0))


def _ways(ctx: Context, logs: Sequence[Array], slack: float) -> Iterator[list[_Choice]]:
    """The choices of strategy 1: a single one, or all between which ties, to within ``slack``, leave it undecided."""
    if len(logs) == 1:
        yield from ([_Choice(log, log, False)] for log in _principal(ctx, logs[0], slack))
        return
    for way in _ways(ctx, logs[:-1], slack):
        for log in _principal(ctx, logs[-1], slack):
            for jumps in _turns(ctx, log, way[-1].departure, slack):
                yield [*way, _Choice(_turned_back(ctx, [log])[0] if jumps else log, log, jumps)]


def _principal(ctx: Context, log: Array, slack: float) -> list[Array]:
    """The principal logarithm, with the one across if its angle is pi to within ``slack``."""
    across = slack and norm(ctx, log[:3]) > ctx.pi - slack
    return [log, _turned_back(ctx, [log])[0]] if across else [log]


def _turns(ctx: Context, log: Array, previous: Array, slack: float) -> list[bool]:
    """Whether -(2 pi - |w|) w / |w| is nearer than w to the rotation vector of ``previous``; both in a tie with slack.

    The middle of the two is at the angle |w| - pi from 0, along w.
    """
    angle = norm(ctx, log[:3])
    if not angle:
        return [False]
    beyond = angle - ctx.pi - dot(ctx, log[:3], previous[:3]) / angle
    if abs(beyond) <= slack:
        return [False, True]
    return [bool(beyond > 0) and not negligible(ctx, beyond, ctx.pi)]


def _segments(choices: Sequence[_Choice]) -> tuple[Array, tuple[int, ...]]:
    """The points and the lengths of the segments that the choices make; a jump at the last pose is none."""
    points, starts = [choices[0].departure], [0]
    for choice in choices[1:-1]:
        points.append(choice.arrival)
        if choice.jumps:
            starts.append(len(points))
            points.append(choice.departure)
    points.append(choices[-1].arrival)
    return array(points), tuple(int(n) for n in np.diff([*starts, len(points)]))


def _moved(ctx: Context, choices: Sequence[_Choice], t: Array, curve: Any) -> Array:
    _domain.finite(ctx, "t", t)
    return sim3.exp(ctx, curve(ctx, *_segments(choices), t[()]))


def _spliced(ctx: Context, points: Array, lengths: tuple[int, ...], t: Number) -> Array:
    span, s = _place(ctx, lengths, t)
    value: Array = _at(_polynomial(ctx, points, lengths, span), s)
    return value


def _smooth(ctx: Context, points: Array, lengths: tuple[int, ...], t: Number) -> Array:
    """The spliced spline with (1 - s)^3 (s p + s^2 (3 p + q)) added on the first span after each junction.

    That has the value 0, the derivative p and half the second derivative q at s = 0, and three zeros at s = 1. They are
    what phi(c) has more than the cubic.
    """
    span, s = _place(ctx, lengths, t)
    cubic = _polynomial(ctx, points, lengths, span)
    value: Array = _at(cubic, s)
    if span and span in np.cumsum(completed(lengths)) - np.arange(1, len(lengths) + 1):
        before = _polynomial(ctx, points, lengths, span - 1)
        due = _turned_back(ctx, [sum(before), before[1] + 2 * before[2] + 3 * before[3], before[2] + 3 * before[3]])
        p, q = due[1] - cubic[1], due[2] - cubic[2]
        value = value + (p + (3 * p + q) * s) * (s * (1 - s) ** 3)
    return value


def _turned_back(ctx: Context, log: Taylor) -> list[Array]:
    """The curve phi(c) of logarithms (omega, v, lambda) whose exponentials are those of c, one turn back; to any order.

    With n the axis and theta the angle of omega, the rotation vector is (theta - 2 pi) n. With Gamma = lambda I +
    [omega]x, V is (e^Gamma - I) Gamma^-1, and e^Gamma the same for both; so V v = V' v' says v' = Gamma' Gamma^-1 v.
    That is v on the axis, and (lambda + i (theta - 2 pi)) / (lambda + i theta) v = v - 2 pi i / (lambda + i theta) v
    across it.
    """
    omega, v, growth = [c[:3] for c in log], [c[3:6] for c in log], [c[6] for c in log]
    square = product(omega, omega, lambda a, b: dot(ctx, a, b))
    turn = multiple(quotient(omega, square_root(ctx, square)), 2 * ctx.pi)
    side = product(turn, v, cross)
    across = total(product(omega, side, cross), multiple(product(side, growth), -1))
    moved = total(v, quotient(across, total(square, product(growth, growth))))
    return [np.concatenate([w - w0, x, [g]]) for w, w0, x, g in zip(omega, turn, moved, growth, strict=True)]


def _nearest(ctx: Context, base: Array, poses: Array, t: Array, curve: Any) -> Array:
    found = [_moved(ctx, way, t, curve) for way in _ways(ctx, _logarithms(ctx, poses), _TIE)]
    return min(found, key=lambda pose: norm(ctx, (pose - base).flat))
