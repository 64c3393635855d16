"""Affine maps and motions from the identity to them, for the properties of section 6."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import distance, mp
from affinecert.properties.claims.rossignac_vinacua.listings import Motion, local_velocity, power
from affinecert.reference import morphs
from affinecert.reference._matrices import Array, Number, identity, scalar

TIMES = tuple(mp.mpf(k) / 4 for k in (0, 1, 3, 4))


def maps() -> list[Array]:
    """Maps of the plane and of space that have a steady motion, 1 being no eigenvalue."""
    return [
        affine([[2, 0], [0, 3]], [1, 1]),
        affine([[0, -1], [1, 0]], [4, 2]),
        affine([[-2, 0], [0, -2]], [1, -3]),
        affine([[2, 1], [0, 2]], [1, 1]),
        affine([[1.5, 0.5], [-0.5, 0.75]], [2, 1]),
        affine([[1, 0.5, 0], [-0.5, 1, 0.25], [0, 0, 1.5]], [1, 0, 1]),
        affine([[2, 1, 0.5], [0.25, 3, -1], [0, 0.5, 4]], [1, 2, -1]),
    ]


def singular_maps() -> list[Array]:
    """Maps with the eigenvalue 1 that have no fixed point, nor a shear across their translation."""
    return [
        affine([[1, 0], [0, 1]], [2, 1]),
        affine([[1, 0], [0, 2]], [1, 3]),
        affine([[1, 1], [0, 2]], [2, 1]),
        affine([[1, 1], [0, 1]], [3, 0]),
    ]


def parabolic_maps() -> list[Array]:
    """Shears of the plane with a translation across: all points go along parabolas."""
    return [affine([[1, 1], [0, 1]], [0, 1]), affine([[3, 4], [-1, -1]], [1, 1])]


def all_maps() -> list[Array]:
    """All of these."""
    return [*maps(), *singular_maps(), *parabolic_maps()]


def steady_motion(end: Array) -> Motion:
    """A^t."""
    return partial(power, end)


def by(name: str) -> Callable[[Array], Motion]:
    """The morph of that name from the identity, as a map of its end."""

    def motion(end: Array) -> Motion:
        return lambda t: morphs.MORPHS[name](mp, identity(mp, len(end)), end, scalar(mp.mpf(t)))

    return motion


def field(motion: Motion, t: Number) -> Array:
    """The velocity field of a motion at a time in the fixed frame, M' M^-1, a homogeneous matrix with last row zero."""
    velocity: Array = definitions.derivative(mp, motion, t) @ definitions.inverse(mp, motion(t))
    return velocity


def unsteadiness(make: Callable[[Array], Motion], end: Array) -> Number:
    """How far the velocity in the moving frame at later times is from that at 0."""
    motion = make(end)
    start = local_velocity(motion, mp.zero)
    return max(distance(local_velocity(motion, t), start) for t in TIMES[1:])


def change_of_field(make: Callable[[Array], Motion], end: Array) -> Number:
    """How far the velocity field at later times is from that at 0."""
    motion = make(end)
    start = field(motion, mp.zero)
    return max(distance(field(motion, t), start) for t in TIMES[1:])


def has_eigenvalue_1(end: Array) -> bool:
    """Whether there are several fixed points or none."""
    linear = end[:-1, :-1]
    return not definitions.determinant(linear - np.eye(len(linear), dtype=int).astype(object))
