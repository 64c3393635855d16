"""Bugs that people reported are caught on the inputs that they reported, and what repairs them is acquitted there."""

from __future__ import annotations

from collections import Counter
from functools import cache
from pathlib import Path

import pytest

from affinecert.case import Case
from affinecert.judging import judge, truths_of
from affinecert.scoring import Verdict
from affinecert.subject import Subject
from affinecert.tier import batches
from affinecert.truths import Truth

from .field import REPORTS, Report
from .field.page import page, reported_cases
from .field.report import Formula, batched

NAMES = [f"{report.thread}-{report.map}-{report.verdict}" for report in REPORTS]


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


def test_the_published_page_is_that_of_the_code() -> None:
    published = Path(__file__).resolve().parents[1] / "reports" / "field.md"
    assert published.read_text(encoding="utf-8") == page(), "python -m tests.field > reports/field.md"
