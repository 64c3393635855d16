"""From judged cases to the certificate's rows, one a map and regime."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence

from affinecert import catalogue
from affinecert.case import Case
from affinecert.certificate import SHOWN_FINDINGS, CaseResult, RegimeResult
from affinecert.scoring import Verdict


def summarise(cases: Sequence[Case], results: Mapping[str, CaseResult]) -> tuple[RegimeResult, ...]:
    """The results by map and regime, in the order of the cases."""
    groups: dict[tuple[str, str], list[Case]] = defaultdict(list)
    for case in cases:
        groups[case.map, case.regime].append(case)
    return tuple(
        _summary(name, regime, [results[case.key] for case in group], group) for (name, regime), group in groups.items()
    )


GRAVITY = {verdict: rank for rank, verdict in enumerate(Verdict)}


def _gravity(result: CaseResult) -> tuple[int, float]:
    return GRAVITY[Verdict(result.verdict)], result.scaled


def _summary(name: str, regime: str, results: Sequence[CaseResult], cases: Sequence[Case]) -> RegimeResult:
    labels = {entry.name: entry.distance for entry in catalogue.find(name).regimes}
    counts = Counter(result.verdict for result in results)
    findings = sorted((r for r in results if Verdict(r.verdict).is_finding), key=_gravity, reverse=True)
    return RegimeResult(
        map=name,
        regime=regime,
        distance=labels.get(regime, "distance"),
        cases=len(results),
        verdicts={str(verdict): counts[verdict] for verdict in Verdict if counts[verdict]},
        worst=max(results, key=_gravity, default=None),
        findings=tuple(findings[:SHOWN_FINDINGS]),
        points=tuple((case.distance, r.scaled, r.verdict) for case, r in zip(cases, results, strict=True)),
    )
