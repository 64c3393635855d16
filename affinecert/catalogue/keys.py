"""Keys of curves in the groups G_A, G_S and SE(3), and of affine maps: each a step of the group from the one before."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from affinecert.catalogue import shears, turns
from affinecert.catalogue.affine_maps import OUTSIDE
from affinecert.catalogue.shears import Shears
from affinecert.catalogue.turns import Turns
from affinecert.draw import Draw
from affinecert.map import Array, Point, Regime
from affinecert.sampling import homogeneous, vector, well_conditioned

Step = Callable[[Draw], tuple[Array, float]]
"""Draws a step, and its distance to what makes it difficult."""

Keys = Callable[[Draw], tuple[list[Array], float]]
"""Draws keys, and the distance of the first step."""


def _walk(first: Step, step: Step, count: int, equal: bool = False) -> Keys:
    """So many keys, each the one before times a step: always the same one if ``equal``."""

    def build(draw: Draw) -> tuple[list[Array], float]:
        key, _ = first(draw)
        once, distance = step(draw)
        keys = [key, key @ once]
        while len(keys) < count:
            keys.append(keys[-1] @ (once if equal else step(draw)[0]))
        return keys, distance

    return build


def _shear(kind: Shears) -> Step:
    return lambda draw: shears.matrix(kind, draw)


def _rigid(kind: Turns, low: float = -2, high: float = 2) -> Step:
    def build(draw: Draw) -> tuple[Array, float]:
        turn = kind.build(draw)
        return homogeneous(turn.matrix, vector(draw, low, high)), turn.distance

    return build


def _pure_translation(draw: Draw) -> tuple[Array, float]:
    size = draw.exponent(-3, 3)
    return homogeneous(np.eye(3), size * draw.direction(3)), size


def _regime(name: str, distance: str, keys: Keys) -> Regime:
    def build(draw: Draw) -> Point:
        found, distant = keys(draw)
        return Point((np.stack(found),), distant)

    return Regime(name, build, distance)


def _outside(keys: Keys, spoil: Callable[[Draw, Array], float]) -> Callable[[Draw], Point]:
    """Keys one of which ``spoil`` takes out of the group."""

    def build(draw: Draw) -> Point:
        found, _ = keys(draw)
        wrong = spoil(draw, draw.choice(found))
        return Point((np.stack(found),), wrong)

    return build


def shear_curves(count: int) -> tuple[Regime, ...]:
    """Regimes of so many shears, (count, 3, 3), the last one outside the domain."""
    first = _shear(shears.GENERIC)
    kinds = (shears.GENERIC, shears.NEAR_IDENTITY, shears.COALESCING, shears.ALL_COALESCING, shears.DEFECTIVE)

    def spoil(draw: Draw, shear: Array) -> float:
        size, place = draw.exponent(-16, 1), draw.choice((1, 2))
        shear[place, place] = draw.choice((-size, 0.0))
        return size

    return (
        *(_regime(kind.name, kind.distance, _walk(first, _shear(kind), count)) for kind in kinds),
        _regime("regular", shears.GENERIC.distance, _walk(first, first, count, equal=True)),
        Regime("outside", _outside(_walk(first, first, count), spoil), "size of the entry that is not positive", 0.25),
    )


def scale_curves(count: int) -> tuple[Regime, ...]:
    """Regimes of so many scales, (count,), the last one outside the domain."""

    def drawn(low: float, high: float) -> Callable[[Draw], Point]:
        """Scales times a common one, their logarithms of size 10**e, e in [low, high]."""

        def build(draw: Draw) -> Point:
            size, common = draw.exponent(low, high), draw.exponent(-3, 3)
            return Point((np.array([common * math.exp(size * draw.uniform(-1, 1)) for _ in range(count)]),), size)

        return build

    def regular(draw: Draw) -> Point:
        step = draw.exponent(-2, 2)
        return Point((draw.exponent(-3, 3) * step ** np.arange(float(count)),), step)

    def outside(draw: Draw) -> Point:
        point, wrong = drawn(-1, 1)(draw), draw.exponent(-300, 300)
        point.inputs[0][draw.choice(range(count))] = draw.choice((0.0, -wrong))
        return Point(point.inputs, wrong)

    return (
        Regime("generic", drawn(-1, 0.5), "largest logarithm"),
        Regime("near-identity", drawn(-16, -1), "largest logarithm"),
        # Keys within e^64 of each other have slopes of their logarithms of up to 64, 192 and 320, which take the curve
        # between them less than 320 / 4 beyond: far from where float64 ends.
        Regime("huge", drawn(1, 1.5), "largest logarithm"),
        Regime("regular", regular, "step"),
        Regime("outside", outside, "|scale|", share=0.25),
    )


def rigid_curves(count: int) -> tuple[Regime, ...]:
    """Regimes of so many rigid motions, (count, 4, 4), the last one outside the domain."""
    first = _rigid(turns.GENERIC)

    def spoil(draw: Draw, pose: Array) -> float:
        turn = turns.no_rotation(draw)
        pose[:3, :3] = turn.matrix
        if draw.choice((True, False)):
            pose[:3, :3] = np.eye(3)
            pose[3, draw.choice(range(4))] += turn.distance
        return turn.distance

    def steps(kind: Turns, low: float, high: float) -> Regime:
        return _regime(kind.name, kind.distance, _walk(first, _rigid(kind, low, high), count))

    return (
        steps(turns.GENERIC, -2, 2),
        steps(turns.NEAR_IDENTITY, -16, 0),
        _regime("near-pi", turns.NEAR_PI.distance, _walk(first, _short_of_pi, count)),
        steps(turns.OFF_MANIFOLD, -2, 2),
        _regime("pure-translation", "length of the first step", _walk(first, _pure_translation, count)),
        _regime("regular", "angle", _walk(first, first, count, equal=True)),
        Regime("outside", _outside(_walk(first, first, count), spoil), "stretch, or error of the last row", 0.25),
    )


def _short_of_pi(draw: Draw) -> tuple[Array, float]:
    # The product of two rotations tells the angle to a few u; none closer to pi than 1e-12 is surely short of it.
    gap = draw.exponent(-12, 0)
    return homogeneous(turns.short_of_pi(draw.direction(3), gap, gap).matrix, vector(draw, -2, 2)), gap


def affine_curves(count: int) -> tuple[Regime, ...]:
    """Regimes of so many affine maps A S E, (count, 4, 4), the last one outside the domain."""

    def generic(draw: Draw) -> tuple[list[Array], float]:
        found = [homogeneous(well_conditioned(draw, 3), vector(draw, -2, 2)) for _ in range(count)]
        return found, float(np.linalg.norm(found[1] - found[0]))

    def near(draw: Draw) -> tuple[list[Array], float]:
        # Perturbed by a tenth of its smallest singular value, a map stays invertible.
        gap, key = draw.exponent(-16, -1.3), homogeneous(well_conditioned(draw, 3), vector(draw, -2, 1))
        change = [homogeneous(gap * draw.direction(9).reshape(3, 3), gap * draw.direction(3)) for _ in range(count)]
        return [key + each - np.diag([0.0, 0.0, 0.0, 1.0]) for each in change], gap

    def composed(shear: Step, rigid: Step, equal: bool = False) -> Keys:
        """A S E for shears and rigid motions of those steps, with powers of two for scales."""

        def build(draw: Draw) -> tuple[list[Array], float]:
            sheared, distance = _walk(_shear(shears.GENERIC), shear, count, equal)(draw)
            moved, other = _walk(_rigid(turns.GENERIC), rigid, count, equal)(draw)
            ratio = 2.0 ** draw.choice(range(-2, 3))
            linear = [homogeneous(ratio**k * a, np.zeros(3)) for k, a in enumerate(sheared)]
            return [a @ e for a, e in zip(linear, moved, strict=True)], min(distance, other)

        return build

    def spoil(draw: Draw, affine: Array) -> float:
        point = OUTSIDE.build(draw)
        affine[:] = point.inputs[0]
        return point.distance

    any_shear, any_rigid = _shear(shears.GENERIC), _rigid(turns.GENERIC)
    return (
        _regime("generic", "distance between the first two", generic),
        _regime("near-identity", "distance between the keys", near),
        _regime("coalescing", "gap of two eigenvalues", composed(_shear(shears.ALL_COALESCING), any_rigid)),
        _regime("near-pi", "pi - angle", composed(any_shear, _short_of_pi)),
        _regime("regular", "angle, or gap of two eigenvalues", composed(any_shear, any_rigid, equal=True)),
        Regime("outside", _outside(generic, spoil), OUTSIDE.distance, share=0.25),
    )
