"""The certificate: the versioned record of a run, from which everything shown to people is rendered."""

from __future__ import annotations

import json
import math
import os
import platform
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from functools import cache
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import Any

import jsonschema

from affinecert.arithmetic import ARITHMETICS, Arithmetic
from affinecert.errors import StoredFileError

FORMAT = 2
"""The version of the record's form; raised when a reader of the old form would misread the new one."""

SHOWN_FINDINGS = 5
"""Findings that are told for each map and regime, gravest first; all of them are counted."""


@dataclass(frozen=True)
class CaseResult:
    """One judged case: its errors in u, and the case itself as a corpus record.

    ``shown`` is the verdict on what the subject's snippet printed at this very input, "" where it was not run.
    """

    verdict: str
    note: str
    block: str
    forward: float
    scaled: float
    condition: float
    backward: float | None
    case: Mapping[str, Any]
    shown: str = ""


@dataclass(frozen=True)
class RegimeResult:
    """All the cases of one map and regime; ``points`` are (distance, worst scaled error, verdict), for the plots."""

    map: str
    regime: str
    distance: str
    cases: int
    verdicts: Mapping[str, int]
    worst: CaseResult | None
    findings: tuple[CaseResult, ...]
    points: tuple[tuple[float, float, str], ...]

    @property
    def passed(self) -> bool:
        """Whether there is no finding."""
        return not self.findings

    def showing(self, shown: str) -> RegimeResult:
        """The same, its gravest finding with what the subject's snippet shows there."""
        if not self.findings or not shown:
            return self
        gravest = replace(self.findings[0], shown=shown)
        return replace(self, worst=gravest, findings=(gravest, *self.findings[1:]))


@dataclass(frozen=True)
class LawRecord:
    """What became of one law: ``verdict`` is passed, failed or absent."""

    name: str
    statement: str
    source: str
    domain: str
    verdict: str
    worst: float
    bound: float
    examples: int
    inputs: tuple[Any, ...]
    note: str


@dataclass(frozen=True)
class MorphLawRecord:
    """A cell of the law matrix: what became of a law of morphs, tried on one morph.

    ``verdict`` is holds; partly, if it holds on a part of the pairs of poses that the morph ``takes``, of which
    ``holds_on`` tells the widest; fails; unclear, if the residual is neither rounding nor anything else; void, if the
    law says nothing of the morph; or absent. ``inputs``, as hexadecimal floats, are the simplest pair of poses found
    on which it fails, start and end, and for the law of continuity the pair next to it; ``residual`` is the one
    there, or else the largest of all ``examples``. ``confirmed`` says that the reference agrees. ``value`` is the
    average relative acceleration between standard poses, in the cell of that law.
    """

    morph: str
    law: str
    verdict: str
    takes: str
    holds_on: tuple[str, ...] = ()
    residual: float = 0.0
    examples: int = 0
    inputs: tuple[Any, ...] = ()
    confirmed: bool = False
    value: float | None = None
    note: str = ""


@dataclass(frozen=True)
class Timing:
    """The best time per item over a few rounds, at that batch size."""

    map: str
    batch: int
    nanoseconds: float


@dataclass(frozen=True)
class Machine:
    """Where a run took place; numbers of different machines are never compared."""

    system: str
    processor: str
    cores: int
    python: str
    packages: Mapping[str, str]


@dataclass(frozen=True)
class Certificate:
    """The record of a run; ``spec`` is what the subject is called on the command line.

    ``morph_laws`` is the law matrix, row by row. A law that a morph breaks is a property of the morph: no finding.
    Errors are in the unit of the ``dtype`` that the subject computes in.
    ``snippets`` are the subject's, by map (see `Subject`).
    """

    subject: str
    subject_version: str
    spec: str
    conventions: Mapping[str, str]
    affinecert: str
    profile: str
    maps: str
    created: str
    seconds: float
    machine: Machine
    results: tuple[RegimeResult, ...]
    laws: tuple[LawRecord, ...]
    timings: tuple[Timing, ...]
    absent: tuple[str, ...] = field(default=())
    morph_laws: tuple[MorphLawRecord, ...] = field(default=())
    dtype: str = "float64"
    snippets: Mapping[str, str] = field(default_factory=dict)

    @property
    def arithmetic(self) -> Arithmetic:
        """The numbers that the subject computes in."""
        return ARITHMETICS[self.dtype]

    @property
    def cases(self) -> int:
        """How many cases were judged."""
        return sum(result.cases for result in self.results)

    @property
    def passed(self) -> bool:
        """Whether there is no finding and no broken law."""
        return all(result.passed for result in self.results) and all(law.verdict != "failed" for law in self.laws)


