"""What ``pytest --pyargs affinecert.properties`` collects.

With ``--affinecert-subject my.module:subject``, the tests of that subject: see `subject_tests`. Without, these modules,
which try the laws on `reference` and on `fast`, or on what the environment variable AFFINECERT_SUBJECT names.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from affinecert.properties.answers import Maps, exactly, singly
from affinecert.properties.check import check
from affinecert.properties.law import Law
from affinecert.properties.plugin import FILE
from affinecert.subject import load

EXAMPLES = 30
"""Inputs a law, enough to meet most regimes of a map, few enough for all laws on two subjects in 100 s."""


def _given(config: pytest.Config) -> bool:
    return bool(config.getoption("--affinecert-subject", default=None))


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leaves the modules out where a subject is given."""
    return True if collection_path.name.startswith("test_") and _given(config) else None


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Collects the tests of the subject that is given, whatever the names of the adopter's test modules."""
    if file_path.name != FILE or not _given(parent.config):
        return None
    from affinecert.properties.subject_tests import SubjectTests  # noqa: PLC0415

    return SubjectTests.from_parent(parent, path=file_path)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Runs each test that asks for ``maps`` on each subject."""
    if "maps" in metafunc.fixturenames:
        subjects = os.environ.get("AFFINECERT_SUBJECT", "reference fast").split()
        metafunc.parametrize("maps", subjects, indirect=True)


class _Offered(dict[str, Callable[..., Any]]):
    """The maps of a subject; a test that needs another one is skipped."""

    def __missing__(self, name: str) -> Callable[..., Any]:
        pytest.skip(f"without {name}")


@cache
def _maps(subject: str) -> Maps:
    # The truths serve as the reference's answers too: they are computed once, for all subjects.
    return _Offered(exactly() if subject == "reference" else singly(load(subject)))


@pytest.fixture
def maps(request: pytest.FixtureRequest) -> Maps:
    """The maps of the subject, taking single items."""
    return _maps(request.param)


@pytest.fixture
def keeps(maps: Maps) -> Callable[[Law], None]:
    """Fails unless the subject keeps a law; skips where it lacks one of the maps."""

    def keep(law: Law) -> None:
        result = check(law, maps, EXAMPLES)
        if result.verdict == "absent":
            pytest.skip(result.note)
        assert result.passed, f"{law.statement}: residual {result.worst:.3g}, {result.note}, at {result.inputs}"

    return keep
