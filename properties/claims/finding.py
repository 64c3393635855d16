"""What the check of a claim comes to, in numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from time import perf_counter
from typing import Any

import mpmath
import numpy as np

from affinecert.properties.claims.claim import Claim, Loss, Verdict
from affinecert.properties.claims.precision import FAILS, HOLDS, distance, exactly, mp

DIGITS = 16
"""Decimal digits of float64; what is not a number has lost them all."""


@dataclass(frozen=True)
class LossFound:
    """The decimal digits of sixteen that a formula loses in float64 at a place, as measured."""

    where: str
    digits: int
    expected: int


@dataclass(frozen=True)
class Finding:
    """What was found of one claim.

    ``deviation`` is the greatest of the cases; of a refuted claim that of the ``counterexample``, the first case that
    deviates, by its number and in words. ``outside`` is the least deviation outside of the domain, ``correction`` the
    greatest of the corrected statement, ``copies`` those of the perturbed copies. ``complaints`` tell why the entry
    does not stand: its verdict is another, a copy is not refuted, a loss is not what was said.
    """

    claim: str
    verdict: str
    cases: int = 0
    deviation: float = 0.0
    counterexample: str = ""
    counterexample_case: int | None = None
    outside: float | None = None
    correction: float | None = None
    copies: Mapping[str, float] = field(default_factory=dict)
    numbers: Mapping[str, str] = field(default_factory=dict)
    losses: tuple[LossFound, ...] = ()
    complaints: tuple[str, ...] = ()
    seconds: float = 0.0


def judge(claim: Claim[Any, Any]) -> Finding:
    """Runs the checks of a claim. What raises is told as a complaint, and the verdict is then "failed"."""
    started = perf_counter()
    if claim.verdict is Verdict.UNCHECKABLE:
        return Finding(claim.id, claim.verdict)
    try:
        finding = _judged(claim)
    except Exception as error:  # whatever a check runs into, the other entries of the ledger are to be told
        return Finding(claim.id, "failed", complaints=(f"{type(error).__name__}: {error}",))
    return Finding(**{**vars(finding), "seconds": perf_counter() - started})


def _judged(claim: Claim[Any, Any]) -> Finding:
    cases, outside = claim.cases(), claim.outside()
    deviations = _deviations(claim.deviation, claim.form, cases)
    first = next((number for number, deviation in enumerate(deviations) if deviation >= FAILS), None)
    beyond = _deviations(claim.deviation, claim.form, outside)
    verdict = Verdict.REFUTED if first is not None else Verdict.BOUND if outside else Verdict.CONFIRMED
    complaints = [f"{claim.verdict} is stated"] if verdict is not claim.verdict else []
    if not cases:
        complaints.append("no case is tried")
    if first is None:
        complaints += _between("the form", deviations)
    complaints += [f"holds outside of the domain, in case {n} there" for n, d in enumerate(beyond) if d < FAILS]
    checked, corrected = _check_of_truth(claim, cases)
    if corrected is not None:
        worst = _deviations(checked[0], corrected, checked[1])
        complaints += _between("the correction", worst, failing=True)
    copies = {copy.change: _worst(_deviations(checked[0], copy.form, checked[1])) for copy in claim.copies}
    complaints += [f"a copy is not refuted: {change}" for change, deviation in copies.items() if deviation < FAILS]
    losses = tuple(map(_measured, claim.losses))
    complaints += [
        f"{loss.where}: {loss.digits} digits are lost, and {loss.expected} were said"
        for loss in losses
        if abs(loss.digits - loss.expected) > 1
    ]
    return Finding(
        claim=claim.id,
        verdict=verdict,
        cases=len(cases),
        deviation=float(_worst(deviations) if first is None else deviations[first]),
        counterexample="" if first is None else told(cases[first]),
        counterexample_case=first,
        outside=float(min(beyond)) if outside else None,
        correction=None if corrected is None else float(_worst(worst)),
        copies={change: float(deviation) for change, deviation in copies.items()},
        numbers={} if claim.numbers is None else {name: told(number) for name, number in claim.numbers().items()},
        losses=losses,
        complaints=tuple(complaints),
    )


def _check_of_truth(claim: Claim[Any, Any], cases: Sequence[Any]) -> tuple[tuple[Any, Sequence[Any]], Any]:
    """The deviation and the cases that the true statement is checked with, and its form where it is a correction."""
    if claim.correction is None:
        return (claim.deviation, cases), None
    correction = claim.correction
    own = cases if correction.cases is None else correction.cases()
    return (correction.deviation or claim.deviation, own), correction.form


def _deviations(deviation: Any, form: Any, cases: Sequence[Any]) -> list[Any]:
    """The deviation in every case; infinite where it is not a number."""
    return [_deviation(deviation, form, case) for case in cases]


def _deviation(deviation: Any, form: Any, case: Any) -> Any:
    try:
        found = mp.mpf(deviation(form, case))
    except ArithmeticError:  # a division by zero: a formula has no value there
        return mp.inf
    return mp.inf if mp.isnan(found) else found


def _worst(deviations: Sequence[Any]) -> Any:
    return max(deviations, default=mp.zero)


def _between(what: str, deviations: Sequence[Any], *, failing: bool = False) -> list[str]:
    """Complaints of deviations that are neither rounding nor failure, and of failure too if so asked."""
    return [
        f"{what} deviates by {mp.nstr(deviation, 3)} in case {number}"
        for number, deviation in enumerate(deviations)
        if deviation > HOLDS and (failing or deviation < FAILS)
    ]


def _measured(loss: Loss) -> LossFound:
    truth = loss.truth(mp, *(exactly(each) for each in loss.at))
    try:
        value = loss.formula(mpmath.fp, *(exactly(each, mpmath.fp) for each in loss.at))
        error = distance(exactly_of(value), truth)
    except ArithmeticError:  # a division by zero, an overflow: no digit is right
        return LossFound(loss.where, DIGITS, loss.digits)
    if not error < 1:
        return LossFound(loss.where, DIGITS, loss.digits)
    lost = math.log10(max(float(error) / 2.0**-53, 1.0))
    return LossFound(loss.where, min(round(lost), DIGITS), loss.digits)


def exactly_of(value: Any) -> Any:
    """`exactly`, member by member of a tuple or list."""
    return tuple(map(exactly_of, value)) if isinstance(value, list | tuple) else exactly(value)


def told(value: Any) -> str:
    """A case or a number in few characters: six digits, arrays as nested lists, the members of a tuple one by one."""
    if isinstance(value, np.ndarray):
        return "[" + ", ".join(map(told, value)) + "]"
    if isinstance(value, list | tuple):
        return "; ".join(map(told, value))
    if isinstance(value, float | np.floating):
        return f"{value:.6g}"
    if hasattr(value, "_mpf_") or hasattr(value, "_mpc_"):
        return str(mp.nstr(value, 6)).removesuffix(".0")
    return str(value)
