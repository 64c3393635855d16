"""A version of `fast` against another: a revision, or the numbers that were stored on this machine before.

Base and head run side by side, in two processes that take turns (base, head, head, base), so that whatever slows the
machine down slows both. A map is slower only if the medians say so and a rank test does too.
"""

from __future__ import annotations

import statistics
import tempfile
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from affinecert import catalogue
from affinecert.benchmarks.baseline import read_baseline, write_baseline
from affinecert.benchmarks.builds import commit, export, lay_out, running, top
from affinecert.benchmarks.measuring import TURNS, Measured, Progress, measure
from affinecert.certificate import Machine, machine
from affinecert.errors import AffinecertError

SIZES = (1, 10_000)
"""Items a batch: the overhead of a call, and the cost of an item."""

RATIO = 1.1
"""The medians' ratio from which a difference counts: smaller ones come and go with the layout of the code."""

CHANCE = 0.01
"""The probability of the ranks, if nothing had changed, below which a difference counts."""

GROWTH = 2.0
"""The worst scaled error may not grow by more than this factor: one bit."""


@dataclass(frozen=True)
class Row:
    """Base and head on one map and batch size; None where one has not got the map. ``chance`` is that of the ranks."""

    map: str
    size: int
    base: Measured | None
    head: Measured | None
    ratio: float | None
    chance: float | None
    verdict: str


@dataclass(frozen=True)
class Comparison:
    """What was compared with what; ``recorded`` if there was no baseline, and this is it now."""

    base: str
    head: str
    machine: Machine
    recorded: bool
    note: str
    rows: tuple[Row, ...]

    @property
    def passed(self) -> bool:
        """Whether no map is slower or less accurate than before."""
        return not any({"slower", "less accurate"} & set(row.verdict.split(", ")) for row in self.rows)


def _silent(done: int, total: int, doing: str) -> None:
    """No progress is shown unless somebody asks for it."""


def compare(
    against: str,
    maps: str = "*",
    *,
    sizes: Sequence[int] = SIZES,
    turns: int = TURNS,
    folder: Path | None = None,
    progress: Progress = _silent,
) -> Comparison:
    """The comparison of `fast` as it is here with a revision, or with the numbers in a baseline file, ``*.json``.

    A revision is looked for in the checkout that holds ``folder`` (or the working folder), and so is the head to
    compare it with, changes that are not committed included. A baseline is compared with the affinecert that is
    installed; if the file does not exist, it is written. Raises BuildError, UnknownNameError or StoredFileError.
    """
    entries = catalogue.matching(maps)
    path = Path(against)
    recorded = path.is_file()
    if recorded or path.suffix == ".json":
        before = read_baseline(path) if recorded else None
        if before is not None and before[0] != machine():
            return _elsewhere(against, *before)
        with (
            tempfile.TemporaryDirectory(prefix="affinecert-bench-") as name,
            running({"head": None}, Path(name)) as built,
        ):
            pairs = list(measure(built, entries, sizes, turns, scratch=Path(name), progress=progress))
        heads = [head for (head,) in pairs if head is not None]
        return _recorded(path, heads) if before is None else _with_baseline(against, before[1], heads)
    root = top(folder or Path.cwd())
    revision = commit(root, against)
    with tempfile.TemporaryDirectory(prefix="affinecert-bench-") as name:
        scratch = Path(name)
        trees = {
            "base": lay_out(export(root, revision, scratch / "tree"), scratch / "base"),
            "head": lay_out(root, scratch / "head"),
        }
        with running(trees, scratch) as built:
            rows = [
                judge(base, head)
                for base, head in measure(built, entries, sizes, turns, scratch=scratch, progress=progress)
                if base is not None or head is not None
            ]
    return Comparison(f"{against} ({revision[:12]})", "working tree", machine(), False, "", tuple(rows))


