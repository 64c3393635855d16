"""Where a regime's random choices come from: uniform numbers here, Hypothesis in `properties.strategies`.

A regime is written once, as a function of a `Draw`. Fed from a seeded generator it gives the deterministic tier; fed
from a vector that the hunt moves about, it gives the hunt its coordinates; fed from Hypothesis, a strategy that
shrinks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

T = TypeVar("T")


class Draw(Protocol):
    """The random choices a regime may make."""

    def uniform(self, low: float, high: float) -> float:
        """A number in [low, high]."""

    def exponent(self, low: float, high: float) -> float:
        """A positive number 10**e, e uniform in [low, high]: how distances to a singular set are drawn."""

    def choice(self, options: Sequence[T]) -> T:
        """One of the options."""

    def direction(self, size: int) -> NDArray[np.float64]:
        """A unit vector of that size, (size,)."""


class UniformDraw:
    """Draws from an iterator of numbers uniform in [0, 1): a generator's, or the hunt's coordinates."""

    def __init__(self, uniforms: Iterator[float]) -> None:
        self._next = uniforms.__next__

    def uniform(self, low: float, high: float) -> float:
        """See `Draw.uniform`."""
        return low + (high - low) * self._next()

    def exponent(self, low: float, high: float) -> float:
        """See `Draw.exponent`."""
        return float(10.0 ** self.uniform(low, high))

    def choice(self, options: Sequence[T]) -> T:
        """See `Draw.choice`."""
        return options[min(int(self._next() * len(options)), len(options) - 1)]

    def direction(self, size: int) -> NDArray[np.float64]:
        """See `Draw.direction`: normal deviates by Box and Muller, so that no direction is preferred."""
        pairs = [(self._next(), self._next()) for _ in range(size)]
        vector: NDArray[np.float64] = np.array(
            [math.sqrt(-2 * math.log1p(-p)) * math.cos(2 * math.pi * q) for p, q in pairs]
        )
        length = float(np.linalg.norm(vector))
        if length == 0.0:
            vector[0] = length = 1.0
        return vector / length
