"""The findings in reports/findings hold: every snippet there prints what the text below it quotes.

And each is told in full, and seen in the published certificates where it says that they show it.
"""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from itertools import product
from pathlib import Path

import pytest

from affinecert.catalogue import CATALOGUE
from affinecert.scoring import Verdict

REPORTS = Path(__file__).parents[1] / "reports"
FOLDER = REPORTS / "findings"
CERTIFICATES = REPORTS / "certificates"
BLOCK = re.compile(r"^```(python|cpp)\n(.*?)^```\n(?:\s*^```text\n(.*?)^```)?", re.MULTILINE | re.DOTALL)

EIGEN = [f"-I{place}" for place in ("/usr/include/eigen3", "/usr/local/include/eigen3") if Path(place).is_dir()]
"""Where else headers are: g++ looks in the folders of CPLUS_INCLUDE_PATH as well, for those of Sophus, say."""

# Runs the snippets of one file, each in a namespace of its own; what one printed before it raised is told too.
RUNNER = """
import contextlib, io, json, sys, traceback, warnings
warnings.simplefilter("ignore")
printed = []
for snippet in json.load(sys.stdin):
    with contextlib.redirect_stdout(io.StringIO()) as output:
        try:
            exec(compile(snippet, "snippet", "exec"), {"__name__": "snippet"})
        except BaseException:
            print(traceback.format_exc())
    printed.append(output.getvalue())
json.dump(printed, sys.stdout)
"""


@dataclass(frozen=True)
class Snippet:
    """One fenced block of Python or C++, and what the text below it says that it prints."""

    file: str
    number: int
    language: str
    code: str
    quoted: str


def snippets() -> list[Snippet]:
    found = []
    for path in sorted(FOLDER.glob("*.md")):
        blocks = BLOCK.findall(path.read_text(encoding="utf-8"))
        found += [Snippet(path.name, k, *block) for k, block in enumerate(blocks, 1)]
    return found


def missing(snippet: Snippet) -> set[str]:
    """The packages or headers that a snippet asks for and nobody has installed; or the compiler."""
    if snippet.language == "cpp":
        if shutil.which("g++") is None:
            return {"g++"}
        return {header for header in re.findall("#include <(.*)>", snippet.code) if not preprocessed(header)}
    names = set()
    for node in ast.walk(ast.parse(snippet.code)):
        if isinstance(node, ast.Import):
            names |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add((node.module or "").partition(".")[0])
    return {name for name in names if find_spec(name) is None}


def preprocessed(header: str) -> bool:
    """Whether g++ finds a header."""
    command = ["g++", *EIGEN, "-E", "-x", "c++", "-", "-o", os.devnull]
    asked = f"#if !__has_include(<{header}>)\n#error\n#endif"
    return subprocess.run(command, input=asked, text=True, capture_output=True, check=False).returncode == 0


def compiled(snippet: Snippet, folder: Path) -> str:
    """What a snippet in C++ prints; products and sums are not fused, as they are not in what is quoted."""
    source, program = folder / "snippet.cpp", folder / "snippet"
    source.write_text(snippet.code, encoding="utf-8")
    subprocess.run(["g++", "-O0", "-std=c++17", "-ffp-contract=off", *EIGEN, source, "-o", program], check=True)
    return subprocess.run(program, capture_output=True, text=True, check=True).stdout


