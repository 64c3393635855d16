"""Certificates side by side as people read them: in a terminal, as JSON, Markdown and one self-contained HTML page."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

from markupsafe import Markup
from rich.console import Console
from rich.table import Table
from rich.text import Text

from affinecert.catalogue import CATALOGUE
from affinecert.certificate import plain
from affinecert.compare import Cell, Comparison, Library, Point, Row, Speed
from affinecert.reports import view
from affinecert.reports.html import GLYPHS, anchor
from affinecert.reports.markdown import code, escape
from affinecert.reports.speed import plot
from affinecert.reports.templates import environment
from affinecert.reports.terminal import STYLES
from affinecert.scoring import Verdict


@dataclass(frozen=True)
class MapRows:
    """A map of the comparison with its rows, in which the libraries that do not offer it are left out."""

    name: str
    definition: str
    bound: float | None
    libraries: tuple[Library, ...]
    rows: tuple[Row, ...]
    speed: Speed | None

    @property
    def plot(self) -> Markup:
        """Accuracy against speed, as SVG; nothing where no library was timed."""
        return Markup(plot(self.speed, self.bound) if self.speed else "")

    @property
    def cells(self) -> tuple[tuple[Row, Cell], ...]:
        """All cells, each with its row."""
        return tuple((row, cell) for row in self.rows for cell in row.cells if cell)

    def gravest(self, library: Library) -> tuple[Row, Cell] | None:
        """A library's gravest cell, with its row; None if it does not offer the map."""
        own = [(row, cell) for row, cell in self.cells if cell.library == library.label]
        return max(own, key=lambda pair: view.gravity(pair[1].worst), default=None)

    def point(self, library: Library) -> Point | None:
        """How fast a library is; None if it was not timed."""
        points = self.speed.points if self.speed else ()
        return next((point for point in points if point.library == library.label), None)


def maps(found: Comparison) -> tuple[MapRows, ...]:
    """The maps of a comparison, in order."""
    speeds = {speed.map: speed for speed in found.speeds}
    views = []
    for name, group in groupby(found.rows, key=lambda row: row.map):
        rows, entry = list(group), CATALOGUE.get(name)
        places = [place for place in range(len(found.libraries)) if any(row.cells[place] for row in rows)]
        views.append(
            MapRows(
                name=name,
                definition=entry.definition if entry else "",
                bound=entry.bound if entry else None,
                libraries=tuple(found.libraries[place] for place in places),
                rows=tuple(Row(name, row.regime, tuple(row.cells[place] for place in places)) for row in rows),
                speed=speeds.get(name),
            )
        )
    return tuple(views)


def reproduce(cell: Cell) -> str:
    """The command that explains a cell's case."""
    return view.command(cell.worst.case["map"], cell.worst.case["inputs"], cell.spec)


def figures(cell: Cell) -> str:
    """Forward and scaled error, and the verdict's sign: "1.9 0.93 ●"."""
    return f"{view.error(cell.worst.forward)} {view.error(cell.worst.scaled)} {GLYPHS[Verdict(cell.worst.verdict)]}"


def sentence(cell: Cell) -> str:
    """What is to be said of a cell's case."""
    worst = cell.worst
    block = f" in {worst.block}" if worst.block else ""
    note = f" · {worst.note}" if worst.note else ""
    return (
        f"forward error {view.error(worst.forward)} u, scaled {view.error(worst.scaled)} u{block}, "
        f"condition {view.error(worst.condition)}, distance {view.figure(view.distance(worst))}{note}"
    )


def tally(library: Library) -> str:
    """What a library offers and how it did, in a few words."""
    found = view.counted(library.findings, "finding") if library.findings else "no finding"
    return f"{found} in {view.counted(library.cases, 'case')} of {view.counted(library.maps, 'map')}"


def record(found: Comparison) -> dict[str, Any]:
    """The comparison as JSON values; each cell with the command and the snippet that show its worst case."""
    told: dict[str, Any] = plain(asdict(found))
    for row, values in zip(found.rows, told["rows"], strict=True):
        values["cells"] = [
            {**value, "command": reproduce(cell)} if cell and value else None
            for cell, value in zip(row.cells, values["cells"], strict=True)
        ]
    return told


