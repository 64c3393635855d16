"""Progress on stderr: a bar with the time that is left; where there is no terminal, a line now and then."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from time import monotonic
from typing import Protocol

from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn, TimeRemainingColumn

PATIENCE = 10.0
"""Seconds between two lines where there is no bar."""


class Update(Protocol):
    """Tells how much is done, as a fraction (None if nobody knows how much there is), and what is being done."""

    def __call__(self, fraction: float | None, doing: str) -> None:
        """One step."""


@contextmanager
def shown(console: Console) -> Iterator[Update]:
    """An `Update` whose calls are seen until the context is left."""
    if not console.is_terminal or console.is_dumb_terminal:
        yield _lines(console)
        return
    columns = (
        BarColumn(bar_width=24),
        TaskProgressColumn(),
        TimeElapsedColumn(),
        TextColumn("left", style="dim"),
        TimeRemainingColumn(),
        TextColumn("{task.description}", markup=False, style="dim"),
    )
    with Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task("starting", total=None)

        def update(fraction: float | None, doing: str) -> None:
            if fraction is None:
                progress.update(task, description=doing)
            else:
                progress.update(task, total=1.0, completed=fraction, description=doing)

        yield update


def _lines(console: Console) -> Update:
    started = told = monotonic()

    def update(fraction: float | None, doing: str) -> None:
        nonlocal told
        now = monotonic()
        if now - told >= PATIENCE:
            told = now
            share = "" if fraction is None else f"{fraction:.0%}, "
            console.print(f"{share}{now - started:.0f} s: {doing}", markup=False, highlight=False)

    return update
