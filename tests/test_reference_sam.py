"""Steady affine motions of the reference: exponentials enclosed by Arb, the principal strip, special cases by hand."""

from __future__ import annotations

import itertools
from typing import Any

import flint
import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import sam, so3
from affinecert.reference._matrices import identity

from . import enclosures
from .enclosures import Numbers, ball, context, distance, length, numbers

BITS = 400
LOST = 60


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def homogeneous(linear: Any, translation: Any = None) -> np.ndarray[Any, Any]:
    linear = np.asarray(linear, dtype=float)
    affine = np.eye(len(linear) + 1)
    affine[:-1, :-1] = linear
    affine[:-1, -1] = np.arange(1, len(linear) + 1) if translation is None else translation
    return affine


def close(ctx: Any, found: Numbers, expected: Any, lost: int = LOST) -> bool:
    expected = numbers(ctx, expected)
    return bool(length(ctx, found - expected) <= ctx.ldexp(length(ctx, expected) + ctx.one, lost - BITS))


def random_maps(size: int, spread: float, count: int = 12) -> list[np.ndarray[Any, Any]]:
    """Affine maps near the identity and far from it that have a logarithm."""
    draw = np.random.default_rng(size)
    maps: list[np.ndarray[Any, Any]] = []
    while len(maps) < count:
        linear = np.eye(size) + spread * draw.normal(size=(size, size))
        if np.linalg.det(linear) > 0 and sam.exists_exactly(linear.tolist()):
            maps.append(homogeneous(linear, draw.normal(size=size)))
    return maps


SPECIAL = {
    "unit eigenvalue, 2d": [[1, 0], [0, 3]],
    "unit eigenvalue, slanted, 2d": [[2, 1], [1, 2]],
    "unit eigenvalue, double, defective, 2d": [[1, 1], [0, 1]],
    "defective, 2d": [[3, 1], [0, 3]],
    "defective to one ulp, 2d": [[3, 1], [1e-300, 3]],
    "gap 1e-15, 2d": [[3, 1], [0, 3 + 3.6e-15]],
    "complex pair, gap 1e-200, 2d": [[3, 1], [-1e-200, 3]],
    "next to the border, 2d": [[-1, 1], [-1e-30, -1]],
    "double, 3d": np.diag([2.0, 2, 5]),
    "unit eigenvalue, 3d": np.diag([1.0, 2, 5]),
    "unit eigenvalue, double, 3d": np.diag([1.0, 1, 5]),
    "unit eigenvalue, double, defective, 3d": [[1, 1, 0], [0, 1, 0], [0, 0, 5]],
    "unit eigenvalue, triple, defective, 3d": [[1, 1, 0], [0, 1, 1], [0, 0, 1]],
    "triple, defective, 3d": [[4, 1, 2], [0, 4, 3], [0, 0, 4]],
    "triple, one block of two, 3d": [[4, 1, 0], [0, 4, 0], [0, 0, 4]],
    "triple to one ulp, 3d": [[4, 1, 2], [1e-300, 4, 3], [0, 0, 4 + 1e-15]],
    "double and one near, 3d": [[4, 1, 2], [0, 4, 3], [0, 0, 4 + 1e-15]],
    "rotation, 3d": [[0, 0, 1], [1, 0, 0], [0, 1, 0]],
    "next to the border, 3d": [[-1, 1, 0], [-1e-40, -1, 0], [0, 3, 2]],
    "scales apart, 3d": [[1e100, 3, 1], [2, 1, 0], [1, 0, 1e-90]],
}


def all_maps() -> list[np.ndarray[Any, Any]]:
    drawn = [m for size, spread in itertools.product((2, 3), (1e-9, 0.3, 2.0)) for m in random_maps(size, spread, 4)]
    return [*(homogeneous(linear) for linear in SPECIAL.values()), *drawn]


@pytest.mark.parametrize("affine", all_maps())
def test_exp_of_log_is_the_map(ctx: Any, affine: Any) -> None:
    exact = numbers(ctx, affine)
    with ctx.workprec(BITS + 2000):  # for what the exponential of huge entries cancels
        balls = enclosures.exponential(sam.log(ctx, exact), 4000)
    for block in (np.s_[:-1, :-1], np.s_[:-1, -1:]):
        size = len(exact) - 1
        columns = range(size) if block[1] != np.s_[-1:] else range(size, size + 1)
        part = flint.arb_mat([[balls[i, j] for j in columns] for i in range(size)])
        assert distance(ctx, part, exact[block]) <= ctx.ldexp(length(ctx, exact[block]), LOST - BITS)


@pytest.mark.parametrize(
    "affine", [m for size, spread in itertools.product((2, 3), (0.3, 2.0)) for m in random_maps(size, spread)]
)
def test_eigenvalues_of_log_lie_in_the_principal_strip(ctx: Any, affine: Any) -> None:
    logarithm = sam.log(ctx, numbers(ctx, affine))[:-1, :-1]
    with flint.ctx.workprec(BITS):
        values = flint.acb_mat(flint.arb_mat([[ball(x) for x in row] for row in logarithm])).eig()
        assert all(abs(value.imag) < flint.arb.pi() for value in values)


