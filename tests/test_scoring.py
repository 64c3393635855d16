"""The verdicts, on truths made up for the purpose."""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.arithmetic import FLOAT64
from affinecert.catalogue import CATALOGUE
from affinecert.magnitude import length
from affinecert.map import Argument, Block, Group, Map
from affinecert.scoring import Answer, Score, Verdict, block_score, score
from affinecert.truths import Truth

ENTRY = Map(
    name="test.pair",
    definition="two outputs, the second in two blocks",
    source="here",
    domain="everywhere",
    arguments=(Argument("x", (2,), (Group(...),)),),
    outputs=((2,), (3,)),
    blocks=(Block("first", 0, ...), Block("head", 1, slice(0, 1)), Block("tail", 1, slice(1, 3))),
    regimes=(),
    reference=lambda ctx, x: (x, x),
    continuation=lambda ctx, base, x: (x, x),
    bound=16.0,
)
Array = NDArray[Any]

FIRST = np.array([3.0, 4.0])
SECOND = np.array([1.0, 0.0, 2.0])


def truth(first: Array = FIRST, second: Array = SECOND, sensitivity: tuple[float, ...] = (0.0, 0.0, 0.0)) -> Truth:
    return Truth((first, second), (np.zeros(2), np.zeros(3)), sensitivity, None)


def judged(
    first: Array = FIRST, second: Array = SECOND, due: Truth | None = None, backward: float | None = None
) -> Score:
    return score(ENTRY, Answer((first, second)), due or truth(), backward)


def test_the_exact_answer_is_ok_with_error_zero() -> None:
    result = judged()
    assert result.verdict is Verdict.OK
    assert (result.forward, result.scaled) == (0.0, 0.0)


def test_errors_are_told_in_units_of_u_relative_to_the_norm_of_the_block() -> None:
    result = judged(FIRST + np.array([0.0, 2.0**-50]))
    assert result.blocks[0].forward == pytest.approx(2.0**-50 / 5 / FLOAT64.unit)
    assert result.forward == result.blocks[0].forward


def test_blocks_of_one_output_are_scored_apart() -> None:
    result = judged(second=SECOND * (1 + np.array([0.0, 0.0, 2.0**-40])))
    assert [block.forward > 0 for block in result.blocks] == [False, False, True]


def test_low_counts_where_high_alone_would_hide_an_error() -> None:
    one = np.array([1.0])
    assert block_score("b", one, one, np.array([2.0**-54]), 0.0).forward == pytest.approx(0.5)


def test_the_scaled_error_forgives_what_the_condition_explains() -> None:
    wrong = FIRST * (1 + 2.0**-43)
    assert judged(wrong).verdict is Verdict.DEGRADED
    forgiven = judged(wrong, due=truth(sensitivity=(5.0 * 1023, 0.0, 0.0)))
    assert forgiven.verdict is Verdict.OK
    assert forgiven.blocks[0].condition == pytest.approx(1023)
    assert forgiven.blocks[0].forward == pytest.approx(1024 * forgiven.blocks[0].scaled)


@pytest.mark.parametrize(
    ("units", "verdict"),
    [
        (16, Verdict.OK),
        (17, Verdict.DEGRADED),
        (FLOAT64.lost_half * 0.99, Verdict.DEGRADED),
        (FLOAT64.lost_half * 1.01, Verdict.WRONG),
        (1 / FLOAT64.unit, Verdict.WRONG),
    ],
)
def test_the_verdict_by_the_size_of_the_scaled_error(units: float, verdict: Verdict) -> None:
    due = truth(first=np.array([1.0, 0.0]))
    assert judged(np.array([1.0, units * FLOAT64.unit]), due=due).verdict is verdict


def test_a_degraded_answer_says_how_many_bits_are_lost() -> None:
    assert "6.0 bits" in judged(np.array([1.0, 1024 * FLOAT64.unit]), due=truth(first=np.array([1.0, 0.0]))).note


def test_the_worst_block_gives_the_verdict() -> None:
    assert judged(second=np.array([1.0, 0.0, 3.0])).verdict is Verdict.WRONG


@pytest.mark.parametrize(
    ("backward", "verdict"), [(2.0, Verdict.OTHER_BRANCH), (1e9, Verdict.WRONG), (None, Verdict.WRONG)]
)
def test_another_branch_is_wrong_forward_and_right_backward(backward: float | None, verdict: Verdict) -> None:
    result = judged(-FIRST, backward=backward)
    assert result.verdict is verdict
    assert not math.isfinite(result.scaled) or result.scaled > FLOAT64.lost_half


