"""The published certificates: each finding has a snippet without affinecert, and that was seen to show it."""

from __future__ import annotations

from pathlib import Path

import pytest

from affinecert import certificate
from affinecert.compare import compare
from affinecert.scoring import FINDINGS, Verdict
from affinecert.subject import named

FOLDER = Path(__file__).parents[1] / "reports" / "certificates"
PUBLISHED = sorted(FOLDER.glob("*.json"))
OURS = {"fast", "printed", "reference"}
"""Subjects that are no libraries of their own."""


def test_every_library_s_certificate_is_published() -> None:
    own = {name for name, entry in named().items() if entry.module.startswith("affinecert.subjects.")}
    assert {path.stem for path in PUBLISHED} == own - OURS


@pytest.mark.parametrize("path", PUBLISHED, ids=lambda path: path.stem)
def test_every_finding_has_a_snippet_that_was_seen_to_show_it(path: Path) -> None:
    read = certificate.read(path)
    assert read.spec == path.stem
    cells = [cell for row in compare([read]).rows for cell in row.cells if cell]
    grave = [cell for cell in cells if Verdict(cell.worst.verdict) in FINDINGS]
    assert all(cell.proven for cell in grave)
    assert {cell.worst.shown for cell in cells if cell not in grave} <= {""}
