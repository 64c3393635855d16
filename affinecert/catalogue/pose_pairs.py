"""Pairs of poses to morph between, by what is difficult in the way from one to the other; in the plane and in space.

Where the angle between two poses matters, both are made of the same few factors, so that every morph's notion of that
angle (of the polar factors of C B^-1, of those of B and of C, of their aligned edges) agrees: B = s R and C = Q R D,
with a scale s, a rotation R, the turn Q and a diagonal matrix D.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from affinecert.catalogue import spectra, turns
from affinecert.catalogue.times import about_time, timed
from affinecert.draw import Draw
from affinecert.map import Array, Point, Regime
from affinecert.sampling import any_rotation, half_turns, homogeneous, quarter_turns, signed, vector, well_conditioned

Ends = tuple[Array, Array, float]
"""Two poses, and the distance to what makes them difficult."""


@dataclass(frozen=True)
class Pair:
    """What a regime draws its two poses from, given the dimension, 2 or 3."""

    name: str
    distance: str
    build: Callable[[Draw, int], Ends]
    share: float = 1.0


def regimes(pairs: Iterable[Pair], sizes: Iterable[int] = (2, 3), share: float = 1.0) -> tuple[Regime, ...]:
    """A regime for each pair and dimension, at a time in [0, 1]; ``share`` multiplies each one's own."""
    return timed(_untimed(pair, size, share) for size in sizes for pair in pairs)


def about_times(pair: Pair, sizes: Iterable[int] = (2, 3), share: float = 1.0) -> tuple[Regime, ...]:
    """The regimes about the time, for the poses of one pair in each dimension."""
    return tuple(
        replace(regime, share=share * pair.share)
        for size in sizes
        for regime in about_time(_untimed(pair, size, share), f"-{size}d")
    )


def _untimed(pair: Pair, size: int, share: float) -> Regime:
    def build(draw: Draw) -> Point:
        start, end, distance = pair.build(draw, size)
        return Point((start, end), distance)

    return Regime(f"{pair.name}-{size}d", build, pair.distance, share * pair.share)


def placed(draw: Draw, linear: Array) -> Array:
    """A pose of that linear part."""
    return homogeneous(linear, vector(draw, size=len(linear)))


def _turn(draw: Draw, size: int, gap: float) -> Array:
    """A rotation by pi - gap."""
    if size == 3:
        return turns.short_of_pi(draw.direction(3), gap, gap).matrix
    sine = draw.choice((1.0, -1.0)) * math.sin(gap)
    return np.array([[-math.cos(gap), -sine], [sine, -math.cos(gap)]])


def _short_turn(draw: Draw, size: int) -> tuple[Array, float]:
    """A rotation by at most 3 radians, and its angle."""
    angle = draw.uniform(0.0, 3.0)
    if size == 3:
        return turns.about(draw.direction(3), angle, angle).matrix, angle
    sine = draw.choice((1.0, -1.0)) * math.sin(angle)
    return np.array([[math.cos(angle), -sine], [sine, math.cos(angle)]]), angle


def _diagonal(draw: Draw, size: int) -> Array:
    return np.diag([draw.uniform(0.5, 2.0) for _ in range(size)])


def _generic(draw: Draw, size: int) -> Ends:
    start, end = placed(draw, well_conditioned(draw, size)), placed(draw, well_conditioned(draw, size))
    return start, end, float(np.linalg.norm(end - start))


def _near_identity(draw: Draw, size: int) -> Ends:
    start, gap = placed(draw, well_conditioned(draw, size)), draw.exponent(-16, -1)
    step = homogeneous(np.eye(size) + gap * draw.direction(size * size).reshape(size, size), gap * draw.direction(size))
    return start, step @ start, gap


def _equal(draw: Draw, size: int) -> Ends:
    start = placed(draw, well_conditioned(draw, size))
    return start, start.copy(), float(np.linalg.norm(start))


def _near_pi(draw: Draw, size: int) -> Ends:
    # Poses tell the angle between them to a few u; none closer to pi than 1e-12 is surely on its side of the jump.
    gap, rotation = draw.exponent(-12, 0), any_rotation(draw, size)
    end = _turn(draw, size, gap) @ rotation @ _diagonal(draw, size)
    return placed(draw, draw.uniform(0.5, 2.0) * rotation), placed(draw, end), gap


def _exact_half_turn(draw: Draw, size: int) -> Array:
    return -np.eye(2) if size == 2 else draw.choice(half_turns())


def _at_pi(draw: Draw, size: int) -> Ends:
    # All of it exact, so that the angle is pi to the last bit, and found so where nothing is rounded.
    rotation, scale = draw.choice(quarter_turns(size)), 2.0 ** draw.choice(range(-3, 4))
    stretch = np.diag([2.0 ** draw.choice(range(-3, 4)) for _ in range(size)])
    start, end = scale * rotation, _exact_half_turn(draw, size) @ rotation @ stretch
    return placed(draw, start), placed(draw, end), scale


def _one_pose_near_pi(draw: Draw, size: int) -> Ends:
    """One of the poses turned by nearly pi against the identity, the other by little; both similar to it."""
    gap, (small, _) = draw.exponent(-12, 0), _short_turn(draw, size)
    far, near = _turn(draw, size, gap) * draw.uniform(0.5, 2.0), small * draw.uniform(0.5, 2.0)
    first, last = draw.choice(((far, near), (near, far)))
    return placed(draw, first), placed(draw, last), gap


