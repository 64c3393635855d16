"""What measures of a path do not depend on."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from affinecert.properties.law import Law
from affinecert.properties.laws.path_invariance import LAWS


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_path_invariance(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)
