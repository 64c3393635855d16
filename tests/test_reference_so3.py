"""The rotations of the reference against the definitions: exponential series, nearest rotation, nearest logarithm."""

from __future__ import annotations

import itertools
from typing import Any

import flint
import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import so3
from affinecert.reference._matrices import cross_matrix, identity

from .enclosures import Numbers, ball, context, distance, exponential, length, numbers

BITS = 400
LOST = 40  # bits that the comparison itself may lose


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def directions(count: int, seed: int = 0) -> list[np.ndarray[Any, Any]]:
    drawn = np.random.default_rng(seed).normal(size=(count, 3))
    return [*(drawn / np.linalg.norm(drawn, axis=1)[:, None]), np.array([1.0, 0, 0]), np.array([1e-200, -1.0, 1e-20])]


def perturbed(ctx: Any, rotation: Numbers, size: float, seed: int) -> Numbers:
    """The matrix rounded to float64 after a relative change of its entries."""
    change = 1 + size * np.random.default_rng(seed).normal(size=(3, 3))
    return numbers(ctx, np.array([float(x) for x in rotation.flat]).reshape(3, 3) * change)


ANGLES = [0.0, 1e-300, 1e-30, 2.0**-10.5, 2.0**-10, 2.0**-9.5, 0.1, 1.0, 3.0, np.pi - 1e-12, np.pi, 4.0, 6.283, 50.0]


@pytest.mark.parametrize("angle", ANGLES)
def test_exp_is_the_exponential_of_the_skew_matrix(ctx: Any, angle: float) -> None:
    for axis in directions(3):
        omega = numbers(ctx, angle * axis)
        difference = distance(ctx, exponential(cross_matrix(ctx, omega)), so3.exp(ctx, omega))
        assert difference <= ctx.ldexp(ctx.one, LOST - BITS)


def test_exp_keeps_the_relative_accuracy_of_the_tiniest_turn(ctx: Any) -> None:
    omega = numbers(ctx, [3e-300, -4e-300, 12e-300])
    linear = so3.exp(ctx, omega) - identity(ctx, 3)
    assert length(ctx, linear - cross_matrix(ctx, omega)) <= 1e-290 * length(ctx, linear)


@pytest.mark.parametrize("angle", [1e10, 1e80, 1e150])
def test_exp_reduces_huge_angles(ctx: Any, angle: float) -> None:
    rotation = so3.exp(ctx, numbers(ctx, [0.0, 0.0, angle]))
    with flint.ctx.workprec(1500):
        cosine, sine = flint.arb(angle).cos(), flint.arb(angle).sin()
        assert abs(cosine - ball(rotation[0, 0])) < flint.arb(2) ** (LOST - BITS)
        assert abs(sine - ball(rotation[1, 0])) < flint.arb(2) ** (LOST - BITS)


@pytest.mark.parametrize("angle", [a for a in ANGLES if a <= np.pi])
@pytest.mark.parametrize("off", [0.0, 2.0**-53, 1e-8, 1e-7])
def test_log_is_the_principal_logarithm_of_the_nearest_rotation(ctx: Any, angle: float, off: float) -> None:
    for seed, axis in enumerate(directions(2)):
        matrix = perturbed(ctx, so3.exp(ctx, numbers(ctx, angle * axis)), off, seed)
        omega = so3.log(ctx, matrix)
        assert length(ctx, omega) <= ctx.pi * (1 + ctx.ldexp(ctx.one, LOST - BITS))
        # R is the nearest rotation to M iff R^T M is symmetric and positive definite; near I the diagonal tells.
        rotation = so3.exp(ctx, omega)
        stretch = rotation.T @ matrix
        assert length(ctx, stretch - stretch.T) <= ctx.ldexp(ctx.one, LOST - BITS)
        assert all(abs(stretch[i, i] - 1) < 1e-5 for i in range(3))


def test_log_inverts_exp_to_full_relative_accuracy(ctx: Any) -> None:
    for angle, axis in itertools.product([1e-300, 1e-150, 1e-20, 1e-5, 1.0, 3.14159], directions(2)):
        omega = numbers(ctx, angle * axis)
        # The matrix carries an omega of 1e-300 only with that many digits more.
        with ctx.workprec(BITS + 2100):
            rotation = so3.exp(ctx, omega)
            assert length(ctx, so3.log(ctx, rotation) - omega) <= ctx.ldexp(length(ctx, omega), LOST - BITS)


@pytest.mark.parametrize(
    ("matrix", "axis"),
    [
        (np.diag([-1.0, 1, -1]), [0, 1, 0]),
        (np.diag([1.0, -1, -1]), [1, 0, 0]),
        ([[0.0, -1, 0], [-1, 0, 0], [0, 0, -1]], [np.sqrt(0.5), -np.sqrt(0.5), 0]),
        ([[-1.0, 0, 0], [0, 0, -1], [0, -1, 0]], [0, np.sqrt(0.5), -np.sqrt(0.5)]),
        # Exactly symmetric, near a half turn: the nearest rotation is a half turn exactly.
        ([[-1.0, 1e-7, 1e-9], [1e-7, -1.0, 3e-8], [1e-9, 3e-8, 1.0]], [0, 0, 1]),
        # A half turn times a stretch: not symmetric, and yet the nearest rotation is the half turn exactly.
        ([[1.0, 1e-7, 0], [-1e-7, -1.0, 0], [0, 0, -1.0]], [1, 0, 0]),
    ],
)
def test_log_at_exactly_pi_has_its_first_component_positive(ctx: Any, matrix: Any, axis: Any) -> None:
    omega = so3.log(ctx, numbers(ctx, matrix))
    assert abs(length(ctx, omega) - ctx.pi) <= ctx.ldexp(ctx.one, LOST - BITS)
    assert np.allclose((omega / ctx.pi).astype(float), axis, atol=1e-6)


