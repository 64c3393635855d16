"""What is timed: batches of ordinary inputs for each map; and how exact an implementation is on difficult ones."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from affinecert import catalogue
from affinecert.case import Case, generate
from affinecert.judging import judge, truths_of
from affinecert.map import Array, Map
from affinecert.scoring import Verdict
from affinecert.store import Store, reference_version
from affinecert.subject import Subject
from affinecert.tier import PROFILES, batches, select
from affinecert.truths import Truth

VARIETY = 256
"""Different items in a batch, which repeats them: enough that no branch predictor learns them by heart."""


@dataclass(frozen=True)
class Accuracy:
    """The worst errors of an implementation over a map's quick tier, in u; an answer on another branch is left out."""

    forward: float
    scaled: float


def batch(entry: Map, size: int) -> tuple[Array, ...]:
    """That many items of the map's first regime, the generic one; of the larger shape, where it offers two."""
    cases = list(generate(entry, entry.regimes[0], VARIETY))
    largest = max(sum(array.size for array in case.inputs) for case in cases)
    chosen = [case.inputs for case in cases if sum(array.size for array in case.inputs) == largest]
    columns = [np.stack(arrays) for arrays in zip(*chosen, strict=True)]
    return tuple(np.resize(column, (size, *column.shape[1:])) for column in columns)


def tier(entry: Map) -> list[tuple[Case, ...]]:
    """The cases on which accuracy is measured, in batches of one shape."""
    return batches(select([entry], PROFILES["quick"]))


@cache
def truths(name: str) -> dict[str, Truth]:
    """The truths of a map's tier by case key, from the store or computed and kept there."""
    entry = catalogue.find(name)
    cases = {case.key: case for group in tier(entry) for case in group}
    reference = reference_version(entry)
    with Store() as store:
        known = store.truths(reference, cases)
        missing = [case for key, case in cases.items() if key not in known]
        fresh = dict(zip([case.key for case in missing], truths_of(missing), strict=True))
        store.keep_truths(reference, fresh)
    return known | fresh


def accuracy(subject: Subject, name: str) -> Accuracy:
    """The accuracy of a subject on one map, over the cases inside its domain."""
    known = truths(name)
    inside = [tuple(case for case in group if known[case.key].refusal is None) for group in tier(catalogue.find(name))]
    results = [
        result
        for group in inside
        if group
        for result in judge(subject, group, [known[case.key] for case in group])
        if result.verdict != Verdict.OTHER_BRANCH
    ]
    return Accuracy(
        forward=max((result.forward for result in results), default=0.0),
        scaled=max((result.scaled for result in results), default=0.0),
    )
