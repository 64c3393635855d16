"""Exponentials and logarithms, and where a principal logarithm stops undoing its exponential."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from affinecert.properties.answers import Maps
from affinecert.properties.law import Law
from affinecert.properties.laws.exp_log import LAWS


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_exp_log(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)


def test_beyond_pi_the_principal_logarithm_is_another(maps: Maps) -> None:
    """A turn by 4 radians is one by 4 - 2 pi: log(exp x) = x is a law of angles below pi only."""
    back = maps["so3.log"](maps["so3.exp"](np.array([0.0, 0.0, 4.0])))
    np.testing.assert_allclose(back, [0.0, 0.0, 4.0 - 2 * np.pi], rtol=1e-15)
