"""Baselines: measured numbers in a file, with the machine they belong to."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from affinecert.benchmarks.measuring import Measured
from affinecert.certificate import Machine, plain
from affinecert.errors import StoredFileError

FORMAT = 1
"""The version of a baseline file's form."""


def read_baseline(path: Path) -> tuple[Machine, list[Measured]]:
    """The machine and the numbers of a baseline file."""
    try:
        record: Mapping[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        if record["format"] != FORMAT:
            raise ValueError(f"format {record['format']} where {FORMAT} is due")
        numbers = [
            Measured(m["map"], m["size"], tuple(m["seconds"]), float(m["forward"]), float(m["scaled"]), m["yardstick"])
            for m in record["measured"]
        ]
        return Machine(**record["machine"]), numbers
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise StoredFileError(f"cannot read the baseline {path}: {type(error).__name__}: {error}") from error


def write_baseline(path: Path, where: Machine, measured: Sequence[Measured]) -> None:
    """Writes a baseline file."""
    record = {"format": FORMAT, "machine": asdict(where), "measured": [plain(asdict(one)) for one in measured]}
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    except OSError as error:
        raise StoredFileError(f"cannot write the baseline {path}: {error}") from error
