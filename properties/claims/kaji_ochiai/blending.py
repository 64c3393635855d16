"""Sections 5.1, 5.2 and 5.4: blends of maps, a deformer, and interpolation of poses."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_ochiai.parametrisation import affine_maps
from affinecert.properties.claims.kaji_ochiai.subspaces import members, outside
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.properties.laws.subclasses import SUBCLASSES, Subclass
from affinecert.reference import kaji_ochiai
from affinecert.reference._matrices import Array, Context, Number, array, identity
from affinecert.reference._natural_spline import natural_spline


def blend(m: Context, affines: Array, weights: Array) -> Array:
    """Equation 9."""
    parameters = array([kaji_ochiai.parametrise(m, affine) for affine in affines])
    return kaji_ochiai.realise(m, weights @ parameters)


def matrix_blend(m: Context, affines: Array, weights: Array) -> Array:
    """The weighted sum of matrices."""
    return np.asarray(sum(weight * affine for weight, affine in zip(weights, affines, strict=True)))


def _interpolation(first: int) -> Any:
    """Blend(1 - t, t; A1, A2) in equation 9; or with the weights exchanged."""

    def between(m: Context, affines: Array, t: Number) -> Array:
        weights = array([1 - t, t] if first == 0 else [t, 1 - t])
        return blend(m, affines, weights)

    return between


def _not_interpolating(between: Any, affines: Array) -> Number:
    ends = array([between(mp, affines, mp.zero), between(mp, affines, mp.one)])
    return difference(ends, affines)


def _pairs() -> list[Array]:
    maps = affine_maps()
    return [array(maps[k : k + 2]) for k in (0, 2, 5, 7)]


def _leaves(form: Any, case: tuple[Subclass, Array]) -> Number:
    subclass, weights = case
    return outside(form(mp, np.array(members(subclass, 2)), weights), subclass)


def _blends() -> list[tuple[Subclass, Array]]:
    weights = exactly([[0.5, 0.5], [1.5, 1], [-1, 2], [-3, 0.25]])
    return [(subclass, own) for subclass in SUBCLASSES for own in weights]


def _deformed(form: Any) -> Any:
    """Points moved by the blend of the probes with weights of their own."""

    def deform(points: Array, probes: Array, weights: Array) -> Array:
        moved = [form(mp, probes, own) @ array([*u, mp.one]) for u, own in zip(points, weights, strict=True)]
        return array(moved)[:, :3]

    return deform


def _does_not_follow(deform: Any, probes: Array) -> Number:
    """How far points of weight 1 for a probe are from moving with it, and those of weight 0 for all from resting."""
    points = arrays("points", 3, (3,), -2, 2)
    weights = exactly([[1, 0], [0, 1], [0, 0]])
    due = [(each @ array([*u, mp.one]))[:3] for each, u in zip((*probes, identity(mp, 4)), points, strict=True)]
    return difference(deform(array(points), probes, weights), array(due))


def _through_keys(kind: str) -> Any:
    """An interpolation of poses by a natural spline of the parameters; a Bézier curve; a spline of the matrices."""

    def curve(poses: Array, t: Number) -> Array:
        knots = array([mp.mpf(k) for k in range(len(poses))])
        if kind == "matrices":
            found: Array = natural_spline(knots, poses.reshape(len(poses), -1), t).reshape(4, 4)
            return found
        parameters = array([kaji_ochiai.parametrise(mp, pose) for pose in poses])
        if kind == "bezier":
            degree, s = len(poses) - 1, t / (len(poses) - 1)
            weights = [mp.binomial(degree, k) * s**k * (1 - s) ** (degree - k) for k in range(degree + 1)]
            return kaji_ochiai.realise(mp, array(weights) @ parameters)
        return kaji_ochiai.realise(mp, natural_spline(knots, parameters, t))

    return curve


def _missed(curve: Any, poses: Array) -> Number:
    return max(difference(curve(poses, mp.mpf(k)), pose) for k, pose in enumerate(poses))


def _curve_leaves(curve: Any, subclass: Subclass) -> Number:
    poses = array(members(subclass, 3))
    return max(outside(curve(poses, mp.mpf(t)), subclass) for t in (-0.5, 0.25, 1, 1.625, 2.5))


def _unsmooth(curve: Any, poses: Array) -> Number:
    """The jump of the curve's velocity at the second pose."""
    h = mp.mpf(10) ** -30
    with mp.workdps(160):
        one = mp.one
        ahead = (curve(poses, one + h) - curve(poses, one)) / h
        behind = (curve(poses, one) - curve(poses, one - h)) / h
        return max(size(ahead - behind) - mp.mpf(10) ** -25, mp.zero)


