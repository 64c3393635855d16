"""The twelve parameters of the reference, against the exponentials and polar factors that define them."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from affinecert.case import generate
from affinecert.catalogue import find
from affinecert.errors import InputError
from affinecert.reference import kaji_ochiai, so3
from affinecert.reference._matrices import cross_matrix, identity
from affinecert.reference._natural_spline import natural_spline

from .enclosures import Numbers, context, length, numbers

BITS = 400
LOST = 80


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def close(ctx: Any, found: Numbers, due: Numbers) -> bool:
    return bool(length(ctx, found - due) <= ctx.ldexp(1 + length(ctx, due), LOST - BITS))


def drawn(name: str, regime: str, count: int = 3) -> list[tuple[np.ndarray[Any, Any], ...]]:
    entry = find(name)
    (chosen,) = (candidate for candidate in entry.regimes if candidate.name == regime)
    return [case.inputs for case in generate(entry, chosen, count)]


def series(ctx: Any, matrix: Numbers) -> Numbers:
    """The exponential from its definition; terms of matrices of this size fall below 2^-450 within 300."""
    total = term = identity(ctx, 3)
    for k in range(1, 300):
        term = matrix @ term / k
        total = total + term
    return total


def symmetric(y: Numbers) -> Numbers:
    a, b, c, d, e, f = y
    return np.array([[a, b, c], [b, d, e], [c, e, f]], dtype=object)


@pytest.mark.parametrize("regime", ["generic", "near-identity", "meeting", "triple"])
def test_realise_is_a_translation_after_two_exponentials(ctx: Any, regime: str) -> None:
    for (given,) in drawn("kaji_ochiai.realise", regime):
        parameters = numbers(ctx, given)
        affine = kaji_ochiai.realise(ctx, parameters)
        linear = series(ctx, cross_matrix(ctx, parameters[3:6])) @ series(ctx, symmetric(parameters[6:]))
        assert close(ctx, affine[:3, :3], linear)
        assert np.array_equal(affine[:3, 3], parameters[:3])
        assert np.array_equal(affine[3], [0, 0, 0, 1])


@pytest.mark.parametrize(
    "regime", [name for name in (each.name for each in find("kaji_ochiai.parametrise").regimes) if name != "outside"]
)
def test_parametrise_is_the_inverse_with_an_angle_of_at_most_pi(ctx: Any, regime: str) -> None:
    for (affine,) in drawn("kaji_ochiai.parametrise", regime):
        parameters = kaji_ochiai.parametrise(ctx, numbers(ctx, affine))
        size = float(np.abs(affine).max())
        assert close(ctx, kaji_ochiai.realise(ctx, parameters) / size, numbers(ctx, affine) / size)
        assert length(ctx, parameters[3:6]) <= ctx.pi * (1 + ctx.ldexp(ctx.one, LOST - BITS))


def test_realise_then_parametrise_gives_parameters_back(ctx: Any) -> None:
    for (given,) in drawn("kaji_ochiai.realise", "generic", 5):
        parameters = numbers(ctx, given)
        assert close(ctx, kaji_ochiai.parametrise(ctx, kaji_ochiai.realise(ctx, parameters)), parameters)


def test_at_pi_the_first_component_is_positive(ctx: Any) -> None:
    for (affine,) in drawn("kaji_ochiai.parametrise", "at-pi", 8):
        omega = kaji_ochiai.parametrise(ctx, numbers(ctx, affine))[3:6]
        assert abs(length(ctx, omega) - ctx.pi) <= ctx.ldexp(ctx.one, LOST - BITS)
        assert next(x for x in omega if abs(x) > 1e-50) > 0


def test_nearest_of_all_logarithms(ctx: Any) -> None:
    for regime in ("generic", "several-turns", "halfway"):
        for given, goal in drawn("kaji_ochiai.parametrise_near", regime):
            affine, near = numbers(ctx, given), numbers(ctx, goal)
            found = kaji_ochiai.parametrise_near(ctx, affine, near)
            principal = kaji_ochiai.parametrise(ctx, affine)
            axis, angle = principal[3:6] / length(ctx, principal[3:6]), length(ctx, principal[3:6])
            candidates = [axis * (angle + 2 * ctx.pi * k) for k in range(-9, 10)]
            nearest = min(candidates, key=lambda omega: length(ctx, omega - near[3:6]))
            assert close(ctx, found[3:6], nearest)
            assert close(ctx, np.delete(found, [3, 4, 5]), np.delete(principal, [3, 4, 5]))


def test_continued_through_pi(ctx: Any) -> None:
    before, beyond = (
        kaji_ochiai.realise(ctx, numbers(ctx, [1.0, 2, 3, 0, 0, angle, 0.1, 0.2, 0, 0, 0, -0.3]))
        for angle in (3.1, 3.2)
    )
    base = kaji_ochiai.parametrise(ctx, before)
    assert kaji_ochiai.parametrise(ctx, beyond)[5] < 0
    continued = kaji_ochiai.continue_parametrise(ctx, base, beyond)
    assert abs(continued[5] - ctx.mpf(3.2)) < ctx.ldexp(ctx.one, LOST - BITS)
    near = kaji_ochiai.continue_parametrise_near(ctx, base, beyond, -base)
    assert close(ctx, near, continued)
    # Without any rotation, the axis is that of the goal.
    still = identity(ctx, 4)
    moved = kaji_ochiai.continue_parametrise_near(ctx, base * 0 + 2 * ctx.pi, still, base * 0 + 7)
    assert moved[3] == moved[4] == moved[5] > 0


def test_a_blend_is_continued_through_pi(ctx: Any) -> None:
    angles = (3.14, 3.15)
    other = kaji_ochiai.realise(ctx, numbers(ctx, [0.0, 1, 0, 0.3, 0, 1, 0.1, 0, 0, 0.2, 0, 0]))
    poses = [
        np.stack([kaji_ochiai.realise(ctx, numbers(ctx, [0.0, 0, 0, 0, 0, angle] + [0.0] * 6)), other])
        for angle in angles
    ]
    weights = numbers(ctx, [0.5, 0.5])
    base = kaji_ochiai.blend(ctx, poses[0], weights)
    jumped = kaji_ochiai.blend(ctx, poses[1], weights)
    continued = kaji_ochiai.continue_blend(ctx, base, poses[1], weights)
    assert length(ctx, jumped - base) > 1
    assert length(ctx, continued - base) < 0.02
    points = numbers(ctx, [[1.0, 2, 3]])
    start = kaji_ochiai.deform(ctx, points, poses[0], weights[None])
    assert length(ctx, kaji_ochiai.continue_deform(ctx, start, points, poses[1], weights[None]) - start) < 0.1
    knots, t = numbers(ctx, [0.0, 1.0]), numbers(ctx, 0.5)
    start = kaji_ochiai.interpolate(ctx, poses[0], knots, t)
    assert length(ctx, kaji_ochiai.continue_interpolate(ctx, start, poses[1], knots, t) - start) < 0.1


def test_blends_of_one_and_of_the_same(ctx: Any) -> None:
    for affines, weights in drawn("kaji_ochiai.blend", "one-alone"):
        chosen = affines[int(np.flatnonzero(weights)[0])]
        assert close(ctx, kaji_ochiai.blend(ctx, numbers(ctx, affines), numbers(ctx, weights)), numbers(ctx, chosen))
        same = numbers(ctx, np.stack([chosen] * 3))
        assert close(ctx, kaji_ochiai.blend(ctx, same, numbers(ctx, [0.5, 0.75, -0.25])), same[0])


def test_a_deformation_is_a_blend_for_each_point(ctx: Any) -> None:
    for given in drawn("kaji_ochiai.deform", "generic", 2):
        points, probes, weights = (numbers(ctx, each) for each in given)
        moved = kaji_ochiai.deform(ctx, points, probes, weights)
        for u, own, image in zip(points, weights, moved, strict=True):
            blended = kaji_ochiai.blend(ctx, probes, own)
            assert close(ctx, blended[:3, :3] @ u + blended[:3, 3], image)


@pytest.mark.parametrize("count", [2, 3, 5])
def test_natural_splines_are_those_of_scipy(ctx: Any, count: int) -> None:
    draw = np.random.default_rng(count)
    knots, values = np.cumsum(draw.uniform(0.5, 2.0, count)), draw.normal(size=(count, 3))
    known = CubicSpline(knots, values, bc_type="natural")
    for t in (*knots, *draw.uniform(knots[0] - 1, knots[-1] + 1, 5)):
        found = natural_spline(numbers(ctx, knots), numbers(ctx, values), ctx.mpf(float(t)))
        assert np.allclose(found.astype(float), known(t), rtol=1e-12, atol=1e-12)


def test_natural_splines_have_two_derivatives_and_no_second_one_at_the_ends(ctx: Any) -> None:
    knots, values = numbers(ctx, [0.0, 1, 1.5, 4]), numbers(ctx, [[1.0], [-2], [0.5], [3]])
    step = ctx.ldexp(ctx.one, -100)

    def second(t: Any) -> Any:
        around = [natural_spline(knots, values, t + k * step)[0] for k in (-1, 0, 1)]
        return (around[0] - 2 * around[1] + around[2]) / step**2

    for knot, value in zip(knots, values, strict=True):
        assert abs(natural_spline(knots, values, knot)[0] - value[0]) <= ctx.ldexp(ctx.one, LOST - BITS)
    for inner in knots[1:-1]:
        assert abs(second(inner - 2 * step) - second(inner + 2 * step)) < 1e-25
    assert abs(second(knots[0] + 2 * step)) < 1e-25
    assert abs(second(knots[-1] - 2 * step)) < 1e-25


def test_an_interpolation_passes_the_poses_and_turns_on(ctx: Any) -> None:
    for poses, knots, _ in drawn("kaji_ochiai.interpolate", "twisting", 2):
        exact, places = numbers(ctx, poses), numbers(ctx, knots)
        for pose, knot in zip(exact, places, strict=True):
            assert close(ctx, kaji_ochiai.interpolate(ctx, exact, places, np.array(knot)), pose)
        chain = [kaji_ochiai.parametrise(ctx, exact[0])]
        for pose in exact[1:]:
            chain.append(kaji_ochiai.parametrise_near(ctx, pose, chain[-1]))
        assert length(ctx, chain[-1][3:6]) > ctx.pi
        assert all(length(ctx, b[3:6] - a[3:6]) < ctx.pi for a, b in itertools.pairwise(chain))
        rotation = so3.exp(ctx, chain[-1][3:6])
        assert close(ctx, rotation, so3.exp(ctx, kaji_ochiai.parametrise(ctx, exact[-1])[3:6]))


@pytest.mark.parametrize(
    ("knots", "reason"), [([0.0], "fewer than two"), ([0.0, 0.0], "increasing"), ([1.0, 0.0], "increasing")]
)
def test_knots_that_are_refused(ctx: Any, knots: Any, reason: str) -> None:
    poses = np.stack([identity(ctx, 4)] * len(knots))
    with pytest.raises(InputError, match=reason):
        kaji_ochiai.interpolate(ctx, poses, numbers(ctx, knots), numbers(ctx, 0.5))


def test_poses_that_are_refused(ctx: Any) -> None:
    for (affine,) in drawn("kaji_ochiai.parametrise", "outside", 6):
        with pytest.raises(InputError, match=r"last row|determinant") as caught:
            kaji_ochiai.deform(ctx, numbers(ctx, np.zeros((1, 3))), numbers(ctx, affine[None]), numbers(ctx, [[1.0]]))
        assert caught.value.argument == "probes"
