"""Conclusions: what the closed forms are said to be good for."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.definitions import determinant
from affinecert.properties.claims.precision import distance, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.plane_logarithm import logarithm
from affinecert.reference._matrices import Array, Context, Number, identity

_Closed = Callable[[Context, Array], Array]


def _printed(m: Context, linear: Array) -> Array:
    """G1 and G2 with the determinant, r and d_L = r^2 - det; θ in its quadrant, a_12 cancelled."""
    r = (linear[0, 0] + linear[1, 1]) / 2
    d = r * r - determinant(linear)
    if d < 0:
        ratio = m.atan2(m.sqrt(-d), r) / m.sqrt(-d)
    else:
        chi = r / m.sqrt(d)
        ratio = m.log((chi + 1) / (chi - 1)) / 2 / m.sqrt(d)
    return _joined(m, linear, m.log(determinant(linear)) / 2, ratio)


def _rearranged(m: Context, linear: Array) -> Array:
    """The same with d_L without cancelling, and log det by log1p next to the identity."""
    return _joined(m, linear, _half_log_det(m, linear), _ratio(m, linear))


def _without_log1p(m: Context, linear: Array) -> Array:
    return _joined(m, linear, m.log(determinant(linear)) / 2, _ratio(m, linear))


def _with_printed_d(m: Context, linear: Array) -> Array:
    r = (linear[0, 0] + linear[1, 1]) / 2
    d = r * r - determinant(linear)
    ratio = m.atan2(m.sqrt(-d), r) / m.sqrt(-d) if d < 0 else m.atanh(m.sqrt(d) / r) / m.sqrt(d)
    return _joined(m, linear, _half_log_det(m, linear), ratio)


def _half_log_det(m: Context, linear: Array) -> Number:
    (a, b), (c, d) = (linear - identity(m, 2)).tolist()
    excess = a + d + (a * d - b * c)
    rounded = 1 + excess
    # log1p after Kahan: that of mpmath.fp rounds 1 + x first.
    return (m.log(rounded) * excess / (rounded - 1) if rounded != 1 else excess) / 2


def _ratio(m: Context, linear: Array) -> Number:
    """Y / sqrt(d_L)."""
    r, z = (linear[0, 0] + linear[1, 1]) / 2, (linear[0, 0] - linear[1, 1]) / 2
    d = z * z + linear[0, 1] * linear[1, 0]
    if d == 0:
        return 1 / r
    return m.atan2(m.sqrt(-d), r) / m.sqrt(-d) if d < 0 else m.atanh(m.sqrt(d) / r) / m.sqrt(d)


def _joined(m: Context, linear: Array, x: Number, ratio: Number) -> Array:
    """Equations 13 to 19 for x and y / sqrt(d_L); (a_11 - a_22) / 2 stands for a_11 - r, which would cancel."""
    z = (linear[0, 0] - linear[1, 1]) / 2
    found: Array = linear * ratio
    found[0, 0], found[1, 1] = x + ratio * z, x - ratio * z
    return found


def _error(form: _Closed, rows: Any) -> Number:
    """The relative error in float64; 1 where the formula has no value."""
    truth = logarithm(mp, exactly(rows))
    try:
        return distance(exactly(form(mpmath.fp, exactly(rows, mpmath.fp))), truth)
    except ArithmeticError:
        return mp.one


def _shortcoming(form: _Closed, rows: Any) -> Number:
    """The error beyond 1e-8."""
    return max(_error(form, rows) - mp.mpf(10) ** -8, mp.zero)


def _errors() -> dict[str, float]:
    """The errors of the forms as printed and rearranged."""
    forms = {"printed": _printed, "rearranged": _rearranged}
    return {
        f"{name}, {rows}": float(_error(form, rows)) for rows in _ordinary_and_near() for name, form in forms.items()
    }


def _ordinary_and_near() -> list[Any]:
    """Well away from all cases; next to the identity; turning little; eigenvalues close, and equal."""
    return [
        [[3.0, 1.0], [1.0, 2.0]],
        [[1.0, -1.0], [2.0, 0.5]],
        [[2.0, 1.0], [1e-10, 2.0]],
        [[1.0 + 1e-9, -2e-9], [2e-9, 1.0 + 1e-9]],
        [[1.0 + 1e-11, 3e-12], [2e-12, 1.0 - 1e-12]],
        [[2.0, 1e-12], [-1e-12, 2.0]],
        [[2.0, 1.0], [0.0, 2.0]],
        [[-1.0, 1e-9], [-1e-9, -1.0]],
    ]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.conclusions.accuracy",
        place="conclusions",
        statement="The closed forms of EAR do away with the shortcomings in accuracy and stability of numeric ones: "
        "here, that in float64 eight digits are left.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_printed,
        cases=_ordinary_and_near,
        deviation=_shortcoming,
        correction=Correction(
            statement="With d_L = (a_11 - a_22)²/4 + a_12 a_21, atanh(s/r)/s or θ/s for y/s, and log1p for log det "
            "eight digits are left in all of these cases.",
            form=_rearranged,
        ),
        copies=(
            Copy("log(det L) / 2 next to the identity", _without_log1p),
            Copy("d_L = r² - det L", _with_printed_d),
        ),
        numbers=_errors,
        remark="Next to the identity and where eigenvalues meet, the closed forms as printed lose all digits: there "
        "square roots and a series in L - 1, as of numeric solutions, have no trouble.",
    ),
    Claim(
        id="rossignac_vinacua.conclusions.performance",
        place="conclusions",
        statement="The closed forms do away with the shortcomings in performance of numeric solutions.",
        verdict=Verdict.UNCHECKABLE,
        reason="a statement on running times; neither the program nor what it is compared to is given",
    ),
    Claim(
        id="rossignac_vinacua.conclusions.complexity",
        place="conclusions",
        statement="For SAMs derived entities such as envelopes of swept volumes have a lower algebraic complexity.",
        verdict=Verdict.UNCHECKABLE,
        reason="no measure of that complexity is given; that grazing points stay the same is checked with section 7.2",
    ),
)