@cache
def printed(file: str) -> dict[int, str]:
    """What the snippets of one file print, by their numbers, run in one process of their own."""
    here = [snippet for snippet in snippets() if snippet.file == file and not missing(snippet)]
    done = subprocess.run(
        [sys.executable, "-c", RUNNER],
        input=json.dumps([snippet.code for snippet in here]),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    # A library may print while it is imported, outside of the snippets' own output.
    outputs = json.loads(done.stdout.splitlines()[-1])
    return {snippet.number: output for snippet, output in zip(here, outputs, strict=True)}


def test_there_are_findings() -> None:
    assert snippets()


@pytest.mark.parametrize("snippet", snippets(), ids=lambda snippet: f"{Path(snippet.file).stem}-{snippet.number}")
def test_a_snippet_prints_what_is_quoted(snippet: Snippet, tmp_path: Path) -> None:
    assert snippet.quoted, f"{snippet.file}: no ```text block follows snippet {snippet.number}"
    absent = missing(snippet)
    if absent:
        pytest.skip(f"not installed: {', '.join(sorted(absent))}")
    told = compiled(snippet, tmp_path) if snippet.language == "cpp" else printed(snippet.file)[snippet.number]
    assert told.strip() == snippet.quoted.strip()


@dataclass(frozen=True)
class Finding:
    """One section of a file that tells of a defect."""

    file: str
    title: str
    text: str

    @property
    def fields(self) -> dict[str, str]:
        """The named fields in their order, each as one line."""
        prose = re.sub(r"^```.*?^```$", "", self.text, flags=re.MULTILINE | re.DOTALL)
        return {name: " ".join(told.split()) for name, told in FIELD.findall(prose)}


FIELD = re.compile(r"^- \*\*([A-Z][a-z ]+)\*\*: (.*?)(?=^- \*\*|\Z)", re.MULTILINE | re.DOTALL)
FIELDS = ["What", "Where", "Found by", "Smallest input", "Expected", "Cause", "Fix", "Tracker"]
SHOWN = re.compile(r"^```(?:python|cpp)\n.*?^```\n\n```text\n", re.MULTILINE | re.DOTALL)
NAMES = r"[\w.-]+(?:(?:, | and )[\w.-]+)*"
CLAUSE = re.compile(rf"(?P<maps>{NAMES})(?: of (?P<subject>\w+))?, regimes? (?P<regimes>.*)")
GROUP = re.compile(rf"(?:, )?({NAMES}) \(([a-z-]+)\)")


@dataclass(frozen=True)
class Sight:
    """What a finding was found by: a verdict of a map in a regime, of the subject named or any of the library."""

    subject: str
    map: str
    regime: str
    verdict: str


def listed(names: str) -> list[str]:
    return re.split(", | and ", names)


@cache
def findings() -> tuple[Finding, ...]:
    found = []
    for path in sorted(set(FOLDER.glob("*.md")) - {FOLDER / "README.md"}):
        for section in re.split(r"^## ", path.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
            title, _, text = section.partition("\n")
            if not title.startswith(("Acquitted", "Degraded", "Looked at")):
                found.append(Finding(path.stem, re.sub(r"^\d+\. ", "", title), text))
    return tuple(found)


def sights(finding: Finding) -> Iterator[Sight]:
    """Those in the first sentence of "Found by": ``maps, regimes names (verdict), names (verdict); ...`` or reading."""
    first, _, _ = finding.fields["Found by"].removesuffix(".").partition(". ")
    for clause in first.split("; "):
        if clause.startswith("reading"):
            continue
        parts = CLAUSE.fullmatch(clause)
        assert parts is not None, clause
        assert GROUP.sub("", parts["regimes"]) == "", clause
        for regimes, verdict in GROUP.findall(parts["regimes"]):
            for name, regime in product(listed(parts["maps"]), listed(regimes)):
                yield Sight(parts["subject"] or "", name, regime, verdict)


@cache
def certified(library: str) -> frozenset[Sight]:
    """All that the published certificates of a library show; nothing if there are none."""
    seen = set()
    for path in CERTIFICATES.glob(f"{library}*.json"):
        for row in json.loads(path.read_text(encoding="utf-8"))["results"]:
            for verdict, subject in product(row["verdicts"], ("", path.stem)):
                seen.add(Sight(subject, row["map"], row["regime"], verdict))
    return frozenset(seen)


def test_a_sight_is_read() -> None:
    told = "so3.log and se3.log of x, regimes a-2d, b and c (wrong), d (raised); reading. Not this (wrong)."
    both = [Sight("x", name, regime, "wrong") for name in ("so3.log", "se3.log") for regime in ("a-2d", "b", "c")]
    raised = [Sight("x", name, "d", "raised") for name in ("so3.log", "se3.log")]
    assert list(sights(Finding("", "", f"- **Found by**: {told}\n"))) == both + raised


@pytest.mark.parametrize("finding", findings(), ids=lambda finding: f"{finding.file}-{finding.title[:40]}")
def test_a_finding_is_complete_and_its_certificate_shows_it(finding: Finding) -> None:
    assert list(finding.fields) == FIELDS
    assert SHOWN.search(finding.text), "no snippet with its output"
    told = list(sights(finding))
    for sight in told:
        assert sight.regime in {regime.name for regime in CATALOGUE[sight.map].regimes}, sight
        assert sight.verdict in set(Verdict), sight
    if certified(finding.file):
        assert set(told) - certified(finding.file) == set()


@cache
def told_of(library: str) -> tuple[frozenset[str], ...]:
    """The names in each paragraph, bullet and table row of a library's file."""
    text = (FOLDER / f"{library}.md").read_text(encoding="utf-8")
    return tuple(frozenset(re.findall(r"[\w.-]+[\w]", part)) for part in re.split(r"\n\n|\n(?=- |\|)", text))


@pytest.mark.parametrize("certificate", sorted(CERTIFICATES.glob("*.json")), ids=lambda path: path.stem)
def test_what_is_graver_than_degraded_and_every_broken_law_is_told(certificate: Path) -> None:
    library = next(path.stem for path in FOLDER.glob("*.md") if certificate.stem.startswith(path.stem))
    record = json.loads(certificate.read_text(encoding="utf-8"))
    broken = {law["name"] for law in record["laws"] if law["verdict"] == "failed"}
    assert broken - frozenset().union(*told_of(library)) == set()
    grave = [
        (row["map"], row["regime"], row["worst"]["verdict"])
        for row in record["results"]
        if row["worst"] and row["worst"]["verdict"] in {Verdict.WRONG, Verdict.NON_FINITE, Verdict.RAISED}
    ]
    # Of the plane and of space it is mostly the same fault: near-pi-2d and near-pi-3d are told by near-pi as well.
    assert [
        cell
        for cell in grave
        if not any(cell[0] in names and {cell[1], re.sub("-[23]d$", "", cell[1])} & names for names in told_of(library))
    ] == []


def test_the_index_tells_every_finding() -> None:
    index = (FOLDER / "README.md").read_text(encoding="utf-8")
    files = sorted(path for path in FOLDER.glob("*.md") if path.name != "README.md")
    assert [path.name for path in files if f"]({path.name})" not in index] == []
    assert [finding.title for finding in findings() if finding.title not in index] == []
    libraries = {finding.file for finding in findings()}
    told = f"{len(findings())} defects in released versions of {len(libraries)} libraries"
    assert told in index
    assert told in (FOLDER.parents[1] / "README.md").read_text(encoding="utf-8")
