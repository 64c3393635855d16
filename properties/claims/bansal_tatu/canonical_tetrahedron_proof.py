"""Appendix A.1.8: the proof of Theorem 2, that the canonical tetrahedron does not matter."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import TIMES, embedded, scaling, tetrahedra
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import distance, exactly, mp
from affinecert.reference import affine_lie
from affinecert.reference._groups import RIGID, SHEARS
from affinecert.reference._li_hao import Group
from affinecert.reference._matrices import Array, Number, identity, norm, scalar

Solids = tuple[Array, Array, Array, Array]
Element = tuple[Array, Array, Number]
TIME = TIMES[1]


@cache
def _cases() -> list[Solids]:
    """The tetrahedra p and q, and two that are taken as canonical, 1 and 2; the usual one first."""
    first, second = tetrahedra("canonical", 5), tetrahedra("other canonical", 9)[4:]
    return [
        (p, q, one, two)
        for p, q, one, two in zip(second, second[1:] + second[:1], first, [*first[3:], *second[2:]], strict=True)
    ]


def _element(solid: Array, canonical: Array) -> Element:
    """The E (4, 4), A (4, 4) and s of a tetrahedron with respect to a canonical one, E as in section 3."""
    e, a, s = affine_lie.represent(mp, solid[:3].T, canonical[:3].T)
    return e, embedded(mp, a), s[()]


def _decomposed(solid: Array, canonical: Array) -> Element:
    """The components A S E of the map to the canonical one itself, instead of equation 7."""
    affine = canonical @ _inverse(solid)
    affine[3] = exactly([0, 0, 0, 1])
    e, a, s = affine_lie.decompose(mp, affine)
    return e, embedded(mp, a), s[()]


def _inverse(matrix: Array) -> Array:
    return definitions.inverse(mp, matrix)


def _scale(s: Number) -> Array:
    return scaling(mp, s)


def _rigid(solid: Array) -> Array:
    return _element(solid, solid)[0]


def _step(group: Group, p: Array, q: Array, t: Number) -> Array:
    """exp(t log(p⁻¹ q)), of rigid motions or shears in 4x4 matrices."""
    n = 4 if group is RIGID else 3
    step = group.exp(mp, group.log(mp, (_inverse(p) @ q)[:n, :n]) * t)
    return step if n == 4 else embedded(mp, step)


def _between(p: Element, q: Element, t: Number = TIME) -> Element:
    """The components of equation 10."""
    return p[0] @ _step(RIGID, p[0], q[0], t), p[1] @ _step(SHEARS, p[1], q[1], t), p[2] * (q[2] / p[2]) ** t


def _by_powers(p: Element, q: Element, t: Number = TIME) -> Element:
    """The same with A_p^(1 - t) A_q^t for the shear."""
    e, _, s = _between(p, q, t)
    one = identity(mp, 4)
    return e, _step(SHEARS, one, p[1], 1 - t) @ _step(SHEARS, one, q[1], t), s


def _truth(case: Solids) -> Array:
    """The tetrahedron between p and q by equation 4 with the usual canonical one."""
    vertices = affine_lie.interpolate_tetrahedra(mp, case[0][:3].T, case[1][:3].T, scalar(TIME))
    truth: Array = vertices.T
    return truth


def _ratio(power: int = 1) -> Any:
    def printed(lengths: tuple[Number, Number, Number]) -> Number:
        p, q, canonical = lengths
        return (p / canonical) ** power * (canonical / q)

    return printed


def _wrong_ratio(form: Any, case: Solids) -> Number:
    p, q, *canonical = case
    first = [norm(mp, (solid[:, 1] - solid[:, 0])) for solid in case]
    return max(
        distance(form((*first[:2], length)), _element(q, solid)[2] / _element(p, solid)[2])
        for length, solid in zip(first[2:], canonical, strict=True)
    )


def _differs(form: Callable[[Element, Element], Any], case: Solids) -> Number:
    """How far the value for one canonical tetrahedron is from that for the other."""
    p, q, one, two = case
    return distance(form(_element(p, one), _element(q, one)), form(_element(p, two), _element(q, two)))


def _tangent(p: Element, q: Element) -> tuple[Array, Array, Number]:
    """The logarithm of p⁻¹ q."""
    rigid = RIGID.log(mp, _inverse(p[0]) @ q[0])
    return rigid, SHEARS.log(mp, (_inverse(p[1]) @ q[1])[:3, :3]), mp.log(q[2] / p[2])


def _shear_tangent_on_the_left(p: Element, q: Element) -> tuple[Array, Array, Number]:
    rigid, _, scale = _tangent(p, q)
    return rigid, SHEARS.log(mp, (q[1] @ _inverse(p[1]))[:3, :3]), scale


def _not_canonical(product: Any, case: Solids) -> Number:
    """How far the product is from mapping p to either canonical tetrahedron, given its E and the element of p."""
    p = case[0]
    return max(distance(product(_rigid(solid), *_element(p, solid)) @ p, solid) for solid in case[2:])


def _not_second(product: Any, case: Solids) -> Number:
    _, _, one, two = case
    return distance(product(_rigid(two), *_element(one, two)) @ one, two)


def _wrong_product(product: Any, case: Solids) -> Number:
    p, _, one, two = case
    _, a, s = _element(p, two)
    return distance(product(_element(one, two), _element(p, one)), a @ _scale(s))


def _shapes(first: Element, second: Element) -> Array:
    """A_1 S_1 A S of two elements, as in the second display."""
    product: Array = first[1] @ _scale(first[2]) @ second[1] @ _scale(second[2])
    return product


def _found(canonical: Array, element: Element, *, aligned: bool = True) -> Array:
    """The tetrahedron (E_i⁻¹ A S E)⁻¹ Δ_i, equations 12 and 13; without E_i if it is not aligned."""
    e, a, s = element
    to_canonical = a @ _scale(s) @ e
    if aligned:
        to_canonical = _inverse(_rigid(canonical)) @ to_canonical
    solid: Array = _inverse(to_canonical) @ canonical
    return solid


def _wrong_interpolant(form: Any, case: Solids) -> Number:
    p, q, *canonical = case
    truth = _truth(case)
    return max(distance(form(solid, _element(p, solid), _element(q, solid))[:3].T, truth.T) for solid in canonical)


def _through_first(*, inverted: bool = True) -> Any:
    """Equation 14: the second tetrahedron from the first canonical one."""

    def solid(case: Solids) -> Array:
        p, q, one, two = case
        _, a, s = _element(one, two)
        e_c, a_c, s_c = _between(_element(p, two), _element(q, two))
        if inverted:
            a, s = _inverse(a), 1 / s
        found: Array = _inverse(_inverse(_rigid(one)) @ _scale(s) @ a @ a_c @ _scale(s_c) @ e_c) @ one
        return found

    return solid


def _wrong_solid(form: Any, case: Solids) -> Number:
    return distance(form(case)[:3], _truth(case))


def _chain(*, commuted: bool = True) -> Any:
    """The members of the last chain of equations; with S_p and the shear's step exchanged unless ``commuted``."""

    def members(case: Solids) -> list[Array]:
        p, q, one, two = case
        _, a, s = _element(one, two)
        (_, a_p, s_p), (_, a_q, s_q) = _element(p, one), _element(q, one)
        (_, b_p, r_p), (_, b_q, r_q) = _element(p, two), _element(q, two)
        moved = a @ _scale(s) @ a_p
        step, other = _step(SHEARS, a_p, a_q, TIME), _step(SHEARS, b_p, b_q, TIME)
        growth, again = _scale((s_q / s_p) ** TIME), _scale((r_q / r_p) ** TIME)
        third = moved @ _scale(s_p) @ step @ growth if commuted else a @ _scale(s) @ step @ a_p @ _scale(s_p) @ growth
        _, a_c, s_c = _between(_element(p, one), _element(q, one))
        return [
            a @ _scale(s) @ a_c @ _scale(s_c),
            moved @ step @ _scale(s_p) @ growth,
            third,
            b_p @ _scale(r_p) @ step @ growth,
            b_p @ other @ _scale(r_p) @ again,
        ]

    return members


