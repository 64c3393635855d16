"""What libraries want of quaternions that are to turn: length 1, which many neither check nor make."""

from __future__ import annotations

import numpy as np

from affinecert.map import Array

OFF_UNIT = 1e-6
"""How far a length may be from 1 in the catalogue's domain."""


def normalised(quaternions: Array) -> Array:
    """The quaternions (N, 4), each divided by its length; ValueError where one is no unit quaternion to 1e-6.

    For a library that takes unit quaternions and leaves it to its user to see to that.
    """
    lengths = np.linalg.norm(quaternions, axis=-1, keepdims=True)
    if not np.all(np.abs(lengths - 1) <= OFF_UNIT):
        raise ValueError("not a unit quaternion")
    return np.asarray(quaternions / lengths)
