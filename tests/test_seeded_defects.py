"""Bugs that somebody could well write are caught, each in the regime where it bites; the sound code passes there."""

from __future__ import annotations

from collections import Counter
from functools import cache

import pytest

from affinecert.case import Case, generate
from affinecert.catalogue import CATALOGUE
from affinecert.judging import judge, truths_of
from affinecert.scoring import Verdict
from affinecert.subject import Subject
from affinecert.subjects import fast
from affinecert.tier import PROFILES, batches
from affinecert.truths import Truth

from .defects import DEFECTS, Defect


@cache
def posed(name: str, regime: str) -> list[tuple[tuple[Case, ...], list[Truth]]]:
    """The deterministic tier of one map and regime at the quick profile, in batches, with the truths."""
    entry = CATALOGUE[name]
    (chosen,) = (candidate for candidate in entry.regimes if candidate.name == regime)
    cases = generate(entry, chosen, PROFILES["quick"].cases)
    return [(batch, truths_of(batch)) for batch in batches(cases)]


def verdicts(subject: Subject, name: str, regime: str) -> Counter[str]:
    return Counter(result.verdict for batch, known in posed(name, regime) for result in judge(subject, batch, known))


@pytest.mark.parametrize("defect", DEFECTS, ids=[f"{defect.map}-{defect.name}" for defect in DEFECTS])
def test_the_defect_is_caught(defect: Defect) -> None:
    damaged = Subject("damaged", "0", {defect.map: defect.function})
    found = verdicts(damaged, defect.map, defect.regime)
    assert found[defect.verdict], f"{defect.function.__doc__} gives {dict(found)}, not one {defect.verdict}"


@pytest.mark.parametrize(("name", "regime"), sorted({(defect.map, defect.regime) for defect in DEFECTS}))
def test_sound_code_passes_where_defects_are_caught(name: str, regime: str) -> None:
    assert set(verdicts(fast.subject, name, regime)) == {Verdict.OK}


def test_every_map_has_its_defects() -> None:
    assert {defect.map for defect in DEFECTS} == set(CATALOGUE)
    assert len(DEFECTS) >= 36
    assert len({(defect.map, defect.name) for defect in DEFECTS}) == len(DEFECTS)
