"""Section 5.1: another canonical tetrahedron."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.bansal_tatu.samples import (
    CANONICAL,
    REGULAR,
    TIMES,
    between,
    embedded,
    inverse,
    moved,
    scaling,
    tetrahedra,
    tetrahedron_pairs,
)
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import distance, mp, size
from affinecert.reference import affine_lie, se3, shear
from affinecert.reference._matrices import Array, Number, identity

Parts = tuple[Array, Array, Array]
"""E, A and S, each (4, 4)."""


def _represented(tetrahedron: Array, canonical: Array) -> Parts:
    """With E as against the usual canonical tetrahedron, and A and S that bring it onto the new one, aligned."""
    rigid, matrix, scale = affine_lie.represent(mp, tetrahedron, canonical)
    return rigid, embedded(matrix), scaling(scale[()])


def _directly(tetrahedron: Array, canonical: Array) -> Parts:
    """The factors A S E of the affine map to the new canonical tetrahedron itself."""
    rigid, matrix, scale = affine_lie.decompose(mp, between(tetrahedron, canonical))
    return rigid, embedded(matrix), scaling(scale[()])


def _own(canonical: Array) -> Array:
    """E_Δ1 of equation 7."""
    rigid, _, _ = affine_lie.represent(mp, canonical, CANONICAL)
    return rigid


def _map_to_canonical(*, back: bool = True, aligned: bool = True) -> Callable[[Parts, Array], Array]:
    """Equation 7."""

    def product(parts: Parts, canonical: Array) -> Array:
        rigid, matrix, scale = parts
        own = _own(canonical)
        turned = (inverse(own) if back else own) if aligned else identity(mp, 4)
        result: Array = turned @ matrix @ scale @ rigid
        return result

    return product


def _off_canonical(product: Callable[[Parts, Array], Array], pair: tuple[Array, Array]) -> Number:
    tetrahedron, canonical = pair
    return distance(moved(product(_represented(tetrahedron, canonical), canonical), tetrahedron), canonical)


def _aligned_alike(map_: Callable[[Array, Array], Array], pair: tuple[Array, Array]) -> int:
    """1 if the rigid part of a map of the tetrahedron is its E."""
    tetrahedron, canonical = pair
    rigid, _, _ = affine_lie.decompose(mp, map_(tetrahedron, canonical))
    usual, _, _ = affine_lie.represent(mp, tetrahedron, CANONICAL)
    return int(size(rigid - usual) < mp.mpf(10) ** -50)


def _power(parts: Parts, t: Number) -> Parts:
    rigid, matrix, scale = parts
    upper = matrix[:3, :3].copy()
    upper[[1, 2, 2], [0, 0, 1]] = mp.zero
    upper[0, 0] = mp.one
    grown = embedded(shear.exp(mp, shear.log(mp, upper) * t))
    return se3.exp(mp, se3.log(mp, rigid) * t), grown, scaling(scale[0, 0] ** t)


def _interpolated(represent: Callable[[Array, Array], Parts], *, aligned: bool) -> Callable[..., Array]:
    """The tetrahedron at t by equation 4, against a canonical tetrahedron."""

    def tetrahedron(source: Array, target: Array, canonical: Array, t: Number) -> Array:
        p, q = represent(source, canonical), represent(target, canonical)
        step = _power((inverse(p[0]) @ q[0], inverse(p[1]) @ q[1], inverse(p[2]) @ q[2]), t)
        rigid, matrix, scale = (one @ other for one, other in zip(p, step, strict=True))
        goal = moved(_own(canonical), canonical) if aligned else canonical
        return moved(inverse(matrix @ scale @ rigid), goal)

    return tetrahedron


def _dependent(interpolate: Callable[..., Array], case: tuple[Array, Array, Array, Array]) -> Number:
    """How far the tetrahedra are apart that two canonical tetrahedra lead to."""
    source, target, one, other = case
    t = TIMES[0]
    return distance(interpolate(source, target, one, t), interpolate(source, target, other, t))


def _canonical_pairs() -> list[tuple[Array, Array, Array, Array]]:
    others = [REGULAR, *tetrahedra()[3:]]
    return [(*pair, CANONICAL, others[k % len(others)]) for k, pair in enumerate(tetrahedron_pairs())]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.5.1.alignment",
        place="section 5.1",
        statement="Of another canonical tetrahedron the alignment may be violated: the map onto it has another rigid "
        "part than E_p.",
        verdict=Verdict.CONFIRMED,
        form=between,
        cases=lambda: [(each, REGULAR) for each in tetrahedra()],
        deviation=_aligned_alike,
        copies=(
            Copy("the map onto that tetrahedron, aligned", lambda p, other: between(p, moved(_own(other), other))),
        ),
    ),
    Claim(
        id="bansal_tatu.5.1.equation_7",
        place="section 5.1, equation 7",
        statement="The map from Δ_p to another canonical Δ₁ is E_Δ₁⁻¹ A_p₁ S_p₁ E_p.",
        printed="T₁ = E_Δ₁⁻¹ A_p₁ S_p₁ E_p",
        verdict=Verdict.CONFIRMED,
        form=_map_to_canonical(),
        cases=tetrahedron_pairs,
        deviation=_off_canonical,
        copies=(
            Copy("E_Δ₁ for its inverse", _map_to_canonical(back=False)),
            Copy("without E_Δ₁", _map_to_canonical(aligned=False)),
        ),
    ),
    Claim(
        id="bansal_tatu.theorem_2",
        place="section 5.1, Theorem 2",
        statement="The interpolated tetrahedron is the same, whatever tetrahedron is canonical.",
        verdict=Verdict.CONFIRMED,
        form=_interpolated(_represented, aligned=True),
        cases=_canonical_pairs,
        deviation=_dependent,
        copies=(
            Copy("E, A, s of the map onto the canonical tetrahedron itself", _interpolated(_directly, aligned=False)),
        ),
        remark="It drops out: R_p [(U_q U_p⁻¹)^t U_p] needs the aligned edges U of source and target alone.",
    ),
    Claim(
        id="bansal_tatu.5.1.origin",
        place="section 5.1, after Theorem 2",
        statement="Likewise the convex combination of two points does not depend on the origin.",
        verdict=Verdict.CONFIRMED,
        form=lambda p, q, t: p * (1 - t) + q * t,
        cases=lambda: [pair for pair in tetrahedron_pairs() if size(pair[0]) > 0],
        deviation=lambda mix, pair: distance(
            mix(pair[0] + 3, pair[1] + 3, TIMES[0]), mix(pair[0], pair[1], TIMES[0]) + 3
        ),
        copies=(Copy("weights 1 - t and t²", lambda p, q, t: p * (1 - t) + q * t**2),),
    ),
)
