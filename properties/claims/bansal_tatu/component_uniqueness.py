"""Appendix A.1.2, part (3) of Theorem 1: every orientation-preserving affine map is A S E in one way."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import (
    CANONICAL,
    components,
    composed,
    embedded,
    scaling,
    tetrahedra,
)
from affinecert.properties.claims.bansal_tatu.tetrahedron_alignment import represented
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import distance, mp
from affinecert.reference._matrices import Array, Context, Number

Solids = tuple[Array, Array]


def _solids() -> list[tuple[Array]]:
    return [(solid,) for solid in tetrahedra("aligned", 8)]


def _not_canonical(product: Any, case: tuple[Array]) -> Number:
    rigid_motion, shear_matrix, s = represented(mp, *case)
    return distance(product(embedded(mp, shear_matrix), scaling(mp, s), rigid_motion) @ case[0], CANONICAL)


def _decomposition(*, inverted: bool = True) -> Any:
    """The components of a map, those of the tetrahedron T⁻¹ Δ that it maps to the canonical one."""

    def parts(m: Context, affine: Array) -> tuple[Array, Array, Number]:
        return represented(m, (definitions.inverse(m, affine) if inverted else affine) @ CANONICAL)

    return parts


def _not_recovered(form: Any, case: tuple[Array, Array, Number]) -> Number:
    return distance(form(mp, composed(mp, *case)), case)


def _pairs() -> list[Solids]:
    return list(zip(tetrahedra("from", 5), tetrahedra("to", 5)[::-1], strict=True))


def _to_canonical(solid: Array) -> Array:
    return composed(mp, *represented(mp, solid))


def _not_target(form: Any, case: Solids) -> Number:
    return distance(form(*map(_to_canonical, case)) @ case[0], case[1])


def _not_back(form: Any, case: Solids) -> Number:
    """How far the map between them is from mapping that tetrahedron to the canonical one."""
    source, target = case
    between = target @ definitions.inverse(mp, source)
    return distance(between @ form(*map(_to_canonical, case)) @ CANONICAL, CANONICAL)


def _inverse(matrix: Array) -> Array:
    return definitions.inverse(mp, matrix)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.2.3.product",
        place="appendix A.1.2 (3)",
        statement="The map to the canonical tetrahedron is the product of the three components.",
        printed="T = A S E",
        verdict=Verdict.CONFIRMED,
        form=lambda a, s, e: a @ s @ e,
        cases=_solids,
        deviation=_not_canonical,
        copies=(
            Copy("E S A, the order of the product in section 4.1", lambda a, s, e: e @ s @ a),
            Copy("A E S", lambda a, s, e: a @ e @ s),
        ),
        remark="S A E is the same, as A and S commute.",
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.unique",
        place="appendix A.1.2 (3); Theorem 1 (3)",
        statement="The components of A S E, found from the tetrahedron that it maps to the canonical one, are E, A, s.",
        verdict=Verdict.CONFIRMED,
        form=_decomposition(),
        cases=lambda: components("unique", 8),
        deviation=_not_recovered,
        copies=(Copy("T Δ for T⁻¹ Δ", _decomposition(inverted=False)),),
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.general",
        place="appendix A.1.2 (3), last paragraph",
        statement="The map between two tetrahedra goes by way of the canonical one.",
        printed="T = (T_Y)⁻¹ T_X",
        verdict=Verdict.CONFIRMED,
        form=lambda t_x, t_y: _inverse(t_y) @ t_x,
        cases=_pairs,
        deviation=_not_target,
        copies=(
            Copy("T_X (T_Y)⁻¹", lambda t_x, t_y: t_x @ _inverse(t_y)),
            Copy("(T_X)⁻¹ T_Y", lambda t_x, t_y: _inverse(t_x) @ t_y),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.2.3.back",
        place="appendix A.1.2 (3), last sentence",
        statement="T maps the tetrahedron (T_X)⁻¹ T_Y Δ to the canonical one, Δ.",
        printed="T also maps the tetrahedron (T_X)⁻¹ T_Y Δ to Δ",
        verdict=Verdict.CONFIRMED,
        form=lambda t_x, t_y: _inverse(t_x) @ t_y,
        cases=_pairs,
        deviation=_not_back,
        copies=(
            Copy("(T_Y)⁻¹ T_X Δ", lambda t_x, t_y: _inverse(t_y) @ t_x),
            Copy("T_Y (T_X)⁻¹ Δ", lambda t_x, t_y: t_y @ _inverse(t_x)),
        ),
        remark="It is T⁻¹ Δ: so the components of a map are those of T⁻¹ Δ, whatever tetrahedra it was given by.",
    ),
)