def test_log_at_the_border_has_an_angle_just_below_pi(ctx: Any) -> None:
    """In 2D trace and determinant of the logarithm give its eigenvalues: the angle is sqrt(det - trace^2 / 4)."""
    for tiny in (1e-10, 1e-100, 5e-324):
        logarithm = sam.log(ctx, numbers(ctx, homogeneous([[-1, 1], [-tiny, -1]])))[:-1, :-1]
        with ctx.workprec(2500):
            trace = logarithm[0, 0] + logarithm[1, 1]
            angle = ctx.sqrt(logarithm[0, 0] * logarithm[1, 1] - logarithm[0, 1] * logarithm[1, 0] - trace * trace / 4)
            expected = ctx.pi - ctx.atan(ctx.sqrt(ctx.mpf(tiny)))
            assert abs(angle - expected) <= ctx.ldexp(ctx.one, LOST - BITS)


@pytest.mark.parametrize("affine", all_maps())
@pytest.mark.parametrize("t", [0.3, -1.7])
def test_powers_are_exponentials_of_multiples(ctx: Any, affine: Any, t: float) -> None:
    exact = numbers(ctx, affine)
    found = sam.power(ctx, exact, numbers(ctx, t))
    with ctx.workprec(BITS + 2000):
        balls = enclosures.exponential(sam.log(ctx, exact) * ctx.mpf(t), 4000)
    assert distance(ctx, balls, found) <= ctx.ldexp(length(ctx, found), LOST - BITS)


@pytest.mark.parametrize("linear", [*SPECIAL.values(), np.diag([-2.0, -2]), np.diag([-2.0, 5, -2])])
def test_whole_powers_are_products(ctx: Any, linear: Any) -> None:
    exact = numbers(ctx, homogeneous(linear))
    with ctx.workprec(BITS + 2000):
        powers = {k: sam.power(ctx, exact, numbers(ctx, float(k))) for k in (0, 1, 3, -1)}
    assert close(ctx, powers[0], identity(ctx, len(exact)))
    assert close(ctx, powers[1], exact)
    with ctx.workprec(4000):
        assert close(ctx, powers[3], exact @ exact @ exact)
        assert close(ctx, powers[-1] @ exact, identity(ctx, len(exact)), LOST + 700)


def test_the_identity_and_translations(ctx: Any) -> None:
    for size in (2, 3):
        shift = numbers(ctx, np.linspace(0.5, 2, size))
        translation = homogeneous(np.eye(size), shift.astype(float))
        expected = np.zeros((size + 1, size + 1))
        expected[:-1, -1] = shift.astype(float)
        assert np.array_equal(sam.log(ctx, numbers(ctx, translation)), numbers(ctx, expected))
        half = sam.power(ctx, numbers(ctx, translation), numbers(ctx, 0.5))
        assert np.array_equal(half[:-1, -1], shift / 2)


def test_log_next_to_the_identity_keeps_its_relative_accuracy(ctx: Any) -> None:
    linear = np.eye(3)
    linear[0, 1], linear[1, 0], linear[2, 0] = 3e-200, -1e-200, 2e-250
    found = sam.log(ctx, numbers(ctx, homogeneous(linear)))[:-1, :-1]
    with ctx.workprec(3000):
        first = numbers(ctx, linear - np.eye(3))
        assert length(ctx, found - (first - first @ first / 2)) <= 1e-110 * 1e-200


def test_half_turns_by_hand(ctx: Any) -> None:
    log2 = ctx.log(2)
    plane = sam.log(ctx, numbers(ctx, homogeneous(np.diag([-2.0, -2]), [0, 0])))
    assert close(ctx, plane, [[log2, -ctx.pi, 0], [ctx.pi, log2, 0], [0, 0, 0]])
    # Eigenplane z = x, of normal (-1, 0, 1): its first component is made positive.
    linear = [[-1.0, 0, 0], [0, -1, 0], [-3, 0, 2]]
    space = sam.log(ctx, numbers(ctx, homogeneous(linear, [0, 0, 0])))[:-1, :-1]
    root = ctx.sqrt(ctx.mpf(0.5))
    turned = space @ numbers(ctx, [1.0, 0, 1])
    assert close(ctx, turned, ctx.pi * numbers(ctx, [0, -2 * root, 0]))
    assert close(ctx, space @ numbers(ctx, [0.0, 0, 1]), [0, 0, log2])


def test_half_turn_rotations_are_those_of_so3(ctx: Any) -> None:
    for matrix in (np.diag([-1.0, 1, -1]), [[0.0, -1, 0], [-1, 0, 0], [0, 0, -1]]):
        rotation = numbers(ctx, matrix)
        found = sam.log(ctx, numbers(ctx, homogeneous(matrix)))[:-1, :-1]
        omega = so3.log(ctx, rotation)
        assert close(ctx, found @ numbers(ctx, [1.0, 2, 3]), np.cross(omega, numbers(ctx, [1.0, 2, 3])))


