"""The reference's measures against their definitions, by other routes."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

import flint
import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import affine_lie, measures, sam, so3
from affinecert.reference._matrices import scalar
from affinecert.reference._quadrature import gauss_legendre

from .enclosures import Numbers, ball, context, length, numbers

BITS = 320


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def rational(matrix: Any) -> list[list[Fraction]]:
    return [[Fraction(float(x)) for x in row] for row in matrix]


def determinant(rows: list[list[Fraction]]) -> Fraction:
    if len(rows) == 1:
        return rows[0][0]
    minors = ([[*row[:k], *row[k + 1 :]] for row in rows[1:]] for k in range(len(rows)))
    return sum(((-1) ** k * rows[0][k] * determinant(minor) for k, minor in enumerate(minors)), Fraction(0))


def path(n: int, count: int = 4) -> Any:
    drawn = np.random.default_rng(n).uniform(-1, 1, (count, n, n))
    drawn[:, :-1, :-1] += 3 * np.eye(n - 1)
    drawn[:, -1] = np.eye(n)[-1]
    return drawn


@pytest.mark.parametrize("n", [3, 4])
def test_volumes_are_determinants(ctx: Any, n: int) -> None:
    poses = path(n)
    for volume, pose in zip(measures.volume(ctx, numbers(ctx, poses)), poses, strict=True):
        due = determinant(rational(pose[:-1, :-1]))
        assert abs(volume - ctx.mpf(due.numerator) / due.denominator) <= ctx.ldexp(volume, 4 - BITS)


@pytest.mark.parametrize("n", [3, 4])
def test_degeneracy_is_what_the_ends_lose(ctx: Any, n: int) -> None:
    poses = path(n)
    volumes = [determinant(rational(pose[:-1, :-1])) for pose in poses]
    due = 1 - min(volumes) / min(volumes[0], volumes[-1])
    found = measures.degeneracy(ctx, numbers(ctx, poses))[()]
    assert abs(found - ctx.mpf(due.numerator) / due.denominator) <= ctx.ldexp(ctx.one, 8 - BITS)
    flat = poses.copy()
    flat[1, :-1, 0] = 0.0
    assert measures.degeneracy(ctx, numbers(ctx, flat))[()] == 1
    assert measures.degeneracy(ctx, numbers(ctx, poses[[0, 0]]))[()] == 0


@pytest.mark.parametrize("n", [3, 4])
def test_acceleration_is_the_second_difference_in_the_moving_frame(ctx: Any, n: int) -> None:
    poses = path(n, 5)
    points = np.random.default_rng(7).uniform(-1, 1, (3, n - 1))
    exact = numbers(ctx, poses)
    inverses = [ctx.matrix(pose.tolist()) ** -1 for pose in exact]
    steps = [inverse * ctx.matrix(pose.tolist()) for inverse, pose in zip(inverses, exact[1:], strict=False)]
    lengths = []
    for x in points:
        place = ctx.matrix([*x, 1])
        velocities = [(step * place - place) * 4 for step in steps]
        lengths += [ctx.norm((after - before) * 4) for before, after in pairwise(velocities)]
    found = measures.average_relative_acceleration(ctx, exact, numbers(ctx, points))[()]
    assert abs(found - ctx.fsum(lengths) / len(lengths)) <= ctx.ldexp(found, 24 - BITS)


def test_falling_and_turning_motions_accelerate_as_mechanics_says(ctx: Any) -> None:
    # x'' = -g. In the frame that turns by w while it is carried straight by v, the velocity turns by -w.
    steps = 64
    falling, turning = np.zeros((2, steps + 1, 3, 3), dtype=object)
    for k in range(steps + 1):
        t = ctx.mpf(k) / steps
        falling[k] = [[1, 0, 0], [0, 1, -5 * t * t], [0, 0, 1]]
        c, s = ctx.cos(2 * t), ctx.sin(2 * t)
        turning[k] = [[c, -s, 3 * t], [s, c, 0], [0, 0, 1]]
    points = numbers(ctx, np.array([[0.0, 0.0]]))
    for poses, due in ((falling, 10.0), (turning, 6.0)):
        found = float(measures.average_relative_acceleration(ctx, poses * ctx.one, points)[()])
        assert abs(found - due) <= 1e-3 * due


@pytest.mark.parametrize("n", [3, 4])
def test_a_steady_motion_has_no_acceleration_at_all(ctx: Any, n: int) -> None:
    start, end = numbers(ctx, path(n, 2))
    exact = np.array([sam.morph(ctx, start, end, scalar(ctx.mpf(k) / 4)) for k in range(5)])
    assert measures.average_relative_acceleration(ctx, exact, numbers(ctx, np.eye(n - 1)))[()] == 0
    powers = np.array([np.linalg.matrix_power(np.diag([3.0] * (n - 1) + [1.0]), k) for k in range(4)])
    assert measures.average_relative_acceleration(ctx, numbers(ctx, powers), numbers(ctx, np.eye(n - 1)))[()] == 0


def test_quadrature_is_exact_for_polynomials(ctx: Any) -> None:
    for count in (2, 8, 34):
        for power in range(2 * count):
            found = ctx.fsum(w * x**power for x, w in gauss_legendre(ctx, count, ctx.mpf(-1), ctx.mpf(2)))
            due = (ctx.mpf(2) ** (power + 1) - (-1) ** (power + 1)) / (power + 1)
            assert abs(found - due) <= ctx.ldexp(abs(due) + 1, 16 - BITS)


VECTORS = [
    ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
    ([3.0, 0.5, 0.0], [-2.0, 1.0, 0.25]),
    ([1e-9, 0.0, 0.0], [0.0, 2e-9, 1e-9]),
    ([np.pi, 0.0, 0.0], [0.0, np.pi, 0.0]),
    ([2 * np.pi, 0.5, 0.0], [2 * np.pi, -1.0, 0.0]),  # nearest to the origin at 2 pi but for rounding: a kink
    ([6.25, 1.0, 0.0], [6.25, -2.0, 0.125]),
    ([9.0, -7.0, 3.0], [-2.0, 5.0, 11.0]),
]


def speed(first: Numbers, second: Numbers, s: Any) -> Any:
    """The length of the series of dexp_c (b - a), with the skew matrix of c to powers, in balls."""
    c = [ball(a) + (ball(b) - ball(a)) * s for a, b in zip(first, second, strict=True)]
    skew = flint.acb_mat([[0, -c[2], c[1]], [c[2], 0, -c[0]], [-c[1], c[0], 0]])
    term = total = flint.acb_mat([[ball(b) - ball(a)] for a, b in zip(first, second, strict=True)])
    for k in range(1, 160):
        term = skew * term / (k + 1)
        total += term
    return sum((total[i, 0] ** 2 for i in range(3)), start=flint.acb(0))


@pytest.mark.parametrize(("first", "second"), VECTORS[:4])
def test_length_is_the_integral_of_the_series(ctx: Any, first: list[float], second: list[float]) -> None:
    a, b = numbers(ctx, first), numbers(ctx, second)
    found = measures.rotation_curve_length(ctx, a, b)[()]
    with flint.ctx.workprec(200):
        enclosed = flint.acb.integral(lambda s, analytic: speed(a, b, s).sqrt(analytic=analytic), 0, 1).real
    assert abs(enclosed - ball(found)).upper() < flint.arb(2) ** -110 * ball(found)


@pytest.mark.parametrize(("first", "second"), VECTORS)
def test_length_is_what_chords_come_to(ctx: Any, first: list[float], second: list[float]) -> None:
    a, b = numbers(ctx, first), numbers(ctx, second)
    found = measures.rotation_curve_length(ctx, a, b)[()]
    chords = []
    for count in (64, 128, 256):
        turns = [so3.exp(ctx, a + (b - a) * (ctx.mpf(k) / count)) for k in range(count + 1)]
        # A turn by x is 2 sqrt(2) sin(x / 2) away in the Frobenius norm.
        angles = (2 * ctx.asin(length(ctx, after - before) / ctx.sqrt(8)) for before, after in pairwise(turns))
        chords.append(ctx.fsum(angles))
    assert chords[0] <= chords[1] <= chords[2] <= found * (1 + ctx.ldexp(1, -200))
    assert found - chords[2] <= (found - chords[1]) / 3 + found * 1e-12


def test_length_of_parallel_vectors_is_their_distance_and_else_less(ctx: Any) -> None:
    a = numbers(ctx, [1.0, -2.0, 0.5])
    for factor in (3.0, -0.25, 0.0):
        found = measures.rotation_curve_length(ctx, a, a * factor)[()]
        assert abs(found - length(ctx, a) * abs(1 - factor)) <= ctx.ldexp(found, 24 - BITS)
    for first, second in VECTORS:
        one, other = numbers(ctx, first), numbers(ctx, second)
        assert measures.rotation_curve_length(ctx, one, other)[()] < length(ctx, other - one)
    assert measures.rotation_curve_length(ctx, a, a)[()] == 0


TETRAHEDRON = np.array([[1.0, 1, 1], [3, 1, 1], [2, 4, 1], [1, 2, 3]])
CANONICAL = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]])


def test_deviation_is_that_of_the_maps_of_each_ordering(ctx: Any) -> None:
    source, target = numbers(ctx, CANONICAL), numbers(ctx, TETRAHEDRON)
    times = [ctx.mpf(k) / 4 for k in (1, 2)]
    corners = np.concatenate([source, np.full((4, 1), ctx.one)], axis=1)
    inverse = np.array((ctx.matrix(corners.tolist()) ** -1).tolist(), dtype=object)
    maps = {}
    for order in map(list, affine_lie.ORDERINGS):
        for t in times:
            moved = affine_lie.interpolate_tetrahedra(ctx, source[order], target[order], scalar(t))
            ordered = np.empty((4, 3), dtype=object)
            ordered[order] = moved
            maps[tuple(order), t] = inverse @ ordered
    pairs = combinations(affine_lie.ORDERINGS, 2)
    deviations = sorted(max(length(ctx, maps[p, t] - maps[q, t]) for t in times) for p, q in pairs)
    assert len(deviations) == 66
    found = measures.path_deviation(ctx, source, target, np.array(times))
    for value, due in zip(found, (deviations[-1], (deviations[32] + deviations[33]) / 2), strict=True):
        assert abs(value - due) <= ctx.ldexp(due, 40 - BITS)


def test_orderings_agree_on_isometries_but_not_on_similarities(ctx: Any) -> None:
    # Bansal and Tatu, section 5.2.1, say that they agree on both. But what is scaled is scaled about the first vertex.
    source, times = numbers(ctx, TETRAHEDRON), numbers(ctx, [0.5])
    turned = source[:, [1, 2, 0]] + numbers(ctx, [1.0, -2.0, 3.0])
    assert measures.path_deviation(ctx, source, turned, times)[0] <= ctx.ldexp(ctx.one, 40 - BITS)
    assert measures.path_deviation(ctx, source, 2 * source, times)[1] > 0.1


REFUSED = [
    (measures.average_relative_acceleration, (path(3, 2), np.zeros((1, 2))), "at least three are due"),
    (measures.average_relative_acceleration, (path(3, 3), np.zeros((0, 2))), "at least one is due"),
    (measures.degeneracy, (np.zeros((0, 3, 3)),), "at least one is due"),
    (measures.path_deviation, (CANONICAL, TETRAHEDRON, np.zeros(0)), "at least one is due"),
]


@pytest.mark.parametrize(("measure", "arguments", "reason"), REFUSED)
def test_too_few_things_are_refused(ctx: Any, measure: Any, arguments: tuple[Any, ...], reason: str) -> None:
    with pytest.raises(InputError, match=reason):
        measure(ctx, *(numbers(ctx, argument) for argument in arguments))
