"""The hunt: it catches its prey, repeats itself, survives being stopped, and says what is wrong with its arguments."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from fnmatch import fnmatch
from functools import cache
from itertools import pairwise
from pathlib import Path
from random import Random

import numpy as np
import pytest

from affinecert import catalogue, corpus
from affinecert.arithmetic import FLOAT64
from affinecert.case import to_record
from affinecert.climb import Arm, Ground, build, choose, learn, propose, shift
from affinecert.errors import StoredFileError, SubjectError, UnknownNameError
from affinecert.fast import quaternion
from affinecert.hunt import Catch, hunt
from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.printed import subject as printed

TOTAL = 1.0
"""A relative error of 1: nothing is left."""


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A store of the tests' own."""
    return tmp_path_factory.mktemp("store") / "store.sqlite"


@cache
def caught(name: str, store: Path) -> dict[str, Catch]:
    return {catch.case.regime: catch for catch in hunt("printed", name, evaluations=400, store=store)}


def told_by(catches: Iterable[Catch]) -> list[tuple[object, ...]]:
    """What can be compared of catches: cases hold arrays."""
    return [(to_record(catch.case), catch.scaled, catch.forward, catch.verdict, catch.evaluations) for catch in catches]


@pytest.mark.parametrize(
    ("name", "regimes", "loss"),
    [
        ("so3.log", "near-identity", TOTAL),  # arccos of the trace
        ("so3.log", "near-pi", TOTAL),  # the antisymmetric part
        ("se3.exp", "near-identity", 1e-9),  # the coefficient of Omega in V is lost at 1e-8, half of it reaches V v
        ("se3.exp", "*", TOTAL),  # theta^3 underflows
        ("sim3.exp", "both-near-zero", 0.1),  # (e^lambda - 1) / lambda, over theta^2 and once more
        ("shear.exp", "*", TOTAL),
        ("shear.log", "*", 0.1),
        ("sam.log", "double-eigenvalue-*", TOTAL),  # forgotten by algorithm 1
    ],
)
def test_the_prey_is_caught(name: str, regimes: str, loss: float, store: Path) -> None:
    lost = [catch.forward * FLOAT64.unit for regime, catch in caught(name, store).items() if fnmatch(regime, regimes)]
    assert max(lost) >= loss


def test_sam_existence_by_the_printed_discriminant_is_caught(store: Path) -> None:
    assert {"wrong"} <= {catch.verdict for catch in caught("sam.exists", store).values()}


def test_what_is_right_is_acquitted_with_its_one_worst_input(store: Path) -> None:
    (catch,) = hunt("printed", "so3.exp", evaluations=100, store=store)
    assert catch.verdict == "ok"
    assert 0 < catch.scaled <= catalogue.find("so3.exp").bound
    assert catch.evaluations == 100


def test_the_same_seed_and_count_catch_the_same(store: Path, tmp_path: Path) -> None:
    first = told_by(hunt("printed", "shear.*", evaluations=60, seed=7, store=store))
    assert first == told_by(hunt("printed", "shear.*", evaluations=60, seed=7, store=tmp_path / "other.sqlite"))
    assert first != told_by(hunt("printed", "shear.*", evaluations=60, seed=8, store=store))


def test_a_hunt_that_was_stopped_goes_on(store: Path, tmp_path: Path) -> None:
    def stop(evaluations: int, worst: float, doing: str) -> None:
        if evaluations == 37:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        hunt("printed", "se3.log", evaluations=80, out=tmp_path, progress=stop, store=store)
    told: list[int] = []
    halves = hunt(
        "printed", "se3.log", evaluations=80, out=tmp_path, store=store, progress=lambda n, worst, doing: told.append(n)
    )
    assert told == list(range(38, 81))
    assert told_by(halves) == told_by(hunt("printed", "se3.log", evaluations=80, store=store))


def test_a_finished_hunt_only_repeats_its_catches(store: Path, tmp_path: Path) -> None:
    first = hunt("printed", "shear.log", evaluations=50, out=tmp_path, store=store)
    told: list[int] = []
    again = hunt(
        "printed",
        "shear.log",
        evaluations=50,
        out=tmp_path,
        store=store,
        progress=lambda n, worst, doing: told.append(n),
    )
    assert told_by(again) == told_by(first)
    assert told == []
    assert len(corpus.read(tmp_path / "printed.jsonl")) == len(first)


def test_catches_are_stored_with_their_provenance(store: Path, tmp_path: Path) -> None:
    catches = hunt("printed", "shear.exp", evaluations=50, seed=3, out=tmp_path, store=store)
    stored = corpus.read(tmp_path / "printed.jsonl")
    assert {case.key for case in stored} == {catch.case.key for catch in catches}
    assert all(case.provenance.startswith("hunt, printed, seed 3, evaluation ") for case in stored)


def test_a_budget_in_seconds_ends_the_hunt(store: Path) -> None:
    catches = hunt("printed", "so3.log", budget=0.5, store=store)
    assert catches
    assert catches[0].evaluations >= 1


def test_progress_tells_the_count_the_worst_and_the_place(store: Path) -> None:
    told: list[tuple[int, float, str]] = []
    hunt("printed", "shear.*", evaluations=20, store=store, progress=lambda *now: told.append(now))
    assert [count for count, _, _ in told] == list(range(1, 41))
    assert all(after >= before for (_, before, _), (_, after, _) in pairwise(told))
    assert told[0][2].startswith("shear.exp ")
    assert told[-1][2].startswith("shear.log ")


