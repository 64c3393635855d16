"""The published page: every thread with the map, the regimes and the verdict by which its bug is caught."""

from __future__ import annotations

import re
from functools import cache

from affinecert import corpus
from affinecert.case import Case

from .report import REPORTS, Report

THREAD = re.compile(r"\b[\w.-]+/[\w.-]+#\d+")
"""How a provenance names a thread of a public tracker: owner, repository and number."""

HEAD = """\
# Bugs from the field

{threads} threads of {projects} public issue trackers report these bugs; {inputs} inputs of the corpus come from them,
as reported or as small as shows the bug. For each, `tests/field` holds a faulty formula and the repaired one, written
anew from the description; where a thread tells no more than the symptom, the formula is one that has it.
`tests/test_field.py` shows that the faulty one is caught, as the table tells, and that the repaired one is acquitted;
where the map has no value, as for a reflection, the repair is to refuse. `other-branch` is no finding: it tells a
rotation vector beyond pi. `python -m tests.field` prints this page.

| thread | title | what was wrong | map | regimes | verdict |
|:--|:--|:--|:--|:--|:--|
"""


@cache
def reported_cases() -> dict[tuple[str, str], list[Case]]:
    """The corpus cases of each thread and map."""
    found: dict[tuple[str, str], list[Case]] = {}
    for case in corpus.shipped():
        for thread in THREAD.findall(case.provenance):
            found.setdefault((thread, case.map), []).append(case)
    return found


def page() -> str:
    """The page as Markdown."""
    threads = {report.thread for report in REPORTS}
    head = HEAD.format(
        threads=len(threads),
        projects=len({thread.partition("#")[0] for thread in threads}),
        inputs=len({case.key for cases in reported_cases().values() for case in cases}),
    )
    rows = sorted(REPORTS, key=lambda report: (report.thread.lower(), report.map, report.verdict))
    return head + "".join(_row(report) for report in rows)


def _row(report: Report) -> str:
    project, _, number = report.thread.partition("#")
    link = f"[{report.thread}](https://github.com/{project}/issues/{number})"
    regimes = ", ".join(dict.fromkeys(case.regime for case in reported_cases()[report.thread, report.map]))
    wrong = " ".join((report.faulty.__doc__ or "").split())
    cells = (link, report.title.replace("|", r"\|"), wrong.replace("|", r"\|"), report.map, regimes, report.verdict)
    return f"| {' | '.join(cells)} |\n"
