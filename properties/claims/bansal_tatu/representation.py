"""Section 3: a tetrahedron as the rigid motion, shear and scale A S E that bring it onto the canonical one."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.bansal_tatu.alignment import alignment, shear_to_canonical
from affinecert.properties.claims.bansal_tatu.samples import (
    CANONICAL,
    embedded,
    inverse,
    maps,
    mirrored,
    moved,
    scaling,
    tetrahedra,
)
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import distance, exactly, mp, size
from affinecert.reference._matrices import Array, Number, homogeneous, identity, norm

Parts = tuple[Array, Array, Number]
"""E (4, 4), A (3, 3) and s."""


def _represented(scale: int = -1, origin: int = 1) -> Any:
    """The steps of section 3; ``scale`` is the power of |v_1| that is s, d is -``origin`` R u_0."""

    def parts(vertices: Array) -> Parts:
        rotation = alignment()(vertices)
        s = norm(mp, vertices[1] - vertices[0]) ** scale
        _, w2, w3 = ((vertices[1:] - vertices[0]) @ rotation.T * s).copy()
        return homogeneous(mp, rotation, -(rotation @ vertices[0]) * origin), shear_to_canonical(w2, w3), s

    return parts


def _composed(order: str) -> Any:
    """The product of A, S and E in an order."""

    def product(rigid: Array, shear: Array, scale: Number) -> Array:
        factors = {"A": embedded(shear), "S": scaling(scale), "E": rigid}
        first, second, third = (factors[letter] for letter in order)
        result: Array = first @ second @ third
        return result

    return product


def _not_canonical(compose: Any, vertices: Array) -> Number:
    return size(moved(compose(*_represented()(vertices)), vertices) - CANONICAL)


def _not_represented(represent: Any, vertices: Array) -> Number:
    """How far the parts are from an element of SE(3) x G_A x G_S that brings a tetrahedron onto the canonical one."""
    rigid, shear, scale = represent(vertices)
    turn = rigid[:3, :3]
    wrong = [size(turn @ turn.T - identity(mp, 3)), -min(scale, shear[1, 1], shear[2, 2], 0)]
    return max(*wrong, size(moved(_composed("ASE")(rigid, shear, scale), vertices) - CANONICAL))


def _unlike(tetrahedron: Any, pose: Array) -> Number:
    return distance(_composed("ASE")(*_represented()(tetrahedron(pose))), pose)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.3.1.equation_1",
        place="section 3.1, equation 1",
        statement="The affine map that brings a tetrahedron onto the canonical one is T = A S E.",
        printed="T = A S E",
        verdict=Verdict.CONFIRMED,
        form=_composed("ASE"),
        cases=tetrahedra,
        deviation=_not_canonical,
        copies=(Copy("E S A", _composed("ESA")), Copy("A E S", _composed("AES"))),
        remark="A and S commute: S A E is the same. The scale acts on E's translation, too.",
    ),
    Claim(
        id="bansal_tatu.3.1.every_tetrahedron",
        place="sections 3 and 3.1",
        statement="Each tetrahedron can be brought onto the canonical one, and any is represented by an (E, A, s).",
        verdict=Verdict.BOUND,
        domain="tetrahedra that are not flat and oriented as the canonical one, as section 3 supposes at first",
        form=_represented(),
        cases=tetrahedra,
        outside=lambda: [mirrored(CANONICAL), exactly([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])],
        deviation=_not_represented,
        copies=(Copy("s = |v₁|", _represented(scale=1)), Copy("d = R u₀", _represented(origin=-1))),
    ),
    Claim(
        id="bansal_tatu.3.3.map_by_inverse",
        place="section 3.3",
        statement="An orientation-preserving affine map T is represented by the tetrahedron T⁻¹Δ, Δ the canonical one.",
        verdict=Verdict.CONFIRMED,
        form=lambda pose: moved(inverse(pose), CANONICAL),
        cases=maps,
        deviation=_unlike,
        copies=(Copy("TΔ for T⁻¹Δ", lambda pose: moved(pose, CANONICAL)),),
        remark="So of the two ways between maps and tetrahedra the inverse one keeps T = A S E; see equation 4.",
    ),
)
