"""Rotations of the plane and of space alike, as pairs: their logarithms, exponentials and powers.

A rotation is (..., d, d, 2); its logarithm, principal, the angle (..., 1, 2) in the plane and the rotation vector
(..., 3, 2) in space.
"""

from __future__ import annotations

from affinecert.fast import _wide as wide
from affinecert.fast import _wide_rotation as space
from affinecert.fast._kernel import Array


def logarithm(rotation: Array) -> Array:
    """The principal logarithm; at pi the angle is positive, or the first component of the vector that is not 0."""
    if rotation.shape[-2] == 2:
        return space.angle(rotation)[..., None, :]
    return space.rotation_vector(rotation)


def exponential(turn: Array) -> Array:
    """The rotation of a logarithm, which may be any."""
    if turn.shape[-2] == 1:
        return space.plane_rotation(turn[..., 0, :])
    return space.rotation(turn)


def power(rotation: Array, t: Array) -> Array:
    """The principal power R^t for float64 t (...)."""
    return exponential(wide.times(logarithm(rotation), t[..., None]))