@pytest.mark.parametrize("tiny", [1e-16, 1e-100, 1e-300])
@pytest.mark.parametrize("sign", [1, -1])
def test_log_tells_the_sides_of_pi_apart(ctx: Any, tiny: float, sign: int) -> None:
    matrix = np.diag([-1.0, -1, 1])
    matrix[1, 0], matrix[0, 1] = sign * tiny, -sign * tiny
    omega = so3.log(ctx, numbers(ctx, matrix))
    assert (omega[2] > 0) == (sign > 0)
    with ctx.workprec(2500):
        assert abs(abs(omega[2]) - (ctx.pi - ctx.atan(tiny))) <= ctx.ldexp(ctx.one, LOST - BITS)


def test_log_of_a_stretch_is_zero(ctx: Any) -> None:
    stretch = np.eye(3) + 3e-8 * np.array([[1.0, 2, 3], [2, -1, 1], [3, 1, 0.5]])
    assert not any(so3.log(ctx, numbers(ctx, stretch)))


def all_logarithms(ctx: Any, rotation: Numbers) -> list[Numbers]:
    principal = so3.log(ctx, rotation)
    angle = length(ctx, principal)
    return [principal / angle * (angle + 2 * ctx.pi * k) for k in range(-9, 10)]


def test_log_near_is_the_nearest_of_all_logarithms(ctx: Any) -> None:
    draw = np.random.default_rng(1)
    for angle, axis in itertools.product([1e-9, 0.5, 3.0, np.pi - 1e-9], directions(2)):
        rotation = so3.exp(ctx, numbers(ctx, angle * axis))
        for size in (0.0, 1.0, 7.0, 20.0):
            near = numbers(ctx, size * draw.normal(size=3))
            expected = min(all_logarithms(ctx, rotation), key=lambda omega: length(ctx, omega - near))
            found = so3.log_near(ctx, rotation, near)
            assert length(ctx, found - expected) <= ctx.ldexp(ctx.one, LOST - BITS)


@pytest.mark.parametrize(
    ("matrix", "near", "turns"),
    [
        (np.eye(3), [0.0, 0, 0], [0, 0, 0]),
        (np.eye(3), [0.0, 3, 0], [0, 0, 0]),
        (np.eye(3), [0.0, -7, 0], [0, -1, 0]),
        (np.eye(3), [12.0, 0, 5], [24 / 13, 0, 10 / 13]),
        (np.diag([-1.0, -1, 1]), [0.0, 0, 0], [0, 0, 0.5]),
        (np.diag([-1.0, -1, 1]), [5.0, 5, 0], [0, 0, 0.5]),
        (np.diag([-1.0, -1, 1]), [0.0, 0, -1e-9], [0, 0, -0.5]),
        (np.diag([-1.0, -1, 1]), [0.0, 0, 9], [0, 0, 1.5]),
    ],
)
def test_log_near_at_identity_and_half_turns(ctx: Any, matrix: Any, near: Any, turns: Any) -> None:
    omega = so3.log_near(ctx, numbers(ctx, matrix), numbers(ctx, near))
    assert np.allclose((omega / (2 * ctx.pi)).astype(float), turns, atol=1e-15)


def test_continuations_follow_a_logarithm_through_pi(ctx: Any) -> None:
    base = numbers(ctx, [0.0, 0.0, 3.1])
    beyond = so3.exp(ctx, numbers(ctx, [0.0, 0.0, 3.2]))
    assert abs(so3.log(ctx, beyond)[2] + 3.0831853) < 1e-6
    assert abs(so3.continue_log(ctx, base, beyond)[2] - 3.2) < 1e-15
    assert abs(so3.continue_log_near(ctx, base, beyond, -base)[2] - 3.2) < 1e-15
    turn = numbers(ctx, [0.0, 0.0, 2 * ctx.pi])
    moved = so3.continue_log_near(ctx, turn, identity(ctx, 3), numbers(ctx, [1.0, 0.0, 1.0]))
    assert abs(moved[0] - moved[2]) == 0 < moved[0]


@pytest.mark.parametrize(
    ("matrix", "reason"),
    [
        (np.diag([1.0, 1, 1 + 1e-6]), "not a rotation"),
        (np.diag([1.0, 1, -1]), "not a rotation"),
        (np.zeros((3, 3)), "not a rotation"),
        (np.diag([1.0, 1, np.nan]), "not finite"),
    ],
)
def test_log_refuses_what_is_no_rotation(ctx: Any, matrix: Any, reason: str) -> None:
    with pytest.raises(InputError, match=reason) as caught:
        so3.log(ctx, numbers(ctx, matrix))
    assert caught.value.argument == "rotation"


def test_exp_refuses_infinity(ctx: Any) -> None:
    with pytest.raises(InputError, match="not finite"):
        so3.exp(ctx, numbers(ctx, [0.0, np.inf, 0.0]))
