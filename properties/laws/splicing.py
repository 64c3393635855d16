"""What spliced splines are made to be: the equations on their de Boor points, and motions that pass their poses."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from gmpy2 import mpq
from hypothesis import strategies as st
from mpmath import MPContext

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answer import near_similarity
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import exact, norm, ratio
from affinecert.properties.law import Law, OutOfDomain
from affinecert.reference import splines as reference

Equation = tuple[dict[int, Any], Any]
"""Coefficients of de Boor points by their place, and what the combination has to be."""


def _segment(start: int, x: Any) -> list[Equation]:
    """What the de Boor points of one segment, the first of which has that place, have to do with its points."""
    last = len(x) - 1
    if last == 2:
        return [({start: 1, start + 1: 2, start + 2: 1}, 4 * x[1])]
    inner: list[Equation] = []
    for i in range(1, last):
        before = mpq(3, 2) if i == 1 else mpq(1)
        behind = mpq(3, 2) if i == last - 1 else mpq(1)
        own = 4 - (before + behind - 2)
        inner.append(({start + i - 1: before, start + i: own, start + i + 1: behind}, 6 * x[i]))
    return inner


def _equations(segments: Sequence[Any]) -> list[Equation]:
    """Sections 8.1 to 8.3: of each segment, (*) and (**) of each junction, and the natural end conditions."""
    ends = np.cumsum([len(x) for x in segments])
    first, final = segments[0], segments[-1]
    last = int(ends[-1]) - 1
    found: list[Equation] = [({0: 3, 1: -1}, 2 * first[0]), ({last: 3, last - 1: -1}, 2 * final[-1])]
    for x, end in zip(segments, ends, strict=True):
        found += _segment(int(end) - len(x), x)
    for x, y, end in zip(segments[:-1], segments[1:], ends[:-1], strict=True):
        m, f = int(end) - 1, int(end)
        found.append(({f: 6, m - 1: 1, f + 1: -1}, x[-1] + 5 * y[0]))
        found.append(({m: 6, m - 1: -1, f + 1: 1}, 5 * x[-1] + y[0]))
    return found


def _solved(maps: Maps, points: Array, lengths: Array) -> float:
    controls = ask(maps, "splines.de_boor", points, lengths)["controls"]
    pieces = np.split(exact(points), np.cumsum(lengths.astype(int))[:-1])
    segments = [np.array([x[0], (x[0] + x[1]) / 2, x[1]]) if len(x) == 2 else x for x in pieces]
    residuals = []
    for coefficients, due in _equations(segments):
        rest = sum(factor * controls.value[place] for place, factor in coefficients.items()) - due
        allowed = sum(abs(float(factor)) for factor in coefficients.values()) * controls.error
        residuals.append(ratio(norm(rest), allowed))
    return max(residuals)


def _at_a_key(name: str, maps: Maps, poses: Array, time: Array) -> float:
    ctx = MPContext()
    ctx.prec = 320
    numbers = np.vectorize(ctx.mpf, otypes=[object])(poses)
    times = reference.key_times(ctx, numbers)
    key = int(abs(float(time))) % len(poses)
    there = ask(maps, name, poses, np.array(float(times[key])))
    return there.affine.misfit(near_similarity(poses[key]).affine)


def _poses_and_time(*regimes: str) -> st.SearchStrategy[tuple[Array, ...]]:
    return st.one_of([strategies.regime("splines.motion", regime) for regime in regimes])


def _without_junctions(maps: Maps, poses: Array, time: Array) -> float:
    ctx = MPContext()
    ctx.prec = 320
    _, lengths = reference.select_logarithms(ctx, np.vectorize(ctx.mpf, otypes=[object])(poses))
    if len(lengths) > 1:
        raise OutOfDomain("a junction")
    printed, smooth = (ask(maps, f"splines.{name}", poses, time) for name in ("motion", "smooth_motion"))
    return printed.affine.misfit(smooth.affine)


PASSED = ("two-keys", "through-pi", "near-pi", "near-2pi", "half-turns", "large-scales")
"""Regimes of few poses, which keep their last digits."""

LAWS = (
    Law(
        name="splicing.equations",
        statement="d_0 + 2 d_1 + d_2 = 4 x_1 and the like, (*) and (**) at junctions, 3 d_0 = 2 x_0 + d_1 at the ends",
        source="gallier, sections 8.1 to 8.3",
        domain="segments of two points or more, the average added to two",
        needs=("splines.de_boor",),
        inputs=strategies.inputs("splines.de_boor"),
        residual=_solved,
    ),
    *(
        Law(
            name=f"splicing.keys.{name}",
            statement="the motion passes through its poses",
            source="gallier, section 5",
            domain="similarities to within the rounding of their entries",
            needs=(f"splines.{name}",),
            inputs=_poses_and_time(*PASSED),
            residual=partial(_at_a_key, f"splines.{name}"),
        )
        for name in ("motion", "smooth_motion")
    ),
    Law(
        name="splicing.one_segment",
        statement="without a junction the motion that is smooth on the group is the printed one",
        source="gallier, section 5; the derivatives of the exponential",
        domain="poses whose rotations do not pass through pi, or only on the way to the last one; all real t",
        needs=("splines.motion", "splines.smooth_motion"),
        inputs=_poses_and_time("two-keys", "near-identity"),
        residual=_without_junctions,
    ),
)
