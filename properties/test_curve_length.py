"""The bounds of a curve's length: section 10 of gallier, corrected."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from affinecert.properties.law import Law
from affinecert.properties.laws.curve_length import LAWS


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_curve_length(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)
