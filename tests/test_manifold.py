"""Matrices off the manifold: how far, and what the subject's word that it takes them as they are is worth."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from affinecert import truths
from affinecert.arithmetic import FLOAT32
from affinecert.case import Case, generate
from affinecert.catalogue import CATALOGUE
from affinecert.judging import judge, truths_of
from affinecert.manifold import distance, slack
from affinecert.map import Argument, Array
from affinecert.properties.answers import singly
from affinecert.properties.law import OutOfDomain
from affinecert.scoring import Answer, Verdict, score
from affinecert.subject import Subject

LOG = CATALOGUE["so3.log"]
NAMED = [name for name, entry in CATALOGUE.items() if any(argument.manifold for argument in entry.arguments)]


def turn(angle: float) -> Array:
    return np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])


def skewed(rotation: Array) -> Array:
    """The rotation vectors (N, 3) by the difference from the transpose, the matrix taken as it is."""
    difference = (rotation - np.swapaxes(rotation, -1, -2)) / 2
    sine = np.stack([difference[:, 2, 1], difference[:, 0, 2], difference[:, 1, 0]], axis=-1)
    length = np.linalg.norm(sine, axis=-1, keepdims=True)
    cosine = (np.trace(rotation, axis1=-2, axis2=-1)[:, None] - 1) / 2
    return np.asarray(np.arctan2(length, cosine) / length * sine)


STRICT = Subject("skewed", "0", {"so3.log": skewed})
AS_IT_IS = "off the manifold"
AS_TOLD = replace(STRICT, policies={AS_IT_IS: "documented for rotation matrices"})


def verdict(subject: Subject, matrix: Array) -> tuple[str, str]:
    case = Case("so3.log", "given", (matrix,), 0.0, "given")
    (found,) = judge(subject, [case], truths_of([case]))
    return found.verdict, found.note


def test_the_distance_is_relative_and_a_similarity_s_size_is_free() -> None:
    stretch = np.diag([1 + 3e-8, 1.0, 1.0])
    assert distance(LOG, (turn(1.0),)) < 3e-16
    assert distance(LOG, (turn(1.0) @ stretch,)) == pytest.approx(3e-8 / np.sqrt(3), rel=1e-6)
    for size in (2.0**-40, 1.0, 1e200):
        pose = np.eye(4)
        pose[:3, :3] = size * turn(1.0)
        assert distance(CATALOGUE["sim3.log"], (pose,)) < 3e-16
    assert distance(CATALOGUE["sam.log"], (2 * np.eye(3),)) == 0.0
    assert distance(LOG, (np.full((3, 3), 1e300),)) == 0.0  # no rotation at all: what is said of it is no matter
    zero = np.zeros((4, 4))
    assert distance(CATALOGUE["sim3.log"], (zero,)) == distance(CATALOGUE["sym3.exp"], (zero[:3, :3],)) == 0.0
    assert distance(CATALOGUE["sym3.exp"], (np.eye(3) * 7 + np.diag([7e-8, 0], 1),)) == pytest.approx(
        1e-8 / np.sqrt(6), rel=1e-6
    )


def moved(argument: Argument, array: Array) -> Array:
    """The array off the argument's manifold by some 1e-8, with the same nearest element."""
    if argument.manifold == "symmetric matrices":
        return np.asarray(array + 2.0**-26 * np.max(np.abs(array)) * np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 0]]))
    if argument.manifold:
        stretch = np.diag([1 + 2.0**-26, 1.0, 1 / (1 + 2.0**-26)])  # of determinant 1: a similarity keeps its size
        array = array.copy()
        array[..., :3, :3] = array[..., :3, :3] @ stretch
    return array


@pytest.mark.parametrize("name", NAMED)
def test_where_the_catalogue_names_a_manifold_the_nearest_of_its_elements_counts(name: str) -> None:
    entry = CATALOGUE[name]
    (case,) = generate(entry, entry.regimes[0], 1)
    inputs = tuple(moved(*pair) for pair in zip(entry.arguments, case.inputs, strict=True))
    assert distance(entry, inputs) > 1e-9
    here, there = truths.value(entry, case.inputs), truths.value(entry, inputs)
    for before, after in zip(here.high, there.high, strict=True):
        np.testing.assert_allclose(after, before, rtol=0, atol=1e-13 * np.max(np.abs(before)))


