"""Unit quaternions (w, x, y, z): interpolation along the shorter great arc.

Everything is computed in double-double arithmetic and rounded once.

Source: Shoemake, "Animating rotation with quaternion curves", 1985.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array, checked
from affinecert.fast._stages import refuse
from affinecert.fast._wide_vectors import inner

NOT_UNIT = "not a unit quaternion: its length is further than 1e-6 from 1"

# A quaternion counts as a unit one up to this distance of its length from 1: rounding to float32 leaves under 2e-7.
UNIT_TOLERANCE = 1e-6

# Inner products of two unit quaternions are known to 2^-102; below this their sign is decided exactly.
DOUBTFUL = 2.0**-98


def slerp(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The point at t on the shorter great arc from p (start) to q (end) or -q.

    start and end (..., 4), within 1e-6 of length 1 and normalised first, and t (...), any number; gives (..., 4):
    (sin((1 - t) a) p + sin(t a) q) / sin a, a the angle between them. A negative p . q takes -q for q, one that is
    exactly 0 takes q as it is. Raises InputError for a wrong shape or dtype, numbers that are not finite, and another
    length.

    >>> slerp([1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0], 1 / 3).round(15)  # a third of half a turn about z
    array([0.8660254, 0.       , 0.       , 0.5      ])
    """
    first, last, time = checked({"start": (4,), "end": (4,), "t": ()}, (start, end, t))[0]
    p, q = _unit("start", first), _unit("end", last)
    sign = _sign(first, last, inner(p, q)[..., 0])
    q = q * sign[..., None, None]
    apart, together = (wide.square_root(inner(x, x)) for x in (wide.subtract(p, q), wide.add(p, q)))
    angle = 2.0 * wide.arctangent2(apart, together)
    rest = wide.subtract(wide.widen(np.array(1.0)), wide.widen(time))
    parts = (wide.multiply(p, _weight(angle, rest)), wide.multiply(q, _weight(angle, wide.widen(time))))
    return wide.rounded(wide.add(*parts))


def _unit(name: str, q: Array) -> Array:
    """The quaternions divided by their lengths, as pairs; refuses those that are no unit quaternions."""
    pairs = wide.widen(q)
    length = wide.square_root(inner(pairs, pairs))
    good = np.abs(wide.subtract(length, wide.widen(np.array(1.0)))[..., 0]) <= UNIT_TOLERANCE
    refuse(good.astype(np.float64), 0.0, name, NOT_UNIT, good.shape)
    return wide.divide(pairs, length[..., None, :])


def _sign(p: Array, q: Array, product: Array) -> Array:
    """The sign of inner products, 1 for 0."""
    sign = np.where(np.abs(product) <= DOUBTFUL, np.nan, np.where(product < 0.0, -1.0, 1.0))
    for index in map(tuple, np.argwhere(np.isnan(sign))):
        pairs = (np.broadcast_to(x, (*sign.shape, 4))[index].tolist() for x in (p, q))
        exact = sum(Fraction(x) * Fraction(y) for x, y in zip(*pairs, strict=True))
        sign[index] = -1.0 if exact < 0 else 1.0
    return sign


def _weight(angle: Array, t: Array) -> Array:
    """sin(t angle) / sin(angle), which is t without any angle; (..., 1, 2)."""
    still = angle[..., 0] == 0.0
    sine, whole = wide.sine_cosine(wide.multiply(t, angle))[0], wide.sine_cosine(angle)[0]
    weight = wide.divide(sine, np.where(still[..., None], 1.0, whole))
    return np.asarray(np.where(still[..., None], t, weight)[..., None, :])
