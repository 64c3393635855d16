from __future__ import annotations

import io
import json
import re
from pathlib import Path

import numpy as np
import pytest
from rich.console import Console

from affinecert import corpus, reports
from affinecert.case import Case, dump_line
from affinecert.catalogue import CATALOGUE
from affinecert.errors import InputError, StoredFileError, UnknownNameError
from affinecert.explain import Entry, entries, explain
from affinecert.inputs import read_inputs
from affinecert.map import Array
from affinecert.replay import load, replay
from affinecert.reports import explanation as rendering
from affinecert.scoring import Verdict
from affinecert.subject import Subject
from affinecert.truths import Truth

from . import certificates

QUARTER = "[[0, -1, 0], [1, 0, 0], [0, 0, 1]]"


def trace_log(rotation: Array) -> Array:
    """The textbook's logarithm, by arc cosine of the trace: lost near 0 and near pi."""
    cosine = (np.trace(rotation, axis1=1, axis2=2) - 1) / 2
    angle = np.arccos(cosine)
    skew = (rotation - np.swapaxes(rotation, 1, 2))[:, [2, 0, 1], [1, 2, 0]]
    return np.asarray(angle / (2 * np.sin(angle)))[:, None] * skew


def fails(rotation: Array) -> Array:
    raise RuntimeError("out of order\nand so on")


TRACE = Subject("trace", "1.0", {"so3.log": trace_log})
FLAT = Subject("flat", "1.0", {"so3.log": lambda rotation: np.zeros((len(rotation), 2))})
FAILING = Subject("failing", "1.0", {"so3.log": fails})
NOTHING = Subject("nothing", "1.0", {})


def shown(map_: str, inputs: str, *subjects: Subject) -> str:
    stream = io.StringIO()
    console = Console(file=stream, width=100, highlight=False, markup=False)
    rendering.show(explain(map_, inputs, subjects), console)
    return stream.getvalue()


@pytest.mark.parametrize(
    ("map_", "text", "inputs"),
    [
        ("so3.exp", "[0.1, 0.2, 0.3]", [[0.1, 0.2, 0.3]]),
        ("so3.exp", "[[0.1, 0.2, 0.3]]", [[0.1, 0.2, 0.3]]),
        ("so3.exp", '["0x1p-3", "-0x1.8p+1", 0]', [[0.125, -3.0, 0.0]]),
        ("scale.exp", "0.5", [0.5]),
        ("scale.exp", "[0.5]", [0.5]),
        ("so3.log_near", f"[{QUARTER}, [1, 0, 0]]", [json.loads(QUARTER), [1, 0, 0]]),
        ("sam.power", "[[[1, 0, 0], [0, 1, 0], [0, 0, 1]], 0.5]", [np.eye(3), 0.5]),
        ("sam.log", "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]", [np.eye(4)]),
    ],
)
def test_inputs_are_read(map_: str, text: str, inputs: list[object]) -> None:
    arrays = read_inputs(CATALOGUE[map_], text)
    assert len(arrays) == len(inputs)
    for array, due in zip(arrays, inputs, strict=True):
        assert array.dtype == np.float64
        np.testing.assert_array_equal(array, np.asarray(due))


