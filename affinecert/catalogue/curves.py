"""The catalogue of curves through many poses, and of the curves and patterns that steady affine morphs cascade to.

A regime of the plane has a name that ends in -2d, one of space in -3d, where a map takes both. Truths of whole curves
are dear: they have few keys, and most regimes are of the plane and short.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from affinecert.catalogue import keys, spectra, steps
from affinecert.catalogue.knots import AT_KEYS, EXTRAPOLATION, INSIDE, NEAR_KEYS, Times, timed
from affinecert.catalogue.parts import ENTRIES, LINEAR, LINEAR_BLOCKS, NORM, TIME, TRANSLATION, WHOLE
from affinecert.catalogue.spectra import Spectrum
from affinecert.catalogue.steps import Steps
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Group, Map, Point, Regime
from affinecert.reference import curves as reference
from affinecert.sampling import homogeneous, vector

UPPER = np.s_[..., [0, 1, 0, 1, 2], [1, 1, 2, 2, 2]]
"""Where shears keep alpha_1, ..., alpha_5."""

EACH = Group(np.s_[..., :-1, :-1]), Group(np.s_[..., :-1, -1])
"""The linear parts of several poses, perturbed as one vector, and their translations."""

POSES = Argument("poses", ("keys", "n", "n"), EACH, "1, length")

WIDE = "Computed in double-double arithmetic and rounded once: no scaled error above 0.5 was met."

BY_NORM = (
    f"The condition is taken by norm: of all linear parts of an argument together, and of all its translations. {WIDE}"
)

UNIT = (0.0, 1.0)
"""The knots of a curve from 0 to 1."""

Join = Callable[[list[Array]], tuple[Array, ...]]
"""Makes the inputs of a map of a list of poses."""


def _stacked(poses: list[Array]) -> tuple[Array, ...]:
    return (np.stack(poses),)


def _sequence(kind: Steps, size: int, count: int, join: Join, share: float) -> Regime:
    """A regime of so many poses in steps of a kind."""

    def build(draw: Draw) -> Point:
        placed, distance = steps.poses(draw, kind, size, count)
        return Point(join(placed), distance)

    return Regime(f"{kind.name}-{size}d", build, kind.distance, share)


def _outside(size: int, count: int, join: Join, share: float) -> Regime:
    def build(draw: Draw) -> Point:
        inputs = join(steps.poses(draw, steps.GENERIC, size, count)[0])
        views = [pose for array in inputs for pose in array.reshape(-1, size + 1, size + 1)]
        return Point(inputs, steps.spoilt(draw, views))

    return Regime(f"outside-{size}d", build, "size of what is wrong", share)


def _through(knots: Sequence[float], times: Sequence[Times], regime: Regime) -> tuple[Regime, ...]:
    """The regime at each of those times."""
    return tuple(timed(regime, each, knots) for each in times)


def _fewer(regimes: Sequence[Regime], share: float) -> tuple[Regime, ...]:
    """The regimes with fewer cases, for a map whose truth is dear."""
    return tuple(replace(regime, share=share * regime.share) for regime in regimes)


def _group_curve(regimes: Sequence[Regime], count: int, share: float) -> tuple[Regime, ...]:
    """Regimes of keys in a group, between the keys; and for the first of them about the keys."""
    knots = [float(key) for key in range(count)]
    inside = [timed(regime, INSIDE, knots) for regime in regimes]
    return _fewer((*inside, *_through(knots, (AT_KEYS, NEAR_KEYS, EXTRAPOLATION), regimes[0])), share)


PLANE, BOTH = (2,), (2, 3)

DEAR = 0.4
"""The share of a regime in space, whose truth takes three times as long, next to one in the plane."""


def _steady(kinds: Sequence[tuple[Steps, tuple[int, ...]]], count: int, join: Join, share: float) -> list[Regime]:
    """Regimes of so many poses in steps of each kind, in the plane, in space or both; the last one is outside."""
    chosen = [(kind, size, share if size == 2 else DEAR * share) for kind, sizes in kinds for size in sizes]
    within = [_sequence(kind, size, count, join, part) for kind, size, part in chosen]
    return [
        *within,
        _sequence(steps.NO_LOGARITHM, 2, count, join, share / 2),
        _outside(2, count, join, share / 2),
        _outside(3, count, join, share / 4),
    ]


def _between(
    kinds: Sequence[tuple[Steps, tuple[int, ...]]],
    count: int,
    join: Join,
    knots: Sequence[float],
    share: float,
) -> tuple[Regime, ...]:
    """Regimes as of `_steady`, with a time; and those about the knots.

    The first step is the one without a logarithm, so that its regime has times in the first segment.
    """
    inside = [
        timed(regime, INSIDE, knots[:2] if regime.name.startswith("no-logarithm") else knots)
        for regime in _steady(kinds, count, join, share)
    ]
    generic, gentle = (_sequence(kind, 2, count, join, share) for kind in (steps.GENERIC, steps.GENTLE))
    return (*inside, *_through(knots, (AT_KEYS, NEAR_KEYS), generic), timed(gentle, EXTRAPOLATION, knots))


def _pose(name: str) -> Argument:
    """A pose; a perturbation moves its linear part as a whole, and its translation."""
    return Argument(name, ("n", "n"), (Group(LINEAR), Group(TRANSLATION)), "1, length")


POSE_A, POSE_B, POSE_C, POSE_D = (_pose(f"pose_{letter}") for letter in "abcd")

ARCS = (
    (steps.GENERIC, BOTH),
    (steps.NEAR_IDENTITY, PLANE),
    (steps.REGULAR, BOTH),
    (steps.COALESCING, PLANE),
    (steps.NEAR_PI, PLANE),
    (steps.BORDER, PLANE),
)
"""What steady morphs in a row are tried on."""

CASCADES = tuple((kind, PLANE if kind is steps.REGULAR else sizes) for kind, sizes in ARCS)
"""What cascades of them are tried on."""


def _corners(placed: list[Array]) -> tuple[Array, ...]:
    """The poses P, Q, R, S as the corners A, B, C, D with B = Q, C = (R Q^-1) A and D = (S R^-1) C for A = P."""
    start, first, second, third = placed
    across, along = second @ np.linalg.inv(first), third @ np.linalg.inv(second)
    corners = [start, first, across @ start, along @ across @ start]
    for corner in corners:
        corner[-1] = start[-1]
    return tuple(corners)


def _patches(share: float) -> tuple[Regime, ...]:
    """Regimes of the corners of a patch, whose sides are steps of a kind, and of two parameters."""
    gentle = replace(steps.GENTLE, name="generic")
    others = (steps.NEAR_IDENTITY, steps.REGULAR, steps.COALESCING, steps.NEAR_PI)
    placed = _steady(((gentle, BOTH), *((kind, PLANE) for kind in others)), 4, _corners, share)
    return (
        *(timed(timed(regime, INSIDE, UNIT), INSIDE, UNIT) for regime in placed),
        timed(timed(placed[0], INSIDE, UNIT), AT_KEYS, UNIT),
        timed(timed(placed[0], EXTRAPOLATION, UNIT), NEAR_KEYS, UNIT),
    )


def _oblique_direction(draw: Draw, size: int) -> Array:
    """A unit vector without a component that is zero, (size,)."""
    angle, height = draw.uniform(0.1, 6.3), draw.uniform(-1.5, 1.4)
    plane = np.array([math.cos(angle), math.sin(angle)])
    return plane if size == 2 else np.array([*(math.cos(height) * plane), math.sin(height)])


def _grazing(kinds: Sequence[Spectrum], share: float) -> tuple[Regime, ...]:
    """Regimes of a motion of some spectrum, a point, a tangent and a normal, in the plane and in space."""

    def regime(kind: Spectrum, size: int) -> Regime:
        def build(draw: Draw) -> Point:
            linear, distance = kind.build(draw, size)
            line = vector(draw, size=size), _oblique_direction(draw, size), _oblique_direction(draw, size)
            return Point((homogeneous(linear, vector(draw, size=size)), *line), distance)

        return Regime(f"{kind.name}-{size}d", build, kind.distance, share * kind.share)

    return tuple(regime(kind, size) for kind in kinds for size in (2, 3))


def _radial(draw: Draw) -> Point:
    """A scaling about a point, whose velocity across the normal is the same all along a tangent."""
    scale, (x, y) = draw.exponent(-3, 3) + 1.0, _oblique_direction(draw, 2)
    affine = homogeneous(scale * np.eye(2), vector(draw, size=2))
    return Point((affine, vector(draw, size=2), np.array([x, y]), np.array([-y, x])), scale - 1.0)


MAPS = (
    Map(
        name="curves.shear_curve",
        definition="A_i exp(s B_i) exp(s^2 C_i), s = t - i, with C_i = log(exp(-B_i) A_i^-1 A_(i+1)), "
        "B_0 = log(A_0^-1 A_1) and B_(i+1) = exp(-C_i) B_i exp(C_i) + 2 C_i",
        source="bansal_tatu, section 4.1, equations 5 and 6 (Li and Hao 2006)",
        domain="at least two keys, all in G_A; every t",
        arguments=(Argument("shears", ("keys", 3, 3), (Group(UPPER),), "1"), TIME),
        outputs=((3, 3),),
        blocks=(Block("shear", 0, UPPER),),
        regimes=_group_curve(keys.shear_curves(4), 4, share=0.35),
        reference=reference.shear_curve,
        cost=15.0,
        remark="The condition is taken by norm, of the entries of all keys together. " + WIDE,
    ),
    Map(
        name="curves.scale_curve",
        definition="curves.shear_curve for scales: the exponential of the quadratic spline of their logarithms",
        source="bansal_tatu, section 4.1, equations 5 and 6 (Li and Hao 2006)",
        domain="at least two keys, all positive; every t",
        arguments=(Argument("scales", ("keys",), (ENTRIES,), "1"), TIME),
        outputs=((),),
        blocks=(Block("scale", 0, WHOLE),),
        regimes=_group_curve(keys.scale_curves(4), 4, share=1.0),
        reference=reference.scale_curve,
        cost=2.0,
        remark=WIDE,
    ),
    Map(
        name="curves.rigid_curve",
        definition="curves.shear_curve for rigid motions; logarithms as se3.log",
        source="bansal_tatu, section 4.1, equations 5 and 6 (Li and Hao 2006)",
        domain="at least two keys, each within 1e-6 of SO(3), the nearest rotation counts; last rows 0 0 0 1; every t",
        arguments=(Argument("poses", ("keys", 4, 4), EACH, "1, length", manifold="rotations"), TIME),
        outputs=((4, 4),),
        blocks=(Block("rotation", 0, LINEAR), Block("translation", 0, TRANSLATION)),
        regimes=_group_curve(keys.rigid_curves(3), 3, share=0.15),
        reference=reference.rigid_curve,
        cost=40.0,
        remark=BY_NORM,
    ),
    Map(
        name="curves.affine_curve",
        definition="N^A(t) N^S(t) N^E(t): the product of the curves through the factors of T_i = A_i S_i E_i",
        source="bansal_tatu, section 4.1, which prints the factors in the opposite order",
        domain="at least two keys, linear parts of positive determinant; last rows 0 0 0 1; every t",
        arguments=(Argument("affines", ("keys", 4, 4), EACH, "1, length"), TIME),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=_group_curve(keys.affine_curves(3), 3, share=0.15),
        reference=reference.affine_curve,
        cost=50.0,
        remark=BY_NORM,
    ),
    Map(
        name="curves.subdivided_curve",
        definition="curves.affine_curve at 2 t, through the keys and between them A_i exp(log(A_i^-1 A_(i+1)) / 2)",
        source="bansal_tatu, sections 4.1 and 6.3, figure 8",
        domain="as curves.affine_curve",
        arguments=(Argument("affines", ("keys", 4, 4), EACH, "1, length"), TIME),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=_group_curve(keys.affine_curves(3), 3, share=0.1),
        reference=reference.subdivided_curve,
        cost=80.0,
        remark=BY_NORM,
    ),
    Map(
        name="curves.poly_sam",
        definition="sam.morph from pose i to pose i + 1 at the time t - i, i = floor(t) kept within 0 and keys - 2",
        source="rossignac_vinacua, section 5.3",
        domain="at least two keys, det > 0; last rows 0 ... 0 1; the morph that holds t as for sam.morph; every t",
        arguments=(POSES, TIME),
        outputs=(("n", "n"),),
        blocks=LINEAR_BLOCKS,
        regimes=_between((*ARCS, (steps.TRANSLATIONS, PLANE)), 3, _stacked, (0.0, 1.0, 2.0), share=0.4),
        reference=reference.poly_sam,
        cost=8.0,
        remark=BY_NORM,
    ),
    Map(
        name="curves.bezier_quadratic",
        definition="SAM(SAM(A, t, B), t, SAM(B, t, C)), SAM(B, t, C) being sam.morph",
        source="rossignac_vinacua, section 5.3",
        domain="det > 0; last rows 0 ... 0 1; sam.exists for each morph, the inner one without a half turn; every t",
        arguments=(POSE_A, POSE_B, POSE_C, TIME),
        outputs=(("n", "n"),),
        blocks=LINEAR_BLOCKS,
        regimes=_between(CASCADES, 3, tuple, UNIT, share=0.2),
        reference=reference.bezier_quadratic,
        cost=24.0,
        remark=WIDE,
    ),
    Map(
        name="curves.bezier_cubic",
        definition="SAM(bezier_quadratic(A, B, C, t), t, bezier_quadratic(B, C, D, t))",
        source="rossignac_vinacua, section 7.3",
        domain="as curves.bezier_quadratic",
        arguments=(POSE_A, POSE_B, POSE_C, POSE_D, TIME),
        outputs=(("n", "n"),),
        blocks=LINEAR_BLOCKS,
        regimes=_between(CASCADES, 4, tuple, UNIT, share=0.15),
        reference=reference.bezier_cubic,
        cost=45.0,
        remark=WIDE,
    ),
    Map(
        name="curves.biarc",
        definition="bezier_quadratic(A, L, B, 2 t), from t = 1/2 on bezier_quadratic(B, R, C, 2 t - 1), where "
        "B L^-1 = R B^-1 = (B A^-1)^(1/4) (C B^-1)^(1/4)",
        source="rossignac_vinacua, section 5.3",
        domain="as curves.bezier_quadratic",
        arguments=(POSE_A, POSE_B, POSE_C, TIME),
        outputs=(("n", "n"),),
        blocks=LINEAR_BLOCKS,
        regimes=_between(CASCADES, 3, tuple, (0.0, 0.5, 1.0), share=0.2),
        reference=reference.biarc,
        cost=40.0,
        remark=WIDE,
    ),
    Map(
        name="curves.four_point",
        definition="the poses, and between them means of the predictions left(A, B, C) = (B C^-1)^(1/8) SAM(A, 5/8, B)",
        source="rossignac_vinacua, section 7.3",
        domain="at least three keys; else as curves.bezier_quadratic",
        arguments=(POSES,),
        outputs=(("2keys-1", "n", "n"),),
        blocks=(
            Block("keys", 0, np.s_[::2, :-1]),
            Block("linear", 0, np.s_[1::2, :-1, :-1]),
            Block("translation", 0, np.s_[1::2, :-1, -1]),
        ),
        regimes=tuple(_steady(CASCADES, 4, _stacked, share=0.15)),
        reference=reference.four_point,
        cost=70.0,
        remark=BY_NORM,
    ),
    Map(
        name="curves.patch",
        definition="SAM(SAM(A, s, B), t, SAM(C, s, D))",
        source="rossignac_vinacua, section 7.3, figure 11",
        domain="as curves.bezier_quadratic; every s and t",
        arguments=(POSE_A, POSE_B, POSE_C, POSE_D, Argument("s", (), (ENTRIES,), "1"), TIME),
        outputs=(("n", "n"),),
        blocks=LINEAR_BLOCKS,
        regimes=_patches(share=0.25),
        reference=reference.patch,
        cost=24.0,
        remark=WIDE,
    ),
    Map(
        name="curves.regular_pattern",
        definition=f"(C B^-1)^(k/{reference.COPIES}) B for k = 0, ..., {reference.COPIES}",
        source="rossignac_vinacua, section 7.1",
        domain="as sam.morph",
        arguments=(_pose("start"), _pose("end")),
        outputs=((reference.COPIES + 1, "n", "n"),),
        blocks=(Block("linear", 0, np.s_[:, :-1, :-1]), Block("translation", 0, np.s_[:, :-1, -1])),
        regimes=tuple(_steady((*ARCS, (steps.TRANSLATIONS, PLANE)), 2, tuple, share=0.5)),
        reference=reference.regular_pattern,
        cost=11.0,
        remark=WIDE,
    ),
    Map(
        name="curves.grazing_parameter",
        definition="s = -n . (log(L) q + v) / n . log(L) t, where [[log L, v], [0, 0]] is sam.log: the velocity at "
        "q + s t is orthogonal to n",
        source="rossignac_vinacua, equation 8, which prints no sign and takes the origin to be fixed",
        domain="A as for sam.log; n . log(L) t not zero",
        arguments=(
            _pose("affine"),
            Argument("point", ("n-1",), (NORM,), "length"),
            Argument("tangent", ("n-1",), (NORM,), "length"),
            Argument("normal", ("n-1",), (NORM,), "1"),
        ),
        outputs=((),),
        blocks=(Block("parameter", 0, WHOLE),),
        regimes=(
            *_grazing(
                (
                    spectra.GENERIC,
                    spectra.NEAR_IDENTITY,
                    spectra.COALESCING,
                    spectra.ROUNDED_DEFECTIVE,
                    spectra.BOUNDARY,
                    spectra.NO_LOGARITHM,
                ),
                share=0.4,
            ),
            Regime("outside-2d", _radial, "|scale - 1|", share=0.25),
            *_grazing((spectra.NOT_ORIENTED,), share=0.5)[1:],
        ),
        reference=reference.grazing_parameter,
        cost=10.0,
        remark=WIDE,
    ),
)