def as_json(found: Comparison) -> str:
    """The comparison as JSON, a line a row."""
    members = []
    for key, value in record(found).items():
        lines = ",\n  ".join(json.dumps(item, ensure_ascii=False, allow_nan=False) for item in value)
        members.append(f'"{key}": [\n  {lines}\n]' if value else f'"{key}": []')
    return "{\n" + ",\n".join(members) + "\n}"


def fenced(text: str, language: str = "") -> str:
    """A block of code in Markdown, whatever backticks it holds."""
    fence = "`" * max(3, 1 + max(map(len, re.findall("`+", text)), default=0))
    return f"{fence}{language}\n{text.rstrip()}\n{fence}"


def html(found: Comparison) -> str:
    """The comparison as an HTML document."""
    return _render(found, "compare.html", autoescape=True)


def markdown(found: Comparison) -> str:
    """The comparison as a Markdown document."""
    return _render(found, "compare.md", autoescape=False)


def _render(found: Comparison, document: str, *, autoescape: bool) -> str:
    templates = environment(autoescape=autoescape)
    templates.filters.update(
        plain=escape, code=code, figure=view.figure, error=view.error, figures=figures, sentence=sentence
    )
    templates.globals.update(
        anchor=anchor, fenced=fenced, glyphs=GLYPHS, meanings=view.MEANINGS, reproduce=reproduce, tally=tally, view=view
    )
    return templates.get_template(f"{document}.jinja").render(comparison=found, maps=maps(found))


def write(found: Comparison, folder: Path) -> tuple[Path, ...]:
    """Writes ``compare.md`` and ``compare.html`` into a folder; each whole or not at all. Raises StoredFileError."""
    from affinecert.reports import prepare, replace  # noqa: PLC0415  (the package imports what it renders with)

    prepare(folder)
    documents = {"compare.md": markdown, "compare.html": html}
    return tuple(replace(folder / name, render(found)) for name, render in documents.items())


def show(found: Comparison, console: Console) -> None:
    """Prints the comparison, in as many parts as the screen needs, and what is to be known of it."""
    console.print(Text("forward error, scaled error and verdict of the worst case; ns: nanoseconds an item", "dim"))
    views = maps(found)
    left = max((len(row.regime) + 2 for row in found.rows), default=0)
    left = min(max([left, *(len(each.name) for each in views)]), console.width // 3)
    for part in _parts(found.libraries, console.width - left):
        console.print()
        console.print(_table(views, part, left))
    for library in found.libraries:
        console.print(Text.assemble(f"{library.label}: ", (tally(library), "red" if library.findings else "green")))
    for note in found.notes:
        console.print(Text(note, style="dim"))
    told = dict.fromkeys(cell.worst.verdict for each in views for _, cell in each.cells)
    console.print(Text("  ".join(f"{GLYPHS[Verdict(name)]} {name}" for name in told), style="dim"))


CELL = 15
"""Characters of a cell: two errors and a sign."""


def _parts(libraries: Sequence[Library], room: int) -> Iterator[tuple[Library, ...]]:
    """The libraries in groups whose columns fit the room; at least one each."""
    part: list[Library] = []
    for library in libraries:
        if part and sum(map(_width, [*part, library])) > room:
            yield tuple(part)
            part = []
        part.append(library)
    if part:
        yield tuple(part)


def _width(library: Library) -> int:
    return max(CELL, *map(len, _heads(library))) + 2


def _heads(library: Library) -> tuple[str, ...]:
    return tuple(library.label.split(" ", 1))


def _table(views: Sequence[MapRows], part: Sequence[Library], left: int) -> Table:
    grid = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim", collapse_padding=True)
    grid.add_column("", width=left, overflow="fold")
    for library in part:
        grid.add_column(Text("\n".join(_heads(library))), justify="right", min_width=CELL, overflow="fold")
    labels = [library.label for library in part]
    for each in views:
        if not {library.label for library in each.libraries} & set(labels):
            continue
        grid.add_row(Text(each.name, style="bold"))
        for row in each.rows:
            own = {cell.library: cell for cell in row.cells if cell}
            if own.keys() & set(labels):
                grid.add_row(Text(f"  {row.regime}"), *(_cell(own.get(label)) for label in labels))
        points = [each.point(library) for library in part]
        if any(points):
            grid.add_row(
                Text("  ns", style="dim"), *(view.figure(point.nanoseconds if point else None) for point in points)
            )
    return grid


def _cell(cell: Cell | None) -> Text:
    if cell is None:
        return Text("–", style="dim")
    return Text(figures(cell), style=STYLES[cell.worst.verdict])
