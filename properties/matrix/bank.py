"""The pairs of poses that the law matrix is tried on, from simple to complex: the same ones in every run.

Simple ones are all the pairs of a few small whole matrices; the others are drawn, some for each domain and for each
premise of a law. Pairs astride a turn by pi, which serve the law of continuity alone, come last.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from affinecert.map import Array
from affinecert.properties.matrix.algebra import Mask
from affinecert.properties.matrix.domains import holding
from affinecert.sampling import homogeneous
from affinecert.shrink import total

Linear = tuple[Array, Array]
"""The linear parts of B and C."""

GAP = 2.0**-40
"""What pairs next to each other differ by, about 1e-12: a short number, and exact in products with short numbers."""


@dataclass(frozen=True)
class Bank:
    """Pairs of poses of one dimension, (pairs, n, n) each, and next to each of them another.

    ``within`` tells for each domain, by name, which pairs belong to it; ``astride`` which ones have a turn by pi
    between them and their neighbours.
    """

    start: Array
    end: Array
    next_start: Array
    next_end: Array
    astride: Mask
    within: Mapping[str, Mask]


def _turn(size: int, i: int, j: int, cosine: float, sine: float) -> Array:
    """A turn in a coordinate plane, from axis i to axis j."""
    matrix = np.eye(size)
    matrix[i, i] = matrix[j, j] = cosine
    matrix[j, i], matrix[i, j] = sine, -sine
    return matrix


def _sheared(size: int, i: int, j: int) -> Array:
    matrix = np.eye(size)
    matrix[i, j] = 1.0
    return matrix


def _stretched(*factors: float) -> Array:
    return np.diag(np.array(factors))


def _simple_parts(size: int) -> tuple[list[Array], list[Array]]:
    """Small whole linear parts: those of starts, and those of ends."""
    rest = (1.0,) * (size - 2)
    identity, quarter, half = np.eye(size), _turn(size, 0, 1, 0.0, 1.0), _turn(size, 0, 1, -1.0, 0.0)
    stretch, shear = _stretched(2.0, 1.0, *rest), _sheared(size, 0, 1)
    slanted = _turn(size, 0, 1, 1.0, 1.0)
    # Of eigenvalues -1 and -2, and yet turning by three quarters of pi only.
    negative = np.eye(size)
    negative[:2, :2] = [[0.0, -2.0], [1.0, -3.0]]
    ends = [
        identity,
        2 * identity,
        stretch,
        _stretched(2.0, 0.5, *rest),
        shear,
        shear.T,
        quarter,
        quarter.T,
        quarter @ stretch,
        half,
        half @ stretch,
        half @ shear,
        negative,
    ]
    if size == 2:
        return [identity, stretch, shear, quarter, half, slanted], [*ends, slanted, slanted.T, half @ slanted]
    other = _turn(3, 1, 2, 0.0, 1.0)
    return [identity, stretch, shear, quarter, other], [*ends, other, other @ quarter, _sheared(3, 1, 2), slanted]


def _simple(size: int) -> Iterator[tuple[Array, Array]]:
    """Pairs of poses of small whole numbers, the end carried along the first axis."""
    starts, ends = _simple_parts(size)
    first, last = np.eye(size)[0], np.eye(size)[-1]
    for start in starts:
        for end in ends:
            yield homogeneous(start, 0 * first), homogeneous(end, first)
    for end in ends:
        yield homogeneous(starts[0], last), homogeneous(end, 0 * first)


class _Drawn:
    """Linear parts drawn at random; each method gives another one at each call."""

    def __init__(self, size: int) -> None:
        self.size = size
        self.generator = np.random.default_rng(size)

    def number(self, low: float, high: float) -> float:
        return float(self.generator.uniform(low, high))

    def vector(self) -> Array:
        return np.asarray(self.generator.uniform(-1.0, 1.0, self.size))

    def rotation(self, largest: float = 3.0, least: float = 0.3) -> Array:
        """A rotation by up to so many radians, and that part of them at least, about any axis."""
        angle = self.number(least, 1.0) * largest
        plain = _turn(self.size, 0, 1, np.cos(angle), np.sin(angle))
        frame = np.linalg.qr(self.generator.normal(size=(self.size, self.size)))[0]
        return np.asarray(frame @ plain @ frame.T)

    def stretch(self) -> Array:
        """A symmetric positive definite matrix."""
        frame = self.rotation()
        return np.asarray(frame @ np.diag(self.generator.uniform(0.5, 2.0, self.size)) @ frame.T)

    def anything(self) -> Array:
        return np.asarray(self.rotation() @ self.stretch())

    def upright(self) -> Array:
        """A matrix that turns no direction by a right angle."""
        wild = self.generator.normal(size=(self.size, self.size))
        return np.asarray(
            self.number(0.5, 2.0) * (np.eye(self.size) + self.number(0.5, 0.9) * wild / np.linalg.norm(wild, 2))
        )

    def similarity(self, largest: float = 3.0) -> Array:
        return self.number(0.5, 2.0) * self.rotation(largest)


def _equal_volume(pair: Linear) -> Linear:
    """The pair with the end scaled to the volume of the start."""
    start, end = pair
    ratio = np.linalg.det(start) / np.linalg.det(end)
    return start, end * ratio ** (1 / len(end))


def _kinds(draw: _Drawn) -> tuple[Callable[[], Linear], ...]:
    """Ways to draw a pair, one or more for each domain and, within it, for what the laws suppose."""
    identity = np.eye(draw.size)

    def by(step: Callable[[], Array], start: Callable[[], Array]) -> Callable[[], Linear]:
        def pair() -> Linear:
            first = start()
            return first, step() @ first

        return pair

    def both(part: Callable[[], Array]) -> Callable[[], Linear]:
        return lambda: (part(), part())

    def fixed() -> Array:
        return identity

    def gentle() -> Array:
        """Upright, and so is its product with a turn by less than 1."""
        return np.asarray(0.3 * draw.upright() + identity)

    def little() -> Array:
        return draw.rotation(0.6)

    def wide() -> Array:
        """A rotation by 2.4 radians or more, after which the way round may be shorter."""
        return draw.rotation(3.0, least=0.8)

    def little_similarity() -> Array:
        return draw.similarity(0.6)

    drawn = (
        both(draw.anything),
        by(draw.upright, draw.anything),
        both(draw.upright),
        by(draw.anything, fixed),
        by(draw.stretch, draw.anything),
        by(draw.stretch, fixed),
        by(fixed, draw.anything),
    )
    similar = (
        by(draw.similarity, draw.anything),
        by(draw.rotation, draw.anything),
        both(draw.similarity),
        both(draw.rotation),
        both(wide),
        by(draw.rotation, draw.similarity),
        by(little, draw.anything),
        by(little_similarity, draw.anything),
        by(little, gentle),
        by(little_similarity, gentle),
        by(draw.rotation, fixed),
        by(draw.similarity, fixed),
    )
    equal = tuple(lambda kind=kind: _equal_volume(kind()) for kind in drawn)
    return (*drawn, *equal, *similar)


DRAWN = 3
"""Pairs of each kind that are drawn."""


def _drawn(size: int) -> Iterator[tuple[Array, Array]]:
    draw = _Drawn(size)
    for kind in _kinds(draw):
        for _ in range(DRAWN):
            start, end = kind()
            exactly = np.array_equal(start, np.eye(size))
            yield homogeneous(start, 0 * draw.vector() if exactly else draw.vector()), homogeneous(end, draw.vector())


def _astride(size: int) -> Iterator[tuple[Array, Array, Array, Array]]:
    """Pairs that turn by pi less a little, and next to them those that turn by pi and a little."""
    quarter, stretch = _turn(size, 0, 1, 0.0, 1.0), _stretched(2.0, *[1.0] * (size - 1))
    identity, shear, shift = np.eye(size), _sheared(size, 0, 1), np.eye(size)[0]
    planes = ((0, 1),) if size == 2 else ((0, 1), (1, 2))

    def placed(start: Array, end: Array) -> tuple[Array, Array]:
        return homogeneous(start, 0 * shift), homogeneous(end, shift)

    for i, j in planes:
        short, beyond = (_turn(size, i, j, -1.0, sign * GAP) for sign in (1.0, -1.0))
        for make in (
            lambda turn: (identity, turn),
            lambda turn: (identity, turn @ stretch),
            lambda turn: (shear, turn @ shear),
            lambda turn: (quarter, turn @ quarter @ stretch),
            lambda turn: (turn, quarter),
            lambda turn: (turn @ stretch, quarter @ stretch),
            lambda turn: (quarter, turn),
            lambda turn: (turn, turn @ stretch),
            lambda turn: (turn, 2 * turn),
            lambda turn: (turn, turn),
        ):
            yield *placed(*make(short)), *placed(*make(beyond))


def _nudged(pose: Array, way: float) -> Array:
    """The poses next to them: turned one way or the other, grown and carried by a little."""
    nudge = np.eye(pose.shape[-1])
    nudge[:-1, :-1] *= 1 + GAP
    nudge[0, 1], nudge[1, 0] = way * GAP, -way * GAP
    nudge[:-1, -1] = GAP
    return nudge @ pose


@cache
def bank(size: int) -> Bank:
    """The pairs of the plane (2) or of space (3), in the order of their complexity."""
    # Adding 0 makes 0 of -0. Of pairs as simple, the one with the simpler start comes first.
    pairs = [(start + 0.0, end + 0.0) for start, end in (*_simple(size), *_drawn(size))]
    ordinary = sorted(pairs, key=lambda pair: (total(pair), total(pair[:1])))
    astride = list(_astride(size))
    start = np.array([*(pair[0] for pair in ordinary), *(both[0] for both in astride)])
    end = np.array([*(pair[1] for pair in ordinary), *(both[1] for both in astride)])
    next_start, next_end = _nudged(start, 1.0), _nudged(end, -1.0)
    next_start[len(ordinary) :] = [both[2] for both in astride]
    next_end[len(ordinary) :] = [both[3] for both in astride]
    about_pi = np.arange(len(start)) >= len(ordinary)
    return Bank(start, end, next_start, next_end, about_pi, holding(start, end))
