"""Certificates side by side: rows of maps and regimes, columns of libraries; of each map, accuracy against speed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from affinecert.catalogue import CATALOGUE
from affinecert.certificate import CaseResult, Certificate, Machine, RegimeResult
from affinecert.scoring import FINDINGS, Verdict
from affinecert.snippet import fill
from affinecert.summary import GRAVITY


@dataclass(frozen=True)
class Library:
    """A column: a subject as certified. ``label`` is its name and version, and a number where two would be alike."""

    label: str
    name: str
    version: str
    spec: str
    dtype: str
    bits: int
    profile: str
    affinecert: str
    created: str
    maps: int
    cases: int
    findings: int


@dataclass(frozen=True)
class Cell:
    """A library on a map in a regime: its gravest case there, and how one calls it without affinecert, or "".

    A snippet that was run on a finding and showed something else is left out; ``proven`` are those that showed it.
    """

    library: str
    spec: str
    cases: int
    findings: int
    worst: CaseResult
    snippet: str

    @property
    def proven(self) -> bool:
        """Whether the snippet was run at this input, and shows the finding."""
        return bool(self.snippet) and self.worst.shown == self.worst.verdict


@dataclass(frozen=True)
class Row:
    """A map in a regime; a cell a library, None where it does not offer the map or the regime was not tried."""

    map: str
    regime: str
    cells: tuple[Cell | None, ...]


@dataclass(frozen=True)
class Point:
    """A library on a map: nanoseconds an item in batches of that size, gravest verdict, worst scaled error.

    The error is the worst over all regimes, other branches aside: these are far away, and no defects.
    """

    library: str
    dtype: str
    nanoseconds: float
    batch: int
    scaled: float
    verdict: str


@dataclass(frozen=True)
class Speed:
    """The libraries that were timed on a map."""

    map: str
    points: tuple[Point, ...]


@dataclass(frozen=True)
class Comparison:
    """Certificates side by side; ``notes`` say what keeps numbers in it from being held against each other."""

    libraries: tuple[Library, ...]
    rows: tuple[Row, ...]
    speeds: tuple[Speed, ...]
    notes: tuple[str, ...]


def compare(certificates: Sequence[Certificate], maps: Iterable[str] | None = None) -> Comparison:
    """The comparison of certificates, on those maps if they are given, in the order of the catalogue.

    Speeds of different machines are never compared: where there is more than one machine, they are left out.
    Raises StoredFileError where a snippet asks for an input that its map lacks.
    """
    labels = _labels(certificates)
    chosen = None if maps is None else set(maps)
    found = [
        {
            (result.map, result.regime): result
            for result in certificate.results
            if result.worst and (chosen is None or result.map in chosen)
        }
        for certificate in certificates
    ]
    keys = sorted(dict.fromkeys(key for results in found for key in results), key=_place)
    columns = list(zip(certificates, labels, found, strict=True))
    return Comparison(
        libraries=tuple(_library(certificate, label, results.values()) for certificate, label, results in columns),
        rows=tuple(
            Row(*key, tuple(_cell(certificate, label, results.get(key)) for certificate, label, results in columns))
            for key in keys
        ),
        speeds=tuple(_speeds(certificates, labels, dict.fromkeys(name for name, _ in keys))),
        notes=tuple(_notes(certificates, labels)),
    )


def _labels(certificates: Sequence[Certificate]) -> tuple[str, ...]:
    """Name and version; the second of the same gets a (2), and so on."""
    seen: Counter[str] = Counter()
    labels = []
    for certificate in certificates:
        label = f"{certificate.subject} {certificate.subject_version}"
        seen[label] += 1
        labels.append(f"{label} ({seen[label]})" if seen[label] > 1 else label)
    return tuple(labels)


def _place(key: tuple[str, str]) -> tuple[int, int]:
    """Where a map and regime stand in the catalogue; what it does not know comes last, in the certificates' order."""
    entry = CATALOGUE.get(key[0])
    regimes = [regime.name for regime in entry.regimes] if entry else []
    map_place = list(CATALOGUE).index(key[0]) if entry else len(CATALOGUE)
    return map_place, regimes.index(key[1]) if key[1] in regimes else len(regimes)


def _findings(result: RegimeResult) -> int:
    return sum(count for verdict, count in result.verdicts.items() if Verdict(verdict) in FINDINGS)


def _library(certificate: Certificate, label: str, results: Iterable[RegimeResult]) -> Library:
    shown = list(results)
    return Library(
        label=label,
        name=certificate.subject,
        version=certificate.subject_version,
        spec=certificate.spec,
        dtype=certificate.dtype,
        bits=certificate.arithmetic.bits,
        profile=certificate.profile,
        affinecert=certificate.affinecert,
        created=certificate.created,
        maps=len({result.map for result in shown}),
        cases=sum(result.cases for result in shown),
        findings=sum(map(_findings, shown)),
    )


def _cell(certificate: Certificate, label: str, result: RegimeResult | None) -> Cell | None:
    if result is None or result.worst is None:
        return None
    shows_it = result.worst.shown in {"", result.worst.verdict}
    template = certificate.snippets.get(result.map, "") if shows_it else ""
    inputs = result.worst.case["inputs"]
    return Cell(
        library=label,
        spec=certificate.spec,
        cases=result.cases,
        findings=_findings(result),
        worst=result.worst,
        snippet=fill(template, inputs, f"{label}, {result.map}"),
    )


def _hardware(machine: Machine) -> tuple[str, str, int]:
    """What makes two machines one: Python and its packages may differ, as some libraries need their own."""
    return machine.system, machine.processor, machine.cores


def one_machine(certificates: Sequence[Certificate]) -> bool:
    """Whether all certificates were made on the same machine."""
    return len({_hardware(certificate.machine) for certificate in certificates}) <= 1


def _speeds(certificates: Sequence[Certificate], labels: Sequence[str], maps: Iterable[str]) -> Iterator[Speed]:
    if not one_machine(certificates):
        return
    for name in maps:
        points = [_point(each, label, name) for each, label in zip(certificates, labels, strict=True)]
        if any(points):
            yield Speed(name, tuple(point for point in points if point))


def _point(certificate: Certificate, label: str, name: str) -> Point | None:
    timing = next((timing for timing in certificate.timings if timing.map == name), None)
    judged = [
        (scaled, verdict)
        for result in certificate.results
        if result.map == name
        for _, scaled, verdict in result.points
    ]
    if timing is None or not judged:
        return None
    return Point(
        library=label,
        dtype=certificate.dtype,
        nanoseconds=timing.nanoseconds,
        batch=timing.batch,
        scaled=max((scaled for scaled, verdict in judged if verdict != Verdict.OTHER_BRANCH), default=0.0),
        verdict=max((verdict for _, verdict in judged), key=lambda verdict: GRAVITY[Verdict(verdict)]),
    )


def _notes(certificates: Sequence[Certificate], labels: Sequence[str]) -> Iterator[str]:
    if not one_machine(certificates):
        yield "The certificates are of different machines, whose speeds are never compared: they are left out."
    for what, values in (
        ("by affinecert", [certificate.affinecert for certificate in certificates]),
        ("of profile", [certificate.profile for certificate in certificates]),
    ):
        if len(set(values)) > 1:
            told = ", ".join(f"{label} {value}" for label, value in zip(labels, values, strict=True))
            yield f"Not all were tried on the same inputs: the certificates are {what} {told}."
    single = [label for each, label in zip(certificates, labels, strict=True) if each.dtype == "float32"]
    if single:
        yield f"Errors are in units of 2^-53; those of {', '.join(single)}, in float32, in units of 2^-24."
