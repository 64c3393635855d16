"""Symmetric matrices of space by their eigenvalues: where these meet, vanish next to one another, or turn negative.

The block [[r, k], [k, r]] has the eigenvalues r + k and r - k, told exactly by two floats however close they are. A
rotated frame mixes all entries and rounds them, which moves eigenvalues by some 1e-16 of the largest.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from affinecert.draw import Draw
from affinecert.map import Array, Point, Regime
from affinecert.sampling import any_rotation, eighths, off_by_ulps, permuted, signed

Stretch = tuple[Array, float]
"""A symmetric matrix, (3, 3), and its distance to what makes it difficult."""


@dataclass(frozen=True)
class Stretches:
    """What a regime draws its symmetric matrices from; ``name`` and ``distance`` become the regime's."""

    name: str
    distance: str
    build: Callable[[Draw], Stretch]
    share: float = 1.0

    def regime(self) -> Regime:
        """The regime of a map of one such matrix."""

        def build(draw: Draw) -> Point:
            matrix, distance = self.build(draw)
            return Point((matrix,), distance)

        return Regime(self.name, build, self.distance, self.share)


def rotated(draw: Draw, eigenvalues: tuple[float, ...]) -> Array:
    """A symmetric matrix with these eigenvalues, up to rounding, and any eigenvectors."""
    frame = any_rotation(draw)
    matrix = frame @ np.diag(eigenvalues) @ frame.T
    return np.asarray((matrix + matrix.T) / 2)


def _block(draw: Draw, mean: float, half_gap: float, third: float) -> Array:
    """A symmetric matrix with the eigenvalues mean +- half_gap and third exactly."""
    matrix = np.diag([mean, mean, third])
    matrix[0, 1] = matrix[1, 0] = half_gap
    return permuted(draw, matrix)


def _direction(draw: Draw) -> Array:
    """A symmetric matrix whose entries have length 1 together."""
    matrix = draw.direction(9).reshape(3, 3)
    matrix = matrix + matrix.T
    return np.asarray(matrix / np.linalg.norm(matrix))


def _any(draw: Draw) -> Stretch:
    eigenvalues = tuple(draw.uniform(-3.0, 3.0) for _ in range(3))
    return rotated(draw, eigenvalues), max(map(abs, eigenvalues))


def _positive(draw: Draw) -> Stretch:
    eigenvalues = tuple(draw.exponent(-1, 1) for _ in range(3))
    return rotated(draw, eigenvalues), min(eigenvalues) / max(eigenvalues)


def _pair(draw: Draw) -> Stretch:
    # Means and the third are multiples of 1/8 at least 1/2 apart from 0; half a gap stays below them.
    mean, third, half_gap = eighths(draw, 8, 24), eighths(draw, 4, 32), draw.exponent(-16, -0.4)
    if draw.choice((True, False)):
        return _block(draw, mean, signed(draw, -300, -0.4), third), half_gap
    return rotated(draw, (mean - half_gap, mean + half_gap, third)), half_gap


def _triple(draw: Draw) -> Stretch:
    mean, gap = draw.exponent(-1, 1), draw.exponent(-16, -0.5)
    return mean * (np.eye(3) + gap * _direction(draw)), gap


def _near_identity(draw: Draw) -> Stretch:
    # Moved by less than 0.4, the identity stays positive definite.
    gap = draw.exponent(-16, -0.5)
    return np.eye(3) + gap * _direction(draw), gap


def _near_zero(low: float, high: float) -> Callable[[Draw], Stretch]:
    def build(draw: Draw) -> Stretch:
        size = draw.exponent(low, high)
        return size * _direction(draw), size

    return build


def _huge_exponents(draw: Draw) -> Stretch:
    eigenvalues = tuple(signed(draw, 1, math.log10(700.0)) for _ in range(3))
    return rotated(draw, eigenvalues), max(map(abs, eigenvalues))


def _diagonal_exponents(draw: Draw) -> Stretch:
    eigenvalues = [signed(draw, -300, math.log10(700.0)) for _ in range(3)]
    return np.diag(eigenvalues), max(map(abs, eigenvalues))


def _ill_conditioned(draw: Draw) -> Stretch:
    # Rounding moves eigenvalues by some 1e-16, and leaves those of 1e-14 positive.
    eigenvalues = (1.0, draw.exponent(-14, 0), draw.exponent(-14, 0))
    return rotated(draw, eigenvalues), min(eigenvalues)


def _graded(draw: Draw) -> Stretch:
    sizes = np.array([draw.exponent(-60, 60) for _ in range(3)])
    matrix, _ = _positive(draw)
    return np.outer(sizes, sizes) * matrix, float((min(sizes) / max(sizes)) ** 2)


def _diagonal(draw: Draw) -> Stretch:
    eigenvalues = [draw.exponent(-150, 150) for _ in range(3)]
    return np.diag(eigenvalues), min(eigenvalues) / max(eigenvalues)