def test_a_changed_subject_is_hunted_from_the_beginning(store: Path, tmp_path: Path) -> None:
    hunt(printed, "so3.log", evaluations=30, out=tmp_path, store=store)
    told: list[int] = []
    newer = replace(printed, version="next")
    hunt(newer, "so3.log", evaluations=30, out=tmp_path, store=store, progress=lambda n, worst, doing: told.append(n))
    assert told[0] == 1


def _nothing(rotation: Array) -> Array:
    return np.zeros((len(rotation), 3))


def _raises(rotation: Array) -> Array:
    raise RuntimeError("no")


@pytest.mark.parametrize(("function", "verdict"), [(_nothing, "wrong"), (_raises, "raised")])
def test_inputs_outside_the_domain_are_no_prey(function: object, verdict: str, store: Path) -> None:
    bad = Subject("bad", "1", {"so3.log": function})  # type: ignore[dict-item]
    catches = hunt(bad, evaluations=60, store=store)
    assert {catch.verdict for catch in catches} == {verdict}
    assert "outside" not in {catch.case.regime for catch in catches}


def _the_other_way_at_a_tie(start: Array, end: Array, t: Array) -> Array:
    """Slerp by the other arc where the quaternions are orthogonal to within rounding, and either is the shorter."""
    arc = quaternion.slerp(start, end, t)
    along = np.sum(arc * start, axis=-1) / np.sum(start * start, axis=-1)
    tied = np.abs(np.sum(start * end, axis=-1)) <= 2.0**-52
    return np.where(tied[:, None], 2 * along[:, None] * start - arc, arc)


def test_an_answer_beyond_a_jump_wins_no_hunt(store: Path) -> None:
    tied = Subject("tied", "1", {"quaternion.slerp": _the_other_way_at_a_tie})
    (catch,) = hunt(tied, evaluations=60, store=store)
    assert catch.verdict == "ok"
    assert catch.scaled <= catalogue.find("quaternion.slerp").bound


def test_a_map_that_the_subject_lacks_is_told() -> None:
    with pytest.raises(SubjectError, match=r"printed offers no map that matches 'sam.power'; it has sam.exists"):
        hunt("printed", "sam.power")


def test_an_unknown_map_is_told() -> None:
    with pytest.raises(UnknownNameError, match=r"no map is named 'so3.lgo'; did you mean so3.log"):
        hunt("printed", "so3.lgo")


def test_a_trail_that_cannot_be_read_is_told(store: Path, tmp_path: Path) -> None:
    (tmp_path / "printed.hunt.json").write_text('{"format": 1, "climbs": []}')
    with pytest.raises(StoredFileError, match=r"cannot read the hunt's trail .*; delete it to start afresh"):
        hunt("printed", "so3.log", evaluations=5, out=tmp_path, store=store)


def test_a_folder_that_cannot_be_written_is_told(store: Path, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(StoredFileError, match=r"cannot write the hunt's trail"):
        hunt("printed", "so3.log", evaluations=5, out=tmp_path / "file", store=store)


def ground() -> Ground:
    entry = catalogue.find("so3.log")
    regime = next(regime for regime in entry.regimes if regime.name == "near-pi")
    return Ground(entry.name, regime.name, regime)


def test_coordinates_build_the_same_input_again() -> None:
    coordinates = [Random(5).random() for _ in range(64)]
    first, second = build(ground(), coordinates), build(ground(), coordinates)
    assert first.case.key == second.case.key
    assert 0 < first.used <= 64


def test_coordinates_that_run_out_are_filled_up() -> None:
    assert build(ground(), [0.5]).case.key == build(ground(), [0.5]).case.key


def test_last_places_move_but_zeros_stay() -> None:
    start = build(ground(), [0.0] * 64)
    random = Random(0)
    for _ in range(50):
        moved = shift(start, random).case.inputs[0]
        assert np.array_equal(moved == 0, start.case.inputs[0] == 0)
        assert np.allclose(moved, start.case.inputs[0], rtol=1e-12, atol=0)


def heights(arm: Arm, found: Iterator[float | None]) -> Arm:
    candidate = build(ground(), [0.5] * 64)
    for number, height in enumerate(found):
        arm = learn(arm, candidate, height, number)
    return arm


def test_an_arm_keeps_the_worst_and_restarts_when_nothing_gives() -> None:
    arm = heights(Arm("near-pi"), iter([1.0, 5.0, 3.0]))
    assert arm.incumbent is not None
    assert arm.incumbent.height == 5.0
    stuck = heights(arm, iter([2.0] * 60))
    assert stuck.worst is not None
    assert stuck.worst.height == 5.0
    assert stuck.worst.evaluation == 1
    assert stuck.incumbent is not None
    assert stuck.incumbent.height == 2.0


def test_arms_are_given_up_outside_the_domain_and_where_nothing_worse_is_left() -> None:
    outside = heights(Arm("outside"), iter([None] * 8))
    infinite = heights(Arm("near-pi"), iter([math.inf]))
    fresh = Arm("generic")
    assert outside.is_over
    assert infinite.is_over
    assert choose([outside, infinite, fresh]) == 2
    assert choose([outside, infinite]) is None


def test_stored_cases_come_first() -> None:
    case = build(ground(), [0.25] * 64).case
    candidate = propose(replace(ground(), stored=(case,)), Arm("near-pi"), Random(0))
    assert candidate.case == case


def test_the_trail_is_strict_json(store: Path, tmp_path: Path) -> None:
    hunt("printed", "so3.log", evaluations=40, out=tmp_path, store=store)

    def refuse(constant: str) -> None:
        raise AssertionError(constant)

    json.loads((tmp_path / "printed.hunt.json").read_text(), parse_constant=refuse)
