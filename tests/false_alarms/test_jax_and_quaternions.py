"""What libraries answer that differs from the catalogue, and must be acquitted: the other value of a tie, a policy.

Of jaxlie, Pinocchio, numpy-quaternion and pyquaternion, where they are installed. Findings that stand are written up in
`reports/findings`.
"""

from __future__ import annotations

import numpy as np
import pytest

from affinecert.scoring import Verdict
from tests.false_alarms.libraries import ACQUITTED, HALF_TURNS, verdict

ALL = ("jaxlie", "pinocchio", "pinocchio_quaternion", "quaternion", "pyquaternion")
RIGID = ALL[:3]


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("axis", HALF_TURNS)
def test_either_rotation_vector_of_a_half_turn(name: str, axis: str) -> None:
    assert verdict(name, "so3.log", HALF_TURNS[axis]) in ACQUITTED


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("end", [(0.0, 0.0, 0.6, 0.8), (-5e-324, 0.0, 0.6, 0.8), (0.0, -1.0, 0.0, 0.0)])
def test_either_arc_between_orthogonal_quaternions(name: str, end: tuple[float, ...]) -> None:
    start, time = np.array([1.0, 0.0, 0.0, 0.0]), np.asarray(0.25)
    assert verdict(name, "quaternion.slerp", start, np.array(end), time) in ACQUITTED


@pytest.mark.parametrize("name", RIGID)
@pytest.mark.parametrize("axis", HALF_TURNS)
def test_either_screw_between_poses_half_a_turn_apart(name: str, axis: str) -> None:
    end = np.eye(4)
    end[:3, :3], end[:3, 3] = HALF_TURNS[axis], (1.0, -2.0, 3.0)
    assert verdict(name, "morphs.sclerp", np.eye(4), end, np.asarray(0.25)) in ACQUITTED


def test_the_longer_rotation_vector_of_a_quaternion_with_a_negative_real_part() -> None:
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    tilted = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
    for rotation in (turn, turn.T, tilted, tilted.T, tilted @ turn):
        assert verdict("quaternion", "so3.log", rotation) in ACQUITTED


def test_the_closest_rotation_to_a_matrix_that_is_none() -> None:
    assert verdict("quaternion", "so3.log", 2.0 * HALF_TURNS["x"]) == Verdict.OK


def test_quaternions_that_slerp_normalises_as_it_says() -> None:
    start, end = np.array([2.0, 0.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.6, 0.8])
    assert verdict("pyquaternion", "quaternion.slerp", start, end, np.asarray(0.25)) == Verdict.OK


def test_the_sign_that_slerp_leaves_open_and_the_times_that_it_clips() -> None:
    start, end = np.array([0.6, 0.8, 0.0, 0.0]), np.array([-0.8, 0.0, 0.6, 0.0])
    for time in (0.25, -0.5, 1.5):
        assert verdict("pyquaternion", "quaternion.slerp", start, end, np.asarray(time)) == Verdict.OK
