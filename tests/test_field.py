"""Bugs that people reported are caught on the inputs that they reported, and what repairs them is acquitted there."""

from __future__ import annotations

import re
from collections import Counter
from functools import cache

import pytest

from affinecert import corpus
from affinecert.case import Case
from affinecert.judging import judge, truths_of
from affinecert.scoring import Verdict
from affinecert.subject import Subject
from affinecert.tier import batches
from affinecert.truths import Truth

from .field import REPORTS, Report
from .field.report import Formula, batched

THREAD = re.compile(r"\b[\w.-]+/[\w.-]+#\d+")
"""How a provenance names a thread of a public tracker: owner, repository and number."""

NAMES = [f"{report.thread}-{report.map}-{report.verdict}" for report in REPORTS]


@cache
def reported_cases() -> dict[tuple[str, str], list[Case]]:
    """The corpus cases of each thread and map."""
    found: dict[tuple[str, str], list[Case]] = {}
    for case in corpus.shipped():
        for thread in THREAD.findall(case.provenance):
            found.setdefault((thread, case.map), []).append(case)
    return found


@cache
def posed(thread: str, name: str) -> list[tuple[tuple[Case, ...], list[Truth]]]:
    """The cases of one thread and map in batches, with the truths."""
    return [(batch, [truth_of(case.key) for case in batch]) for batch in batches(reported_cases()[thread, name])]


@cache
def truth_of(key: str) -> Truth:
    """The truth of a case, which several threads may share."""
    case = next(case for cases in reported_cases().values() for case in cases if case.key == key)
    return truths_of([case])[0]


def verdicts(report: Report, formula: Formula) -> Counter[str]:
    subject = Subject("reported", "0", {report.map: batched(formula)})
    return Counter(
        result.verdict for batch, known in posed(report.thread, report.map) for result in judge(subject, batch, known)
    )


@pytest.mark.parametrize("report", REPORTS, ids=NAMES)
def test_the_reported_bug_is_caught(report: Report) -> None:
    found = verdicts(report, report.faulty)
    assert found[report.verdict], f"{report.faulty.__doc__} gives {dict(found)}, not one {report.verdict}"


@pytest.mark.parametrize("report", REPORTS, ids=NAMES)
def test_the_repair_is_acquitted(report: Report) -> None:
    assert set(verdicts(report, report.repaired)) == {Verdict.OK}


def test_reports_and_corpus_name_the_same_threads() -> None:
    assert {(report.thread, report.map) for report in REPORTS} == set(reported_cases())


def test_a_thread_is_told_with_its_title() -> None:
    told = {thread: case.provenance for (thread, _), cases in reported_cases().items() for case in cases}
    assert all(f"{report.thread}, {report.title}" in told[report.thread] for report in REPORTS)


def test_the_field_is_wide() -> None:
    threads = {report.thread for report in REPORTS}
    assert len(threads) >= 60
    assert len({thread.partition("#")[0] for thread in threads}) >= 12
    assert len({case.key for cases in reported_cases().values() for case in cases}) >= 60
