"""Every map of positive determinant is a product in one way only.

An affine one of a shear, a scaling and a rigid motion; a linear one of a rotation and a stretch.
"""

from __future__ import annotations

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answer import near_rigid
from affinecert.properties.answers import Maps, ask, ask_all
from affinecert.properties.inexact import affine, precisely
from affinecert.properties.law import Law

DECOMPOSE, COMPOSE, POLAR = "affine_lie.decompose", "affine_lie.compose", "polar.decompose"


def _existence(maps: Maps, matrix: Array) -> float:
    rigid, shear, scale = ask_all(maps, DECOMPOSE, matrix)
    return rigid.affine.then(scale.whole, shear.whole).misfit(affine(matrix))


def _composition(maps: Maps, rigid: Array, shear: Array, scale: Array) -> float:
    parts = affine(rigid).then(precisely(scale.reshape(1, 1)), precisely(shear))
    return ask(maps, COMPOSE, rigid, shear, scale).affine.misfit(parts)


def _uniqueness(maps: Maps, rigid: Array, shear: Array, scale: Array) -> float:
    given = near_rigid(rigid)
    found = ask_all(maps, DECOMPOSE, ask(maps, COMPOSE, given, shear, scale))
    return max(
        found[0].affine.misfit(given.affine),
        *(found[1][name].misfit(precisely(shear[where])) for name, (where, _) in found[1].parts.items()),
        found[2].whole.misfit(precisely(scale.reshape(1, 1))),
    )


def _polar(maps: Maps, linear: Array) -> float:
    rotation, stretch = ask_all(maps, POLAR, linear)
    return (rotation.whole @ stretch.whole).misfit(precisely(linear))


LAWS = (
    Law(
        name="decomposition.existence",
        statement="T = A S E for the decomposition (E, A, s) of T",
        source="bansal_tatu, Theorem 1 (3)",
        domain="det T > 0",
        needs=(DECOMPOSE,),
        inputs=strategies.inputs(DECOMPOSE),
        residual=_existence,
    ),
    Law(
        name="decomposition.composition",
        statement="the composition of (E, A, s) is the matrix product A S E",
        source="bansal_tatu, section 3.1, equation 1",
        domain="every E, A and s",
        needs=(COMPOSE,),
        inputs=strategies.inputs(COMPOSE),
        residual=_composition,
    ),
    Law(
        name="decomposition.uniqueness",
        statement="the decomposition of A S E is (E, A, s)",
        source="bansal_tatu, Theorem 1 (3)",
        domain="every E, A and s",
        needs=(DECOMPOSE, COMPOSE),
        inputs=strategies.inputs(COMPOSE),
        residual=_uniqueness,
    ),
    Law(
        name="decomposition.polar",
        statement="L = R S for the polar factors R and S of L",
        source="kaji_ochiai, remark 3.1 and equation 3",
        domain="det L > 0, in the plane and in space",
        needs=(POLAR,),
        inputs=strategies.inputs(POLAR),
        residual=_polar,
    ),
)
