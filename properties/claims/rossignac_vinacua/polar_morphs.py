"""Section 3.3.2: interpolations of the linear part by rotation and stretch."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import plane_rotation
from affinecert.properties.claims.precision import HOLDS, difference, distance, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.polar_factors import Angles, angles_and_stretches, conjugate, turned
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import (
    Morph,
    at,
    steady,
    unit,
    unsteadiness,
)
from affinecert.reference import morphs
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity


def _power(stretch: Array, t: Number) -> Array:
    return array([[stretch[0, 0] ** t, mp.zero], [mp.zero, stretch[1, 1] ** t]])


def _mixed(t: Number, matrix: Array) -> Array:
    found: Array = identity(mp, 2) * (1 - t) + matrix * t
    return found


def _arap(t: Number, alpha: Number, beta: Number, stretch: Array) -> Array:
    """R(t (alpha + beta)) ((1 - t) I + t B), B = R(-beta) Y R(beta)."""
    found: Array = plane_rotation(t * (alpha + beta)) @ _mixed(t, conjugate(beta, stretch))
    return found


def _arap_after(t: Number, alpha: Number, beta: Number, stretch: Array) -> Array:
    """((1 - t) I + t B) R(t (alpha + beta)), B = R(alpha) Y R(-alpha)."""
    found: Array = _mixed(t, conjugate(-alpha, stretch)) @ plane_rotation(t * (alpha + beta))
    return found


def _arap_joined(t: Number, alpha: Number, beta: Number, stretch: Array) -> Array:
    """(1 - t) R(t (alpha + beta)) + t R(t (alpha + beta)) B."""
    turn = plane_rotation(t * (alpha + beta))
    found: Array = turn * (1 - t) + turn @ conjugate(beta, stretch) * t
    return found


def _asap(t: Number, alpha: Number, beta: Number, stretch: Array) -> Array:
    """R(t (alpha + beta)) R(-beta) Y^t R(beta)."""
    return turned(t * (alpha + beta) - beta, beta, _power(stretch, t))


def _asap_after(t: Number, alpha: Number, beta: Number, stretch: Array) -> Array:
    """R(alpha) Y^t R(-alpha) R(t (alpha + beta))."""
    return turned(alpha, t * (alpha + beta) - alpha, _power(stretch, t))


def _asap_joined(t: Number, alpha: Number, beta: Number, stretch: Array) -> Array:
    """The same as `_asap`, L^0 being I: R(t alpha - (1 - t) beta) Y^t R(beta)."""
    return turned(t * alpha - (1 - t) * beta, beta, _power(stretch, t))


def _unlike(morph: Morph) -> Any:
    """How far a formula is from the linear part of a morph from B = I to L."""

    def deviation(form: Any, case: Angles) -> Number:
        pair = unit(2), homogeneous(mp, turned(*case), exactly([0, 0]))
        return max(distance(form(mp.mpf(t), *case), at(morph, pair, t)[:2, :2]) for t in (0.25, 0.5))

    return deviation


def _alike(form: tuple[Any, Any], case: Angles) -> Number:
    """Whether two ways from I to L have the same matrix half way, or one of them leads elsewhere."""
    halves = [each(mp.mpf(0.5), *case) for each in form]
    ends = [each(mp.mpf(k), *case) for each in form for k in (0, 1)]
    astray = max(difference(end, (identity(mp, 2), turned(*case))[k % 2]) for k, end in enumerate(ends)) > HOLDS
    return mp.mpf(astray or difference(*halves) < HOLDS)


def _is_steady(form: Any, case: Angles) -> Number:
    """Whether a way of linear maps is steady."""

    def morph(_: Context, _start: Array, _end: Array, t: Array) -> Array:
        return homogeneous(mp, form(t[()], *case), exactly([0, 0]))

    return mp.mpf(unsteadiness(morph, (unit(2), homogeneous(mp, turned(*case), exactly([0, 0])))) < HOLDS)


def _steady_linear(t: Number, *case: Any) -> Array:
    return at(steady, (unit(2), homogeneous(mp, turned(*case), exactly([0, 0]))), t)[:2, :2]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.3.3.2.arap",
        place="section 3.3.2",
        statement="The as-rigid-as-possible morph of L is a turn by t (α + β) after an even mixture of I and B.",
        printed="L(t) = R(t(α + β)) ∘ ((1-t)·I + t·B)",
        verdict=Verdict.CONFIRMED,
        form=_arap,
        cases=angles_and_stretches,
        deviation=_unlike(morphs.arap),
        copies=(Copy("the turn first", lambda t, a, b, y: _mixed(t, conjugate(b, y)) @ plane_rotation(t * (a + b))),),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.stretch_last",
        place="section 3.3.2",
        statement="L is B R(α + β) as well, with B = R(α) Y R(-α).",
        printed="L(t) = ((1-t)·I + t·B) ∘ R(t(α + β)), with B = R(α) ∘ Y ∘ R(-α)",
        verdict=Verdict.CONFIRMED,
        form=_arap_after,
        cases=angles_and_stretches,
        deviation=lambda form, case: distance(form(mp.one, *case), turned(*case)),
        copies=(
            Copy("R(-α) Y R(α) for B", lambda t, a, b, y: _mixed(t, conjugate(a, y)) @ plane_rotation(t * (a + b))),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.two_solutions",
        place="section 3.3.2",
        statement="With the stretch last or first the solution is another in general.",
        verdict=Verdict.CONFIRMED,
        form=(_arap, _arap_after),
        cases=angles_and_stretches,
        deviation=_alike,
        copies=(Copy("(1 - t) R(t(α + β)) + t R(t(α + β)) B for the stretch last", (_arap, _arap_joined)),),
        remark="It is another wherever L turns and stretches unevenly.",
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.more_rigid",
        place="section 3.3.2",
        statement="That there are two solutions suggests that neither is optimal, and that one is more rigid.",
        verdict=Verdict.UNCHECKABLE,
        reason="no measure of rigidity is defined by which one solution could be better than another",
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.asap",
        place="section 3.3.2",
        statement="The ASAP variation is R(t(α + β)) R(-β) Y^t R(β), the product of powers R^t S^t.",
        printed="L(t) = R(t(α + β)) ∘ R(-β) ∘ Y^t ∘ R(β)",
        verdict=Verdict.CONFIRMED,
        form=_asap,
        cases=angles_and_stretches,
        deviation=_unlike(morphs.asap),
        copies=(
            Copy("R(tβ) last", lambda t, a, b, y: turned(t * (a + b) - b, t * b, _power(y, t))),
            Copy("R(-β) left out", lambda t, a, b, y: turned(t * (a + b), b, _power(y, t))),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.asap_unsteady",
        place="section 3.3.2",
        statement="The ASAP variation is still not steady.",
        verdict=Verdict.CONFIRMED,
        form=_asap,
        cases=angles_and_stretches,
        deviation=_is_steady,
        copies=(Copy("L^t for R^t S^t", _steady_linear),),
        remark="Unless R and S commute.",
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.two_variations",
        place="section 3.3.2",
        statement="It differs from the equally valid variation R(α) Y^t R(-α) R(t(α + β)).",
        printed="L(t) = R(α) ∘ Y^t ∘ R(-α) ∘ X^t ∘ R(-α) ∘ X^t ∘ X R(t(α + β))",
        verdict=Verdict.CONFIRMED,
        form=(_asap, _asap_after),
        cases=angles_and_stretches,
        deviation=_alike,
        copies=(Copy("R(tα - (1 - t)β) Y^t R(β) for the variation", (_asap, _asap_joined)),),
        remark="The scan repeats parts of the formula, with an X that stands for nothing.",
    ),
)
