"""A morph between pairs of poses, asked at times."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from affinecert.map import Array, Map
from affinecert.properties.carrying import several
from affinecert.properties.matrix.algebra import Mask, Poses

Ask = Callable[[Poses, Poses, float], Poses]
"""The poses of a morph between starts and ends, (pairs, n, n), at one time; not a number where there are none."""


@dataclass(frozen=True)
class Motion:
    """A morph between pairs of poses; what it gives at a time is asked once and kept.

    ``clear`` tells which pairs are clear of turns by pi, so that rounding does not change their branch. ``beside`` is
    the same morph between poses that are next to these, for the law of continuity.
    """

    ask: Ask
    start: Poses
    end: Poses
    clear: Mask
    beside: Motion | None = None
    kept: dict[float, Poses] = field(default_factory=dict, compare=False, repr=False)

    def at(self, t: float) -> Poses:
        """The poses at a time."""
        if t not in self.kept:
            self.kept[t] = self.ask(self.start, self.end, t)
        return self.kept[t]

    def between(self, start: Poses, end: Poses) -> Motion:
        """The same morph between other poses."""
        return Motion(self.ask, start, end, self.clear)


def subject(function: Callable[..., Any]) -> Ask:
    """A subject's morph, that takes and gives batches; pairs that it refuses are singled out by halves."""

    def ask(start: Array, end: Array, t: float) -> Array:
        poses = np.full(start.shape, np.nan)
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            _fill(function, start, end, t, poses)
        return poses

    return ask


def _fill(function: Callable[..., Any], start: Array, end: Array, t: float, poses: Array) -> None:
    """Writes the answers that are poses; the others stay what they are."""
    if not len(start):
        return
    try:
        (given,) = several(function(start.copy(), end.copy(), np.full(len(start), t)))
        answer = np.asarray(given, dtype=np.float64)
        complaint = answer.shape != poses.shape
    except Exception:
        complaint = True
    if not complaint:
        good = np.isfinite(answer).all(axis=(-2, -1))
        poses[good] = answer[good]
    elif len(start) > 1:
        half = len(start) // 2
        for part in (np.s_[:half], np.s_[half:]):
            _fill(function, start[part], end[part], t, poses[part])


def reference(entry: Map, ctx: Any) -> Ask:
    """The reference of a morph, on pairs of mpmath's numbers; raises InputError where it refuses one."""

    def ask(start: Poses, end: Poses, t: float) -> Poses:
        time = np.array(ctx.mpf(t), dtype=object)
        return np.array([entry.reference(ctx, *pair, time) for pair in zip(start, end, strict=True)], dtype=object)

    return ask


def exactly(ctx: Any, poses: Array) -> Poses:
    """Poses of float64 as mpmath's numbers."""
    return np.array([ctx.mpf(x) for x in poses.ravel().tolist()], dtype=object).reshape(poses.shape)
