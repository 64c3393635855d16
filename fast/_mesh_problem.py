"""Interpolation of a mesh of the plane as a least squares problem at each time, solved and refined.

With the plane as that of complex numbers all errors are Hermitian in the vertices. The matrix of E^F does not depend on
the time, and is factored once. Those of E^R and E^S do: with A(t) the map z -> a z + b conj(z) and B the map
z -> alpha z + beta conj(z), they are multiples of |a beta - b alpha|^2, which depends on b / a alone, so that neither
scale nor rotation of A(t) matter; but b / a changes with the time, unless A is a similarity, where it is 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property, partial, reduce

import numpy as np
from numpy.typing import NDArray

from affinecert.errors import InputError
from affinecert.fast._homotopy import ONE
from affinecert.fast._kernel import Array
from affinecert.fast._mesh_constraints import Held
from affinecert.fast._mesh_errors import Errors, Goal, Homotopies, homotopies
from affinecert.fast._sparse import Pattern, factored, mean, pattern, refined, without_threads_of_blas
from affinecert.fast._triangulation import Indices, indices, pieces, twice_areas
from affinecert.fast._wide import add, divide, multiply, rounded, subtract, times, widen

Hold = Callable[[Array, Array, int], Held]
"""The constraints for a source and a target that have been divided by 2^exponent, and that exponent."""

Solve = Callable[[Array], Array]
"""What gives a step, (vertices, 2), for half a gradient."""

NO_AREA = "a triangle without area"
TURNED_OVER = "a triangle without area, or turned over"
HINGED = "pieces that hang together by vertices only, which E^R and E^S leave free to turn and to collapse"
NOT_UNIQUE = "the minimiser is not unique, or too ill-conditioned to be told"


@dataclass(frozen=True)
class Options:
    """How errors are made, as `affinecert.fast.mesh2.interpolate` has it."""

    energy: str = "frobenius"
    homotopy: str = "exponential"
    weights: Array | None = None
    balance: Array | None = None
    symmetric: bool = False
    coherent: bool = False


@dataclass(frozen=True)
class _Way:
    """The errors of one direction of the interpolation: from source to target, or ``backwards``."""

    errors: Errors
    homotopies: Homotopies
    backwards: bool

    def goal(self, t: Array) -> Goal:
        """The maps of the triangles at a time of the interpolation, a pair; unturned where turning changes nothing."""
        return self.homotopies.at(subtract(ONE, t) if self.backwards else t, turned=self.errors.directly)


@dataclass(frozen=True)
class _Problem:
    """What is minimised: the errors of one or two ways, and the terms of constraints."""

    ways: tuple[_Way, ...]
    held: Held

    @cached_property
    def count(self) -> int:
        """How many vertices there are."""
        return len(self.ways[0].errors.source)

    @cached_property
    def free(self) -> NDArray[np.bool_]:
        """Which vertices are to be found; if nothing has a place, the first one stays at 0 and all are moved later."""
        mask = np.ones(self.count, dtype=np.bool_)
        mask[[term.vertices[0] for term in self.held.fixed] if self.held.placed else [0]] = False
        return mask

    @cached_property
    def pattern(self) -> Pattern:
        """Where the matrix has entries."""
        rows, columns, _ = self.held.entries()
        return pattern(self.ways[0].errors.triangles, rows, columns, self.free)

    @cached_property
    def pull(self) -> float:
        """The weight of the mean of all vertices; 0 where it is moved to its place in the end."""
        return self.held.mean_weight if self.held.placed else 0.0

    def prepare(self) -> Solve | None:
        """What solves the equations of all times; None if they differ."""
        if any(way.errors.by_similarity for way in self.ways):
            return None
        return self.solver([way.goal(ONE) for way in self.ways])

    def solver(self, goals: Iterable[Goal]) -> Solve:
        """What solves the equations, up to rounding, with these maps of the triangles."""
        blocks = reduce(np.add, [way.errors.blocks(goal) for way, goal in zip(self.ways, goals, strict=True)])
        factors = factored(self.pattern.matrix(np.concatenate([blocks.ravel(), self.held.entries()[2]])))
        if factors is None:
            raise InputError("triangles", NOT_UNIQUE)
        # The mean adds ``pull`` / count^2 to every entry of the matrix: a term of rank one (Sherman and Morrison).
        answer = factors.solve(self.free.astype(np.complex128)) if self.pull else np.zeros(self.count)
        gain = self.pull / (self.count**2 + self.pull * answer[self.free].sum())

        def solve(slope: Array) -> Array:
            step = factors.solve(slope @ np.array([1.0, 1j]))
            step -= answer * (gain * step[self.free].sum())
            return np.stack([step.real, step.imag], axis=-1)

        return solve

    def at(self, number: int, time: float, solve: Solve | None) -> Array:
        """The vertices at a time, (vertices, 2), given its number; ``solve`` is what `prepare` gave."""
        t = widen(np.array(time))
        goals = [way.goal(t) for way in self.ways]
        places = [term.goal(number, t) for term in self.held.soft]
        centre = self.held.centre(number, t)
        start = np.zeros((self.count, 2, 2))
        for term in self.held.fixed:
            start[term.vertices[0]] = term.goal(number, t)

        def slope(moved: Array) -> Array:
            found = reduce(add, [way.errors.slope(goal, moved) for way, goal in zip(self.ways, goals, strict=True)])
            self.held.add_slope(found, places, moved)
            if self.pull:
                each = times(subtract(centre, mean(moved)), self.pull)
                found = add(found, divide(each, widen(np.array(float(self.count)))))
            found[~self.free] = 0.0
            return found

        moved = refined(start, slope, solve or self.solver(goals))
        if moved is None:
            raise InputError("triangles", NOT_UNIQUE)
        return rounded(moved if self.held.placed else add(moved, subtract(centre, mean(moved))))


def moving(
    source: Array, target: Array, triangles: Array, options: Options, hold: Hold
) -> Callable[[Array, int], Array]:
    """What takes times (count,) and a number of threads to shapes (count, vertices, 2).

    Source and target (vertices, 2), triangles (faces, 3) as float64. Raises InputError for what is no mesh, or for E^R
    and E^S not connected by edges, and for triangles without area or turned over; what is returned does where the
    minimiser is not unique.
    """
    exponent = int(np.frexp(np.abs(source).max())[1])
    faces = indices(triangles, len(source))
    if options.energy != "frobenius":
        _require_edges(faces, np.zeros(len(faces)) if options.balance is None else options.balance)
    shapes = np.ldexp(source, -exponent), np.ldexp(target, -exponent)
    areas = twice_areas(shapes[0], faces), twice_areas(shapes[1], faces)
    if not areas[0][:, 0].all():
        raise InputError("source", NO_AREA)
    if (np.sign(areas[0][:, 0]) != np.sign(areas[1][:, 0])).any():
        raise InputError("target", TURNED_OVER)
    ways = [_way(shapes, areas, faces, options, exponent, backwards=False)]
    if options.symmetric:
        ways.append(_way(shapes[::-1], areas[::-1], faces, options, exponent, backwards=True))
    problem = _Problem(tuple(ways), hold(*shapes, exponent))
    with without_threads_of_blas():
        at = partial(problem.at, solve=problem.prepare())

    def frames(moments: Array, workers: int) -> Array:
        numbered = range(len(moments)), moments.tolist()
        with without_threads_of_blas():
            if workers > 1:
                with ThreadPoolExecutor(workers) as pool:
                    found = list(pool.map(at, *numbered))
            else:
                found = list(map(at, *numbered))
        return np.ldexp(np.reshape(found, (-1, len(source), 2)), exponent)

    return frames


def _require_edges(triangles: Indices, balance: Array) -> None:
    """InputError for several pieces, connected by vertices only, in one of which E^F has no share."""
    numbers = pieces(triangles)
    if numbers.any() and not np.bincount(numbers, balance).all():
        raise InputError("triangles", HINGED)


def _way(
    shapes: tuple[Array, Array],
    areas: tuple[Array, Array],
    triangles: Indices,
    options: Options,
    exponent: int,
    backwards: bool,
) -> _Way:
    by_points = options.energy == "points"
    # All terms are divided by 4^exponent, the square of the unit of length: so those of constraints stay as they are.
    # An area has that factor, and E^S; E^F and E^R have no unit.
    if options.weights is None:
        weights = np.ldexp(0.5 * areas[0] * np.sign(areas[0][:, :1]), 2 * exponent * by_points)
    else:
        weights = widen(np.ldexp(options.weights, 2 * exponent * (by_points - 1)))
    balance = np.array(float(options.energy == "frobenius")) if options.balance is None else options.balance
    share = widen(np.broadcast_to(balance, len(triangles)))
    parts = np.stack([multiply(weights, share), multiply(weights, subtract(ONE, share))], axis=1)
    known = homotopies(*shapes, triangles, areas, options.homotopy, options.coherent)
    return _Way(Errors(shapes[0], triangles, parts, by_points), known, backwards)
