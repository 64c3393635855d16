"""Interpolated and blended meshes in plain float64, straight from the definition: dense least squares, for small ones.

What is least over s and delta as well is left to the same least squares, with s R_delta = x I + y J.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from affinecert.fast import homotopy2, kaji_ochiai
from affinecert.fast.mesh2 import Edge, Locus

Array = NDArray[Any]
Row = tuple[float, dict[int, float], float]
"""A weight, the coefficients of unknowns, and what their sum should be."""

QUARTER = np.array([[0.0, -1.0], [1.0, 0.0]])


def linear_parts(source: Array, target: Array, triangles: Array) -> Array:
    """The linear parts of the affine maps of triangles, (faces, 2, 2)."""
    before, after = (edges(shape, triangles) for shape in (source, target))
    return np.asarray(after @ np.linalg.inv(before))


def edges(shape: Array, triangles: Array) -> Array:
    """The edges from the first vertex of each triangle, in columns, (faces, dimension, 2)."""
    corners = shape[triangles.astype(int)]
    return np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=-1)


def areas(shape: Array, triangles: Array) -> Array:
    """The areas of triangles of the plane, with their signs."""
    return np.asarray(np.linalg.det(edges(shape, triangles)) / 2)


def frobenius(goal: Array, source: Array, triple: Array, own: int) -> Iterator[Row]:
    """The squares of E^F of one triangle."""
    yield from ((1.0, terms, goal[place]) for place, terms in entries(source, triple))


def similarity(goal: Array, source: Array, triple: Array, own: int) -> Iterator[Row]:
    """The squares of E^R; x and y are the unknowns ``own`` and the next."""
    turned = QUARTER @ goal
    for place, terms in entries(source, triple):
        yield 1.0, terms | {own: -goal[place], own + 1: -turned[place]}, 0.0


def points(goal: Array, source: Array, triple: Array, own: int) -> Iterator[Row]:
    """The squares of E^S; the translation d is unknowns ``own`` + 2 and + 3."""
    for vertex in triple:
        image = goal @ source[vertex]
        turned = QUARTER @ image
        for axis in range(2):
            yield 1.0, {2 * vertex + axis: 1.0, own: -image[axis], own + 1: -turned[axis], own + 2 + axis: -1.0}, 0.0


def entries(source: Array, triple: Array) -> Iterator[tuple[tuple[int, int], dict[int, float]]]:
    """The entries of the linear part of the map from a triangle to its image, in the coordinates of the image."""
    inverse = np.linalg.inv(edges(source, triple[None])[0])
    for row, column in np.ndindex(2, 2):
        second, third = inverse[:, column]
        coefficients = (-second - third, second, third)
        yield (row, column), {2 * v + row: c for v, c in zip(triple.tolist(), coefficients, strict=True)}


ENERGIES: Mapping[str, Callable[..., Iterator[Row]]] = {
    "frobenius": frobenius,
    "similarity": similarity,
    "points": points,
}


def shape(
    source: Array,
    target: Array,
    triangles: Array,
    t: float,
    energy: str = "frobenius",
    homotopy: Callable[..., Array] = homotopy2.exponential,
    weights: Array | None = None,
    balance: float | None = None,
    constraints: tuple[Any, ...] = (),
    symmetric: bool = False,
    squared: bool = False,
) -> Array:
    """The vertices at a time; ``constraints`` have finite weights and paths of one point, or fix a vertex there.

    With ``squared`` they are found by normal equations.
    """
    triangles = triangles.astype(int)
    rows: list[Row] = []
    own = 2 * len(source)
    for start, end, time in ((source, target, t), (target, source, 1 - t))[: 1 + symmetric]:
        goals = homotopy(linear_parts(start, end, triangles), np.array(time))
        mass = np.abs(areas(start, triangles)) if weights is None else weights
        for triple, goal, weight in zip(triangles, goals, mass, strict=True):
            shares = {energy: 1.0} if balance is None else {"frobenius": balance, energy: 1 - balance}
            for name, share in shares.items():
                rows += [(weight * share, *rest) for _, *rest in ENERGIES[name](goal, start, triple, own)]
            own += 4
    known: dict[int, float] = {}
    for each in constraints:
        place = np.asarray(each.path)
        for axis in range(2):
            if isinstance(each, Locus):
                terms = {2 * each.vertex + axis: 1.0}
            elif isinstance(each, Edge):
                terms = {2 * each.second + axis: 1.0, 2 * each.first + axis: -1.0}
            else:
                terms = {2 * v + axis: 1 / len(source) for v in range(len(source))}
            if np.isinf(each.weight):
                known[2 * each.vertex + axis] = place[axis]
            else:
                rows.append((each.weight, terms, place[axis]))
    return least_squares(rows, own, known, squared)[: 2 * len(source)].reshape(-1, 2)


def least_squares(rows: list[Row], size: int, known: Mapping[int, float], squared: bool = False) -> Array:
    """The unknowns that make the weighted squares least, the known ones as given; unknowns without a row are 0."""
    matrix, right = np.zeros((len(rows), size)), np.zeros(len(rows))
    for number, (weight, terms, goal) in enumerate(rows):
        matrix[number, list(terms)] = np.sqrt(weight) * np.array(list(terms.values()))
        right[number] = np.sqrt(weight) * goal
    x = np.zeros(size)
    x[list(known)] = list(known.values())
    free = np.array([i for i in np.flatnonzero(matrix.any(axis=0)) if i not in known])
    matrix, right = matrix[:, free], right - matrix @ x
    x[free] = np.linalg.solve(matrix.T @ matrix, matrix.T @ right) if squared else np.linalg.lstsq(matrix, right)[0]
    return x


def frames(shape: Array, triangles: Array) -> Array:
    """Edges and unit normals of triangles of space, in columns, (faces, 3, 3)."""
    sides = edges(shape, triangles)
    normals = np.cross(sides[..., 0], sides[..., 1])
    return np.concatenate([sides, (normals / np.linalg.norm(normals, axis=-1, keepdims=True))[..., None]], axis=-1)


def blend(rest: Array, targets: Array, triangles: Array, weights: Array, weighted: bool = True) -> Array:
    """The blended mesh of space, its triangles weighted with their areas or not."""
    triangles = triangles.astype(int)
    inverse = np.linalg.inv(frames(rest, triangles))
    poses = np.tile(np.eye(4), (len(triangles), len(targets), 1, 1))
    for number, target in enumerate(targets):
        poses[:, number, :3, :3] = frames(target, triangles) @ inverse
    goals = kaji_ochiai.blend(poses, weights)[:, :3, :3]
    doubled = np.linalg.norm(np.cross(*np.moveaxis(edges(rest, triangles), -1, 0)), axis=-1)
    matrix, right = [], []
    for face, (triple, goal, back) in enumerate(zip(triangles, goals, inverse, strict=True)):
        for column in range(3):
            row = np.zeros(len(rest) + len(triangles))
            row[triple] = -back[0, column] - back[1, column], back[0, column], back[1, column]
            row[len(rest) + face] = back[2, column]
            mass = np.sqrt(doubled[face]) if weighted else 1.0
            matrix.append(mass * row)
            right.append(mass * goal[:, column])
    moved = np.linalg.lstsq(np.array(matrix), np.array(right))[0][: len(rest)]
    centres = np.mean([rest, *targets], axis=1)
    return np.asarray(moved - moved.mean(axis=0) + centres[0] + weights @ (centres[1:] - centres[0]))
