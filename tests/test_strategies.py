"""The public strategies: within their bounds, close to the singular sets, and shrinking to what can be read."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import HealthCheck, find, given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from affinecert.catalogue import CATALOGUE
from affinecert.errors import UnknownNameError
from affinecert.map import Array, Map
from affinecert.properties import special, strategies
from affinecert.properties.culver import Negative, negative_eigenvalues
from affinecert.properties.inexact import determinant, exact

QUICK = settings(
    database=None, derandomize=True, deadline=None, max_examples=30, suppress_health_check=list(HealthCheck)
)
BOUNDS = [(-300.0, -16.0), (-16.0, 0.0), (-300.0, 0.49), (0.1, 0.4), (2.0, 8.0), (-150.0, 150.0)]
RANGES = [(0.0, math.pi), (-1.0, 1.0), (0.5, 2.0), (1.0, 1.0), (1e-12, 2e-12), (-1e3, 1e3)]


@pytest.mark.parametrize(("low", "high"), BOUNDS)
def test_exponents_stay_within_their_bounds_and_shrink_towards_one(low: float, high: float) -> None:
    numbers = strategies.drawn(lambda draw: draw.exponent(low, high))

    @QUICK
    @given(numbers)
    def within(number: float) -> None:
        assert 10.0**low * (1 - 1e-12) <= number <= 10.0**high * (1 + 1e-12)

    within()
    if low <= 0.0 <= high and high - low >= 1:
        assert find(numbers, lambda _: True, settings=QUICK) == 1.0


@pytest.mark.parametrize(("low", "high"), RANGES)
def test_uniform_numbers_stay_within_their_bounds(low: float, high: float) -> None:
    @QUICK
    @given(strategies.drawn(lambda draw: draw.uniform(low, high)))
    def within(number: float) -> None:
        assert low <= number <= high

    within()


def test_uniform_numbers_shrink_to_round_ones() -> None:
    numbers = strategies.drawn(lambda draw: draw.uniform(-10.0, 10.0))
    assert find(numbers, lambda number: number > 2.345, settings=settings(QUICK, max_examples=500)) in {3.0, 2.4}


@pytest.mark.parametrize("size", [2, 3, 4, 9])
def test_directions_are_unit_vectors_and_shrink_to_the_first_axis(size: int) -> None:
    directions = strategies.drawn(lambda draw: draw.direction(size))

    @QUICK
    @given(directions)
    def unit(vector: Array) -> None:
        assert vector.shape == (size,)
        assert np.linalg.norm(vector) == pytest.approx(1.0, rel=1e-15)

    unit()
    np.testing.assert_array_equal(find(directions, lambda _: True, settings=QUICK), np.eye(size)[0])


@pytest.mark.parametrize("entry", CATALOGUE.values(), ids=CATALOGUE)
def test_every_regime_is_a_strategy(entry: Map) -> None:
    for each in entry.regimes:

        @settings(QUICK, max_examples=3)
        @given(strategies.regime(entry.name, each.name))
        def well_formed(inputs: tuple[Array, ...]) -> None:
            assert len(inputs) == len(entry.arguments)
            for array, argument in zip(inputs, entry.arguments, strict=True):
                assert array.dtype == np.float64
                assert len(array.shape) == len(argument.shape)

        well_formed()


@pytest.mark.parametrize(
    ("strategy", "shape"),
    [
        (strategies.rotation_vectors(), (3,)),
        (strategies.rotations(), (3, 3)),
        (strategies.twists(), (6,)),
        (strategies.poses(), (4, 4)),
        (strategies.shear_twists(), (5,)),
        (strategies.shears(), (3, 3)),
        (strategies.scales(), ()),
        (strategies.log_scales(), ()),
        (strategies.tetrahedra(), (4, 3)),
        (strategies.affine_maps(2), (3, 3)),
        (strategies.affine_maps(3), (4, 4)),
        (strategies.times(), ()),
    ],
)
def test_named_strategies_give_what_they_are_named_after(strategy: SearchStrategy[Array], shape: tuple[int]) -> None:
    @QUICK
    @given(strategy)
    def shaped(array: Array) -> None:
        assert np.shape(array) == shape

    shaped()


@pytest.mark.parametrize(
    ("strategy", "close"),
    [
        (strategies.rotation_vectors(), lambda omega: 0 < np.linalg.norm(omega) < 1e-100),
        (strategies.rotation_vectors(), lambda omega: 0 < abs(np.linalg.norm(omega) - math.pi) < 1e-12),
        (strategies.rotations(), lambda matrix: 0 < np.linalg.norm(matrix - matrix.T) < 1e-12 and matrix.trace() < 0),
        (strategies.times(), lambda time: 0 < abs(time - 1) < 1e-9),
        (strategies.affine_maps(2), lambda m: negative_eigenvalues(exact(m[:2, :2])) is Negative.HALF_TURN),
    ],
)
def test_singular_sets_are_approached(strategy: SearchStrategy[Array], close: Callable[[Array], bool]) -> None:
    find(strategy, close, settings=settings(QUICK, max_examples=2000))


@pytest.mark.parametrize("dimension", [2, 3])
def test_volume_keeping_maps_do_so_exactly(dimension: int) -> None:
    @QUICK
    @given(special.volume_keeping_maps(dimension))
    def kept(matrix: Array) -> None:
        assert determinant(exact(matrix)) == 1

    kept()


def test_unknown_names_are_answered_with_near_ones() -> None:
    with pytest.raises(UnknownNameError, match=r"so3\.exp"):
        strategies.inputs("so3.epx")
    with pytest.raises(UnknownNameError, match="near-identity"):
        strategies.regime("so3.exp", "near-identiy")


def test_a_strategy_composes_with_those_of_hypothesis() -> None:
    @QUICK
    @given(st.lists(strategies.poses(), min_size=2, max_size=3))
    def poses_in_a_row(poses: list[Array]) -> None:
        assert len(np.stack(poses)) == len(poses)

    poses_in_a_row()
