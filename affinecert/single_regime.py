"""One regime of one map, judged in this process: a row of the certificate, for those who ask for rows one by one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from functools import cache

from affinecert import catalogue, corpus
from affinecert.case import Case
from affinecert.certificate import CaseResult, RegimeResult
from affinecert.judging import judge, resolve, truths_of
from affinecert.store import Store, reference_version
from affinecert.subject import Subject
from affinecert.summary import summarise
from affinecert.tier import PROFILES, batches, select, taken
from affinecert.truths import Truth


@cache
def regimes(name: str) -> tuple[str, ...]:
    """The regimes of a map by name: those that the catalogue draws from, then those that only the corpus knows."""
    drawn = [regime.name for regime in catalogue.find(name).regimes]
    return tuple(dict.fromkeys([*drawn, *_stored().get(name, ())]))


@cache
def _stored() -> Mapping[str, Sequence[str]]:
    found = defaultdict(list)
    for case in corpus.shipped():
        found[case.map].append(case.regime)
    return found


@cache
def _cases(name: str, profile: str, dtype: str) -> tuple[Case, ...]:
    """The deterministic tier of a map, as a subject of that dtype takes it."""
    return tuple(taken(select([catalogue.find(name)], PROFILES[profile]), dtype))


def certify_regime(subject: str | Subject, name: str, regime: str, profile: str = "standard") -> RegimeResult | None:
    """The certificate's row for a regime of a map that the subject offers; None where the tier has no case for it.

    Truths are looked up in the store, and kept there. Raises StoredFileError where it cannot be used.
    """
    cases = [case for case in _cases(name, profile, resolve(subject).dtype) if case.regime == regime]
    results: dict[str, CaseResult] = {}
    with Store() as store:
        for batch in batches(cases):
            found = judge(subject, batch, _truths(store, batch))
            results |= zip([case.key for case in batch], found, strict=True)
    return next(iter(summarise(cases, results)), None)


def _truths(store: Store, batch: Sequence[Case]) -> list[Truth]:
    """The truths of cases of one map, in order; those that the store lacks are computed, and kept."""
    version = reference_version(catalogue.find(batch[0].map))
    held = store.truths(version, [case.key for case in batch])
    missing = [case for case in batch if case.key not in held]
    if missing:
        fresh = dict(zip([case.key for case in missing], truths_of(missing), strict=True))
        store.keep_truths(version, fresh)
        held |= fresh
    return [held[case.key] for case in batch]
