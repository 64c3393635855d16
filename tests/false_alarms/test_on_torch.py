"""What the libraries on torch answer that differs from the catalogue, and must be acquitted: other branches, policies.

Of kornia, PyPose and RoMa, where they are installed. Findings that stand are written up in `reports/findings`.
"""

from __future__ import annotations

import numpy as np
import pytest

from affinecert.case import Case
from affinecert.judging import judge, truths_of
from affinecert.map import Array
from affinecert.scoring import Verdict
from affinecert.subject import Subject
from tests.false_alarms.libraries import ACQUITTED, HALF_TURNS, verdict

ALL = ("kornia", "kornia_liegroup", "pypose", "roma")


def pose(linear: Array, translation: tuple[float, float, float], last: float = 1.0) -> Array:
    matrix = np.diag([1.0, 1.0, 1.0, last])
    matrix[:3, :3], matrix[:3, 3] = linear, translation
    return matrix


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("axis", HALF_TURNS)
def test_either_rotation_vector_of_a_half_turn(name: str, axis: str) -> None:
    assert verdict(name, "so3.log", HALF_TURNS[axis]) in ACQUITTED


@pytest.mark.parametrize(("name", "map"), [("kornia", "se3.log"), ("pypose", "se3.log"), ("pypose", "sim3.log")])
@pytest.mark.parametrize("axis", HALF_TURNS)
def test_either_twist_of_half_a_screw(name: str, map: str, axis: str) -> None:
    assert verdict(name, map, pose(HALF_TURNS[axis], (1.0, 2.0, -0.5))) in ACQUITTED


# Inner products of 0 exactly, to which the products of rounding give either sign.
ORTHOGONAL = (
    ((1.0, 0.0, 0.0, 0.0), (0.0, -1.0, 0.0, 0.0)),
    ((0.3966066250181437, -0.5322825168500261, -0.18170346833328302, -0.7255083437446979),
     (-0.18170346833328302, -0.7255083437446979, -0.3966066250181437, 0.5322825168500261)),
    ((-0.10203498673261183, -0.7049424774108448, -0.6714734363778239, 0.20437316179795365),
     (-0.6714734363778239, 0.20437316179795365, 0.10203498673261183, 0.7049424774108448)),
)  # fmt: skip


@pytest.mark.parametrize("name", ["kornia", "roma"])
@pytest.mark.parametrize(("start", "end"), ORTHOGONAL)
def test_either_arc_between_orthogonal_quaternions(name: str, start: tuple[float, ...], end: tuple[float, ...]) -> None:
    answers = {verdict(name, "quaternion.slerp", np.array(start), np.array(end), np.asarray(t)) for t in (0.25, 1.0)}
    assert answers <= ACQUITTED


def test_the_longer_arc_is_acquitted_at_no_other_angle() -> None:
    longer = Subject("longer", "0", {"quaternion.slerp": lambda p, q, t: q})
    case = Case(
        "quaternion.slerp", "near-orthogonal", (np.eye(4)[0], np.array([-1e-12, 1.0, 0.0, 0.0]), np.ones(())), 0.0, ""
    )
    assert judge(longer, [case], truths_of([case]))[0].verdict == Verdict.WRONG


DOCUMENTED = (
    ("kornia", "so3.log", (2 * np.eye(3),)),
    ("kornia", "quaternion.slerp", (np.eye(4)[0], np.zeros(4), np.asarray(0.5))),
    ("kornia_liegroup", "so3.log", (np.diag([-1.0, 1.0, 1.0]),)),
    ("pypose", "se3.log", (pose(np.eye(3), (1.0, 2.0, 3.0), last=2.0),)),
    ("pypose", "sim3.log", (pose(2 * np.eye(3), (1.0, 2.0, 3.0), last=2.0),)),
    ("roma", "polar.decompose", (np.diag([1.0, 2.0, -3.0]),)),
    ("roma", "quaternion.slerp", (np.eye(4)[0], 2 * np.eye(4)[1], np.asarray(0.5))),
)
"""Answers outside the domain that the library's documentation promises."""


@pytest.mark.parametrize(("name", "map", "inputs"), DOCUMENTED)
def test_documented_policies(name: str, map: str, inputs: tuple[Array, ...]) -> None:
    assert verdict(name, map, *inputs) == Verdict.OK


def test_a_refusal_of_what_is_no_rotation() -> None:
    assert verdict("pypose", "so3.log", 2 * np.eye(3)) == Verdict.OK