def test_only_a_map_that_jumps_has_other_branches() -> None:
    steady = replace(ENTRY, continuation=None)
    assert score(steady, Answer((-FIRST, SECOND)), truth(), backward=0.0).verdict is Verdict.WRONG


def test_a_small_error_is_never_excused_as_another_branch() -> None:
    assert judged(FIRST * (1 + 2.0**-40), backward=0.0).verdict is Verdict.DEGRADED


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_nan_or_infinity_where_a_number_is_due(bad: float) -> None:
    result = judged(np.array([3.0, bad]))
    assert result.verdict is Verdict.NON_FINITE
    assert result.scaled == math.inf


def test_a_raised_error_keeps_its_complaint() -> None:
    result = score(ENTRY, Answer(None, "ValueError: no"), truth())
    assert result.verdict is Verdict.RAISED
    assert result.note == "ValueError: no"
    assert [block.block for block in result.blocks] == ["first", "head", "tail"]


@pytest.mark.parametrize(
    ("outputs", "note"),
    [
        ((FIRST,), "1 outputs where 2 are due"),
        ((FIRST, SECOND, SECOND), "3 outputs where 2 are due"),
        ((FIRST, SECOND[:2]), r"output 1 has shape (2,) where (3,) is due"),
        ((FIRST[:, None], SECOND), r"output 0 has shape (2, 1) where (2,) is due"),
        ((FIRST + 1j, SECOND), "complex where a real value is due"),
    ],
)
def test_misshapen_answers_are_wrong(outputs: tuple[Array, ...], note: str) -> None:
    result = score(ENTRY, Answer(outputs), truth())
    assert result.verdict is Verdict.WRONG
    assert result.note == note
    assert result.scaled == math.inf


REFUSED = Truth((), (), (), "not a rotation")


@pytest.mark.parametrize(
    "answer",
    [Answer(None, "ValueError"), Answer((np.full(2, np.nan), SECOND)), Answer((FIRST, np.array([1.0, np.inf, 0.0])))],
    ids=["raised", "nan", "infinity"],
)
def test_outside_the_domain_a_refusal_is_ok(answer: Answer) -> None:
    result = score(ENTRY, answer, REFUSED)
    assert result.verdict is Verdict.OK
    assert result.note == "rightly refused: not a rotation"


def test_outside_the_domain_a_silent_answer_is_wrong() -> None:
    result = score(ENTRY, Answer((FIRST, SECOND)), REFUSED)
    assert result.verdict is Verdict.WRONG
    assert "silent answer outside the domain: not a rotation" in result.note


def test_outside_the_domain_a_complex_logarithm_is_a_refusal() -> None:
    logarithm: Array = FIRST + 1j
    assert score(ENTRY, Answer((logarithm, SECOND)), REFUSED).verdict is Verdict.OK


def test_a_documented_policy_acquits_an_answer_outside_the_domain() -> None:
    policies = {"not a rotation": "the nearest rotation counts"}
    result = score(ENTRY, Answer((FIRST, SECOND)), REFUSED, policies=policies)
    assert result.verdict is Verdict.OK
    assert "a documented policy: the nearest rotation counts" in result.note
    other = score(ENTRY, Answer((FIRST, SECOND)), REFUSED, policies={"determinant": "ignored"})
    assert other.verdict is Verdict.WRONG


def test_a_complex_answer_is_right_where_rounding_decides_whether_a_real_one_exists() -> None:
    logarithm: Array = FIRST + 1j
    answer = Answer((logarithm, SECOND))
    assert score(ENTRY, answer, truth(sensitivity=(5.1 * 2.0**53, 0.0, 0.0))).verdict is Verdict.OK
    assert score(ENTRY, answer, truth(sensitivity=(2.0**46, 0.0, 0.0))).verdict is Verdict.DEGRADED
    assert score(ENTRY, answer, truth()).verdict is Verdict.WRONG


@pytest.mark.parametrize(
    ("imaginary", "verdict"), [(4, Verdict.DEGRADED), (1e4, Verdict.DEGRADED), (2.0**30, Verdict.WRONG), (np.nan, None)]
)
def test_an_imaginary_part_is_an_error_as_any_other(imaginary: float, verdict: Verdict | None) -> None:
    logarithm: Array = FIRST + 1j * imaginary * FLOAT64.unit * FIRST
    result = score(ENTRY, Answer((logarithm, SECOND)), truth())
    assert result.verdict is (verdict or Verdict.NON_FINITE)
    if verdict is Verdict.DEGRADED:
        assert result.blocks[0].forward == pytest.approx(imaginary)
        said = "by an imaginary part of rounding" if imaginary == 4 else "9.3 bits beyond the bound"
        assert result.note == f"complex where a real value is due, {said}"
    else:
        assert result.scaled == math.inf


