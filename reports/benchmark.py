"""A comparison of two versions in a terminal: time and worst error in one table."""

from __future__ import annotations

from rich.console import Console
from rich.text import Text

from affinecert.benchmarks.against import Comparison
from affinecert.reports.terminal import table
from affinecert.reports.view import error, figure

STYLES = {"slower": "red", "less accurate": "red", "faster": "green"}


def show(comparison: Comparison, console: Console) -> None:
    """Prints the comparison: nanoseconds an item, worst scaled errors in u, and what is to be said of them."""
    console.print(Text(f"base: {comparison.base}\nhead: {comparison.head}", style="dim"))
    if comparison.note:
        console.print(Text(comparison.note))
    numbers = ("items", "base ns", "head ns", "ratio", "chance", "base u", "head u")
    grid = table("map", *numbers, "verdict", numbers=numbers)
    for row in comparison.rows:
        sides = (row.base, row.head)
        verdicts = row.verdict.split(", ")
        grid.add_row(
            Text(row.map),
            f"{row.size:,}",
            *(figure(side.nanoseconds if side else None) for side in sides),
            figure(row.ratio),
            figure(row.chance),
            *(error(side.scaled if side else None) for side in sides),
            Text(row.verdict, style=STYLES.get(verdicts[-1], STYLES.get(verdicts[0], ""))),
        )
    console.print(grid)
    console.print(
        Text("nanoseconds an item; worst scaled errors in u; chance: of ranks so uneven if nothing changed", "dim")
    )
