"""Lemma 5 of bansal_tatu, property 3 of rossignac_vinacua, and where they end."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from affinecert.properties.answers import Maps
from affinecert.properties.law import Law
from affinecert.properties.laws.reversibility import LAWS
from affinecert.properties.special import CANONICAL


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_reversibility(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)


def test_tetrahedra_half_a_turn_apart_do_not_go_back_as_they_came(maps: Maps) -> None:
    """At a relative angle of exactly pi Lemma 5 is false: log R = log R^-1, so that both ways turn the same way."""
    half_turn = np.diag([-1.0, -1.0, 1.0])
    target = CANONICAL @ half_turn.T
    there = maps["affine_lie.interpolate_tetrahedra"](CANONICAL, target, np.array(0.5))
    back = maps["affine_lie.interpolate_tetrahedra"](target, CANONICAL, np.array(0.5))
    # A quarter turn one way and the other: opposite points, the second vertex at distance 1 from the axis.
    assert np.linalg.norm(there[1] - back[1]) == pytest.approx(2.0)


def test_a_morph_over_half_a_turn_does_not_go_back_as_it_came(maps: Maps) -> None:
    """Nor is property 3 true of C B^-1 = -I in the plane."""
    half_turn = np.diag([-1.0, -1.0, 1.0])
    there = maps["sam.morph"](np.eye(3), half_turn, np.array(0.5))
    back = maps["sam.morph"](half_turn, np.eye(3), np.array(0.5))
    np.testing.assert_allclose(there, np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]), atol=1e-15)
    np.testing.assert_allclose(back[:2, :2], -there[:2, :2], atol=1e-15)
