"""What changed against a baseline, as people read it: in words, which documents take from here, and in a terminal."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from rich.console import Console
from rich.text import Text

from affinecert.certificate import CaseResult, Certificate
from affinecert.ratchet import GROWTH, Kind, LawChange, Ratchet, RegimeChange
from affinecert.reports import view
from affinecert.scoring import Verdict

STYLES: Mapping[Kind, str] = {Kind.WORSE: "red", Kind.NEW: "yellow", Kind.BETTER: "green", Kind.CHANGED: "blue"}

TONES: Mapping[Kind, str] = {
    Kind.WORSE: "wrong",
    Kind.NEW: "degraded",
    Kind.BETTER: "ok",
    Kind.CHANGED: "other-branch",
}
"""The colours of the page, which are those of the certificate's verdicts."""

RULE = (
    f"Worse is a graver verdict that is a finding, a worst scaled error of a finding that has grown by more than a "
    f"factor of {GROWTH:g}, a map that is no longer offered, and a law that is newly broken; only that fails. New are "
    f"findings of which the baseline says nothing."
)
"""What counts, for readers."""


def outcome(found: Ratchet) -> str:
    """The whole comparison in a few words: "2 worse, 1 better, 34 regimes as before"."""
    if found.recorded:
        return "no baseline yet: recorded"
    parts = [f"{found.count(kind)} {kind}" for kind in Kind if found.count(kind)]
    return ", ".join([*(parts or ["nothing changed"]), f"{view.counted(found.same, 'regime')} as before"])


def against(found: Ratchet, certificate: Certificate) -> str:
    """What it was held against."""
    return f"against {certificate.subject} {found.version} of {found.created}"


def notes(found: Ratchet) -> tuple[str, ...]:
    """What should be known of the two runs, so that not every change is put down to the subject."""
    differing = [f"{each.what}: {each.before} in the baseline, {each.now} now" for each in found.differences]
    if found.gone:
        differing.append(f"{view.counted(found.gone, 'regime')} in the baseline only")
    if found.come:
        differing.append(f"{view.counted(found.come, 'regime')} not in the baseline")
    return tuple(differing)


def place(change: RegimeChange) -> str:
    """The map and the regime, or the map alone."""
    return f"{change.map}, {change.regime}" if change.regime else change.map


def sentence(change: RegimeChange) -> str:
    """How a regime, or a whole map, changed: "ok 1.50 u, now degraded 40.0 u"."""
    if change.now == Verdict.ABSENT:
        return "no longer offered"
    if not change.regime:
        return "offered now, and in order"
    now = _told(change.now, change.worst)
    return f"{_told(change.before, change.worst_before)}, now {now}" if change.before else f"not in the baseline: {now}"


def _told(verdict: str, worst: CaseResult | None) -> str:
    return f"{verdict} {view.error(worst.scaled)} u" if worst else verdict


def law_sentence(change: LawChange) -> str:
    """How a law changed: "passed, now failed"."""
    before = f"{change.before}, now " if change.before else "not in the baseline: "
    return f"{before}{change.law.verdict}"


def show(found: Ratchet, certificate: Certificate, console: Console, path: Path) -> None:
    """Prints the comparison with the baseline in the file ``path``; what is worse, or new, with how to see it."""
    if found.recorded:
        console.print(Text(f"\nno baseline yet: recorded in {path}"), soft_wrap=True)
        return
    console.print(Text(f"\n{against(found, certificate)} ({path})", style="dim"), soft_wrap=True)
    for kind in Kind:
        for law in (each for each in found.laws if each.kind is kind):
            console.print(Text.assemble((kind, STYLES[kind]), f"  law {law.law.name}: {law_sentence(law)}"))
        for change in (each for each in found.regimes if each.kind is kind):
            console.print(Text.assemble((kind, STYLES[kind]), f"  {place(change)}: {sentence(change)}"))
            if change.worst and kind in {Kind.WORSE, Kind.NEW}:
                console.print(Text(f"  {view.reproduce(certificate, change.worst)}"), soft_wrap=True)
    for note in notes(found):
        console.print(Text(note, style="dim"))
    style = "bold green" if found.passed else "bold red"
    console.print(Text.assemble("against the baseline: ", (outcome(found), style)))
