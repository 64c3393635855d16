"""Homotopies of the reference against exponentials that Arb encloses, and what the paper says of their determinants."""

from __future__ import annotations

from typing import Any

import flint
import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import homotopy2, polar, sam
from affinecert.reference._matrices import homogeneous, identity

from . import enclosures
from .enclosures import Numbers, context, distance, length, numbers

BITS = 400
LOST = 60

HALF_TURN = [[-1.0, 0], [0, -1]]

SPECIAL = {
    "identity": [[1.0, 0], [0, 1]],
    "half turn": HALF_TURN,
    "half turn after a stretch": [[-2.0, 1], [1, -3]],
    "next to a half turn": [[-1.0, 1e-30], [-1e-30, -2]],
    "quarter turn": [[0.0, -1], [1, 0]],
    "stretch": [[3.0, 1], [1, 2]],
    "stretches that nearly agree": [[2.0, 1e-40], [0, 2]],
    "thin": [[1.0, 1], [1, 1 + 2**-50]],
    "huge": [[1e150, 3], [-2, 1e-140]],
    "tiny": [[0.0, -1e-150], [1e-140, 0]],
}


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def random_maps(count: int = 20) -> dict[str, Any]:
    draw = np.random.default_rng(0)
    maps = [matrix for matrix in draw.normal(size=(4 * count, 2, 2)) if np.linalg.det(matrix) > 0]
    return {f"random {number}": matrix for number, matrix in enumerate(maps[:count])}


ALL = SPECIAL | random_maps()
every_map = pytest.mark.parametrize("matrix", ALL.values(), ids=list(ALL))


def logarithm(ctx: Any, matrix: Numbers) -> Numbers:
    """The principal logarithm; of a half turn that which turns by +pi."""
    return sam.log(ctx, homogeneous(ctx, matrix, numbers(ctx, [0.0, 0.0])))[:2, :2]


def close(ctx: Any, found: Numbers, expected: Any) -> bool:
    expected = numbers(ctx, expected)
    return bool(length(ctx, found - expected) <= ctx.ldexp(length(ctx, expected), LOST - BITS))


@every_map
@pytest.mark.parametrize("t", [0.3, -1.7, 2.5])
def test_homotopies_are_products_of_powers_of_the_polar_factors(ctx: Any, matrix: Any, t: float) -> None:
    exact = numbers(ctx, matrix)
    with ctx.workprec(BITS + 3000):
        rotation, stretch = polar.decompose(ctx, exact)
        if rotation[0, 0] < 0 and exact[0, 1] == exact[1, 0]:
            rotation = -identity(ctx, 2)  # where rounding would leave it open to which side of pi it turns
        turn, growth = logarithm(ctx, rotation), logarithm(ctx, stretch)
        straight = identity(ctx, 2) * (1 - ctx.mpf(t)) + stretch * ctx.mpf(t)
        turned = enclosures.exponential(turn * ctx.mpf(t), 5000)
        power = enclosures.exponential(growth * ctx.mpf(t), 5000)
    with flint.ctx.workprec(5000):
        expected = {homotopy2.polar: turned * enclosures.balls(straight), homotopy2.exponential: turned * power}
    for function, enclosed in expected.items():
        found = function(ctx, exact, numbers(ctx, t))
        assert distance(ctx, enclosed, found) <= ctx.ldexp(length(ctx, found), LOST - BITS)


@every_map
def test_ends_are_reached(ctx: Any, matrix: Any) -> None:
    exact = numbers(ctx, matrix)
    for function in (homotopy2.linear, homotopy2.polar, homotopy2.exponential):
        assert close(ctx, function(ctx, exact, numbers(ctx, 0.0)), np.eye(2))
        assert close(ctx, function(ctx, exact, numbers(ctx, 1.0)), exact)


def determinant(matrix: Numbers) -> Any:
    return matrix[0, 0] * matrix[1, 1] - matrix[0, 1] * matrix[1, 0]


def test_what_the_paper_says_of_determinants(ctx: Any) -> None:
    """The linear homotopy of -I vanishes half way; A^P turns over where 1 + t (x - 1) does, and A^E never."""
    assert not homotopy2.linear(ctx, numbers(ctx, HALF_TURN), numbers(ctx, 0.5)).any()
    assert close(ctx, homotopy2.polar(ctx, numbers(ctx, HALF_TURN), numbers(ctx, 0.5)), [[0, -1], [1, 0]])
    # Singular values 1/8 and 2: A^P collapses at t = 8/7.
    matrix = numbers(ctx, [[0.0, -2.0], [0.125, 0.0]])
    signs = [determinant(homotopy2.polar(ctx, matrix, numbers(ctx, t))) > 0 for t in (1.0, 1.142, 1.143, 1.35)]
    assert signs == [True, True, False, False]
    areas = [determinant(homotopy2.exponential(ctx, matrix, numbers(ctx, t))) for t in (-2.0, 0.0, 1.0, 1.35, 10.0)]
    assert areas == sorted(areas, reverse=True)
    assert areas[-1] > 0


@pytest.mark.parametrize("name", ["polar", "exponential"])
def test_a_half_turn_is_continued_to_both_sides(ctx: Any, name: str) -> None:
    function, continued = getattr(homotopy2, name), getattr(homotopy2, f"continue_{name}")
    t = numbers(ctx, 0.5)
    base = function(ctx, numbers(ctx, HALF_TURN), t)
    beyond = numbers(ctx, [[-1.0, 1e-20], [-1e-20, -1.0]])
    assert length(ctx, function(ctx, beyond, t) + base) <= 1e-19
    assert length(ctx, continued(ctx, base, beyond, t) - base) <= 1e-19
    assert close(ctx, continued(ctx, base, numbers(ctx, HALF_TURN), t), base)


@pytest.mark.parametrize("matrix", [[[1.0, 2], [2, 4]], [[0.0, 1], [1, 0]], [[1.0, 0], [0, -1e-300]]])
def test_a_map_that_turns_over_has_no_polar_homotopy(ctx: Any, matrix: Any) -> None:
    for function in (homotopy2.polar, homotopy2.exponential):
        with pytest.raises(InputError, match=r"^linear: determinant is not positive"):
            function(ctx, numbers(ctx, matrix), numbers(ctx, 0.5))
    assert homotopy2.linear(ctx, numbers(ctx, matrix), numbers(ctx, 0.5)).shape == (2, 2)
