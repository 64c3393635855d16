"""Section 4: the interpolation of tetrahedra: equation 4, triangles, Lemma 5."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.bansal_tatu.interpolation import lie
from affinecert.properties.claims.bansal_tatu.samples import (
    CANONICAL,
    HALF_TURN,
    REGULAR,
    TIMES,
    at,
    between,
    embedded,
    inverse,
    maps,
    moved,
    rigid_maps,
    scaling,
    tetrahedron_pairs,
)
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import difference, distance, exactly, mp
from affinecert.reference import affine_lie, se3, shear
from affinecert.reference._matrices import Array, Number

Between = Callable[[Array, Array, Number], Array]
"""The tetrahedron at t between two."""


def _in_group(order: str = "pq") -> Between:
    """Equation 4 with the group's products: vertices E^-1 S^-1 A^-1 of the canonical ones."""

    def tetrahedron(source: Array, target: Array, t: Number) -> Array:
        p, q = (_represented(each) for each in (source, target))
        found = []
        for one, other, power in zip(p, q, (_rigid_power, _shear_power, _scale_power), strict=True):
            step = inverse(one) @ other if order == "pq" else other @ inverse(one)
            found.append(one @ power(step, t))
        rigid, matrix, scale = found
        return moved(inverse(matrix @ scale @ rigid), CANONICAL)

    return tetrahedron


def _represented(tetrahedron: Array) -> tuple[Array, Array, Array]:
    rigid, matrix, scale = affine_lie.represent(mp, tetrahedron, CANONICAL)
    return rigid, embedded(matrix), scaling(scale[()])


def _rigid_power(pose: Array, t: Number) -> Array:
    return se3.exp(mp, se3.log(mp, pose) * t)


def _shear_power(pose: Array, t: Number) -> Array:
    upper = pose[:3, :3].copy()
    upper[:, 0], upper[2, 1] = exactly([1, 0, 0]), mp.zero
    return embedded(shear.exp(mp, shear.log(mp, upper) * t))


def _scale_power(pose: Array, t: Number) -> Array:
    return scaling(pose[0, 0] ** t)


def _off_tetrahedra(path: Between, pair: tuple[Array, Array]) -> Number:
    """How far the ends are from the two tetrahedra, and the path between them from the interpolant."""
    source, target = pair
    ends = max(distance(path(source, target, mp.zero), source), distance(path(source, target, mp.one), target))
    t = TIMES[0]
    return max(ends, distance(path(source, target, t), _tetrahedron(source, target, t)))


def _tetrahedron(source: Array, target: Array, t: Number) -> Array:
    return affine_lie.interpolate_tetrahedra(mp, source, target, at(t))


def _on_fourth_vertex(order: tuple[int, ...], pair: tuple[Array, Array]) -> Number:
    """How far the first face half way depends on the fourth vertex, the vertices being taken in an order."""
    source, target = pair
    faces = []
    for height in (0, 3):
        one, other = (each[list(order)] for each in (source, _raised(target, height)))
        faces.append(_tetrahedron(one, other, TIMES[0])[[order.index(k) for k in range(3)]])
    return difference(*faces)


def _raised(tetrahedron: Array, height: int) -> Array:
    """The tetrahedron with its fourth vertex moved, off the first face and along it."""
    raised = tetrahedron.copy()
    raised[3] += (raised[3] - raised[0] + raised[1] - raised[0]) * height
    return raised


def _unlike_equation_2(image: Callable[[Array], Array], pose: Array) -> Number:
    """How far the tetrahedron between Δ and that of T is from that of T_t."""
    t = TIMES[0]
    return distance(_tetrahedron(CANONICAL, image(pose), t), image(lie(pose, t)))


def _irreversible(path: Between, pair: tuple[Array, Array]) -> Number:
    source, target = pair
    t = TIMES[0]
    return distance(path(source, target, t), path(target, source, 1 - t))


def _by_map(source: Array, target: Array, t: Number) -> Array:
    """The source moved by T_t of equation 2, T being the affine map to the target."""
    return moved(lie(between(source, target), t), source)


def _turned_pairs() -> list[tuple[Array, Array]]:
    """Tetrahedra that are turned by up to 0.9 pi, and others."""
    turned = [(REGULAR, moved(pose, REGULAR)) for pose in rigid_maps()]
    return turned + tetrahedron_pairs()[:4]


def _half_turned() -> list[tuple[Array, Array]]:
    return [(each, moved(affine(HALF_TURN), each)) for each in (CANONICAL, REGULAR)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.4.equation_4",
        place="section 4, equation 4",
        statement="The tetrahedra represented by p exp(t log p⁻¹q) lead from Δ_p to Δ_q.",
        printed="p exp(t log p⁻¹q), t ∈ [0, 1]",
        verdict=Verdict.CONFIRMED,
        form=_in_group(),
        cases=tetrahedron_pairs,
        deviation=_off_tetrahedra,
        copies=(Copy("q p⁻¹ for p⁻¹q", _in_group("qp")),),
    ),
    Claim(
        id="bansal_tatu.1.triangles",
        place="section 1, contribution (3)",
        statement="As a special case triangles are interpolated: the path of the first face is the same, whatever the "
        "fourth vertices are.",
        verdict=Verdict.CONFIRMED,
        form=(0, 1, 2, 3),
        cases=tetrahedron_pairs,
        deviation=_on_fourth_vertex,
        copies=(Copy("the fourth vertex taken second", (0, 3, 1, 2)),),
    ),
    Claim(
        id="bansal_tatu.4.equations_2_and_4",
        place="sections 3.3 and 4",
        statement="Equation 2 is equation 4 from Δ to T⁻¹Δ: at t there is T_t⁻¹Δ.",
        verdict=Verdict.CONFIRMED,
        form=lambda pose: moved(inverse(pose), CANONICAL),
        cases=maps,
        deviation=_unlike_equation_2,
        copies=(Copy("TΔ for T⁻¹Δ", lambda pose: moved(pose, CANONICAL)),),
        remark="From Δ to TΔ the two equations lead along different paths: T_tΔ is not the tetrahedron of equation 4.",
    ),
    Claim(
        id="bansal_tatu.lemma_5",
        place="section 4, Lemma 5",
        statement="The interpolation from Δ_q to Δ_p at 1 - t is that from Δ_p to Δ_q at t.",
        printed="Δ_p^q(t) = Δ_q^p(1 - t)",
        verdict=Verdict.BOUND,
        domain="rotations E_p⁻¹E_q by less than π; at π the logarithms of both ways are the same, not opposite",
        form=_tetrahedron,
        cases=_turned_pairs,
        outside=_half_turned,
        deviation=_irreversible,
        copies=(Copy("T_t of equation 2 applied to Δ_p, T the affine map to Δ_q", _by_map),),
    ),
)
