"""One evaluation of the hunt: how badly a subject fares on one input, at the least cost in truth."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np

from affinecert import truths
from affinecert.answering import answers
from affinecert.case import Case, generate, rounded
from affinecert.errors import InputError, PrecisionError
from affinecert.judging import as_taken, held_against, on_another_branch
from affinecert.map import Map
from affinecert.scoring import COMPLEX, Score, Verdict
from affinecert.store import Store, reference_version
from affinecert.subject import Subject
from affinecert.truths import Truth


def height(judged: Score) -> float:
    """How bad an answer is: log2 of its scaled error; of its backward error, if it is right on another branch.

    Without an inverse that error is the one to the value beyond a jump, within the bound: none to speak of.
    """
    error = judged.scaled if judged.verdict is not Verdict.OTHER_BRANCH else judged.backward or 0.0
    return math.log2(error) if error > 0 else -math.inf


def error(height: float) -> float:
    """The scaled error of a height."""
    return 2.0**height if height < sys.float_info.max_exp else math.inf


class Trial:
    """A map of a subject, ready to be tried on inputs; truths that the store holds are not computed again."""

    def __init__(self, subject: Subject, entry: Map, store: Store) -> None:
        self.subject = subject
        self.entry = entry
        self.store = store
        self._version = reference_version(entry)
        self._context = mpmath.MPContext()

    def __call__(self, case: Case, floor: float = -math.inf) -> Score | None:
        """The score on a case; None outside the map's domain, and where the height is surely below ``floor``.

        The scaled error is at most the forward error, and that needs the value alone, without the differences that the
        sensitivity takes: most proposals fall there.
        """
        taken = rounded(case, self.subject.dtype)
        try:
            return None if taken is None else self._judged(taken, floor)
        except PrecisionError:
            # The reference itself cannot settle this input: nothing can be said of the subject there.
            return None

    def _judged(self, case: Case, floor: float) -> Score | None:
        answer = answers(self.subject, [case])[0]
        truth = self.store.truths(self._version, [case.key]).get(case.key)
        if truth is None:
            value = self._glance(case)
            due = as_taken(self.entry, case.inputs, value, self.subject)
            first = held_against(self.entry, answer, due, self.subject)
            if value.refusal is not None or height(first) < floor:
                return None
            # Whether a complex answer is off by more than rounding, the sensitivity tells.
            if math.isinf(first.scaled) and first.note != COMPLEX:
                return first
            truth = truths.compute(self.entry, case.inputs)
        if truth.refusal is not None:
            return None
        due = as_taken(self.entry, case.inputs, truth, self.subject)
        judged = held_against(self.entry, answer, due, self.subject)
        return on_another_branch(self.entry, case.inputs, answer, due, judged, self.subject)

    def warm_up(self) -> None:
        """Has the subject answer once, for that may import and compile."""
        answers(self.subject, list(generate(self.entry, self.entry.regimes[0], 1)))

    def keep(self, case: Case) -> None:
        """Puts the truth of a case into the store."""
        self.store.keep_truths(self._version, {case.key: truths.compute(self.entry, case.inputs)})

    def _glance(self, case: Case) -> Truth:
        """The value at one precision, unconfirmed, with sensitivity 0; if it errs, no more than a proposal is lost."""
        ctx = self._context
        ctx.prec = truths.BASE
        try:
            value = self.entry.reference(ctx, *(_apply(ctx.mpf, array) for array in case.inputs))
        except InputError as error:
            return Truth((), (), (), error.reason)
        outputs = value if isinstance(value, tuple) else (value,)
        high = tuple(_apply(float, output).astype(np.float64) for output in outputs)
        low = tuple(
            _apply(float, o - _apply(ctx.mpf, h)).astype(np.float64) for o, h in zip(outputs, high, strict=True)
        )
        return Truth(high, low, (0.0,) * len(self.entry.blocks), None)


def _apply(function: Callable[[Any], Any], array: Any) -> Any:
    """The function on each entry, as an object array even of no dimension."""
    return np.asarray(np.frompyfunc(function, 1, 1)(array), dtype=object)
