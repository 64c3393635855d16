"""What a report from the field is: a thread, what it complains of, the faulty formula and the repaired one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from affinecert.scoring import Verdict

Array = NDArray[Any]
Formula = Callable[..., Any]


@dataclass(frozen=True)
class Report:
    """One thread; ``faulty`` and ``repaired`` take one item, and ``verdict`` is what the faulty one must get."""

    thread: str
    title: str
    map: str
    faulty: Formula
    repaired: Formula
    verdict: Verdict


REPORTS: list[Report] = []


def reported(
    thread: str, title: str, entry: str, repaired: Formula, verdict: Verdict = Verdict.WRONG
) -> Callable[[Formula], Formula]:
    """Enters the decorated formula as what that thread reports; its docstring says what is wrong with it."""

    def enter(faulty: Formula) -> Formula:
        REPORTS.append(Report(thread, title, entry, faulty, repaired, verdict))
        return faulty

    return enter


def batched(formula: Formula) -> Formula:
    """A formula of one item as a map of batches."""

    def each(*columns: Array) -> Any:
        answers = [formula(*items) for items in zip(*columns, strict=True)]
        if isinstance(answers[0], tuple):
            return tuple(np.stack(outputs) for outputs in zip(*answers, strict=True))
        return np.stack(answers)

    return each
