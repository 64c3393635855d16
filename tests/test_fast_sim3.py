"""Similarities in float64: gallier's example, the ends of float64, and where V is all but singular."""

from __future__ import annotations

import math

import numpy as np
import pytest

from affinecert.arithmetic import FLOAT64
from affinecert.catalogue import find
from affinecert.errors import InputError
from affinecert.fast import se3, sim3, so3
from affinecert.map import Array
from affinecert.scoring import block_score
from affinecert.truths import compute

THIRD = math.pi / 3


def about_z(angle: float, scale: float = 1.5) -> Array:
    pose = np.eye(4)
    pose[:3, :3] = scale * so3.exp([0.0, 0.0, angle])
    pose[:3, 3] = [1.0, 2.0, 3.0]
    return pose


def scaled_error(name: str, output: Array, *inputs: Array) -> float:
    """The worst scaled error of the blocks, in u."""
    truth = compute(find(name), inputs)
    return max(
        block_score(block.name, output[block.where], truth.high[0][block.where], truth.low[0][block.where], k).scaled
        for block, k in zip(find(name).blocks, truth.sensitivity, strict=True)
    )


def test_strategy_1_follows_a_turn_through_pi_and_then_jumps() -> None:
    """Section 5: 2 pi/3, 4 pi/3 and 5 pi/3. B_2' follows B_1; B_3 follows B_2, the principal one; from B_2', B_3'."""
    first, second, last = sim3.log(np.stack([about_z(k * THIRD) for k in (2, 4, 5)]))
    np.testing.assert_allclose([first[2], second[2], last[2]], [2 * THIRD, -2 * THIRD, -THIRD], rtol=1e-15)
    after_first = sim3.log_next(about_z(4 * THIRD), first)
    np.testing.assert_allclose(after_first[2], 4 * THIRD, rtol=1e-15)
    np.testing.assert_allclose(sim3.exp(after_first), about_z(4 * THIRD), atol=3e-15)
    np.testing.assert_array_equal(sim3.log_next(about_z(5 * THIRD), second), last)
    np.testing.assert_allclose(sim3.log_next(about_z(5 * THIRD), after_first)[2], 5 * THIRD, rtol=1e-15)


def test_strategy_2_follows_a_turn_through_pi_and_whole_turns() -> None:
    here = sim3.log(about_z(2 * THIRD))
    for k in (4, 5, 6, 8, 10, 11, 13):
        here = sim3.log_near(about_z(k * THIRD), here)
        np.testing.assert_allclose(here[:3], [0.0, 0.0, k * THIRD], atol=1e-13)
        np.testing.assert_allclose(sim3.exp(here), about_z(k * THIRD), atol=1e-13)


def test_the_middle_of_the_intended_motion_is_a_half_turn() -> None:
    """Section 5: between B_1 and B_2' the motion passes through pi, between B_1 and B_2 through no turn at all."""
    start, principal = sim3.log(about_z(2 * THIRD)), sim3.log(about_z(4 * THIRD))
    for end, turn in ((sim3.log_next(about_z(4 * THIRD), start), math.pi), (principal, 0.0)):
        middle = sim3.exp((start + end) / 2)
        np.testing.assert_allclose(middle[:3, :3], about_z(turn)[:3, :3], atol=1e-15)


def test_the_identity_is_exactly_nothing() -> None:
    np.testing.assert_array_equal(sim3.exp(np.zeros(7)), np.eye(4))
    np.testing.assert_array_equal(sim3.log(np.eye(4)), np.zeros(7))
    np.testing.assert_array_equal(sim3.log_next(np.eye(4), np.full(7, 9.0)), np.zeros(7))
    assert sim3.condition(np.zeros(7)) == 1.0


def test_powers_of_two_are_exact_scales() -> None:
    poses = np.diag([2.0, 2.0, 2.0, 1.0]) * np.ones((3, 1, 1))
    poses[1, :3, :3] = 2.0**-30 * np.eye(3)
    poses[2, :3, :3] = 2.0**700 * np.eye(3)
    np.testing.assert_array_equal(sim3.log(poses)[:, 6], np.array([1.0, -30.0, 700.0]) * math.log(2.0))


def test_without_growth_it_is_a_rigid_motion() -> None:
    twists = np.random.default_rng(0).normal(size=(100, 6)) * np.logspace(-12, 1, 100)[:, None]
    tangents = np.concatenate([twists, np.zeros((100, 1))], axis=1)
    np.testing.assert_allclose(sim3.exp(tangents), se3.exp(twists), rtol=1e-14, atol=2e-15)


@pytest.mark.parametrize("growth", [-1e20, -709.0, 709.0])
@pytest.mark.parametrize("angle", [0.0, 1.0, 1e10])
def test_the_ends_of_float64(growth: float, angle: float) -> None:
    tangent = np.array([0.0, angle, 0.0, 1.0, 2.0, 3.0, growth])
    assert scaled_error("sim3.exp", sim3.exp(tangent), tangent) <= 4.0
    assert scaled_error("sim3.condition", sim3.condition(tangent), tangent) <= 4.0


