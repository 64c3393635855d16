"""Judging: each way in which an entry may not stand is told, and nothing false is confirmed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import mpmath
import pytest

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.finding import judge, told
from affinecert.properties.claims.precision import equals, exactly, mp


def line(slope: float, offset: float = 0.0) -> Any:
    return lambda m, x: m.mpf(slope) * x + m.mpf(offset)


def at(*points: float) -> Any:
    return lambda: [(mp.mpf(point),) for point in points]


CONFIRMED: Claim[Any, Any] = Claim(
    id="paper.1.double",
    place="section 1",
    statement="Twice a number is the number and itself.",
    verdict=Verdict.CONFIRMED,
    form=line(2),
    cases=at(1, 3),
    deviation=equals(lambda m, x: x + x),
    copies=(Copy("3 for 2", line(3)),),
)

REFUTED = replace(
    CONFIRMED,
    verdict=Verdict.REFUTED,
    form=line(2, 1),
    fault=Fault.SLIP,
    correction=Correction(statement="without the 1", form=line(2)),
    cases=at(1, 3),
)

BOUND = replace(
    CONFIRMED,
    verdict=Verdict.BOUND,
    deviation=equals(lambda m, x: abs(x + x)),
    domain="numbers that are not negative",
    outside=at(-1e-3),
)


@pytest.mark.parametrize("claim", [CONFIRMED, REFUTED, BOUND], ids=lambda claim: str(claim.verdict))
def test_an_entry_stands(claim: Claim[Any, Any]) -> None:
    finding = judge(claim)
    assert finding.complaints == ()
    assert finding.verdict == claim.verdict


def test_the_counterexample_is_the_first_case_that_deviates() -> None:
    finding = judge(replace(REFUTED, form=lambda m, x: 2 * x + (m.one if x > 2 else m.zero)))
    assert (finding.counterexample_case, finding.counterexample) == (1, "3")
    assert finding.deviation == pytest.approx(1 / 6)


@pytest.mark.parametrize(
    ("claim", "complaint"),
    [
        (replace(CONFIRMED, form=line(3)), "confirmed is stated"),
        (replace(CONFIRMED, copies=(Copy("nothing", line(2)),)), "a copy is not refuted: nothing"),
        (replace(CONFIRMED, copies=(Copy("too little", line(2, 1e-20)),)), "a copy is not refuted: too little"),
        (replace(CONFIRMED, form=line(2, 1e-20)), "the form deviates by 5.0e-21 in case 0"),
        (replace(CONFIRMED, cases=at()), "no case is tried"),
        (replace(REFUTED, form=line(2)), "refuted is stated"),
        (replace(REFUTED, correction=Correction(statement="with 2", form=line(2, 2))), "the correction deviates by 1"),
        (replace(BOUND, outside=at(-1, 2)), "holds outside of the domain, in case 1 there"),
        (replace(BOUND, cases=at(1, -1)), "domain-bound is stated"),
    ],
)
def test_an_entry_that_does_not_stand_is_told(claim: Claim[Any, Any], complaint: str) -> None:
    assert any(each.startswith(complaint) for each in judge(claim).complaints)


def test_a_formula_without_a_value_deviates() -> None:
    assert judge(replace(REFUTED, form=lambda m, x: x / 0)).deviation == float("inf")
    assert judge(replace(REFUTED, form=lambda m, x: m.nan)).deviation == float("inf")


def test_a_check_that_raises_has_no_verdict() -> None:
    finding = judge(replace(CONFIRMED, form=lambda m, x: exactly([x, x])))
    assert finding.verdict == "failed"
    assert finding.complaints == ("ValueError: shapes (2,) and () cannot be compared",)


def shifted(m: Any, x: Any) -> Any:
    return (1 + x) - 1


def test_lost_digits_are_measured_in_float64() -> None:
    def losing(digits: int, x: float) -> Sequence[str]:
        loss = Loss(where="small numbers", formula=shifted, truth=lambda m, x: x, at=(x,), digits=digits)
        return judge(replace(CONFIRMED, losses=(loss,))).complaints

    assert losing(8, 1e-8) == ()
    assert losing(16, 1e-20) == ()
    assert losing(2, 1e-8) == ("small numbers: 8 digits are lost, and 2 were said",)


def test_a_division_by_zero_loses_all_digits() -> None:
    loss = Loss(where="0", formula=lambda m, x: x / x, truth=lambda m, x: m.one, at=(0.0,), digits=16)
    assert judge(replace(CONFIRMED, losses=(loss,))).complaints == ()


@pytest.mark.parametrize(
    ("lacking", "what"),
    [
        (lambda: replace(CONFIRMED, copies=()), "confirmed, lacks a perturbed copy"),
        (lambda: replace(CONFIRMED, form=None), "lacks a form"),
        (lambda: replace(REFUTED, fault=None), "lacks a fault"),
        (lambda: replace(REFUTED, correction=None), "lacks a correction"),
        (
            lambda: replace(REFUTED, copies=(), correction=Correction(statement="", form=line(2), cases=at(1))),
            "lacks a perturbed copy of the correction",
        ),
        (lambda: replace(BOUND, domain=""), "lacks a domain"),
        (lambda: replace(BOUND, verdict=Verdict.UNCHECKABLE), "lacks a reason"),
    ],
)
def test_an_entry_that_lacks_something_is_refused(lacking: Any, what: str) -> None:
    with pytest.raises(ValueError, match=f"claim paper.1.double, .*{what}"):
        lacking()


def test_numbers_are_told_in_few_characters() -> None:
    assert told((mp.mpf(1) / 3, exactly([[1, 0], [0.5, -2]]), "as it is")) == "0.333333; [[1, 0], [0.5, -2]]; as it is"
    assert told([mpmath.fp.mpf(0.1), 3]) == "0.1; 3"
