"""Constraints on a moving mesh of the plane: squares of linear functions of its vertices."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast import _homotopy
from affinecert.fast._homotopy import complex_product, conjugate, squared
from affinecert.fast._kernel import Array
from affinecert.fast._sparse import total
from affinecert.fast._triangulation import Indices
from affinecert.fast._wide import add, divide, multiply, subtract, times, widen

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
    """The mean of all vertices is to be given: the term weight |mean - path|^2, exactly so if there is no `Locus`."""

    path: Path
    weight: float = 1.0


Constraint = Locus | Edge | Barycentre

NOWHERE = "one of them must be a Locus or a Barycentre, or nothing holds the shape in its place"
ONE_PLACE = "the first and the last vertex are in one place"
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

    @property
    def mean_weight(self) -> float:
        """The weights of the mean together."""
        return math.fsum(term.weight for term in self.means)

    def centre(self, number: int, t: Array) -> Array:
        """Where the mean is to be: the mean of its places by their weights."""
        if not self.means:
            return np.zeros((2, 2))
        weighted = total(np.stack([times(term.goal(number, t), term.weight) for term in self.means]))
        return divide(weighted, total(np.stack([widen(np.array(term.weight)) for term in self.means])))

    def add_slope(self, slope: Array, goals: Iterable[Array], moved: Array) -> None:
        """Adds half the gradient, downwards, of the soft terms, given their goals, at the vertices ``moved``."""
        for term, goal in zip(self.soft, goals, strict=True):
            rest = times(term.rest(goal, moved), term.weight)
            for vertex, sign in zip(term.vertices, term.signs, strict=True):
                slope[vertex] = add(slope[vertex], sign * rest)

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
    fixed: list[Term] = []
    soft: list[Term] = []
    means: list[Term] = []
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
        raise InputError("constraints", f"{value!r} on a path, where a point of the plane is due")
    return widen(np.ldexp(point, -exponent))


def _straight(source: Array, target: Array, vertex: int) -> Term:
    """The vertex moves linearly."""
    start = widen(source[vertex])
    way = subtract(widen(target[vertex]), start)
    return Term((vertex,), (1.0,), math.inf, lambda _, t: add(start, multiply(way, t)))


def first_linearly(source: Array, target: Array, _: int) -> Held:
    """The first vertex moves linearly."""
    return Held((_straight(source, target, 0),), (), ())


def ends_as_a_similarity(source: Array, target: Array, _: int) -> Held:
    """The first vertex moves linearly, and the last about it by the homotopy of the similarity of these two."""
    first = _straight(source, target, 0)
    before, after = (subtract(widen(shape[-1]), widen(shape[0]))[None] for shape in (source, target))
    for name, vector in (("source", before), ("target", after)):
        if not vector.any():
            raise InputError(name, ONE_PLACE)
    square = squared(before)
    ratio = divide(complex_product(after, conjugate(before)), square[:, None, :])
    factors = _homotopy.factors(ratio, np.zeros_like(ratio), divide(squared(after), square))

    def place(number: int, t: Array) -> Array:
        grown, _ = _homotopy.turned(factors, _homotopy.exponential(factors, t), t)
        return add(first.goal(number, t), complex_product(grown, before)[0])

    return Held((first, Term((len(source) - 1,), (1.0,), math.inf, place)), (), ())


def pulled_last(place: Array, weight: float) -> Callable[[Array, Array, int], Held]:
    """The first vertex moves linearly, and the last is pulled to a place with that weight."""

    def hold(source: Array, target: Array, exponent: int) -> Held:
        point = _point(place, exponent)
        last = Term((len(source) - 1,), (1.0,), weight, lambda _number, _t: point)
        return Held((_straight(source, target, 0),), (last,), ())

    return hold
