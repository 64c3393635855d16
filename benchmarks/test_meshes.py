"""Meshes of a hundred thousand triangles: sixty frames between two shapes of the plane, and a blend in space."""

from __future__ import annotations

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from affinecert.fast import mesh2, mesh3
from affinecert.map import Array

CELLS = 224
"""Cells along each side of a square, each cut in two triangles: 100 352 triangles, 50 625 vertices."""

FRAMES = 60
"""A second or two of an animation; they are to take half a minute at most on two processors."""


def square() -> tuple[Array, Array]:
    """The vertices of the square's grid, each moved by up to a seventh of a cell, and its triangles."""
    row = np.arange(CELLS + 1) / CELLS
    places = np.stack(np.meshgrid(row, row), axis=-1).reshape(-1, 2)
    moved = places + np.random.default_rng(0).uniform(-1, 1, places.shape) / (7 * CELLS)
    corner = (np.arange(CELLS) + (CELLS + 1) * np.arange(CELLS)[:, None]).ravel()
    across = corner + CELLS + 2
    halves = np.stack([corner, corner + 1, across]), np.stack([corner, across, across - 1])
    return moved, np.concatenate(halves, axis=1).T


def ring(source: Array) -> Array:
    """The square bent to two thirds of a ring, half as thick as its inner radius."""
    x, y = source.T
    return np.asarray(np.stack([np.sin(4.2 * x), -np.cos(4.2 * x)], axis=-1) * (3.0 - y)[:, None])


def relief(source: Array) -> Array:
    """The square as a hilly surface of space."""
    x, y = source.T
    return np.stack([x, y, 0.1 * np.sin(6 * x) * np.cos(5 * y)], axis=-1)


@pytest.mark.parametrize("energy", ["frobenius", "similarity", "points"])
def test_interpolation(benchmark: BenchmarkFixture, energy: mesh2.Energy) -> None:
    """The time of all frames, two threads sharing them; the matrix of E^F is factored once, the others each time."""
    source, triangles = square()
    target, times = ring(source), np.linspace(0.0, 1.0, FRAMES)
    few = triangles[:1], times[:1]
    mesh2.interpolate(source[few[0].ravel()], target[few[0].ravel()], [[0, 1, 2]], few[1], energy=energy)
    benchmark.group = f"mesh2.interpolate, {len(triangles)} triangles"
    benchmark.extra_info.update(map=f"mesh2.interpolate, {energy}", size=FRAMES, implementation="fast")
    options = {"energy": energy, "workers": 2}
    shapes = benchmark.pedantic(mesh2.interpolate, (source, target, triangles, times), options, rounds=1)
    assert np.abs(shapes[[0, -1]] - [source, target]).max() <= 1e-15


def test_blend(benchmark: BenchmarkFixture) -> None:
    """The time of a blend of two targets, factors and logarithms included."""
    source, triangles = square()
    rest, faces = relief(source), triangles.astype(np.float64)
    bent = np.insert(ring(source), 2, rest[:, 2], axis=1)
    targets = np.stack([bent, 2.0 * rest])
    mesh3.blend(rest[:3] + np.eye(3), targets[:, :3] + np.eye(3), [[0.0, 1.0, 2.0]], [0.5, 0.25])
    benchmark.group = f"mesh3.blend, {len(triangles)} triangles"
    benchmark.extra_info.update(map="mesh3.blend", size=1, implementation="fast")
    benchmark.pedantic(mesh3.blend, (rest, targets, faces, [0.5, 0.25]), rounds=1)
