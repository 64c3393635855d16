"""The store: truths already computed, and the verdicts of a run that was interrupted, in one SQLite file.

A truth is keyed by map, input bits and the version of what made it, so that a second subject on the same maps costs
no truth at all. Every batch is committed as it comes: Ctrl-C, or a full disk, loses nothing that was finished.
"""

from __future__ import annotations

import hashlib
import json
import os
import sqlite3
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from importlib.resources import files
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import platformdirs

import affinecert.reference
from affinecert import truths
from affinecert.case import from_hex, to_hex
from affinecert.errors import StoredFileError
from affinecert.map import Map
from affinecert.truths import Truth

SCHEMA = """
create table if not exists truths (key text, version text, value text, primary key (key, version)) without rowid;
create table if not exists verdicts (run text, key text, value text, primary key (run, key)) without rowid;
"""


def default_path() -> Path:
    """``store.sqlite`` in the folder AFFINECERT_CACHE, or else in the user's cache folder."""
    folder = os.environ.get("AFFINECERT_CACHE") or platformdirs.user_cache_dir("affinecert", appauthor=False)
    return Path(folder) / "store.sqlite"


@cache
def _sources() -> bytes:
    digest = hashlib.sha256(Path(truths.__file__).read_bytes())
    for source in sorted(files(affinecert.reference).iterdir(), key=lambda entry: entry.name):
        if source.name.endswith(".py"):
            digest.update(source.read_bytes())
    return digest.digest()


def reference_version(entry: Map) -> str:
    """A digest of all that a map's truth depends on: the reference's source, and how the map is perturbed and cut."""
    digest = hashlib.sha256(_sources())
    digest.update(repr((entry.arguments, entry.blocks)).encode())
    return digest.hexdigest()[:16]


def dump_truth(truth: Truth) -> str:
    """A truth as one JSON text."""
    return json.dumps(
        {
            "high": [to_hex(array) for array in truth.high],
            "low": [to_hex(array) for array in truth.low],
            "sensitivity": [value.hex() for value in truth.sensitivity],
            "refusal": truth.refusal,
        }
    )


def load_truth(text: str) -> Truth:
    """The inverse of `dump_truth`."""
    record: Mapping[str, Any] = json.loads(text)
    return Truth(
        high=tuple(from_hex(value) for value in record["high"]),
        low=tuple(from_hex(value) for value in record["low"]),
        sensitivity=tuple(float.fromhex(value) for value in record["sensitivity"]),
        refusal=record["refusal"],
    )


class Store:
    """The store's file, open; a context manager."""

    def __init__(self, path: Path | None = None) -> None:
        self.path = path or default_path()
        with self._told():
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self._connection = sqlite3.connect(self.path, timeout=60)
            try:
                self._connection.executescript(SCHEMA)
            except sqlite3.Error:
                self._connection.close()
                raise

    @contextmanager
    def _told(self) -> Iterator[None]:
        try:
            yield
        except (sqlite3.Error, OSError) as error:
            remedy = "delete it to start afresh, or set AFFINECERT_CACHE to another folder"
            raise StoredFileError(f"the store {self.path} cannot be used: {error}; {remedy}") from error
        except (KeyError, TypeError, ValueError) as error:
            remedy = "delete it to start afresh"
            raise StoredFileError(
                f"the store {self.path} holds a record that cannot be read: {error}; {remedy}"
            ) from error

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._connection.close()

    def truths(self, version: str, keys: Iterable[str]) -> dict[str, Truth]:
        """The truths held for those keys."""
        with self._told():
            query = "select value from truths where key = ? and version = ?"
            rows = ((key, self._connection.execute(query, (key, version)).fetchone()) for key in keys)
            return {key: load_truth(row[0]) for key, row in rows if row is not None}

    def keep_truths(self, version: str, truths: Mapping[str, Truth]) -> None:
        """Adds truths, and commits."""
        rows = [(key, version, dump_truth(truth)) for key, truth in truths.items()]
        with self._told(), self._connection:
            self._connection.executemany("insert or replace into truths values (?, ?, ?)", rows)

    def verdicts(self, run: str) -> dict[str, Any]:
        """The records of an interrupted run, by case key."""
        with self._told():
            rows = self._connection.execute("select key, value from verdicts where run = ?", (run,))
            return {key: json.loads(value) for key, value in rows}

    def keep_verdicts(self, run: str, records: Mapping[str, Any]) -> None:
        """Adds the records of finished cases, and commits."""
        rows = [(run, key, json.dumps(record)) for key, record in records.items()]
        with self._told(), self._connection:
            self._connection.executemany("insert or replace into verdicts values (?, ?, ?)", rows)

    def forget(self, run: str) -> None:
        """Drops the records of a run that has come to its end."""
        with self._told(), self._connection:
            self._connection.execute("delete from verdicts where run = ?", (run,))
