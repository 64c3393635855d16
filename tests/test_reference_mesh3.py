"""Blends of the reference: where the error is stationary, what they are made of, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from affinecert.errors import InputError
from affinecert.reference import kaji_ochiai, mesh3, so3
from affinecert.reference._matrices import array, cross, homogeneous, norm

from .enclosures import Numbers, context, length, numbers

BITS = 300

REST = [[0.0, 0.0, 0.0], [1.0, 0.2, 0.0], [0.1, 1.3, 0.0], [1.1, 1.0, 0.4]]
TARGETS = [
    [[1.0, 0.0, 0.5], [1.2, 1.0, 0.4], [-0.1, 0.3, 0.2], [0.3, 1.1, 1.0]],
    [[0.0, 2.0, 0.0], [1.5, 2.2, 0.3], [0.1, 2.8, -1.0], [1.0, 3.0, -1.2]],
]
TRIANGLES = [[0.0, 1.0, 2.0], [2.0, 1.0, 3.0]]


@pytest.fixture
def ctx() -> Any:
    return context(BITS)


def blended(ctx: Any, weights: Any, targets: Any = TARGETS, rest: Any = REST) -> Numbers:
    return mesh3.blend(ctx, numbers(ctx, rest), numbers(ctx, targets), numbers(ctx, TRIANGLES), numbers(ctx, weights))


def close(ctx: Any, found: Numbers, expected: Any) -> bool:
    expected = numbers(ctx, expected)
    return bool(length(ctx, found - expected) <= ctx.ldexp(length(ctx, expected), 80 - BITS))


@pytest.mark.parametrize(("weights", "shape"), [([0.0, 0.0], REST), ([1.0, 0.0], TARGETS[0]), ([0.0, 1.0], TARGETS[1])])
def test_the_shapes_given_are_interpolated(ctx: Any, weights: Any, shape: Any) -> None:
    assert close(ctx, blended(ctx, weights), shape)


def edges(shape: Numbers, row: list[float]) -> tuple[Numbers, Numbers]:
    first, second, third = (shape[int(i)] for i in row)
    return second - first, third - first


def error(ctx: Any, goals: list[Numbers], shape: Numbers) -> Any:
    """The sum of area |A - A'|^2 over two orthogonal directions in each triangle, which the normal does not enter."""
    total = ctx.zero
    for row, goal in zip(TRIANGLES, goals, strict=True):
        (first, second), (moved_first, moved_second) = edges(numbers(ctx, REST), row), edges(shape, row)
        part = (first @ second) / (first @ first)
        pairs = ((first, moved_first), (second - first * part, moved_second - moved_first * part))
        area = norm(ctx, cross(first, second)) / 2
        total += area * sum(np.sum((moved - goal @ e) ** 2) / (e @ e) for e, moved in pairs)
    return total


def frame(ctx: Any, shape: Numbers, row: list[float]) -> Numbers:
    first, second = edges(shape, row)
    normal = cross(first, second)
    return array([first, second, normal / norm(ctx, normal)]).T


def test_the_error_is_stationary(ctx: Any) -> None:
    weights, origin = numbers(ctx, [0.3, 0.5]), numbers(ctx, np.zeros(3))
    goals = []
    for row in TRIANGLES:
        at_rest = ctx.inverse(ctx.matrix(frame(ctx, numbers(ctx, REST), row).tolist()))
        back = array([[at_rest[i, j] for j in range(3)] for i in range(3)])
        maps = [homogeneous(ctx, frame(ctx, numbers(ctx, target), row) @ back, origin) for target in TARGETS]
        goals.append(kaji_ochiai.blend(ctx, array(maps), weights)[:3, :3])
    shape = blended(ctx, [0.3, 0.5])
    least = error(ctx, goals, shape)
    assert least > 0.001  # the maps of the two triangles do not agree on their common edge
    for place in np.ndindex(4, 3):
        there, back = shape.copy(), shape.copy()
        there[place] += 1
        back[place] -= 1
        changes = error(ctx, goals, there) - least, error(ctx, goals, back) - least
        assert abs(changes[0] - changes[1]) <= ctx.ldexp(changes[0] + changes[1], 80 - BITS)


def test_a_rigid_motion_is_blended_as_one(ctx: Any) -> None:
    """Half of a rotation is the rotation by half the angle, about any point: the barycentre tells the rest."""
    omega = numbers(ctx, [0.3, -1.0, 2.0])
    rest = numbers(ctx, REST)
    target = (so3.exp(ctx, omega) @ rest.T).T + numbers(ctx, [1.0, 2.0, 3.0])
    found = mesh3.blend(ctx, rest, target[None], numbers(ctx, TRIANGLES), numbers(ctx, [0.5]))
    turned = (so3.exp(ctx, omega / 2) @ rest.T).T
    centre = (np.sum(rest, axis=0) + np.sum(target, axis=0)) / 8
    assert close(ctx, found, turned - np.sum(turned, axis=0) / 4 + centre)


@pytest.mark.parametrize(
    ("changes", "argument", "reason"),
    [
        ({"rest": np.full((4, 3), np.inf)}, "rest", "not finite"),
        ({"weights": [np.nan, 0.0]}, "weights", "not finite"),
        ({"rest": [REST[0], REST[1], REST[1], REST[3]]}, "rest", "a triangle without area"),
        ({"targets": [REST, np.outer(range(4), [1.0, 2, 3])]}, "targets", "a triangle without area"),
        ({"triangles": [[0.0, 1, 2], [2, 1, 2]]}, "triangles", "not triples of different vertices"),
        ({"triangles": [[0.0, 1, 2]]}, "triangles", "not one piece with all vertices"),
    ],
)
def test_refusals(ctx: Any, changes: dict[str, Any], argument: str, reason: str) -> None:
    arguments = {"rest": REST, "targets": TARGETS, "triangles": TRIANGLES, "weights": [0.5, 0.5]} | changes
    with pytest.raises(InputError, match=rf"^{argument}: {reason}"):
        mesh3.blend(ctx, *(numbers(ctx, value) for value in arguments.values()))
