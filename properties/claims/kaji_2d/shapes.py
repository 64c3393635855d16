"""Triangulated shapes of the plane, and the global error as a quadratic function of their vertices.

Numbers are mpf or rationals; what is computed of rationals is exact.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.kaji_2d.plane import determinant, edges, inner, inverse
from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference._matrices import Array, Number, array

Error = Callable[[Array, Array], Number]
"""A local error function E(A, B)."""

Constraint = Callable[[Array], Number]
"""A constraint function C of the vertices (n, 2)."""


@dataclass(frozen=True, eq=False)
class Mesh:
    """Places of the vertices (n, 2), triangles as triples of their indices, and a name."""

    vertices: Array
    triangles: tuple[tuple[int, int, int], ...]
    name: str

    def __str__(self) -> str:
        return self.name


def rational(nested: Sequence[Any]) -> Array:
    """Nested sequences of numbers as an array of exact rationals."""
    return array([rational(each) if isinstance(each, list | tuple) else Fraction(each) for each in nested])


TRIANGLE = Mesh(rational([[0, 0], [1, 0], [0, 1]]), ((0, 1, 2),), "a triangle")

SQUARE = Mesh(rational([[0, 0], [1, 0], [1, 1], [0, 1]]), ((0, 1, 2), (0, 2, 3)), "a square")
"""Two triangles that share an edge."""

STRIP = Mesh(rational([[0, 0], [1, 0], [0, 1], [1, 1], [0, 2]]), ((0, 1, 2), (1, 3, 2), (2, 3, 4)), "a strip")
"""Three triangles in a row."""

FAN = Mesh(rational([[0, 0], [2, 0], [0, 1], [-1, -1]]), ((0, 1, 2), (0, 2, 3), (0, 3, 1)), "a fan")
"""Three triangles around a vertex: the smallest mesh in which they get into each other's way."""


def linear_parts(mesh: Mesh, moved: Array) -> list[Array]:
    """The linear parts B_i of the affine maps that take the triangles of a mesh to those of moved vertices."""
    return [edges(moved[[*each]]) @ inverse(edges(mesh.vertices[[*each]])) for each in mesh.triangles]


def areas(mesh: Mesh) -> list[Number]:
    """The areas of the triangles."""
    return [abs(determinant(edges(mesh.vertices[[*each]]))) / 2 for each in mesh.triangles]


def total(
    mesh: Mesh,
    error: Error,
    goals: Sequence[Array],
    constraint: Constraint | None = None,
    weights: Sequence[Number] | None = None,
) -> Any:
    """The global error, a function of the coordinates (2n,) of all vertices: the sum of w_i E(A_i, B_i), and C."""
    inverses = [inverse(edges(mesh.vertices[[*each]])) for each in mesh.triangles]

    def of_coordinates(coordinates: Array) -> Number:
        moved = coordinates.reshape(-1, 2)
        parts = [edges(moved[[*each]]) @ back for each, back in zip(mesh.triangles, inverses, strict=True)]
        errors = [error(a, b) for a, b in zip(goals, parts, strict=True)]
        local = sum(errors) if weights is None else inner(array(weights), array(errors))
        return local + constraint(moved) if constraint else local

    return of_coordinates


def minimum(function: Callable[[Array], Number], count: int) -> Array:
    """The vertices (n, 2) where a quadratic function of their coordinates, as mpf, is least: -G⁻¹ u / 2."""
    g, u, _ = polarised(function, 2 * count, mp.one)
    least: Array = (definitions.inverse(mp, g) @ u / -2).reshape(-1, 2)
    return least


def precise(mesh: Mesh) -> Mesh:
    """The mesh with its places as mpf."""
    return Mesh(exactly(mesh.vertices.astype(float).tolist()), mesh.triangles, mesh.name)


def polarised(function: Callable[[Array], Number], size: int, one: Number = Fraction(1)) -> tuple[Array, Array, Number]:
    """The matrix G, vector u and number c of a function xᵀ G x + xᵀ u + c of so many variables.

    They are told from its values at 0, at the unit vectors, their opposites, and their sums.
    """
    units = array([[one * (i == k) for i in range(size)] for k in range(size)])
    c = function(units[0] * 0)
    there, back = ([function(sign * unit) - c for unit in units] for sign in (1, -1))
    g = np.empty((size, size), dtype=object)
    for i in range(size):
        g[i, i] = (there[i] + back[i]) / 2
        for k in range(i):
            g[i, k] = g[k, i] = (function(units[i] + units[k]) - c - there[i] - there[k]) / 2
    return g, array([(a - b) / 2 for a, b in zip(there, back, strict=True)]), c


def form_of(function: tuple[Array, Array, Number], x: Array) -> Number:
    """The value xᵀ G x + xᵀ u + c."""
    g, u, c = function
    return inner(x, g @ x) + inner(x, u) + c


def inertia(matrix: Array) -> tuple[int, int, int]:
    """The numbers of positive, negative and zero squares of a symmetric matrix of rationals, by L D Lᵀ: exactly."""
    rest = matrix.copy()
    signs = []
    while len(rest):
        pivot = next((k for k in range(len(rest)) if rest[k, k]), None)
        if pivot is None:
            crossed = np.argwhere(rest.astype(bool))
            if not len(crossed):
                break
            pivot, other = (int(k) for k in crossed[0])
            rest[pivot] = rest[pivot] + rest[other]
            rest[:, pivot] = rest[:, pivot] + rest[:, other]
        kept = [k for k in range(len(rest)) if k != pivot]
        column, square = rest[kept, pivot], rest[pivot, pivot]
        rest = rest[np.ix_(kept, kept)] - np.multiply.outer(column, column) / square
        signs.append(square > 0)
    return sum(signs), len(signs) - sum(signs), len(rest)


def drawn_goals(name: str, count: int) -> list[Array]:
    """So many rational maps of positive determinant."""
    generator = np.random.default_rng(list(name.encode()))
    found: list[Array] = []
    while len(found) < count:
        each = rational(generator.integers(-3, 4, size=(2, 2)).tolist())
        if determinant(each) > 0:
            found.append(each)
    return found
