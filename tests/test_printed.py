"""The prey: the printed closed forms are right where they are well behaved, and fail where design says they do."""

from __future__ import annotations

import math

import numpy as np
import pytest

from affinecert import catalogue
from affinecert.answering import answers
from affinecert.arithmetic import FLOAT64
from affinecert.case import Case, generate
from affinecert.map import Array
from affinecert.scoring import Score, Verdict, score
from affinecert.subjects import printed, printed_sam
from affinecert.subjects.printed import subject
from affinecert.truths import compute


def judged(name: str, *inputs: Array) -> Score:
    entry = catalogue.find(name)
    case = Case(name, "", inputs, 0.0, "")
    return score(entry, answers(subject, [case])[0], compute(entry, inputs))


def turn(axis: list[float], angle: float) -> Array:
    """A rotation to full accuracy, from half angles."""
    x, y, z = np.array(axis) / np.linalg.norm(axis) * math.sin(angle / 2)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y), 2 * (x * z)],
            [2 * (x * y), 1 - 2 * (x * x + z * z), 2 * (y * z)],
            [2 * (x * z), 2 * (y * z), 1 - 2 * (x * x + y * y)],
        ]
    ) + 2 * math.cos(angle / 2) * printed.cross(np.array([x, y, z]))


@pytest.mark.parametrize("name", sorted(subject.maps))
def test_a_generic_input_loses_no_more_than_half_of_the_digits(name: str) -> None:
    entry = catalogue.find(name)
    for case in generate(entry, entry.regimes[0], 10):
        assert judged(name, *case.inputs).scaled < 2.0**26


@pytest.mark.parametrize("alpha_2", [0.0, 0.7])
@pytest.mark.parametrize("alpha_5", [0.0, 0.7, -0.4])
def test_every_branch_of_the_shears_is_right_as_printed(alpha_2: float, alpha_5: float) -> None:
    twist = np.array([0.3, alpha_2, -1.1, 0.9, alpha_5])
    assert judged("shear.exp", twist).scaled < 16
    shear = printed.shear_exp(twist)
    assert judged("shear.log", shear).scaled < 16


def test_so3_log_loses_eight_digits_at_a_hundred_thousandth_before_pi() -> None:
    assert judged("so3.log", turn([1.0, 2.0, 3.0], math.pi - 1e-5)).forward * FLOAT64.unit > 1e-8


def test_so3_log_is_garbage_past_ten_millionths_before_pi() -> None:
    assert judged("so3.log", turn([1.0, 2.0, 3.0], math.pi - 1e-8)).verdict in {Verdict.WRONG, Verdict.NON_FINITE}


def test_so3_log_by_the_trace_is_nothing_near_the_identity() -> None:
    assert judged("so3.log", turn([1.0, 2.0, 3.0], 1e-9)).forward * FLOAT64.unit >= 1


def test_the_coefficient_of_v_is_lost_at_a_hundred_millionth() -> None:
    theta = 1e-8
    left = printed.left_jacobian(np.array([0.0, 0.0, theta]))
    assert left[1, 0] == 0.0  # theta / 2 is due
    assert judged("se3.exp", np.array([0.0, 0.0, theta, 1.0, 0.0, 0.0])).forward * FLOAT64.unit == pytest.approx(
        theta / 2
    )


def test_v_is_not_a_number_where_the_cube_underflows() -> None:
    assert judged("se3.exp", np.array([0.0, 0.0, 1e-120, 1.0, 0.0, 0.0])).verdict is Verdict.NON_FINITE


@pytest.mark.parametrize(("growth", "loss"), [(1e-3, 1e-14), (1e-6, 1e-11), (1e-9, 1e-8), (1e-12, 1e-5), (1e-15, 1e-2)])
@pytest.mark.parametrize("angle", [1.0, 1e-6])
def test_v_of_a_similarity_is_lost_as_the_growth_vanishes(growth: float, loss: float, angle: float) -> None:
    tangent = np.array([0.6 * angle, 0.0, -0.8 * angle, 1.0, 2.0, -0.5, growth])
    assert loss < judged("sim3.exp", tangent).forward * FLOAT64.unit < 100 * loss


def test_the_logarithm_of_a_similarity_by_the_trace_is_nothing_near_no_rotation() -> None:
    pose = np.eye(4)
    pose[:3, :3] = 2 * turn([1.0, 2.0, 3.0], 1e-9)
    assert judged("sim3.log", pose).forward * FLOAT64.unit >= 1


