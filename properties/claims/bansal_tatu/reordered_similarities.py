"""Section 5.2.1: the order of the vertices does not matter to isometries; to scalings it does."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.orderings import apart, by_lie
from affinecert.properties.claims.bansal_tatu.samples import (
    CANONICAL,
    REGULAR,
    inverse,
    moved,
    rigid_maps,
    scaling,
    tetrahedra,
)
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.precision import difference, distance, mp
from affinecert.reference import affine_lie, measures, se3
from affinecert.reference._matrices import Array, Number, array


def _relation(*, scaled: bool = False) -> Callable[[Array, Array], Array]:
    """E_q of E_p, for Δ_q = S E Δ_p."""

    def rigid(rigid_p: Array, similarity: Array) -> Array:
        scale = scaling(_growth(similarity))
        step = inverse(inverse(scale) @ similarity)
        moving: Array = scale @ rigid_p @ step @ inverse(scale) if scaled else rigid_p @ step
        return moving

    return rigid


def _growth(similarity: Array) -> Number:
    return mp.cbrt(definitions.determinant(similarity[:3, :3]))


def _other_relation(rigid: Callable[[Array, Array], Array], case: tuple[Array, Array]) -> Number:
    """How far (E_q, A_q, s_q) is from that E_q, A_p and s_p / s."""
    similarity, source = case
    p, q = (affine_lie.represent(mp, each, CANONICAL) for each in (source, moved(similarity, source)))
    return distance((q[0], q[1], q[2][()]), (rigid(p[0], similarity), p[1], p[2][()] / _growth(similarity)))


def _similarities() -> list[tuple[Array, Array]]:
    """Isometries and then similarities, with tetrahedra."""
    pairs = list(zip(rigid_maps(), tetrahedra(), strict=False))
    return [*pairs, (scaling(mp.mpf(2)), CANONICAL + 1), (scaling(mp.mpf(3)) @ rigid_maps()[2], REGULAR)]


def _isometries() -> list[tuple[Array, Array]]:
    return list(zip(rigid_maps(), (CANONICAL, REGULAR, *tetrahedra()[3:]), strict=False))


def _scalings() -> list[tuple[Array, Array]]:
    little = mp.mpf(17) / 16
    return [
        (scaling(little), CANONICAL),
        (scaling(mp.mpf(2)), REGULAR),
        (scaling(little) @ rigid_maps()[2], tetrahedra()[4]),
    ]


def _doubled() -> dict[str, Number]:
    times = array([-mp.log(mp.log(2), 2)])  # where 1 + t - 2^t, by which the centres of scaling differ, is largest
    source = REGULAR / mp.sqrt(3)
    most, median = measures.path_deviation(mp, source, 2 * source, times)
    return {"u for a regular tetrahedron in the unit sphere, doubled: maximum": most, "median": median}


def _tangent(p: Array, q: Array) -> Array:
    return se3.log(mp, inverse(p) @ q)


def _tangents_apart(tangent: Callable[[Array, Array], Array], case: tuple[Array, Array]) -> Number:
    """How far log(E_p^-1 E_q) of the orderings are apart."""
    pose, source = case
    target = moved(pose, source)
    found = []
    for order in map(list, affine_lie.ORDERINGS):
        p, q = (affine_lie.represent(mp, each[order], CANONICAL)[0] for each in (source, target))
        found.append(tangent(p, q))
    return max(difference(found[0], other) for other in found[1:])


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.5.2.1.relation",
        place="section 5.2.1",
        statement="If Δ_q = S E Δ_p, then q = p (E⁻¹, I, 1/s).",
        printed="q_O = p_O (E⁻¹, I₃, 1/s)",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_relation(),
        cases=_similarities,
        deviation=_other_relation,
        correction=Correction(
            statement="q = (S E_p E⁻¹ S⁻¹, A_p, s_p / s): the translation of E_q is scaled, too",
            form=_relation(scaled=True),
        ),
        remark="S and the translation of E_p do not commute. It is right for isometries, s = 1.",
    ),
    Claim(
        id="bansal_tatu.5.2.1.tangent",
        place="section 5.2.1",
        statement="For isometries and uniform scalings the tangent vector log(p⁻¹q) is the same for all orderings.",
        printed="log((p_O)⁻¹ q_O) = log((E⁻¹, I₃, 1/s))",
        verdict=Verdict.BOUND,
        domain="isometries, s = 1",
        form=_tangent,
        cases=_isometries,
        outside=_scalings,
        deviation=_tangents_apart,
        copies=(Copy("q p⁻¹ for p⁻¹q", lambda p, q: se3.log(mp, q @ inverse(p))),),
    ),
    Claim(
        id="bansal_tatu.5.2.1.invariance",
        place="section 5.2.1",
        statement="The interpolation does not depend on the order of the vertices if the map is an isometry, a uniform "
        "scaling or both.",
        verdict=Verdict.BOUND,
        domain="isometries, s = 1; each ordering scales about a path of its own first vertex",
        form=by_lie,
        cases=_isometries,
        outside=_scalings,
        deviation=apart,
        copies=(Copy("the interpolant of a tetrahedron twice as large", lambda p, q, t: by_lie(p, 2 * q, t)),),
        numbers=_doubled,
        remark="The shapes are the same up to translation; their places differ.",
    ),
)
