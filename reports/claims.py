"""The ledger of claims as people read it: what is told of an entry, in a terminal, as JSON, Markdown and HTML."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

from jinja2 import Environment
from rich.console import Console
from rich.table import Table
from rich.text import Text

from affinecert.certificate import plain
from affinecert.properties.claims import PAPERS
from affinecert.properties.claims.claim import Claim, Verdict
from affinecert.properties.claims.finding import Finding
from affinecert.reports.markdown import code, escape
from affinecert.reports.templates import environment
from affinecert.reports.terminal import table
from affinecert.reports.view import counted

WORDS: Mapping[str, str] = {
    Verdict.CONFIRMED: "confirmed",
    Verdict.REFUTED: "refuted",
    Verdict.BOUND: "holds on a domain",
    Verdict.UNCHECKABLE: "not checkable",
    "failed": "no verdict",
}
"""What the verdicts are called."""

SHORT: Mapping[str, str] = {**WORDS, Verdict.BOUND: "domain", Verdict.UNCHECKABLE: "unchecked", "failed": "failed"}
"""The same where there is little room."""

MEANINGS: Mapping[str, str] = {
    Verdict.CONFIRMED: "true in every case tried; every perturbed copy of it is refuted by the same check",
    Verdict.REFUTED: "false as printed; a counterexample is given, and what is true in its place",
    Verdict.BOUND: "true on the domain told, and false just outside of it",
    Verdict.UNCHECKABLE: "nothing that a machine could check, for the reason told",
}

STYLES: Mapping[str, str] = {
    Verdict.CONFIRMED: "green",
    Verdict.REFUTED: "red",
    Verdict.BOUND: "yellow",
    Verdict.UNCHECKABLE: "dim",
    "failed": "bold red",
}

TONES: Mapping[str, str] = {
    Verdict.CONFIRMED: "ok",
    Verdict.REFUTED: "wrong",
    Verdict.BOUND: "degraded",
    Verdict.UNCHECKABLE: "absent",
    "failed": "raised",
}
"""The colours of the page, which are those of the certificate's verdicts."""

GLYPHS: Mapping[str, str] = {"ok": "●", "wrong": "■", "degraded": "▲", "absent": "·", "raised": "✚"}


@dataclass(frozen=True)
class Entry:
    """A claim and what was found of it."""

    claim: Claim[Any, Any]
    finding: Finding

    @property
    def verdict(self) -> str:
        """The verdict that the check came to."""
        return self.finding.verdict


def entries(claims: Iterable[Claim[Any, Any]], findings: Iterable[Finding]) -> tuple[Entry, ...]:
    """The claims that have a finding, in their order."""
    found = {finding.claim: finding for finding in findings}
    return tuple(Entry(claim, found[claim.id]) for claim in claims if claim.id in found)


def by_paper(ledger: Sequence[Entry]) -> tuple[tuple[str, tuple[Entry, ...]], ...]:
    """The entries of each paper, under its title."""
    return tuple(
        (PAPERS[name].title, tuple(group)) for name, group in groupby(ledger, key=lambda entry: entry.claim.paper)
    )


def to_be_known(ledger: Sequence[Entry]) -> tuple[Entry, ...]:
    """The refuted and the domain-bound entries."""
    return tuple(entry for entry in ledger if entry.verdict in {Verdict.REFUTED, Verdict.BOUND})


def tally(ledger: Iterable[Entry]) -> str:
    """How many entries there are, and of each verdict: "3 claims: 2 confirmed, 1 refuted"."""
    counts = Counter(entry.verdict for entry in ledger)
    told = ", ".join(f"{counts[verdict]} {word}" for verdict, word in WORDS.items() if counts[verdict])
    return f"{counted(counts.total(), 'claim')}: {told}" if told else counted(0, "claim")


def chapter(claim: Claim[Any, Any]) -> str:
    """The module that holds a claim."""
    return next(module.__name__ for paper in PAPERS.values() for module in paper.chapters if claim in module.CLAIMS)


def amount(deviation: float | None) -> str:
    """A deviation in two digits."""
    return f"{deviation:.2g}" if deviation else "0"


def judgement(entry: Entry) -> str:
    """The verdict in words, with what a refuted claim reads like."""
    word, fault = WORDS[entry.verdict], entry.claim.fault
    return f"{word}: {fault}" if fault and entry.verdict == Verdict.REFUTED else word


def evidence(entry: Entry) -> str:
    """What the check measured, in a sentence."""
    finding = entry.finding
    if entry.verdict == Verdict.REFUTED:
        return f"deviates by {amount(finding.deviation)} in case {finding.counterexample_case}"
    inside = f"deviates by {amount(finding.deviation)} at most in {counted(finding.cases, 'case')}"
    return inside if finding.outside is None else f"{inside}; just outside by {amount(finding.outside)} at least"


def facts(entry: Entry) -> tuple[tuple[str, str], ...]:
    """All that is told of an entry, a name and a text each."""
    claim, finding = entry.claim, entry.finding
    correction = claim.correction
    told = [
        ("printed", claim.printed),
        ("verdict", judgement(entry)),
        ("domain", claim.domain),
        ("reason", claim.reason),
        ("evidence", evidence(entry) if finding.cases else ""),
        ("counterexample", finding.counterexample),
        ("true is", correction.statement if correction else ""),
        ("which", f"deviates by {amount(finding.correction)} at most" if correction and finding.cases else ""),
        *(
            ("perturbed", f"{change}: refuted, deviates by {amount(deviation)}")
            for change, deviation in finding.copies.items()
        ),
        *(("float64", f"{loss.where}: {lost(loss.digits)}") for loss in finding.losses),
        *((f"measured: {name}", number) for name, number in finding.numbers.items()),
        ("remark", claim.remark),
        *(("complaint", complaint) for complaint in finding.complaints),
    ]
    return tuple((name, text) for name, text in told if text)


