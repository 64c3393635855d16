"""Interpolation of triangulated shapes of the plane as piecewise affine maps.

Triangle i is moved by the affine map of linear part A_i from the source to the target, and A_i(t) is a homotopy from I
to it (`affinecert.fast.homotopy2`). The shape at the time t has those vertices v that make the sum of the errors
E_i(A_i(t), B_i), and of constraints, least; B_i, linear in v, is the linear part of the map from triangle i of the
source to that of v.

    E^F  |A - B|_F^2
    E^R  min |s R_delta A - B|_F^2 over s and delta
    E^S  min sum_k |s R_delta A p_k + d - v_k|^2 over s, delta and d, p_k and v_k the three corners

With the plane as that of complex numbers all of these are Hermitian in v, half the size that they have in coordinates.
The matrix of E^F does not depend on the time, and is factored once for all times. Those of E^R and E^S do: with A_i(t)
the map z -> a z + b conj(z) and B_i the map z -> alpha z + beta conj(z), they are multiples of |a beta - b alpha|^2.
That depends on b / a alone, so that neither scale nor rotation of A_i(t) matter, but b / a changes with the time,
unless A_i is a similarity, where it is 0. So the matrix is factored for each time. (The appendix says that it is the
same for all times.)

All but these factors is computed in double-double arithmetic; the solution is refined, and rounded once.

Source: Kaji, Hirose, Sakata, Mizoguchi, Anjyo, "Mathematical analysis on affine maps for 2D shape interpolation", 2012,
section 4 and appendix.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property, partial, reduce
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from affinecert.errors import InputError
from affinecert.fast import _homotopy
from affinecert.fast._batches import each
from affinecert.fast._homotopy import ONE, complex_product, conjugate, squared
from affinecert.fast._kernel import Array, Shape, as_float64, checked
from affinecert.fast._mesh_constraints import Barycentre, Constraint, Edge, Held, Locus, Term, read
from affinecert.fast._mesh_errors import GROWTHS, Errors, Goal, Homotopies, homotopies
from affinecert.fast._sparse import Pattern, factored, pattern, refined, total, without_threads_of_blas
from affinecert.fast._triangulation import Indices, indices, twice_areas
from affinecert.fast._wide import add, divide, multiply, rounded, subtract, times, widen

__all__ = [
    "Barycentre",
    "Edge",
    "Locus",
    "balanced",
    "constrained",
    "frobenius",
    "interpolate",
    "points",
    "similarity",
    "symmetric",
]

Energy = Literal["frobenius", "similarity", "points"]
Homotopy = Literal["linear", "polar", "exponential"]
Angles = Literal["principal", "coherent"]
ENERGIES, ANGLES = get_args(Energy), get_args(Angles)

Hold = Callable[[Array, Array, int], Held]
"""The constraints for a source and a target that have been divided by 2^exponent, and that exponent."""

MESH: Mapping[str, Shape] = {"source": ("vertices", 2), "target": ("vertices", 2), "triangles": ("faces", 3), "t": ()}

NO_AREA = "a triangle without area"
TURNED_OVER = "a triangle without area, or turned over"
ONE_PLACE = "the first and the last vertex are in one place"
OUT_OF_BALANCE = "not in [0, 1]"
NOT_UNIQUE = "the minimiser is not unique, or too ill-conditioned to be told"

# Each thread has factors of its own, a hundred megabytes for a hundred thousand triangles.
MOST_WORKERS = 4


@dataclass(frozen=True)
class _Way:
    """The errors of one direction of the interpolation: from source to target, or ``backwards`` from target to source."""

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

    @property
    def count(self) -> int:
        """How many vertices there are."""
        return len(self.ways[0].errors.source)

    @cached_property
    def free(self) -> NDArray[np.bool_]:
        """Which vertices are not in given places; if none has a place, the first one is at 0 to begin with."""
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
        """The weight of the mean; 0 where the mean is moved to its place in the end."""
        return math.fsum(term.weight for term in self.held.means) if self.held.placed else 0.0

    def prepare(self) -> Callable[[Array], Array] | None:
        """What solves the equations of all times; None if they differ."""
        if any(way.errors.by_similarity for way in self.ways):
            return None
        return self.solver([way.goal(ONE) for way in self.ways])

    def solver(self, goals: Iterable[Goal]) -> Callable[[Array], Array]:
        """What gives a step, (vertices, 2), for half a gradient."""
        blocks = sum(way.errors.blocks(goal) for way, goal in zip(self.ways, goals, strict=True))
        factors = factored(self.pattern.matrix(np.concatenate([np.ravel(blocks), self.held.entries()[2]])))
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

    def at(self, number: int, time: float, solve: Callable[[Array], Array] | None) -> Array:
        """The vertices at a time, (vertices, 2); ``solve`` is what `prepare` gave."""
        t = widen(np.array(time))
        goals = [way.goal(t) for way in self.ways]
        places = [term.goal(number, t) for term in self.held.soft]
        mean = self.mean_place(number, t)
        start = np.zeros((self.count, 2, 2))
        for term in self.held.fixed:
            start[term.vertices[0]] = term.goal(number, t)

        def slope(moved: Array) -> Array:
            found = reduce(add, [way.errors.slope(goal, moved) for way, goal in zip(self.ways, goals, strict=True)])
            for term, place in zip(self.held.soft, places, strict=True):
                rest = times(term.rest(place, moved), term.weight)
                for vertex, sign in zip(term.vertices, term.signs, strict=True):
                    found[vertex] = add(found[vertex], sign * rest)
            if self.pull:
                found = add(found, self.mean_of(times(subtract(mean, self.mean_of(total(moved))), self.pull)))
            found[~self.free] = 0.0
            return found

        moved = refined(start, slope, solve or self.solver(goals))
        if moved is None:
            raise InputError("triangles", NOT_UNIQUE)
        if not self.held.placed:
            moved = add(moved, subtract(mean, self.mean_of(total(moved))))
        return rounded(moved)

    def mean_of(self, sums: Array) -> Array:
        """The mean over vertices, given their sum."""
        return divide(sums, widen(np.array(float(self.count))))

    def mean_place(self, number: int, t: Array) -> Array:
        """The mean of the places that are given to the mean, by their weights."""
        if not self.held.means:
            return np.zeros((2, 2))
        weighted = total(np.stack([times(term.goal(number, t), term.weight) for term in self.held.means]))
        return divide(weighted, total(np.stack([widen(np.array(term.weight)) for term in self.held.means])))


def _straight(source: Array, target: Array, vertex: int) -> Term:
    """The vertex moves linearly."""
    start = widen(source[vertex])
    way = subtract(widen(target[vertex]), start)
    return Term((vertex,), (1.0,), math.inf, lambda _, t: add(start, multiply(way, t)))


def _first(source: Array, target: Array, _: int) -> Held:
    return Held((_straight(source, target, 0),), (), ())


def _ends(source: Array, target: Array, _: int) -> Held:
    """The first vertex on its line, and the last one about it as a similarity has it."""
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


@dataclass(frozen=True)
class _Options:
    """How the errors are made; see `interpolate`."""

    energy: Energy = "frobenius"
    homotopy: Homotopy = "exponential"
    weights: Array | None = None
    balance: Array | None = None
    symmetric: bool = False
    coherent: bool = False


def _problem(source: Array, target: Array, triangles: Indices, options: _Options, hold: Hold) -> tuple[_Problem, int]:
    """The problem in lengths divided by 2^exponent, and that exponent."""
    exponent = int(np.frexp(np.abs(source).max())[1])
    shapes = [np.ldexp(shape, -exponent) for shape in (source, target)]
    areas = [twice_areas(shape, triangles) for shape in shapes]
    if not areas[0][:, 0].all():
        raise InputError("source", NO_AREA)
    if (np.sign(areas[0][:, 0]) != np.sign(areas[1][:, 0])).any():
        raise InputError("target", TURNED_OVER)
    ways = tuple(
        _way(shapes[one], shapes[1 - one], triangles, (areas[one], areas[1 - one]), options, bool(one), exponent)
        for one in range(1 + options.symmetric)
    )
    return _Problem(ways, hold(*shapes, exponent)), exponent


def _way(
    source: Array,
    target: Array,
    triangles: Indices,
    areas: tuple[Array, Array],
    options: _Options,
    backwards: bool,
    exponent: int,
) -> _Way:
    by_points = options.energy == "points"
    # All terms are divided by 4^exponent, the square of the unit of length: so those of constraints stay as they are.
    # An area has that factor, and E^S; E^F and E^R have no unit.
    if options.weights is None:
        weights = np.ldexp(0.5 * areas[0] * np.sign(areas[0][:, :1]), 2 * exponent * by_points)
    else:
        weights = widen(np.ldexp(options.weights, 2 * exponent * (by_points - 1)))
    balance = (1.0 if options.energy == "frobenius" else 0.0) if options.balance is None else options.balance
    share = widen(np.broadcast_to(balance, len(triangles)).astype(np.float64))
    parts = np.stack([multiply(weights, share), multiply(weights, subtract(ONE, share))], axis=1)
    known = homotopies(source, target, triangles, areas, options.homotopy, options.coherent)
    return _Way(Errors(source, triangles, parts, by_points), known, backwards)


def _moving(
    source: Array, target: Array, triangles: Array, options: _Options, hold: Hold
) -> Callable[[Array, int], Array]:
    """What takes times (count,) and a number of threads to shapes (count, vertices, 2)."""
    problem, exponent = _problem(source, target, indices(triangles, len(source)), options, hold)
    with without_threads_of_blas():
        at = partial(problem.at, solve=problem.prepare())

    def shapes(moments: Array, workers: int = 1) -> Array:
        numbered = range(len(moments)), moments.tolist()
        with without_threads_of_blas():
            if workers > 1:
                with ThreadPoolExecutor(workers) as pool:
                    frames = list(pool.map(at, *numbered))
            else:
                frames = list(map(at, *numbered))
        return np.ldexp(np.reshape(frames, (-1, len(source), 2)), exponent)

    return shapes


def interpolate(
    source: ArrayLike,
    target: ArrayLike,
    triangles: ArrayLike,
    t: ArrayLike,
    *,
    homotopy: Homotopy = "exponential",
    energy: Energy = "similarity",
    weights: ArrayLike | None = None,
    balance: ArrayLike | None = None,
    constraints: Iterable[Constraint] | None = None,
    symmetric: bool = False,
    angles: Angles = "principal",
    workers: int | None = None,
) -> Array:
    """The shapes between two triangulated shapes of the plane.

    source and target (vertices, 2), triangles (faces, 3) of indices from 0, and t (...), any number; gives (...,
    vertices, 2). Triangles may have either orientation, the same one in both shapes.

    ``energy`` is "frobenius" (E^F), "similarity" (E^R) or "points" (E^S), and ``homotopy`` the one of the triangles'
    linear parts. The errors are weighted with the areas in the source, or with ``weights`` (faces,). With a
    ``balance`` w in [0, 1], one or (faces,), "similarity" means w E^F + (1 - w) E^R. ``constraints`` are terms `Locus`,
    `Edge` and `Barycentre`; without any, the first vertex moves linearly, and for E^R and E^S the last vertex moves
    about it by the exponential homotopy of the similarity that takes one edge between them to the other: for these
    errors see neither rotation nor size, and would be least in a single point. (The first vertex is that of Alexa,
    Cohen-Or and Levin; "(1 - t) p_1 + t p_1" in the paper is a misprint for "(1 - t) p_1 + t q_1".) If ``symmetric``,
    those of the way back at 1 - t are added to the errors, with the areas of the target.

    Angles of rotation are "principal", in (-pi, pi], or "coherent": with whole turns added so that they change by half
    a turn at most between neighbours, from the first triangle on. E^R and E^S do not depend on them.

    ``workers`` is the number of threads that share the times, by default one for each processor, at most 4; the result
    does not depend on it. Raises InputError for wrong shapes and dtypes, numbers that are not finite, triangles that
    are no triples of different vertices, a mesh that is not one piece with all vertices, a triangle without area or
    turned over, weights that are not positive, a balance outside [0, 1], and constraints that leave the minimiser
    undetermined.

    >>> square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    >>> turned = square @ [[0.0, 2.0], [-2.0, 0.0]]
    >>> interpolate(square, turned, [[0, 1, 2], [0, 2, 3]], 0.5).round(6) + 0.0
    array([[ 0.,  0.],
           [ 1.,  1.],
           [ 0.,  2.],
           [-1.,  1.]])
    """
    (first, last, moments), _, _ = checked(
        {"source": ("vertices", 2), "target": ("vertices", 2), "t": ()}, (source, target, t)
    )
    for name, shape in (("source", first), ("target", last)):
        if shape.ndim > 2:
            raise InputError(name, f"shape {shape.shape} where (vertices, 2) is due")
    faces = _faces(triangles)
    for name, value, values in (
        ("energy", energy, ENERGIES),
        ("homotopy", homotopy, GROWTHS),
        ("angles", angles, ANGLES),
    ):
        if value not in values:
            raise InputError(name, f"{value!r} where one of {', '.join(map(repr, values))} is due")
    options = _Options(
        energy,
        homotopy,
        None if weights is None else _positive(weights, len(faces)),
        None if balance is None else _balance(balance, len(faces), energy),
        symmetric,
        angles == "coherent",
    )

    def hold(start: Array, end: Array, exponent: int) -> Held:
        if constraints is None:
            return (_first if energy == "frobenius" else _ends)(start, end, exponent)
        held = read(constraints, len(start), moments.shape, exponent)
        held.require(start, rigid=energy == "frobenius" or (options.balance is not None and options.balance.any()))
        return held

    threads = min(workers or min(os.cpu_count() or 1, MOST_WORKERS), moments.size)
    frames = _moving(first, last, faces, options, hold)(moments.ravel(), threads)
    return frames.reshape(*moments.shape, *first.shape)


def _faces(triangles: ArrayLike) -> Array:
    """Triangles given by whole numbers of any dtype, (faces, 3), as float64."""
    array = np.asarray(triangles)
    if array.dtype.kind not in "iuf":
        raise InputError("triangles", f"dtype {array.dtype} where whole numbers are due")
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError("triangles", f"shape {array.shape} where (faces, 3) is due")
    return array.astype(np.float64)


def _positive(weights: ArrayLike, count: int) -> Array:
    array = as_float64("weights", weights)
    if array.shape != (count,):
        raise InputError("weights", f"shape {array.shape} where ({count},) is due")
    if not (np.isfinite(array) & (array > 0.0)).all():
        raise InputError("weights", "not positive and finite")
    return array


def _balance(balance: ArrayLike, count: int, energy: str) -> Array:
    array = as_float64("balance", balance)
    if array.shape not in ((), (count,)):
        raise InputError("balance", f"shape {array.shape} where () or ({count},) is due")
    if energy != "similarity":
        raise InputError("balance", f"given for {energy!r}; it is between E^F and E^R, the energy 'similarity'")
    if not ((array >= 0.0) & (array <= 1.0)).all():
        raise InputError("balance", OUT_OF_BALANCE)
    return np.broadcast_to(array, count)


def frobenius(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike) -> Array:
    """`interpolate` with E^F, weighted with areas: the first vertex moves linearly.

    source and target (..., vertices, 2), triangles (..., faces, 3) as float64, t (...); gives (..., vertices, 2).
    Raises InputError as `interpolate` does.
    """
    return _each(MESH, (source, target, triangles, t), lambda: (_Options(), _first))


def points(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike) -> Array:
    """`interpolate` with E^S, weighted with areas: the first and the last vertex move as a similarity has it.

    Shapes and errors are those of `frobenius`; besides, these two vertices must not be in one place.
    """
    return _each(MESH, (source, target, triangles, t), lambda: (_Options("points"), _ends))


def similarity(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike) -> Array:
    """`interpolate` with E^R, weighted with areas: the first and the last vertex move as a similarity has it.

    Shapes and errors are those of `points`.
    """
    return _each(MESH, (source, target, triangles, t), lambda: (_Options("similarity"), _ends))


def balanced(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike, balance: ArrayLike) -> Array:
    """`interpolate` with w E^F + (1 - w) E^R, w the balance, (..., faces), in [0, 1].

    Otherwise as `similarity`.
    """

    def settled(share: Array) -> tuple[_Options, Hold]:
        return _Options("similarity", balance=_balance(share, len(share), "similarity")), _ends

    return _each(MESH | {"balance": ("faces",)}, (source, target, triangles, t, balance), settled)


def constrained(
    source: ArrayLike,
    target: ArrayLike,
    triangles: ArrayLike,
    t: ArrayLike,
    place: ArrayLike,
    weight: ArrayLike,
) -> Array:
    """`interpolate` with E^F, the first vertex moving linearly, and a `Locus` of the last vertex.

    place (..., 2) is where it should be, weight (...) positive. Otherwise as `frobenius`.
    """

    def settled(goal: Array, pull: Array) -> tuple[_Options, Hold]:
        if not pull > 0.0:
            raise InputError("weight", "not positive")

        def hold(start: Array, end: Array, exponent: int) -> Held:
            point = widen(np.ldexp(goal, -exponent))
            last = Term((len(start) - 1,), (1.0,), float(pull), lambda _number, _t: point)
            return Held((_straight(start, end, 0),), (last,), ())

        return _Options(), hold

    inputs = MESH | {"place": (2,), "weight": ()}
    return _each(inputs, (source, target, triangles, t, place, weight), settled)


def symmetric(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike) -> Array:
    """`interpolate` with E^F, symmetrised: the way back is the same backwards. The first vertex moves linearly.

    Shapes and errors are those of `frobenius`.
    """
    return _each(MESH, (source, target, triangles, t), lambda: (_Options(symmetric=True), _first))


def _each(
    inputs: Mapping[str, Shape], arguments: tuple[ArrayLike, ...], settled: Callable[..., tuple[_Options, Hold]]
) -> Array:
    """The shapes of a batch; ``settled`` makes options and constraints of the arguments after the time."""

    def prepare(source: Array, target: Array, triangles: Array, *more: Array) -> Callable[[Array], Array]:
        shapes = _moving(source, target, triangles, *settled(*more))
        return lambda t: shapes(t[None])[0]

    return each(inputs, arguments, "t", prepare, ("vertices", 2))
