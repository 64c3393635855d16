"""The tests of somebody's subject: one a map and regime (``so3.log[near-pi]``), and one a law (``law[isometry.sam]``).

They are collected here where the option ``--affinecert-subject`` is given. A test judges what `certify` does, and fails
where that has findings. Maps that the subject lacks, and laws that speak of one, have no tests.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator

import pytest

from affinecert.catalogue import CATALOGUE
from affinecert.certificate import LawRecord, RegimeResult
from affinecert.errors import AffinecertError, SubjectError
from affinecert.judging import obey, resolve
from affinecert.properties.expectations import SEPARATOR, first
from affinecert.properties.laws import LAWS
from affinecert.properties.plugin import EXPECTATIONS
from affinecert.reports import view
from affinecert.single_regime import certify_regime, regimes
from affinecert.tier import PROFILES


class SubjectTest(pytest.Item):
    """A test of a subject, and what it is about: a map and one of its regimes, or a law."""

    def __init__(self, *, subject: str, about: tuple[str, ...], **rest: object) -> None:
        super().__init__(**rest)  # type: ignore[arg-type]
        self.subject, self.about = subject, about

    def runtest(self) -> None:
        """Fails with the findings, as text."""
        try:
            failure = self.failure()
        except AffinecertError as error:
            failure = str(error)
        if failure:
            pytest.fail(failure, pytrace=False)

    @abstractmethod
    def failure(self) -> str:
        """What is wrong; nothing if the test passes."""

    def reportinfo(self) -> tuple[str, int, str]:
        """See pytest; the line has to be a number."""
        return str(self.path), 0, self.name


class RegimeTest(SubjectTest):
    """A map in one of its regimes."""

    def failure(self) -> str:
        """See `of_regime`."""
        map_name, regime = self.about
        row = certify_regime(self.subject, map_name, regime, self.config.getoption("--affinecert-profile"))
        if row is None:
            pytest.skip("no case of it in the subject's numbers")
        return "" if row.passed else of_regime(row, self.subject)


class LawTest(SubjectTest):
    """A law."""

    def failure(self) -> str:
        """See `of_law`."""
        profile = PROFILES[self.config.getoption("--affinecert-profile")]
        (law,) = self.about
        record = obey(self.subject, law, profile.examples)
        return "" if record.verdict != "failed" else of_law(record)


def of_regime(row: RegimeResult, subject: str) -> str:
    """The failure of a map in a regime: the verdicts, and the worst input in the command that explains it."""
    worst = row.findings[0]
    return "\n".join(
        [
            view.tally(row.verdicts),
            f"the worst is {worst.verdict}: {worst.note}",
            f"scaled error {view.error(worst.scaled)} u, forward {view.error(worst.forward)} u, "
            f"condition {view.error(worst.condition)}, {row.distance} {view.figure(view.distance(worst))}",
            view.command(row.map, worst.case["inputs"], subject),
        ]
    )


def of_law(record: LawRecord) -> str:
    """The failure of a law: what is wrong, the law, and the input that breaks it."""
    return "\n".join(
        [
            record.note,
            f"{record.statement}: {record.source}; {record.domain}",
            f"up to a residual of {record.bound:g}, but not at {view.decimal(record.inputs)}",
        ]
    )


def tests(subject: str) -> Iterator[tuple[str, type[SubjectTest], tuple[str, ...]]]:
    """The tests of a subject: the id, the kind, and what it is about. Raises UnknownNameError or SubjectError."""
    loaded = resolve(subject)
    offered = [name for name in CATALOGUE if name in loaded.maps]
    if not offered:
        raise SubjectError(f"{subject} offers no map of the catalogue")
    for name in offered:
        for regime in regimes(name):
            yield f"{name}[{regime}]", RegimeTest, (name, regime)
    if loaded.dtype != "float64":
        return  # what a law allows an answer to err by is told in float64's unit
    for law in LAWS:
        if set(law.needs) <= set(offered):
            yield f"law[{law.name}]", LawTest, (law.name,)


def subjects(config: pytest.Config) -> dict[str, str]:
    """What stands before the ids of each subject's tests: nothing if there is but one."""
    given = dict.fromkeys(config.getoption("--affinecert-subject"))
    return {subject: f"{subject}{SEPARATOR}" if len(given) > 1 else "" for subject in given}


def names(config: pytest.Config) -> Iterator[str]:
    """The ids of all tests of a run, chosen or not."""
    return (prefix + name for subject, prefix in subjects(config).items() for name, _, _ in tests(subject))


class SubjectTests(pytest.File):
    """Collects the tests of the subjects of a run."""

    def collect(self) -> Iterator[SubjectTest]:
        """Each with what is expected of it. Raises CollectError where a subject cannot be loaded."""
        expectations = self.config.stash[EXPECTATIONS]
        for subject, prefix in subjects(self.config).items():
            try:
                found = list(tests(subject))
            except AffinecertError as error:
                raise self.CollectError(str(error)) from error
            for name, kind, about in found:
                test = kind.from_parent(self, name=prefix + name, subject=subject, about=about)
                if skip := first(expectations.skips, test.name):
                    test.add_marker(pytest.mark.skip(reason=skip.reason or f"listed at {skip.place}"))
                elif xfail := first(expectations.xfails, test.name):
                    reason = xfail.reason or f"listed at {xfail.place}"
                    test.add_marker(pytest.mark.xfail(reason=reason, strict=False))
                yield test
