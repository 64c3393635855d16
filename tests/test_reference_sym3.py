"""The symmetric matrices of the reference and its polar factors, against their definitions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from affinecert.case import generate
from affinecert.catalogue import find, stretches
from affinecert.errors import InputError
from affinecert.reference import polar, so3, sym3
from affinecert.reference._matrices import identity

from .enclosures import Numbers, context, distance, exponential, length, numbers

BITS = 400
LOST = 60


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def close(ctx: Any, found: Numbers, due: Numbers) -> bool:
    return bool(length(ctx, found - due) <= ctx.ldexp(length(ctx, due), LOST - BITS))


def drawn(name: str, regime: str, count: int = 3) -> list[tuple[np.ndarray[Any, Any], ...]]:
    entry = find(name)
    (chosen,) = (candidate for candidate in entry.regimes if candidate.name == regime)
    return [case.inputs for case in generate(entry, chosen, count)]


MODERATE = ["generic", "meeting", "triple", "near-zero", "tiny", "asymmetric"]


@pytest.mark.parametrize("regime", MODERATE)
def test_exp_is_the_exponential_of_the_symmetric_part(ctx: Any, regime: str) -> None:
    for (matrix,) in drawn("sym3.exp", regime):
        exact = numbers(ctx, matrix)
        found = sym3.exp(ctx, exact)
        assert distance(ctx, exponential((exact + exact.T) / 2), found) <= ctx.ldexp(length(ctx, found), LOST - BITS)


@pytest.mark.parametrize(
    "regime", [kind.name for kind in stretches.POSITIVE_DEFINITE if kind.name != stretches.OUTSIDE.name]
)
def test_log_is_symmetric_and_has_the_matrix_for_exponential(ctx: Any, regime: str) -> None:
    for (matrix,) in drawn("sym3.log", regime):
        exact = numbers(ctx, matrix)
        # A logarithm tells the smallest eigenvalue by its last bits only.
        with ctx.workprec(BITS + 2000):
            logarithm = sym3.log(ctx, exact)
        assert close(ctx, logarithm, logarithm.T)
        balls = exponential(logarithm, 4000)
        assert distance(ctx, balls, (exact + exact.T) / 2) <= ctx.ldexp(length(ctx, exact), LOST - BITS)


@pytest.mark.parametrize("regime", ["generic", "meeting", "triple", "ill-conditioned", "last-bits", "huge-or-tiny"])
def test_powers_of_whole_exponents_are_products_and_inverses(ctx: Any, regime: str) -> None:
    for (matrix,) in drawn("sym3.log", regime):
        exact = numbers(ctx, matrix)
        half, minus = (sym3.power(ctx, exact, numbers(ctx, t)) for t in (0.5, -1.0))
        with ctx.workprec(BITS + 400):
            assert close(ctx, half @ half, exact)
            assert length(ctx, minus @ exact - identity(ctx, 3)) <= ctx.ldexp(
                length(ctx, minus) * length(ctx, exact), LOST - BITS
            )
        assert close(ctx, sym3.power(ctx, exact, numbers(ctx, 3.0)), exact @ exact @ exact)


def test_power_is_the_exponential_of_a_multiple_of_the_logarithm(ctx: Any) -> None:
    for matrix, t in drawn("sym3.power", "extrapolation", 5):
        found = sym3.power(ctx, numbers(ctx, matrix), numbers(ctx, t))
        balls = exponential(ctx.mpf(float(t)) * sym3.log(ctx, numbers(ctx, matrix)))
        assert distance(ctx, balls, found) <= ctx.ldexp(length(ctx, found), LOST - BITS)


def test_worked_by_hand(ctx: Any) -> None:
    swap = numbers(ctx, [[0.0, 1, 0], [1, 0, 0], [0, 0, 0]])
    cosh, sinh = ctx.cosh(1), ctx.sinh(1)
    due = numbers(ctx, [[cosh, sinh, 0], [sinh, cosh, 0], [0, 0, 1]])
    assert close(ctx, sym3.exp(ctx, swap), due)
    # The eigenvalues 3, 1 and 1.
    matrix = numbers(ctx, [[2.0, 1, 0], [1, 2, 0], [0, 0, 1]])
    half = ctx.log(3) / 2
    assert close(ctx, sym3.log(ctx, matrix), numbers(ctx, [[half, half, 0], [half, half, 0], [0, 0, 0]]))


@pytest.mark.parametrize(
    ("matrix", "reason"),
    [
        ([[1.0, 1e-5, 0], [-1e-5, 1, 0], [0, 0, 1]], "not symmetric"),
        (np.diag([1.0, 1, np.inf]), "not finite"),
        (np.diag([1.0, -1e-300, 1]), "not positive definite"),
        (np.diag([-1.0, -1, 1]), "not positive definite"),
        (np.zeros((3, 3)), "not positive definite"),
        ([[1.0, 1, 0], [1, 1, 0], [0, 0, 1]], "not positive definite"),
        ([[1.0, 1, 0], [1, 1 - 2.0**-53, 0], [0, 0, 1]], "not positive definite"),
    ],
)
def test_log_refuses(ctx: Any, matrix: Any, reason: str) -> None:
    with pytest.raises(InputError, match=reason):
        sym3.log(ctx, numbers(ctx, matrix))


def test_the_border_is_exact(ctx: Any) -> None:
    matrix = numbers(ctx, [[1.0, 1, 0], [1, 1 + 2.0**-52, 0], [0, 0, 1]])
    eigenvalue = ctx.exp(sym3.log(ctx, matrix).trace())
    assert abs(eigenvalue - ctx.ldexp(ctx.one, -52)) <= ctx.ldexp(ctx.one, LOST - BITS)


REGIMES = [regime.name for regime in find("polar.decompose").regimes if not regime.name.startswith("outside")]


@pytest.mark.parametrize("regime", REGIMES)
def test_polar_factors_are_a_rotation_and_a_stretch(ctx: Any, regime: str) -> None:
    for (matrix,) in drawn("polar.decompose", regime):
        linear = numbers(ctx, matrix)
        rotation, stretch = polar.decompose(ctx, linear)
        unit = identity(ctx, len(matrix))
        assert close(ctx, rotation.T @ rotation, unit)
        assert close(ctx, rotation @ stretch, linear)
        assert close(ctx, stretch, stretch.T)
        # The only symmetric root of L^T L with positive eigenvalues; that they are is told by the leading minors.
        (a, b), (_, d) = stretch[:2, :2]
        assert a > 0
        assert a * d - b * b > 0
        assert close(ctx, stretch @ stretch, linear.T @ linear)


def test_the_rotation_is_the_nearest_one(ctx: Any) -> None:
    for (matrix,) in drawn("so3.log", "off-manifold", 5):
        linear = numbers(ctx, matrix)
        assert close(ctx, polar.decompose(ctx, linear)[0], so3.project(ctx, "matrix", linear))


@pytest.mark.parametrize("matrix", [np.diag([1.0, 1, -1]), np.zeros((2, 2)), [[1.0, 2], [2, 4]], [[0.0, 1], [1, 0]]])
def test_polar_refuses_what_has_no_rotation(ctx: Any, matrix: Any) -> None:
    with pytest.raises(InputError, match="determinant is not positive"):
        polar.decompose(ctx, numbers(ctx, matrix))
