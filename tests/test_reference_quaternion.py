"""Quaternions of the reference: the arc by what defines it, its sign, and rotations of space by quaternions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import quaternion, so3
from affinecert.reference._matrices import dot, scalar

from .enclosures import Numbers, context, length, numbers

BITS = 400
LOST = 60


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def close(ctx: Any, found: Numbers, expected: Numbers, lost: int = LOST) -> bool:
    return bool(length(ctx, found - expected) <= ctx.ldexp(length(ctx, expected) + ctx.one, lost - BITS))


def units(ctx: Any, count: int) -> list[Numbers]:
    draw = np.random.default_rng(count)
    given = [numbers(ctx, draw.normal(size=4)) for _ in range(count)]
    return [q / length(ctx, q) for q in given]


@pytest.mark.parametrize("t", [0.0, 0.25, 0.7, 1.0, -0.5, 1.75])
def test_the_arc_is_run_through_evenly(ctx: Any, t: float) -> None:
    for p, q in zip(units(ctx, 6), units(ctx, 7), strict=False):
        found = quaternion.slerp(ctx, p, q, numbers(ctx, t))
        nearer = q if dot(ctx, p, q) >= 0 else -q
        angle = ctx.acos(dot(ctx, p, nearer))
        # Of length 1, and with these inner products, it lies in the plane of p and q.
        assert abs(length(ctx, found) - 1) <= ctx.ldexp(1, LOST - BITS)
        assert abs(dot(ctx, found, p) - ctx.cos(t * angle)) <= ctx.ldexp(1, LOST - BITS)
        assert abs(dot(ctx, found, nearer) - ctx.cos((1 - t) * angle)) <= ctx.ldexp(1, LOST - BITS)


def test_the_arc_is_a_power_of_the_rotation_between(ctx: Any) -> None:
    for p, q in zip(units(ctx, 6), units(ctx, 7), strict=False):
        between = quaternion.matrix(p).T @ quaternion.matrix(q)
        due = quaternion.matrix(p) @ so3.exp(ctx, so3.log(ctx, between) * ctx.mpf(0.3))
        assert close(ctx, quaternion.matrix(quaternion.slerp(ctx, p, q, numbers(ctx, 0.3))), due, 100)


@pytest.mark.parametrize("gap", [0.0, 1e-300, 1e-40, 1e-8])
def test_coincident_and_antipodal_ones_stay(ctx: Any, gap: float) -> None:
    p, q = numbers(ctx, np.array([1.0, 0, 0, 0])), numbers(ctx, np.array([1.0, gap, 0, 0]))
    for end in (q, -q):
        found = quaternion.slerp(ctx, p, end, numbers(ctx, 0.5))
        assert abs(found[0] - 1) <= gap * gap + ctx.ldexp(1, LOST - BITS)
        assert abs(found[1] - gap / 2) <= gap**3 + ctx.ldexp(gap, LOST - BITS)


def test_the_sign_at_a_right_angle(ctx: Any) -> None:
    p, half = numbers(ctx, np.array([1.0, 0, 0, 0])), numbers(ctx, 0.5)
    for tilt, sign in ((0.0, 1), (1e-300, 1), (-1e-300, -1)):
        for axis in (1.0, -1.0):
            found = quaternion.slerp(ctx, p, numbers(ctx, np.array([tilt, axis, 0, 0])), half)
            assert close(ctx, found, numbers(ctx, np.array([1.0, sign * axis, 0, 0])) / ctx.sqrt(2))
            continued = quaternion.continue_slerp(ctx, found, p, numbers(ctx, np.array([-tilt, axis, 0, 0])), half)
            assert close(ctx, continued, found)


def test_quaternions_of_rotations(ctx: Any) -> None:
    for q in units(ctx, 6):
        assert close(ctx, quaternion.of_rotation(ctx, quaternion.matrix(q)), q if q[0] > 0 else -q, 100)
    for axis in (np.array([-1.0, 0, 0]), np.array([0.0, -1, 1]), np.array([1.0, -1, 0])):
        matrix = 2 * np.outer(axis, axis) / (axis @ axis) - np.eye(3)
        first = axis[np.flatnonzero(axis)[0]]
        due = numbers(ctx, np.array([0.0, *axis * first])) / ctx.sqrt(numbers(ctx, axis @ axis)[()])
        assert close(ctx, quaternion.of_rotation(ctx, numbers(ctx, matrix)), due)


def test_products_are_those_of_rotations(ctx: Any) -> None:
    p, q = units(ctx, 2)
    product = quaternion.product(p, q)
    assert close(ctx, quaternion.matrix(product), quaternion.matrix(p) @ quaternion.matrix(q))
    assert close(ctx, quaternion.product(product, quaternion.conjugate(q)), p)


@pytest.mark.parametrize("factor", [0.0, 0.5, 1 + 2e-6, 1 - 2e-6])
def test_other_lengths_are_refused(ctx: Any, factor: float) -> None:
    good, bad = numbers(ctx, np.array([0.6, 0, 0.8, 0])), numbers(ctx, factor * np.array([0.6, 0, 0.8, 0]))
    for argument, pair in (("start", (bad, good)), ("end", (good, bad))):
        with pytest.raises(InputError, match="not a unit quaternion") as caught:
            quaternion.slerp(ctx, *pair, scalar(ctx.one))
        assert caught.value.argument == argument


def test_a_length_within_a_millionth_is_made_1(ctx: Any) -> None:
    p, q, half = *units(ctx, 2), numbers(ctx, 0.5)
    due = quaternion.slerp(ctx, p, q, half)
    assert close(ctx, quaternion.slerp(ctx, p * ctx.mpf(1 + 9e-7), q * ctx.mpf(1 - 9e-7), half), due)
