"""What every entry of the ledger has to stand: its check comes to its verdict, and is able to fail."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.finding import judge
from affinecert.reports.claims import Entry, record

PUBLISHED = Path(__file__).parents[2] / "reports" / "ledger"

FIGURES = {"deviation", "outside", "correction", "copies", "numbers", "losses"}
"""What rounding may change a little from one machine to another."""


@cache
def published() -> Mapping[str, Mapping[str, Any]]:
    """The records of the published ledger, by the claims' ids, in its order."""
    records = json.loads((PUBLISHED / "ledger.json").read_text(encoding="utf-8"))
    return {each["id"]: each for each in records}


def without_figures(told: Mapping[str, Any]) -> Mapping[str, Any]:
    return {name: value for name, value in told.items() if name not in FIGURES}


def stands(claim: Claim[Any, Any]) -> None:
    """Runs the check.

    The verdict is the one stated, copies are refuted, the correction and the losses are right; and so it is published.
    """
    finding = judge(claim)
    assert finding.complaints == ()
    assert finding.verdict == claim.verdict
    assert without_figures(record(Entry(claim, finding))) == without_figures(published()[claim.id])
