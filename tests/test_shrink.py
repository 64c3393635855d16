"""Shrinking: simpler, as bad, and within its limit."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.shrink import complexity, shrink, total

FLOATS = st.floats(allow_nan=False, allow_infinity=False)


@pytest.mark.parametrize(
    ("simple", "complicated"),
    [
        (0.0, 1.0),
        (1.0, -1.0),
        (1.0, 2.0),
        (2.0, 12.0),
        (1e-9, 1.5e-9),
        (1e-9, 2.0**-30),
        (2.0**-30, 0.123),
        (0.1, 0.1 + 2.0**-56),
    ],
)
def test_what_is_shorter_to_write_is_simpler(simple: float, complicated: float) -> None:
    assert complexity(simple) < complexity(complicated)


@given(FLOATS)
def test_a_single_number_shrinks_to_zero_where_anything_goes(number: float) -> None:
    (shrunk,) = shrink((np.array(number),), lambda inputs: True, limit=100)
    assert shrunk == 0


@given(st.lists(FLOATS, min_size=1, max_size=4), st.integers(0, 40))
def test_the_result_is_as_bad_and_no_more_complicated(numbers: list[float], limit: int) -> None:
    start = (np.array(numbers),)
    asked = 0

    def as_bad(inputs: tuple[Array, ...]) -> bool:
        nonlocal asked
        asked += 1
        return math.copysign(1.0, inputs[0][0]) == math.copysign(1.0, numbers[0])

    shrunk = shrink(start, as_bad, limit)
    assert asked <= limit
    assert total(shrunk) <= total(start)
    assert as_bad(shrunk)


def test_what_matters_is_kept_and_the_rest_goes() -> None:
    start = (np.array([0.731, -1.4142135623730951, 3.3e-9]), np.array(17.25))
    shrunk = shrink(start, lambda inputs: 1e-9 <= inputs[0][2] <= 5e-9, limit=1000)
    assert shrunk[0].tolist() == [0.0, 0.0, 3e-9]
    assert shrunk[1] == 0.0


def test_rounding_as_a_whole_keeps_what_single_entries_would_break() -> None:
    angle = 0.3000001
    rotation = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])

    def orthogonal(inputs: tuple[Array, ...]) -> bool:
        return bool(np.linalg.norm(inputs[0].T @ inputs[0] - np.eye(2)) < 1e-3 and inputs[0][1, 0] > 0.2)

    (shrunk,) = shrink((rotation,), orthogonal, limit=500)
    assert all(len(repr(abs(entry))) <= 6 for entry in shrunk.ravel().tolist())


def test_the_input_is_left_alone() -> None:
    start = (np.array([0.5, 0.25]),)
    shrink(start, lambda inputs: True, limit=10)
    assert start[0].tolist() == [0.5, 0.25]
