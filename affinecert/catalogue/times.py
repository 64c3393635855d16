"""Regimes of maps that take a time: those of the other inputs at a time inside, and those about the time itself."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from affinecert.draw import Draw
from affinecert.map import Point, Regime
from affinecert.sampling import scalar, signed


def _with(regime: Regime, time: Callable[[Draw], float]) -> Regime:
    def build(draw: Draw) -> Point:
        point = regime.build(draw)
        return Point((*point.inputs, scalar(time(draw))), point.distance)

    return replace(regime, build=build)


def timed(regimes: Iterable[Regime]) -> tuple[Regime, ...]:
    """The regimes, with a time in [0, 1] after their inputs."""
    return tuple(_with(regime, lambda draw: draw.uniform(0.0, 1.0)) for regime in regimes)


def about_time(regime: Regime, suffix: str = "") -> tuple[Regime, ...]:
    """The regimes about the time: outside [0, 1], at its ends, and near them; other inputs as in ``regime``."""

    def extrapolation(draw: Draw) -> Point:
        gap = draw.uniform(0.0, 1.0)
        return Point((*regime.build(draw).inputs, scalar(draw.choice((-gap, 1 + gap)))), gap)

    def near_the_ends(draw: Draw) -> Point:
        end, gap = draw.choice(((0.0, signed(draw, -100, -3)), (1.0, signed(draw, -16, -3))))
        return Point((*regime.build(draw).inputs, scalar(end + gap)), abs(gap))

    return (
        Regime(f"extrapolation{suffix}", extrapolation, "distance of t from [0, 1]"),
        Regime(f"near-the-ends{suffix}", near_the_ends, "distance of t from 0 or 1"),
        replace(_with(regime, lambda draw: draw.choice((0.0, 1.0))), name=f"at-the-ends{suffix}"),
    )