@pytest.mark.parametrize("off", [1e-13, 1e-10, 3e-8])
def test_taken_as_it_is_a_matrix_is_scored_at_its_own_accuracy(off: float) -> None:
    matrix = turn(1.0) + off * np.outer([1, 2, 0], [1, 0, 1])
    strictly, note = verdict(STRICT, matrix)
    assert strictly in {Verdict.DEGRADED, Verdict.WRONG}
    assert AS_IT_IS in note
    found, note = verdict(AS_TOLD, matrix)
    assert found == Verdict.OK
    assert note.startswith("taken as it is, the input being ")


def test_what_amplifies_the_distance_stays_a_finding() -> None:
    near_pi = turn(np.pi - 1e-6) + 1e-9 * np.outer([1, 2, 0], [1, 0, 1])
    assert verdict(AS_TOLD, near_pi)[0] in {Verdict.DEGRADED, Verdict.WRONG}


def test_a_policy_may_speak_of_one_manifold_alone() -> None:
    matrix = turn(1.0) + 3e-8 * np.outer([1, 2, 0], [1, 0, 1])
    for kind, due in (("rotations", Verdict.OK), ("symmetric matrices", Verdict.WRONG)):
        subject = replace(STRICT, policies={f"off the manifold of {kind}": "as it is"})
        assert verdict(subject, matrix)[0] == due


def test_no_law_is_tried_off_the_manifold_on_what_is_taken_as_it_is() -> None:
    matrix = turn(1.0) + 3e-8 * np.outer([1, 2, 0], [1, 0, 1])
    assert singly(STRICT)["so3.log"](matrix).shape == (3,)
    assert singly(AS_TOLD)["so3.log"](turn(1.0)).shape == (3,)
    with pytest.raises(OutOfDomain, match="taken as it is"):
        singly(AS_TOLD)["so3.log"](matrix)


def test_on_the_manifold_the_policy_changes_nothing() -> None:
    sloppy = Subject("sloppy", "0", {"so3.log": lambda rotation: skewed(rotation) * (1 + 1e-12)})
    for subject in (sloppy, replace(sloppy, policies=AS_TOLD.policies)):
        found, note = verdict(subject, turn(1.0))
        assert found == Verdict.DEGRADED
        assert AS_IT_IS not in note


def test_either_axis_of_a_half_turn_off_the_manifold() -> None:
    half_turn = np.diag([-1.0, -1.0, 1.0]) * (1 + 1e-8)
    other = Subject("other", "0", {"so3.log": lambda _: np.array([[1e-8, 2e-8, -np.pi]])}, policies=AS_TOLD.policies)
    assert verdict(other, half_turn)[0] in {Verdict.OK, Verdict.OTHER_BRANCH}


def test_a_float32_subject_is_off_by_its_own_roundings() -> None:
    single = replace(AS_TOLD, dtype="float32")
    rounded = turn(1.0).astype(np.float32).astype(np.float64)
    assert slack(LOG, (rounded,), AS_TOLD) > 1e7
    assert slack(LOG, (rounded,), single) < 2
    assert slack(LOG, (rounded,), STRICT) == 1
    assert single.arithmetic is FLOAT32


def test_a_certificate_tells_what_its_subject_is_excused_by() -> None:
    subject = replace(AS_TOLD, conventions={"angle": "radian"}, refusals={"Expect": "to 20 eps"})
    policy = f"policy, {AS_IT_IS}"
    assert subject.words == {"angle": "radian", policy: AS_TOLD.policies[AS_IT_IS], "refusal, Expect": "to 20 eps"}


def test_documented_refusals_inside_the_domain_are_absent() -> None:
    (truth,) = truths_of([Case("so3.log", "given", (turn(1.0),), 0.0, "given")])
    said, refusals = Answer(None, "ValueError: Expect SO(3)"), {"Expect SO(3)": "to 20 eps"}
    found = score(LOG, said, truth, refusals=refusals)
    assert found.verdict is Verdict.ABSENT
    assert found.note == "refused (ValueError: Expect SO(3)), as documented: to 20 eps"
    assert score(LOG, said, truth).verdict is Verdict.RAISED
    assert score(LOG, Answer(None, "ValueError: Expect SE(3)"), truth, refusals=refusals).verdict is Verdict.RAISED
    assert score(LOG, replace(said, broken=True), truth, refusals=refusals).verdict is Verdict.RAISED
    (refused,) = truths_of([Case("so3.log", "given", (2 * np.eye(3),), 0.0, "given")])
    assert score(LOG, said, refused, refusals=refusals).verdict is Verdict.OK
