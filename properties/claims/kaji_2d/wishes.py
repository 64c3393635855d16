"""Section 3, the remark: what Alexa et al. wish of a local homotopy, and which homotopy grants it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import plane_rotation
from affinecert.properties.claims.kaji_2d.degeneration import Homotopy, stretched
from affinecert.properties.claims.kaji_2d.homotopies import exponential, polar, power
from affinecert.properties.claims.kaji_2d.plane import angle, determinant, zero_or_one
from affinecert.properties.claims.precision import HOLDS, exactly, mp
from affinecert.reference._matrices import Array, Number

Timing = Callable[[Array, Number], tuple[Number, Number]]
"""How far the rotation and the stretch of A are at the time t."""


def _not_reflected(homotopy: Homotopy, case: tuple[Array, Number]) -> int:
    return zero_or_one(determinant(homotopy(*case)) > -HOLDS)


def _times_beyond() -> list[tuple[Array, Number]]:
    """Maps, and times just after the first collapse."""
    values = (0.5, 1), (0.125, 2), (0.0625, 0.5), (0.25, 0.125)
    return [
        (stretched(mp.mpf(2), mp.mpf(a), mp.mpf(b)), 1 / (1 - mp.mpf(min(a, b))) + mp.mpf(1) / 64) for a, b in values
    ]


def _times_within() -> list[tuple[Array, Number]]:
    """Maps, some almost singular, and times between 0 and 1."""
    values = (0.5, 1), (2**-20, 1), (2**-10, 2**10), (3, 2**-30)
    return [(stretched(mp.mpf(2), mp.mpf(a), mp.mpf(b)), mp.mpf(t)) for a, b in values for t in (0, 0.5, 0.9375, 1)]


def _monotonic(homotopy: Homotopy, case: tuple[Number, Number]) -> int:
    """Whether the determinant does not turn between 0 and 1: its slopes there have no opposite signs."""
    a = stretched(mp.mpf(1), *case)
    first, last = (definitions.derivative(mp, lambda t: determinant(homotopy(a, t)), mp.mpf(end)) for end in (0, 1))
    return zero_or_one(first * last > -HOLDS)


def _values(*pairs: tuple[float, float]) -> list[tuple[Number, Number]]:
    return [(mp.mpf(first), mp.mpf(second)) for first, second in pairs]


def _of_area(a: Array, t: Number) -> Number:
    """The time when the determinant of A^E has made the part t of its way."""
    final = determinant(a)
    return mp.log(1 + t * (final - 1)) / mp.log(final)


def _timed(a: Array, rotation: Number, stretch: Number) -> Array:
    """The map R_θ^r S^s."""
    theta = angle(a)
    moved: Array = plane_rotation(rotation * theta) @ power(mp, plane_rotation(-theta) @ a, stretch)
    return moved


def _not_linear(timing: Timing, case: tuple[Array, Number]) -> Number:
    """How far angle and determinant are from changing linearly."""
    a, t = case
    moved = _timed(a, *timing(a, t))
    return max(abs(angle(moved) - t * angle(a)), abs(determinant(moved) - (1 + t * (determinant(a) - 1))))


def _maps_and_times() -> list[tuple[Array, Number]]:
    quarter = exactly([[0, -2], [2, 0]])
    values = (mp.mpf(1), 2, 1), (mp.mpf(2), 3, 0.5), (-mp.mpf(1), 0.5, 0.25)
    drawn = [stretched(theta, mp.mpf(a), mp.mpf(b)) for theta, a, b in values]
    return [(a, mp.mpf(t)) for a in (quarter, *drawn) for t in (0.5, 0.25)]


def _in_one_time(a: Array, t: Number) -> tuple[Number, Number]:
    return _of_area(a, t), _of_area(a, t)


def _in_two_times(a: Array, t: Number) -> tuple[Number, Number]:
    return t, _of_area(a, t)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.3.best_of_several",
        place="section 3, after equation 2",
        statement="A^P gives the visually best result of several methods (as [ACOL00] claims).",
        verdict=Verdict.UNCHECKABLE,
        reason="A judgement of looks; the pictures compared are in another paper.",
    ),
    Claim(
        id="kaji_2d.3.property_b_speed",
        place="section 3, remark, property (b)",
        statement="With the speed of t adjusted, A^E has angle and scale that change linearly.",
        printed="our method ... can easily achieve (b), by adjusting the speed of time parameter t",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_in_one_time,
        cases=_maps_and_times,
        deviation=_not_linear,
        correction=Correction(
            statement="Rotation and stretch need a time each: R_θ^t S^τ(t), τ = log(1 + t (det A - 1)) / log(det A), "
            "turns and changes its area linearly.",
            form=_in_two_times,
        ),
        copies=(
            Copy("the times exchanged", lambda a, t: (_of_area(a, t), t)),
            Copy("A^E itself: t for both", lambda a, t: (t, t)),
        ),
        remark="The angle of A^E is linear in t as it stands, and any other speed spoils it. Singular values are "
        "linear in A^P, both of them; no τ does that. (If a speed for each factor is meant, the claim stands.)",
    ),
    Claim(
        id="kaji_2d.3.property_b_monotonic",
        place="section 3, remark, property (b)",
        statement="The scale (area) of A^P does not even change monotonically from 0 to 1.",
        printed="As for (b), the scale change is not even monotonic.",
        verdict=Verdict.BOUND,
        domain="harmonic mean of the singular values < 1 < arithmetic mean; else it is monotonic between 0 and 1",
        form=polar,
        cases=lambda: _values((0.5, 2), (0.5, 1.53125), (0.75, 1.484375), (0.125, 5), (0.875, 1.140625)),
        outside=lambda: _values((0.5, 1.5), (0.75, 1.5), (2, 1), (0.5, 1), (2, 3), (0.5, 1.46875), (0.75, 1.515625)),
        deviation=_monotonic,
        copies=(Copy("A^E for A^P", exponential),),
        remark="If scale means the singular values, 1 - t + t λ, A^P changes it linearly, as Alexa et al. wish.",
    ),
    Claim(
        id="kaji_2d.3.property_c",
        place="section 3, remark, property (c)",
        statement="The method of Alexa et al. reflects triangles: it does not satisfy (c).",
        verdict=Verdict.BOUND,
        domain="extrapolation, t outside of [0, 1]; between source and target (1 - t) I + t S is positive definite",
        form=polar,
        cases=_times_beyond,
        outside=_times_within,
        deviation=_not_reflected,
        copies=(Copy("A^E for A^P", exponential),),
    ),
    Claim(
        id="kaji_2d.3.property_d",
        place="section 3, remark, property (d)",
        statement="Paths of vertices by A^E are simple in the sense of indicators like winding numbers.",
        verdict=Verdict.UNCHECKABLE,
        reason="The indicators are not given; they are left to a separate paper.",
    ),
)
"""The remark on (b), (c) and (d); (a) is with the symmetrised error."""