@pytest.mark.parametrize(
    ("map_", "text", "message"),
    [
        ("so3.exp", "[0.1, 0.2", "INPUT: not JSON: Expecting ',' delimiter: line 1 column 10 (char 9)"),
        ("so3.exp", "[0.1, 0.2]", "omega: shape (2,) where (3,) is due"),
        ("so3.exp", "[]", "omega: shape (0,) where (3,) is due"),
        ("so3.exp", '["a", 0, 0]', "omega: not an array of numbers: could not convert string to float: 'a'"),
        ("so3.exp", '{"omega": 1}', "omega: not an array of numbers:"),
        ("so3.exp", "[NaN, 0, 0]", "omega: not finite"),
        ("so3.exp", "[1e400, 0, 0]", "omega: not finite"),
        ("so3.exp", "null", "omega: not an array of numbers:"),
        ("so3.log", "[[1, 0, 0], [0, 1], [0, 0, 1]]", "rotation: not an array of numbers:"),
        ("so3.log_near", QUARTER, "INPUT: a list of 2 is due: rotation, near"),
        ("sam.log", "[[1]]", "affine: shape (1, 1) where (3, 3) or (4, 4) is due"),
        (
            "sam.morph",
            "[[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]], 0.5]",
            "end: shape (4, 4) where (3, 3) is due",
        ),
    ],
)
def test_bad_inputs_are_told_by_argument(map_: str, text: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        read_inputs(CATALOGUE[map_], text)
    assert str(caught.value).startswith(message)


def test_an_unknown_map_is_told_with_its_nearest() -> None:
    with pytest.raises(UnknownNameError, match=r"no map is named 'so3\.lgo'; did you mean so3\.log"):
        explain("so3.lgo", QUARTER, [])


def test_truth_is_told_to_thirty_digits() -> None:
    truth = Truth(
        (np.array([np.pi, 0.0]), np.array(5e-324)), (np.array([1.2246467991473532e-16, 0.0]), np.array(0.0)), (), None
    )
    assert entries(truth) == (
        Entry(0, (0,), "3.14159265358979323846264338328"),
        Entry(0, (1,), "0"),
        Entry(1, (), "4.94065645841246544176568792868E-324"),
    )


def test_an_explanation_holds_truth_answers_and_verdicts() -> None:
    near_pi = "[[[-1, 1e-9, 0], [-1e-9, -1, 0], [0, 0, 1]]]"
    told = explain("so3.log", near_pi, [TRACE, FLAT, FAILING, NOTHING])
    assert [reply.score.verdict for reply in told.replies] == [
        Verdict.WRONG,
        Verdict.WRONG,
        Verdict.RAISED,
        Verdict.ABSENT,
    ]
    assert abs(told.truth.high[0][2]) == pytest.approx(np.pi - 1e-9, abs=1e-15)


def test_an_explanation_is_shown_on_100_columns() -> None:
    text = shown("so3.log", QUARTER, TRACE, FLAT, FAILING, NOTHING)
    assert max(map(len, text.splitlines())) <= 100
    assert "1.57079632679489661923132169164" in text
    assert "trace 1.0" in text
    assert "flat: output 0 has shape (2,) where (3,) is due" in text
    assert "failing: RuntimeError: out of order and so on" in text
    assert "nothing: the subject does not offer this map" in text


def test_several_outputs_are_told_apart() -> None:
    identity = "[[[2, 0, 0, 1], [0, 2, 0, 2], [0, 0, 2, 3], [0, 0, 0, 1]]]"
    text = shown("affine_lie.decompose", identity, NOTHING)
    assert "output 1 [3, 3]" in text
    assert "output 2 [2, 2]" in text
    assert re.search(r"^output 3 +2 *$", text, re.MULTILINE)


def test_outside_the_domain_a_refusal_is_right() -> None:
    reflection = "[[[1, 0, 0], [0, 1, 0], [0, 0, -1]]]"
    told = explain("so3.log", reflection, [FAILING, FLAT])
    assert [reply.score.verdict for reply in told.replies] == [Verdict.OK, Verdict.WRONG]
    assert "outside the domain: not a rotation" in shown("so3.log", reflection, FAILING)


def case(map_: str = "so3.log", inputs: tuple[Array, ...] = (np.eye(3),)) -> Case:
    return Case(map_, "near-identity", inputs, 0.0, "by hand")


def test_a_corpus_is_replayed(tmp_path: Path) -> None:
    path = tmp_path / "so3.jsonl"
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    corpus.append(path, [case(), case(inputs=(turn,)), case("so3.exp", (np.ones(3),))])
    results = replay(load(path), TRACE)
    assert [result.case["map"] for result in results] == ["so3.log", "so3.log"]
    assert [result.verdict for result in results] == ["non-finite", "ok"]


def test_the_worst_inputs_of_a_certificate_are_replayed(tmp_path: Path) -> None:
    rotations = [case(inputs=(turn,)) for turn in (np.eye(3), np.diag([-1.0, -1.0, 1.0]))]
    results = [
        certificates.case_result(inputs=rotation.inputs, scaled=1e9, verdict=Verdict.WRONG) for rotation in rotations
    ]
    row = certificates.regime_result("so3.log", "near-pi", results)
    path, *_ = reports.write(certificates.certificate((row,)), tmp_path)
    assert len(load(path)) == 2
    assert [result.verdict for result in replay(load(path), TRACE)] == ["non-finite", "wrong"]


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.jsonl", "{", "a.jsonl:1: not JSON"),
        ("a.jsonl", '{"map": "so3.log"}', "a.jsonl:1: not a case: KeyError: 'regime'"),
        ("a.jsonl", "[1]", "a.jsonl:1: not a case"),
        (
            "a.jsonl",
            dump_line(case(inputs=(np.eye(2),))),
            "does not fit it: rotation: shape (2, 2) where (3, 3) is due",
        ),
        ("a.jsonl", dump_line(case(inputs=())), "does not fit it: inputs: 0 arguments where 1 are due"),
        ("a.json", "{", "cannot read the certificate"),
        ("a.json", "{}", "not a certificate of format 2"),
    ],
)
def test_a_corrupt_file_is_told_by_name(tmp_path: Path, name: str, text: str, message: str) -> None:
    (tmp_path / name).write_text(text, encoding="utf-8")
    with pytest.raises(StoredFileError) as caught:
        load(tmp_path / name)
    assert message in str(caught.value)
    assert name in str(caught.value)


def test_a_case_of_an_unknown_map_is_told(tmp_path: Path) -> None:
    (tmp_path / "a.jsonl").write_text(dump_line(case("so4.log")), encoding="utf-8")
    with pytest.raises(UnknownNameError, match=r"no map is named 'so4\.log'"):
        load(tmp_path / "a.jsonl")
