"""Shapes of our own, moved by E^F and E^R in float64, for the figures whose data the paper does not give.

Points of the plane are complex numbers. A linear map x + i y → b₁ x + b₂ y is the row (b₁, b₂), so that a turn of the
image is a factor, and the matrix of the quadratic form is Hermitian, one row and column a vertex.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

Points = NDArray[np.complex128]
Numbers = NDArray[np.float64]


class Shape(NamedTuple):
    """Vertices in the source and the target, and triangles, (faces, 3)."""

    source: Points
    target: Points
    triangles: NDArray[np.int64]


class Term(NamedTuple):
    """The term weight |sum of sign v - place|² of some vertices, with a place that depends on the time."""

    signs: dict[int, float]
    place: Callable[[float], complex]
    weight: float = 1.0


class Moved(NamedTuple):
    """The linear parts of all triangles, (times, faces, 2), as they should be and as the minimiser has them."""

    goals: Points
    parts: Points


LENGTH = 6.0
TIMES = np.linspace(0.0, 1.0, 11)[1:-1]


def bar(turn: float, offset: float = 0.0) -> Shape:
    """A bar of 24 × 2 cells, and the same rolled up: its angle grows along it, by ``turn``, from an offset."""
    columns, rows = 24, 2
    x, y = np.linspace(0.0, LENGTH, columns + 1), np.linspace(-0.2, 0.2, rows + 1)
    source = (x[:, None] + 1j * y).ravel()
    corner = (np.arange(columns)[:, None] * (rows + 1) + np.arange(rows)).ravel()
    over = corner + rows + 1
    triangles = np.concatenate(
        [np.stack(each, axis=1) for each in ((corner, over, over + 1), (corner, over + 1, corner + 1))]
    )
    curvature = turn / LENGTH
    heading = np.exp(1j * curvature * source.real)
    rolled = (heading - 1.0) / (1j * curvature) + 1j * source.imag * heading
    return Shape(source, rolled * np.exp(1j * offset), triangles)


def wheel(seed: int, long: float) -> Shape:
    """Eight triangles around a vertex, five spokes longer than the other three, and a random wheel alike."""
    generator = np.random.default_rng(seed)
    spokes = np.where(np.arange(8) <= 4, long, 1.0)
    while True:
        gaps, lengths = np.exp(0.4 * generator.normal(size=(2, 8)))
        gaps *= 2.0 * np.pi / gaps.sum()
        if gaps.max() < 2.5:
            break
    source = spokes * np.exp(0.25j * np.pi * np.arange(8))
    target = spokes * lengths * np.exp(1j * np.cumsum(gaps))
    rim = np.arange(8)
    triangles = np.stack([np.zeros_like(rim), 1 + rim, 1 + (rim + 1) % 8], axis=1)
    return Shape(np.concatenate([[0.0], source]), np.concatenate([[0.0], target]), triangles)


def derivatives(shape: Shape) -> tuple[Numbers, Numbers]:
    """What takes places of vertices to linear parts, (faces, 2, vertices), and the areas in the source."""
    first, second, third = shape.source[shape.triangles].T
    p, q = second - first, third - first
    double = (p.conj() * q).imag
    rows = np.stack([[q.imag, -p.imag], [-q.real, p.real]]) / double
    found = np.zeros((len(double), 2, len(shape.source)))
    faces = np.arange(len(double))
    for axis in (0, 1):
        for weight, vertex in zip((-rows[axis].sum(axis=0), *rows[axis]), shape.triangles.T, strict=True):
            found[faces, axis, vertex] = weight
    return found, np.abs(double) / 2.0


def determinants(parts: Points) -> Numbers:
    """The determinants of linear parts (..., 2)."""
    return np.asarray((parts[..., 0].conj() * parts[..., 1]).imag)


def angles(parts: Points) -> Numbers:
    """The angles of the rotations nearest to linear parts (..., 2), in (-π, π]."""
    return np.angle(parts[..., 0] - 1j * parts[..., 1])


def exponential(parts: Points, t: float, expected: Numbers | None = None) -> Points:
    """A^E(t) of linear parts (faces, 2), of the angles nearest to those expected."""
    theta = angles(parts)
    straight = parts * np.exp(-1j * theta)[:, None]
    stretch = np.stack([straight.real, straight.imag], axis=1)
    values, vectors = np.linalg.eigh(stretch)
    power = (vectors * values[:, None, :] ** t) @ np.swapaxes(vectors, 1, 2)
    if expected is not None:
        theta = theta + 2.0 * np.pi * np.round((expected - theta) / (2.0 * np.pi))
    moved: Points = (power[:, 0] + 1j * power[:, 1]) * np.exp(1j * t * theta)[:, None]
    return moved


def strain(goal: Points, part: Points) -> Numbers:
    """How far linear parts are from turned and scaled goals, relative to their size: the root of E^R / |B|²."""
    size, length = (np.sum(np.abs(each) ** 2, axis=-1) for each in (part, goal))
    along = np.abs(np.sum(part * goal.conj(), axis=-1)) ** 2
    found: Numbers = np.sqrt(np.maximum(1.0 - along / (size * length), 0.0))
    return found


def _least(
    take: Numbers, weights: Numbers, goal: Points, terms: Sequence[tuple[Term, complex]], *, invariant: bool
) -> Points:
    """The linear parts of the minimiser, with the places of the terms at the time."""
    projection: Any = np.eye(2)
    if invariant:
        squares = np.sum(np.abs(goal) ** 2, axis=1)[:, None, None]
        projection = np.eye(2) - goal[:, :, None] * goal.conj()[:, None] / squares
    kept = weights[:, None, None] * (projection @ take)
    columns = take.reshape(-1, take.shape[2])
    matrix = columns.T @ kept.reshape(columns.shape)
    right = np.zeros(take.shape[2], complex) if invariant else columns.T @ (weights[:, None] * goal).ravel()
    for (signs, _, weight), place in terms:
        row = np.zeros(take.shape[2])
        row[list(signs)] = list(signs.values())
        matrix = matrix + weight * np.outer(row, row)
        right = right + weight * row * place
    parts: Points = take @ np.linalg.solve(matrix, right)
    return parts


def move(
    shape: Shape,
    terms: Sequence[Term],
    times: Sequence[float] | Numbers = TIMES,
    *,
    invariant: bool,
    weighted: bool = True,
    expected: Numbers | None = None,
) -> Moved:
    """The minimiser of E^F, or E^R if ``invariant``, with these terms, at some times."""
    take, areas = derivatives(shape)
    weights = areas if weighted else np.ones_like(areas)
    # Matrices as small as these gain nothing from more threads, which cost much on a busy machine.
    with threadpool_limits(1):
        whole = take @ shape.target
        goals = np.array([exponential(whole, t, expected) for t in times])
        placed = [[(term, term.place(t)) for term in terms] for t in times]
        parts = [_least(take, weights, *each, invariant=invariant) for each in zip(goals, placed, strict=True)]
    return Moved(goals, np.array(parts))
