"""The similarities of the reference against the exponential series, and gallier's examples of choosing logarithms."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import se3, sim3, so3
from affinecert.reference._matrices import cross_matrix, homogeneous, identity, tangent

from .enclosures import Numbers, context, distance, exponential, length, numbers

BITS = 400
LOST = 40

ANGLES = [0.0, 1e-300, 1e-9, 0.3, np.pi, 2 * np.pi, 40.0]
GROWTHS = [0.0, 1e-300, -1e-9, 0.004, -1.0, 3.0, -40.0, 90.0]


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def hat(ctx: Any, x: Numbers) -> Numbers:
    return tangent(ctx, cross_matrix(ctx, x[:3]) + identity(ctx, 3) * x[6], x[3:6])


def tangents(angle: float, growth: float, count: int = 2) -> list[np.ndarray[Any, Any]]:
    drawn = np.random.default_rng(3).normal(size=(count, 7))
    drawn[:, :3] *= angle / np.linalg.norm(drawn[:, :3], axis=1)[:, None]
    drawn[:, 6] = growth
    return list(drawn)


def turned(ctx: Any, angle: Any, scale: float = 1.0, translation: tuple[float, ...] = (1.0, 2.0, 3.0)) -> Numbers:
    """A similarity that turns about the z axis."""
    cosine, sine = ctx.cos_sin(angle)
    linear = numbers(ctx, [[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
    return homogeneous(ctx, linear * ctx.mpf(scale), numbers(ctx, translation))


def at(ctx: Any, *omega: Any) -> Numbers:
    """A tangent with that rotation vector."""
    return numbers(ctx, [*omega, 4.0, 5.0, 6.0, 0.5])


@pytest.mark.parametrize("growth", GROWTHS)
@pytest.mark.parametrize("angle", ANGLES)
def test_exp_is_the_exponential_of_the_matrix(ctx: Any, angle: float, growth: float) -> None:
    for each in tangents(angle, growth):
        exact = numbers(ctx, each)
        similarity = sim3.exp(ctx, exact)
        size = length(ctx, similarity)
        assert distance(ctx, exponential(hat(ctx, exact)), similarity) <= ctx.ldexp(size, LOST - BITS)


@pytest.mark.parametrize("growth", GROWTHS)
@pytest.mark.parametrize("angle", [angle for angle in ANGLES if angle < 3.14])
def test_log_inverts_exp_blockwise(ctx: Any, angle: float, growth: float) -> None:
    for each, size in itertools.product(tangents(angle, growth, 1), [1e-100, 1.0, 1e100]):
        each[3:6] *= size
        exact = numbers(ctx, each)
        with ctx.workprec(BITS + 2100):
            found = sim3.log(ctx, sim3.exp(ctx, exact))
            for block in (slice(0, 3), slice(3, 6), slice(6, 7)):
                whole = length(ctx, exact[block]) or ctx.one
                assert length(ctx, found[block] - exact[block]) <= ctx.ldexp(whole, LOST - BITS)


@pytest.mark.parametrize("growth", GROWTHS)
@pytest.mark.parametrize("angle", ANGLES)
def test_every_similarity_has_a_logarithm(ctx: Any, angle: float, growth: float) -> None:
    """Theorem 3.2; the linear part of exp(log A) is the multiple of a rotation with the determinant of A's."""
    for each in tangents(angle, growth):
        pose = numbers(ctx, sim3.exp(ctx, numbers(ctx, each)).astype(float))
        found = sim3.log(ctx, pose)
        rotation = so3.nearest_rotation(ctx, pose[:3, :3], pose[:3, :3].T @ pose[:3, :3])
        scale = ctx.cbrt(ctx.det(ctx.matrix(pose[:3, :3].tolist())))
        pose[:3, :3] = rotation * scale
        size = length(ctx, pose)
        assert distance(ctx, exponential(hat(ctx, found)), pose) <= ctx.ldexp(size, LOST - BITS)


