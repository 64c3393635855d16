"""Constraints on a moving mesh of the plane: squares of linear functions of its vertices."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast._kernel import Array
from affinecert.fast._triangulation import Indices
from affinecert.fast._wide import subtract, widen

Path = Callable[[float], ArrayLike] | ArrayLike
"""Points or vectors of the plane: a function of the time, (2,); or one for each time that is asked for, (..., 2)."""


@dataclass(frozen=True)
class Locus:
    """A vertex is to be at a place: the term weight |v - path|^2, or exactly there with an infinite weight."""

    vertex: int
    path: Path
    weight: float = math.inf


@dataclass(frozen=True)
class Edge:
    """The vector from one vertex to another is to be given: the term weight |v_second - v_first - path|^2."""

    first: int
    second: int
    path: Path
    weight: float = 1.0


@dataclass(frozen=True)
class Barycentre:
    """The mean of all vertices is to be given: the term weight |mean - path|^2; exactly so where there is no `Locus`."""

    path: Path
    weight: float = 1.0


Constraint = Locus | Edge | Barycentre

NOWHERE = "one of them must be a Locus or a Barycentre, or nothing holds the shape in its place"
COLLAPSING = "they must give two vertices, or a place and an edge: else E^R and E^S are least where all vertices meet"


@dataclass(frozen=True)
class Term:
    """The term weight |sum of sign v - goal|^2; ``goal`` gives a complex number of pairs, (2, 2).

    It is told the number of the time among those that are asked for, and the time as a pair.
    """

    vertices: tuple[int, ...]
    signs: tuple[float, ...]
    weight: float
    goal: Callable[[int, Array], Array]

    def rest(self, goal: Array, moved: Array) -> Array:
        """What the vertices ``moved``, pairs (vertices, 2, 2), leave of a goal."""
        for vertex, sign in zip(self.vertices, self.signs, strict=True):
            goal = subtract(goal, sign * moved[vertex])
        return goal


@dataclass(frozen=True)
class Held:
    """Constraints that have been read: single vertices exactly in their places, other terms, and those of the mean."""

    fixed: tuple[Term, ...]
    soft: tuple[Term, ...]
    means: tuple[Term, ...]

    @property
    def placed(self) -> list[int]:
        """The vertices that have a place."""
        return [term.vertices[0] for term in (*self.fixed, *self.soft) if len(term.vertices) == 1]

    def entries(self) -> tuple[Indices, Indices, Array]:
        """Rows, columns and values of what the soft terms add to the matrix of all errors."""
        found = [
            (row, column, term.weight * sign * other)
            for term in self.soft
            for row, sign in zip(term.vertices, term.signs, strict=True)
            for column, other in zip(term.vertices, term.signs, strict=True)
        ]
        rows, columns, values = np.array(found).reshape(-1, 3).T
        return rows.astype(np.intp), columns.astype(np.intp), values

    def require(self, source: Array, rigid: bool) -> None:
        """InputError unless the minimiser is unique; if not ``rigid``, the errors leave similarities free."""
        if not (self.placed or self.means):
            raise InputError("constraints", NOWHERE)
        places = [source[vertex] for vertex in self.placed] + [source.mean(axis=0)] * bool(self.means)
        edges = [source[i] - source[j] for i, j in (term.vertices for term in self.soft if len(term.vertices) == 2)]
        if not rigid and not np.any([*edges, *(place - places[0] for place in places)]):
            raise InputError("constraints", COLLAPSING)


def read(constraints: Iterable[Constraint], count: int, batch: tuple[int, ...], exponent: int) -> Held:
    """The constraints on ``count`` vertices at times of the shape ``batch``, lengths divided by 2^exponent."""
    fixed, soft, means = [], [], []
    for each in constraints:
        goal = _goal(each.path, batch, exponent)
        if not each.weight > 0.0 or (each.weight == math.inf and not isinstance(each, Locus)):
            raise InputError("constraints", f"a weight of {each.weight}")
        if isinstance(each, Barycentre):
            means.append(Term((), (), each.weight, goal))
            continue
        vertices, signs = (
            ((each.vertex,), (1.0,)) if isinstance(each, Locus) else ((each.second, each.first), (1.0, -1.0))
        )
        if not all(0 <= vertex < count for vertex in vertices):
            raise InputError("constraints", f"no vertex has the index {min(vertices)} or {max(vertices)}")
        (fixed if each.weight == math.inf else soft).append(Term(vertices, signs, each.weight, goal))
    once = {term.vertices for term in fixed}
    if len(once) < len(fixed):
        raise InputError("constraints", "a vertex is exactly in two places")
    return Held(tuple(fixed), tuple(soft), tuple(means))


def _goal(path: Path, batch: tuple[int, ...], exponent: int) -> Callable[[int, Array], Array]:
    if callable(path):
        return lambda _, t: _point(path(float(t[0])), exponent)
    samples = np.asarray(path, dtype=np.float64)
    if samples.shape != (*batch, 2):
        raise InputError("constraints", f"a path of shape {samples.shape} where {(*batch, 2)} is due")
    return lambda number, _: _point(samples.reshape(-1, 2)[number], exponent)


def _point(value: ArrayLike, exponent: int) -> Array:
    point = np.asarray(value, dtype=np.float64)
    if point.shape != (2,) or not np.isfinite(point).all():
        raise InputError("constraints", f"{value} on a path, where a point of the plane is due")
    return widen(np.ldexp(point, -exponent))
