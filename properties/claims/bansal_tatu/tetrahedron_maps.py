"""Appendix A.1.2, parts (1) and (2) of Theorem 1: the affine map between two tetrahedra."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import (
    CANONICAL,
    components,
    composed,
    from_corners,
    tetrahedra,
    volume,
)
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.precision import distance, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, array, cross, homogeneous, norm

Pair = tuple[Array, Array]
Test = Callable[[Array, Array], bool]


def _centroid(solid: Array) -> Array:
    centre: Array = solid[:3].sum(axis=1) / 4
    return centre


def _incentre(solid: Array) -> Array:
    """The mean of the vertices, weighted with the areas of the faces opposite."""
    faces = [[k for k in range(4) if k != vertex] for vertex in range(4)]
    corners = solid[:3].T
    areas = array([norm(mp, cross(corners[b] - corners[a], corners[c] - corners[a])) for a, b, c in faces])
    centre: Array = corners.T @ areas / sum(areas)
    return centre


def _maps() -> list[Array]:
    return [composed(mp, *parts) for parts in components("maps of tetrahedra", 7)]


def _mapped() -> list[Pair]:
    """Tetrahedra X with maps T; Y is T X."""
    return [(solid, affine) for solid, affine in zip(tetrahedra("sources", 7), _maps(), strict=True)]


def _uncentred(centre: Callable[[Array], Array], case: Pair) -> Number:
    """How far T is from mapping one centre to the other."""
    solid, affine = case
    return distance((affine @ array([*centre(solid), mp.one]))[:3], centre(affine @ solid))


def _centred() -> list[Pair]:
    """Tetrahedra about the origin; and one elsewhere, that is only moved."""
    around = [(from_corners(solid[:3] - _centroid(solid)[:, None]), affine) for solid, affine in _mapped()]
    return [*around, (CANONICAL, homogeneous(mp, exactly([[1, 0, 0], [0, 1, 0], [0, 0, 1]]), exactly([1, 2, 3])))]


def _off_centre() -> list[Pair]:
    return [(solid, affine) for solid, affine in _mapped() if any(affine[:3, :3] @ _centroid(solid) - _centroid(solid))]


def _shift(centre: Callable[[Array], Array], sign: int = 1) -> Any:
    return lambda source, target: sign * (centre(target) - centre(source))


def _wrong_shift(form: Any, case: Pair) -> Number:
    solid, affine = case
    return distance(form(solid, affine @ solid), affine[:3, 3])


def _all_from(centre: Callable[[Array], Array], count: int) -> Callable[[Array], list[Array]]:
    """The sets of so many of the vectors from a centre to the vertices, in rows."""

    def sets(solid: Array) -> list[Array]:
        vectors = solid[:3].T - centre(solid)
        return [vectors[list(chosen)] for chosen in combinations(range(4), count)]

    return sets


def _face_centroid(solid: Array) -> Array:
    centre: Array = solid[:3, :3].sum(axis=1) / 3
    return centre


def _dependent(sets: Callable[[Array], list[Array]], case: tuple[Array]) -> bool:
    """Whether the vectors of one of the sets are dependent: their Gram determinant is 0, up to rounding."""
    return any(abs(definitions.determinant(vectors @ vectors.T)) < mp.mpf(10) ** -40 for vectors in sets(*case))


def _by_vertices(*, turned: bool = False, unmoved: bool = False) -> Any:
    """T from three differences with the centroids, and d = c_Y - L c_X."""

    def found(m: Context, source: Array, target: Array) -> Array:
        c_x, c_y = _centroid(source), _centroid(target)
        x, y = source[:3, 1:] - c_x[:, None], target[:3, 1:] - c_y[:, None]
        linear = y @ definitions.inverse(m, x)
        return homogeneous(m, linear.T if turned else linear, c_y - (c_x if unmoved else linear @ c_x))

    return found


def _wrong_map(form: Any, case: Pair) -> Number:
    solid, affine = case
    return distance(form(mp, solid, affine @ solid), affine)


def _sign(number: Number) -> int:
    return int(number > 0) - int(number < 0)


def _same_orientation(source: Array, target: Array) -> bool:
    """As footnote 3 has it."""
    return _sign(definitions.determinant(source)) == _sign(definitions.determinant(target))


def _same_edges(source: Array, target: Array) -> bool:
    """By the vertices 1, 2, 3 as vectors, without the first."""
    return _sign(definitions.determinant(source[:3, 1:])) == _sign(definitions.determinant(target[:3, 1:]))


def _with_mirrors() -> list[Pair]:
    mirror = homogeneous(mp, exactly([[1, 0, 0], [0, 1, 0], [0, 0, -1]]), exactly([0, 0, 4]))
    return [(solid, m @ affine) for solid, affine in _mapped() for m in (mirror @ mirror, mirror)]


def _misjudged(test: Test, case: Pair) -> bool:
    solid, affine = case
    return test(solid, affine @ solid) is not bool(definitions.determinant(affine) > 0)


def _with_flat() -> list[Pair]:
    flat = exactly([[1, 0, 2], [0, 1, -1], [1, 1, 1]])
    return [*_mapped(), *((solid, homogeneous(mp, flat, affine[:3, 3])) for solid, affine in _mapped())]


def _invertible_by(test: Callable[[Array], bool], case: Pair) -> bool:
    solid, affine = case
    return test(affine @ solid) is not bool(definitions.determinant(affine) != 0)


def _has_volume(solid: Array) -> bool:
    return bool(abs(volume(solid)) > mp.mpf(10) ** -50)


def _has_distinct_vertices(solid: Array) -> bool:
    return all(any(solid[:, i] - solid[:, j]) for i, j in combinations(range(4), 2))


def _wrong_source(form: Callable[[Array, Array], Array], case: Pair) -> Number:
    solid, affine = case
    return distance(form(affine, affine @ solid), solid)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.2.1.centroids",
        place="appendix A.1.2 (1)",
        statement="The affine map between two tetrahedra maps centroid to centroid.",
        verdict=Verdict.CONFIRMED,
        form=_centroid,
        cases=_mapped,
        deviation=_uncentred,
        copies=(Copy("the centre of the inscribed sphere", _incentre),),
    ),
    Claim(
        id="bansal_tatu.A.1.2.1.translation",
        place="appendix A.1.2 (1)",
        statement="The translation part d of T = [L | d] aligns the two centroids, whatever L is.",
        printed="The translation part d aligns the two centroids and is thus uniquely determined",
        verdict=Verdict.BOUND,
        domain="L keeps the centroid of the source, as where that is the origin",
        form=_shift(_centroid),
        cases=_centred,
        outside=_off_centre,
        deviation=_wrong_shift,
        copies=(
            Copy("the first vertices for the centroids", _shift(lambda solid: solid[:3, 0])),
            Copy("from the target to the source", _shift(_centroid, -1)),
        ),
        remark="In general d = c_Y - L c_X, which needs L first; it is unique all the same.",
    ),
    Claim(
        id="bansal_tatu.A.1.2.1.independent",
        place="appendix A.1.2 (1)",
        statement="The difference vectors of the four vertices with the centroid are linearly independent.",
        printed="these two sets of difference vectors are linearly independent, implying the uniqueness of L",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_all_from(_centroid, 4),
        cases=lambda: [(solid,) for solid in tetrahedra("solids", 6)],
        deviation=_dependent,
        correction=Correction(
            statement="Any three of the difference vectors are; the sum of the four is 0.", form=_all_from(_centroid, 3)
        ),
        copies=(Copy("from the centroid of the first face", _all_from(_face_centroid, 3)),),
        remark="Three of them are enough for the uniqueness of L.",
    ),
    Claim(
        id="bansal_tatu.A.1.2.1.unique",
        place="appendix A.1.2 (1); Theorem 1 (1)",
        statement="T is determined by the vertices: L by the differences with the centroids, d by L and the centroids.",
        verdict=Verdict.CONFIRMED,
        form=_by_vertices(),
        cases=_mapped,
        deviation=_wrong_map,
        copies=(
            Copy("L transposed", _by_vertices(turned=True)),
            Copy("d = c_Y - c_X", _by_vertices(unmoved=True)),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.2.1.orientation",
        place="appendix A.1.2 (1); footnote 3",
        statement="Two tetrahedra have the same orientation, the sign of the determinant of their homogeneous "
        "coordinates, if and only if the map between them has a positive determinant.",
        printed="since the two tetrahedrons have the same orientation, det(T) > 0",
        verdict=Verdict.CONFIRMED,
        form=_same_orientation,
        cases=_with_mirrors,
        deviation=_misjudged,
        copies=(Copy("the determinant of the last three vertices as vectors", _same_edges),),
    ),
    Claim(
        id="bansal_tatu.A.1.2.2.invertible",
        place="appendix A.1.2 (2)",
        statement="The linear part is invertible if and only if the image of a tetrahedron with volume has volume.",
        printed="the linear part is invertible as far as the tetrahedrons are non-degenerate",
        verdict=Verdict.CONFIRMED,
        form=_has_volume,
        cases=_with_flat,
        deviation=_invertible_by,
        copies=(Copy("its vertices are distinct", _has_distinct_vertices),),
    ),
    Claim(
        id="bansal_tatu.A.1.2.2.source",
        place="appendix A.1.2 (2); Theorem 1 (2)",
        statement="The source is determined by the map and the target.",
        printed="Δ_X = T⁻¹ Δ_Y",
        verdict=Verdict.CONFIRMED,
        form=lambda affine, target: definitions.inverse(mp, affine) @ target,
        cases=_mapped,
        deviation=_wrong_source,
        copies=(
            Copy("T for T⁻¹", lambda affine, target: affine @ target),
            Copy("Tᵀ for T⁻¹", lambda affine, target: affine.T @ target),
        ),
    ),
)
