"""What is no defect and must be acquitted: other determinations, documented policies, refusals, ill-conditioning."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from affinecert.case import Case, generate
from affinecert.catalogue import CATALOGUE
from affinecert.judging import judge, truths_of
from affinecert.map import Array
from affinecert.scoring import Verdict
from affinecert.subject import Subject
from affinecert.tier import batches
from tests.false_alarms.libraries import ACQUITTED, installed


def verdict(name: str, inputs: tuple[Any, ...], answer: Any, policies: Mapping[str, str] | None = None) -> str:
    """The verdict of an answer, an array or an exception, at one input."""

    def give(*_: Array) -> Any:
        if isinstance(answer, Exception):
            raise answer
        return np.asarray(answer, dtype=np.float64)[None]

    arrays = tuple(np.asarray(item, dtype=np.float64) for item in inputs)
    cases = [Case(name, "given", arrays, 0.0, "given")]
    subject = Subject("given", "0", {name: give}, policies=policies or {})
    return judge(subject, cases, truths_of(cases))[0].verdict


def on_arc(start: Array, end: Array, t: float) -> Array:
    """Slerp along the arc that the signs give, be it the longer one."""
    angle = np.arccos(np.clip(start @ end, -1.0, 1.0))
    return np.asarray((np.sin((1 - t) * angle) * start + np.sin(t * angle) * end) / np.sin(angle))


ONE = np.array([1.0, 0.0, 0.0, 0.0])


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("product", [0.0, 5e-324, -5e-324, 1e-17, -1e-17])
def test_either_arc_between_orthogonal_quaternions(product: float, sign: float) -> None:
    end = np.array([product, 0.0, 0.6, 0.8])
    assert verdict("quaternion.slerp", (ONE, end, 0.25), on_arc(ONE, sign * end, 0.25)) in ACQUITTED


@pytest.mark.parametrize("product", [0.6, 1e-3, 1e-12])
def test_the_longer_arc_is_wrong_where_no_rounding_makes_the_choice(product: float) -> None:
    end = np.array([product, np.sqrt(1 - product**2), 0.0, 0.0])
    assert verdict("quaternion.slerp", (ONE, end, 0.25), on_arc(ONE, end, 0.25)) == Verdict.OK
    assert verdict("quaternion.slerp", (ONE, end, 0.25), on_arc(ONE, -end, 0.25)) == Verdict.WRONG


def turn(angle: float) -> Array:
    """The pose turned about the z axis through the origin."""
    pose = np.eye(4)
    pose[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    return pose


HALF_TURN = np.diag([-1.0, -1.0, 1.0, 1.0])


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("end", [HALF_TURN, turn(np.pi), turn(-np.pi)], ids=["exact", "rounded", "rounded-back"])
def test_either_way_between_poses_half_a_turn_apart(end: Array, way: float) -> None:
    assert verdict("morphs.sclerp", (np.eye(4), end, 0.5), turn(way * np.pi / 2)) in ACQUITTED


@pytest.mark.parametrize("short", [1e-2, 1e-9])
def test_the_longer_way_between_poses_is_wrong_short_of_half_a_turn(short: float) -> None:
    end = turn(np.pi - short)
    assert verdict("morphs.sclerp", (np.eye(4), end, 0.5), turn((np.pi - short) / 2)) == Verdict.OK
    assert verdict("morphs.sclerp", (np.eye(4), end, 0.5), turn(-(np.pi + short) / 2)) == Verdict.WRONG


def test_a_wrong_answer_beside_a_jump_stays_wrong() -> None:
    assert verdict("morphs.sclerp", (np.eye(4), HALF_TURN, 0.5), turn(1.5)) == Verdict.WRONG
    assert verdict("quaternion.slerp", (ONE, [0.0, 1.0, 0.0, 0.0], 0.5), [0.8, 0.6, 0.0, 0.0]) == Verdict.WRONG


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_either_axis_of_a_half_turn(sign: float) -> None:
    axis = sign * np.array([0.0, 0.6, 0.8])
    half_turn = np.array([[-1, 0, 0], [0, -0.28, 0.96], [0, 0.96, 0.28]])
    assert verdict("so3.log", (half_turn,), np.pi * axis) in ACQUITTED
    pose = np.eye(4)
    pose[:3, :3] = half_turn
    assert verdict("se3.log", (pose,), [*(np.pi * axis), 0, 0, 0]) in ACQUITTED


def test_a_logarithm_with_whole_turns_more_is_another_branch() -> None:
    rotation = turn(1.0)[:3, :3]
    assert verdict("so3.log", (rotation,), [0, 0, 1.0 + 2 * np.pi]) == Verdict.OTHER_BRANCH


def test_documented_answers_outside_the_domain_are_acquitted_and_silent_ones_not() -> None:
    twice, policy = 2 * np.eye(3), {"not a rotation": "orthogonalises what it is given"}
    assert verdict("so3.log", (twice,), np.zeros(3), policy) == Verdict.OK
    assert verdict("so3.log", (twice,), np.zeros(3)) == Verdict.WRONG


@pytest.mark.parametrize("answer", [ValueError("not a rotation"), [np.nan] * 3], ids=["raised", "nan"])
def test_refusals_outside_the_domain_are_right(answer: Any) -> None:
    assert verdict("so3.log", (np.diag([1.0, 1.0, -1.0]),), answer) == Verdict.OK


def test_digits_that_an_ill_conditioned_matrix_does_not_determine_are_not_asked_for() -> None:
    gap, slope = 1e-8, 1e8
    affine, logarithm = np.eye(3), np.zeros((3, 3))
    affine[:2, :2] = [[2.0, slope], [0.0, 2.0 + gap]]
    logarithm[:2, :2] = [[np.log(2.0), slope * np.log1p(gap / 2) / gap], [0.0, np.log(2.0 + gap)]]
    # A rounding beside the gap moves the logarithm by far more than this.
    assert verdict("sam.log", (affine,), logarithm * (1 + 1e-10)) == Verdict.OK
    assert verdict("sam.log", (np.diag([2.0, 2.0, 1.0]),), np.diag([np.log(2.0)] * 2 + [0]) * (1 + 1e-10)) != Verdict.OK


LIBRARIES = (
    "opencv",
    "pytransform3d",
    "pytransform3d_batch",
    "spatialmath",
    "transforms3d",
    "transforms3d_quaternions",
)


@pytest.mark.parametrize(
    ("name", "map", "regime"),
    [
        *((name, "so3.exp", regime) for name in LIBRARIES for regime in ("generic", "near-pi", "huge-angle")),
        *((name, "so3.log", "coordinate-axis-at-pi") for name in LIBRARIES),
        ("pytransform3d", "morphs.sclerp", "at-pi-3d"),
        ("pytransform3d", "morphs.sclerp", "coordinate-axis-at-pi-3d"),
        ("pytransform3d", "quaternion.slerp", "near-orthogonal"),
        ("pytransform3d", "quaternion.slerp", "outside"),
        ("pytransform3d_batch", "morphs.sclerp", "coordinate-axis-at-pi-3d"),
        ("spatialmath", "quaternion.slerp", "orthogonal"),
        ("opencv", "so3.log", "outside"),
        ("opencv", "affine_lie.decompose", "generic"),
        ("transforms3d", "affine_lie.decompose", "generic"),
        ("transforms3d", "so3.log", "generic"),
    ],
)
def test_libraries_are_acquitted_where_they_are_right(name: str, map: str, regime: str) -> None:
    entry, subject = CATALOGUE[map], installed(name)
    (chosen,) = (candidate for candidate in entry.regimes if candidate.name == regime)
    tried = batches(generate(entry, chosen, 6))
    assert {result.verdict for batch in tried for result in judge(subject, batch, truths_of(batch))} <= ACQUITTED
