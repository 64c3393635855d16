"""Where the papers say that morphs are the same."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from affinecert.properties.law import Law
from affinecert.properties.laws.coincidence import LAWS


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_coincidence(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)
