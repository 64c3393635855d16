"""Appendix A.1.8, second half of the proof of Theorem 2: the interpolant by several canonical tetrahedra is one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.bansal_tatu.appendix_cases import TIMES, embedded
from affinecert.properties.claims.bansal_tatu.canonical_tetrahedron_components import (
    Element,
    Solids,
    element,
    inverse,
    rigid_component,
    scale_matrix,
    solids,
)
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import distance, exactly, mp
from affinecert.reference import affine_lie
from affinecert.reference._groups import RIGID, SHEARS
from affinecert.reference._li_hao import Group
from affinecert.reference._matrices import Array, Number, identity, scalar

TIME = TIMES[1]


def _decomposed(solid: Array, canonical: Array) -> Element:
    """The components A S E of the map to the canonical one itself, instead of equation 7."""
    affine = canonical @ inverse(solid)
    affine[3] = exactly([0, 0, 0, 1])
    e, a, s = affine_lie.decompose(mp, affine)
    return e, embedded(mp, a), s[()]


def _step(group: Group, p: Array, q: Array, t: Number) -> Array:
    """exp(t log(p⁻¹ q)), of rigid motions or shears in 4x4 matrices."""
    n = 4 if group is RIGID else 3
    step = group.exp(mp, group.log(mp, (inverse(p) @ q)[:n, :n]) * t)
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


def _found(canonical: Array, element: Element, *, aligned: bool = True) -> Array:
    """The tetrahedron (E_i⁻¹ A S E)⁻¹ Δ_i, equations 12 and 13; without E_i if it is not aligned."""
    e, a, s = element
    to_canonical = a @ scale_matrix(s) @ e
    if aligned:
        to_canonical = inverse(rigid_component(canonical)) @ to_canonical
    solid: Array = inverse(to_canonical) @ canonical
    return solid


def _wrong_interpolant(form: Any, case: Solids) -> Number:
    p, q, *canonical = case
    truth = _truth(case)
    return max(distance(form(solid, element(p, solid), element(q, solid))[:3].T, truth.T) for solid in canonical)


def _through_first(*, inverted: bool = True) -> Any:
    """Equation 14: the second tetrahedron from the first canonical one."""

    def solid(case: Solids) -> Array:
        p, q, one, two = case
        _, a, s = element(one, two)
        e_c, a_c, s_c = _between(element(p, two), element(q, two))
        if inverted:
            a, s = inverse(a), 1 / s
        found: Array = (
            inverse(inverse(rigid_component(one)) @ scale_matrix(s) @ a @ a_c @ scale_matrix(s_c) @ e_c) @ one
        )
        return found

    return solid


def _wrong_solid(form: Any, case: Solids) -> Number:
    return distance(form(case)[:3], _truth(case))


def _chain(*, commuted: bool = True) -> Any:
    """The members of the last chain of equations; with S_p and the shear's step exchanged unless ``commuted``."""

    def members(case: Solids) -> list[Array]:
        p, q, one, two = case
        _, a, s = element(one, two)
        (_, a_p, s_p), (_, a_q, s_q) = element(p, one), element(q, one)
        (_, b_p, r_p), (_, b_q, r_q) = element(p, two), element(q, two)
        moved = a @ scale_matrix(s) @ a_p
        step, other = _step(SHEARS, a_p, a_q, TIME), _step(SHEARS, b_p, b_q, TIME)
        growth, again = scale_matrix((s_q / s_p) ** TIME), scale_matrix((r_q / r_p) ** TIME)
        third = (
            moved @ scale_matrix(s_p) @ step @ growth
            if commuted
            else a @ scale_matrix(s) @ step @ a_p @ scale_matrix(s_p) @ growth
        )
        _, a_c, s_c = _between(element(p, one), element(q, one))
        return [
            a @ scale_matrix(s) @ a_c @ scale_matrix(s_c),
            moved @ step @ scale_matrix(s_p) @ growth,
            third,
            b_p @ scale_matrix(r_p) @ step @ growth,
            b_p @ other @ scale_matrix(r_p) @ again,
        ]

    return members


def _unequal(members: Any, case: Solids) -> Number:
    """How far the members are from A_c2 S_c2."""
    p, q, _, two = case
    _, a_c, s_c = _between(element(p, two), element(q, two))
    return max(distance(member, a_c @ scale_matrix(s_c)) for member in members(case))


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
        id="bansal_tatu.A.1.8.equations_10_12_13",
        place="appendix A.1.8, equations 10, 12 and 13",
        statement="The interpolated tetrahedron from its interpolated components and its canonical tetrahedron.",
        printed="(E_i⁻¹ A_ci S_ci E_ci)⁻¹ Δ_i = Δ_ci; A_ci = A_pi exp(t log(A_pi⁻¹ A_qi)), and so E_ci and s_ci",
        verdict=Verdict.CONFIRMED,
        form=lambda canonical, p, q: _found(canonical, _between(p, q)),
        cases=solids,
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
        cases=solids,
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
        cases=solids,
        deviation=_unequal,
        copies=(Copy("the step of the shear before A_p1", _chain(commuted=False)),),
    ),
    Claim(
        id="bansal_tatu.A.1.8.invariance",
        place="appendix A.1.8; Theorem 2",
        statement="The tetrahedron between p and q does not depend on the canonical one.",
        printed="Δ_c1 = Δ_c2",
        verdict=Verdict.CONFIRMED,
        form=_by(element),
        cases=solids,
        deviation=_depends,
        copies=(
            Copy("with the components A S E of the maps to Δ_1 and Δ_2 themselves", _by(_decomposed, aligned=False)),
            Copy("without E_i⁻¹", _by(element, aligned=False)),
        ),
        remark="Equation 7, the E of section 3 for every canonical tetrahedron, is essential.",
    ),
)
