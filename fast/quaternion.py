"""Unit quaternions (w, x, y, z)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast._kernel import Array, checked


def slerp(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The point at t on the shorter great arc."""
    p, q, time = checked({"start": (4,), "end": (4,), "t": ()}, (start, end, t))[0]
    for name, x in (("start", p), ("end", q)):
        bad = np.abs(np.linalg.norm(x, axis=-1) - 1) > 1e-6
        if bad.any():
            raise InputError(name, "not a unit quaternion", tuple(int(i) for i in np.argwhere(bad)[0]))
    p, q = (x / np.linalg.norm(x, axis=-1, keepdims=True) for x in (p, q))
    d = np.sum(p * q, axis=-1)
    q = np.where(d[..., None] < 0, -q, q)
    angle = 2 * np.arctan2(np.linalg.norm(p - q, axis=-1), np.linalg.norm(p + q, axis=-1))
    def weight(s):
        with np.errstate(all="ignore"):
            return np.where(angle > 1e-9, np.sin(s * angle) / np.sin(angle), s)[..., None]
    return np.asarray(weight(1 - time) * p + weight(time) * q)
