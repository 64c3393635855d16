"""Spliced splines: a misprinted row, segments that do not know of each other, time miscounted, the long way round."""

from __future__ import annotations

import numpy as np

from affinecert.fast import _wide as wide
from affinecert.fast import splines
from affinecert.fast._splicing import Legs, Place, cubic_at, pick, place
from affinecert.fast._wide_similarity import exponential, multiple, turned_back_curve

from .defect import Array, homogeneous, seeded


def segments(points: Array, lengths: Array) -> list[Array]:
    """The points (length, dims) of each segment of one item."""
    return np.split(points, np.cumsum(lengths.astype(int))[:-1])


@seeded("splines.de_boor", "generic")
def segments_apart(points: Array, lengths: Array) -> Array:
    """Each segment has zero second derivatives at its own ends."""
    items = (segments(x, n) for x, n in zip(points, lengths, strict=True))
    return np.stack([np.concatenate([splines.de_boor(x, [len(x)]) for x in pieces]) for pieces in items])


@seeded("splines.de_boor", "one-segment")
def points_for_first_and_last_controls(points: Array, lengths: Array) -> Array:
    """The first and the last de Boor point are the data points there."""
    controls = splines.de_boor(points, lengths)
    controls[:, [0, -1]] = points[:, [0, -1]]
    return controls


@seeded("splines.de_boor", "nothing-but-threes")
def four_for_fourteen(points: Array, lengths: Array) -> Array:
    """The last inner row has 4 for 14, as the paper's matrices for K = 7 and K = 8 have it."""
    x = points.reshape(len(points), -1, 3, points.shape[-1])
    count = x.shape[1]
    matrix = 14 * np.eye(count) - np.eye(count, k=1) - np.eye(count, k=-1)
    matrix[[0, -1], [0, -1]] = 15.0
    matrix[-2, -2] = 4.0
    right = 24 * x[:, :, 1] - 5 * x[:, :, 0] - 5 * x[:, :, 2]
    right[:, 0] += x[:, 0, 0]
    right[:, -1] += x[:, -1, 2]
    right[:, 1:] -= x[:, :-1, 2]
    right[:, :-1] -= x[:, 1:, 0]
    inner = np.linalg.solve(matrix, right)
    controls = np.stack([inner] * 3, axis=2)
    controls[:, 0, 0] = (2 * x[:, 0, 0] + inner[:, 0]) / 3
    controls[:, -1, 2] = (2 * x[:, -1, 2] + inner[:, -1]) / 3
    step = (inner[:, :-1] - inner[:, 1:]) / 6
    controls[:, :-1, 2] = (5 * x[:, :-1, 2] + x[:, 1:, 0]) / 6 + step
    controls[:, 1:, 0] = (x[:, :-1, 2] + 5 * x[:, 1:, 0]) / 6 - step
    return controls.reshape(points.shape)


@seeded("splines.evaluate", "generic")
def a_curve_of_each_segment(points: Array, lengths: Array, t: Array) -> Array:
    """The segments are interpolated one by one; where they join, only a jump is left."""

    def value(points: Array, lengths: Array, t: float) -> Array:
        starts = np.cumsum(lengths - 1) - (lengths - 1)
        at = max(int(np.sum(starts <= t)) - 1, 0)
        return np.asarray(splines.evaluate(segments(points, lengths)[at], lengths[at : at + 1], t - starts[at]))

    return np.stack([value(*item) for item in zip(points, lengths, t, strict=True)])


@seeded("splines.evaluate", "nothing-but-threes")
def time_of_points(points: Array, lengths: Array, t: Array) -> Array:
    """Time counts points: a junction takes as long as a span."""
    junctions = np.cumsum(lengths, axis=-1)[:, :-1]
    return np.asarray(splines.evaluate(points, lengths, t - np.sum(t[:, None] >= junctions, axis=-1)))


@seeded("splines.evaluate", "twos")
def average_forgotten(points: Array, lengths: Array, t: Array) -> Array:
    """A segment of two points takes the time 1, as everything does here, where it should take 2."""
    knots = np.cumsum(lengths - 1, axis=-1)
    before = np.concatenate([np.zeros_like(knots[:, :1]), knots[:, :-1]], axis=-1)
    passed = np.clip(t[:, None] - before, 0.0, 1.0) * (lengths == 2)
    return np.asarray(splines.evaluate(points, lengths, t + passed.sum(axis=-1)))


@seeded("splines.motion", "through-pi")
def the_long_way(poses: Array, t: Array) -> Array:
    """Principal logarithms throughout."""
    return np.asarray(splines.principal_motion(poses, t))


@seeded("splines.motion", "two-keys")
def from_key_to_key_in_the_time_one(poses: Array, t: Array) -> Array:
    """Two logarithms are a segment of the length 1."""
    return np.asarray(splines.motion(poses, 2 * t))


@seeded("splines.motion", "generic")
def translation_apart(poses: Array, t: Array) -> Array:
    """The translations have a spline of their own, without the logarithm's V."""
    moved = splines.motion(poses, t)
    places = splines.evaluate(poses[:, :, :3, 3], np.full((len(poses), 1), float(poses.shape[1])), t)
    return homogeneous(moved[:, :3, :3], places)


@seeded("splines.smooth_motion", "behind-a-junction")
def smooth_as_printed(poses: Array, t: Array) -> Array:
    """The derivatives of the logarithm agree at junctions; those of the motion do not."""
    return np.asarray(splines.motion(poses, t))


@seeded("splines.smooth_motion", "behind-a-junction")
def velocity_alone(poses: Array, t: Array) -> Array:
    """The velocity is continuous at junctions, the second derivative of the logarithm left as it is."""

    def mended(legs: Legs, at: Place) -> Array:
        cubic = cubic_at(legs, at)
        before = pick(legs.end, np.maximum(at.leg - 1, 0), 2)
        due = turned_back_curve((before, cubic.linear, 2.0 * cubic.square))[1]
        behind = pick(legs.opens, at.leg) & (at.leg > 0) & ~at.second
        s = at.s[..., 0]
        factor = wide.widen(np.where(behind, s * (1 - s) ** 2, 0.0))
        return wide.add(cubic.at(at.s), multiple(factor, wide.subtract(due, cubic.linear)))

    legs = splines._selected(poses)
    return wide.rounded(exponential(mended(legs, place(legs, t))))
