"""Pairs of poses and laws of morphs, with which the claims of sections 1 to 4 are tried."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import combinations
from typing import Any

import numpy as np

from affinecert.errors import InputError
from affinecert.properties.claims.draws import affine, arrays, rotations
from affinecert.properties.claims.precision import distance, mp
from affinecert.properties.matrix.laws import LAWS
from affinecert.properties.matrix.motion import Motion
from affinecert.reference import morphs, sam
from affinecert.reference._matrices import Array, Context, Number, homogeneous, identity, scalar

Morph = Callable[[Context, Array, Array, Array], Array]
Pair = tuple[Array, Array]

steady: Morph = sam.morph
"""The steady affine morph (C B^-1)^t B."""


def at(morph: Morph, pair: Pair, t: Number) -> Array:
    """The pose of a morph between two poses at a time."""
    return morph(mp, *pair, scalar(mp.mpf(t)))


def law(name: str) -> Callable[[Morph, Pair], Number]:
    """The residual of a law of the law matrix, as a deviation: how far a morph between two poses is from keeping it."""
    residual = next(each.residual for each in LAWS if each.name == name)

    def deviation(morph: Morph, pair: Pair) -> Number:
        def ask(start: Any, end: Any, t: float) -> Any:
            return np.array([at(morph, each, t) for each in zip(start, end, strict=True)], dtype=object)

        start, end = pair
        return residual(Motion(ask, start[None], end[None], np.array([True])))[0]

    return deviation


unsteadiness = law("steady")
"""How much the step M(t + 1/4) M(t)^-1 changes with t: the residual of equation 1."""


def unlike_steady(morph: Morph, pair: Pair) -> Number:
    """How far a morph between two poses is from the steady one."""
    return max(distance(at(morph, pair, t), at(steady, pair, t)) for t in (1, 0.5, 0.25))


def unit(dimension: int) -> Array:
    """The pose that is the identity, of the plane or of space."""
    return identity(mp, dimension + 1)


QUARTER = affine([[0, -1], [1, 0]], [0, 0])
"""The quarter turn of the plane about the origin."""


@cache
def general_pairs(dimension: int, count: int = 3) -> list[Pair]:
    """Pairs of poses in general position between which all morphs exist, no two with a half turn between them."""
    drawn = arrays(f"poses {dimension}", 60, (2, dimension, dimension + 1), -1.5, 1.5)
    found = [_SIMPLE[dimension]]
    for start, end in drawn:
        pair = affine(start[:, :-1], start[:, -1]), affine(end[:, :-1], end[:, -1])
        if len(found) < count and _related(pair):
            found.append(pair)
    return found


@cache
def rigid_pairs() -> list[Pair]:
    """Pairs of rigid poses of space, less than half a turn apart."""
    turns = rotations("rigid pairs", 4)
    shifts = arrays("rigid shifts", 4, (3,), -2, 2)
    poses = [homogeneous(mp, turn, shift) for turn, shift in zip(turns, shifts, strict=True)]
    quarter = affine([[0, -1, 0], [1, 0, 0], [0, 0, 1]], [1, 0, 1])
    return [(unit(3), quarter), (unit(3), poses[3]), *combinations(poses[:3], 2)]


_SIMPLE = {
    2: (affine([[1, 0.5], [0, 1]], [0, 0]), affine([[0, -1], [1, 1]], [2, 1])),
    3: (affine([[1, 0, 0], [0, 1, 0.5], [0, 0, 1]], [0, 0, 0]), affine([[0, -1, 0], [1, 1, 0], [0, 0, 2]], [2, 1, 1])),
}


def _related(pair: Pair) -> bool:
    """Whether the steady morph and that of Alexa (2002) exist between two poses, which are not too flat."""
    try:
        poses = at(steady, pair, 0.5), at(morphs.alexa_2002, pair, 0.5)
    except InputError:
        return False
    return all(np.max(np.abs(pose.astype(float))) < 8 for pose in poses)
