"""What every report shows, taken from the certificate once: maps, findings by gravity, numbers and commands as text."""

from __future__ import annotations

import json
import math
import shlex
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from affinecert.case import from_hex
from affinecert.catalogue import CATALOGUE
from affinecert.certificate import CaseResult, Certificate, LawRecord, RegimeResult, Timing
from affinecert.scoring import FINDINGS, Verdict
from affinecert.summary import GRAVITY

MEANINGS: Mapping[Verdict, str] = {
    Verdict.OK: "The scaled error is within the bound; or the input is outside the domain, and was refused.",
    Verdict.OTHER_BRANCH: "Another value of a map that jumps: its inverse, or an input beside this one, tells so.",
    Verdict.ABSENT: "The subject does not offer the map, or documents that it refuses this input.",
    Verdict.DEGRADED: "The scaled error is beyond the bound, but half of the digits are left; or complex by rounding.",
    Verdict.WRONG: "More than half of the digits are lost; or a silent answer outside the domain.",
    Verdict.NON_FINITE: "NaN or infinity where a number is due.",
    Verdict.RAISED: "An exception, or no answer within the time limit, inside the domain.",
}
"""What each verdict says, for readers."""


@dataclass(frozen=True)
class MapView:
    """One map of a certificate with all that belongs to it; ``bound`` is None if the catalogue lacks the map by now."""

    name: str
    definition: str
    source: str
    domain: str
    bound: float | None
    results: tuple[RegimeResult, ...]
    timing: Timing | None

    @property
    def cases(self) -> int:
        """How many cases were judged."""
        return sum(result.cases for result in self.results)

    @property
    def findings(self) -> int:
        """How many of them are findings."""
        return sum(map(finding_count, self.results))

    @property
    def worst(self) -> CaseResult | None:
        """The gravest case over all regimes."""
        return max((result.worst for result in self.results if result.worst), key=gravity, default=None)


def maps(certificate: Certificate) -> tuple[MapView, ...]:
    """The certificate's maps in its order, their regimes in that of the catalogue."""
    timings = {timing.map: timing for timing in certificate.timings}
    views = []
    for name, results in groupby(certificate.results, key=lambda result: result.map):
        entry = CATALOGUE.get(name)
        order = [regime.name for regime in entry.regimes] if entry else []
        views.append(
            MapView(
                name=name,
                definition=entry.definition if entry else "",
                source=entry.source if entry else "",
                domain=entry.domain if entry else "",
                bound=entry.bound if entry else None,
                results=tuple(sorted(results, key=lambda result: _place(result.regime, order))),
                timing=timings.get(name),
            )
        )
    return tuple(views)


def _place(regime: str, order: Sequence[str]) -> int:
    """Where a regime stands among a map's; those that only the corpus knows come last."""
    return order.index(regime) if regime in order else len(order)


def gravity(result: CaseResult) -> tuple[int, float]:
    """Sorts cases from harmless to grave: by verdict, then by scaled error."""
    return GRAVITY[Verdict(result.verdict)], result.scaled


def finding_count(result: RegimeResult) -> int:
    """How many cases of a regime are findings; the certificate tells the gravest few of them."""
    return sum(count for verdict, count in result.verdicts.items() if Verdict(verdict) in FINDINGS)


def findings(certificate: Certificate) -> tuple[CaseResult, ...]:
    """The findings that are told, gravest first."""
    told = (finding for result in certificate.results for finding in result.findings)
    return tuple(sorted(told, key=gravity, reverse=True))


def gravest(results: Iterable[CaseResult], *by: str) -> tuple[CaseResult, ...]:
    """Of findings in order of gravity, the first one of each map (``"map"``), or of each map and ``"regime"``."""
    first: dict[tuple[str, ...], CaseResult] = {}
    for result in results:
        first.setdefault(tuple(result.case[key] for key in by), result)
    return tuple(first.values())


def total(certificate: Certificate) -> int:
    """How many findings there are; those that are told are the gravest few of each regime."""
    return sum(map(finding_count, certificate.results))


def distance(result: CaseResult) -> float:
    """How far the case lies from its regime's singular set."""
    return float.fromhex(result.case["distance"])


def laws(certificate: Certificate) -> tuple[LawRecord, ...]:
    """The laws: the broken ones first, then those kept, then those the subject cannot be held to."""
    order = {"failed": 0, "passed": 1, "absent": 2}
    return tuple(sorted(certificate.laws, key=lambda law: order[law.verdict]))


