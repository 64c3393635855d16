"""What an adopter expects of tests: files, kept in the adopter's repository, of tests to skip or known to fail.

A line is the id of a test (``so3.log[near-pi]``) or a pattern of ids, in which ``*`` stands for any characters and
``?`` for one; brackets stand for themselves. What follows a ``#`` is the reason, and a comment where it stands alone.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Set
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

from affinecert.errors import StoredFileError

SHOWN = 60
"""Characters of a line that is no id which an error tells."""

FORM = re.compile(r"[^\s\[\]]+(\[[^\s\[\]]+\])?")
"""The form of an id, or of a pattern: no blanks, and what stands in brackets comes last."""

SEPARATOR = "::"
"""Stands between a subject and the id of its test, where there are several subjects."""


@dataclass(frozen=True)
class Expectation:
    """One line of such a file; ``place`` is the file and the line's number."""

    pattern: str
    reason: str
    place: str

    def matches(self, name: str) -> bool:
        """Whether the line speaks of the test of that id, with its subject or without."""
        pattern = self.pattern.replace("[", "[[]")
        return fnmatchcase(name, pattern) or fnmatchcase(name.rpartition(SEPARATOR)[2], pattern)


def parse(text: str, name: str) -> tuple[Expectation, ...]:
    """The expectations in a file's text; ``name`` is the file's. Raises StoredFileError for a line that is no id."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        pattern, _, comment = (part.strip() for part in line.partition("#"))
        if not pattern:
            continue
        if not FORM.fullmatch(pattern):
            due = "one a line is due, such as so3.log[near-pi] or se3.*"
            raise StoredFileError(f"{name}:{number}: {pattern[:SHOWN]!r} is no id of a test: {due}")
        found.append(Expectation(pattern, comment, f"{name}:{number}"))
    return tuple(found)


def read(path: Path) -> tuple[Expectation, ...]:
    """The expectations in a file. Raises StoredFileError."""
    try:
        return parse(path.read_text(encoding="utf-8-sig"), str(path))
    except (OSError, UnicodeDecodeError) as error:
        raise StoredFileError(f"cannot read the list of tests {path}: {error}") from error


def first(expectations: Iterable[Expectation], name: str) -> Expectation | None:
    """The first of the expectations that speaks of a test."""
    return next((each for each in expectations if each.matches(name)), None)


@dataclass(frozen=True)
class Expectations:
    """The tests to skip, and those known to fail."""

    skips: tuple[Expectation, ...] = ()
    xfails: tuple[Expectation, ...] = ()

    def stale(self, names: Iterable[str], passed: Set[str]) -> tuple[tuple[Expectation, str], ...]:
        """The expectations that have outlived their tests, and why.

        Of ``names``, all the tests there are, those in ``passed`` were expected to fail and did not. A pattern is
        stale only if all of its tests pass: one of them that fails, or was left out of the run, keeps it.
        """
        names = tuple(names)
        run = [name for name in names if not first(self.skips, name)]
        lost = {each: _lost(each, names) for each in self.skips}
        lost |= {each: _lost(each, names) or _outlived(each, run, passed) for each in self.xfails}
        return tuple((each, why) for each, why in lost.items() if why)


def _lost(expectation: Expectation, names: Iterable[str]) -> str:
    return "" if any(map(expectation.matches, names)) else "matches no test"


def _outlived(expectation: Expectation, run: Iterable[str], passed: Set[str]) -> str:
    matched = list(filter(expectation.matches, run))
    if not matched or not set(matched) <= passed:
        return ""
    return "passes" if len(matched) == 1 else f"all {len(matched)} pass"
