"""Lemma 2 of bansal_tatu, and property 4 of rossignac_vinacua."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from affinecert.properties.law import Law
from affinecert.properties.laws.volume_kept import LAWS


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_volume_kept(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)
