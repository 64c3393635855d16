"""Steady affine maps in float64: double-doubles, exact decisions, ends, special cases and refusals.

The errors in every regime are held in `test_fast_accuracy`, what all functions promise of batches in
`test_fast_kernels`.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.catalogue import CATALOGUE
from affinecert.errors import InputError
from affinecert.fast import _double_double as dd
from affinecert.fast import sam
from affinecert.fast._existence import kind_of_matrix, kind_of_quotient
from affinecert.fast._spectrum import NONE
from affinecert.reference import sam as reference
from affinecert.scoring import block_score
from affinecert.truths import compute

Matrix = NDArray[np.float64]


def affine(linear: Any, translation: Any = None) -> Matrix:
    linear = np.asarray(linear, dtype=float)
    matrix = np.eye(len(linear) + 1)
    matrix[:-1, :-1] = linear
    matrix[:-1, -1] = np.arange(1, len(linear) + 1) if translation is None else translation
    return matrix


def exactly(number: complex) -> Fraction:
    return Fraction(number.real) + Fraction(number.imag)


def double_doubles(count: int) -> list[complex]:
    draw = np.random.default_rng(1)
    high = draw.normal(size=count) * 10.0 ** draw.integers(-20, 21, count)
    return [complex(x, y) for x, y in zip(high, high * draw.uniform(-0.5, 0.5, count) * 2.0**-53, strict=True)]


OPERATIONS: tuple[tuple[Callable[..., complex], Callable[..., Fraction]], ...] = (
    (dd.add, lambda x, y: x + y),
    (dd.subtract, lambda x, y: x - y),
    (dd.multiply, lambda x, y: x * y),
    (dd.divide, lambda x, y: x / y),
)


@pytest.mark.parametrize(("operation", "exact"), OPERATIONS)
def test_double_doubles_keep_104_bits(operation: Callable[..., complex], exact: Callable[..., Fraction]) -> None:
    numbers = double_doubles(400)
    near = [complex(-x.real, x.imag) for x in numbers]  # sums that cancel down to the lower parts
    for a, b in itertools.chain(itertools.pairwise(numbers), zip(numbers, near, strict=True)):
        found, due = operation(a, b), exact(exactly(a), exactly(b))
        assert abs(exactly(found) - due) <= abs(due) * Fraction(1, 2**103)
        assert found.real == found.real + found.imag


def test_square_roots_keep_100_bits() -> None:
    for x in double_doubles(400):
        root, square = exactly(dd.square_root(complex(abs(x.real), x.imag))), exactly(complex(abs(x.real), x.imag))
        assert abs(root * root - square) <= square * Fraction(1, 2**100)


BORDER: dict[str, tuple[Any, bool]] = {
    "-I": (-np.eye(2), True),
    "defective": ([[-1, 1], [0, -1]], False),
    "complex by 1e-300": ([[-1, 1], [-1e-300, -1]], True),
    "real by 1e-300": ([[-1, 1], [1e-300, -1]], False),
    "-I but for one ulp": (np.diag([-1.0, -1.0 - 2.0**-52]), False),
    "trace 0": ([[1, -2], [1, -1]], True),
    "half turn": (np.diag([-1.0, -1.0, 1.0]), True),
    "oblique half turn": (2 * np.outer([1, 2, 2], [1, 2, 2]) - 9 * np.eye(3), True),
    "half turn and a growth": (np.diag([-3e100, -3e100, 1e-100]), True),
    "defective in space": ([[-1, 1, 0], [0, -1, 5], [0, 0, 2]], False),
    "defective by a coupling of 1e-200": ([[-1, 1e-200, 0], [0, -1, 0], [0, 0, 2]], False),
    "complex in space": ([[-1, 1, 0], [-1e-200, -1, 5], [0, 0, 2]], True),
    "positive, ratio 1e600": (np.diag([1e300, 1e-300, 1e-300]), True),
    "negative, ratio 1e600": (np.diag([1e300, -1e-300, -2e-300]), False),
}


@pytest.mark.parametrize("name", BORDER)
def test_existence_at_the_border(name: str) -> None:
    linear, due = BORDER[name]
    assert sam.exists(affine(linear)) == due
    if not due:
        with pytest.raises(InputError, match=r"^affine: no real logarithm"):
            sam.log(affine(linear))


@pytest.mark.parametrize("size", [2, 3])
def test_existence_of_small_integer_matrices(size: int) -> None:
    linear = np.random.default_rng(size).integers(-3, 4, (3000, size, size)).astype(float)
    linear = linear[np.rint(np.linalg.det(linear)) > 0]
    due = [reference.exists_exactly(rows) for rows in linear.tolist()]
    matrices = np.stack([affine(rows) for rows in linear])
    assert sam.exists(matrices).tolist() == due
    assert [kind_of_matrix(rows) != NONE for rows in linear] == due
    # Of C B^-1 for C = A B, with an oblique B of determinant 1.
    start = np.eye(size) + np.eye(size, k=1)
    assert [kind_of_quotient(start, rows @ start) for rows in linear] == [kind_of_matrix(rows) for rows in linear]


def scaled_errors(name: str, inputs: Sequence[Any], outputs: Any) -> list[float]:
    entry = CATALOGUE[name]
    truth = compute(entry, tuple(np.asarray(x, dtype=float) for x in inputs))
    assert truth.refusal is None
    return [
        block_score(block.name, outputs[block.where], truth.high[0][block.where], truth.low[0][block.where], k).scaled
        for block, k in zip(entry.blocks, truth.sensitivity, strict=True)
    ]


HARD: dict[str, Any] = {
    "eigenvalues 1, 1, 1, defective": [[1, 1, 0], [0, 1, 1], [0, 0, 1]],
    "triple by 1e-8": [[2, 1, 0], [0, 2, 1], [1e-24, 0, 2]],
    "triple by 1e-3": [[2, 1, 0], [0, 2, 1], [1e-9, 0, 2]],
    "triple by 0.1": [[2, 1, 0], [0, 2, 1], [1e-3, 0, 2]],
    "double next to a third": [[2, 1e8, 0], [0, 2, 3], [0, 0, 2.000001]],
    "next to 1": np.diag([1 + 2.0**-52, 1 - 2.0**-52, 1 + 1e-9]),
    "sizes 1e40": [[1e-40, 3, 5], [0, 2e-40, 1], [0, 0, 1]],
    "small third": [[2, 1, 1], [-3, 2, 1], [0, 0, 1e-30]],
    "small pair": [[1e-20, 1e-20, 1], [-2e-20, 3e-20, 1], [0, 0, 1]],
    "far from normal": [[1, 1e10, 1e20], [0, 2, 1e10], [0, 0, 3]],
    "next to the border": [[-1, 1, 0], [-1e-24, -1, 5], [0, 0, 2]],
    "at the border": [[-1, 1, 0], [-1e-300, -1, 5], [0, 0, 2]],
    "half turn": np.diag([-2.0, -2.0, 0.5]),
    "oblique half turn": [[-5, 0, 0], [0, -5, 0], [4, 8, 3]],
    "rotation by 1e-200": [[1, -1e-200, 0], [1e-200, 1, 0], [0, 0, 1]],
}


@pytest.mark.parametrize("name", HARD)
def test_hard_spectra(name: str) -> None:
    matrix = affine(HARD[name])
    assert max(scaled_errors("sam.log", (matrix,), sam.log(matrix))) <= 8.0
    for t in (0.3, 2.0, -1.0, 1e-20, 1.0 + 2.0**-52):
        assert max(scaled_errors("sam.power", (matrix, t), sam.power(matrix, t))) <= 8.0
    # C = A B without rounding, the columns of B being those of a multiple of I in another order.
    start = affine(np.diag([2.0**-30, 1.0, 2.0**20])[[1, 2, 0]], [1e9, -3, 1])
    end = affine(matrix[:3, :3] @ start[:3, :3])
    assert max(scaled_errors("sam.morph", (start, end, 0.4), sam.morph(start, end, 0.4))) <= 8.0


def test_powers_end_exactly() -> None:
    matrix = affine([[0.3, -2, 1e5], [1, 0.1, 7], [0, 0, 1e-9]])
    assert np.array_equal(sam.power(matrix, [0.0, 1.0]), [np.eye(4), matrix])
    start = affine([[3, 1, 0], [0, 1e-3, 5], [0, 0.5, 2600]])
    assert np.array_equal(sam.morph(start, matrix @ start, [0.0, 1.0]), [start, matrix @ start])


def test_a_half_turn_in_the_plane_turns_to_the_left() -> None:
    turn = affine(-4 * np.eye(2), [0, 0])
    assert np.allclose(sam.log(turn)[:2, :2], [[math.log(4), -math.pi], [math.pi, math.log(4)]], rtol=1e-15, atol=0)
    assert np.allclose(sam.power(turn, 0.5)[:2, :2], [[0, -2], [2, 0]], rtol=0, atol=1e-15)


@pytest.mark.parametrize("axis", [[1, 2, 2], [0, 3, -4], [0, 0, -5], [-2, 1, 2]])
def test_a_half_turn_in_space_is_about_the_axis_that_begins_positive(axis: list[int]) -> None:
    square = np.dot(axis, axis)
    turn = affine(2 * np.outer(axis, axis) - square * np.eye(3), [0, 0, 0])
    x, y, z = np.array(axis) / math.sqrt(square) * np.sign(next(a for a in axis if a)) * math.pi
    due = math.log(square) * np.eye(3) + [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    assert np.allclose(sam.log(turn)[:3, :3], due, rtol=0, atol=1e-14)


@pytest.mark.parametrize("size", [2, 3])
def test_graded_matrices_give_finite_numbers(size: int) -> None:
    draw = np.random.default_rng(size)
    for _ in range(300):
        linear = 10.0 ** draw.uniform(-140, 140, (size, size)) * draw.choice([-1.0, 1.0], (size, size))
        try:
            logarithm = sam.log(affine(linear))
        except InputError:
            continue
        assert np.isfinite(logarithm).all()
        assert np.isfinite(sam.power(affine(linear), draw.uniform(0, 1))).all()


def test_fixed_points_next_to_none() -> None:
    unit = affine([[2, 1], [1, 2]])
    with pytest.raises(InputError, match=r"^affine\[1\]: degenerate: no unique fixed point"):
        sam.fixed_point(np.stack([2 * np.eye(3) - np.diag([0, 0, 1]), unit]))
    unit[0, 1] = np.nextafter(1, 2)
    ulp = Fraction(1, 2**52)
    due = [float(-(1 + 2 * ulp) / ulp), float(1 / ulp)]
    assert sam.fixed_point(unit).tolist() == pytest.approx(due, rel=1e-15)
    # So near to singular that only integers tell.
    tiny = affine([[1 + 2.0**-52, 1], [0, 1 - 2.0**-53]], [2.0**-400, 2.0**-500])
    tiny[1, 0] = -(2.0**-300)
    assert scaled_errors("sam.fixed_point", (tiny,), sam.fixed_point(tiny))[0] <= 8.0


def test_refusals_of_a_morph_name_the_pose() -> None:
    good, mirror, flat = affine(np.eye(2)), affine(np.diag([1.0, -1.0])), affine(np.zeros((2, 2)))
    for bad in (mirror, flat):
        with pytest.raises(InputError, match=r"^start\[1\]: the determinant"):
            sam.morph(np.stack([good, bad]), good, 0.5)
        with pytest.raises(InputError, match=r"^end\[2\]: the determinant"):
            sam.morph(good, np.stack([good, good, bad]), [[0.5], [0.6]])
    with pytest.raises(InputError, match=r"^start: the determinant"):
        sam.morph(mirror, mirror, 0.5)
    with pytest.raises(InputError, match=r"^end: no real logarithm"):
        sam.morph(good, affine(np.diag([-1.0, -2.0])), 0.5)
    with pytest.raises(InputError, match=r"^start: the last row"):
        sam.morph(np.ones((3, 3)), good, 0.5)
    with pytest.raises(InputError, match=r"^end: the last row"):
        sam.morph(good, np.ones((3, 3)), 0.5)
    with pytest.raises(InputError, match=r"^t: not finite"):
        sam.morph(good, good, math.nan)


@pytest.mark.parametrize("function", [sam.exists, sam.log, sam.fixed_point])
def test_refusals_of_a_map(function: Callable[..., Any]) -> None:
    for bad, reason in ((np.diag([1.0, -1.0, 1.0]), "the determinant"), (np.ones((3, 3)), "the last row")):
        with pytest.raises(InputError, match=rf"^affine\[0, 1\]: {reason}"):
            function(np.stack([affine(3 * np.eye(2)), bad])[None])


@pytest.mark.parametrize("gap", [1e-8, 1e-16, 2e-17, 1e-20, 1e-60])
def test_a_rotation_all_but_by_pi_keeps_its_logarithm(gap: float) -> None:
    # From 2e-17 on double-doubles take the pair -1 +- gap i for a double eigenvalue; integers tell it apart.
    plane = np.array([[-1.0, -gap, 0.0], [gap, -1.0, 0.0], [0.0, 0.0, 1.0]])
    assert sam.log(plane)[1, 0] == pytest.approx(np.pi - gap, rel=1e-15)
    assert np.allclose(sam.power(plane, 0.5)[:2, :2], [[gap / 2, -1.0], [1.0, gap / 2]], rtol=1e-15, atol=1e-15)
    space = np.eye(4)
    space[1:3, 1:3] = plane[:2, :2]
    assert sam.log(space)[2, 1] == pytest.approx(np.pi - gap, rel=1e-15)
    morph = sam.morph(np.eye(4), space, 0.5)
    assert morph[2, 1] == pytest.approx(1.0, rel=1e-15)