def figure(value: float | None) -> str:
    """A number as tables show it: two or three digits, "∞" for infinity, "–" for none."""
    if value is None or math.isnan(value):
        return "–"
    if math.isinf(value):
        return "∞"
    if value == 0.0:
        return "0"
    if 0.01 <= value < 1e5:
        return f"{value:.{2 if value < 10 else 1 if value < 100 else 0}f}"
    mantissa, exponent = f"{value:.1e}".split("e")
    return f"{mantissa.removesuffix('.0')}e{int(exponent)}"


def error(value: float | None) -> str:
    """The same for errors and condition numbers, of which nobody needs to tell those below 0.01 apart."""
    return "<0.01" if value is not None and 0.0 < value < 0.01 else figure(value)


def tally(verdicts: Mapping[str, int]) -> str:
    """Verdict counts in words, the gravest first: "12 wrong, 20 ok"."""
    grave_first = sorted(verdicts.items(), key=lambda item: GRAVITY[Verdict(item[0])], reverse=True)
    return ", ".join(f"{count} {verdict}" for verdict, count in grave_first)


def counted(number: int, one: str, many: str | None = None) -> str:
    """The number with its noun: "1 law", "2,000 cases"."""
    return f"{number:,} {one if number == 1 else many or one + 's'}"


@dataclass(frozen=True)
class Gap:
    """What is missing, by its name: a family of maps or laws, with a ``remark`` on how much of it, or a single one."""

    name: str
    remark: str = ""

    def __str__(self) -> str:
        return f"{self.name} ({self.remark})" if self.remark else self.name


def by_family(missing: Iterable[str], there: Iterable[str]) -> tuple[Gap, ...]:
    """The missing names, FAMILY.NAME each, in few words and in their order: beside those that are there.

    A family of which nothing is there is told with its count, "mesh2 (6)"; one of which little is there by that,
    "morphs (all but sclerp)"; of any other the missing names are told.
    """
    lost, kept = _families(missing), _families(there)
    gaps: list[Gap] = []
    for family, names in lost.items():
        rest = [name.removeprefix(f"{family}.") for name in kept.get(family, ())]
        if len(names) > max(len(rest), 1):
            gaps.append(Gap(family, f"all but {', '.join(rest)}" if rest else f"{len(names)}"))
        else:
            gaps += map(Gap, names)
    return tuple(gaps)


def _families(names: Iterable[str]) -> Mapping[str, Sequence[str]]:
    """The names of each family, each once, in the order in which they come."""
    families: dict[str, list[str]] = {}
    for name in dict.fromkeys(names):
        families.setdefault(name.partition(".")[0], []).append(name)
    return families


def absent(certificate: Certificate) -> tuple[Gap, ...]:
    """The chosen maps that the subject does not offer."""
    return by_family(certificate.absent, (result.map for result in certificate.results))


def decimal(inputs: Any) -> str:
    """A case's inputs as JSON of decimal numbers; each is the shortest that reads back as the same float64."""
    return json.dumps([from_hex(value).tolist() for value in inputs])


def hexadecimal(inputs: Any) -> str:
    """A case's inputs as JSON of hexadecimal floats."""
    return json.dumps(inputs)


def command(map_name: str, inputs: Any, subject: str) -> str:
    """The command that explains one input of a map; ``subject`` as one names it on the command line."""
    words = ["affinecert", "explain", map_name, decimal(inputs), *(["--subject", subject] if subject != "fast" else [])]
    return shlex.join(words)


def reproduce(certificate: Certificate, result: CaseResult) -> str:
    """The command that explains a case of this certificate."""
    return command(result.case["map"], result.case["inputs"], certificate.spec)


def outcome(certificate: Certificate) -> str:
    """The whole certificate in a few words."""
    if certificate.passed:
        return "passed"
    regimes = sum(not result.passed for result in certificate.results)
    number = total(certificate)
    broken = sum(law.verdict == "failed" for law in certificate.laws)
    parts = []
    if number:
        parts.append(f"{counted(number, 'finding')} in {counted(regimes, 'regime')} of {len(certificate.results)}")
    if broken:
        parts.append(f"{counted(broken, 'law')} broken")
    return ", ".join(parts)


def extent(certificate: Certificate) -> str:
    """What was done: cases, maps, laws, profile, seconds."""
    names = {result.map for result in certificate.results}
    checked = sum(law.verdict != "absent" for law in certificate.laws)
    morphs = len({cell.morph for cell in certificate.morph_laws})
    matrix = f"law matrix of {counted(morphs, 'morph')}, " if morphs else ""
    return (
        f"{counted(certificate.cases, 'case')} of {counted(len(names), 'map')}, {counted(checked, 'law')}, {matrix}"
        f"profile {certificate.profile}, {certificate.seconds:.0f} s"
    )
