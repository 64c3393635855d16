"""pyquaternion: rotation vectors and matrices by way of quaternions, and slerp."""

from __future__ import annotations

from importlib.metadata import version

import numpy as np
from pyquaternion import Quaternion

from affinecert.map import Array
from affinecert.subject import Subject

OFF_MANIFOLD = 1e-6
"""How far a matrix may be from a rotation in the catalogue's domain: an argument of Quaternion(matrix=...)."""


def so3_exp(omega: Array) -> Array:
    """The rotation matrices (N, 3, 3) of rotation vectors (N, 3), by the exponential of pure quaternions."""
    return np.stack([Quaternion.exp(Quaternion(vector=item / 2)).rotation_matrix for item in omega])


def so3_log(rotation: Array) -> Array:
    """The rotation vectors (N, 3) of rotation matrices (N, 3, 3)."""
    turns = [Quaternion(matrix=item, rtol=0.0, atol=OFF_MANIFOLD) for item in rotation]
    return np.stack([turn.angle * turn.axis for turn in turns])


def slerp(start: Array, end: Array, t: Array) -> Array:
    """The quaternions (N, 4) between quaternions (N, 4), of the sign that the start has."""
    values = []
    for p, q, time in zip(start, end, t, strict=True):
        origin = Quaternion(p)
        value = Quaternion.slerp(origin, Quaternion(q), float(time)).elements
        # For the shorter arc it turns the start round, in place.
        values.append(-value if np.dot(origin.elements, p) < 0.0 else value)
    return np.stack(values)


subject = Subject(
    name="pyquaternion",
    version=version("pyquaternion"),
    maps={"so3.exp": so3_exp, "so3.log": so3_log, "quaternion.slerp": slerp},
    conventions={
        "quaternions": "(w, x, y, z)",
        "rotations": "columns, matrices act from the left; Quaternion(matrix=R) refuses what is no rotation",
        "rotation vectors": "angle times axis, the angle in (-pi, pi]; either sign at a half turn, as documented",
        "slerp": "along the shorter arc, documented for amounts in [0, 1]; others are clipped",
        "sign": "where p . q < 0 slerp goes from -p to q, the same rotations; the adapter takes the sign back",
    },
    policies={"not a unit quaternion": "slerp 'will implicitly normalise the endpoints to unit quaternions'"},
)
