"""Interpolation does not depend on which tetrahedron is taken as canonical."""

from __future__ import annotations

from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask_all
from affinecert.properties.inexact import Affine, Inexact, precisely
from affinecert.properties.law import Law
from affinecert.properties.special import CANONICAL

REPRESENT = "affine_lie.represent"


def _step(maps: Maps, source: Array, target: Array, canonical: Array) -> tuple[Affine, Affine, Inexact, Inexact]:
    """E_p, E_q, A_p^-1 A_q and s_p^-1 s_q: what the interpolant between p and q is made from."""
    rigid_p, shear_p, scale_p = ask_all(maps, REPRESENT, source, canonical)
    rigid_q, shear_q, scale_q = ask_all(maps, REPRESENT, target, canonical)
    shear = shear_p.whole.inverse() @ shear_q.whole
    return rigid_p.affine, rigid_q.affine, shear, scale_p.whole.inverse() @ scale_q.whole


def _invariant(maps: Maps, source: Array, target: Array, one: Array, other: Array) -> float:
    rigid_p, rigid_q, shear, scale = _step(maps, source, target, one)
    again = _step(maps, source, target, other)
    return max(rigid_p.misfit(again[0]), rigid_q.misfit(again[1]), shear.misfit(again[2]), scale.misfit(again[3]))


def _represents(maps: Maps, solid: Array, canonical: Array) -> float:
    rigid, shear, scale = ask_all(maps, REPRESENT, solid, canonical)
    own, _, _ = ask_all(maps, REPRESENT, canonical, CANONICAL)
    aligning = rigid.affine.then(scale.whole, shear.whole)
    corners = zip(solid, canonical, strict=True)
    return max(aligning(precisely(corner)).misfit(own.affine(precisely(image))) for corner, image in corners)


LAWS = (
    Law(
        name="canonical_tetrahedron.invariance",
        statement="E_p, E_q, A_p^-1 A_q and s_p^-1 s_q, and so the interpolant p exp(t log p^-1 q), are the same "
        "whatever tetrahedron is canonical",
        source="bansal_tatu, Theorem 2 and its proof (A.1.8)",
        domain="all tetrahedra oriented as the standard canonical one",
        needs=(REPRESENT,),
        inputs=st.tuples(*[strategies.tetrahedra()] * 4),
        residual=_invariant,
    ),
    Law(
        name="canonical_tetrahedron.representation",
        statement="A_p S_p E_p maps the tetrahedron p to the aligned canonical one, E_c c",
        source="bansal_tatu, section 5.1, equation 7",
        domain="all tetrahedra oriented as the standard canonical one",
        needs=(REPRESENT,),
        inputs=st.tuples(*[strategies.tetrahedra()] * 2),
        residual=_represents,
    ),
)
