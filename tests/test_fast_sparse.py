"""Refinement by conjugate gradients: to the last bit with poor factors, and an end where there is no solution."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.fast import _wide as wide
from affinecert.fast._sparse import factored, pattern, refined

Array = NDArray[Any]
SIZE = 6


def definite(seed: int, values: Array) -> Array:
    """A symmetric matrix with those eigenvalues, but for rounding, and eigenvectors that the seed tells."""
    turn = np.linalg.qr(np.random.default_rng(seed).normal(size=(SIZE, SIZE)))[0]
    matrix = np.asarray(turn @ np.diag(values) @ turn.T)
    return np.asarray((matrix + matrix.T) / 2)


def solution(matrix: Array, right: Array) -> list[Fraction]:
    """The solution of equations of float64, exactly."""
    rows = [[Fraction(x) for x in [*row, b]] for row, b in zip(matrix.tolist(), right.tolist(), strict=True)]
    for k in range(SIZE):
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(SIZE):
            if i != k:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k], strict=True)]
    return [row[-1] for row in rows]


def slope(matrix: Array, right: Array) -> Any:
    """What equations leave, pairs."""

    def of(x: Array) -> Array:
        return wide.subtract(wide.widen(right), wide.product(wide.widen(matrix), x[:, None])[:, 0])

    return of


@pytest.mark.parametrize("ratio", [1e-3, 1e-9, 1e-12])
@pytest.mark.parametrize("factors", [[1.0] * 6, [0.5, 0.75, 1, 1.25, 1.5, 2], [1, 1, 1, 1, 30, 1000]], ids=str)
def test_the_solution_is_found_to_more_than_its_rounding(ratio: float, factors: list[float]) -> None:
    """Steps are those of a matrix with eigenvalues that many times as large."""
    values = np.geomspace(1.0, ratio, SIZE)
    for seed in range(3):
        matrix, poor = definite(seed, values), definite(seed, 1 / (values * factors))
        right = np.random.default_rng(seed).normal(size=SIZE)
        found = refined(np.zeros((SIZE, 2)), slope(matrix, right), poor.__matmul__)
        assert found is not None
        exact = solution(matrix, right)
        missed = [abs(Fraction(high) + Fraction(low) - x) for (high, low), x in zip(found.tolist(), exact, strict=True)]
        assert max(missed) <= 2.0**-60 * max(factors) * max(abs(x) for x in exact)


def test_equations_without_a_solution_have_none() -> None:
    matrix = np.diag([1.0, 1.0, 1.0, 1.0, 1.0, 0.0])
    assert refined(np.zeros((SIZE, 2)), slope(matrix, np.ones(SIZE)), lambda rest: rest) is None
    never = refined(np.zeros((SIZE, 2)), slope(matrix, np.ones(SIZE)), lambda rest: np.full(SIZE, np.nan))
    assert never is None
    assert not refined(np.zeros((SIZE, 2)), slope(matrix, np.zeros(SIZE)), lambda rest: rest).any()  # type: ignore[union-attr]


def test_a_pattern_adds_what_meets_and_leaves_out_what_is_given() -> None:
    triangles = np.array([[0, 1, 2], [2, 1, 3]])
    free = np.array([True, True, True, False])
    blocks = np.arange(18.0).reshape(2, 3, 3) + 1j
    made = pattern(triangles, np.array([0]), np.array([2]), free).matrix(np.append(blocks.ravel(), 100.0)).toarray()
    due = np.zeros((4, 4), dtype=complex)
    for triple, block in zip(triangles, blocks, strict=True):
        due[np.ix_(triple, triple)] += block
    due[0, 2] += 100.0
    due[3], due[:, 3], due[3, 3] = 0.0, 0.0, 1.0
    assert np.allclose(made, due, rtol=2.0**-49)


def test_a_singular_matrix_has_no_factors() -> None:
    triangles = np.array([[0, 1, 2]])
    none = np.empty(0, dtype=np.intp)
    assert factored(pattern(triangles, none, none, np.ones(3, dtype=bool)).matrix(np.zeros(9))) is None
