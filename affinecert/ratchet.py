"""The ratchet: a certificate held against an earlier one of the same subject; only what got worse fails.

A map in a regime got worse if it is a finding now, and

- its gravest verdict is graver than before (in the order of `Verdict`, so that a map that was absent and is now offered
  and wrong counts), or
- the verdict is the same and the worst scaled error has grown by more than `GROWTH`;

and a map that is no longer offered, though some regime of it was in order, got worse as well. A law got worse if it is
broken now and was not. Everything else is noise, or news: errors within the bound may grow as they like, another branch
is no defect, and where nothing of a regime that is broken already is left, its errors are not told apart.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum

from affinecert.certificate import CaseResult, Certificate, LawRecord, RegimeResult
from affinecert.errors import StoredFileError
from affinecert.scoring import FINDINGS, Verdict
from affinecert.summary import GRAVITY

GROWTH = 2.0
"""The worst scaled error of a finding may not grow by more than this factor: one bit. Better means as much less."""


class Kind(StrEnum):
    """What is said of a change; ``new`` are findings of which the baseline says nothing."""

    WORSE = "worse"
    NEW = "new"
    BETTER = "better"
    CHANGED = "changed"


@dataclass(frozen=True)
class RegimeChange:
    """A map in a regime that is not as it was; ``regime`` is "" where the whole map came or went.

    ``before`` and ``now`` are verdicts, "" where there is none; the worst cases are None where the map is absent.
    """

    map: str
    regime: str
    kind: Kind
    before: str
    now: str
    worst_before: CaseResult | None
    worst: CaseResult | None


@dataclass(frozen=True)
class LawChange:
    """A law of which something else is said; ``before`` is a verdict, "" if the baseline does not know the law."""

    kind: Kind
    before: str
    law: LawRecord


@dataclass(frozen=True)
class Difference:
    """A circumstance (affinecert's version, the profile, the maps chosen) in which two runs differ."""

    what: str
    before: str
    now: str


@dataclass(frozen=True)
class Ratchet:
    """What changed against a baseline, or, if ``recorded``, that there was none and this run is it now.

    ``version`` and ``created`` are the baseline's. Of the regimes, ``same`` are as they were, ``gone`` only the
    baseline knows, and ``come`` only this certificate. ``differences`` are those between the two runs themselves, so
    that not every change need be the subject's.
    """

    version: str
    created: str
    recorded: bool
    same: int
    regimes: tuple[RegimeChange, ...]
    laws: tuple[LawChange, ...]
    gone: int
    come: int
    differences: tuple[Difference, ...]

    @property
    def passed(self) -> bool:
        """Whether nothing got worse."""
        return self.count(Kind.WORSE) == 0

    def count(self, kind: Kind) -> int:
        """How many changes are of a kind."""
        return [*(each.kind for each in self.regimes), *(each.kind for each in self.laws)].count(kind)


def recorded(certificate: Certificate) -> Ratchet:
    """The outcome where there was no baseline: this certificate becomes it."""
    return Ratchet(certificate.subject_version, certificate.created, True, 0, (), (), 0, 0, ())


def require_same(baseline: Certificate, subject: str, dtype: str, name: str) -> None:
    """Raises StoredFileError unless the baseline, of the file ``name``, is of that subject, in the same unit."""
    if baseline.subject != subject:
        raise StoredFileError(f"{name}: a baseline of {baseline.subject}, where one of {subject} is due")
    if baseline.dtype != dtype:
        raise StoredFileError(f"{name}: a baseline in {baseline.dtype}, where {subject} computes in {dtype}")


def ratchet(baseline: Certificate, certificate: Certificate) -> Ratchet:
    """What changed from the baseline to the certificate, both of one subject, the worst first.

    Maps that only one of the two runs was asked for are not compared, but findings among them are told as new.
    """
    beyond = 1.0 / certificate.arithmetic.unit
    before = {(result.map, result.regime): result for result in baseline.results if result.worst}
    now = {(result.map, result.regime): result for result in certificate.results if result.worst}
    found = [
        *_regimes(before, now, beyond),
        *_offered(baseline, certificate),
        *_dropped(baseline, certificate),
    ]
    laws = tuple(_laws(baseline, certificate))
    order = list(Kind)
    moved = {(change.map, change.regime) for change in found}
    return Ratchet(
        version=baseline.subject_version,
        created=baseline.created,
        recorded=False,
        same=len((before.keys() & now.keys()) - moved),
        regimes=tuple(sorted(found, key=lambda change: (order.index(change.kind), _descending(change)))),
        laws=tuple(sorted(laws, key=lambda change: order.index(change.kind))),
        gone=len(before.keys() - now.keys()),
        come=len(now.keys() - before.keys()),
        differences=tuple(_differences(baseline, certificate)),
    )


def _descending(change: RegimeChange) -> tuple[int, float]:
    """The gravest first."""
    rank = GRAVITY[Verdict(change.now)] if change.now else 0
    return -rank, -(change.worst.scaled if change.worst else 0.0)


def _finding(verdict: str) -> bool:
    return Verdict(verdict) in FINDINGS


def _regimes(
    before: Mapping[tuple[str, str], RegimeResult], now: Mapping[tuple[str, str], RegimeResult], beyond: float
) -> Iterator[RegimeChange]:
    """The changes of regimes that both certificates know."""
    for (name, regime), result in now.items():
        old = before[name, regime].worst if (name, regime) in before else None
        new = result.worst
        if old is None or new is None:
            continue
        kind = _kind(old, new, beyond)
        if kind is not None:
            yield RegimeChange(name, regime, kind, old.verdict, new.verdict, old, new)


def _kind(old: CaseResult, new: CaseResult, beyond: float) -> Kind | None:
    """How the worst case of a regime changed; None if it did not."""
    if not _finding(old.verdict) and not _finding(new.verdict):
        return Kind.CHANGED if old.verdict != new.verdict else None
    step = GRAVITY[Verdict(new.verdict)] - GRAVITY[Verdict(old.verdict)]
    if step:
        return Kind.WORSE if step > 0 else Kind.BETTER
    was, is_ = _told_apart(old.scaled, beyond), _told_apart(new.scaled, beyond)
    if is_ > GROWTH * was:
        return Kind.WORSE
    return Kind.BETTER if was > GROWTH * is_ else None


def _told_apart(scaled: float, beyond: float) -> float:
    """An error as far as it says anything: where no digit is right, one is like another; infinity is no measure."""
    return scaled if math.isinf(scaled) else min(scaled, beyond)


def _offered(baseline: Certificate, certificate: Certificate) -> Iterator[RegimeChange]:
    """Maps that the subject did not offer, or that the baseline does not know: their findings, and that they came."""
    known = {(result.map, result.regime) for result in baseline.results if result.worst}
    came: dict[str, bool] = {}
    for result in certificate.results:
        if result.worst is None or (result.map, result.regime) in known:
            continue
        absent, found = result.map in baseline.absent, _finding(result.worst.verdict)
        if absent:
            came[result.map] = came.get(result.map, True) and not found
        if found:
            kind, before = (Kind.WORSE, str(Verdict.ABSENT)) if absent else (Kind.NEW, "")
            yield RegimeChange(result.map, result.regime, kind, before, result.worst.verdict, None, result.worst)
    for name, sound in came.items():
        if sound:
            yield RegimeChange(name, "", Kind.BETTER, Verdict.ABSENT, Verdict.OK, None, None)


def _dropped(baseline: Certificate, certificate: Certificate) -> Iterator[RegimeChange]:
    """Maps that the subject offered and does not offer any more."""
    for name in certificate.absent:
        had = [result.worst for result in baseline.results if result.map == name and result.worst]
        if had:
            best = min(had, key=lambda worst: (GRAVITY[Verdict(worst.verdict)], worst.scaled))
            kind = Kind.BETTER if _finding(best.verdict) else Kind.WORSE
            yield RegimeChange(name, "", kind, best.verdict, Verdict.ABSENT, best, None)


def _laws(baseline: Certificate, certificate: Certificate) -> Iterator[LawChange]:
    """The laws of which something else is said than before."""
    before = {law.name: law.verdict for law in baseline.laws}
    for law in certificate.laws:
        old = before.get(law.name, "")
        if old == law.verdict:
            continue
        if law.verdict == "failed":
            yield LawChange(Kind.WORSE if old else Kind.NEW, old, law)
        elif old:
            yield LawChange(Kind.BETTER if (old, law.verdict) == ("failed", "passed") else Kind.CHANGED, old, law)


def _differences(baseline: Certificate, certificate: Certificate) -> Iterator[Difference]:
    pairs = {
        "affinecert": (baseline.affinecert, certificate.affinecert),
        "profile": (baseline.profile, certificate.profile),
        "maps": (baseline.maps, certificate.maps),
    }
    for what, (old, new) in pairs.items():
        if old != new:
            yield Difference(what, old, new)
