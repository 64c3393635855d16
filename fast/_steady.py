"""Steady affine morphs in a row: between given poses, where existence is decided exactly, and between computed ones."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from affinecert.fast import _sam_stages as stages
from affinecert.fast import _wide as wide
from affinecert.fast._existence import kind_of_quotient
from affinecert.fast._kernel import Array
from affinecert.fast._spectrum import NONE, PRIMARY, UNDECIDED
from affinecert.fast._stages import refuse, run, settle
from affinecert.fast._wide_affine import affine_power

LAST_ROW = "the last row is not 0 ... 0 1"
DETERMINANT = "the determinant of the linear part is not positive"
NO_LOGARITHM = "no real logarithm: a negative eigenvalue, not double with two eigenvectors"
ON_THE_WAY = "no real logarithm: a negative eigenvalue between poses on the way"


def require(good: NDArray[np.bool_], argument: str, reason: str, batch: tuple[int, ...]) -> None:
    """Refuses the first item that is not good, (*batch, ...): altogether, where it has parts beyond its batch."""
    together = good.all(axis=tuple(range(len(batch), good.ndim)))
    refuse(np.asarray(together, dtype=np.float64), 0.0, argument, reason, batch)


def require_last_row(argument: str, poses: Array, batch: tuple[int, ...]) -> None:
    """Refuses a last row other than 0 ... 0 1, poses (*batch, ..., n, n)."""
    require(poses[..., -1, :] == np.eye(poses.shape[-1])[-1], argument, LAST_ROW, batch)


def require_poses(argument: str, poses: Array, batch: tuple[int, ...]) -> None:
    """Refuses what is no orientation-preserving affine map, poses (*batch, ..., n, n)."""
    require_last_row(argument, poses, batch)
    require(wide.determinant_sign(wide.widen(poses[..., :-1, :-1])) > 0.0, argument, DETERMINANT, batch)


def require_morph(argument: str, start: Array, end: Array, batch: tuple[int, ...]) -> None:
    """Refuses poses, of positive determinant, between which there is no steady morph: decided exactly.

    start and end (..., n, n); ``batch`` is that of the argument that is blamed.
    """
    linear, _, sign = run(stages.quotient, start, end)
    existence = run(stages.eigenvalues, linear)[1]
    existence[sign <= 0.0] = UNDECIDED
    settle(existence, UNDECIDED, kind_of_quotient, start[..., :-1, :-1], end[..., :-1, :-1])
    refuse(existence, NONE, argument, NO_LOGARITHM, batch)


def morph(start: Array, end: Array, t: Array) -> Array:
    """SAM(B, t, C) = (C B^-1)^t B, for pairs (..., n, n, 2) and float64 t (...); nan where there is none."""
    return carried(start, start, end, t)


def carried(pose: Array, start: Array, end: Array, t: Array) -> Array:
    """The pose F_X carried along the motion from B to C for the time t, (C B^-1)^t F_X."""
    return wide.product(affine_power(wide.right_quotient(end, start), t)[0], pose)


def between(argument: str, start: Array, end: Array, t: Array, batch: tuple[int, ...]) -> Array:
    """`morph` between computed poses; refuses what has no logarithm, and half turns, which rounding hides."""
    power, existence = affine_power(wide.right_quotient(end, start), t)
    refuse((existence == PRIMARY).astype(np.float64), 0.0, argument, ON_THE_WAY, batch)
    return wide.product(power, start)