def test_where_squares_are_beyond_float64() -> None:
    for angle in (0.0, 1e-200, 1.0, 1e200):
        pose = sim3.exp([0.0, angle, 0.0, 1.0, 2.0, 3.0, -1e200])
        np.testing.assert_array_equal(pose[:3, :3], np.zeros((3, 3)))
        if angle < 1e200:
            np.testing.assert_allclose(pose[:3, 3], [1e-200, 2e-200, 3e-200], rtol=1e-15)
    # Across the axis V is 1 / (1e200 - 1e200 i).
    np.testing.assert_allclose(pose[:3, 3] / 1e-200, [2.0, 2.0, 1.0], rtol=1e-15)
    assert np.all(np.isfinite(sim3.condition([[0.0, angle, 0.0, 0.0, 0.0, 0.0, 1.0] for angle in (1e-200, 1e200)])))


def test_growth_beyond_float64_is_infinite_and_no_more() -> None:
    pose = sim3.exp([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 800.0])
    np.testing.assert_array_equal(pose[:3, :3], np.diag([np.inf] * 3))
    np.testing.assert_array_equal(pose[:3, 3], [np.inf, 0.0, 0.0])
    # e^720 is beyond float64; a translation of 1e-300 times that, over 720, is not.
    tangent = np.array([0.0, 0.0, 0.0, 1e-300, 0.0, 0.0, 720.0])
    assert scaled_error("sim3.exp", np.array(sim3.exp(tangent)), tangent) <= 4.0


@pytest.mark.parametrize("scale", [2.0**-1000, 2.0**-340, 2.0**340, 2.0**1000])
def test_scales_of_any_size(scale: float) -> None:
    pose = np.eye(4)
    pose[:3, :3] = scale * so3.exp([0.3, -2.0, 0.5])
    pose[:3, 3] = [1.0, -2.0, 0.5]
    assert scaled_error("sim3.log", sim3.log(pose), pose) <= 4.0


@pytest.mark.parametrize("noise", [1e-200, 1e-160, 1e-30, 1e-16])
def test_whole_turns_of_what_turns_next_to_nothing(noise: float) -> None:
    """V is nearly singular, and its inverse as large as 2 pi over the noise: beyond where squares underflow."""
    pose = np.eye(4)
    pose[1, 0], pose[0, 1] = noise, -noise
    pose[:3, 3] = [1.0, 2.0, 3.0]
    near = np.array([0.0, 0.0, 2 * math.pi, 0.0, 0.0, 0.0, 0.0])
    tangent = sim3.log_near(pose, near)
    np.testing.assert_allclose(np.hypot(*tangent[3:5]), 2 * math.pi * math.sqrt(5) / noise, rtol=1e-12)
    assert scaled_error("sim3.log_near", tangent, pose, near) <= 4.0


def test_whole_turns_of_what_neither_turns_nor_grows_are_refused() -> None:
    near = np.zeros((2, 7))
    near[1, 2] = 6.0
    with pytest.raises(InputError, match=r"^near\[1\]: V is singular"):
        sim3.log_near(np.eye(4), near)
    # The determinant is 1 - 2^-104 here.
    unequal = np.diag([1.0 + 2.0**-52, 1.0 - 2.0**-52, 1.0, 1.0])
    np.testing.assert_allclose(sim3.log_near(unequal, near[1])[6], -(2.0**-104) / 3, rtol=1e-15)
    # And exactly 1 here, though no entry on the diagonal but one is.
    sheared = np.eye(4)
    sheared[0, 1] = sheared[1, 0] = 2.0**-22
    sheared[1, 1] += 2.0**-44
    with pytest.raises(InputError, match=r"^near: V is singular"):
        sim3.log_near(sheared, near[1])


def test_the_condition_number_beside_whole_turns() -> None:
    """At 2 pi rounded to float64, without growth, V's least singular value is its 2.4e-16 over 2 pi."""
    tangent = np.zeros(7)
    tangent[0] = 2 * math.pi
    np.testing.assert_allclose(sim3.condition(tangent), 2 * math.pi / 2.4492935982947064e-16, rtol=4 * FLOAT64.unit)
    tangent[6] = 1e-3
    np.testing.assert_allclose(sim3.condition(tangent), 2 * math.pi / 1e-3, rtol=1e-6)


def test_errors_name_the_argument_as_the_caller_knows_it() -> None:
    with pytest.raises(InputError, match=r"^previous: shape"):
        sim3.log_next(np.eye(4), np.zeros(6))
    with pytest.raises(InputError, match=r"^pose\[1\]: not a similarity"):
        sim3.log_next(np.stack([np.eye(4), np.diag([1.0, 2.0, 1.0, 1.0])]), np.zeros(7))
