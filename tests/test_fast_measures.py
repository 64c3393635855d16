"""Fast's measures: limits of accelerations, refusals, and figures of the papers that can be measured."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.errors import InputError
from affinecert.fast import measures, morphs, sam, so3

Array = NDArray[np.float64]

START = np.array([[1.0, 0.25, 0.0], [0.0, 0.75, 0.0], [0.0, 0.0, 1.0]])
END = np.array([[0.0, -1.5, 2.0], [1.0, 0.5, 1.0], [0.0, 0.0, 1.0]])


def turning(start: Array, end: Array, t: Array) -> Array:
    """Turns by 2 radians while it is carried straight by 3."""
    pose = np.zeros((*t.shape, 3, 3))
    pose[..., 0, 0] = pose[..., 1, 1] = np.cos(2 * t)
    pose[..., 1, 0], pose[..., 0, 1] = np.sin(2 * t), -np.sin(2 * t)
    pose[..., 0, 2], pose[..., 2, 2] = 3 * t, 1.0
    return pose


def test_the_limit_of_the_acceleration_is_told_with_its_error() -> None:
    value, error = measures.average_relative_acceleration_limit(turning, START, END, [[0.0, 0.0]], 1e-9)
    assert abs(value - 6.0) <= error <= 6e-9
    coarse = measures.average_relative_acceleration(turning(START, END, np.linspace(0, 1, 9)), [[0.0, 0.0]])
    assert abs(float(coarse) - 6.0) > 1e-3


@pytest.mark.parametrize(("morph", "steady"), [(morphs.linear, False), (morphs.log_spiral, False), (sam.morph, True)])
def test_the_limit_of_morphs(morph: Any, steady: bool) -> None:
    points = measures.simplex_grid(2, 10)
    value, error = measures.average_relative_acceleration_limit(morph, START, END, points)
    fine = float(measures.average_relative_acceleration(morph(START, END, np.linspace(0, 1, 513)), points))
    assert error <= 1e-6 * max(1.0, value)
    assert abs(value - fine) <= 0.02 * max(value, 1e-5)
    assert (value < 1e-8) == steady


def test_what_cannot_be_reached_is_told_by_the_error() -> None:
    def jumping(start: Array, end: Array, t: Array) -> Array:
        return np.array(turning(start, end, t) + (t > 0.3)[:, None, None] * np.eye(3)[0][:, None] * np.eye(3)[2])

    value, error = measures.average_relative_acceleration_limit(jumping, START, END, [[0.0, 0.0]])
    assert not error <= 1e-3 * value


def test_the_grid_of_the_simplex() -> None:
    assert measures.simplex_grid(2, 100).shape == (5151, 2)
    grid = measures.simplex_grid(3, 4)
    assert grid.shape == (35, 3)
    assert len(np.unique(grid, axis=0)) == 35
    assert grid.min() == 0
    assert grid.sum(axis=1).max() == 1


REFUSED = [
    (measures.average_relative_acceleration, (np.zeros((2, 2, 3, 3)), np.zeros((1, 2))), "poses: shape .* three poses"),
    (measures.average_relative_acceleration, (np.zeros((3, 3, 3)), np.zeros((0, 2))), "points: shape .* one point"),
    (measures.degeneracy, (np.zeros((0, 3, 3)),), "poses: shape .* one pose"),
    (measures.path_deviation, (np.zeros((4, 3)), np.zeros((4, 3)), np.zeros(0)), "times: shape .* one time"),
]


@pytest.mark.parametrize(("measure", "arguments", "reason"), REFUSED)
def test_too_few_things_are_refused(measure: Any, arguments: tuple[Any, ...], reason: str) -> None:
    with pytest.raises(InputError, match=reason):
        measure(*arguments)


def test_the_printed_length_of_a_curve_is_too_long() -> None:
    # Gallier and others, section 10: |b - a|. About the sphere of radius 2 pi, all of whose rotations are the identity,
    # hardly anything of it is left.
    for size, quotient in ((1.0, 1.0210), (np.pi, 1.2230), (2 * np.pi, 1.9675)):
        first, second = np.array([size, 0.0, 0.0]), np.array([0.0, size, 0.0])
        printed = np.linalg.norm(second - first)
        assert printed / measures.rotation_curve_length(first, second) == pytest.approx(quotient, abs=1e-4)
    first, second = np.array([2 * np.pi, 0.1, 0.0]), np.array([2 * np.pi, -0.1, 0.0])
    assert measures.rotation_curve_length(first, second) < 1e-2 * np.linalg.norm(second - first)


def test_the_curve_is_no_shorter_than_the_geodesic() -> None:
    generator = np.random.default_rng(3)
    first, second = generator.uniform(-2, 2, (2, 200, 3))
    relative = np.swapaxes(so3.exp(first), -1, -2) @ so3.exp(second)
    geodesic = np.linalg.norm(so3.log(relative), axis=-1)
    lengths = measures.rotation_curve_length(first, second)
    assert (geodesic <= lengths * (1 + 1e-12)).all()
    assert (lengths <= np.linalg.norm(second - first, axis=-1) * (1 + 1e-15)).all()


REGULAR = np.array([[1.0, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]]) / np.sqrt(3)
"""The regular tetrahedron inscribed in the unit sphere (Bansal and Tatu, section 6.5)."""


def test_deviation_grows_with_shear_as_in_figure_9() -> None:
    source = REGULAR[[0, 1, 2, 3]] if np.linalg.det(REGULAR[1:] - REGULAR[0]) > 0 else REGULAR[[0, 2, 1, 3]]
    times = np.linspace(0.0, 1.0, 21)
    moves = np.linspace(0.0, 1.0, 6)
    targets = np.repeat(source[None], len(moves), axis=0)
    targets[:, 2, 0] += moves
    targets[:, 3, 1] += moves
    found = measures.path_deviation(source, targets, times)
    assert (np.diff(found, axis=0) > 0).all()
    assert found[0].max() < 1e-14
    assert (found[:, 0] >= found[:, 1]).all()
