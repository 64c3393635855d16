"""A finding's snippet is run at the finding's own input, to be sure that it shows the fault."""

from __future__ import annotations

from pathlib import Path

import pytest

from affinecert.campaign import certify
from affinecert.compare import compare
from affinecert.reports import compare as told
from affinecert.scoring import Verdict


@pytest.mark.parametrize(
    ("subject", "jobs", "verdict"),
    [
        ("shows", 1, Verdict.DEGRADED),
        ("shows_nothing", 1, Verdict.OK),
        ("raises", 1, Verdict.RAISED),
        ("prints_nothing", 1, Verdict.RAISED),
        ("shows", 2, Verdict.DEGRADED),
        ("hangs", 2, ""),
    ],
)
def test_a_finding_s_snippet_is_run_at_its_own_input(subject: str, jobs: int, verdict: str, tmp_path: Path) -> None:
    found = certify(
        f"tests.adapters.coarse:{subject}",
        maps="scale.exp",
        profile="quick",
        jobs=jobs,
        store=tmp_path / "store",
        limit=1.0 if subject == "hangs" else 20.0,
    )
    gravest = [result.findings[0] for result in found.results if result.findings]
    assert len(gravest) >= 2
    assert {case.shown for case in gravest} == {verdict}
    assert all(result.worst == result.findings[0] for result in found.results if result.findings)
    assert not any(result.worst.shown for result in found.results if result.worst and not result.findings)
    table = compare([found])
    cells = [cell for row in table.rows for cell in row.cells if cell and cell.findings]
    assert {cell.proven for cell in cells} == {verdict == Verdict.DEGRADED}
    assert {bool(cell.snippet) for cell in cells} == {verdict in {Verdict.DEGRADED, ""}}
    assert ("by itself: degraded" in told.html(table)) == (verdict == Verdict.DEGRADED)