def _one_pose_at_pi(draw: Draw, size: int) -> Ends:
    far, scale = _exact_half_turn(draw, size), 2.0 ** draw.choice(range(-3, 4))
    near = scale * draw.choice(quarter_turns(size)[:2])
    first, last = draw.choice(((far, near), (near, far)))
    return placed(draw, first), placed(draw, last), scale


def _pure_translation(draw: Draw, size: int) -> Ends:
    linear, size_of_way = well_conditioned(draw, size), draw.exponent(-3, 3)
    return placed(draw, linear), homogeneous(linear, size_of_way * draw.direction(size)), size_of_way


def _rigid(draw: Draw, size: int) -> Ends:
    start, (turn, angle) = any_rotation(draw, size), _short_turn(draw, size)
    return placed(draw, start), placed(draw, turn @ start), angle


def _similar(draw: Draw, size: int) -> Ends:
    start, (turn, _), scale = any_rotation(draw, size), _short_turn(draw, size), 10.0 ** signed(draw, -8, 0.5)
    return placed(draw, draw.exponent(-3, 3) * start), placed(draw, scale * turn @ start), abs(scale - 1)


def _sheared(draw: Draw, size: int) -> Ends:
    """The end sheared against the start, which turns it by less than pi/2."""
    amount, linear = signed(draw, -8, 1), well_conditioned(draw, size)
    shear = np.eye(size)
    shear[0, size - 1] = amount
    return placed(draw, linear), placed(draw, shear @ linear), abs(amount)


def _stretched(draw: Draw, size: int) -> Ends:
    """Poses one of which, or both, are thin; their singular values are up to a million apart."""
    thinness = draw.exponent(-6, 0)
    thin, other = (well_conditioned(draw, size) @ np.diag([x] + [1.0] * (size - 1)) for x in (thinness, 1.0))
    other = other @ np.diag(draw.choice(([1.0] * size, [1.0] * (size - 1) + [thinness])))
    first, last = draw.choice(((thin, other), (other, thin)))
    return placed(draw, first), placed(draw, last), thinness


def _far(draw: Draw, size: int) -> Ends:
    start, end, _ = _generic(draw, size)
    length = draw.exponent(-100, 100)
    start[:-1, -1], end[:-1, -1] = (length * draw.direction(size) for _ in range(2))
    return start, end, length


def _logarithmic(draw: Draw, size: int) -> Ends:
    """Poses that have a logarithm each."""
    (first, gap), (last, _) = spectra.GENERIC.build(draw, size), spectra.GENERIC.build(draw, size)
    return placed(draw, first), placed(draw, last), gap


def _logarithmic_by(kind: spectra.Spectrum) -> Callable[[Draw, int], Ends]:
    """A pose of that spectrum, and one that has a logarithm."""

    def build(draw: Draw, size: int) -> Ends:
        (pose, distance), (other, _) = kind.build(draw, size), spectra.GENERIC.build(draw, size)
        first, last = draw.choice(((pose, other), (other, pose)))
        return placed(draw, first), placed(draw, last), distance

    return build


def _not_affine(draw: Draw, size: int) -> Ends:
    """One pose reflected or projected, or of another last row."""
    start, end, distance = _generic(draw, size)
    bad = draw.choice((start, end))
    if draw.choice((True, False)):
        bad[-1, draw.choice(range(size + 1))] += draw.exponent(-15, 0)
    else:
        bad[draw.choice(range(size))] *= draw.choice((-1.0, 0.0))
    return start, end, distance


GENERIC = Pair("generic", "difference of the poses", _generic)
NEAR_IDENTITY = Pair("near-identity", "difference of the poses", _near_identity)
EQUAL = Pair("equal", "size of the poses", _equal)
NEAR_PI = Pair("near-pi", "pi - angle", _near_pi)
AT_PI = Pair("at-pi", "scale", _at_pi)
ONE_POSE_NEAR_PI = Pair("one-pose-near-pi", "pi - angle", _one_pose_near_pi)
ONE_POSE_AT_PI = Pair("one-pose-at-pi", "scale", _one_pose_at_pi)
PURE_TRANSLATION = Pair("pure-translation", "length of the way", _pure_translation)
RIGID = Pair("rigid", "angle", _rigid)
SIMILAR = Pair("similar", "|ratio of the scales - 1|", _similar)
SHEARED = Pair("sheared", "shear", _sheared)
STRETCHED = Pair("stretched", "thinness", _stretched)
FAR = Pair("tiny-next-to-huge", "length of the translations", _far)
LOGARITHMIC = Pair("generic", "gap of two eigenvalues", _logarithmic)
OUTSIDE = Pair("outside", "difference of the poses", _not_affine, share=0.5)

WITH_LOGARITHMS = (
    LOGARITHMIC,
    *(
        Pair(kind.name, kind.distance, _logarithmic_by(kind), kind.share)
        for kind in (
            spectra.NEAR_IDENTITY,
            spectra.PURE_TRANSLATION,
            spectra.UNIT_EIGENVALUE,
            spectra.COALESCING,
            spectra.DEFECTIVE,
            spectra.ROTATION,
            spectra.NEAR_MINUS_ONE,
            spectra.NO_LOGARITHM,
        )
    ),
    ONE_POSE_AT_PI,
)
"""Poses by the logarithms that they have themselves."""
