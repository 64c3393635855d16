"""The shears and scales of the reference, and the divided differences they rest on."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import scale, shear
from affinecert.reference._functions import divided_difference, exponential, logarithm, power, quotient
from affinecert.reference._stumpff import stumpff

from . import enclosures
from .enclosures import context, distance, length, numbers

BITS = 400
LOST = 40


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


DIAGONALS = [
    (0.7, -0.4),
    (0.0, 0.0),
    (0.0, 1.5),
    (1.5, 0.0),
    (0.8, 0.8),
    (0.8, 0.8 + 1e-15),
    (1e-15, -1e-15),
    (1e-200, -1e-200),
    (1e-200, 1.0),
    (1e-160, 1e-300),
    (30.0, -30.0),
]


@pytest.mark.parametrize(("second", "fifth"), DIAGONALS)
def test_exp_is_the_exponential_of_the_matrix(ctx: Any, second: float, fifth: float) -> None:
    for seed in range(3):
        first, third, fourth = np.random.default_rng(seed).normal(size=3)
        twist = numbers(ctx, [first, second, third, fourth, fifth])
        value = shear.exp(ctx, twist)
        balls = enclosures.exponential(shear.matrix(ctx, twist, ctx.zero), 4000)
        assert distance(ctx, balls, value) <= ctx.ldexp(length(ctx, value), LOST - BITS)


@pytest.mark.parametrize(("second", "fifth"), [*DIAGONALS, (345.0, -345.0), (-300.0, -300.0)])
def test_log_is_the_logarithm(ctx: Any, second: float, fifth: float) -> None:
    for seed in range(3):
        draw = np.random.default_rng(seed)
        matrix = np.eye(3)
        matrix[[0, 0, 1], [1, 2, 2]] = draw.normal(size=3)
        matrix[1, 1], matrix[2, 2] = np.exp(second), np.exp(fifth)
        exact = numbers(ctx, matrix)
        with ctx.workprec(BITS + 1000):  # what the exponential of so huge entries cancels
            twist = shear.log(ctx, exact)
        # Real eigenvalues are in the principal strip by themselves.
        balls = enclosures.exponential(shear.matrix(ctx, twist, ctx.zero), 4000)
        assert distance(ctx, balls, exact) <= ctx.ldexp(length(ctx, exact), LOST - BITS)


@pytest.mark.parametrize("gap", [1e-15, 1e-100, 1e-300])
def test_entries_next_to_the_identity_are_each_accurate(ctx: Any, gap: float) -> None:
    twist = numbers(ctx, [gap, 2 * gap, -gap, 3 * gap, -gap])
    linear = shear.parameters(shear.exp(ctx, twist))
    with ctx.workprec(2500):
        exact = shear.parameters(shear.exp(ctx, twist))
        assert all(abs(a - b) <= ctx.ldexp(abs(b), LOST - BITS) for a, b in zip(linear, exact, strict=True))


def test_defective_cases_by_hand(ctx: Any) -> None:
    one = numbers(ctx, [2.0, 0.0, 3.0, 5.0, 0.0])
    assert np.array_equal(shear.exp(ctx, one), numbers(ctx, [[1, 2, 3 + 5], [0, 1, 5], [0, 0, 1]]))
    assert np.array_equal(shear.log(ctx, numbers(ctx, [[1, 2, 8], [0, 1, 5], [0, 0, 1]])), one)
    # Bansal and Tatu, A.2.4, equal eigenvalues other than 1.
    twist = shear.log(ctx, numbers(ctx, [[1, 2, 3], [0, 4, 5], [0, 0, 4]]))
    log4 = ctx.log(4)
    expected = [2 * log4 / 3, log4, log4 + ctx.mpf(10) / 12 - 10 * log4 / 9, ctx.mpf(5) / 4, log4]
    assert length(ctx, twist - np.array(expected)) <= ctx.ldexp(ctx.one, LOST - BITS)


@pytest.mark.parametrize(
    ("entry", "value", "reason"),
    [
        ((0, 0), 1.5, "not a shear"),
        ((2, 1), 1e-300, "not a shear"),
        ((1, 1), 0.0, "not positive"),
        ((2, 2), -1.0, "not positive"),
        ((0, 2), np.nan, "not finite"),
    ],
)
def test_log_refuses_what_is_not_in_the_group(ctx: Any, entry: tuple[int, int], value: float, reason: str) -> None:
    matrix = np.eye(3)
    matrix[entry] = value
    with pytest.raises(InputError, match=reason) as caught:
        shear.log(ctx, numbers(ctx, matrix))
    assert caught.value.argument == "shear"


def test_scales(ctx: Any) -> None:
    assert abs(scale.exp(ctx, numbers(ctx, 1.0))[()] - ctx.e) <= ctx.ldexp(ctx.one, 4 - BITS)
    for value in (1e-300, 0.5, 1 - 2.0**-53, 1.0, 1e150):
        log = scale.log(ctx, numbers(ctx, value))
        assert abs(scale.exp(ctx, log)[()] - value) <= ctx.ldexp(ctx.mpf(value), LOST - BITS)
    for value in (0.0, -1.0):
        with pytest.raises(InputError, match="not positive"):
            scale.log(ctx, numbers(ctx, value))
    with pytest.raises(InputError, match="not finite"):
        scale.exp(ctx, numbers(ctx, np.nan))


@pytest.mark.parametrize("gap", [0.0, 1e-300, 1e-40, 1.0])
def test_divided_differences_of_a_cube_are_exact_sums(ctx: Any, gap: float) -> None:
    cube = power(ctx, ctx.mpf(3))
    a, b, c = nodes = [ctx.mpf(2), ctx.mpf(2) + gap, ctx.mpf(2) + 3 * gap]
    assert abs(divided_difference(ctx, cube, nodes, c) - (a + b + c)) <= ctx.ldexp(c, LOST - BITS)
    square_sum = a * a + a * b + b * b
    assert abs(divided_difference(ctx, cube, [a, b], c) - square_sum) <= ctx.ldexp(square_sum, LOST - BITS)


@pytest.mark.parametrize("function", [exponential, logarithm, lambda ctx: power(ctx, ctx.mpf(0.3))])
def test_quotients_at_1_follow_from_their_neighbourhood(ctx: Any, function: Any) -> None:
    g = quotient(ctx, function(ctx))
    for k, gap in itertools.product(range(3), [1e-30, 1e-300]):
        # The coefficients g_k at 1 + gap differ from those at 1 by about (k + 1) g_(k+1) gap.
        at, near = g(ctx.one, 3), g(1 + ctx.ldexp(ctx.one, -100 if gap > 1e-40 else -390), 2)
        bound = ctx.ldexp(abs(at[k + 1]) + 1, -97 if gap > 1e-40 else -387)
        assert abs(near[k] - at[k]) <= (k + 1) * bound


def test_taylor_coefficients_are_derivatives(ctx: Any) -> None:
    x, h = ctx.mpf(1.7), ctx.ldexp(ctx.one, -120)
    for f in (exponential(ctx), logarithm(ctx), power(ctx, ctx.mpf(-0.4)), quotient(ctx, logarithm(ctx))):
        for k in range(2):
            slope = (f(x + h, k)[k] - f(x - h, k)[k]) / (2 * h)
            assert abs(slope - (k + 1) * f(x, k + 1)[k + 1]) <= ctx.ldexp(ctx.one, -200)


@pytest.mark.parametrize("x", [0.0, 1e-300, 2.0**-21, 2.0**-20, 0.5, 9.8696, 39.4, 1000.0])
def test_stumpff_functions_are_their_series(ctx: Any, x: float) -> None:
    values = stumpff(ctx, ctx.mpf(x))
    with ctx.workprec(BITS + 200):
        for k, value in enumerate(values):
            series = ctx.fsum((-ctx.mpf(x)) ** j / ctx.factorial(2 * j + k) for j in range(150))
            assert abs(series - value) <= ctx.ldexp(ctx.one, LOST - BITS)