def test_rotations_have_the_logarithm_of_so3(ctx: Any) -> None:
    for angle in (1e-12, 1.0, 3.1415):
        with ctx.workprec(BITS + 400):
            omega = numbers(ctx, np.array([2.0, -1, 2]) / 3 * angle)
            affine = numbers(ctx, np.eye(4))
            affine[:3, :3] = so3.exp(ctx, omega)
            found = sam.log(ctx, affine)
        assert close(ctx, found[[2, 0, 1], [1, 2, 0]], omega)


@pytest.mark.parametrize("size", [2, 3])
def test_morphs_run_from_start_to_end_steadily(ctx: Any, size: int) -> None:
    for start, change in zip(random_maps(size, 0.3), random_maps(size, 1.0), strict=True):
        end = change @ start
        b, c = numbers(ctx, start), numbers(ctx, end)
        at = {t: sam.morph(ctx, b, c, numbers(ctx, t)) for t in (0.0, 0.25, 0.5, 1.0, 2.0)}
        assert close(ctx, at[0.0], b)
        assert close(ctx, at[1.0], c)
        inverse = sam.power(ctx, b, numbers(ctx, -1.0))
        assert close(ctx, at[2.0], c @ inverse @ c)
        assert close(ctx, at[0.5], at[0.25] @ inverse @ at[0.25])


def test_morph_decides_a_half_turn_exactly(ctx: Any) -> None:
    """C = -3 B, where B^-1 has no finite binary expansion."""
    b = homogeneous([[3, 1, 7], [1, 5, 2], [0, 1, 9]])
    c = b.copy()
    c[:3, :3] = np.diag([-3.0, -3, 3]) @ b[:3, :3]
    half = sam.morph(ctx, numbers(ctx, b), numbers(ctx, c), numbers(ctx, 0.5))
    quarter = numbers(ctx, [[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]) * ctx.sqrt(ctx.mpf(3))
    assert close(ctx, half[:3, :3], quarter @ numbers(ctx, b)[:3, :3])
    c[0, 0] = np.nextafter(c[0, 0], 0)
    with pytest.raises(InputError, match="no real logarithm"):
        sam.morph(ctx, numbers(ctx, b), numbers(ctx, c), numbers(ctx, 0.5))


@pytest.mark.parametrize("affine", all_maps())
def test_fixed_points_stay(ctx: Any, affine: Any) -> None:
    exact = numbers(ctx, affine)
    difference = numbers(ctx, affine)[:-1, :-1] - identity(ctx, len(affine) - 1)
    with flint.ctx.workprec(4000):  # enough for the determinant to be exact
        determinant = flint.arb_mat([[ball(x) for x in row] for row in difference]).det()
    if determinant == 0:
        with pytest.raises(InputError, match="no single fixed point"):
            sam.fixed_point(ctx, exact)
        return
    fixed = sam.fixed_point(ctx, exact)
    with ctx.workprec(3000):
        moved = exact[:-1, :-1] @ fixed + exact[:-1, -1]
        size = length(ctx, exact[:-1, :-1]) * length(ctx, fixed)
        assert length(ctx, moved - fixed) <= ctx.ldexp(size, LOST - BITS)


def test_velocity_is_the_derivative_of_the_motion(ctx: Any) -> None:
    for size in (2, 3):
        for affine in random_maps(size, 0.5, 4):
            exact, point = numbers(ctx, affine), numbers(ctx, np.linspace(-1, 2, size))
            velocity = sam.velocity(ctx, exact, point)
            h = 2.0**-100
            ahead, behind = (sam.power(ctx, exact, numbers(ctx, t)) for t in (h, -h))
            slope = ((ahead - behind)[:-1, :-1] @ point + (ahead - behind)[:-1, -1]) / (2 * ctx.mpf(h))
            assert length(ctx, velocity - slope) <= ctx.ldexp(length(ctx, velocity) + 1, -180)


@pytest.mark.parametrize(
    ("affine", "reason"),
    [
        (homogeneous(np.diag([-1.0, -2])), "no real logarithm"),
        (homogeneous([[-1, 1, 0], [0, -1, 0], [0, 0, 1]]), "no real logarithm"),
        (homogeneous(np.diag([-1.0, 2])), "determinant"),
        (homogeneous(np.diag([1.0, 0, 2])), "determinant"),
        (homogeneous(np.diag([1.0, np.nan])), "not finite"),
        (np.array([[1.0, 0, 0], [0, 1, 0], [0, 1e-300, 1]]), "last row"),
    ],
)
def test_refusals(ctx: Any, affine: Any, reason: str) -> None:
    exact = numbers(ctx, affine)
    point = numbers(ctx, np.zeros(len(affine) - 1))
    t = numbers(ctx, 0.5)
    one = numbers(ctx, np.eye(len(affine)))
    with pytest.raises(InputError, match=reason):
        sam.log(ctx, exact)
    with pytest.raises(InputError, match=reason):
        sam.power(ctx, exact, t)
    with pytest.raises(InputError, match=reason):
        sam.morph(ctx, one, exact, t)
    with pytest.raises(InputError, match=reason):
        sam.velocity(ctx, exact, point)