def machine() -> Machine:
    """The machine that this runs on."""
    return Machine(
        system=f"{platform.system()} {platform.machine()}",
        processor=_processor(),
        cores=os.cpu_count() or 1,
        python=platform.python_version(),
        packages={name: version(name) for name in ("numpy", "numba", "mpmath")},
    )


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor()
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor()


def plain(value: Any) -> Any:
    """The value in JSON: mappings, lists, numbers; JSON has no infinity, so it is written as the string "inf"."""
    if isinstance(value, Mapping):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, float) and math.isinf(value):
        return "inf"
    return value


def dump(certificate: Certificate) -> dict[str, Any]:
    """The certificate as JSON values, of the form that ``certificate.schema.json`` describes."""
    head = {"format": FORMAT, "passed": certificate.passed, "cases": certificate.cases}
    return {**head, **plain(asdict(certificate))}


@cache
def schema() -> dict[str, Any]:
    """The published JSON Schema of a certificate."""
    text = (files("affinecert") / "certificate.schema.json").read_text(encoding="utf-8")
    loaded: dict[str, Any] = json.loads(text)
    return loaded


def _number(value: Any) -> float:
    return math.inf if value == "inf" else float(value)


def case_result(record: Mapping[str, Any]) -> CaseResult:
    """The result of a JSON record."""
    numbers = {name: _number(record[name]) for name in ("forward", "scaled", "condition")}
    backward = record["backward"]
    return CaseResult(**{**record, **numbers, "backward": None if backward is None else _number(backward)})


def morph_law(record: Mapping[str, Any]) -> MorphLawRecord:
    """The cell of the law matrix of a JSON record."""
    lists = {name: tuple(record[name]) for name in ("holds_on", "inputs")}
    return MorphLawRecord(**{**record, **lists, "residual": _number(record["residual"])})


def parse(record: Mapping[str, Any], name: str) -> Certificate:
    """The certificate of a JSON record; ``name`` is the file's, for errors."""
    try:
        jsonschema.validate(record, schema())
    except jsonschema.ValidationError as error:
        place = "/".join(map(str, error.absolute_path)) or "the record"
        raise StoredFileError(f"{name}: not a certificate of format {FORMAT}: {place}: {error.message}") from error
    fields = {key: value for key, value in record.items() if key not in {"format", "passed", "cases"}}
    results = tuple(
        RegimeResult(
            **{
                **result,
                "worst": None if result["worst"] is None else case_result(result["worst"]),
                "findings": tuple(case_result(finding) for finding in result["findings"]),
                "points": tuple((_number(d), _number(e), v) for d, e, v in result["points"]),
            }
        )
        for result in fields.pop("results")
    )
    laws = tuple(
        LawRecord(**{**law, "worst": _number(law["worst"]), "inputs": tuple(law["inputs"])})
        for law in fields.pop("laws")
    )
    cells = tuple(map(morph_law, fields.pop("morph_laws")))
    timings = tuple(Timing(**timing) for timing in fields.pop("timings"))
    there = Machine(**fields.pop("machine"))
    absent = tuple(fields.pop("absent"))
    return Certificate(
        **fields, machine=there, results=results, laws=laws, timings=timings, absent=absent, morph_laws=cells
    )


def read(path: Path) -> Certificate:
    """The certificate in a file."""
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise StoredFileError(f"cannot read the certificate {path}: {error}") from error
    return parse(record, str(path))
