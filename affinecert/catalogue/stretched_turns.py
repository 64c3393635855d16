"""Linear maps of positive determinant by their singular values: where these meet, where they vanish, near a rotation.

A map is R S, a rotation after a stretch, of the plane or of space.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from affinecert.draw import Draw
from affinecert.map import Array, Point, Regime
from affinecert.sampling import any_rotation, eighths, half_turns, oblique, off_by_ulps, quarter_turns, well_conditioned

Linear = tuple[Array, float]
"""A linear map, (2, 2) or (3, 3), and its distance to what makes it difficult."""


def _from_values(draw: Draw, values: list[float]) -> Array:
    """A map with these singular values, up to rounding."""
    size = len(values)
    return any_rotation(draw, size) @ np.diag(values) @ any_rotation(draw, size)


def _generic(draw: Draw, size: int) -> Linear:
    values = [draw.exponent(-1, 1) for _ in range(size)]
    return _from_values(draw, values), min(values) / max(values)


def _near_rotation(draw: Draw, size: int) -> Linear:
    # Moved by less than 0.4, a rotation keeps its orientation.
    gap = draw.exponent(-16, -0.5)
    return any_rotation(draw, size) + gap * draw.direction(size * size).reshape(size, size), gap


def _rotation(draw: Draw, size: int) -> Linear:
    """A rotation: to the last bit, or rounded, or off by a few last places; by half a turn too."""
    exact = quarter_turns(size) if size == 2 else (*quarter_turns(size), *half_turns())
    rounded = any_rotation(draw, size)
    choices = (draw.choice(exact), rounded, off_by_ulps(draw, rounded, 4))
    return draw.choice(choices), float(np.finfo(np.float64).eps)


def _nearly_singular(draw: Draw, size: int) -> Linear:
    # Rounding moves singular values by some 1e-16, which leaves the determinant of one of 1e-14 positive.
    least = draw.exponent(-14, 0)
    values = [draw.uniform(0.5, 2.0) for _ in range(size - 1)]
    return _from_values(draw, [*values, least]), least


def _nearly_rank_one(draw: Draw, _: int) -> Linear:
    """Two small singular values, in space: their sum is what tells the rotation."""
    least = draw.exponent(-14, 0)
    values = [1.0, least * draw.uniform(1.0, 2.0), least]
    return any_rotation(draw) @ np.diag(values) @ any_rotation(draw), least


def _meeting(draw: Draw, size: int) -> Linear:
    """Two or all singular values as near as 1e-16, or equal to the last bit, after a rotation that keeps it."""
    half_gap = draw.choice((draw.exponent(-16, -0.5), 0.0))
    values = [1 + half_gap, 1 - half_gap, draw.choice((1.0, eighths(draw, 2, 24)))][:size]
    if half_gap:
        return _from_values(draw, values), half_gap
    scale = eighths(draw, 2, 24)
    return scale * draw.choice(quarter_turns(size)) @ np.diag(values), half_gap


def _huge_or_tiny(draw: Draw, size: int) -> Linear:
    scale = draw.exponent(-150, 150)
    return scale * well_conditioned(draw, size), scale


def _last_bits(draw: Draw, size: int) -> Linear:
    """An integer matrix of determinant 1, next to singular ones: its singular values multiply to 1.

    It is a product of shears by 64 at most, whose entries stay below 65^6 < 2^37.
    """
    matrix, order = np.eye(size), [(i, j) for i in range(size) for j in range(size) if i != j]
    for row, column in order:
        shear = np.eye(size)
        shear[row, column] = draw.choice((1.0, -1.0)) * round(draw.exponent(0, 1.8))
        matrix = matrix @ shear
    return matrix, float(np.linalg.norm(matrix)) ** -size


def _diagonal(draw: Draw, size: int) -> Linear:
    values = [draw.exponent(-100, 100) for _ in range(size)]
    return np.diag(values), min(values) / max(values)


def _outside(draw: Draw, size: int) -> Linear:
    """A reflection, however small, or a projection, exactly."""
    if draw.choice((True, False)):
        least = draw.exponent(-14, 0)
        values = [*(draw.uniform(0.5, 2.0) for _ in range(size - 1)), -least]
        return _from_values(draw, values), least
    flat = np.diag([eighths(draw, 1, 16) for _ in range(size)])
    flat[-1, -1] = 0.0
    return oblique(draw, flat), 0.0


@dataclass(frozen=True)
class StretchedTurns:
    """What a regime draws its linear maps from, given the dimension, 2 or 3."""

    name: str
    distance: str
    build: Callable[[Draw, int], Linear]

    def regime(self, size: int, share: float = 1.0) -> Regime:
        """The regime of a map of one such matrix."""

        def build(draw: Draw) -> Point:
            linear, distance = self.build(draw, size)
            return Point((linear,), distance)

        return Regime(f"{self.name}-{size}d", build, self.distance, share)


GENERIC = StretchedTurns("generic", "ratio of the extreme singular values", _generic)
NEAR_ROTATION = StretchedTurns("near-rotation", "distance from a rotation", _near_rotation)
ROTATION = StretchedTurns("rotation", "distance from a rotation", _rotation)
NEARLY_SINGULAR = StretchedTurns("nearly-singular", "smallest singular value", _nearly_singular)
NEARLY_RANK_ONE = StretchedTurns("nearly-rank-one", "sum of the smallest singular values", _nearly_rank_one)
MEETING = StretchedTurns("meeting", "half the gap of two singular values", _meeting)
LAST_BITS = StretchedTurns("last-bits", "determinant over the power of the norm", _last_bits)
HUGE_OR_TINY = StretchedTurns("huge-or-tiny", "scale", _huge_or_tiny)
DIAGONAL = StretchedTurns("diagonal", "ratio of the extreme singular values", _diagonal)
OUTSIDE = StretchedTurns("outside", "distance from singular", _outside)

OF_EVERY_SIZE = (
    GENERIC,
    NEAR_ROTATION,
    ROTATION,
    NEARLY_SINGULAR,
    MEETING,
    LAST_BITS,
    HUGE_OR_TINY,
    DIAGONAL,
    OUTSIDE,
)

REGIMES = (
    *(kind.regime(3) for kind in (*OF_EVERY_SIZE, NEARLY_RANK_ONE)),
    *(kind.regime(2, share=0.5) for kind in OF_EVERY_SIZE),
)
"""What the polar decomposition is tried on."""
