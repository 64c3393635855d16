"""What a claim is: a statement of a paper that can be checked, the form that it takes there, and what is said of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any, Generic, TypeVar

Form = TypeVar("Form")
Case = TypeVar("Case")


class Verdict(StrEnum):
    """What becomes of a claim."""

    CONFIRMED = "confirmed"
    REFUTED = "refuted"
    BOUND = "domain-bound"
    UNCHECKABLE = "not-checkable"


class Fault(StrEnum):
    """What a refuted claim reads like."""

    SLIP = "a slip of the pen"
    SCAN = "a slip of the scan"
    MATHEMATICAL = "a mathematical error"


@dataclass(frozen=True)
class Copy(Generic[Form]):
    """A perturbed copy of a form: one coefficient, sign, exponent or order is changed, as ``change`` says.

    It shows that the check can fail: the check has to refute it.
    """

    change: str
    form: Form


@dataclass(frozen=True, kw_only=True)
class Correction(Generic[Form]):
    """The statement that is true in place of a refuted one, and the form to be checked.

    It is checked as the claim is, unless it has ``cases`` or a ``deviation`` of its own.
    """

    statement: str
    form: Form
    cases: Callable[[], Sequence[Any]] | None = None
    deviation: Callable[[Any, Any], Any] | None = None


@dataclass(frozen=True, kw_only=True)
class Loss:
    """Where a formula is poor in float64, and how many decimal digits of sixteen it loses there.

    ``formula(m, *at)`` and ``truth(m, *at)`` are written over an mpmath context ``m``: the formula is run in float64
    (`mpmath.fp`), the truth at high precision, both at the float64 numbers ``at`` (nested sequences for arrays).
    """

    where: str
    formula: Callable[..., Any]
    truth: Callable[..., Any]
    at: tuple[Any, ...]
    digits: int


@dataclass(frozen=True, kw_only=True)
class Claim(Generic[Form, Case]):
    """A statement of a paper, with its check and the verdict that the check comes to.

    ``deviation(form, case)`` is how far the form is from the truth in that case: 0 if it tells the truth, up to
    rounding; a difference relative to the truth, a violation of an inequality, or whether something is false.
    The claim holds if ``form``, as printed, deviates in none of the ``cases``, which go from simple to complex.

    - confirmed: it holds, and every perturbed copy among ``copies`` deviates somewhere.
    - refuted: it deviates; the first case where it does is the counterexample. ``fault`` says what it reads like. The
      ``correction`` holds. Where that has a check of its own, it refutes the copies.
    - domain-bound: it holds in the cases, inside of ``domain``, and deviates in every case ``outside``, which is
      just outside. It refutes the copies inside.
    - not-checkable, for the ``reason`` given; such a claim has nothing else.

    ``remark`` is what else an implementer should know. ``numbers`` gives what was measured, by name.
    """

    id: str
    place: str
    statement: str
    verdict: Verdict
    printed: str = ""
    form: Form | None = None
    cases: Callable[[], Sequence[Case]] = tuple
    deviation: Callable[[Form, Case], Any] | None = None
    copies: tuple[Copy[Form], ...] = ()
    fault: Fault | None = None
    correction: Correction[Form] | None = None
    domain: str = ""
    outside: Callable[[], Sequence[Case]] = tuple
    reason: str = ""
    remark: str = ""
    numbers: Callable[[], Mapping[str, Any]] | None = None
    losses: tuple[Loss, ...] = ()

    def __post_init__(self) -> None:
        """Refuses an entry that lacks what its verdict needs."""
        missing = [what for what, there in self._needs() if not there]
        if missing:
            raise ValueError(f"claim {self.id}, {self.verdict}, lacks {', '.join(missing)}")

    def _needs(self) -> tuple[tuple[str, bool], ...]:
        checked = ("a deviation", self.deviation is not None), ("a form", self.form is not None)
        correction = self.correction
        own_check = correction is not None and (correction.cases is not None or correction.deviation is not None)
        return {
            Verdict.CONFIRMED: (*checked, ("a perturbed copy", bool(self.copies))),
            Verdict.REFUTED: (
                *checked,
                ("a fault", self.fault is not None),
                ("a correction", correction is not None),
                ("a perturbed copy of the correction", bool(self.copies) or not own_check),
            ),
            Verdict.BOUND: (*checked, ("a perturbed copy", bool(self.copies)), ("a domain", bool(self.domain))),
            Verdict.UNCHECKABLE: (("a reason", bool(self.reason)),),
        }[self.verdict]

    @property
    def paper(self) -> str:
        """The short name of the paper."""
        return self.id.partition(".")[0]
