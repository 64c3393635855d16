"""Curves in float64: through keys of any number, exactly; patterns of any number of copies; half turns and refusals.

The errors in every regime are held in `test_fast_accuracy`, what all functions promise of batches in
`test_fast_kernels`.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.catalogue import CATALOGUE
from affinecert.errors import InputError
from affinecert.fast import curves, sam, se3
from affinecert.scoring import block_score
from affinecert.truths import compute

Matrix = NDArray[np.float64]


def affines(count: int, n: int = 4, spread: float = 0.2) -> Matrix:
    draw = np.random.default_rng(count * n)
    return np.eye(n) + spread * draw.normal(size=(count, n, n)) * (np.arange(n) < n - 1)[:, None]


def shears(count: int) -> Matrix:
    draw = np.random.default_rng(count)
    keys = np.stack([np.eye(3)] * count)
    keys[:, [0, 0, 1], [1, 2, 2]] = draw.normal(size=(count, 3))
    keys[:, [1, 2], [1, 2]] = np.exp(draw.normal(size=(count, 2)))
    return keys


def scaled_error(name: str, *inputs: Any) -> float:
    """The worst scaled error of the function of that name."""
    entry = CATALOGUE[f"curves.{name}"]
    arrays = tuple(np.asarray(x, dtype=float) for x in inputs)
    truth = compute(entry, arrays)
    assert truth.refusal is None
    found = getattr(curves, name)(*arrays)
    return max(
        block_score(
            block.name,
            np.asarray(found[block.where]),
            truth.high[0][block.where],
            truth.low[0][block.where],
            k,
        ).scaled
        for block, k in zip(entry.blocks, truth.sensitivity, strict=True)
    )


@pytest.mark.parametrize("count", [2, 3, 7])
def test_keys_come_back_to_the_last_bit(count: int) -> None:
    times = np.arange(float(count))
    scales = np.exp(np.random.default_rng(1).normal(size=count))
    assert np.array_equal(curves.shear_curve(shears(count), times), shears(count))
    assert np.array_equal(curves.scale_curve(scales, times), scales)
    assert np.array_equal(curves.affine_curve(affines(count), times), affines(count))
    assert np.array_equal(curves.subdivided_curve(affines(count), times), affines(count))
    for n in (3, 4):
        assert np.array_equal(curves.poly_sam(affines(count, n), times), affines(count, n))


def test_rotations_of_keys_come_back_as_the_nearest_ones() -> None:
    keys = se3.exp(np.random.default_rng(2).normal(size=(4, 6)))
    moved = keys + 1e-8 * (np.arange(4) < 3)[:, None] * np.eye(4)[[1, 2, 0, 3]]
    found = curves.rigid_curve(moved, np.arange(4.0))
    rotation = found[:, :3, :3]
    assert np.allclose(rotation @ np.swapaxes(rotation, 1, 2), np.eye(3), rtol=0, atol=4e-16)
    assert np.allclose(found, keys, rtol=0, atol=4e-8)
    assert not np.allclose(found, keys, rtol=0, atol=1e-10)


@pytest.mark.parametrize("n", [3, 4])
def test_ends_and_corners_come_back_to_the_last_bit(n: int) -> None:
    a, b, c, d = affines(4, n)
    for t, pose in ((0.0, a), (1.0, c)):
        assert np.array_equal(curves.bezier_quadratic(a, b, c, t), pose)
        assert np.array_equal(curves.biarc(a, b, c, t), pose)
    assert np.array_equal(curves.biarc(a, b, c, 0.5), b)
    assert np.array_equal(curves.bezier_cubic(a, b, c, d, [0.0, 1.0]), [a, d])
    corners = curves.patch(a, b, c, d, [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0])
    assert np.array_equal(corners, [a, b, c, d])
    assert np.array_equal(curves.four_point(np.stack([a, b, c, d]))[::2], [a, b, c, d])
    assert np.array_equal(curves.regular_pattern(a, b)[[0, -1]], [a, b])


def test_long_curves_are_as_accurate() -> None:
    for t in (0.5, 3.3, 5.9):
        assert scaled_error("shear_curve", shears(7), t) <= 1.0
        assert scaled_error("scale_curve", np.exp(np.sin(np.arange(7.0))), t) <= 1.0
    assert scaled_error("affine_curve", affines(5), 3.7) <= 1.0
    assert scaled_error("four_point", affines(6, 3)) <= 1.0


def test_keys_and_times_broadcast_against_each_other() -> None:
    keys = np.stack([affines(3), affines(3)[::-1]])
    times = np.linspace(-0.5, 2.5, 7)
    for curve in (curves.affine_curve, curves.subdivided_curve, curves.poly_sam):
        whole = curve(keys[:, None], times)
        assert whole.shape == (2, 7, 4, 4)
        for i in range(2):
            for j in range(7):
                assert np.array_equal(whole[i, j], curve(keys[i], times[j]))


@pytest.mark.parametrize("copies", [1, 3, 10])
@pytest.mark.parametrize("n", [3, 4])
def test_patterns_of_any_number_of_copies(n: int, copies: int) -> None:
    start, end = affines(2, n)
    poses = curves.regular_pattern(start, end, copies)
    assert poses.shape == (copies + 1, n, n)
    step = sam.power(end @ np.linalg.inv(start), 1 / copies)
    assert np.allclose(step @ poses[:-1], poses[1:], rtol=0, atol=1e-14)
    assert curves.regular_pattern(affines(6, n)[:, None], end, copies).shape == (6, 1, copies + 1, n, n)


def test_no_copies_are_refused() -> None:
    with pytest.raises(InputError, match=r"^copies: 0 where at least one is due"):
        curves.regular_pattern(np.eye(3), np.eye(3), 0)


def test_refinement_again_and_again_keeps_a_regular_pattern() -> None:
    start, end = affines(2, 3)
    poses = curves.regular_pattern(start, end, 3)
    for _ in range(3):
        poses = curves.four_point(poses)
    assert np.allclose(poses, curves.regular_pattern(start, end, 24), rtol=0, atol=1e-13)


def test_a_half_turn_between_keys_is_about_the_axis_that_begins_positive() -> None:
    keys = np.stack([np.eye(4), np.diag([1.0, -1, -1, 1]), np.eye(4)])
    quarter = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
    assert np.allclose(curves.rigid_curve(keys, 0.5)[:3, :3], quarter, rtol=0, atol=1e-15)
    assert np.allclose(curves.affine_curve(keys, 0.5)[:3, :3], quarter, rtol=0, atol=1e-15)
    assert np.allclose(curves.subdivided_curve(keys, 0.5)[:3, :3], quarter, rtol=0, atol=1e-15)


@pytest.mark.parametrize("gap", [1e-3, 1e-8, 1e-14])
def test_rotations_short_of_a_half_turn(gap: float) -> None:
    sine, cosine = math.sin(gap), -math.cos(gap)
    turned = np.diag([1.0, cosine, cosine, 1.0])
    turned[1, 2], turned[2, 1] = -sine, sine
    turned[:3, 3] = (1, 2, 3)
    assert scaled_error("rigid_curve", np.stack([np.eye(4), turned, np.eye(4)]), 0.3) <= 1.0
    assert scaled_error("poly_sam", np.stack([np.eye(4), turned]), 0.3) <= 1.0


def test_a_half_turn_is_a_morph_between_keys_and_none_on_the_way() -> None:
    start = np.array([[1.0, 2, 0], [0, 1, 1], [0, 0, 1]])
    a, b, c = start, np.diag([-2.0, -2, 1]) @ start, np.diag([4.0, 4, 1]) @ start
    assert np.array_equal(curves.poly_sam(np.stack([a, b, c]), 0.5), sam.morph(a, b, 0.5))
    assert np.array_equal(curves.regular_pattern(a, b)[2], sam.morph(a, b, 0.5))
    for curve in (curves.bezier_quadratic, curves.biarc):
        with pytest.raises(
            InputError, match=r"^pose_[bc]\[1\]: no real logarithm: a negative eigenvalue between poses"
        ):
            curve(np.stack([a, a]), np.stack([a, b]), np.stack([a, c]), 0.3)


def test_poly_sam_asks_only_for_the_morph_that_holds_t() -> None:
    poses = np.stack([np.eye(3), np.diag([2.0, 3, 1]), np.diag([-2.0, -6, 1])])
    assert np.array_equal(curves.poly_sam(poses, 0.5), sam.morph(poses[0], poses[1], 0.5))
    with pytest.raises(InputError, match=r"^poses\[1\]: no real logarithm"):
        curves.poly_sam(np.stack([poses, poses]), [0.5, 1.5])


def test_too_few_keys_are_refused() -> None:
    with pytest.raises(InputError, match=r"^poses: shape \(1, 3, 3\) where at least 2 keys are due"):
        curves.poly_sam(affines(1, 3), 0.5)
    with pytest.raises(InputError, match=r"^poses: shape \(2, 3, 3\) where at least 3 keys are due"):
        curves.four_point(affines(2, 3))
    with pytest.raises(InputError, match=r"^scales: shape \(\) where \(..., keys\) is due"):
        curves.scale_curve(1.0, 0.5)


def test_the_index_of_a_refused_curve_is_that_of_its_batch() -> None:
    good, bad = affines(3), affines(3)
    bad[1, 0, :3] *= -1
    batch = np.stack([good, good, bad]).reshape(3, 1, 3, 4, 4)
    for curve in (curves.affine_curve, curves.subdivided_curve, curves.poly_sam):
        with pytest.raises(InputError, match="determinant") as caught:
            curve(batch, np.zeros(5))
        assert caught.value.index == (2, 0)


def test_grazing_points_of_a_turn_about_the_origin() -> None:
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    # Points of the line y = 2 move along it where they are above the origin.
    assert curves.grazing_parameter(turn, [-3.0, 2.0], [1.0, 0.0], [0.0, 1.0]) == 3.0
    with pytest.raises(InputError, match=r"^tangent\[1\]: degenerate"):
        curves.grazing_parameter(turn, [-3.0, 2.0], [[1.0, 0.0], [0.0, 1.0]], [0.0, 1.0])
    # Another batch of motions, across that of the tangents, does not change whose index it is.
    turns = np.stack([turn, np.linalg.inv(turn), turn])[:, None]
    with pytest.raises(InputError, match=r"^tangent\[1\]: degenerate"):
        curves.grazing_parameter(turns, [-3.0, 2.0], [[1.0, 0.0], [0.0, 1.0]], [0.0, 1.0])
