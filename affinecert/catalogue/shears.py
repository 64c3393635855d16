"""Shears by their eigenvalues: 1, alpha_2 and alpha_5, drawn as 0 and two logarithms at any gap down to equality."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from affinecert.draw import Draw
from affinecert.map import Array
from affinecert.sampling import signed


@dataclass(frozen=True)
class Shears:
    """What a regime draws its shears from.

    ``logarithms`` draws log alpha_2, log alpha_5 and the distance; the entries off the diagonal have sizes 10**e, e in
    ``sizes``.
    """

    name: str
    distance: str
    logarithms: Callable[[Draw], tuple[float, float, float]]
    sizes: tuple[float, float] = (-2, 1)


def off_diagonal(kind: Shears, draw: Draw) -> list[float]:
    """The entries 1, 3 and 4."""
    return [signed(draw, *kind.sizes) for _ in range(3)]


def twist(kind: Shears, draw: Draw) -> tuple[Array, float]:
    """The (a1, ..., a5) of a kind, (5,), and its distance."""
    second, fifth, distance = kind.logarithms(draw)
    first, third, fourth = off_diagonal(kind, draw)
    return np.array([first, second, third, fourth, fifth]), distance


def matrix(kind: Shears, draw: Draw) -> tuple[Array, float]:
    """A shear of a kind, (3, 3), and its distance."""
    second, fifth, distance = kind.logarithms(draw)
    first, third, fourth = off_diagonal(kind, draw)
    return assemble(np.array([first, math.exp(second), third, fourth, math.exp(fifth)])), distance


def assemble(alpha: Array) -> Array:
    """The shear of (alpha_1, ..., alpha_5), (3, 3)."""
    first, second, third, fourth, fifth = alpha
    return np.array([[1.0, first, third], [0.0, second, fourth], [0.0, 0.0, fifth]])


def _generic(draw: Draw) -> tuple[float, float, float]:
    second, fifth = draw.uniform(-2, 2), draw.uniform(-2, 2)
    return second, fifth, abs(second - fifth)


def _near_identity(draw: Draw) -> tuple[float, float, float]:
    size = draw.exponent(-16, -1)
    return size * draw.uniform(-1, 1), size * draw.uniform(-1, 1), size


def _coalescing(draw: Draw) -> tuple[float, float, float]:
    second, gap = draw.uniform(-2, 2), signed(draw, -16, 0)
    return second, second + gap, abs(gap)


def _one_coalescing(draw: Draw) -> tuple[float, float, float]:
    gap, other = signed(draw, -16, 0), draw.uniform(-2, 2)
    return (*draw.choice(((gap, other), (other, gap))), abs(gap))


def _all_coalescing(draw: Draw) -> tuple[float, float, float]:
    second, gap = signed(draw, -16, 0), signed(draw, -16, 0)
    return second, draw.choice((gap, second + gap)), min(abs(second), abs(gap))


def _defective(draw: Draw) -> tuple[float, float, float]:
    value = draw.uniform(-2, 2)
    return (*draw.choice(((value, value), (0.0, value), (value, 0.0), (0.0, 0.0))), abs(value))


def _huge(draw: Draw) -> tuple[float, float, float]:
    # log(1e150) = 345.4
    second, fifth = draw.uniform(-345, 345), draw.uniform(-345, 345)
    return second, fifth, max(abs(second), abs(fifth))


def _tiny(draw: Draw) -> tuple[float, float, float]:
    size = draw.exponent(-290, -16)
    return size * draw.choice((1.0, -1.0, 0.0)), size * draw.uniform(-1, 1), size


GENERIC = Shears("generic", "gap of the eigenvalues", _generic)
NEAR_IDENTITY = Shears("near-identity", "size of the logarithms", _near_identity, (-16, 0))
COALESCING = Shears("coalescing", "gap of the last two eigenvalues", _coalescing)
ONE_COALESCING = Shears("coalescing-with-first", "gap to the first eigenvalue", _one_coalescing)
ALL_COALESCING = Shears("all-coalescing", "smallest gap of the eigenvalues", _all_coalescing)
DEFECTIVE = Shears("defective", "gap to the third eigenvalue", _defective)
HUGE = Shears("huge", "largest logarithm", _huge)
TINY_NEXT_TO_HUGE = Shears("tiny-next-to-huge", "gap of the last two eigenvalues", _coalescing, (-100, 100))
TINY = Shears("tiny", "size of the logarithms", _tiny, (-290, -16))

ALL = (
    GENERIC,
    NEAR_IDENTITY,
    COALESCING,
    ONE_COALESCING,
    ALL_COALESCING,
    DEFECTIVE,
    HUGE,
    TINY_NEXT_TO_HUGE,
    TINY,
)
