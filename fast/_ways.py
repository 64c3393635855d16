"""What the morphs from a pose B to a pose C share: their arguments, straight lines, and the pose at the end.

Linear parts (..., d, d, 2) and translations (..., d, 2) are pairs.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array, checked
from affinecert.fast._stages import refuse
from affinecert.fast._wide_rotation import nearest_rotation, require_rotation
from affinecert.fast._wide_symmetric import symmetric_logarithm
from affinecert.fast._wide_vectors import row_sums

DETERMINANT = "the determinant of the linear part is not positive"
LAST_ROW = "the last row is not 0 ... 0 1"


class Way(NamedTuple):
    """Start and end and the time, as they are given; and the linear parts and translations of both, as pairs."""

    start: Array
    end: Array
    t: Array
    first: Array
    last: Array
    origin: Array
    goal: Array

    @property
    def translation(self) -> Array:
        """The translation in a straight line, as pairs."""
        return mixed(self.origin, self.goal, self.t[..., None])

    def stretched(self, first: Array, last: Array) -> Array:
        """The matrix between two matrices, as pairs, in a straight line."""
        return mixed(first, last, self.t[..., None, None])

    def pose(self, linear: Array, translation: Array) -> Array:
        """The pose of a linear part and a translation, as pairs, rounded; the ends as they are given."""
        pose = wide.rounded(wide.homogeneous(linear, translation))
        t = self.t[..., None, None]
        return np.where(t == 0.0, self.start, np.where(t == 1.0, self.end, pose))

    def about_barycentre(self, linear: Array) -> Array:
        """The pose of that linear part that moves the barycentre of the standard simplex in a straight line."""
        size = linear.shape[-2]
        first, last = (
            wide.add(row_sums(part), wide.times(place, float(size + 1)))
            for part, place in ((self.first, self.origin), (self.last, self.goal))
        )
        moved = wide.subtract(mixed(first, last, self.t[..., None]), row_sums(linear))
        divisor = wide.widen(np.array(size + 1.0))
        return self.pose(linear, wide.divide(moved, divisor))


def affine_way(start: ArrayLike, end: ArrayLike, t: ArrayLike, sizes: tuple[int, ...] = (3, 4)) -> Way:
    """The arguments of a morph; refuses poses that are not affine of positive determinant."""
    first, last, time = checked({"start": ("n", "n"), "end": ("n", "n"), "t": ()}, (start, end, t), sizes)[0]
    for name, pose in (("start", first), ("end", last)):
        _require_last_row(name, pose)
        sign = wide.determinant_sign(wide.widen(pose[..., :-1, :-1]))
        refuse((sign > 0.0).astype(np.float64), 0.0, name, DETERMINANT, sign.shape)
    return _from(first, last, time)


def _from(first: Array, last: Array, time: Array) -> Way:
    b, c = wide.widen(first), wide.widen(last)
    parts = wide.linear_part(b), wide.linear_part(c), wide.translation(b), wide.translation(c)
    return Way(first, last, time, *parts)


def _require_last_row(name: str, pose: Array) -> None:
    good = (pose[..., -1, :] == np.eye(pose.shape[-1])[-1]).all(axis=-1)
    refuse(good.astype(np.float64), 0.0, name, LAST_ROW, good.shape)


def mixed(first: Array, last: Array, t: Array) -> Array:
    """(1 - t) first + t last, pairs; t broadcasts against their entries."""
    return wide.add(first, wide.times(wide.subtract(last, first), t))


def rigid_way(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Way:
    """The arguments of a morph of rigid motions of space, their linear parts replaced by the nearest rotations."""
    first, last, time = checked({"start": (4, 4), "end": (4, 4), "t": ()}, (start, end, t))[0]
    for name, pose in (("start", first), ("end", last)):
        _require_last_row(name, pose)
        require_rotation(name, pose[..., :-1, :-1])
    way = _from(first, last, time)
    return way._replace(first=nearest_rotation(first[..., :-1, :-1]), last=nearest_rotation(last[..., :-1, :-1]))


def log_scale(stretch: Array) -> Array:
    """The logarithm of det(S)^(1/dim), the mean of the diagonal of log S."""
    logarithm, size = symmetric_logarithm(stretch), stretch.shape[-2]
    total = row_sums(logarithm[..., None, range(size), range(size), :])[..., 0, :]
    return wide.divide(total, wide.widen(np.array(float(size))))
