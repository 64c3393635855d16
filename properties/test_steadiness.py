"""Lemma 1 of bansal_tatu, property 6 of rossignac_vinacua, and where the first ends."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from affinecert.properties.answers import Maps
from affinecert.properties.law import Law
from affinecert.properties.laws.steadiness import LAWS


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_steadiness(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)


def test_all_three_components_together_are_not_steady(maps: Maps) -> None:
    """A shear, then a rotation: T_(1/2) T_(1/2) is far from T, so Lemma 1 cannot be widened to every T."""
    shear = np.array([[1.0, 1.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]])
    quarter = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    matrix = np.eye(4)
    matrix[:3, :3] = shear @ quarter
    half = maps["affine_lie.interpolate"](matrix, np.array(0.5))
    assert np.linalg.norm(half @ half - matrix) > 0.1
