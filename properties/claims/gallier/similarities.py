"""Abstract, section 1 and section 9: what the group and its algebra are, and how interpolation in them goes."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays, numbers, rotations
from affinecert.properties.claims.precision import difference, distance, exactly, mp
from affinecert.reference import sim3, so3
from affinecert.reference._matrices import Array, Number, array, cross_matrix, homogeneous, identity, scalar, tangent
from affinecert.reference.splines import principal_motion


def off_group(matrix: Array) -> Number:
    """How far a homogeneous matrix is from a direct similarity: 0 in SIM(n), at least 1 where it turns inside out."""
    linear = matrix[:-1, :-1]
    gram = linear.T @ linear
    scale = gram.trace() / len(gram)
    last = array([mp.zero] * len(gram) + [mp.one])
    skewed = distance(gram, scale * identity(mp, len(gram))) + difference(matrix[-1], last)
    return skewed + (0 if definitions.determinant(linear) > 0 else 1)


def skew(entries: Array, n: int) -> Array:
    """The skew matrix with the given entries above its diagonal, row by row, (n (n - 1) / 2,) -> (n, n)."""
    above = identity(mp, n) * 0
    above[np.triu_indices(n, 1)] = entries
    matrix: Array = above - above.T
    return matrix


def generators() -> list[tuple[Number, Array, Array]]:
    """Some (lambda, Omega, u) of n = 1 to 4."""
    growths = numbers("growths", 6, -2, 2)
    found = []
    for growth, n in zip(growths, (3, 1, 2, 3, 4, 3), strict=True):
        (entries,) = arrays(f"omega {n}", 1, (n * (n - 1) // 2,), -2, 2)
        (u,) = arrays(f"u {n}", 1, (n,), -2, 2)
        found.append((growth, skew(entries, n), u))
    return found


def _element(where: str = "everywhere") -> Any:
    """The matrix of the algebra, or one whose lambda is on the first place of the diagonal only."""

    def printed(growth: Number, omega: Array, u: Array) -> Array:
        n = len(u)
        diagonal = identity(mp, n)
        if where == "first":
            diagonal[1:] *= 0
        return tangent(mp, diagonal * growth + omega, u)

    return printed


def _leaves(form: Any, case: Any) -> Number:
    """How far the exponentials of multiples of an element are from SIM(n)."""
    matrix = form(*case)
    return max(off_group(definitions.exponential(mp, matrix * t)) for t in (mp.mpf(1) / 2, mp.one, -mp.one))


def _similarity(row: int | None = None) -> Any:
    """The matrix of x -> alpha R x + u; with a row given, alpha multiplies that one only."""

    def printed(alpha: Number, rotation: Array, u: Array) -> Array:
        scale = identity(mp, len(u))
        for k in range(len(u)) if row is None else [row]:
            scale[k, k] = alpha
        return homogeneous(mp, scale @ rotation, u)

    return printed


def _parts() -> list[tuple[Any, Any]]:
    turns = rotations("group", 8)
    moves = arrays("moves", 8, (3,), -2, 2)
    scales = [mp.mpf(k) / 3 for k in range(2, 10)]
    parts = list(zip(scales, turns, moves, strict=True))
    return list(zip(parts[::2], parts[1::2], strict=True))


def _not_a_group(form: Any, case: Any) -> Number:
    """How far a product, a quotient and the image of a point are from what they have to be."""
    (alpha, rotation, u), _ = case
    first, second = (form(*each) for each in case)
    x = exactly([1, 2, 3])
    image = first @ np.append(x, mp.one)
    due = np.append(alpha * (rotation @ x) + u, mp.one)
    products = first @ second, first @ definitions.inverse(mp, second)
    return distance(image, due) + max(map(off_group, products))


def _pairs() -> list[tuple[Array, Array]]:
    """Pairs of similarities of space, the first one with the identity."""
    keys = [homogeneous(mp, a * r, u) for pair in _parts() for a, r, u in pair]
    quarter = homogeneous(mp, so3.exp(mp, exactly([0, 0, 1]) * mp.pi / 2), exactly([0, 0, 0]))
    return [(identity(mp, 4), quarter), *zip(keys[::2], keys[1::2], strict=True)]


def _blend(first: Array, second: Array, t: Number) -> Array:
    blended: Array = (1 - t) * first + t * second
    return blended


def _by_logarithms(first: Array, second: Array, t: Number) -> Array:
    return sim3.exp(mp, _blend(sim3.log(mp, first), sim3.log(mp, second), t))


def _stays(form: Any, case: tuple[Array, Array]) -> int:
    """1 if the curve stays in SIM(3), as it is not to."""
    return 0 if off_group(form(*case, mp.mpf(1) / 2)) > mp.mpf(1) / 100 else 1


def _basis(*names: str) -> list[Any]:
    """Integer 4 x 4 matrices: turns about the axes, moves along them, growth, and what else is named."""
    spaces: dict[str, list[Any]] = {
        "turns": [cross_matrix(mp, row) for row in identity(mp, 3)],
        "growth": [identity(mp, 3)],
        "stretch": [array([[1, 0, 0], [0, -1, 0], [0, 0, 0]])],
        "shear": [array([[0, 1, 0], [0, 0, 0], [0, 0, 0]])],
        "triangular": [np.outer(identity(mp, 3)[i], identity(mp, 3)[j]) for i in range(3) for j in range(i, 3)],
    }
    still = exactly([0, 0, 0])
    moves = [tangent(mp, identity(mp, 3) * 0, row) for row in identity(mp, 3)]
    return [tangent(mp, block, still) for name in names for block in spaces[name]] + moves


def _dimension(elements: list[Any]) -> int:
    """The dimension of the Lie algebra that matrices generate."""
    rows = [np.asarray(each, dtype=float) for each in elements]
    rank = 0
    while True:
        found = np.linalg.matrix_rank(np.array([row.ravel() for row in rows]))
        if found == rank:
            return int(rank)
        rank = int(found)
        rows += [a @ b - b @ a for a in rows for b in rows]
        rows = [row.reshape(4, 4) for row in np.linalg.svd(np.array([r.ravel() for r in rows]))[2][: _rank(rows)]]


def _rank(rows: list[Any]) -> int:
    return int(np.linalg.matrix_rank(np.array([row.ravel() for row in rows])))


def _lacks_logarithm(matrix: Array) -> bool:
    """Whether a real matrix has a negative eigenvalue once only: a real logarithm would have it twice."""
    found = definitions.eigenvalues(mp, matrix)
    negative = [z for z in found if abs(mp.im(z)) < mp.mpf(10) ** -40 and mp.re(z) < 0]
    return any(sum(abs(z - w) < mp.mpf(10) ** -20 for w in negative) == 1 for z in negative)


def _groups_around() -> list[tuple[list[Any], Array, bool]]:
    """Generators added to the algebra, and an element of the group of both."""
    without = exactly([[-1, 0, 0, 0], [0, -2, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    doubled = exactly([[2, 0, 0, 1], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]])
    return [(_basis("growth"), doubled, True), (_basis("stretch"), without, True), (_basis("shear"), without, True)]


def _triangular_group() -> list[tuple[list[Any], Array, bool]]:
    return [(_basis("triangular"), exactly([[2, 1, 3, 1], [0, 2, 1, 0], [0, 0, 5, 1], [0, 0, 0, 1]]), False)]


def _larger(form: list[Any], case: tuple[list[Any], Array, bool]) -> int:
    """1 if a group is larger and the given element of it has a logarithm too."""
    others, element, around = case
    whole = _dimension(form + others if around else others)
    return int(whole > _dimension(form) and not _lacks_logarithm(element))


def _span(form: str, n: int) -> int:
    """How far a dimension as printed is from that of the span of many elements."""
    vectors = arrays("span", 20, (n * (n + 1) // 2 + 1,), -2, 2)
    turns = n * (n - 1) // 2
    elements = [_element()(v[0], skew(v[1 : 1 + turns], n), v[1 + turns :]) for v in vectors]
    return abs(int(form) - _rank([np.asarray(each, dtype=float) for each in elements]))


def _journeys() -> list[tuple[Array]]:
    keys = [key for pair in _pairs() for key in pair]
    return [(array([each.tolist() for each in keys[:4]]),), (array([each.tolist() for each in keys[4:9]]),)]


def _misses(form: Any, case: tuple[Array]) -> Number:
    """How far a curve passes by its keys at the whole numbers."""
    (keys,) = case
    return max(distance(form(keys, mp.mpf(i)), key) for i, key in enumerate(keys))


def _exponential_of_spline(keys: Array, t: Number) -> Array:
    return principal_motion(mp, keys, scalar(t))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.1.group",
        place="section 1, SIM(n)",
        statement="The matrices (αR, u; 0, 1) represent the maps x ↦ αRx + u, and make a group.",
        printed="ρ(x) = αRx + u iff (ρ(x); 1) = (αR, u; 0, 1)(x; 1)",
        verdict=Verdict.CONFIRMED,
        form=_similarity(),
        cases=_parts,
        deviation=_not_a_group,
        copies=(Copy("α multiplies the first row only", _similarity(0)),),
    ),
    Claim(
        id="gallier.1.linear_interpolation",
        place="section 1, naive interpolation",
        statement="(1-t) g + t h does not in general belong to SIM(3), of g and h that do.",
        printed="(1-t) g_i + t g_(i+1) does not belong to SIM(3) (in general)",
        verdict=Verdict.CONFIRMED,
        form=_blend,
        cases=_pairs,
        deviation=_stays,
        copies=(Copy("exp((1-t) log g + t log h)", _by_logarithms),),
        remark="In the plane it does belong to SIM(2), except where it is singular (from g to a half turn of it).",
    ),
    Claim(
        id="gallier.1.algebra",
        place="section 1, sim(n)",
        statement="The Lie algebra of SIM(n) consists of the matrices (λI + Ω, u; 0, 0), Ω skew.",
        printed="sim(n) = {(λI_n + Ω, u; 0, 0): Ω ∈ so(n), u ∈ R^n, λ ∈ R}",
        verdict=Verdict.CONFIRMED,
        form=_element(),
        cases=generators,
        deviation=_leaves,
        copies=(Copy("λ on the first place of the diagonal only", _element("first")),),
    ),
    Claim(
        id="gallier.1.dimension",
        place="abstract and section 6",
        statement="sim(3) has dimension 7.",
        printed="sim(3) ≈ R^7",
        verdict=Verdict.CONFIRMED,
        form="7",
        cases=lambda: [3],
        deviation=_span,
        copies=(Copy("6, that of se(3)", "6"),),
    ),
    Claim(
        id="gallier.1.largest",
        place="section 1, the reason for SIM(3)",
        statement="SIM(3) is, as far as the authors know, the largest group of affine maps of space whose exponential "
        "is surjective and easily computed.",
        printed="it is the largest group of affine transformations for which the exponential map is surjective and "
        "easily computable",
        verdict=Verdict.BOUND,
        domain="among connected groups that contain SIM(3): the only larger one is that of all affine maps of positive "
        "determinant, whose exponential is not surjective. By dimension, 7, it is not the largest: the upper "
        "triangular affine maps with positive diagonal have 9, and exactly one logarithm each, by divided differences",
        form=_basis("turns", "growth"),
        cases=_groups_around,
        outside=_triangular_group,
        deviation=_larger,
        copies=(Copy("SE(3)", _basis("turns")),),
        remark="diag(-1, -2, 1) has a positive determinant and no real logarithm.",
    ),
    Claim(
        id="gallier.1.interpolation",
        place="section 1, steps 1 to 3",
        statement="The exponential of a spline through logarithms of the g_i is a curve in SIM(3) with c(i) = g_i.",
        printed="c(t) = e^{X(t)}, X(i) = log g_i",
        verdict=Verdict.CONFIRMED,
        form=_exponential_of_spline,
        cases=_journeys,
        deviation=_misses,
        copies=(
            Copy(
                "the exponential of the spline at t(1 + (t-1)²/100)",
                lambda keys, t: _exponential_of_spline(keys, t * (1 + (t - 1) ** 2 / 100)),
            ),
        ),
    ),
    Claim(
        id="gallier.1.novelty",
        place="section 1 and section 9",
        statement="Nobody else has looked into the trouble that the many values of the logarithm make; none of the "
        "papers cited on motion interpolation deals with it.",
        verdict=Verdict.UNCHECKABLE,
        reason="a statement on the literature; with quaternions, whether to take q or -q is the same trouble in "
        "another form",
    ),
    Claim(
        id="gallier.9.corrections",
        place="section 9",
        statement="Shoemake carried de Casteljau's algorithm over to the sphere of quaternions, and Kim, Kim and Shin "
        "put right mistakes of his.",
        verdict=Verdict.UNCHECKABLE,
        reason="a statement on other papers, which are not at hand; no mistake is named",
    ),
)