def lost(digits: int) -> str:
    """The decimal digits lost, of the sixteen of float64."""
    return f"{'all' if digits >= 16 else digits} of 16 digits lost" if digits else "no digit lost"


def replay(entry: Entry) -> tuple[str, ...]:
    """The lines of Python that run the check in one case: the counterexample, or the first one."""
    if not entry.finding.cases:
        return ()
    number = entry.finding.counterexample_case or 0
    return (
        "from affinecert.properties.claims import LEDGER",
        f'claim = LEDGER["{entry.claim.id}"]',
        f"claim.deviation(claim.form, claim.cases()[{number}])",
    )


def record(entry: Entry) -> dict[str, Any]:
    """An entry as JSON values; without its seconds, so that two runs give the same."""
    claim, correction = entry.claim, entry.claim.correction
    found = asdict(entry.finding)
    for name in ("seconds", "claim", "verdict"):
        del found[name]
    stated = {
        "id": claim.id,
        "paper": claim.paper,
        "place": claim.place,
        "statement": claim.statement,
        "printed": claim.printed,
        "verdict": entry.verdict,
        "fault": claim.fault,
        "corrected": correction.statement if correction else "",
        "domain": claim.domain,
        "reason": claim.reason,
        "remark": claim.remark,
        "check": chapter(claim),
    }
    told = {name: value for name, value in (stated | found).items() if value not in ("", None, {}, ())}
    values: dict[str, Any] = plain(told)
    return values


def as_json(ledger: Iterable[Entry]) -> str:
    """The ledger as JSON, a line an entry."""
    lines = (json.dumps(record(entry), ensure_ascii=False, allow_nan=False) for entry in ledger)
    return "[\n  " + ",\n  ".join(lines) + "\n]"


def _environment(*, autoescape: bool) -> Environment:
    templates = environment(autoescape=autoescape)
    templates.filters.update(plain=escape, code=code)
    templates.globals.update(
        by_paper=by_paper,
        chapter=chapter,
        facts=facts,
        glyphs=GLYPHS,
        judgement=judgement,
        meanings=MEANINGS,
        replay=replay,
        tally=tally,
        to_be_known=to_be_known,
        tones=TONES,
        words=WORDS,
    )
    return templates


RENDERED: Mapping[str, bool] = {"ledger.md": False, "errata.md": False, "ledger.html": True}
"""The documents, by the names of their files, and whether their text is escaped as HTML."""


def render(ledger: Sequence[Entry], document: str) -> str:
    """One of the documents."""
    return _environment(autoescape=RENDERED[document]).get_template(f"{document}.jinja").render(ledger=ledger)


def documents(ledger: Sequence[Entry]) -> Mapping[str, str]:
    """All documents of a ledger, by the names of their files; the record comes first."""
    return {"ledger.json": as_json(ledger) + "\n"} | {name: render(ledger, name) for name in RENDERED}


def show(ledger: Sequence[Entry], console: Console) -> None:
    """Prints the ledger, an entry a line, paper by paper, with the complaints, and the tally at the end."""
    for title, group in by_paper(ledger):
        console.print(Text(title, style="bold"))
        console.print(_rows(group))
        console.print(Text(tally(group) + "\n", style="dim"))
    for entry in ledger:
        for complaint in entry.finding.complaints:
            console.print(Text.assemble((entry.claim.id, "bold red"), f": {complaint}"), soft_wrap=True)
    console.print(tally(ledger))


def _rows(group: Iterable[Entry]) -> Table:
    grid = table("verdict", "claim", "statement")
    grid.columns[0].no_wrap = True
    for entry in group:
        grid.add_row(Text(SHORT[entry.verdict], style=STYLES[entry.verdict]), entry.claim.id, entry.claim.statement)
    return grid


def show_entry(entry: Entry, console: Console) -> None:
    """Prints one entry in full, with how to replay it."""
    claim = entry.claim
    console.print(Text.assemble((claim.id, f"bold {STYLES[entry.verdict]}"), f"  {PAPERS[claim.paper].title}"))
    console.print(Text(f"{claim.place}: {claim.statement}\n"))
    grid = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    grid.add_column(style="dim", no_wrap=True, max_width=30)
    grid.add_column(overflow="fold")
    for name, text in facts(entry):
        grid.add_row(name, Text(text))
    grid.add_row("check", chapter(claim))
    console.print(grid)
    lines = replay(entry)
    if lines:
        console.print(Text("\nto replay it", style="dim"))
        for line in lines:
            console.print(Text(f"  {line}"), soft_wrap=True)


def write(ledger: Sequence[Entry], folder: Path) -> tuple[Path, ...]:
    """Writes the documents into a folder; each appears whole or not at all. Raises StoredFileError."""
    from affinecert.reports import prepare, replace  # noqa: PLC0415  (the package imports what it renders with)

    prepare(folder)
    return tuple(replace(folder / name, text) for name, text in documents(ledger).items())