@pytest.mark.parametrize("growth", [0.0, 0.7, -3.0])
@pytest.mark.parametrize("angle", [0.0, 1.0, 2.0])
def test_every_case_of_theorem_2_3_is_right_as_printed(angle: float, growth: float) -> None:
    tangent = np.array([0.6 * angle, 0.0, -0.8 * angle, 1.0, 2.0, -0.5, growth])
    assert judged("sim3.exp", tangent).scaled < 16
    pose = printed.sim3_exp(tangent)
    assert judged("sim3.log", pose).scaled < 16
    assert judged("sim3.log_next", pose, 2 * tangent).scaled < 16
    assert judged("sim3.log_near", pose, tangent * 4).scaled < 64


def test_half_turns_have_their_case_in_section_4() -> None:
    pose = np.diag([-2.0, 2.0, -2.0, 1.0])
    assert judged("sim3.log", pose).scaled < 16


@pytest.mark.parametrize(("gap", "loss"), [(1e-6, 1e-5), (1e-15, 1.0)])
def test_shear_exp_loses_by_the_square_of_the_gap(gap: float, loss: float) -> None:
    twists = [np.array([1.0, ratio * gap, 0.3, 0.7, gap]) for ratio in (2.0, 1.5, 3.1, -1.0)]
    assert max(judged("shear.exp", twist).forward for twist in twists) * FLOAT64.unit > loss


@pytest.mark.parametrize(("gap", "loss"), [(1e-6, 1e-10), (1e-15, 0.1)])
def test_shear_log_loses_by_the_gap(gap: float, loss: float) -> None:
    shears = [
        np.array([[1.0, 1.0, 0.3], [0.0, 1 + ratio * gap, 0.7], [0.0, 0.0, 1 + gap]]) for ratio in (2.0, 1.5, 3.1, -1.0)
    ]
    assert max(judged("shear.log", shear).forward for shear in shears) * FLOAT64.unit > loss


def test_g1_is_lost_below_a_hundred_millionth() -> None:
    small = 2e-9
    scores = [
        judged("sam.log", np.array([[stretch, -small, 1.0], [small, stretch, 2.0], [0.0, 0.0, 1.0]]))
        for stretch in (1 + 1e-8, 1 + 3e-8, 1 - 1e-8, 1 - 7e-9)
    ]
    assert max(score.scaled for score in scores) * FLOAT64.unit >= 0.01


def test_the_double_positive_eigenvalue_is_forgotten() -> None:
    assert judged("sam.log", np.diag([2.0, 2.0, 1.0])).verdict is Verdict.NON_FINITE


@pytest.mark.parametrize(
    ("linear", "procedure"),
    [
        ([[0.0, -1.0], [1.0, 0.0]], "G1"),
        ([[3.0, 0.5], [0.0, 2.0]], "G2"),
        ([[1.0, 0.5], [0.0, 2.0]], "S1"),
        ([[-2.0, 0.0], [0.0, -2.0]], "S2"),
        ([[-2.0, 1.0], [0.0, -2.0]], "G3"),
        ([[-2.0, 0.0], [0.0, -3.0]], "G3"),
    ],
)
def test_algorithm_1_selects_the_procedure(linear: list[list[float]], procedure: str) -> None:
    assert printed_sam.procedure(np.array(linear)) == procedure


@pytest.mark.parametrize(
    "matrix",
    [
        [[1.0, 0.0, 3.0], [0.0, 1.0, 2.0], [0.0, 0.0, 1.0]],
        [[1.0, 0.5, 3.0], [0.0, 1.0, 2.0], [0.0, 0.0, 1.0]],
        [[1.0, 0.5, 3.0], [0.0, 2.0, 2.0], [0.0, 0.0, 1.0]],
        [[-2.0, 0.0, 3.0], [0.0, -2.0, 1.0], [0.0, 0.0, 1.0]],
        [[0.3, -0.8, 3.0], [0.9, 0.1, 1.0], [0.0, 0.0, 1.0]],
        [[2.0, 0.1, 3.0], [0.3, 1.2, 1.0], [0.0, 0.0, 1.0]],
        [[1.0, 0.0, 0.0, 5.0], [0.0, 0.3, -0.8, 1.0], [0.0, 0.9, 0.1, 1.0], [0.0, 0.0, 0.0, 1.0]],
        [[3.0, 0.0, 0.0, 5.0], [0.0, -2.0, 0.0, 1.0], [0.0, 0.0, -2.0, 1.0], [0.0, 0.0, 0.0, 1.0]],
    ],
)
def test_every_procedure_and_space_are_right_where_nothing_cancels(matrix: list[list[float]]) -> None:
    assert judged("sam.log", np.array(matrix)).scaled < 64