@pytest.mark.parametrize("angle", ANGLES)
def test_without_growth_it_is_a_rigid_motion(ctx: Any, angle: float) -> None:
    for each in tangents(angle, 0.0):
        exact = numbers(ctx, each)
        motion = se3.exp(ctx, exact[:6])
        assert length(ctx, sim3.exp(ctx, exact) - motion) <= ctx.ldexp(ctx.one, LOST - BITS)
        found, twist = sim3.log(ctx, motion), se3.log(ctx, motion)
        assert length(ctx, found - np.append(twist, ctx.zero)) <= ctx.ldexp(ctx.one, LOST - BITS)


@pytest.mark.parametrize("growth", GROWTHS)
@pytest.mark.parametrize("angle", ANGLES)
def test_the_condition_is_that_of_the_singular_values(ctx: Any, angle: float, growth: float) -> None:
    (each,) = tangents(angle, growth, 1)
    columns = []
    for unit in np.eye(3):
        each[3:6] = unit
        columns.append(sim3.exp(ctx, numbers(ctx, each))[:3, 3])
    values = ctx.svd_r(ctx.matrix(np.stack(columns, axis=1).tolist()), compute_uv=False)
    found = sim3.condition(ctx, numbers(ctx, each))[()]
    assert abs(found - values[0] / values[2]) <= ctx.ldexp(found, 2 * LOST - BITS)


def test_the_two_thirds_example_of_strategy_1(ctx: Any) -> None:
    """Section 5: turns by 2 pi/3, 4 pi/3 and 5 pi/3 about z. B_2' = 4 pi/3 follows B_1, and B_3 = -pi/3 follows B_2."""
    third = ctx.pi / 3
    first, second, last = (sim3.log(ctx, turned(ctx, k * third, 1.5)) for k in (2, 4, 5))
    assert [ctx.nstr(x[2] / third, 5) for x in (first, second, last)] == ["2.0", "-2.0", "-1.0"]
    after_first = sim3.log_next(ctx, turned(ctx, 4 * third, 1.5), first)
    assert length(ctx, after_first[:3] - numbers(ctx, [0, 0, 4 * third])) <= ctx.ldexp(ctx.one, LOST - BITS)
    # B_2 is what the next segment starts from: the spline jumps from B_2' to it, the motion does not.
    assert length(ctx, sim3.exp(ctx, after_first) - sim3.exp(ctx, second)) <= ctx.ldexp(ctx.one, LOST - BITS)
    after_second = sim3.log_next(ctx, turned(ctx, 5 * third, 1.5), second)
    assert length(ctx, after_second - last) <= ctx.ldexp(ctx.one, LOST - BITS)
    # From B_2' it would be B_3' = 5 pi/3.
    other = sim3.log_next(ctx, turned(ctx, 5 * third, 1.5), after_first)
    assert length(ctx, other[:3] - numbers(ctx, [0, 0, 5 * third])) <= ctx.ldexp(ctx.one, LOST - BITS)


def test_the_two_thirds_example_of_strategy_2(ctx: Any) -> None:
    """Section 5: strategy 2 follows the turns on, 2 pi/3, 4 pi/3, 5 pi/3, and beyond whole turns."""
    third = ctx.pi / 3
    here = sim3.log(ctx, turned(ctx, 2 * third, 1.5))
    for k in (4, 5, 6, 8, 10, 11, 13):
        here = sim3.log_near(ctx, turned(ctx, k * third, 1.5), here)
        assert length(ctx, here[:3] - numbers(ctx, [0, 0, k * third])) <= ctx.ldexp(ctx.one, LOST - BITS)
        back = sim3.exp(ctx, here)
        assert length(ctx, back - turned(ctx, k * third, 1.5)) <= ctx.ldexp(ctx.one, LOST - BITS)


def test_screw_of_the_last_example(ctx: Any) -> None:
    """Section 7: successive turns by 2 pi/3 that move along z by 2, at scale 3/2: the velocity along z is known."""
    pose = turned(ctx, 2 * ctx.pi / 3, 1.5, (0.0, 0.0, 2.0))
    # On the axis V is (e^lambda - 1) / lambda.
    expected = numbers(ctx, [0, 0, 2 * ctx.pi / 3, 0, 0, 4 * ctx.log(ctx.mpf(1.5)), ctx.log(ctx.mpf(1.5))])
    assert length(ctx, sim3.log(ctx, pose) - expected) <= ctx.ldexp(ctx.one, LOST - BITS)


