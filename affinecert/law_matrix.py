"""The law matrix of a subject: every morph by every law, a row at a time on an executor."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Future
from fnmatch import fnmatchcase
from typing import Any

from pebble import ProcessExpired

from affinecert.certificate import MorphLawRecord
from affinecert.errors import UnknownNameError
from affinecert.executor import executor
from affinecert.judging import morph_laws, resolve
from affinecert.properties.matrix.laws import LAWS, MorphLaw
from affinecert.properties.matrix.morphs import MORPHS, Morph
from affinecert.subject import Subject


def morphs(glob: str) -> tuple[Morph, ...]:
    """The morphs whose names match a shell pattern. Raises UnknownNameError where none does."""
    found = tuple(morph for morph in MORPHS if fnmatchcase(morph.name, glob))
    if not found:
        raise UnknownNameError("morph", glob, (morph.name for morph in MORPHS))
    return found


def laws(glob: str) -> tuple[MorphLaw, ...]:
    """The laws whose names match a shell pattern. Raises UnknownNameError where none does."""
    found = tuple(law for law in LAWS if fnmatchcase(law.name, glob))
    if not found:
        raise UnknownNameError("law of morphs", glob, (law.name for law in LAWS))
    return found


def lost(morph: Morph, chosen: Sequence[MorphLaw], complaint: str) -> tuple[MorphLawRecord, ...]:
    """The row of a morph whose trial came to nothing."""
    return tuple(MorphLawRecord(morph.name, law.name, "unclear", morph.takes, note=complaint) for law in chosen)


def law_matrix(
    subject: str | Subject = "fast", *, morph: str = "*", law: str = "*", jobs: int = 1, limit: float = 200.0
) -> tuple[MorphLawRecord, ...]:
    """The cells of the morphs and laws that match, row by row; ``limit`` is the time of a row in seconds.

    With more than one job the rows are tried in that many processes. Raises UnknownNameError or SubjectError.
    """
    rows, columns = morphs(morph), laws(law)
    resolve(subject)
    names = [each.name for each in columns]
    with executor(jobs) as submit:
        futures = [submit(morph_laws, subject, row.name, names, timeout=limit) for row in rows]
        return tuple(
            cell for row, future in zip(rows, futures, strict=True) for cell in _cells(row, columns, future, limit)
        )


def _cells(row: Morph, columns: Sequence[MorphLaw], future: Future[Any], limit: float) -> tuple[MorphLawRecord, ...]:
    try:
        return tuple(future.result())
    except TimeoutError:
        return lost(row, columns, f"no answer within {limit:g} s")
    except ProcessExpired as error:
        return lost(row, columns, f"the process died: {error}")
