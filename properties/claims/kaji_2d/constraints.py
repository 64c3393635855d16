"""Section 4: the list of constraints that the constraint function can express."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import plane_rotation
from affinecert.properties.claims.kaji_2d.errors import frobenius, similarity
from affinecert.properties.claims.kaji_2d.minimisers import goals, held, meshes, targets
from affinecert.properties.claims.kaji_2d.plane import square
from affinecert.properties.claims.kaji_2d.shapes import Constraint, Error, Mesh, minimum, total
from affinecert.properties.claims.precision import difference, distance, exactly, mp
from affinecert.reference._matrices import Array, Number

Led = tuple[str, Mesh, float, Number, Number]
"""The error, the mesh, its last vertices that are led (one or two), the weight, the time."""

ERRORS: Mapping[str, Error] = {"E^F": frobenius, "E^R": similarity}


def _places(mesh: Mesh, target: Array, count: Number, t: Number) -> list[tuple[int, Array]]:
    """Where so many vertices, the last ones, are to be: on curves that leave the straight line."""
    aside = exactly([1, -2]) * t * (1 - t)
    last = range(len(target) - int(count), len(target))
    return [(i, (1 - t) * mesh.vertices[i] + t * target[i] + (1 + i) * aside) for i in last]


def _locus(places: list[tuple[int, Array]], weight: Number) -> Constraint:
    return held(*places, weight=weight)


def _mirrored(places: list[tuple[int, Array]], weight: Number) -> Constraint:
    return held(*((i, -place) for i, place in places), weight=weight)


def _off_the_locus(constraint: Any, case: Led) -> Number:
    """How far the minimiser with loci is off them."""
    name, mesh, count, weight, t = case
    target = targets(mesh, 1)[0]
    places = _places(mesh, target, count, t)
    found = minimum(total(mesh, ERRORS[name], goals(mesh, target, t), constraint(places, weight)), len(target))
    return max(difference(found[i], place) for i, place in places)


def _compatible() -> list[Led]:
    """As many loci as the error leaves freedoms, or times when all can be met."""
    _, square_, strip, fan = meshes()
    third = mp.mpf(3) / 8
    free = [("E^F", square_, 1, 1, third), ("E^F", fan, 1, 1, third), ("E^R", strip, 2, 1, third)]
    return [*free, ("E^F", strip, 2, 1, mp.zero), ("E^F", fan, 2, 1, mp.one), ("E^R", fan, 2, 1, mp.one)]


def _in_conflict() -> list[Led]:
    _, square_, strip, fan = meshes()
    third = mp.mpf(3) / 8
    return [
        *[("E^F", square_, 2, mp.mpf(10) ** k, third) for k in (0, 2, 6)],
        ("E^F", strip, 2, 1, third),
        ("E^R", fan, 2, 1, third),
        ("E^R", strip, 3, 1, third),
    ]


def _falling_gaps() -> Mapping[str, Any]:
    square_ = meshes()[1]
    weights = [mp.mpf(10) ** k for k in range(5)]
    gaps = [_off_the_locus(_locus, ("E^F", square_, 2, weight, mp.mpf(3) / 8)) for weight in weights]
    return {"off two loci with E^F, weights 1, 10, ..., 10000": tuple(gaps)}


def _of_edge(edge: Array, given: Array) -> Number:
    return square(edge - given)


def _penalised(term: Any, case: tuple[Array, Array]) -> Number:
    """The term of an edge that has the direction given."""
    return term(*case)


def _edges(*factors: float) -> list[tuple[Array, Array]]:
    vectors = [exactly(each) for each in ([1, 0], [3, 4], [-2, 0.5])]
    return [(vector * mp.mpf(factor), vector) for vector in vectors for factor in factors]


def _with_edge(task: tuple[str, Mesh, Number], sign: int, delta: Number) -> Array:
    """The minimiser with the first vertex at (1, 1) and an edge vector, turned by δ."""
    name, mesh, t = task
    target = targets(mesh, 1)[0]
    first = exactly([1, 1])
    edge = plane_rotation(delta) @ exactly([2, 1])
    parts = goals(mesh, target, t)
    constraint = held((0, first))
    found = total(
        mesh, ERRORS[name], parts, lambda moved: constraint(moved) + square(moved[1] + sign * moved[0] - edge)
    )
    relative: Array = minimum(found, len(target)) - first
    return relative


def _not_turned(sign: int, task: tuple[str, Mesh, Number]) -> Number:
    """How far the minimiser is from being turned as the edge vector is."""
    delta = mp.mpf(2)
    still, turned = (_with_edge(task, sign, angle) for angle in (mp.zero, delta))
    return distance(turned, (plane_rotation(delta) @ still.T).T)


def _tasks(name: str) -> list[tuple[str, Mesh, Number]]:
    return [(name, mesh, mp.mpf(3) / 8) for mesh in meshes()]


def _mean(moved: Array) -> Array:
    mean: Array = moved.sum(axis=0) / len(moved)
    return mean


def _off_the_barycentre(mean: Any, mesh: Mesh) -> Number:
    """How far the mean of the vertices of the minimiser of E^F with the term of the barycentre is from its place."""
    target, t = targets(mesh, 1)[0], mp.mpf(3) / 8
    place = exactly([3, -2])
    found = minimum(
        total(mesh, frobenius, goals(mesh, target, t), lambda moved: square(mean(moved) - place)), len(target)
    )
    return difference(_mean(found), place)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.4.locus",
        place="section 4, list of constraints, first",
        statement="Points that must trace given loci do so, if weighted squares of their distances are added.",
        printed="add the term c_i |u_i(t) - v_i(t)|²",
        verdict=Verdict.BOUND,
        domain="loci that cost no error: t = 0 and 1, one vertex for E^F, two for E^R of a mesh without inner vertices",
        form=_locus,
        cases=_compatible,
        outside=_in_conflict,
        deviation=_off_the_locus,
        copies=(Copy("-u for u", _mirrored),),
        numbers=_falling_gaps,
        remark="Else the vertices are off their loci, in proportion to 1/c: put them there by elimination.",
    ),
    Claim(
        id="kaji_2d.4.edge_direction",
        place="section 4, list of constraints, second",
        statement="That an edge has a given direction is realised by the square of v_i - v_j - e_ij: it is 0 then.",
        printed="add the term c_ij |v_i(t) - v_j(t) - e_ij(t)|²",
        verdict=Verdict.BOUND,
        domain="edges as long as e_ij: the term fixes length and direction",
        form=_of_edge,
        cases=lambda: _edges(1),
        outside=lambda: _edges(2, 0.5, 1.0625),
        deviation=_penalised,
        copies=(Copy("e_ji for e_ij", lambda edge, given: square(edge + given)),),
        remark="The direction alone is fixed by the term ⟨J e_ij, v_i - v_j⟩², quadratic as well.",
    ),
    Claim(
        id="kaji_2d.4.edge_rotation",
        place="section 4, list of constraints, second",
        statement="An edge is a simple way to control the global rotation: turn e_ij, and the shape turns with it.",
        verdict=Verdict.BOUND,
        domain="errors that are invariant under rotations, E^R and E^S; for E^F the edge only bends the shape",
        form=-1,
        cases=lambda: _tasks("E^R"),
        outside=lambda: _tasks("E^F"),
        deviation=_not_turned,
        copies=(Copy("v_i + v_j for v_i - v_j", 1),),
    ),
    Claim(
        id="kaji_2d.4.barycentre",
        place="section 4, list of constraints, third",
        statement="The term of the barycentre controls the global translation: with E^F, the mean of the vertices is "
        "then in its place, whatever the weight.",
        printed="add the term c_o |Σ v_i(t) / n - u_o(t)|²",
        verdict=Verdict.CONFIRMED,
        form=_mean,
        cases=lambda: [*meshes()],
        deviation=_off_the_barycentre,
        copies=(
            Copy("the sum for the mean", lambda moved: moved.sum(axis=0)),
            Copy("n - 1 for n", lambda moved: moved.sum(axis=0) / (len(moved) - 1)),
        ),
        remark="The mean of the vertices is not the barycentre of the shape: it moves if a region is cut finer.",
    ),
)
"""Constraints."""
