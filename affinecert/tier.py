"""The deterministic tier: which cases a run judges, the same ones on every machine."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from affinecert import corpus
from affinecert.case import Case, generate, rounded
from affinecert.map import Map


@dataclass(frozen=True)
class Profile:
    """How much is done: cases a regime, and examples a law."""

    cases: int
    examples: int


PROFILES: Mapping[str, Profile] = {
    "quick": Profile(cases=8, examples=10),
    "standard": Profile(cases=10, examples=10),
    "thorough": Profile(cases=256, examples=250),
}

BATCH = 16
"""Cases a task: long enough to be worth a message to another process, short enough to be lost without regret."""


def select(entries: Iterable[Map], profile: Profile) -> Iterator[Case]:
    """The deterministic tier: the corpus, and the first cases of every regime, each once."""
    entries = tuple(entries)
    names = {entry.name for entry in entries}
    seen: set[str] = set()
    for case in _tier(entries, [case for case in corpus.shipped() if case.map in names], profile):
        if case.key not in seen:
            seen.add(case.key)
            yield case


def taken(cases: Iterable[Case], dtype: str) -> Iterator[Case]:
    """The cases as a subject of that dtype takes them, each once; those beyond its numbers are left out."""
    fitting = (rounded(case, dtype) for case in cases)
    yield from {case.key: case for case in fitting if case is not None}.values()


def _tier(entries: Sequence[Map], stored: Sequence[Case], profile: Profile) -> Iterator[Case]:
    for entry in entries:
        yield from (case for case in stored if case.map == entry.name)
        for regime in entry.regimes:
            yield from generate(entry, regime, max(1, round(profile.cases * regime.share)))


def batches(cases: Iterable[Case]) -> list[tuple[Case, ...]]:
    """The cases in batches of one map, one regime and one shape."""
    groups: dict[Any, list[Case]] = defaultdict(list)
    for case in cases:
        groups[case.map, case.regime, tuple(array.shape for array in case.inputs)].append(case)
    return [tuple(group[start : start + BATCH]) for group in groups.values() for start in range(0, len(group), BATCH)]
