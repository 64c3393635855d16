"""Existence of a real logarithm: the exact decision against cases known by hand and against factored polynomials."""

from __future__ import annotations

from typing import Any

import flint
import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import sam
from affinecert.reference._existence import Logarithm, logarithm

from .enclosures import context, numbers

ULP = 2.0**-52

PLANE = {
    "identity": ([[1, 0], [0, 1]], True),
    "half turn": ([[-2, 0], [0, -2]], True),
    "half turn, tiny": ([[-5e-324, 0], [0, -5e-324]], True),
    "distinct negative": ([[-2, 0], [0, -2 - 2 * ULP]], False),
    "defective": ([[-1, 1e-300], [0, -1]], False),
    "complex pair next to the axis": ([[-1, 1e-300], [-1e-300, -1]], True),
    "complex pair by one ulp": ([[-1, 1], [-5e-324, -1]], True),
    "real pair by one ulp": ([[-1, 1], [5e-324, -1]], False),
    "double by cancellation": ([[-3, 1], [-1, -1]], False),
    "quarter turn": ([[0, -1], [1, 0]], True),
    "positive pair": ([[3, 1], [1, 3]], True),
}

SPACE = {
    "identity": (np.eye(3), True),
    "half turn": (np.diag([-1.0, 1, -1]), True),
    "half turn with a scale": (np.diag([7.0, -3, -3]), True),
    "distinct negative": (np.diag([-1.0, -1 - ULP, 1]), False),
    "negative, scales apart": (np.diag([-1e150, -1e-150, 1]), False),
    "defective": ([[-1, 1, 0], [0, -1, 0], [0, 0, 2]], False),
    "defective by the last bit": ([[-1, 5e-324, 0], [0, -1, 0], [0, 0, 2]], False),
    "half turn in a slanted plane": ([[-1, 0, 5], [0, -1, -7], [0, 0, 2]], True),
    "half turn about the diagonal": ([[-0.375, 0.625, 0.625], [0.625, -0.375, 0.625], [0.625, 0.625, -0.375]], True),
    "half turn about the diagonal but for an ulp": (
        [[-0.375 - ULP / 4, 0.625, 0.625], [0.625, -0.375, 0.625], [0.625, 0.625, -0.375]],
        False,
    ),
    "irrational complex pair": ([[0, 0, 2], [1, 0, 0], [0, 1, 0]], True),
    "irrational negative pair": ([[-2, 1, 0], [1, -1, 0], [0, 0, 1]], False),
    "irrational negative pair, coupled": ([[-2, 1, 3], [1, -1, 5], [0, 0, 1]], False),
    "three distinct positive": ([[2, 1, 0], [1, 3, 1], [0, 1, 4]], True),
    "triple positive, defective": ([[2, 1, 0], [0, 2, 1], [0, 0, 2]], True),
}


@pytest.mark.parametrize(("matrix", "expected"), [*PLANE.values(), *SPACE.values()], ids=[*PLANE, *SPACE])
@pytest.mark.parametrize("scale", [1.0, 2.0**400])
def test_cases_by_hand(matrix: Any, expected: bool, scale: float) -> None:
    linear = np.asarray(matrix, dtype=float) * scale
    affine = np.eye(len(linear) + 1)
    affine[:-1, :-1] = linear
    affine[:-1, -1] = 3.0
    assert sam.exists_exactly(linear.tolist()) is expected
    assert sam.exists(context(), numbers(context(), affine)) is expected


def expected_kind(entries: list[list[int]]) -> Logarithm:
    """Culver's condition by factoring the characteristic polynomial and by the rank of L - lambda."""
    matrix = flint.fmpz_mat(entries)
    roots: list[Any] = matrix.charpoly().complex_roots()
    negative = [(root.real, multiplicity) for root, multiplicity in roots if root.imag.is_zero() and root.real < 0]
    if not negative:
        return Logarithm.PRINCIPAL
    if any(multiplicity != 2 for _, multiplicity in negative):
        return Logarithm.NONE
    # A double root of a monic integer polynomial of degree at most 3 is an integer.
    root = negative[0][0].unique_fmpz()
    size = len(entries)
    shifted = flint.fmpz_mat([[x - (root if i == j else 0) for j, x in enumerate(r)] for i, r in enumerate(entries)])
    return Logarithm.HALF_TURN if shifted.rank() == size - 2 else Logarithm.NONE


@pytest.mark.parametrize("size", [2, 3])
def test_small_integer_matrices_against_factored_polynomials(size: int) -> None:
    draw = np.random.default_rng(size)
    kinds = set()
    for _ in range(3000):
        entries = draw.integers(-3, 4, size=(size, size)).tolist()
        if round(np.linalg.det(entries)) > 0:
            kind = logarithm(entries)
            assert kind is expected_kind(entries), entries
            kinds.add(kind)
    assert Logarithm.NONE in kinds and Logarithm.PRINCIPAL in kinds


def test_half_turns_in_slanted_frames() -> None:
    """V diag(-s, -s, mu) adj V, V integer of determinant d: an exact double eigenvalue -s d; a nudge destroys it."""
    draw = np.random.default_rng(5)
    for _ in range(300):
        frame = draw.integers(-4, 5, size=(3, 3))
        d = round(np.linalg.det(frame))
        if d == 0:
            continue
        adjugate = np.array([[int(x) for x in row] for row in np.round(np.linalg.inv(frame) * d)])
        s, mu = int(draw.integers(1, 9)), int(draw.integers(1, 9))
        matrix = frame @ np.diag([-s, -s, mu]) @ adjugate * np.sign(d)
        assert logarithm(matrix.tolist()) is Logarithm.HALF_TURN
        matrix = frame @ np.array([[-s, 1, 0], [0, -s, 0], [0, 0, mu]]) @ adjugate * np.sign(d)
        assert logarithm(matrix.tolist()) is Logarithm.NONE


@pytest.mark.parametrize("linear", [np.diag([1.0, -1.0]), np.diag([-1.0, -1, -1]), np.zeros((3, 3)), np.ones((2, 2))])
def test_refuses_a_determinant_that_is_not_positive(linear: Any) -> None:
    with pytest.raises(InputError, match="determinant"):
        sam.exists_exactly(linear.tolist())
