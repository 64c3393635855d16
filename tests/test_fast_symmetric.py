"""Symmetric matrices and polar factors in double-double: what is exact, what is close to it, and where they end.

The errors in every regime are held in `test_fast_accuracy`, what all functions promise of batches in
`test_fast_kernels`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from affinecert.case import generate
from affinecert.catalogue import find, stretches
from affinecert.errors import InputError
from affinecert.fast import polar, sym3
from affinecert.fast._exact import definiteness
from affinecert.fast._wide import rounded, widen
from affinecert.fast._wide_polar import polar as wide_polar
from affinecert.fast._wide_symmetric import symmetric_exponential, symmetric_logarithm, symmetric_power
from affinecert.reference import polar as reference_polar
from affinecert.reference import sym3 as reference
from affinecert.reference._domain import positive_definite

from .enclosures import Numbers, context, length, numbers

CTX = context(600)
WIDE = 2.0**-95
"""What double-doubles of 106 bits keep of the norm, and of the matrix against rounding it."""


def exactly(pairs: Any) -> Numbers:
    high, low = (numbers(CTX, pairs[..., part]) for part in range(2))
    return np.asarray(high + low)


def error(pairs: Any, due: Numbers) -> float:
    return float(length(CTX, exactly(pairs) - due) / length(CTX, due))


def drawn(name: str, regime: str, count: int) -> list[Any]:
    (chosen,) = (candidate for candidate in find(name).regimes if candidate.name == regime)
    return [case.inputs[0] for case in generate(find(name), chosen, count)]


@pytest.mark.parametrize("regime", ["generic", "meeting", "triple", "near-identity", "diagonal"])
def test_functions_of_symmetric_matrices_keep_95_bits(regime: str) -> None:
    for matrix in drawn("sym3.log", regime, 4):
        part, given = numbers(CTX, matrix), widen(matrix)
        assert error(symmetric_power(given, np.array(-0.75)), reference.power(CTX, part, numbers(CTX, -0.75))) <= WIDE
        logarithm = reference.log(CTX, part)
        assert length(CTX, exactly(symmetric_logarithm(given)) - logarithm) <= WIDE * (1 + length(CTX, logarithm))
        if np.max(np.abs(matrix)) < 100.0:
            assert error(symmetric_exponential(given), reference.exp(CTX, part)) <= WIDE


def test_small_eigenvalues_of_graded_matrices_are_accurate() -> None:
    for matrix in drawn("sym3.log", "graded", 10):
        due = reference.power(CTX, numbers(CTX, matrix), numbers(CTX, -1.0))
        assert error(symmetric_power(widen(matrix), np.array(-1.0)), due) <= WIDE


@pytest.mark.parametrize("regime", ["generic-2d", "generic-3d", "near-rotation-3d", "meeting-3d", "huge-or-tiny-3d"])
def test_polar_factors_keep_95_bits(regime: str) -> None:
    for matrix in drawn("polar.decompose", regime, 4):
        rotation, stretch = wide_polar(widen(matrix))
        due = reference_polar.decompose(CTX, numbers(CTX, matrix))
        assert error(rotation, due[0]) <= WIDE
        assert error(stretch, due[1]) <= WIDE


@pytest.mark.parametrize("regime", ["nearly-rank-one-3d", "last-bits-3d", "diagonal-3d"])
def test_the_rotation_is_one_however_near_the_matrix_is_to_singular(regime: str) -> None:
    for matrix in drawn("polar.decompose", regime, 10):
        rotation = exactly(wide_polar(widen(matrix))[0])
        assert length(CTX, rotation.T @ rotation - numbers(CTX, np.eye(3))) <= WIDE


@pytest.mark.parametrize("column", [(1.0, -1.0, 1.0), (0.0, 0.0, 3.0), (1e-200, 0.0, 2.0)])
def test_rank_one_in_double_double_still_gives_a_rotation(column: Any) -> None:
    # In rational numbers these are regular; their two smaller singular values are below any double-double.
    matrix = np.outer(column, [1.0, 2.0, 0.5]) + 0.0
    rotation = exactly(wide_polar(widen(matrix))[0])
    assert length(CTX, rotation.T @ rotation - numbers(CTX, np.eye(3))) <= WIDE


def test_rotations_and_diagonal_stretches_with_whole_entries_are_exact() -> None:
    for turn in np.array(
        [np.eye(3), [[0, -1, 0], [1, 0, 0], [0, 0, 1.0]], np.eye(3)[[1, 2, 0]], np.diag([-1.0, -1, 1])]
    ):
        for stretch in (np.diag([1.0, 2.0, 3.0]), np.diag([5.0, 5.0, 5.0]), np.diag([1e-150, 1e150, 1.0])):
            rotation, found = polar.decompose(turn @ stretch)
            assert np.array_equal(rotation, turn)
            assert np.array_equal(found, stretch)


def test_exponential_of_zero_and_powers_at_the_ends_are_exact() -> None:
    assert np.array_equal(sym3.exp(np.zeros((3, 3))), np.eye(3))
    matrix = np.stack(drawn("sym3.log", "generic", 6))
    assert np.array_equal(sym3.power(matrix, 0.0), np.broadcast_to(np.eye(3), matrix.shape))
    assert np.array_equal(sym3.power(matrix, 1.0), matrix)


def test_results_are_exactly_symmetric() -> None:
    for function, name in ((sym3.exp, "sym3.exp"), (sym3.log, "sym3.log")):
        result = function(np.stack(drawn(name, "asymmetric", 8)))
        assert np.array_equal(result, np.swapaxes(result, -1, -2))


def test_beyond_the_range_entries_are_infinite_or_zero() -> None:
    assert np.array_equal(sym3.exp(np.diag([1200.0, 0.0, -1200.0])), np.diag([np.inf, 1.0, 0.0]))
    assert np.array_equal(sym3.exp(np.diag([1e300, 1e300, -1e300])), np.diag([np.inf, np.inf, 0.0]))
    # Eigenvectors (1, -2, 0) of 1e5 and (2, 1, 0) of 0: the signs are those of the larger one.
    signs = sym3.exp(1e4 * np.array([[2.0, -4, 0], [-4, 8, 0], [0, 0, 0]]))[:2, :2]
    assert np.array_equal(signs, [[np.inf, -np.inf], [-np.inf, np.inf]])
    assert np.array_equal(sym3.power(np.diag([4.0, 1.0, 0.25]), 600.0), np.diag([np.inf, 1.0, 0.0]))
    # 1000 log 2 each way: no intermediate result may overflow where the result does not.
    assert sym3.power(np.diag([2.0, 1.0, 1.0]), 1000.0)[0, 0] == 2.0**1000
    assert np.array_equal(sym3.log(sym3.power(np.diag([2.0, 4.0, 8.0]), 300.0)), 300 * np.log(2) * np.diag([1.0, 2, 3]))


@pytest.mark.parametrize("count", [60])
def test_positive_definiteness_is_decided_exactly(count: int) -> None:
    for matrix in drawn("sym3.log", "last-bits", count):
        assert definiteness(matrix) == 1.0
        sym3.log(matrix)
        for place in range(3):
            less = matrix.copy()
            less[place, place] -= 1.0
            with pytest.raises(InputError, match="not positive definite"):
                positive_definite("matrix", numbers(CTX, less))
            with pytest.raises(InputError, match=r"^matrix: not positive definite"):
                sym3.log(less)


def test_the_refused_item_is_named_in_its_own_batch() -> None:
    good, bad = np.eye(3), np.diag([1.0, 1.0, -1.0])
    with pytest.raises(InputError, match=r"^matrix\[1\]: not positive definite"):
        sym3.power(np.stack([good, bad]), np.zeros((4, 2)))
    with pytest.raises(InputError, match=r"^matrix\[1\]: not symmetric"):
        sym3.exp(np.stack([good, np.triu(np.ones((3, 3)))]))
    with pytest.raises(InputError, match=r"^linear\[1\]: the determinant is not positive"):
        polar.decompose(np.stack([good, bad]))


def test_every_kind_of_stretch_outside_is_refused_and_no_other() -> None:
    for kind in stretches.POSITIVE_DEFINITE:
        for matrix in drawn("sym3.log", kind.name, 6):
            if kind is stretches.OUTSIDE:
                with pytest.raises(InputError):
                    sym3.log(matrix)
            else:
                assert np.isfinite(sym3.log(matrix)).all()


def test_pairs_are_rounded_once() -> None:
    matrix = np.stack(drawn("polar.decompose", "generic-3d", 5))
    rotation, stretch = polar.decompose(matrix)
    wide_rotation, wide_stretch = wide_polar(widen(matrix))
    assert np.array_equal(rotation, rounded(wide_rotation))
    assert np.array_equal(stretch, rounded(wide_stretch))
