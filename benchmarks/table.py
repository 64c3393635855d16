"""One Markdown table of a pytest-benchmark JSON file: time and worst error side by side.

``python -m affinecert.benchmarks.table FILE``.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from affinecert.errors import StoredFileError

HEAD = (
    "map",
    "items",
    "implementation",
    "ns per item",
    "times a copy",
    "worst forward error, u",
    "worst scaled error, u",
)


INSTRUMENT = frozenset({"truth", "verdict", "hunt"})
"""What is timed of the instrument itself."""


def read(path: Path) -> list[Mapping[str, Any]]:
    """The benchmarks in a file that ``pytest --benchmark-json=FILE`` wrote."""
    try:
        benchmarks: list[Mapping[str, Any]] = json.loads(path.read_text(encoding="utf-8"))["benchmarks"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise StoredFileError(f"cannot read the benchmarks {path}: {type(error).__name__}: {error}") from error
    return benchmarks


def nanoseconds(benchmark: Mapping[str, Any]) -> float:
    """The median time per item."""
    return float(benchmark["stats"]["median"]) / int(benchmark["extra_info"]["size"]) * 1e9


def error(info: Mapping[str, Any], name: str) -> str:
    """A worst error in a cell; empty where none was measured."""
    return f"{float(info[name]):.3g}" if name in info else ""


def table(benchmarks: list[Mapping[str, Any]]) -> str:
    """The maps, then the instrument itself: a line a benchmark, in order of map and size; a copy is the measure."""
    named = [one for one in benchmarks if {"map", "size", "implementation"} <= one["extra_info"].keys()]
    maps = [one for one in named if one["extra_info"]["implementation"] not in INSTRUMENT]
    instrument = [one for one in named if one["extra_info"]["implementation"] in INSTRUMENT]
    rule = ("---", "---:", "---", *("---:",) * 4)
    lines = [HEAD, rule, *_rows(maps), *_rows(instrument)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines) + "\n"


def _rows(benchmarks: list[Mapping[str, Any]]) -> Iterator[tuple[str, ...]]:
    copies = {
        (one["extra_info"]["map"], one["extra_info"]["size"]): nanoseconds(one)
        for one in benchmarks
        if one["extra_info"]["implementation"] == "copy"
    }
    order = sorted(benchmarks, key=lambda one: (one["extra_info"]["map"], one["extra_info"]["size"], nanoseconds(one)))
    for one in order:
        info, time = one["extra_info"], nanoseconds(one)
        copy = copies.get((info["map"], info["size"]))
        ratio = f"{time / copy:.3g}" if copy else ""
        cells = (info["map"], f"{info['size']:,}", info["implementation"], f"{time:.3g}", ratio)
        yield (*cells, error(info, "worst_forward"), error(info, "worst_scaled"))


def main(arguments: list[str]) -> int:
    """Prints the table of the file named in the arguments; 2 for bad use."""
    if len(arguments) != 1:
        print("usage: python -m affinecert.benchmarks.table FILE", file=sys.stderr)
        return 2
    try:
        print(table(read(Path(arguments[0]))), end="")
    except StoredFileError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
