"""Regimes about the time of a curve through several keys: at them, near them, between them and beyond them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from affinecert.draw import Draw
from affinecert.map import Array, Point, Regime
from affinecert.sampling import scalar, signed


@dataclass(frozen=True)
class Times:
    """What a regime draws its times from, given the knots: the times of the keys, in ascending order.

    ``build`` gives the time and its distance to what makes it special; None where the other inputs tell the distance.
    """

    name: str
    distance: str
    build: Callable[[Draw, Sequence[float]], tuple[float, float | None]]


def _inside(draw: Draw, knots: Sequence[float]) -> tuple[float, None]:
    return draw.uniform(knots[0], knots[-1]), None


def _at(draw: Draw, knots: Sequence[float]) -> tuple[float, float]:
    knot = draw.choice(knots)
    return knot, abs(knot)


def _near(draw: Draw, knots: Sequence[float]) -> tuple[float, float]:
    knot = draw.choice(knots)
    gap = signed(draw, -16 if knot else -100, -3)
    return knot + gap, abs(gap)


def _beyond(draw: Draw, knots: Sequence[float]) -> tuple[float, float]:
    gap = draw.uniform(0.0, 0.5)
    return draw.choice((knots[0] - gap, knots[-1] + gap)), gap


INSIDE = Times("", "", _inside)
AT_KEYS = Times("at-keys", "time of the key", _at)
NEAR_KEYS = Times("near-keys", "distance of t from a key", _near)
EXTRAPOLATION = Times("extrapolation", "distance of t from the keys", _beyond)


def timed(regime: Regime, times: Times, knots: Sequence[float]) -> Regime:
    """The regime with a time after its inputs; named after the times, if these have a name, and the dimension."""

    def build(draw: Draw) -> Point:
        point = regime.build(draw)
        time, distance = times.build(draw, knots)
        inputs: tuple[Array, ...] = (*point.inputs, scalar(time))
        return Point(inputs, point.distance if distance is None else distance)

    if not times.name:
        return replace(regime, build=build)
    suffix = regime.name[-3:] if regime.name.endswith(("-2d", "-3d")) else ""
    return replace(regime, name=times.name + suffix, build=build, distance=times.distance)