def _polygon(poses: Array, t: Number) -> Array:
    """Piecewise linear interpolation of the parameters."""
    k = min(max(int(mp.floor(t)), 0), len(poses) - 2)
    return blend(mp, poses[k : k + 2], array([1 - (t - k), t - k]))


def _keys() -> list[Array]:
    maps = affine_maps()
    return [array(maps[:3]), array(maps[4:8])]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.5.1.eq9.interpolation",
        place="section 5.1, equation 9",
        statement="With weights 1 - t and t a blend of two maps interpolates between them.",
        printed="Blend(w1, ..., wn, A1, ..., An) = φ(Σ w_i ψ(A_i))",
        verdict=Verdict.CONFIRMED,
        form=_interpolation(0),
        cases=_pairs,
        deviation=_not_interpolating,
        copies=(Copy("weights t and 1 - t", _interpolation(1)),),
    ),
    Claim(
        id="kaji_ochiai.5.1.class",
        place="section 5.1, after equation 9",
        statement="A blend of maps of one of the classes of section 3 is in the class, whatever the weights.",
        verdict=Verdict.CONFIRMED,
        form=blend,
        cases=_blends,
        deviation=_leaves,
        copies=(Copy("the weighted sum of matrices", matrix_blend),),
        remark="Weights need not have sum 1, nor be positive.",
    ),
    Claim(
        id="kaji_ochiai.5.2.deformer",
        place="section 5.2",
        statement="A point of weight 1 for one probe and 0 for others moves with it; one of weights 0 rests.",
        printed="u ↦ Blend(w1(u), ..., wn(u), A1, ..., An) u",
        verdict=Verdict.CONFIRMED,
        form=_deformed(blend),
        cases=_pairs,
        deviation=_does_not_follow,
        copies=(Copy("the weighted sum of matrices, which takes weights 0 to the origin", _deformed(matrix_blend)),),
    ),
    Claim(
        id="kaji_ochiai.5.4.through_keys",
        place="section 5.4",
        statement="An interpolation in the parameter space passes the given poses at its knots.",
        printed="A(t) = φ(Interpolate(t, {ψ(A_j)}))",
        verdict=Verdict.CONFIRMED,
        form=_through_keys("spline"),
        cases=_keys,
        deviation=_missed,
        copies=(Copy("a Bézier curve with the poses for control points", _through_keys("bezier")),),
        remark="Bézier and B-spline curves, named too, pass keys only if their control points are solved for.",
    ),
    Claim(
        id="kaji_ochiai.5.4.smooth",
        place="section 5.4",
        statement="Methods for Euclidean space keep their smoothness: a spline of parameters is a smooth motion.",
        printed="any ordinary interpolation method can be applied in the parameter space",
        verdict=Verdict.CONFIRMED,
        form=_through_keys("spline"),
        cases=_keys,
        deviation=_unsmooth,
        copies=(Copy("a polygon for the spline", _polygon),),
    ),
    Claim(
        id="kaji_ochiai.5.4.class",
        place="section 5.4",
        statement="The interpolation of poses of one of the classes is in the class at every time.",
        verdict=Verdict.CONFIRMED,
        form=_through_keys("spline"),
        cases=lambda: list(SUBCLASSES),
        deviation=_curve_leaves,
        copies=(Copy("the spline of the matrices", _through_keys("matrices")),),
    ),
)
