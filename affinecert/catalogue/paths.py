"""Paths, given by their poses at equal steps of time: how steady they are, and how near they come to losing volume."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from affinecert.draw import Draw
from affinecert.map import Array, Point, Regime
from affinecert.sampling import any_rotation, homogeneous, oblique, quarter_turns, signed, vector, well_conditioned

Path = tuple[Array, float]
"""Poses, (poses, n, n), and the distance to what makes them difficult."""


@dataclass(frozen=True)
class Paths:
    """What a regime draws its paths from, given the dimension, 2 or 3, and the number of poses."""

    name: str
    distance: str
    build: Callable[[Draw, int, int], Path]
    share: float = 1.0


def regimes(
    kinds: Iterable[Paths], count: int, inputs: Callable[[Draw, Array], tuple[Array, ...]], share: float
) -> tuple[Regime, ...]:
    """A regime for each kind and dimension; ``inputs`` makes the map's inputs of a path.

    ``count`` is the number of poses in space; in the plane there are two more. ``share`` multiplies each kind's own.
    """

    def regime(kind: Paths, size: int) -> Regime:
        def build(draw: Draw) -> Point:
            poses, distance = kind.build(draw, size, count + 2 * (3 - size))
            return Point(inputs(draw, poses), distance)

        return Regime(f"{kind.name}-{size}d", build, kind.distance, share * kind.share)

    return tuple(regime(kind, size) for kind in kinds for size in (2, 3))


def _pose(draw: Draw, size: int, low: float = -1, high: float = 1) -> Array:
    return homogeneous(well_conditioned(draw, size), vector(draw, low, high, size))


def _generic(draw: Draw, size: int, count: int) -> Path:
    poses = np.array([_pose(draw, size) for _ in range(count)])
    return poses, float(np.linalg.norm(poses[0] - poses[-1]))


def _smooth(draw: Draw, size: int, count: int) -> Path:
    """Straight lines from pose to pose, as fine as they come."""
    step = draw.exponent(-7, -1)
    start, way = _pose(draw, size), np.zeros((size + 1, size + 1))
    way[:-1] = draw.direction(size * (size + 1)).reshape(size, size + 1)
    # Shorter than the smallest singular value of the start, 1/2, the whole way loses no orientation.
    return np.array([start + step * i / count * way for i in range(count)]), step


def _steady(draw: Draw, size: int, count: int) -> Path:
    """A steady motion, but for the rounding of its poses, or for more."""
    step, off = draw.exponent(-5, -0.5), draw.choice((0.0, draw.exponent(-16, 0)))
    change = homogeneous(
        np.eye(size) + step * draw.direction(size * size).reshape(size, size), vector(draw, -2, 0, size)
    )
    poses = [_pose(draw, size)]
    while len(poses) < count:
        poses.append(change @ poses[-1])
    poses[-1][:-1, -1] += off * draw.direction(size)
    return np.array(poses), off or step


def _exactly_steady(draw: Draw, size: int, count: int) -> Path:
    """Powers of an exact matrix, from an exact pose: the acceleration is 0 to the last bit."""
    scale = 2.0 ** draw.choice(range(-2, 3))
    change = homogeneous(
        scale * draw.choice(quarter_turns(size)), np.array([draw.choice(range(-3, 4)) for _ in range(size)])
    )
    poses = [homogeneous(oblique(draw, np.eye(size)) @ draw.choice(quarter_turns(size)), np.ones(size))]
    while len(poses) < count:
        poses.append(change @ poses[-1])
    return np.array(poses), scale


def _far(draw: Draw, size: int, count: int) -> Path:
    distance = draw.exponent(1, 10)
    shift = distance * draw.direction(size)
    return np.array(
        [homogeneous(well_conditioned(draw, size), shift + draw.direction(size)) for _ in range(count)]
    ), distance


def _thin(draw: Draw, size: int, count: int) -> Path:
    # Rounding moves the volume by u; a pose of thinness 1e-8 keeps its orientation all the same.
    thinness = draw.exponent(-8, 0)
    squashed = np.array([thinness, *[1.0] * (size - 1)])
    poses = np.array(
        [homogeneous(well_conditioned(draw, size) * squashed, vector(draw, -1, 1, size)) for _ in range(count)]
    )
    return poses, thinness


def _whole(draw: Draw, size: int) -> Array:
    """A linear part of small whole numbers, whose determinant is exact."""
    return np.array([[float(draw.choice(range(-9, 10))) for _ in range(size)] for _ in range(size)])


def _flat_pose(draw: Draw, size: int) -> Array:
    """A pose whose last column repeats the first."""
    linear = _whole(draw, size)
    linear[:, -1] = draw.choice((1.0, -2.0, 0.0)) * linear[:, 0]
    return homogeneous(linear, draw.direction(size))


def _flat(draw: Draw, size: int, count: int) -> Path:
    """A pose that is flat to the last bit, among others."""
    poses, distance = _generic(draw, size, count)
    poses[draw.choice(range(1, count - 1))] = _flat_pose(draw, size)
    return poses, distance


def _nearly_flat(draw: Draw, size: int, count: int) -> Path:
    """A pose that is flat but for a little, among others."""
    poses, _ = _generic(draw, size, count)
    gap = signed(draw, -12, 0)
    linear = well_conditioned(draw, size)
    linear[:, -1] = linear[:, 0] + gap * draw.direction(size)
    poses[draw.choice(range(1, count - 1)), :-1, :-1] = linear
    return poses, abs(gap)


def _inside_out(draw: Draw, size: int, count: int) -> Path:
    """Straight lines to nearly a half turn: some poses on the way may be turned inside out."""
    gap = draw.exponent(-8, 0)
    turn = np.eye(size)
    turn[:2, :2] = [[-np.cos(gap), -np.sin(gap)], [np.sin(gap), -np.cos(gap)]]
    start = well_conditioned(draw, size)
    end = any_rotation(draw, size) @ turn @ np.diag([draw.uniform(0.5, 2.0) for _ in range(size)])
    times = np.arange(count)[:, None, None] / (count - 1)
    linear = (1 - times) * start + times * end
    return np.array([homogeneous(part, draw.direction(size)) for part in linear]), gap


def _no_loss(draw: Draw, size: int, count: int) -> Path:
    """No pose has less volume than the ends, and some as little."""
    start = homogeneous(_pose(draw, size)[:-1, :-1], draw.direction(size))
    factors = [1.0, *(draw.choice((1.0, 1.0 + draw.exponent(-15, 0))) for _ in range(count - 2)), 1.0]
    poses = np.array([start] * count)
    poses[:, :-1, 0] *= np.array(factors)[:, None]
    return poses, max(factors) - 1


def _huge_or_tiny(draw: Draw, size: int, count: int) -> Path:
    # The volume is at most 1e240, whose low part, 1e224, and that of 1e-240, 1e-256, are there.
    scale = draw.exponent(-80, 80)
    poses = np.array([homogeneous(scale * well_conditioned(draw, size), draw.direction(size)) for _ in range(count)])
    return poses, scale


def _outside(draw: Draw, size: int, count: int) -> Path:
    """An end that is flat or mirrored, or a pose whose last row is another one."""
    poses, distance = _generic(draw, size, count)
    end = draw.choice((0, -1))
    fault = draw.choice(("flat", "mirrored", "last row"))
    if fault == "flat":
        poses[end] = _flat_pose(draw, size)
    elif fault == "mirrored":
        poses[end, :-1, 0] *= -1.0
    else:
        poses[end, -1, draw.choice(range(size + 1))] += draw.exponent(-15, 0)
    return poses, distance


def _no_poses(draw: Draw, size: int, count: int) -> Path:
    """A pose whose last row is another one."""
    poses, distance = _generic(draw, size, count)
    poses[draw.choice(range(count)), -1, draw.choice(range(size + 1))] += draw.exponent(-15, 0)
    return poses, distance


GENERIC = Paths("generic", "difference of the ends", _generic)
SMOOTH = Paths("smooth", "length of the way", _smooth)
STEADY = Paths("near-steady", "distance from a steady motion, or its step", _steady)
EXACTLY_STEADY = Paths("steady", "scale of a step", _exactly_steady)
FAR = Paths("far-from-origin", "distance from the origin", _far)
THIN = Paths("thin", "thinness", _thin)
FLAT = Paths("flat", "difference of the ends", _flat)
NEARLY_FLAT = Paths("nearly-flat", "distance from a flat pose", _nearly_flat)
INSIDE_OUT = Paths("inside-out", "pi - angle", _inside_out)
NO_LOSS = Paths("no-loss", "gain of volume", _no_loss)
HUGE_OR_TINY = Paths("huge-or-tiny", "scale", _huge_or_tiny)
OUTSIDE = Paths("outside", "difference of the ends", _outside, share=0.5)
NO_POSES = Paths("outside", "difference of the ends", _no_poses, share=0.5)
