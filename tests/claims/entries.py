"""What every entry of the ledger has to stand: its check comes to its verdict, and is able to fail."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.finding import judge


def stands(claim: Claim[Any, Any]) -> None:
    """Runs the check: the verdict is the one stated, copies are refuted, the correction and the losses are right."""
    finding = judge(claim)
    assert finding.complaints == ()
    assert finding.verdict == claim.verdict
