"""Lemma 4 of bansal_tatu, and property 5 of rossignac_vinacua."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from affinecert.properties.law import Law
from affinecert.properties.laws.isometry import LAWS


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_isometry(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)
