"""Global interpolation: weights forgotten, constraints misread, and matrices taken for constant that are not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.fast import homotopy2, mesh2
from affinecert.fast.mesh2 import Locus
from affinecert.scoring import Verdict

from .. import dense_meshes
from .defect import Array, seeded


def singly(function: Callable[..., Array], *arguments: Array) -> Array:
    """The answers of a function of single items."""
    return np.array([function(*item) for item in zip(*arguments, strict=True)])


def ends(sound: Array) -> tuple[Locus, Locus]:
    """The first and the last vertex of a sound answer, held there."""
    return Locus(0, sound[0]), Locus(len(sound) - 1, sound[-1])


def first(source: Array, target: Array, t: Array) -> Locus:
    """The first vertex on its line."""
    return Locus(0, (1 - t) * source[0] + t * target[0])


@seeded("mesh2.frobenius", "generic")
def areas_forgotten(*arguments: Array) -> Array:
    """All triangles count alike."""

    def one(source: Array, target: Array, triangles: Array, t: Array) -> Array:
        weights = np.ones(len(triangles))
        return np.asarray(mesh2.interpolate(source, target, triangles, t, energy="frobenius", weights=weights))

    return singly(one, *arguments)


@seeded("mesh2.frobenius", "generic")
def first_vertex_at_rest(*arguments: Array) -> Array:
    """(1 - t) p₁ + t p₁, as printed."""

    def one(source: Array, target: Array, triangles: Array, t: Array) -> Array:
        return np.asarray(mesh2.frobenius(source, target, triangles, t) - t * (target[0] - source[0]))

    return singly(one, *arguments)


@seeded("mesh2.frobenius", "generic")
def barycentre_for_the_first_vertex(*arguments: Array) -> Array:
    """The barycentre moves linearly instead."""

    def one(source: Array, target: Array, triangles: Array, t: Array) -> Array:
        centre = mesh2.Barycentre(((1 - t) * source + t * target).mean(axis=0))
        return np.asarray(mesh2.interpolate(source, target, triangles, t, energy="frobenius", constraints=[centre]))

    return singly(one, *arguments)


@seeded("mesh2.points", "tiny-next-to-huge", Verdict.DEGRADED)
def corners_from_the_origin(*arguments: Array) -> Array:
    """Corners that are not seen from their centroid, and normal equations in float64."""

    def one(source: Array, target: Array, triangles: Array, t: Array) -> Array:
        held = ends(np.asarray(mesh2.points(source, target, triangles, t)))
        return dense_meshes.shape(source, target, triangles, float(t), "points", constraints=held, squared=True)

    return singly(one, *arguments)


@seeded("mesh2.points", "generic")
def maps_for_points(source: Array, target: Array, triangles: Array, t: Array) -> Array:
    """E^R for E^S."""
    return np.asarray(mesh2.similarity(source, target, triangles, t))


@seeded("mesh2.points", "generic")
def from_the_origin(*arguments: Array) -> Array:
    """E^S as printed, without the translation d: it depends on the origin."""

    def one(source: Array, target: Array, triangles: Array, t: Array) -> Array:
        sound = np.asarray(mesh2.points(source, target, triangles, t))
        rows, own = [], 2 * len(source)
        goals = homotopy2.exponential(dense_meshes.linear_parts(source, target, triangles), t)
        masses = np.abs(dense_meshes.areas(source, triangles))
        for triple, goal, mass in zip(triangles.astype(int), goals, masses, strict=True):
            for _, terms, aim in dense_meshes.points(goal, source, triple, own):
                rows.append((mass, {i: c for i, c in terms.items() if i < own + 2}, aim))
            own += 2
        known = {2 * v + axis: sound[v, axis] for v in (0, len(source) - 1) for axis in range(2)}
        return dense_meshes.least_squares(rows, own, known)[: 2 * len(source)].reshape(-1, 2)

    return singly(one, *arguments)


@seeded("mesh2.similarity", "generic")
def matrix_of_the_start(*arguments: Array) -> Array:
    """The matrix of t = 0 for all times, as the appendix has it."""

    def one(source: Array, target: Array, triangles: Array, t: Array) -> Array:
        held = ends(np.asarray(mesh2.similarity(source, target, triangles, t)))
        return dense_meshes.shape(source, source, triangles, 0.0, "similarity", constraints=held)

    return singly(one, *arguments)


@seeded("mesh2.similarity", "generic")
def stretches_in_a_straight_line(*arguments: Array) -> Array:
    """A^P for A^E."""

    def one(source: Array, target: Array, triangles: Array, t: Array) -> Array:
        return np.asarray(mesh2.interpolate(source, target, triangles, t, homotopy="polar"))

    return singly(one, *arguments)


@seeded("mesh2.balanced", "generic")
def balance_the_other_way(source: Array, target: Array, triangles: Array, t: Array, balance: Array) -> Array:
    """w E^R + (1 - w) E^F."""
    return np.asarray(mesh2.balanced(source, target, triangles, t, 1 - balance))


@seeded("mesh2.balanced", "generic")
def balance_of_lengths(source: Array, target: Array, triangles: Array, t: Array, balance: Array) -> Array:
    """w² E^F + (1 - w)² E^R: the rows were weighted, not their squares."""
    weights = balance**2 / (balance**2 + (1 - balance) ** 2)
    return np.asarray(mesh2.balanced(source, target, triangles, t, weights))


@seeded("mesh2.constrained", "generic")
def weight_of_length(source: Array, target: Array, triangles: Array, t: Array, place: Array, weight: Array) -> Array:
    """weight² |v - place|²: the row was weighted, not its square."""
    return np.asarray(mesh2.constrained(source, target, triangles, t, place, weight**2))


@seeded("mesh2.constrained", "generic")
def exactly_there(*arguments: Array) -> Array:
    """The place is taken exactly, whatever the weight."""

    def one(source: Array, target: Array, triangles: Array, t: Array, place: Array, weight: Array) -> Array:
        held = first(source, target, t), Locus(len(source) - 1, place)
        return np.asarray(mesh2.interpolate(source, target, triangles, t, energy="frobenius", constraints=held))

    return singly(one, *arguments)


@seeded("mesh2.symmetric", "generic")
def one_way_only(source: Array, target: Array, triangles: Array, t: Array) -> Array:
    """The way back is forgotten."""
    return np.asarray(mesh2.frobenius(source, target, triangles, t))


@seeded("mesh2.symmetric", "generic")
def areas_of_the_source_both_ways(*arguments: Array) -> Array:
    """The way back is weighted with areas of the source, where it starts from the target."""

    def one(source: Array, target: Array, triangles: Array, t: Array) -> Array:
        options: dict[str, Any] = {"energy": "frobenius", "symmetric": True}
        weights = np.abs(dense_meshes.areas(source, triangles))
        return np.asarray(mesh2.interpolate(source, target, triangles, t, weights=weights, **options))

    return singly(one, *arguments)
