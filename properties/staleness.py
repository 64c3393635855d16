"""Reporting the lines of an adopter's files that are stale, as a plugin of the run that has such files."""

from __future__ import annotations

from functools import cached_property

import pytest

from affinecert.properties.expectations import Expectation
from affinecert.properties.plugin import EXPECTATIONS, FILE


class Staleness:
    """Remembers the tests that were run, and which passed against expectation; tells at the end what is stale."""

    def __init__(self, config: pytest.Config) -> None:
        self.config = config
        self.ran = False
        self.passed: set[str] = set()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """See pytest."""
        _, file, name = report.nodeid.partition(f"{FILE}::")
        if file:
            self.ran = True
            if report.when == "call" and report.passed and hasattr(report, "wasxfail"):
                self.passed.add(name)

    @cached_property
    def stale(self) -> tuple[tuple[Expectation, str], ...]:
        """What is stale; nothing if the run was of other tests."""
        if not self.ran:
            return ()
        from affinecert.properties.subject_tests import names  # noqa: PLC0415  (other runs do not need the catalogue)

        return self.config.stash[EXPECTATIONS].stale(names(self.config), self.passed)

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        """Has the run fail, if it is to be strict."""
        if self.config.getoption("--affinecert-strict") and session.exitstatus == pytest.ExitCode.OK and self.stale:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        """Tells what is stale."""
        if self.stale:
            terminalreporter.section("affinecert: stale expectations")
        for expectation, why in self.stale:
            terminalreporter.line(f"{expectation.place}: {expectation.pattern}: {why}")
