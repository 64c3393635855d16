"""The catalogue of affine interpolation by T = A S E: shear after uniform scale after rigid motion."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from affinecert.catalogue import affine_maps, shears, tetrahedra, turns
from affinecert.catalogue.parts import ENTRIES, LINEAR, LINEAR_BLOCKS, TIME, TRANSLATION, WHOLE
from affinecert.catalogue.shear import SHEAR, alpha_blocks
from affinecert.catalogue.shears import Shears
from affinecert.catalogue.times import about_time, timed
from affinecert.catalogue.turns import Turns
from affinecert.draw import Draw
from affinecert.map import Argument, Block, Group, Map, Point, Regime
from affinecert.reference import affine_lie as reference
from affinecert.sampling import homogeneous, scalar, vector

ROWS = tuple(Group((row, np.s_[:3])) for row in range(3))
"""The rows of the linear part, each perturbed as one vector: how they are scaled against each other costs nothing."""

AFFINE = Argument("affine", (4, 4), (*ROWS, Group(TRANSLATION, "entries")), "1, length")
SCALE = Argument("scale", (), (ENTRIES,), "1")

REPRESENTATION = (
    Block("rotation", 0, LINEAR),
    Block("translation", 0, TRANSLATION),
    *alpha_blocks(1),
    Block("scale", 2, WHOLE),
)
"""The blocks of (rigid, shear, scale)."""

VERTICES = (Block("vertices", 0, WHOLE),)


def _factors(
    turn_kind: Turns, shear_kind: Shears, scales: tuple[float, float], lengths: tuple[float, float]
) -> Callable[[Draw], Point]:
    """Inputs (rigid, shear, scale); scale and translation of size 10**e, e in ``scales`` and ``lengths``."""

    def build(draw: Draw) -> Point:
        turn, (shear, _) = turn_kind.build(draw), shears.matrix(shear_kind, draw)
        scale = draw.exponent(*scales)
        return Point((homogeneous(turn.matrix, vector(draw, *lengths)), shear, scalar(scale)), scale)

    return build


_any_factors = _factors(turns.GENERIC, shears.GENERIC, (-3, 3), (-3, 3))


def _no_factors(draw: Draw) -> Point:
    """Three factors, one of which lies outside its group."""
    rigid, shear, scale = _any_factors(draw).inputs
    wrong = draw.exponent(-8, 3)
    fault = draw.choice(("rigid", "shear", "scale"))
    if fault == "rigid":
        rigid[:3, :3] = turns.no_rotation(draw).matrix
    elif fault == "shear":
        shear[2, 2] = -wrong
    else:
        scale = scalar(draw.choice((-wrong, 0.0)))
    return Point((rigid, shear, scale), wrong)


def _triangles(regimes: Iterable[Regime]) -> tuple[Regime, ...]:
    """The regimes of tetrahedra without their last vertices."""

    def triangle(regime: Regime) -> Regime:
        def build(draw: Draw) -> Point:
            point = regime.build(draw)
            return Point(tuple(corners[:3] for corners in point.inputs), point.distance)

        return replace(regime, build=build)

    return tuple(triangle(regime) for regime in regimes)


def _fewer(regimes: Iterable[Regime], share: float) -> tuple[Regime, ...]:
    """The regimes with fewer cases, for a map whose truth is dear."""
    return tuple(replace(regime, share=share * regime.share) for regime in regimes)


def _vertices(name: str, count: int) -> Argument:
    """Vertices in space, one a row."""
    return Argument(name, (count, 3), (ENTRIES,), "length")


def _continued(function: Callable[..., Any]) -> Callable[..., Any]:
    """An interpolation continued through angle pi, near to the value ``base``."""
    return lambda ctx, base, *inputs: function(ctx, *inputs, near=base)


MAPS = (
    Map(
        name="affine_lie.decompose",
        definition="(E, A, s) with T = A S E: E rigid, A in G_A, S = s I",
        source="bansal_tatu, equation 1 and theorem 1 (3)",
        domain="linear part of positive determinant; last row 0 0 0 1",
        arguments=(AFFINE,),
        outputs=((4, 4), (3, 3), ()),
        blocks=REPRESENTATION,
        regimes=affine_maps.FACTORED,
        reference=reference.decompose,
        inverse="affine_lie.compose",
        cost=2.5,
    ),
    Map(
        name="affine_lie.compose",
        definition="T = A S E",
        source="bansal_tatu, equation 1",
        domain="E rigid to within 1e-6, A in G_A, s > 0",
        arguments=(
            Argument("rigid", (4, 4), (Group(LINEAR, "entries"), Group(TRANSLATION, "entries")), "1, length"),
            SHEAR,
            SCALE,
        ),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=(
            Regime("generic", _any_factors, "scale"),
            Regime("near-identity", _factors(turns.NEAR_IDENTITY, shears.NEAR_IDENTITY, (-1e-8, 0), (-16, 0)), "scale"),
            Regime("off-by-ulps", _factors(turns.OFF_BY_ULPS, shears.GENERIC, (-3, 3), (-3, 3)), "scale"),
            Regime("huge-or-tiny", _factors(turns.GENERIC, shears.GENERIC, (-150, 150), (-100, 100)), "scale"),
            Regime("tiny-next-to-huge", _factors(turns.TINY, shears.TINY_NEXT_TO_HUGE, (-3, 3), (-100, 100)), "scale"),
            Regime("outside", _no_factors, "size of what is wrong", share=0.5),
        ),
        reference=reference.compose,
        inverse="affine_lie.decompose",
        cost=2.5,
    ),
    Map(
        name="affine_lie.interpolate",
        definition="T_t = exp(t log A) exp(t log S) exp(t log E), where T = A S E",
        source="bansal_tatu, equation 2",
        domain="T as for affine_lie.decompose, every t",
        arguments=(AFFINE, TIME),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=(*timed(affine_maps.INTERPOLATED), *about_time(affine_maps.GENERIC)),
        reference=reference.interpolate,
        continuation=_continued(reference.interpolate),
        cost=8.0,
    ),
    Map(
        name="affine_lie.represent",
        definition="(E, A, s) of a tetrahedron p against a canonical one c: E = E_p, A = A_c^-1 A_p, s = s_p / s_c",
        source="bansal_tatu, section 3.3, section 5.1 and equation 7",
        domain="both tetrahedra of positive volume, (u1 - u0, u2 - u0, u3 - u0) right-handed",
        arguments=(_vertices("tetrahedron", 4), _vertices("canonical", 4)),
        outputs=((4, 4), (3, 3), ()),
        blocks=REPRESENTATION,
        regimes=(
            tetrahedra.GENERIC,
            tetrahedra.AGAINST_STANDARD,
            tetrahedra.IDENTITY,
            tetrahedra.THIN,
            tetrahedra.FAR,
            tetrahedra.HUGE_AND_TINY,
            tetrahedra.OUTSIDE,
            tetrahedra.MIRRORED,
        ),
        reference=reference.represent,
        cost=5.0,
    ),
    Map(
        name="affine_lie.interpolate_tetrahedra",
        definition="the tetrahedron of p exp(t log(p^-1 q)), where p, q = (E, A, s) represent source and target",
        source="bansal_tatu, equation 4",
        domain="both tetrahedra of positive volume, right-handed; every t",
        arguments=(_vertices("source", 4), _vertices("target", 4), TIME),
        outputs=((4, 3),),
        blocks=VERTICES,
        regimes=(*timed((*tetrahedra.ALL, tetrahedra.MIRRORED)), *about_time(tetrahedra.GENERIC)),
        reference=reference.interpolate_tetrahedra,
        continuation=_continued(reference.interpolate_tetrahedra),
        cost=14.0,
    ),
    Map(
        name="affine_lie.interpolate_triangles",
        definition="as affine_lie.interpolate_tetrahedra, with the normal for third edge",
        source="bansal_tatu, equation 4 and section 6.1",
        domain="both triangles of positive area; every t",
        arguments=(_vertices("source", 3), _vertices("target", 3), TIME),
        outputs=((3, 3),),
        blocks=VERTICES,
        regimes=(*timed(_triangles(tetrahedra.ALL)), *about_time(_triangles((tetrahedra.GENERIC,))[0])),
        reference=reference.interpolate_triangles,
        continuation=_continued(reference.interpolate_triangles),
        cost=11.0,
    ),
    Map(
        name="affine_lie.interpolate_orderings",
        definition="affine_lie.interpolate_tetrahedra for each of the 12 even orderings of the vertices",
        source="bansal_tatu, section 5.2",
        domain="as for affine_lie.interpolate_tetrahedra",
        arguments=(_vertices("source", 4), _vertices("target", 4), TIME),
        outputs=((12, 4, 3),),
        blocks=VERTICES,
        regimes=_fewer(
            (
                *timed(
                    (
                        tetrahedra.GENERIC,
                        tetrahedra.RIGID,
                        tetrahedra.NEAR_IDENTITY,
                        tetrahedra.THIN,
                        tetrahedra.FAR,
                        tetrahedra.OUTSIDE,
                    )
                ),
                *about_time(tetrahedra.GENERIC),
            ),
            share=0.125,
        ),
        reference=reference.interpolate_orderings,
        continuation=_continued(reference.interpolate_orderings),
        cost=160.0,
    ),
)