def test_no_rotation_by_either_strategy(ctx: Any) -> None:
    pose = turned(ctx, 0, 2.0)
    far = at(ctx, 0, 13, 0)
    assert not any(sim3.log_next(ctx, pose, far)[:3])
    found = sim3.log_near(ctx, pose, far)
    assert length(ctx, found[:3] - numbers(ctx, [0, 4 * ctx.pi, 0])) <= ctx.ldexp(ctx.one, LOST - BITS)
    assert length(ctx, sim3.exp(ctx, found) - pose) <= ctx.ldexp(ctx.one, LOST - BITS)
    assert not any(sim3.log_near(ctx, pose, at(ctx, 0, 0, 0))[:3])


def test_ties_go_to_the_principal_logarithm(ctx: Any) -> None:
    half, across = numbers(ctx, np.diag([-1.0, -1.0, 1.0, 1.0])), at(ctx, 5, 0, 0)
    for choose in (sim3.log_next, sim3.log_near):
        assert float(choose(ctx, half, across)[2]) == math.pi
    behind = at(ctx, 5, 0, -1e-30)
    for choose in (sim3.log_next, sim3.log_near):
        assert float(choose(ctx, half, behind)[2]) == -math.pi


def test_whole_turns_of_what_neither_turns_nor_grows_are_refused(ctx: Any) -> None:
    still = numbers(ctx, np.eye(4))
    with pytest.raises(InputError, match="V is singular") as caught:
        sim3.log_near(ctx, still, at(ctx, 0, 0, 6))
    assert caught.value.argument == "near"
    assert not any(sim3.log_near(ctx, still, at(ctx, 0, 0, 3))[:3])
    # Larger by 2^-52 along one axis, less by that along another, the determinant is 1 - 2^-104: V is not singular.
    still[0, 0] += ctx.ldexp(ctx.one, -52)
    still[1, 1] -= ctx.ldexp(ctx.one, -52)
    assert ctx.nstr(sim3.log_near(ctx, still, at(ctx, 0, 0, 6))[6] * 3 * 2**104, 5) == "-1.0"


def test_continuations_stay_on_their_branch(ctx: Any) -> None:
    beyond = at(ctx, 0, 3.2, 0)
    pose = sim3.exp(ctx, beyond)
    for found in (
        sim3.continue_log(ctx, beyond + ctx.mpf(0.01), pose),
        sim3.continue_log_next(ctx, beyond, pose, at(ctx, 0, 0, 0)),
        sim3.continue_log_near(ctx, beyond, pose, at(ctx, 0, -9, 0)),
    ):
        assert length(ctx, found - beyond) <= ctx.ldexp(ctx.one, LOST - BITS)
    growing = turned(ctx, 0, 2.0)
    base = sim3.log_near(ctx, growing, at(ctx, 0, 6, 0))
    moved = sim3.continue_log_near(ctx, base, growing, at(ctx, 0.5, 20, 0))
    axis = numbers(ctx, [0.5, 20, 0])
    expected = axis * (2 * ctx.pi / length(ctx, axis))
    assert length(ctx, moved[:3] - expected) <= ctx.ldexp(ctx.one, LOST - BITS)


@pytest.mark.parametrize(
    ("entry", "value", "reason"),
    [
        ((3, 0), 1e-300, "last row"),
        ((3, 3), 2.0, "last row"),
        ((0, 0), 2.00001, "not a similarity"),
        ((2, 2), -2.0, "not a similarity: the determinant"),
        ((2, 2), 0.0, "not a similarity: the determinant"),
        ((0, 3), np.inf, "finite"),
    ],
)
def test_log_refuses_what_is_no_similarity(ctx: Any, entry: tuple[int, int], value: float, reason: str) -> None:
    pose = turned(ctx, 0, 2.0)
    pose[entry] = ctx.mpf(value)
    with pytest.raises(InputError, match=reason) as caught:
        sim3.log(ctx, pose)
    assert caught.value.argument == "pose"
