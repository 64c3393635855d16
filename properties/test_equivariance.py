"""Property 2 of rossignac_vinacua."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from affinecert.properties.answers import Maps
from affinecert.properties.law import Law
from affinecert.properties.laws.equivariance import LAWS


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_equivariance(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)


def test_no_power_of_minus_one_suits_every_frame(maps: Maps) -> None:
    """-I looks the same in every frame, but its square root, a quarter turn, does not: half turns are excluded."""
    half = maps["sam.power"](np.diag([-1.0, -1.0, 1.0]), np.array(0.5))
    frame = np.diag([2.0, 1.0, 1.0])
    assert np.linalg.norm(frame @ half @ np.linalg.inv(frame) - half) > 1.0