def _recorded(path: Path, heads: Sequence[Measured]) -> Comparison:
    """There was no baseline: the numbers become it."""
    write_baseline(path, machine(), heads)
    rows = tuple(Row(head.map, head.size, None, head, None, None, "recorded") for head in heads)
    return Comparison(str(path), "installed", machine(), True, f"no baseline yet: recorded in {path}", rows)


def _with_baseline(against: str, before: Sequence[Measured], heads: Sequence[Measured]) -> Comparison:
    """The numbers of two runs, which took no turns: a yardstick tells how fast the machine was in each."""
    bases = {(base.map, base.size): base for base in before}
    rows = tuple(judge(base := bases.get((head.map, head.size)), as_fast_as(base, head)) for head in heads)
    note = "head's times are scaled by a yardstick to how fast the machine was when the baseline was recorded"
    return Comparison(against, "installed", machine(), False, note, rows)


def as_fast_as(base: Measured | None, head: Measured) -> Measured:
    """The head's numbers as if the machine had been as fast as for the base's, by what the yardstick took in each."""
    scale = base.yardstick / head.yardstick if base is not None else 1.0
    return replace(head, seconds=tuple(seconds * scale for seconds in head.seconds))


def _elsewhere(against: str, where: Machine, before: Sequence[Measured]) -> Comparison:
    """The baseline is another machine's: its numbers are told, and not compared."""
    note = f"the numbers of another machine are not compared: {_difference(where, machine())}"
    rows = tuple(Row(base.map, base.size, base, None, None, None, "other machine") for base in before)
    return Comparison(against, "installed", machine(), False, note, rows)


def _difference(before: Machine, now: Machine) -> str:
    old, new = asdict(before), asdict(now)
    return "; ".join(f"{name} {old[name]}, now {new[name]}" for name in new if old[name] != new[name])


def judge(base: Measured | None, head: Measured | None) -> Row:
    """The row of a map and size: slower or faster only if both the ratio of the medians and the ranks say so."""
    known = head or base
    assert known is not None
    if base is None or head is None:
        return Row(known.map, known.size, base, head, None, None, "new" if base is None else "gone")
    ratio = statistics.median(head.seconds) / statistics.median(base.seconds)
    chance = rank_chance(base.seconds, head.seconds)
    verdict = "same"
    if chance < CHANCE and ratio > RATIO:
        verdict = "slower"
    if chance < CHANCE and ratio < 1 / RATIO:
        verdict = "faster"
    if head.scaled > GROWTH * max(base.scaled, 1.0):
        verdict += ", less accurate"
    return Row(head.map, head.size, base, head, ratio, chance, verdict)


def rank_chance(first: Sequence[float], second: Sequence[float]) -> float:
    """The p-value of the two-sided Mann-Whitney test: how likely ranks so uneven are if nothing changed."""
    try:
        from scipy.stats import mannwhitneyu  # noqa: PLC0415 -- SciPy is an extra, and wanted here only
    except ImportError as error:
        raise AffinecertError("comparing timings needs scipy: pip install 'affinecert[bench]'") from error

    return float(mannwhitneyu(first, second, alternative="two-sided").pvalue)


def render(comparison: Comparison) -> str:
    """The comparison as a Markdown table."""
    head = ("map", "items", "base, ns", "head, ns", "ratio", "chance", "base error, u", "head error, u", "verdict")
    lines: list[tuple[str, ...]] = [head, ("---", *("---:",) * 7, "---")]
    for row in comparison.rows:
        times = [f"{one.nanoseconds:.3g}" if one else "" for one in (row.base, row.head)]
        errors = [f"{one.scaled:.3g}" if one else "" for one in (row.base, row.head)]
        odds = [f"{value:.3g}" if value is not None else "" for value in (row.ratio, row.chance)]
        lines.append((row.map, f"{row.size:,}", *times, *odds, *errors, row.verdict))
    table = "\n".join(f"| {' | '.join(line)} |" for line in lines)
    told = f"base: {comparison.base}; head: {comparison.head}; times per item, worst scaled errors"
    return "\n".join(filter(None, (told, comparison.note, "", table))) + "\n"