def _huge_or_tiny(draw: Draw) -> Stretch:
    scale = draw.exponent(-150, 150)
    return scale * _positive(draw)[0], scale


def _gram(draw: Draw) -> Stretch:
    """M^T M, exactly, for an integer matrix M of determinant 1: its eigenvalues multiply to 1.

    M is a product of six shears, by 16 at most: its entries are at most 17^6 < 2^25, and those of M^T M below 2^53.
    """
    matrix, inverse = np.eye(3), np.eye(3)
    for row, column in ((1, 0), (2, 0), (2, 1), (0, 1), (0, 2), (1, 2)):
        shear = np.eye(3)
        shear[row, column] = draw.choice((1.0, -1.0)) * round(draw.exponent(0, 1.2))
        matrix, inverse = matrix @ shear, (2 * np.eye(3) - shear) @ inverse
    return matrix.T @ matrix, float((np.linalg.norm(matrix, 2) * np.linalg.norm(inverse, 2)) ** -2)


def _asymmetric(kind: Callable[[Draw], Stretch]) -> Callable[[Draw], Stretch]:
    """Matrices of that kind, symmetric but for rounding: by last places, or by what rounding to float32 leaves."""

    def build(draw: Draw) -> Stretch:
        matrix, _ = kind(draw)
        if draw.choice((True, False)):
            return off_by_ulps(draw, matrix, 4), float(np.finfo(np.float64).eps)
        # |A - A^T| is at most 2 noise |A|, below the 1e-6 |A| that is allowed.
        noise = draw.exponent(-16, -7)
        return matrix + noise * np.linalg.norm(matrix, 2) * draw.direction(9).reshape(3, 3), noise

    return build


def _not_symmetric(draw: Draw) -> Stretch:
    size, (matrix, _) = draw.exponent(-5, 3), _positive(draw)
    x, y, z = size * float(np.linalg.norm(matrix)) * draw.direction(3)
    return matrix + np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]), size


def _not_positive_definite(draw: Draw) -> Stretch:
    fault = draw.choice(("negative", "singular", "last bit"))
    if fault == "negative":
        # Rounding leaves an eigenvalue of -1e-14 negative.
        least = -draw.exponent(-14, 0)
        return rotated(draw, (1.0, draw.exponent(-1, 1), least)), -least
    if fault == "singular":
        columns = np.array([[eighths(draw, -16, 16) for _ in range(2)] for _ in range(3)])
        return columns @ columns.T, 0.0
    # The determinant is 1 less a cofactor, which is a positive integer.
    matrix, distance = _gram(draw)
    place = draw.choice(range(3))
    matrix[place, place] -= 1.0
    return matrix, distance


def _not_a_stretch(draw: Draw) -> Stretch:
    return draw.choice((_not_symmetric, _not_positive_definite))(draw)


GENERIC = Stretches("generic", "ratio of the extreme eigenvalues", _positive)
MEETING = Stretches("meeting", "half the gap of two eigenvalues", _pair)
TRIPLE = Stretches("triple", "spread of the eigenvalues", _triple)
NEAR_IDENTITY = Stretches("near-identity", "distance from the identity", _near_identity)
ILL_CONDITIONED = Stretches("ill-conditioned", "ratio of the extreme eigenvalues", _ill_conditioned)
GRADED = Stretches("graded", "ratio of the extreme eigenvalues", _graded)
LAST_BITS = Stretches("last-bits", "ratio of the extreme eigenvalues", _gram)
DIAGONAL = Stretches("diagonal", "ratio of the extreme eigenvalues", _diagonal)
HUGE_OR_TINY = Stretches("huge-or-tiny", "scale", _huge_or_tiny)
ASYMMETRIC = Stretches("asymmetric", "distance from symmetric", _asymmetric(_positive))
OUTSIDE = Stretches("outside", "size of what is wrong", _not_a_stretch, share=0.5)

POSITIVE_DEFINITE = (
    GENERIC,
    MEETING,
    TRIPLE,
    NEAR_IDENTITY,
    ILL_CONDITIONED,
    GRADED,
    LAST_BITS,
    DIAGONAL,
    HUGE_OR_TINY,
    ASYMMETRIC,
    OUTSIDE,
)
"""What a logarithm is tried on."""

SYMMETRIC = (
    Stretches("generic", "largest eigenvalue", _any),
    MEETING,
    TRIPLE,
    Stretches("near-zero", "size", _near_zero(-16, 0)),
    Stretches("tiny", "size", _near_zero(-300, -16)),
    Stretches("huge", "largest eigenvalue", _huge_exponents),
    Stretches("diagonal", "largest eigenvalue", _diagonal_exponents),
    Stretches("asymmetric", "distance from symmetric", _asymmetric(_any)),
    Stretches("outside", "distance from symmetric", _not_symmetric, share=0.25),
)
"""What an exponential is tried on."""
