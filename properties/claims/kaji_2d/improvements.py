"""Section 4, improvements: weights, the balanced error, and the symmetrised one."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import numbers
from affinecert.properties.claims.kaji_2d.degeneration import Homotopy
from affinecert.properties.claims.kaji_2d.errors import frobenius, least, similarity
from affinecert.properties.claims.kaji_2d.homotopies import exponential, linear, polar
from affinecert.properties.claims.kaji_2d.minimisers import goals, held, meshes, straight, targets
from affinecert.properties.claims.kaji_2d.plane import J, inner, inverse, maps, square
from affinecert.properties.claims.kaji_2d.shapes import Error, Mesh, areas, linear_parts, minimum, total
from affinecert.properties.claims.precision import distance, equals, mp
from affinecert.reference._matrices import Array, Context, Number, array

Weights = Callable[[Mesh], Sequence[Number]]

Total = Callable[[Array], Number]
"""A global error, of the coordinates of all vertices."""

Task = tuple[Mesh, Array, Number, Homotopy, Error]
"""A source, the vertices of the target, a time, a local homotopy and an error."""

HOMOTOPIES: Mapping[str, Homotopy] = {"A^L": linear, "A^P": polar, "A^E": exponential}


def _cut(mesh: Mesh, target: Array) -> tuple[Mesh, Array]:
    """The mesh with its first triangle cut into three, and the target so."""
    first, *rest = mesh.triangles
    a, b, c = first
    new = len(target)
    source, moved = (array([*shape, shape[[*first]].sum(axis=0) / 3]) for shape in (mesh.vertices, target))
    return Mesh(source, ((a, b, new), (b, c, new), (c, a, new), *rest), f"{mesh.name}, cut"), moved


def _sees_the_cut(weights: Weights, case: tuple[Error, Mesh]) -> Number:
    """The change of the minimiser if a triangle is cut."""
    error, mesh = case
    target = targets(mesh, 1)[0]
    t = mp.mpf(3) / 8
    ends = (0, len(target) - 1)
    constraint = held(*((i, straight(mesh.vertices[i], target[i], t)) for i in ends))
    whole, finer = (
        minimum(total(m, error, goals(m, places, t), constraint, weights(m)), len(places))
        for m, places in ((mesh, target), _cut(mesh, target))
    )
    return distance(finer[:-1], whole)


def _alike(mesh: Mesh) -> Sequence[Number]:
    return [mp.one for _ in mesh.triangles]


def _longest_edges(mesh: Mesh) -> Sequence[Number]:
    places = [mesh.vertices[[*each]] for each in mesh.triangles]
    return [max(square(p[k] - p[k - 1]) for k in range(3)) for p in places]


def _balanced(first: Error, second: Error) -> Any:
    return lambda m, a, b, w: w * first(a, b) + (1 - w) * second(a, b)


def _priced(m: Context, a: Array, b: Array, w: Number) -> Number:
    """The least |z A - B|², and w |A|² |z - 1|² for the best similarity z = x + i y."""
    x, y = (inner(each, b) / square(a) for each in (a, J @ a))
    return least(m, a, b) + w * square(a) * ((x - 1) ** 2 + y**2)


def _pairs_and_weights() -> list[tuple[Array, Array, Number]]:
    firsts, seconds = maps("balance, A", 4), maps("balance, B", 4)[::-1]
    weights = [mp.zero, mp.one, *numbers("balance", len(firsts) - 2, 0, 1)]
    return list(zip(firsts, seconds, weights, strict=True))


def _there(mesh: Mesh, target: Array, t: Number, homotopy: Homotopy, error: Error) -> Total:
    ends = (0, len(target) - 1)
    constraint = held(*((i, straight(mesh.vertices[i], target[i], t)) for i in ends))
    function: Total = total(mesh, error, goals(mesh, target, t, homotopy), constraint, areas(mesh))
    return function


def _back(mesh: Mesh, target: Array, t: Number, homotopy: Homotopy, error: Error) -> Total:
    """E⁻¹(t), that of the maps A_i⁻¹ from the target to the source."""
    return _there(Mesh(target, mesh.triangles, "back"), mesh.vertices, t, homotopy, error)


def _printed(*task: Any) -> Total:
    """E(t) + E⁻¹(1 - t)."""
    mesh, target, t, *rest = task
    there, back = _there(mesh, target, t, *rest), _back(mesh, target, 1 - t, *rest)
    return lambda v: there(v) + back(v)


def _back_at_same_time(*task: Any) -> Total:
    there, back = _there(*task), _back(*task)
    return lambda v: there(v) + back(v)


def _back_twice(*task: Any) -> Total:
    mesh, target, t, *rest = task
    there, back = _there(mesh, target, t, *rest), _back(mesh, target, 1 - t, *rest)
    return lambda v: there(v) + 2 * back(v)


def _back_from_source(*task: Any) -> Total:
    """E⁻¹(1 - t) of the same B_i, the maps from the source."""
    mesh, target, t, homotopy, error = task
    there = _there(*task)
    inverses = [homotopy(inverse(a), 1 - t) for a in linear_parts(mesh, target)]
    back = total(mesh, error, inverses, None, areas(mesh))
    return lambda v: there(v) + back(v)


def _asymmetry(symmetrised: Any, task: Task) -> Number:
    """How far the minimiser is from that with source and target exchanged, at 1 - t."""
    mesh, target, t, *rest = task
    there = minimum(symmetrised(mesh, target, t, *rest), len(target))
    swapped = Mesh(target, mesh.triangles, "swapped")
    back = minimum(symmetrised(swapped, mesh.vertices, 1 - t, *rest), len(target))
    return distance(back, there)


def _tasks() -> list[Task]:
    """All homotopies with E^F, and A^E with E^R."""
    _, square_, strip, fan = meshes()
    third = mp.mpf(3) / 8
    with_frobenius = [(square_, targets(square_, 1)[0], third, each, frobenius) for each in HOMOTOPIES.values()]
    return [
        *with_frobenius,
        (fan, targets(fan, 1)[0], third, exponential, frobenius),
        (strip, targets(strip, 1)[0], third, exponential, similarity),
    ]


def _plain_asymmetry() -> Mapping[str, Any]:
    """What E(t) alone leaves, and the local homotopies by themselves."""
    task = _tasks()[3]
    a = maps("symmetric", 1)[-1]
    t = mp.mpf(3) / 8
    local = {
        f"of {name} itself: A(t) against A⁻¹(1 - t) A": mp.chop(distance(each(inverse(a), 1 - t) @ a, each(a, t)))
        for name, each in HOMOTOPIES.items()
    }
    return {"asymmetry of E^F, not symmetrised, a fan": _asymmetry(_there, task), **local}


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.4.area_weights",
        place="section 4, improvements, weights",
        statement="Weighted with its area, a triangle counts the more, the larger it is: a region counts by its size, "
        "however it is cut.",
        printed="E_i ← Area(Δ(p_i1, p_i2, p_i3)) E_i",
        verdict=Verdict.CONFIRMED,
        form=areas,
        cases=lambda: [(error, mesh) for mesh in meshes()[1::2] for error in (frobenius, similarity)],
        deviation=_sees_the_cut,
        copies=(
            Copy("no weights", _alike),
            Copy("squared areas", lambda mesh: [area**2 for area in areas(mesh)]),
            Copy("squares of the longest edges", _longest_edges),
        ),
        remark="Cutting a triangle into three with the same A_i changes nothing: the minimiser is that before.",
    ),
    Claim(
        id="kaji_2d.4.balanced",
        place="section 4, improvements, balanced error",
        statement="In w E^F + (1 - w) E^R a large w suppresses rotation and scale: it is E^R and w |A|² |z - 1|², z "
        "the rotation and scale of B relative to A.",
        printed="w_i E_i^F(t) + (1 - w_i) E_i^R(t)",
        verdict=Verdict.CONFIRMED,
        form=_balanced(frobenius, similarity),
        cases=_pairs_and_weights,
        deviation=equals(_priced),
        copies=(
            Copy("w and 1 - w exchanged", _balanced(similarity, frobenius)),
            Copy("E^F + (1 - w) E^R", lambda m, a, b, w: frobenius(a, b) + (1 - w) * similarity(a, b)),
        ),
        remark="Relative to A_i(t): a triangle that turns on its way turns with w = 1 as well. To keep a face from "
        "turning, its A_i must not turn.",
    ),
    Claim(
        id="kaji_2d.4.symmetrised",
        place="section 3, remark, property (a); section 4, improvements, symmetrised error",
        statement="The symmetrised error has the same minimiser if source and target are swapped and time is reversed, "
        "whatever the local homotopy.",
        printed="E'(t) = E(t) + E⁻¹(1 - t)",
        verdict=Verdict.CONFIRMED,
        form=_printed,
        cases=_tasks,
        deviation=_asymmetry,
        copies=(
            Copy("E(t) alone", _there),
            Copy("E⁻¹(t) for E⁻¹(1 - t)", _back_at_same_time),
            Copy("2 E⁻¹ for E⁻¹", _back_twice),
            Copy("E⁻¹ of the maps from the source, B_i", _back_from_source),
        ),
        numbers=_plain_asymmetry,
        remark="E⁻¹ has to compare A_i⁻¹(1 - t) with the map from the target to v, B_i A_i⁻¹; with B_i itself, as the "
        "notation suggests, it is neither symmetric nor meets the source at t = 0. All three local homotopies are "
        "symmetric by themselves (but for θ = π): what is not is their assembly in the source.",
    ),
)
"""Improvements."""
