"""The corpus: stored cases, one JSON line each, one file a family; reviewable in a diff."""

from __future__ import annotations

import json
from collections.abc import Iterable
from importlib.resources import files
from pathlib import Path

from affinecert.case import Case, dump_line, from_record
from affinecert.errors import StoredFileError


def parse(text: str, name: str) -> tuple[Case, ...]:
    """The cases of a corpus file's text; ``name`` is the file's, for errors. Lines that start with # are comments."""
    cases = []
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        where = f"{name}:{number}"
        try:
            record = json.loads(line)
        except json.JSONDecodeError as error:
            raise StoredFileError(f"{where}: not JSON: {error}") from error
        cases.append(from_record(record, where))
    return tuple(cases)


def read(path: Path) -> tuple[Case, ...]:
    """The cases of one corpus file."""
    try:
        return parse(path.read_text(encoding="utf-8"), str(path))
    except (OSError, UnicodeDecodeError) as error:
        raise StoredFileError(f"cannot read the corpus file {path}: {error}") from error


def append(path: Path, cases: Iterable[Case]) -> None:
    """Adds cases to a corpus file, leaving out those it holds already."""
    held = {case.key for case in read(path)} if path.exists() else set()
    fresh = [case for case in cases if case.key not in held]
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a", encoding="utf-8") as stream:
            stream.writelines(dump_line(case) + "\n" for case in fresh)
    except OSError as error:
        raise StoredFileError(f"cannot write the corpus file {path}: {error}") from error


def shipped() -> tuple[Case, ...]:
    """Every case that ships with affinecert."""
    folder = files(__name__)
    names = sorted(entry.name for entry in folder.iterdir() if entry.name.endswith(".jsonl"))
    return tuple(case for name in names for case in parse((folder / name).read_text(encoding="utf-8"), name))