@pytest.mark.parametrize(
    ("map_name", "place", "size"),
    [("se3.exp", (3, 3), 1.0), ("se3.exp", (3, 0), 1.0), ("shear.exp", (2, 0), 1.0), ("sam.log", (2, 1), 5.0)],
)
@pytest.mark.parametrize(("off", "verdict"), [(4, Verdict.OK), (1e4, Verdict.DEGRADED), (2.0**30, Verdict.WRONG)])
def test_entries_of_no_block_are_what_they_are_due_to_be(
    map_name: str, place: tuple[int, int], size: float, off: float, verdict: Verdict
) -> None:
    entry, side = CATALOGUE[map_name], place[0] + 1
    value = np.eye(side)
    if map_name == "sam.log":
        value = np.zeros((side, side))
        value[0, 0], value[0, 1] = 3.0, 4.0
    due = Truth((value,), (np.zeros_like(value),), (0.0,) * len(entry.blocks), None)
    answer = value.copy()
    answer[place] += off * FLOAT64.unit * size
    result = score(entry, Answer((answer,)), due)
    assert result.verdict is verdict
    assert result.scaled == pytest.approx(off)
    assert result.blocks[-1].block == "fixed entries"
    assert len(score(entry, Answer((value,)), due).blocks) == len(entry.blocks)


def test_a_truth_of_zero_wants_zero() -> None:
    due = truth(first=np.zeros(2))
    assert judged(np.zeros(2), due=due).verdict is Verdict.OK
    assert judged(np.array([1e-30, 0.0]), due=due).verdict is Verdict.WRONG


def test_a_truth_of_zero_is_measured_against_its_sensitivity() -> None:
    due = truth(first=np.zeros(2), sensitivity=(1.0, 0.0, 0.0))
    result = judged(np.array([2 * FLOAT64.unit, 0.0]), due=due)
    assert result.verdict is Verdict.OK
    assert result.blocks[0].scaled == pytest.approx(2.0)
    assert result.blocks[0].forward > FLOAT64.lost_half


def test_gradual_underflow_is_no_error() -> None:
    least = sys.float_info.min * 2.0**-52
    due = truth(first=np.array([3 * least, 0.0]))
    assert judged(np.array([2 * least, 0.0]), due=due).verdict is Verdict.OK
    assert judged(np.array([100 * least, 0.0]), due=due).verdict is Verdict.DEGRADED


def test_a_truth_beyond_float64_wants_the_same_infinity() -> None:
    due = truth(first=np.array([np.inf, 1.0]))
    right = judged(np.array([np.inf, 1.0]), due=due)
    assert right.verdict is Verdict.OK
    assert (right.forward, right.scaled) == (0.0, 0.0)
    for other in (-np.inf, sys.float_info.max, np.nan):
        result = judged(np.array([other, 1.0]), due=due)
        assert result.verdict.is_finding
        assert result.scaled == math.inf


@pytest.mark.parametrize("size", [1e-290, 1e-160, 1.0, 1e160, 1e307])
def test_the_score_does_not_depend_on_the_size(size: float) -> None:
    entries = np.array([0.75, 1.0]) * size
    assert length(entries) == pytest.approx(1.25 * size)
    result = block_score("b", entries * (1 + 2.0**-40), entries, np.zeros(2), 0.0)
    assert result.forward == pytest.approx(2.0**13, rel=1e-2)


def test_norms_beyond_float64_do_not_raise() -> None:
    largest = np.full(4, sys.float_info.max)
    assert length(largest) == sys.float_info.max
    assert block_score("b", largest, largest, np.zeros(4), 0.0).scaled == 0.0
    assert block_score("b", -largest, largest, np.zeros(4), 0.0).scaled > FLOAT64.lost_half


def test_no_error_is_ever_nan() -> None:
    edges = [0.0, -0.0, 5e-324, 1.0, sys.float_info.max, math.inf]
    for high in edges:
        for got in (*edges, math.nan):
            for sensitivity in (0.0, 1.0, sys.float_info.max):
                result = block_score("b", np.array([got]), np.array([high]), np.zeros(1), sensitivity)
                assert not any(math.isnan(value) for value in (result.forward, result.scaled, result.condition))


def test_findings_are_what_makes_a_run_fail() -> None:
    assert {verdict for verdict in Verdict if verdict.is_finding} == {
        Verdict.DEGRADED,
        Verdict.WRONG,
        Verdict.NON_FINITE,
        Verdict.RAISED,
    }
