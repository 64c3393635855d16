"""Quaternions: the sign forgotten, the length taken for 1, and the angle of those that all but coincide."""

from __future__ import annotations

import numpy as np

from affinecert.fast import quaternion
from affinecert.scoring import Verdict

from .defect import Array, column, seeded


def nearer(start: Array, end: Array) -> Array:
    """The end, or its negative if that is nearer to the start."""
    return np.where(column(np.sum(start * end, axis=-1)) < 0.0, -end, end)


def weighted(start: Array, end: Array, t: Array, angle: Array, small: float) -> Array:
    """The arc between two quaternions at that angle, the chord where it is below ``small``."""
    sine = np.where(angle > small, np.sin(angle), 1.0)
    first, second = (np.where(angle > small, np.sin(s * angle) / sine, s) for s in (1 - t, t))
    return np.asarray(column(first) * start + column(second) * end)


@seeded("quaternion.slerp", "generic")
def the_long_way(start: Array, end: Array, t: Array) -> Array:
    """q is taken as it is, also where -q is nearer."""
    cosine = np.clip(np.sum(start * end, axis=-1), -1.0, 1.0)
    return weighted(start, end, t, np.arccos(cosine), 1e-8)


@seeded("quaternion.slerp", "coincident", Verdict.NON_FINITE)
def cosine_as_rounded(start: Array, end: Array, t: Array) -> Array:
    """The angle is the arccosine of p . q, which may be above 1, and is divided by, though it may be 0."""
    end = nearer(start, end)
    with np.errstate(all="ignore"):
        angle = np.arccos(np.sum(start * end, axis=-1))
        first, second = (np.sin(s * angle) / np.sin(angle) for s in (1 - t, t))
    return np.asarray(column(first) * start + column(second) * end)


@seeded("quaternion.slerp", "near-coincident", Verdict.DEGRADED)
def chord_above_a_threshold(start: Array, end: Array, t: Array) -> Array:
    """Above p . q = 0.9995 the chord is taken for the arc."""
    end = nearer(start, end)
    return weighted(start, end, t, np.arccos(np.clip(np.sum(start * end, axis=-1), -1.0, 1.0)), np.arccos(0.9995))


@seeded("quaternion.slerp", "generic")
def normalised_chord(start: Array, end: Array, t: Array) -> Array:
    """The chord, normalised: the same arc at another speed."""
    chord = column(1 - t) * start + column(t) * nearer(start, end)
    return np.asarray(chord / np.linalg.norm(chord, axis=-1, keepdims=True))


@seeded("quaternion.slerp", "orthogonal", Verdict.OTHER_BRANCH)
def negated_at_a_right_angle(start: Array, end: Array, t: Array) -> Array:
    """p . q = 0 takes -q, as a negative one does."""
    inner = column(np.sum(start * end, axis=-1))
    return np.asarray(quaternion.slerp(start, np.where(np.abs(inner) < 1e-15, -end, end), t))


@seeded("quaternion.slerp", "off-unit", Verdict.WRONG)
def taken_for_unit(start: Array, end: Array, t: Array) -> Array:
    """The quaternions are not normalised."""
    end = nearer(start, end)
    apart, together = (np.linalg.norm(x, axis=-1) for x in (start - end, start + end))
    return weighted(start, end, t, 2 * np.arctan2(apart, together), 1e-8)
