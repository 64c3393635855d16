from __future__ import annotations

from typing import Any

import pytest

from affinecert.properties.claims import PAPERS
from affinecert.properties.claims.claim import Claim
from tests.claims.entries import stands


@pytest.mark.parametrize("claim", PAPERS["rossignac_vinacua"].claims, ids=lambda claim: claim.id)
def test_the_check_of(claim: Claim[Any, Any]) -> None:
    stands(claim)
