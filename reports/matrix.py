"""The law matrix as people read it: its words, and a table of them in a terminal."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass

from rich.console import Console
from rich.table import Table
from rich.text import Text

from affinecert.case import from_hex
from affinecert.certificate import MorphLawRecord, plain
from affinecert.properties.matrix.domains import DOMAINS, NO_HALF_TURN
from affinecert.properties.matrix.laws import LAWS, STEADINESS
from affinecert.reports.view import counted, figure

STYLES: Mapping[str, str] = {
    "holds": "green",
    "nearly": "green",
    "partly": "yellow",
    "fails": "red",
    "unclear": "magenta",
    "void": "dim",
    "absent": "dim",
}

WORDS: Mapping[str, str] = {"holds": "yes", "fails": "no", "unclear": "?", "void": "–", "absent": "·"}

MEANINGS: Mapping[str, str] = {
    "yes": "holds on every pair of poses that was tried and has a morph",
    "no": "fails; elsewhere than between poses that differ by a translation it may hold nowhere",
    "–": "says nothing of the morph, which does not take the poses",
    "?": "could not be told",
    "·": "the subject does not offer the morph",
    "!": "the reference does not agree: it is the code that breaks the law, or keeps it",
}
"""What stands in the cells, but for the names of domains."""

SHORT: Mapping[str, str] = {domain.words: domain.name for domain in DOMAINS}
HEADS: Mapping[str, str] = {law.name: law.head for law in LAWS}
STATEMENTS: Mapping[str, str] = {law.name: f"{law.statement} ({law.source})" for law in LAWS}


@dataclass(frozen=True)
class Row:
    """The cells of one morph, with the poses that it takes."""

    morph: str
    takes: str
    cells: tuple[MorphLawRecord, ...]


def rows(cells: Iterable[MorphLawRecord]) -> tuple[Row, ...]:
    """The matrix, row by row."""
    found: dict[str, list[MorphLawRecord]] = {}
    for cell in cells:
        found.setdefault(cell.morph, []).append(cell)
    return tuple(Row(name, row[0].takes, tuple(row)) for name, row in found.items())


def columns(cells: Iterable[MorphLawRecord]) -> tuple[str, ...]:
    """The names of the laws, in order."""
    return tuple(dict.fromkeys(cell.law for cell in cells))


def tone(cell: MorphLawRecord) -> str:
    """The verdict as it is coloured: a law that fails at turns by exactly pi alone nearly holds."""
    return "nearly" if cell.verdict == "partly" and cell.holds_on[0] == NO_HALF_TURN.words else cell.verdict


def word(cell: MorphLawRecord) -> str:
    """What stands in a cell: yes, no, or the widest domain on which the law holds; for ARA its value."""
    told = SHORT.get(cell.holds_on[0], cell.holds_on[0]) if cell.verdict == "partly" else WORDS[cell.verdict]
    if cell.law == STEADINESS.name and cell.value is not None:
        told = "0" if cell.verdict == "holds" else figure(cell.value)
    return told + ("" if cell.confirmed or cell.verdict in {"unclear", "void", "absent"} else "!")


OUTCOMES: Mapping[str, str] = {
    "holds": "holds",
    "partly": "fails",
    "fails": "fails",
    "unclear": "is unclear",
    "void": "says nothing",
    "absent": "was not tried, as the subject does not offer the morph",
}


def sentence(cell: MorphLawRecord) -> str:
    """A cell in full."""
    parts = [f"{cell.law}: {OUTCOMES[cell.verdict]}"]
    if cell.examples:
        parts.append(f"on {counted(cell.examples, 'pair')} tried ({cell.takes}), residual {figure(cell.residual)}")
    if cell.holds_on:
        parts.append("holds where " + ", or where ".join(cell.holds_on))
    if cell.value is not None:
        parts.append(f"between the standard poses it is {figure(cell.value)}")
    if cell.examples and not cell.confirmed:
        parts.append("the reference does not agree")
    if cell.note:
        parts.append(cell.note)
    return "; ".join(parts)


def named_poses(cell: MorphLawRecord) -> tuple[tuple[str, str], ...]:
    """The poses of a counterexample, without their last rows, as JSON: B and C, and perhaps those next to them."""
    told = (json.dumps(from_hex(pose).tolist()[:-1]) for pose in cell.inputs)
    return tuple(zip(("B", "C", "next to it B", "and C"), told, strict=False))


def legend(cells: Sequence[MorphLawRecord], *, statements: bool = True) -> tuple[tuple[str, str], ...]:
    """What the words in the matrix mean: domains, signs, morphs that take some poses only, and the heads of laws."""
    named = {cell.holds_on[0] for cell in cells if cell.verdict == "partly"}
    told = [word(cell) for cell in cells]
    signs = {sign.removesuffix("!") for sign in told} | {sign[-1] for sign in told if sign.endswith("!")}
    takes = dict.fromkeys(row.takes for row in rows(cells) if row.takes != DOMAINS[0].words)
    return (
        *((domain.name, domain.words) for domain in DOMAINS if domain.words in named),
        *((sign, meaning) for sign, meaning in MEANINGS.items() if sign in signs),
        *((", ".join(row.morph for row in rows(cells) if row.takes == pairs), pairs) for pairs in takes),
        *((HEADS[name], STATEMENTS[name]) for name in columns(cells) if name in HEADS and statements),
    )


def counterexamples(cells: Iterable[MorphLawRecord]) -> tuple[MorphLawRecord, ...]:
    """The cells that have one."""
    return tuple(cell for cell in cells if cell.inputs)


def as_json(cells: Iterable[MorphLawRecord]) -> str:
    """The cells as JSON, a line each."""
    return "[\n  " + ",\n  ".join(json.dumps(plain(asdict(cell)), ensure_ascii=False) for cell in cells) + "\n]"


def show(cells: Sequence[MorphLawRecord], console: Console, *, statements: bool = True) -> None:
    """Prints the matrix, in as many parts as the screen needs, and what its words mean, with the laws' statements."""
    shown, names = rows(cells), columns(cells)
    left = max(len(row.morph) for row in shown)
    room = max((console.width - left) // (WIDTH + 1), 1)
    for start in range(0, len(names), room):
        if start:
            console.print()
        console.print(_part(shown, range(start, min(start + room, len(names))), names))
    console.print()
    for name, meaning in legend(cells, statements=statements):
        console.print(Text.assemble((name, "bold"), f": {meaning}"))


WIDTH = 8
"""Characters of a cell: the names of domains and the heads of columns have no more."""


def _part(shown: Sequence[Row], places: Iterable[int], names: Sequence[str]) -> Table:
    grid = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0), header_style="dim")
    grid.add_column("", no_wrap=True, min_width=max(len(row.morph) for row in shown))
    chosen = list(places)
    for place in chosen:
        grid.add_column(HEADS.get(names[place], names[place]), no_wrap=True, min_width=WIDTH)
    for row in shown:
        told = [Text(word(row.cells[place]), style=STYLES[tone(row.cells[place])]) for place in chosen]
        grid.add_row(Text(row.morph), *told)
    return grid


def show_cells(cells: Iterable[MorphLawRecord], console: Console) -> None:
    """Prints cells in full, each with its counterexample."""
    for cell in cells:
        console.print(Text.assemble((cell.morph, STYLES[tone(cell)]), f"  {sentence(cell)}"))
        for name, pose in named_poses(cell):
            console.print(Text(f"  {name} = {pose}"), soft_wrap=True)
