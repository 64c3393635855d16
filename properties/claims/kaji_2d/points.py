"""Section 4: errors between points, E^S and that of Igarashi et al., and what is said of them."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays, numbers, plane_rotation
from affinecert.properties.claims.kaji_2d.plane import J, determinant, edges, inner, maps, square
from affinecert.properties.claims.precision import distance, exactly, mp, size
from affinecert.reference._least_squares import Square, minimiser
from affinecert.reference._matrices import Array, Number, array

Corners = tuple[Array, Array, Array]
"""A, B, and the corners (3, 2) of a triangle."""


def _pointwise(a: Array, b: Array, corners: Array) -> Number:
    """E^S as printed: over x and y the least sum of |(x I + y J) A p_k - B p_k|²."""
    before, after = (a @ corners.T).T, (b @ corners.T).T
    return square(after) - (inner(before, after) ** 2 + inner((J @ before.T).T, after) ** 2) / square(before)


def _about_centroid(a: Array, b: Array, corners: Array) -> Number:
    return _pointwise(a, b, corners - sum(corners) / 3)


def _without_rotation(a: Array, b: Array, corners: Array) -> Number:
    before, after = (a @ corners.T).T, (b @ corners.T).T
    return square(after) - inner(before, after) ** 2 / square(before)


def _up_to_similarities(a: Array, b: Array, corners: Array) -> Number:
    """The least sum of |z A p_k + d - B p_k|² over all similarities, by the normal equations for x, y and d."""
    squares = []
    for p in corners:
        before, after = a @ p, b @ p
        for axis, turned in enumerate(J @ before):
            terms = [(0, before[axis]), (1, turned), (2 + axis, mp.one)]
            squares.append(Square(mp.one, terms, after[axis]))
    best = minimiser(mp, squares, 4, {})
    assert best is not None
    return sum((inner(array([c for _, c in s.terms]), best[[i for i, _ in s.terms]]) - s.goal) ** 2 for s in squares)


def _differs(error: Any, case: Corners) -> Number:
    return distance(error(*case), _up_to_similarities(*case))


def _triangles(name: str) -> list[Array]:
    drawn = [each for each in arrays(name, 12, (3, 2), -3, 3) if determinant(edges(each))]
    return [exactly([[-1, 0], [1, 0], [0, 1]]), exactly([[0, 0], [1, 0], [0, 1]]), *drawn[:4]]


def _cases(name: str, *, centred: bool) -> list[Corners]:
    """Maps A and B, and triangles whose centroid is the origin, or is not."""
    drawn = zip(maps(name, 1), maps(f"{name}, B", 2)[2:], _triangles(name), strict=False)
    return [(a, b, corners - sum(corners) / 3 if centred else corners) for a, b, corners in drawn]


def _next_to_the_origin() -> list[Corners]:
    return [(a, b, corners + exactly([2**-8, 0])) for a, b, corners in _cases("near", centred=True)]


def _changes(change: Any, case: tuple[Corners, Number, Number]) -> Number:
    """The relative change of E^S if A is changed by (s, δ)."""
    (a, b, corners), s, delta = case
    return distance(_pointwise(change(s, delta) @ a, b, corners), _pointwise(a, b, corners))


def _scaled_turns() -> list[tuple[Corners, Number, Number]]:
    drawn = _cases("turned", centred=False)
    scales, angles = numbers("scales", len(drawn), 0.5, 2), numbers("angles of E^S", len(drawn), -3, 3)
    return list(zip(drawn, scales, angles, strict=True))


def _scaled_turn(s: Number, delta: Number) -> Array:
    turned: Array = s * plane_rotation(delta)
    return turned


def _igarashi(local: Any) -> Any:
    """The sum over corners of |x e + y J e + v_i - v_k|², (x, y) the place of a corner in the frame of an edge."""

    def error(source: Array, moved: Array) -> Number:
        total = mp.zero
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            x, y = local(source[j] - source[i], source[k] - source[i])
            edge = moved[j] - moved[i]
            total += square(moved[i] + x * edge + y * (J @ edge) - moved[k])
        return total

    return error


def _in_frame(edge: Array, vector: Array) -> tuple[Number, Number]:
    return inner(edge, vector) / square(edge), inner(J @ edge, vector) / square(edge)


def _in_unscaled_frame(edge: Array, vector: Array) -> tuple[Number, Number]:
    return inner(edge, vector), inner(J @ edge, vector)


def _not_invariant(error: Any, case: tuple[Array, Array, Number, Number]) -> Number:
    """The error of a similar triangle, and the change of that of another one if the source is replaced by a similar."""
    source, moved, s, delta = case
    similar = (_scaled_turn(s, delta) @ source.T).T + array([5, -2])
    return max(abs(error(source, similar)), distance(error(similar, moved), error(source, moved)))


def _pairs_of_triangles() -> list[tuple[Array, Array, Number, Number]]:
    pairs = zip(_triangles("source"), _triangles("moved")[::-1], strict=True)
    return [(p, q, mp.mpf(k + 1) / 2, mp.mpf(k)) for k, (p, q) in enumerate(pairs) if size(p - q)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.4.E_S_up_to_similarity",
        place="section 4, E^S",
        statement="E^S measures how different the points A p_k and B p_k are up to similarity transformation.",
        printed="E^S(A, B) = min over s, δ of Σ |s R_δ A p_k - B p_k|²",
        verdict=Verdict.BOUND,
        domain="triangles whose centroid is the origin: the translations of similarities are forgotten",
        form=_pointwise,
        cases=lambda: _cases("E^S", centred=True),
        outside=lambda: [*_next_to_the_origin(), *_cases("E^S", centred=False)[1:]],
        deviation=_differs,
        copies=(Copy("s alone, without the rotation", _without_rotation),),
        remark="As printed it depends on where the source lies. Take the p_k from their centroid, or minimise over a "
        "translation too, as Werman and Weinshall do.",
    ),
    Claim(
        id="kaji_2d.4.E_S_invariant",
        place="section 4, before E^S",
        statement="E^S does not change if A is turned and scaled.",
        verdict=Verdict.CONFIRMED,
        form=_scaled_turn,
        cases=_scaled_turns,
        deviation=_changes,
        copies=(
            Copy(
                "the similarity is followed by a stretch of 17/16",
                lambda s, delta: _scaled_turn(s, delta) @ exactly([[1, 0], [0, 1.0625]]),
            ),
        ),
    ),
    Claim(
        id="kaji_2d.4.igarashi",
        place="section 4, [II09] and [IMH05]",
        statement="The error functions of Igarashi et al. are invariant under rotation and scale.",
        verdict=Verdict.CONFIRMED,
        form=_igarashi(_in_frame),
        cases=_pairs_of_triangles,
        deviation=_not_invariant,
        copies=(Copy("coordinates in a frame that is not scaled", _igarashi(_in_unscaled_frame)),),
        remark="The formula is theirs, as known: each corner against its place in the frame of the opposite edge. "
        "Invariant for the source; scaled images have scaled errors, as with E^R.",
    ),
    Claim(
        id="kaji_2d.4.igarashi_loci",
        place="section 4, after E^S",
        statement="[II09] and [IMH05] force the loci of vertices onto curves by their constraint function.",
        verdict=Verdict.UNCHECKABLE,
        reason="A statement on other papers, which are not at hand.",
    ),
    Claim(
        id="kaji_2d.4.better_metric",
        place="section 4, before equation 4",
        statement="A metric between transformations serves better than one between points.",
        verdict=Verdict.UNCHECKABLE,
        reason="No measure of better is given.",
        remark="What can be said: E^R does not depend on the place of the source, E^S as printed does. For a regular "
        "triangle about the origin they differ by the factor Σ |p_k|² / 2 only.",
    ),
)
"""Errors between points."""
