"""Spliced splines in float64: what is not in the catalogue, and what the generic tests do not ask.

The errors in every regime are held in `test_fast_accuracy`, what all functions promise of batches in
`test_fast_kernels`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from affinecert.case import generate
from affinecert.catalogue import find
from affinecert.errors import InputError
from affinecert.fast import splines
from affinecert.reference import splines as reference

Array = NDArray[np.float64]

CTX = mpmath.MPContext()
CTX.prec = 320

UNIT = 2.0**-53


def exactly(function: Callable[..., Any], *arrays: Array) -> Array:
    """The reference's result, rounded."""
    numbers = [np.array([CTX.mpf(x) for x in np.ravel(a).tolist()] + [None])[:-1].reshape(a.shape) for a in arrays]
    return np.asarray(function(CTX, *numbers), dtype=np.float64)


def cases(name: str, *regimes: str, count: int = 3) -> list[tuple[Array, ...]]:
    entry = find(name)
    chosen = [regime for regime in entry.regimes if not regimes or regime.name in regimes]
    return [case.inputs for regime in chosen for case in generate(entry, regime, count, seed=3)]


JOURNEYS = ("generic", "through-pi", "round-and-round", "half-turns", "near-2pi", "equal-keys", "two-keys")


def test_bezier_points_are_those_of_the_reference() -> None:
    for points, lengths in cases("splines.de_boor", "generic", "twos", "threes", "nothing-but-threes"):
        found, due = splines.bezier_points(points, lengths), exactly(reference.bezier_points, points, lengths)
        assert found.shape == due.shape
        assert np.abs(found - due).max() <= UNIT * np.abs(due).max()


def test_selected_logarithms_key_times_and_principal_motions_are_those_of_the_reference() -> None:
    for poses, t in cases("splines.motion", *JOURNEYS):
        points, lengths = splines.select_logarithms(poses)
        numbers = np.vectorize(CTX.mpf, otypes=[object])(poses)
        due_points, due_lengths = reference.select_logarithms(CTX, numbers)
        assert lengths.tolist() == due_lengths.tolist()
        due = due_points.astype(float)
        assert np.abs(points - due).max() <= UNIT * np.abs(due).max()
        assert splines.key_times(poses).tolist() == exactly(reference.key_times, poses).tolist()
        moved, goal = splines.principal_motion(poses, t), exactly(reference.principal_motion, poses, t)
        assert np.abs(moved - goal).max() <= 2 * UNIT * np.abs(goal).max()


def test_a_batch_of_different_segments() -> None:
    points = np.arange(24.0).reshape(8, 3) ** 2 % 7
    lengths = np.array([[2.0, 6.0], [4.0, 4.0], [6.0, 2.0], [3.0, 5.0]])
    t = np.linspace(-1.0, 9.0, 41)[:, None]
    found = splines.evaluate(points, lengths, t)
    assert found.shape == (41, 4, 3)
    for column, numbers in enumerate(lengths):
        assert (found[:, column] == splines.evaluate(points, numbers, t[:, 0])).all()
    with pytest.raises(InputError, match=r"^lengths\[1\]: segments of two points are more in one item") as caught:
        splines.de_boor(points, lengths[:2])
    assert caught.value.index == (1,)
    assert splines.de_boor(points, lengths[[1, 3]]).shape == (2, 8, 3)
    assert splines.bezier_points(points, lengths[[0, 2]]).shape == (2, 7, 4, 3)


def test_one_segment_is_the_natural_spline_of_scipy() -> None:
    points = np.random.default_rng(5).normal(size=(7, 3))
    times = np.linspace(0.0, 6.0, 50)
    due = CubicSpline(np.arange(7.0), points, bc_type="natural")(times)
    np.testing.assert_allclose(splines.evaluate(points, [7], times), due, atol=1e-14)


def test_derivatives_are_continuous_at_junctions() -> None:
    # By the Bezier points: C'(1) = 3 (b_3 - b_2), C''(1) = 6 (b_1 - 2 b_2 + b_3), and so on (section 8.1).
    for points, lengths in cases("splines.de_boor", "generic", "twos", "nothing-but-threes"):
        b = splines.bezier_points(points, lengths)
        tolerance = 64 * UNIT * np.abs(points).max()
        np.testing.assert_allclose(b[:-1, 3] - b[:-1, 2], b[1:, 1] - b[1:, 0], rtol=0, atol=tolerance)
        ends, starts = b[:, 1] - 2 * b[:, 2] + b[:, 3], b[:, 0] - 2 * b[:, 1] + b[:, 2]
        np.testing.assert_allclose(ends[:-1], starts[1:], rtol=0, atol=tolerance)
        np.testing.assert_allclose([starts[0], ends[-1]], 0.0, rtol=0, atol=tolerance)


def test_motions_pass_through_their_keys_in_batches() -> None:
    poses = np.stack([case[0] for case in cases("splines.motion", "through-pi", "half-turns", "near-2pi", count=8)])
    times = splines.key_times(poses)
    for motion in (splines.motion, splines.smooth_motion):
        found = motion(poses[:, None], times)
        assert found.shape == poses.shape
        # The poses are similarities up to rounding.
        assert np.abs(found - poses).max() <= 8 * UNIT * np.abs(poses).max()


def test_the_way_from_pose_to_pose_is_the_short_one() -> None:
    angles = np.array([0.5, 2.0, 3.6, 5.2, 6.8, 8.4])
    poses = np.tile(np.eye(4), (6, 1, 1))
    poses[:, 0, 0] = poses[:, 1, 1] = np.cos(angles)
    poses[:, 1, 0] = np.sin(angles)
    poses[:, 0, 1] = -poses[:, 1, 0]
    times = splines.key_times(poses)
    assert times.tolist() == [0, 1, 2, 3, 4, 5]
    found = splines.motion(poses, np.linspace(0.0, 5.0, 101))
    turned = np.unwrap(np.arctan2(found[:, 1, 0], found[:, 0, 0]))
    assert np.diff(turned).min() > 0.0
    assert turned[-1] - turned[0] == pytest.approx(7.9)
    wrong = splines.principal_motion(poses, np.linspace(0.0, 5.0, 101))
    assert np.diff(np.unwrap(np.arctan2(wrong[:, 1, 0], wrong[:, 0, 0]))).min() < -0.02
    assert np.abs(found - splines.smooth_motion(poses, np.linspace(0.0, 5.0, 101))).max() <= 4 * UNIT


def test_the_jump_of_the_printed_velocity_and_none_of_the_smooth_one() -> None:
    (poses, _), *_ = cases("splines.motion", "through-pi")
    step = 2.0**-20

    def change(motion: Callable[..., Array]) -> float:
        before, here, behind = motion(poses, np.array([2.0 - step, 2.0, 2.0 + step]))
        return float(np.abs((behind - here) - (here - before)).max() / step)

    # What is left of the smooth one is the acceleration times the step, and rounding over the step.
    assert change(splines.motion) > 0.01
    assert change(splines.smooth_motion) < 1e-3


def test_too_few_poses_and_batches_of_poses() -> None:
    with pytest.raises(InputError, match=r"^poses: shape \(1, 4, 4\): two or more are due"):
        splines.motion(np.eye(4)[None], 0.5)
    with pytest.raises(InputError, match=r"^poses: shape \(2, 3, 4, 4\) where \(keys, 4, 4\) is due"):
        splines.select_logarithms(np.tile(np.eye(4), (2, 3, 1, 1)))
