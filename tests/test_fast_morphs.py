"""Morphs and quaternions in float64: exact ends, half turns, times far outside, and scipy's slerp."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from affinecert.fast import affine_lie, morphs, quaternion, sam
from affinecert.sampling import homogeneous

RIGID = {"sim", "sclerp", "dual_quaternion_linear"}
BETWEEN = sorted(set(morphs.MORPHS) - RIGID)
COUNT = 20


def poses(size: int, seed: int, rigid: bool = False) -> np.ndarray[Any, Any]:
    """Poses that have a logarithm each, (COUNT, size + 1, size + 1)."""
    draw = np.random.default_rng(seed)
    found: list[np.ndarray[Any, Any]] = []
    while len(found) < COUNT:
        linear = np.linalg.qr(draw.normal(size=(size, size)))[0]
        if not rigid:
            linear = np.eye(size) + 0.5 * draw.normal(size=(size, size))
        pose = homogeneous(linear, draw.normal(size=size))
        if np.linalg.det(linear) > 0.1 and sam.exists(pose):
            found.append(pose)
    return np.stack(found)


def sizes(name: str) -> tuple[int, ...]:
    return (2,) if name == "three_spiral" else (3,) if name in RIGID else (2, 3)


@pytest.mark.parametrize("name", BETWEEN)
def test_the_ends_are_exact(name: str) -> None:
    for size in sizes(name):
        start, end = poses(size, 1), poses(size, 2)
        if name == "sam":
            keep = [bool(sam.exists(c @ np.linalg.inv(b))) for b, c in zip(start, end, strict=True)]
            start, end = start[keep], end[keep]
        np.testing.assert_array_equal(morphs.MORPHS[name](start, end, 0.0), start)
        np.testing.assert_array_equal(morphs.MORPHS[name](start, end, 1.0), end)


@pytest.mark.parametrize("name", sorted(RIGID))
def test_the_ends_of_rigid_motions_are_the_nearest_ones(name: str) -> None:
    start, end = poses(3, 1, rigid=True), poses(3, 2, rigid=True)
    for t, due in ((0.0, start), (1.0, end)):
        pose = morphs.MORPHS[name](start, end, t)
        np.testing.assert_array_max_ulp(pose[:, :3, 3], due[:, :3, 3], 1)
        np.testing.assert_allclose(pose, due, rtol=0.0, atol=2.0**-50)
        gram = np.swapaxes(pose[:, :3, :3], -1, -2) @ pose[:, :3, :3]
        np.testing.assert_allclose(gram, np.broadcast_to(np.eye(3), gram.shape), rtol=0.0, atol=2.0**-50)


@pytest.mark.parametrize("name", morphs.MORPHS)
def test_the_last_row_is_exact(name: str) -> None:
    for size in sizes(name):
        start = poses(size, 1, name in RIGID)
        pose = morphs.MORPHS[name](start, start @ homogeneous(np.eye(size), np.ones(size)), np.linspace(-1, 2, COUNT))
        np.testing.assert_array_equal(pose[:, -1], np.broadcast_to(np.eye(size + 1)[-1], (COUNT, size + 1)))


@pytest.mark.parametrize("name", morphs.MORPHS)
def test_times_and_poses_broadcast(name: str) -> None:
    for size in sizes(name):
        start = poses(size, 1, name in RIGID)
        end = start @ homogeneous(np.eye(size), np.ones(size))
        t = np.linspace(0.0, 1.0, 5)
        crossed = morphs.MORPHS[name](start[:, None], end[:, None], t)
        assert crossed.shape == (COUNT, 5, size + 1, size + 1)
        np.testing.assert_array_equal(crossed[3, 2], morphs.MORPHS[name](start[3], end[3], t[2]))


@pytest.mark.parametrize("name", sorted({"shoemake_duff", "arap", "rarap", "asap", "log_spiral", "three_spiral"}))
def test_half_a_turn_of_the_plane_is_positive(name: str) -> None:
    pose = morphs.MORPHS[name](np.eye(3), np.diag([-1.0, -1, 1]), 0.5)
    np.testing.assert_allclose(pose[:2, :2], np.array([[0.0, -1], [1, 0]]), rtol=0.0, atol=2.0**-52)


@pytest.mark.parametrize("size", [2, 3])
def test_edges_are_those_of_tetrahedra(size: int) -> None:
    """To rounding, where the vertices are not far from the origin."""
    start, end = poses(3, 3), poses(3, 4)
    if size == 2:
        start[:, 2], end[:, 2] = np.eye(4)[2], np.eye(4)[2]
        start[:, :, 2], end[:, :, 2] = np.eye(4)[:, 2], np.eye(4)[:, 2]
        keep = (np.linalg.det(start) > 0.1) & (np.linalg.det(end) > 0.1)
        start, end = start[keep], end[keep]
    simplex = np.array([[0.0, 0, 0, 1], [1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1]])
    found = (start, end, morphs.lie(start, end, 0.3))
    first, last, between = ((pose @ simplex.T).swapaxes(-1, -2)[..., :3] for pose in found)
    due = affine_lie.interpolate_tetrahedra(first, last, 0.3)
    np.testing.assert_allclose(between, due, rtol=0.0, atol=2.0**-46)


def test_slerp_turns_as_scipy_does() -> None:
    draw = np.random.default_rng(5)
    ends = draw.normal(size=(COUNT, 2, 4))
    ends /= np.linalg.norm(ends, axis=-1, keepdims=True)
    times = np.array([0.0, 0.1, 0.5, 0.9, 1.0])
    for pair in ends:
        due = Slerp([0.0, 1.0], Rotation.from_quat(pair, scalar_first=True))(times)
        found = Rotation.from_quat(quaternion.slerp(pair[0], pair[1], times), scalar_first=True)
        assert np.max((found * due.inv()).magnitude()) <= 2.0**-48


def test_slerp_far_outside() -> None:
    """Four times half the way round is the whole way, of quaternions at a right angle."""
    p, q = np.array([1.0, 0, 0, 0]), np.array([0.0, 0, 0.6, 0.8])
    for turns in (4.0, 400.0, -4.0):
        np.testing.assert_allclose(quaternion.slerp(p, q, turns), p, rtol=0.0, atol=2.0**-50)
    np.testing.assert_allclose(quaternion.slerp(p, q, 4001.0), q, rtol=0.0, atol=2.0**-50)


@pytest.mark.parametrize("tilt", [5e-324, 1e-300, 1e-40])
def test_the_sign_of_an_inner_product_is_exact(tilt: float) -> None:
    p, side = np.array([1.0, 0, 0, 0]), np.array([0.0, 0.6, 0.8, 0])
    for sign in (1.0, -1.0):
        end = side + np.array([sign * tilt, 0, 0, 0])
        np.testing.assert_allclose(quaternion.slerp(p, end, 1.0), sign * end, rtol=0.0, atol=2.0**-52)
