"""The certificate in a terminal: one table of maps by regime, the laws, the findings, and one line at the end.

It reads as well without colour as with it, on a screen of 100 columns.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from rich.console import Console
from rich.table import Table
from rich.text import Text

from affinecert.certificate import CaseResult, Certificate, LawRecord
from affinecert.reports import matrix, view
from affinecert.scoring import Verdict

STYLES: Mapping[str, str] = {
    Verdict.OK: "green",
    Verdict.OTHER_BRANCH: "blue",
    Verdict.ABSENT: "dim",
    Verdict.DEGRADED: "yellow",
    Verdict.WRONG: "red",
    Verdict.NON_FINITE: "magenta",
    Verdict.RAISED: "bold red",
    "passed": "green",
    "failed": "red",
}

SHOWN = 10
"""Findings that are told at most; the page shows the rest."""

NOTE = 160
"""Characters of a note that are told: what a subject answered may be long."""


def _clipped(note: str) -> str:
    line = " ".join(note.split())
    return line if len(line) <= NOTE else f"{line[: NOTE - 1]}…"


def table(*columns: str, numbers: Sequence[str] = ()) -> Table:
    """An empty table without frames; the columns named in ``numbers`` are flush right."""
    grid = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim", collapse_padding=True)
    for column in columns:
        if column in numbers:
            grid.add_column(column, justify="right", no_wrap=True)
        else:
            grid.add_column(column, overflow="fold")
    return grid


def verdict(name: str) -> Text:
    """A verdict or a law's outcome, in its colour."""
    return Text(name, style=STYLES[name])


def tally(verdicts: Mapping[str, int]) -> Text:
    """Verdict counts in the colour of the gravest."""
    words = view.tally(verdicts)
    return Text(words or "no cases", style=STYLES[words.split(", ")[0].split(" ")[1]] if words else "dim")


def show(certificate: Certificate, console: Console) -> None:
    """Prints the certificate."""
    console.print(_errors(certificate))
    if certificate.absent:
        console.print(Text(f"\nmaps not offered: {', '.join(map(str, view.absent(certificate)))}", style="dim"))
    checked = [law for law in view.laws(certificate) if law.verdict != "absent"]
    if checked:
        console.print()
        console.print(_laws(checked))
    if without := [law.name for law in certificate.laws if law.verdict == "absent"]:
        gaps = view.by_family(without, (law.name for law in checked))
        console.print(Text(f"\nlaws of maps not offered: {', '.join(map(str, gaps))}", style="dim"))
    if certificate.morph_laws:
        console.print()
        matrix.show(certificate.morph_laws, console, statements=False)
    show_findings(certificate, console)
    style = "bold green" if certificate.passed else "bold red"
    head = Text(f"\n{certificate.subject} {certificate.subject_version}: ").append(view.outcome(certificate), style)
    console.print(head)
    console.print(Text(view.extent(certificate), style="dim"))


def _errors(certificate: Certificate) -> Table:
    numbers = ("scaled", "forward", "backward", "condition")
    grid = table("regime", *numbers, "verdicts", numbers=numbers)
    for number, entry in enumerate(view.maps(certificate)):
        if number:
            grid.add_row()
        grid.add_row(Text(entry.name, style="bold"))
        for result in entry.results:
            worst = result.worst
            style = STYLES[worst.verdict] if worst else ""
            grid.add_row(
                Text(f"  {result.regime}"),
                Text(view.error(worst.scaled if worst else None), style=style),
                *(view.error(value) for value in _others(worst)),
                tally(result.verdicts),
            )
    return grid


def _others(worst: CaseResult | None) -> tuple[float | None, ...]:
    return (worst.forward, worst.backward, worst.condition) if worst else (None, None, None)


def _laws(laws: Iterable[LawRecord]) -> Table:
    """The laws the subject was held to."""
    numbers = ("residual", "bound", "examples")
    grid = table("law", "verdict", *numbers, numbers=numbers)
    for law in laws:
        figures = (view.error(law.worst), view.figure(law.bound), f"{law.examples:,}")
        grid.add_row(Text(law.name), verdict(law.verdict), *figures)
    return grid


def show_findings(certificate: Certificate, console: Console) -> None:
    """Prints how laws are broken, and the gravest finding of each map and regime with the command that explains it."""
    broken = [law for law in certificate.laws if law.verdict == "failed"]
    told = view.gravest(view.findings(certificate), "map", "regime")
    if not broken and not told:
        return
    console.print(Text("\nfindings, gravest first", style="dim"))
    for law in broken:
        console.print(Text.assemble(verdict(law.verdict), f"  {law.name}: {_clipped(law.note or law.statement)}"))
    for finding in told[:SHOWN]:
        head = Text.assemble(
            verdict(finding.verdict),
            f"  {finding.case['map']}, {finding.case['regime']}: {_clipped(finding.note)}",
        )
        console.print(head)
        # As one line, however long: what a terminal breaks by itself it also copies whole.
        console.print(Text(f"  {view.reproduce(certificate, finding)}"), soft_wrap=True)
    if len(told) > SHOWN:
        console.print(Text(f"and in {view.counted(len(told) - SHOWN, 'more regime')}", style="dim"))
