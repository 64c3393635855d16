"""The rigid motions of the reference against the exponential series."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import se3, so3
from affinecert.reference._matrices import cross_matrix, identity, tangent

from .enclosures import Numbers, context, distance, exponential, length, numbers

BITS = 400
LOST = 40


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def hat(ctx: Any, twist: Numbers) -> Numbers:
    return tangent(ctx, cross_matrix(ctx, twist[:3]), twist[3:])


def twists(angle: float, count: int = 3) -> list[np.ndarray[Any, Any]]:
    drawn = np.random.default_rng(2).normal(size=(count, 6))
    drawn[:, :3] *= angle / np.linalg.norm(drawn[:, :3], axis=1)[:, None]
    return list(drawn)


ANGLES = [0.0, 1e-300, 1e-100, 1e-9, 2.0**-10.5, 2.0**-9.5, 0.3, 2.0, np.pi - 1e-15, np.pi]


@pytest.mark.parametrize("angle", [*ANGLES, 6.0, 2 * np.pi, 40.0])
def test_exp_is_the_exponential_of_the_matrix(ctx: Any, angle: float) -> None:
    for twist in twists(angle):
        motion = se3.exp(ctx, numbers(ctx, twist))
        balls = exponential(hat(ctx, numbers(ctx, twist)))
        assert distance(ctx, balls, motion) <= ctx.ldexp(ctx.one, LOST - BITS)


@pytest.mark.parametrize("angle", [a for a in ANGLES if a < 3.14159])
def test_log_inverts_exp_blockwise(ctx: Any, angle: float) -> None:
    for twist, size in itertools.product(twists(angle, 2), [1e-100, 1.0, 1e100]):
        twist[3:] *= size
        exact = numbers(ctx, twist)
        with ctx.workprec(BITS + 2100):
            found = se3.log(ctx, se3.exp(ctx, exact))
            for block in (slice(0, 3), slice(3, 6)):
                error = length(ctx, found[block] - exact[block])
                assert error <= ctx.ldexp(length(ctx, exact[block]), LOST - BITS)


@pytest.mark.parametrize("angle", ANGLES)
def test_exp_of_log_is_the_nearest_rotation_and_the_same_translation(ctx: Any, angle: float) -> None:
    for twist in twists(angle):
        pose = numbers(ctx, se3.exp(ctx, numbers(ctx, twist)).astype(float))
        found = se3.log(ctx, pose)
        assert np.array_equal(found[:3], so3.log(ctx, pose[:3, :3]))
        balls = exponential(hat(ctx, found))
        pose[:3, :3] = so3.exp(ctx, found[:3])
        assert distance(ctx, balls, pose) <= ctx.ldexp(ctx.one, LOST - BITS)


def test_screw_by_half_a_turn(ctx: Any) -> None:
    pose = np.diag([-1.0, -1, 1, 1])
    pose[:3, 3] = [2.0, 0.0, 5.0]
    twist = se3.log(ctx, numbers(ctx, pose))
    # The axis passes through (1, 0, 0), where omega x p + v = (0, 0, 5): v = (0, -pi, 5).
    expected = numbers(ctx, [0, 0, ctx.pi, 0, -ctx.pi, 5])
    assert length(ctx, twist - expected) <= ctx.ldexp(ctx.one, LOST - BITS)


def test_continuation_beyond_half_a_turn(ctx: Any) -> None:
    twist = numbers(ctx, [0.0, 3.2, 0.0, 1.0, 2.0, 3.0])
    found = se3.continue_log(ctx, twist + ctx.mpf(0.01), se3.exp(ctx, twist))
    assert length(ctx, found - twist) <= ctx.ldexp(ctx.one, LOST - BITS)


def test_powers_take_either_side_of_pi(ctx: Any) -> None:
    rotation, translation = np.diag([-1, -1, 1]) * ctx.one, numbers(ctx, [2.0, 0.0, 5.0])
    half = ctx.mpf(0.5)
    quarters = list(se3.powers(ctx, rotation, translation, half))
    assert [float(r[1, 0]) for r, _ in quarters] == pytest.approx([1.0, -1.0])
    for r, d in quarters:
        assert length(ctx, r @ r - rotation) <= ctx.ldexp(ctx.one, LOST - BITS)
        assert length(ctx, r @ d + d - translation) <= ctx.ldexp(ctx.one, LOST - BITS)
    assert len(list(se3.powers(ctx, identity(ctx, 3), translation, half))) == 1


@pytest.mark.parametrize(
    ("entry", "value", "reason"),
    [
        ((3, 0), 1e-300, "last row"),
        ((3, 3), 2.0, "last row"),
        ((0, 0), 1.1, "not a rotation"),
        ((0, 3), np.inf, "finite"),
    ],
)
def test_log_refuses_what_is_no_rigid_motion(ctx: Any, entry: tuple[int, int], value: float, reason: str) -> None:
    pose = np.eye(4)
    pose[entry] = value
    with pytest.raises(InputError, match=reason) as caught:
        se3.log(ctx, numbers(ctx, pose))
    assert caught.value.argument == "pose"
