"""An explanation, a replay and the catalogue in a terminal."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from rich.console import Console
from rich.table import Table
from rich.text import Text

from affinecert.case import to_record
from affinecert.certificate import CaseResult
from affinecert.explain import Entry, Explanation, Reply, entries
from affinecert.map import Map
from affinecert.reports import view
from affinecert.reports.terminal import SHOWN, table, verdict
from affinecert.scoring import Verdict

if TYPE_CHECKING:
    from affinecert.existence import Sweep
    from affinecert.hunt import Catch


def show(explanation: Explanation, console: Console) -> None:
    """Prints an explanation: the input, the truth beside the answers, and the errors of each block."""
    entry, truth = explanation.map, explanation.truth
    console.print(Text.assemble((entry.name, "bold"), f"  {entry.definition}"))
    for argument, array in zip(entry.arguments, explanation.inputs, strict=True):
        console.print(Text(f"\n{argument.name}", style="dim"))
        console.print(
            Text(np.array2string(array, floatmode="unique", max_line_width=10_000, separator=", ")), soft_wrap=True
        )
    console.print()
    if truth.refusal is not None:
        console.print(f"outside the domain: {truth.refusal}", markup=False)
    else:
        console.print(_values(explanation))
    console.print()
    console.print(_errors(explanation))
    for reply in explanation.replies:
        if reply.score.note:
            console.print(Text.assemble((f"{reply.subject}: ", "dim"), " ".join(reply.score.note.split())))


def _values(explanation: Explanation) -> Table:
    """One entry a line: its truth, and what each subject answered."""
    answered = [reply for reply in explanation.replies if reply.answer.outputs is not None]
    grid = table("", "truth, 30 digits", *(reply.subject for reply in answered))
    several = len(explanation.truth.high) > 1
    for entry in entries(explanation.truth):
        name = f"output {entry.output + 1} " if several else ""
        place = ", ".join(map(str, entry.index))
        grid.add_row(f"{name}[{place}]" if place else name, entry.digits, *(_value(reply, entry) for reply in answered))
    return grid


def _value(reply: Reply, entry: Entry) -> str:
    """The subject's number there; nothing where its answer has no such place."""
    outputs = reply.answer.outputs or ()
    if entry.output >= len(outputs) or outputs[entry.output].ndim != len(entry.index):
        return ""
    if any(place >= extent for place, extent in zip(entry.index, outputs[entry.output].shape, strict=True)):
        return ""
    return str(outputs[entry.output][entry.index])


def _errors(explanation: Explanation) -> Table:
    numbers = ("forward", "scaled", "condition", "backward")
    grid = table("subject", "block", *numbers, "verdict", numbers=numbers)
    for reply in explanation.replies:
        judged = reply.score
        who = f"{reply.subject} {reply.version}"
        if not judged.blocks:
            grid.add_row(who, "", *[view.figure(None)] * 4, verdict(judged.verdict))
        for number, block in enumerate(judged.blocks):
            first = number == 0
            measured = view.error(block.forward), view.error(block.scaled), view.error(block.condition)
            grid.add_row(
                who if first else "",
                block.block,
                *measured,
                *((view.error(judged.backward), verdict(judged.verdict)) if first else ()),
            )
    return grid


def show_replay(results: Sequence[CaseResult], console: Console) -> None:
    """Prints the results of cases judged again, in order."""
    numbers = ("scaled", "forward", "backward", "condition")
    grid = table("map", "regime", *numbers, "verdict", "", numbers=numbers)
    for result in results:
        figures = (result.scaled, result.forward, result.backward, result.condition)
        note = Text(" ".join(result.note.split()))
        case = result.case
        grid.add_row(Text(case["map"]), Text(case["regime"]), *map(view.error, figures), verdict(result.verdict), note)
    console.print(grid)
    bad = sum(Verdict(result.verdict).is_finding for result in results)
    style = "bold red" if bad else "bold green"
    said = view.counted(bad, "finding") if bad else "no finding"
    console.print(Text.assemble("\n", (said, style), f" in {view.counted(len(results), 'case')}"))


def show_catalogue(maps: Iterable[Map], console: Console) -> None:
    """Prints what there is to certify: each map with its definition, source, domain and regimes."""
    for number, entry in enumerate(maps):
        if number:
            console.print()
        console.print(Text.assemble((entry.name, "bold"), f"({', '.join(a.name for a in entry.arguments)})"))
        grid = Table.grid(padding=(0, 2))
        for title, text in (
            ("", entry.definition),
            ("source", entry.source),
            ("domain", entry.domain),
            ("regimes", ", ".join(regime.name for regime in entry.regimes)),
        ):
            grid.add_row(Text(f"  {title:7}", style="dim"), Text(text))
        console.print(grid)


def catalogue_json(maps: Iterable[Map]) -> str:
    """The same as JSON, for programs."""
    return json.dumps(
        [
            {
                "name": entry.name,
                "definition": entry.definition,
                "source": entry.source,
                "domain": entry.domain,
                "arguments": [{"name": a.name, "shape": a.shape, "units": a.units} for a in entry.arguments],
                "outputs": entry.outputs,
                "blocks": [block.name for block in entry.blocks],
                "regimes": [{"name": regime.name, "distance": regime.distance} for regime in entry.regimes],
                "inverse": entry.inverse,
                "bound": entry.bound,
            }
            for entry in maps
        ],
        indent=2,
        ensure_ascii=False,
    )


def show_catches(catches: Sequence[Catch], subject: str, console: Console) -> None:
    """Prints what a hunt caught, each with the command that explains it."""
    for catch in catches:
        case = catch.case
        errors = f"scaled error {view.error(catch.scaled)} u, forward {view.error(catch.forward)} u"
        where = f"  {case.map}, {case.regime}: {errors}; {view.counted(catch.evaluations, 'input')} tried"
        console.print(Text.assemble(verdict(catch.verdict), where))
        console.print(Text(f"  {view.command(case.map, to_record(case)['inputs'], subject)}"), soft_wrap=True)


def show_sweep(swept: Sweep, console: Console) -> None:
    """Prints the outcome of a sweep over sam.exists, with the first few matrices that were decided wrongly."""
    said = f"{len(swept.wrong):,} decided wrongly" if swept.wrong else "all decided rightly"
    style = "bold red" if swept.wrong else "bold green"
    head = f"{view.counted(swept.tried, 'matrix', 'matrices')}, of which {swept.exist:,} have a real logarithm: "
    console.print(Text.assemble(head, (said, style)))
    for rows in swept.wrong[:SHOWN]:
        console.print(Text(json.dumps([[entry.hex() for entry in row] for row in rows])), soft_wrap=True)
