"""The pytest options of ``pytest --pyargs affinecert.properties``; loaded in every pytest run, so next to nothing.

They stand apart from the tests' conftest, as pytest reads that of a package too late for an option.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from affinecert.errors import StoredFileError
from affinecert.properties.expectations import Expectations, read

FILE = "subject_tests.py"
"""The module that collects the tests of a subject: what their ids start with."""

EXPECTATIONS = pytest.StashKey[Expectations]()
"""Where the expectations of a run are kept."""


def pytest_addoption(parser: pytest.Parser) -> None:
    """Adds the options."""
    group = parser.getgroup("affinecert", "affinecert, with --pyargs affinecert.properties")
    group.addoption(
        "--affinecert-subject",
        action="append",
        metavar="SUBJECT",
        help="what is certified, one test a map and regime, and a law: a subject's name or module:attribute; "
        "may be given repeatedly",
    )
    group.addoption(
        "--affinecert-profile",
        choices=("quick", "standard", "thorough"),
        default="standard",
        help="how much is tried, as of affinecert certify; default: standard",
    )
    for option, purpose in (("xfails", "that are known to fail"), ("skips", "to skip")):
        group.addoption(
            f"--affinecert-{option}",
            type=Path,
            metavar="FILE",
            help=f"tests {purpose}: an id or a pattern a line, # and the reason after it",
        )
    group.addoption(
        "--affinecert-strict",
        action="store_true",
        help="fail if a line of these files is stale: its tests pass by now, or are no more",
    )


def pytest_configure(config: pytest.Config) -> None:
    """Reads the expectations, and has what becomes of them reported. Raises UsageError."""
    files = {name: config.getoption(f"--affinecert-{name}") for name in ("skips", "xfails")}
    config.stash[EXPECTATIONS] = Expectations()
    for name, file in files.items():
        if file and not config.getoption("--affinecert-subject"):
            raise pytest.UsageError(f"--affinecert-{name} needs an --affinecert-subject")
    if not any(files.values()):
        return
    try:
        config.stash[EXPECTATIONS] = Expectations(**{name: read(file) for name, file in files.items() if file})
    except StoredFileError as error:
        raise pytest.UsageError(str(error)) from error
    if not hasattr(config, "workerinput"):  # pytest-xdist: its workers report to the one that tells
        from affinecert.properties.staleness import Staleness  # noqa: PLC0415

        config.pluginmanager.register(Staleness(config), "affinecert-staleness")
