"""Section 4 and the appendix: the minimiser of the global error, how it is computed, and what it interpolates."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays, plane_rotation
from affinecert.properties.claims.kaji_2d.degeneration import Homotopy
from affinecert.properties.claims.kaji_2d.errors import frobenius, similarity
from affinecert.properties.claims.kaji_2d.homotopies import exponential, linear, polar
from affinecert.properties.claims.kaji_2d.plane import angle, determinant, square, zero_or_one
from affinecert.properties.claims.kaji_2d.shapes import (
    FAN,
    SQUARE,
    STRIP,
    TRIANGLE,
    Constraint,
    Error,
    Mesh,
    linear_parts,
    minimum,
    precise,
    total,
)
from affinecert.properties.claims.precision import difference, distance, exactly, mp
from affinecert.reference._matrices import Array, Number, array

Task = tuple[Mesh, Array, Number]
"""A mesh, the places of its vertices in the target, and a time."""


Place = Callable[[Array, Array, Number], Array]
"""Where the constraint of Alexa et al. has the first vertex: a function of p₁, q₁ and t."""


def straight(p: Array, q: Array, t: Number) -> Array:
    """The place on the line from p to q."""
    place: Array = (1 - t) * p + t * q
    return place


def held(*places: tuple[int, Array], weight: Number = 1) -> Constraint:
    """The weighted sum of |u_i - v_i|² over some vertices."""
    return lambda moved: weight * sum(square(place - moved[i]) for i, place in places)


def goals(mesh: Mesh, target: Array, t: Number, homotopy: Homotopy = exponential) -> list[Array]:
    """A_i(t), triangle by triangle."""
    return [homotopy(a, t) for a in linear_parts(mesh, target)]


@cache
def targets(mesh: Mesh, count: int = 2) -> tuple[Array, ...]:
    """So many drawn targets in which no triangle is turned over: the source plus an offset, turned."""
    offsets = arrays(f"target of {mesh.name}", 60, mesh.vertices.shape, -0.5, 0.5)
    found = []
    for number, offset in enumerate(offsets):
        moved = mesh.vertices + offset + exactly([1, 2])
        if all(determinant(each) > 0 for each in linear_parts(mesh, moved)):
            found.append((plane_rotation(mp.mpf(number % 5) / 2) @ moved.T).T)
    return tuple(found[:count])


@cache
def meshes() -> tuple[Mesh, ...]:
    """The meshes of the checks, in mpf."""
    return tuple(map(precise, (TRIANGLE, SQUARE, STRIP, FAN)))


def tasks(*times: float) -> list[Task]:
    """Meshes, each with a target, and these times."""
    return [(mesh, targets(mesh, 1)[0], mp.mpf(t)) for mesh in meshes() for t in times]


def interpolated(task: Task, error: Error = frobenius, homotopy: Homotopy = exponential) -> Array:
    """The minimiser with the first vertex on its line and, for E^R, the last one too."""
    mesh, target, t = task
    ends = [0] if error is frobenius else [0, len(target) - 1]
    places = [(i, straight(mesh.vertices[i], target[i], t)) for i in ends]
    return minimum(total(mesh, error, goals(mesh, target, t, homotopy), held(*places)), len(target))


def _with_first_at(place: Place, task: Task) -> Number:
    """How far the minimiser of E^F is from the target at t = 1, from the source at 0."""
    mesh, target, t = task
    constraint = held((0, place(mesh.vertices[0], target[0], t)))
    found = minimum(total(mesh, frobenius, goals(mesh, target, t), constraint), len(target))
    return difference(found, target if t else mesh.vertices)


def _misses_the_ends(homotopy: Homotopy, task: Task) -> Number:
    mesh, target, t = task
    due = target if t else mesh.vertices
    return max(difference(interpolated(task, error, homotopy), due) for error in (frobenius, similarity))


def _moved_by_one() -> list[Task]:
    triangle = precise(TRIANGLE)
    return [(triangle, triangle.vertices + array([1, 0]), mp.one), *tasks(0, 1)]


def _inhomogeneous(constrained: Any, case: tuple[Mesh, Array, Number]) -> Number:
    """How far B_i are from A(t) where all triangles have the same A, for each homotopy."""
    mesh, a, t = case
    target = (a @ mesh.vertices.T).T
    gap = mp.zero
    for homotopy in (linear, polar, exponential):
        constraint = constrained(mesh, target, t)
        found = minimum(total(mesh, frobenius, goals(mesh, target, t, homotopy), constraint), len(target))
        gap = max(gap, *(difference(each, homotopy(a, t)) for each in linear_parts(mesh, found)))
    return gap


def _first(mesh: Mesh, target: Array, t: Number) -> Constraint:
    return held((0, straight(mesh.vertices[0], target[0], t)))


def _both(mesh: Mesh, target: Array, t: Number) -> Constraint:
    return held(*((i, straight(mesh.vertices[i], target[i], t)) for i in (0, len(target) - 1)))


def _global_maps() -> list[tuple[Mesh, Array, Number]]:
    drawn = [[[0, -1], [1, 0]], [[2, 0], [0, 1]], [[-1, 1], [-1, -2]], [[1, -2], [1, 1]]]
    return [(mesh, exactly(a), mp.mpf(3) / 8) for mesh, a in zip(meshes(), drawn, strict=True)]


def _depends_on_turns(error: Error, task: Task) -> Number:
    """The change of the minimiser if triangle i makes i + 1 turns more on its way."""
    mesh, target, t = task
    places = held(*((i, straight(mesh.vertices[i], target[i], t)) for i in (0, len(target) - 1)))
    once = goals(mesh, target, t)
    more = [plane_rotation(2 * mp.pi * (i + 1) * t) @ each for i, each in enumerate(once)]
    first, second = (minimum(total(mesh, error, each, places), len(target)) for each in (once, more))
    return distance(first, second)


def _jumps(homotopy: Homotopy, task: Task) -> int:
    """Whether the minimisers of E^F and E^R change by more than 1e-15 in the time 1e-20."""
    mesh, target, t = task
    after = mesh, target, t + mp.mpf(10) ** -20
    gaps = [
        difference(interpolated(task, error, homotopy), interpolated(after, error, homotopy))
        for error in (frobenius, similarity)
    ]
    return zero_or_one(max(gaps) > mp.mpf(10) ** -15)


def _shorter_way(a: Array, t: Number) -> Array:
    """A^E, its rotation that of t θ up to t = 1/2, and from there on by the other way round."""
    return exponential(a, t) if t <= 0.5 else exponential(a, t, -2 if angle(a) > 0 else 2)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.4.first_vertex",
        place="section 4, constraint of Alexa et al.",
        statement="The first vertex is held on a path so that E^F interpolates source and target.",
        printed="C(v₁, ..., v_n) = |(1 - t) p₁ + t p₁ - v₁|²",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=lambda p, q, t: (1 - t) * p + t * p,
        cases=_moved_by_one,
        deviation=_with_first_at,
        correction=Correction(statement="C = |(1 - t) p₁ + t q₁ - v₁|²", form=straight),
        copies=(Copy("p₁ and q₁ exchanged", lambda p, q, t: (1 - t) * q + t * p),),
        remark="As printed the first vertex stays where it is: the target is met but for a translation.",
    ),
    Claim(
        id="kaji_2d.4.interpolates",
        place="section 4, second condition",
        statement="The minimiser is the source at t = 0 and the target at t = 1, if the constraints are met there.",
        printed="B(0) p_k = p_k and B(1) p_k = q_k",
        verdict=Verdict.CONFIRMED,
        form=exponential,
        cases=lambda: tasks(0, 1)[2:],
        deviation=_misses_the_ends,
        copies=(
            Copy("A^E of Aᵀ", lambda a, t: exponential(a.T, t)),
            Copy("θ + π for θ", lambda a, t: exponential(a, t, 1)),
        ),
        remark="For E^F with one vertex, for E^R with two. There each error is 0.",
    ),
    Claim(
        id="kaji_2d.4.continuous",
        place="section 4, fourth condition",
        statement="The minimiser varies continuously with t.",
        verdict=Verdict.CONFIRMED,
        form=exponential,
        cases=lambda: tasks(0.5)[1:],
        deviation=_jumps,
        copies=(Copy("the other way round from t = 1/2 on", _shorter_way),),
        remark="Wherever G is regular: A_i(t) is analytic in t.",
    ),
    Claim(
        id="kaji_2d.4.homogeneous",
        place="section 4, after the constraint of Alexa et al.",
        statement="E^F is satisfactory where the constraint is simple and rotation homogeneous: where all A_i are one "
        "A, all B_i(t) are A(t).",
        verdict=Verdict.CONFIRMED,
        form=_first,
        cases=_global_maps,
        deviation=_inhomogeneous,
        copies=(Copy("the last vertex held on its line too", _both),),
    ),
    Claim(
        id="kaji_2d.4.turns_drop_out",
        place="section 1, rotation consistency; figure 5, caption",
        statement="The minimiser of E^R does not depend on the angles of the local homotopies: it chooses them.",
        verdict=Verdict.CONFIRMED,
        form=similarity,
        cases=lambda: tasks(0.375)[1:],
        deviation=_depends_on_turns,
        copies=(
            Copy("E^F for E^R", frobenius),
            Copy("a balance of 1/1000 of E^F", lambda a, b: similarity(a, b) + frobenius(a, b) / 1000),
        ),
    ),
)
"""The minimiser."""
