"""Culver's condition, and the region that equation 4 of rossignac_vinacua draws."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from affinecert.map import Array
from affinecert.properties.answers import Maps
from affinecert.properties.culver import Negative, negative_eigenvalues
from affinecert.properties.inexact import exact
from affinecert.properties.law import Law
from affinecert.properties.laws.existence import LAWS, in_region


@pytest.mark.parametrize("law", LAWS, ids=[law.name for law in LAWS])
def test_existence(law: Law, keeps: Callable[[Law], None]) -> None:
    """The subject keeps the law."""
    keeps(law)


def test_equation_4_as_printed_bounds_the_maps_that_have_a_logarithm() -> None:
    """Its sign is right, though the text calls it a rewriting of the condition for the bad ones."""
    stretch = np.diag([2.0, 0.5])
    for degrees, exists in ((100.0, True), (140.0, True), (145.0, False), (180.0, False)):
        a = math.radians(degrees)  # arccos(-2 s / (s^2 + 1)) at s = 1/2 is 143.1 degrees
        turn = np.array([[math.cos(a), -math.sin(a)], [math.sin(a), math.cos(a)]])
        assert in_region(turn @ stretch) is exists
        assert (negative_eigenvalues(exact(turn @ stretch)) is Negative.NONE) is exists


def test_the_region_is_convex_and_contains_the_trapezoid() -> None:
    """Arccos(-2 s / (s^2 + 1)) = pi/2 + 2 arctan s, concave in s, so over its chord, the trapezoid's (1 + s) pi/2."""
    s = np.linspace(0.0, 1.0, 1001)
    border = np.arccos(-2 * s / (s * s + 1))
    # arccos loses half of the digits where its argument comes to -1.
    np.testing.assert_allclose(border, math.pi / 2 + 2 * np.arctan(s), atol=1e-7)
    border = math.pi / 2 + 2 * np.arctan(s)
    assert np.all(np.diff(border, 2) < 0)
    assert np.all(border[1:-1] > (1 + s[1:-1]) * math.pi / 2)


@pytest.mark.parametrize(
    ("linear", "kind"),
    [
        (np.diag([-1.0, -1.0]), Negative.HALF_TURN),
        (np.diag([-1.0, -2.0]), Negative.PREVENTING),
        (np.array([[-1.0, 1.0], [0.0, -1.0]]), Negative.PREVENTING),
        (np.array([[0.0, -1.0], [1.0, 0.0]]), Negative.NONE),
        (np.diag([-2.0, 3.0, -2.0]), Negative.HALF_TURN),
        (np.diag([-2.0, 3.0, np.nextafter(-2.0, -3.0)]), Negative.PREVENTING),
        (np.array([[3.0, 1.0, 1.0], [0.0, -2.0, 1.0], [0.0, 0.0, -2.0]]), Negative.PREVENTING),
        (np.array([[3.0, 1.0, 1.0], [0.0, -2.0, 0.0], [0.0, 0.0, -2.0]]), Negative.HALF_TURN),
        (np.array([[2.0, 1.0, 0.0], [0.0, 2.0, 1.0], [0.0, 0.0, 2.0]]), Negative.NONE),
    ],
)
def test_negative_eigenvalues(linear: Array, kind: Negative) -> None:
    """Culver's condition, on matrices whose eigenvalues can be read off."""
    assert negative_eigenvalues(exact(linear)) is kind


def test_a_subject_decides_as_the_region_does_on_its_border(maps: Maps) -> None:
    """At s = 1 and a = pi the map is -I and has a logarithm; a hair inside of s = 1 it is none and has none."""
    for last, exists in ((-1.0, True), (np.nextafter(-1.0, 0.0), False)):
        assert bool(maps["sam.exists"](np.diag([-1.0, last, 1.0]))) is exists
