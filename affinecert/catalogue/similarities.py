"""Similarities by their angle and their growth, the logarithm of their scale: next to 0, and next to each other."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from affinecert.catalogue import turns
from affinecert.catalogue.turns import Turn, Turns
from affinecert.draw import Draw
from affinecert.map import Array
from affinecert.sampling import homogeneous, signed


@dataclass(frozen=True)
class Similarity:
    """A turn and a growth, with their distance to what is difficult."""

    turn: Turn
    growth: float
    distance: float

    def tangent(self, v: Array) -> Array:
        """The tangent (omega, v, lambda), (7,)."""
        return np.concatenate([self.turn.vector, v, [self.growth]])

    def pose(self, translation: Array) -> Array:
        """The similarity itself with a translation, (4, 4)."""
        return homogeneous(math.exp(self.growth) * self.turn.matrix, translation)


@dataclass(frozen=True)
class Similarities:
    """What a regime draws its similarities from; ``name`` and ``distance`` become the regime's."""

    name: str
    distance: str
    build: Callable[[Draw], Similarity]


def _turn(draw: Draw, angle: float) -> Turn:
    return turns.about(draw.direction(3), angle, angle)


def _generic(draw: Draw) -> Similarity:
    turn = turns.GENERIC.build(draw)
    return Similarity(turn, draw.uniform(-2.0, 2.0), turn.distance)


def _grid(draw: Draw) -> Similarity:
    angle, growth = draw.exponent(-16, 0.49), signed(draw, -16, 0.49)
    return Similarity(_turn(draw, angle), growth, math.hypot(angle, growth))


def _ratio(draw: Draw) -> Similarity:
    larger, ratio = draw.exponent(-16, 0), draw.exponent(-8, 0)
    angle, growth = draw.choice(((larger, ratio * larger), (ratio * larger, larger)))
    return Similarity(_turn(draw, angle), draw.choice((1.0, -1.0)) * growth, larger)


def _tiny(draw: Draw) -> Similarity:
    angle, growth = draw.exponent(-300, -16), signed(draw, -300, -16)
    return Similarity(_turn(draw, angle), growth, max(angle, abs(growth)))


def _no_turn(low: float) -> Callable[[Draw], Similarity]:
    def build(draw: Draw) -> Similarity:
        growth = signed(draw, low, 2)
        return Similarity(Turn(np.zeros(3), np.zeros(3), np.eye(3), 0.0), growth, abs(growth))

    return build


def _large_growth(draw: Draw) -> Similarity:
    turn = draw.choice((turns.GENERIC, turns.NEAR_IDENTITY, turns.NEAR_PI)).build(draw)
    growth = signed(draw, 0.3, 2)
    return Similarity(turn, growth, abs(growth))


def _near_two_pi(draw: Draw) -> Similarity:
    turn, growth = turns.NEAR_TWO_PI.build(draw), signed(draw, -16, 0)
    return Similarity(turn, growth, math.hypot(turn.distance, growth))


def without_growth(name: str, distance: str, *kinds: Turns) -> Similarities:
    """Rigid motions: a growth of exactly 0."""

    def build(draw: Draw) -> Similarity:
        turn = draw.choice(kinds).build(draw)
        return Similarity(turn, 0.0, turn.distance)

    return Similarities(name, distance, build)


def with_any_growth(kind: Turns) -> Similarities:
    """Turns of that kind with a growth of any size up to 2, or none."""

    def build(draw: Draw) -> Similarity:
        turn = kind.build(draw)
        return Similarity(turn, draw.choice((signed(draw, -16, 0.3), 0.0)), turn.distance)

    return Similarities(kind.name, kind.distance, build)


GENERIC = Similarities("generic", "angle", _generic)
GRID = Similarities("angle-by-growth", "length of (angle, growth)", _grid)
RATIO = Similarities("both-near-zero", "the larger of angle and growth", _ratio)
TINY = Similarities("tiny", "the larger of angle and growth", _tiny)
NO_TURN = Similarities("no-rotation", "growth", _no_turn(-300))
GROWING = Similarities("growing", "growth", _no_turn(-15))
LARGE_GROWTH = Similarities("large-growth", "growth", _large_growth)
NEAR_TWO_PI = Similarities("near-2pi", "length of (angle - 2 pi, growth)", _near_two_pi)
NO_GROWTH = without_growth("no-growth", "angle", turns.GENERIC, turns.NEAR_IDENTITY)
NEAR_PI = with_any_growth(turns.NEAR_PI)
AT_PI = with_any_growth(turns.AT_PI)
MANY_TURNS = with_any_growth(turns.NEAR_MULTIPLE_OF_PI)
HUGE_ANGLE = with_any_growth(turns.HUGE_ANGLE)
OFF_BY_ULPS = with_any_growth(turns.OFF_BY_ULPS)
OFF_MANIFOLD = with_any_growth(turns.OFF_MANIFOLD)
