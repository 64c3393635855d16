"""Cases for checks: simple ones first, then seeded ones of short dyadic numbers, so that counterexamples are short."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Number, array, homogeneous

STEP = 16
"""Drawn numbers are multiples of 1/16."""


def numbers(name: str, count: int, low: float, high: float) -> list[Number]:
    """So many multiples of 1/16 in [low, high], always the same ones for one name."""
    return list(arrays(name, count, (), low, high))


def arrays(name: str, count: int, shape: tuple[int, ...], low: float, high: float) -> list[Any]:
    """So many arrays of multiples of 1/16 in [low, high]."""
    generator = np.random.default_rng(list(name.encode()))
    drawn = generator.integers(round(low * STEP), round(high * STEP), size=(count, *shape), endpoint=True)
    return [exactly((each / STEP).tolist()) for each in drawn]


def rotations(name: str, count: int, most: Number = mp.pi) -> list[Array]:
    """So many rotations of space about seeded axes, their angles spread over (0, most)."""
    axes = [axis for axis in arrays(name, 2 * count, (3,), -1, 1) if any(axis)][:count]
    angles = [most * (2 * k + 1) / (2 * count) for k in range(count)]
    return [so3.exp(mp, axis * (angle / mp.sqrt(sum(axis * axis)))) for axis, angle in zip(axes, angles, strict=True)]


def plane_rotation(angle: Number) -> Array:
    """The rotation of the plane by an angle, (2, 2)."""
    cosine, sine = mp.cos(angle), mp.sin(angle)
    return array([[cosine, -sine], [sine, cosine]])


def affine(linear: Any, translation: Any = None) -> Array:
    """The homogeneous matrix of a linear part and a translation, by default none; nested sequences of numbers."""
    return homogeneous(mp, exactly(linear), exactly([0] * len(linear) if translation is None else translation))
