"""The trail of a hunt: where each climb stands, in a JSON file that survives being killed."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from affinecert.case import from_record, to_record
from affinecert.climb import Arm, Candidate, Climber
from affinecert.errors import StoredFileError

FORMAT = 1
"""The version of the file's form."""


@dataclass(frozen=True)
class Trail:
    """One climb: what it depends on (a digest), how far it came, in how many seconds, and its arms."""

    run: str
    evaluations: int
    seconds: float
    arms: tuple[Arm, ...]


def load_trails(path: Path) -> dict[str, Trail]:
    """The trails in a file, by climb; none if there is no file."""
    if not path.exists():
        return {}
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        if record["format"] != FORMAT:
            raise ValueError(f"format {record['format']} where {FORMAT} is due")
        return {name: _trail(value, str(path)) for name, value in record["climbs"].items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError, StoredFileError) as error:
        raise StoredFileError(f"cannot read the hunt's trail {path}: {error}; delete it to start afresh") from error


def save_trails(path: Path, trails: Mapping[str, Trail]) -> None:
    """Writes the trails, all or nothing: a reader finds the old file or the new one."""
    record = {"format": FORMAT, "climbs": {name: _trail_record(trail) for name, trail in trails.items()}}
    beside = path.with_name(path.name + ".new")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        beside.write_text(json.dumps(record), encoding="utf-8")
        os.replace(beside, path)
    except OSError as error:
        raise StoredFileError(f"cannot write the hunt's trail {path}: {error}") from error


def _trail(record: Mapping[str, Any], where: str) -> Trail:
    arms = tuple(
        Arm(**{**arm, "incumbent": _climber(arm["incumbent"], where), "worst": _climber(arm["worst"], where)})
        for arm in record["arms"]
    )
    return Trail(record["run"], record["evaluations"], record["seconds"], arms)


def _climber(record: Mapping[str, Any] | None, where: str) -> Climber | None:
    if record is None:
        return None
    coordinates = None if record["coordinates"] is None else tuple(record["coordinates"])
    candidate = Candidate(from_record(record["case"], where), coordinates, record["used"])
    return Climber(candidate, float.fromhex(record["height"]), record["evaluation"])


def _trail_record(trail: Trail) -> dict[str, Any]:
    arms = [
        {**vars(arm), "incumbent": _climber_record(arm.incumbent), "worst": _climber_record(arm.worst)}
        for arm in trail.arms
    ]
    return {**vars(trail), "arms": arms}


def _climber_record(climber: Climber | None) -> dict[str, Any] | None:
    if climber is None:
        return None
    candidate = climber.candidate
    return {
        "case": to_record(candidate.case),
        "coordinates": candidate.coordinates,
        "used": candidate.used,
        # Hexadecimal, for an infinite height has no number in JSON.
        "height": climber.height.hex(),
        "evaluation": climber.evaluation,
    }
