"""From a certificate to what people read: a table in the terminal, Markdown, and a self-contained HTML page."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from affinecert.certificate import Certificate, dump
from affinecert.errors import StoredFileError
from affinecert.ratchet import Ratchet


@contextmanager
def _told(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise StoredFileError(f"cannot write {path}: {error.strerror or error}") from error


def prepare(folder: Path) -> None:
    """Makes the folder, and makes sure that files can be written there.

    Raises StoredFileError if not, before the hours of work whose result would have nowhere to go.
    """
    with _told(folder):
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=folder, prefix=".affinecert-"):
            pass


def write(certificate: Certificate, folder: Path, ratchet: Ratchet | None = None) -> tuple[Path, ...]:
    """Writes ``certificate.json``, ``.md`` and ``.html`` into the folder; each appears whole or not at all.

    What changed against a baseline is told in the latter two; the record is of this run alone.
    Raises StoredFileError, naming the file, where the folder cannot be written or the disk is full.
    """
    prepare(folder)
    # The record first: whatever happens to what is rendered from it, nothing computed is lost.
    record = replace(folder / "certificate.json", to_json(certificate))
    from affinecert.reports.html import html  # noqa: PLC0415  (matplotlib is slow to import)
    from affinecert.reports.markdown import markdown  # noqa: PLC0415

    rendered = {"md": markdown, "html": html}
    return record, *(
        replace(folder / f"certificate.{suffix}", render(certificate, ratchet)) for suffix, render in rendered.items()
    )


def to_json(certificate: Certificate) -> str:
    """The certificate's JSON, one line a regime, law and timing, so that a diff shows which of them changed."""
    return "{\n" + ",\n".join(f'"{key}": {_member(value)}' for key, value in dump(certificate).items()) + "\n}\n"


def _member(value: Any) -> str:
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return "[\n  " + ",\n  ".join(map(_line, value)) + "\n]"
    return _line(value)


def _line(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def replace(path: Path, text: str) -> Path:
    """Writes beside the file and then takes its place."""
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    with _told(path):
        try:
            # A subject's complaint may hold what UTF-8 cannot: it is escaped as JSON would escape it.
            beside.write_text(text, encoding="utf-8", errors="backslashreplace", newline="\n")
            beside.replace(path)
        except BaseException:
            beside.unlink(missing_ok=True)
            raise
    return path
