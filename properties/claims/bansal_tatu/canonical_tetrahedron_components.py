"""Appendix A.1.8, first half of the proof of Theorem 2: components with respect to several canonical tetrahedra."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import embedded, scaling, tetrahedra
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import distance, mp
from affinecert.reference import affine_lie
from affinecert.reference._groups import RIGID, SHEARS
from affinecert.reference._matrices import Array, Number, norm

Solids = tuple[Array, Array, Array, Array]
Element = tuple[Array, Array, Number]


@cache
def solids() -> list[Solids]:
    """The tetrahedra p and q, and two that are taken as canonical, 1 and 2; the usual one first."""
    first, second = tetrahedra("canonical", 5), tetrahedra("other canonical", 9)[4:]
    return [
        (p, q, one, two)
        for p, q, one, two in zip(second, second[1:] + second[:1], first, [*first[3:], *second[2:]], strict=True)
    ]


def element(solid: Array, canonical: Array) -> Element:
    """The E (4, 4), A (4, 4) and s of a tetrahedron with respect to a canonical one, E as in section 3."""
    e, a, s = affine_lie.represent(mp, solid[:3].T, canonical[:3].T)
    return e, embedded(mp, a), s[()]


def inverse(matrix: Array) -> Array:
    """The inverse matrix."""
    return definitions.inverse(mp, matrix)


def scale_matrix(s: Number) -> Array:
    """S = diag(s, s, s, 1)."""
    return scaling(mp, s)


def rigid_component(solid: Array) -> Array:
    """The E of a tetrahedron, whatever is canonical."""
    return element(solid, solid)[0]


def _ratio(power: int = 1) -> Any:
    def printed(lengths: tuple[Number, Number, Number]) -> Number:
        p, q, canonical = lengths
        return (p / canonical) ** power * (canonical / q)

    return printed


def _wrong_ratio(form: Any, case: Solids) -> Number:
    p, q, *canonical = case
    first = [norm(mp, (solid[:, 1] - solid[:, 0])) for solid in case]
    return max(
        distance(form((*first[:2], length)), element(q, solid)[2] / element(p, solid)[2])
        for length, solid in zip(first[2:], canonical, strict=True)
    )


def _differs(form: Callable[[Element, Element], Any], case: Solids) -> Number:
    """How far the value for one canonical tetrahedron is from that for the other."""
    p, q, one, two = case
    return distance(form(element(p, one), element(q, one)), form(element(p, two), element(q, two)))


def _tangent(p: Element, q: Element) -> tuple[Array, Array, Number]:
    """The logarithm of p⁻¹ q."""
    rigid = RIGID.log(mp, inverse(p[0]) @ q[0])
    return rigid, SHEARS.log(mp, (inverse(p[1]) @ q[1])[:3, :3]), mp.log(q[2] / p[2])


def _shear_tangent_on_the_left(p: Element, q: Element) -> tuple[Array, Array, Number]:
    rigid, _, scale = _tangent(p, q)
    return rigid, SHEARS.log(mp, (q[1] @ inverse(p[1]))[:3, :3]), scale


def _not_canonical(product: Any, case: Solids) -> Number:
    """How far the product is from mapping p to either canonical tetrahedron, given its E and the element of p."""
    p = case[0]
    return max(distance(product(rigid_component(solid), *element(p, solid)) @ p, solid) for solid in case[2:])


def _not_second(product: Any, case: Solids) -> Number:
    _, _, one, two = case
    return distance(product(rigid_component(two), *element(one, two)) @ one, two)


def _wrong_product(product: Any, case: Solids) -> Number:
    p, _, one, two = case
    _, a, s = element(p, two)
    return distance(product(element(one, two), element(p, one)), a @ scale_matrix(s))


def _shapes(first: Element, second: Element) -> Array:
    """A_1 S_1 A S of two elements, as in the second display."""
    product: Array = first[1] @ scale_matrix(first[2]) @ second[1] @ scale_matrix(second[2])
    return product


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.8.scale",
        place="appendix A.1.8, below equation 10",
        statement="The ratio of scales depends on the lengths of the first edges of p and q only.",
        printed="s_p1⁻¹ s_q1 = (l_p / l_1)(l_1 / l_q) = (l_p / l_2)(l_2 / l_q) = s_p2⁻¹ s_q2",
        verdict=Verdict.CONFIRMED,
        form=_ratio(),
        cases=solids,
        deviation=_wrong_ratio,
        copies=(Copy("l_1 / l_p for l_p / l_1", _ratio(-1)),),
    ),
    Claim(
        id="bansal_tatu.A.1.8.shear",
        place="appendix A.1.8, below equation 10",
        statement="A_p⁻¹ A_q depends on p and q only, not on the canonical tetrahedron.",
        printed="(A_p1)⁻¹ A_q1 = (A_p2)⁻¹ A_q2",
        verdict=Verdict.CONFIRMED,
        form=lambda p, q: inverse(p[1]) @ q[1],
        cases=solids,
        deviation=_differs,
        copies=(
            Copy("A_q A_p⁻¹", lambda p, q: q[1] @ inverse(p[1])),
            Copy("A_p A_q", lambda p, q: p[1] @ q[1]),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.8.tangent",
        place="appendix A.1.8, below equation 10",
        statement="The tangent vector at the identity, log(p⁻¹q), does not depend on the canonical tetrahedron.",
        verdict=Verdict.CONFIRMED,
        form=_tangent,
        cases=solids,
        deviation=_differs,
        copies=(Copy("log(A_q A_p⁻¹) for the shear", _shear_tangent_on_the_left),),
    ),
    Claim(
        id="bansal_tatu.A.1.8.to_canonical",
        place="appendix A.1.8, first display",
        statement="The map from p to a canonical tetrahedron Δ_i, by the components of p and the E_i of Δ_i.",
        printed="(E_1⁻¹ A_p1 S_p1 E_p) Δ_p = Δ_1",
        verdict=Verdict.CONFIRMED,
        form=lambda own, e, a, s: inverse(own) @ a @ scale_matrix(s) @ e,
        cases=solids,
        deviation=_not_canonical,
        copies=(
            Copy("without E_1⁻¹", lambda own, e, a, s: a @ scale_matrix(s) @ e),
            Copy("E_1 for E_1⁻¹", lambda own, e, a, s: own @ a @ scale_matrix(s) @ e),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.8.equation_11",
        place="appendix A.1.8, equation 11",
        statement="The map from one canonical tetrahedron to the other.",
        printed="(E_2⁻¹ A_1 S_1 E_1) Δ_1 = Δ_2",
        verdict=Verdict.CONFIRMED,
        form=lambda own, e, a, s: inverse(own) @ a @ scale_matrix(s) @ e,
        cases=solids,
        deviation=_not_second,
        copies=(
            Copy("E_2 for E_2⁻¹", lambda own, e, a, s: own @ a @ scale_matrix(s) @ e),
            Copy("E_1 and E_2 exchanged", lambda own, e, a, s: inverse(e) @ a @ scale_matrix(s) @ own),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.8.product",
        place="appendix A.1.8, below equation 11",
        statement="The shapes of p for the two canonical tetrahedra differ by that of the first for the second.",
        printed="A_1 S_1 A_p1 S_p1 = A_p2 S_p2",
        verdict=Verdict.CONFIRMED,
        form=_shapes,
        cases=solids,
        deviation=_wrong_product,
        copies=(Copy("A_p1 S_p1 A_1 S_1", lambda first, second: _shapes(second, first)),),
    ),
)
