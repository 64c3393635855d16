"""Sequences of poses by the steps from each to the next: how far they turn, stretch, and differ from one another.

Morphs of morphs ask for logarithms of what lies between the steps. Steps that turn by less than a right angle, or about
one axis, or have one frame, leave them real.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from affinecert.catalogue import turns
from affinecert.draw import Draw
from affinecert.map import Array
from affinecert.sampling import any_rotation, eighths, homogeneous, signed, vector, well_conditioned

Sequence = tuple[list[Array], float]
"""Steps as homogeneous matrices, and their distance to what makes them difficult."""


@dataclass(frozen=True)
class Steps:
    """What a regime draws its steps from, given the dimension, 2 or 3, and how many there are."""

    name: str
    distance: str
    build: Callable[[Draw, int, int], Sequence]


def poses(draw: Draw, kind: Steps, size: int, count: int) -> tuple[list[Array], float]:
    """So many poses, each a step from the one before, and the distance of the steps."""
    steps, distance = kind.build(draw, size, count - 1)
    placed = [homogeneous(well_conditioned(draw, size), vector(draw, -3, 1, size))]
    for step in steps:
        placed.append(step @ placed[-1])
    return placed, distance


def _turn(axis: Array, angle: float) -> Array:
    """The rotation by an angle, about an axis in space; in the plane the axis has one component, which is not used."""
    if len(axis) == 3:
        return turns.about(axis, angle, 0.0).matrix
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([[cosine, -sine], [sine, cosine]])


def _axis(draw: Draw, size: int) -> Array:
    return draw.direction(3) if size == 3 else np.ones(1)


def _stretched_turn(draw: Draw, size: int, most: float, stretch: float) -> tuple[Array, float]:
    """A turn by at most ``most`` after a stretch by up to ``stretch`` along some axes; and the angle."""
    angle = draw.uniform(0.1 * most, most) * draw.choice((1.0, -1.0))
    values = np.diag([stretch ** draw.uniform(-1.0, 1.0) for _ in range(size)])
    frame = any_rotation(draw, size)
    linear = _turn(_axis(draw, size), angle) @ frame @ values @ frame.T
    return homogeneous(linear, vector(draw, -2, 1, size)), abs(angle)


def _turns(most: float, stretch: float) -> Callable[[Draw, int, int], Sequence]:
    def build(draw: Draw, size: int, count: int) -> Sequence:
        steps, angles = zip(*(_stretched_turn(draw, size, most, stretch) for _ in range(count)), strict=True)
        return list(steps), min(angles)

    return build


def _regular(draw: Draw, size: int, count: int) -> Sequence:
    step, angle = _stretched_turn(draw, size, 1.2, 1.4)
    return [step] * count, angle


def _near_identity(draw: Draw, size: int, count: int) -> Sequence:
    gap = draw.exponent(-16, -1)
    steps = [
        homogeneous(
            np.eye(size) + gap * draw.direction(size * size).reshape(size, size), gap * vector(draw, -1, 1, size)
        )
        for _ in range(count)
    ]
    return steps, gap


def _translations(draw: Draw, size: int, count: int) -> Sequence:
    steps = [homogeneous(np.eye(size), vector(draw, size=size)) for _ in range(count)]
    return steps, float(np.linalg.norm(steps[0][:-1, -1]))


def _coalescing(draw: Draw, size: int, count: int) -> Sequence:
    """Positive eigenvalues at any distance, with one eigenvector where they meet, triangular in one frame."""
    frame = well_conditioned(draw, size)
    gap = draw.choice((draw.exponent(-16, -1), 0.0))
    steps = []
    for _ in range(count):
        upper = np.triu([[draw.uniform(-1.0, 1.0) for _ in range(size)] for _ in range(size)])
        np.fill_diagonal(upper, eighths(draw, 4, 16) * (1.0 + gap * np.arange(size)))
        steps.append(homogeneous(frame @ upper @ np.linalg.inv(frame), vector(draw, -2, 1, size)))
    return steps, gap


def _near_pi(draw: Draw, size: int, count: int) -> Sequence:
    """Similarities that turn by nearly pi about one axis, all the same way."""
    # Steps that rounding sets apart by u have generators apart by u / gap. So far apart are what lies between them, and
    # these have generators u / gap^2 apart: that has to be well below gap for a second round of morphs to exist.
    gap, axis, sign = draw.exponent(-4, -1), _axis(draw, size), draw.choice((1.0, -1.0))
    steps = []
    for _ in range(count):
        angle = sign * (math.pi - gap * draw.uniform(1.0, 2.0))
        steps.append(homogeneous(draw.uniform(0.5, 2.0) * _turn(axis, angle), vector(draw, -2, 1, size)))
    return steps, gap


def _border(draw: Draw, size: int, count: int) -> Sequence:
    """Equal steps, with a pair of eigenvalues r (-1 +- i gap) near the negative axis, their eigenvectors close."""
    # As in `_near_pi`, with generators u / gap^3 apart, and u / gap^6 in the second round: below gap from 0.005 on.
    r, gap = draw.uniform(0.5, 1.5), draw.exponent(-2, -0.5)
    linear = np.diag([draw.uniform(0.5, 1.5)] * size)
    linear[:2, :2] = r * np.array([[-1.0, 1.0], [-gap * gap, -1.0]])
    frame = well_conditioned(draw, size)
    return [homogeneous(frame @ linear @ np.linalg.inv(frame), vector(draw, -2, 1, size))] * count, gap


def _no_logarithm(draw: Draw, size: int, count: int) -> Sequence:
    """A first step with two negative eigenvalues that differ; the others are ordinary."""
    steps, _ = _turns(0.8, 1.4)(draw, size, count)
    gap = draw.exponent(-3, 0)
    values = np.diag([-1.0, -1.0 - gap, *[draw.uniform(0.5, 2.0)] * (size - 2)])
    frame = well_conditioned(draw, size)
    steps[0] = homogeneous(frame @ values @ np.linalg.inv(frame), vector(draw, -2, 1, size))
    return steps, gap


GENERIC = Steps("generic", "smallest angle of a step", _turns(0.8, 1.4))
GENTLE = Steps("gentle", "smallest angle of a step", _turns(0.3, 1.2))
REGULAR = Steps("regular", "angle of the step", _regular)
NEAR_IDENTITY = Steps("near-identity", "distance of the steps from the identity", _near_identity)
TRANSLATIONS = Steps("pure-translation", "length of the first step", _translations)
COALESCING = Steps("coalescing", "relative gap of two eigenvalues", _coalescing)
NEAR_PI = Steps("near-pi", "pi - angle", _near_pi)
BORDER = Steps("border", "relative distance of a pair to the negative axis", _border)
NO_LOGARITHM = Steps("no-logarithm", "relative gap of two negative eigenvalues", _no_logarithm)


def spoilt(draw: Draw, placed: list[Array]) -> float:
    """Makes one of the poses a reflection, a projection, or a matrix with another last row; tells its smallest part."""
    pose = draw.choice(placed)
    fault = draw.choice(("reflection", "projection", "last row"))
    size = len(pose) - 1
    if fault == "last row":
        wrong = signed(draw, -15, 0)
        pose[size, draw.choice(range(size))] = wrong
        return abs(wrong)
    row = draw.choice(range(size))
    length = float(np.linalg.norm(pose[row, :size]))
    pose[row, :size] *= -1.0 if fault == "reflection" else 0.0
    return length