def _unequal(members: Any, case: Solids) -> Number:
    """How far the members are from A_c2 S_c2."""
    p, q, _, two = case
    _, a_c, s_c = _between(_element(p, two), _element(q, two))
    return max(distance(member, a_c @ _scale(s_c)) for member in members(case))


def _by(element: Callable[[Array, Array], Element], *, aligned: bool = True) -> Any:
    """The interpolant of p and q by a canonical tetrahedron, with elements of that kind."""
    return lambda p, q, canonical: _found(
        canonical, _between(element(p, canonical), element(q, canonical)), aligned=aligned
    )


def _depends(interpolant: Any, case: Solids) -> Number:
    p, q, one, two = case
    return distance(interpolant(p, q, one), interpolant(p, q, two))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.8.scale",
        place="appendix A.1.8, below equation 10",
        statement="The ratio of scales depends on the lengths of the first edges of p and q only.",
        printed="s_p1⁻¹ s_q1 = (l_p / l_1)(l_1 / l_q) = (l_p / l_2)(l_2 / l_q) = s_p2⁻¹ s_q2",
        verdict=Verdict.CONFIRMED,
        form=_ratio(),
        cases=_cases,
        deviation=_wrong_ratio,
        copies=(Copy("l_1 / l_p for l_p / l_1", _ratio(-1)),),
    ),
    Claim(
        id="bansal_tatu.A.1.8.shear",
        place="appendix A.1.8, below equation 10",
        statement="A_p⁻¹ A_q depends on p and q only, not on the canonical tetrahedron.",
        printed="(A_p1)⁻¹ A_q1 = (A_p2)⁻¹ A_q2",
        verdict=Verdict.CONFIRMED,
        form=lambda p, q: _inverse(p[1]) @ q[1],
        cases=_cases,
        deviation=_differs,
        copies=(
            Copy("A_q A_p⁻¹", lambda p, q: q[1] @ _inverse(p[1])),
            Copy("A_p A_q", lambda p, q: p[1] @ q[1]),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.8.tangent",
        place="appendix A.1.8, below equation 10",
        statement="The tangent vector at the identity, log(p⁻¹q), does not depend on the canonical tetrahedron.",
        verdict=Verdict.CONFIRMED,
        form=_tangent,
        cases=_cases,
        deviation=_differs,
        copies=(Copy("log(A_q A_p⁻¹) for the shear", _shear_tangent_on_the_left),),
    ),
    Claim(
        id="bansal_tatu.A.1.8.to_canonical",
        place="appendix A.1.8, first display",
        statement="The map from p to a canonical tetrahedron Δ_i, by the components of p and the E_i of Δ_i.",
        printed="(E_1⁻¹ A_p1 S_p1 E_p) Δ_p = Δ_1",
        verdict=Verdict.CONFIRMED,
        form=lambda own, e, a, s: _inverse(own) @ a @ _scale(s) @ e,
        cases=_cases,
        deviation=_not_canonical,
        copies=(
            Copy("without E_1⁻¹", lambda own, e, a, s: a @ _scale(s) @ e),
            Copy("E_1 for E_1⁻¹", lambda own, e, a, s: own @ a @ _scale(s) @ e),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.8.equation_11",
        place="appendix A.1.8, equation 11",
        statement="The map from one canonical tetrahedron to the other.",
        printed="(E_2⁻¹ A_1 S_1 E_1) Δ_1 = Δ_2",
        verdict=Verdict.CONFIRMED,
        form=lambda own, e, a, s: _inverse(own) @ a @ _scale(s) @ e,
        cases=_cases,
        deviation=_not_second,
        copies=(
            Copy("E_2 for E_2⁻¹", lambda own, e, a, s: own @ a @ _scale(s) @ e),
            Copy("E_1 and E_2 exchanged", lambda own, e, a, s: _inverse(e) @ a @ _scale(s) @ own),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.8.product",
        place="appendix A.1.8, below equation 11",
        statement="The shapes of p for the two canonical tetrahedra differ by that of the first for the second.",
        printed="A_1 S_1 A_p1 S_p1 = A_p2 S_p2",
        verdict=Verdict.CONFIRMED,
        form=_shapes,
        cases=_cases,
        deviation=_wrong_product,
        copies=(Copy("A_p1 S_p1 A_1 S_1", lambda first, second: _shapes(second, first)),),
    ),
    Claim(
        id="bansal_tatu.A.1.8.equations_10_12_13",
        place="appendix A.1.8, equations 10, 12 and 13",
        statement="The interpolated tetrahedron from its interpolated components and its canonical tetrahedron.",
        printed="(E_i⁻¹ A_ci S_ci E_ci)⁻¹ Δ_i = Δ_ci; A_ci = A_pi exp(t log(A_pi⁻¹ A_qi)), and so E_ci and s_ci",
        verdict=Verdict.CONFIRMED,
        form=lambda canonical, p, q: _found(canonical, _between(p, q)),
        cases=_cases,
        deviation=_wrong_interpolant,
        copies=(
            Copy("A_p^(1 - t) A_q^t", lambda canonical, p, q: _found(canonical, _by_powers(p, q))),
            Copy("without E_i⁻¹", lambda canonical, p, q: _found(canonical, _between(p, q), aligned=False)),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.8.equation_14",
        place="appendix A.1.8, equation 14",
        statement="The second interpolated tetrahedron from the first canonical one.",
        printed="(E_1⁻¹ S_1⁻¹ A_1⁻¹ A_c2 S_c2 E_c2)⁻¹ Δ_1 = Δ_c2",
        verdict=Verdict.CONFIRMED,
        form=_through_first(),
        cases=_cases,
        deviation=_wrong_solid,
        copies=(Copy("S_1 A_1 for S_1⁻¹ A_1⁻¹", _through_first(inverted=False)),),
    ),
    Claim(
        id="bansal_tatu.A.1.8.equation_15",
        place="appendix A.1.8, equation 15 and the chain of equations below it",
        statement="A_1 S_1 A_c1 S_c1 = A_c2 S_c2, by way of every member of the chain.",
        printed="A_1 S_1 A_c1 S_c1 = A_1 S_1 A_p1 S_p1 exp(t log(A_p1⁻¹ A_q1)) exp(t log(S_p1⁻¹ S_q1)) = A_c2 S_c2",
        verdict=Verdict.CONFIRMED,
        form=_chain(),
        cases=_cases,
        deviation=_unequal,
        copies=(Copy("the step of the shear before A_p1", _chain(commuted=False)),),
    ),
    Claim(
        id="bansal_tatu.A.1.8.invariance",
        place="appendix A.1.8; Theorem 2",
        statement="The tetrahedron between p and q does not depend on the canonical one.",
        printed="Δ_c1 = Δ_c2",
        verdict=Verdict.CONFIRMED,
        form=_by(_element),
        cases=_cases,
        deviation=_depends,
        copies=(
            Copy("with the components A S E of the maps to Δ_1 and Δ_2 themselves", _by(_decomposed, aligned=False)),
            Copy("without E_i⁻¹", _by(_element, aligned=False)),
        ),
        remark="Equation 7, the E of section 3 for every canonical tetrahedron, is essential.",
    ),
)
