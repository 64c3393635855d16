"""Section 10, and section 5: the length of e^{(1-t)B_1 + tB_2} in SO(n), step by step."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.gallier.invertibility_of_v import NOTHING, blocks, turned
from affinecert.properties.claims.gallier.similarities import skew
from affinecert.properties.claims.precision import difference, distance, exactly, mp
from affinecert.reference import measures, so3
from affinecert.reference._matrices import Array, Number, cross_matrix, norm
from affinecert.reference._quadrature import gauss_legendre

Ends = tuple[Array, Array]
"""B_1 and B_2."""

Curve = Callable[[Array, Array, Number], Array]


def _line(ends: Ends, t: Number) -> Array:
    line: Array = (1 - t) * ends[0] + t * ends[1]
    return line


def _velocity(ends: Ends, t: Number) -> Array:
    """The derivative of e^{(1-t)B_1 + tB_2} at t, from the exponential of (C, D; 0, C), C the place and D the rate."""
    place, rate = _line(ends, t), ends[1] - ends[0]
    n = len(place)
    both = np.full((2 * n, 2 * n), mp.zero, dtype=object)
    both[:n, :n] = both[n:, n:] = place
    both[:n, n:] = rate
    velocity: Array = definitions.exponential(mp, both)[:n, n:]
    return velocity


def _size(matrix: Array) -> Number:
    """Sqrt(tr(B^T B) / 2)."""
    return mp.sqrt((matrix.T @ matrix).trace() / 2)


_ENDS = (((0, 0, 0), (1, 0, 0)), ((1, 0, 0), (0, 1, 0)), ((1, 0, 0), (1, 1, 1)))
"""Vectors of B_1 and B_2 for which the length is found."""


@cache
def _length(number: int) -> Number:
    """The length of a curve of `_ENDS` by its definition."""
    ends = _skew(*_ENDS[number])
    nodes = gauss_legendre(mp, 40, mp.zero, mp.one)
    return mp.fsum(w * _size(_velocity(ends, t)) for t, w in nodes)


def _skew(*vectors: Any) -> Ends:
    first, second = (cross_matrix(mp, exactly(list(vector))) for vector in vectors)
    return first, second


def _commuting() -> list[Ends]:
    """Pairs that commute, of R^3 and of R^4 about the same two planes."""
    one, two = mp.one, mp.mpf(2)
    planes = [turned(blocks(angles, 4)) for angles in ((one, two), (-two, mp.mpf(3)))]
    return [
        _skew([0, 0, 0], [1, 0, 0]),
        _skew([1, 0, 0], [-2, 0, 0]),
        _skew([1, 2, 2], [2, 4, 4]),
        (planes[0], planes[1]),
    ]


def _others() -> list[Ends]:
    """Pairs that do not commute, one of them nearly."""
    a, b = arrays("length", 2, (6,), -1, 1)
    return [_skew([1, 0, 0], [0, 1, 0]), _skew([1, 0, 0], [2, 0.001, 0]), (skew(a, 4), skew(b, 4))]


def _printed_velocity(factor: str) -> Any:
    """(B_2 - B_1) e^{(1-t)B_1 + tB_2}, or another vector in place of B_2 - B_1."""

    def printed(ends: Ends, t: Number) -> Array:
        rate = ends[1] - ends[0] if factor == "difference" else ends[1]
        velocity: Array = rate @ definitions.exponential(mp, _line(ends, t))
        return velocity

    return printed


def _velocity_misses(form: Any, ends: Ends) -> Number:
    return max(difference(form(ends, t), _velocity(ends, t)) for t in (mp.zero, mp.mpf(1) / 3))


def _norm_of_product(side: str) -> Any:
    """The lines from tr((D E)^T D E) / 2 to tr(D^T D) / 2, E the exponential, as sizes."""

    def printed(ends: Ends) -> tuple[Number, ...]:
        rate, place = ends[1] - ends[0], _line(ends, mp.mpf(1) / 3)
        forward, back = definitions.exponential(mp, place), definitions.exponential(mp, -place)
        if side == "twice":
            back = forward
        return (
            (forward.T @ rate.T @ rate @ forward).trace() / 2,
            (rate.T @ rate @ forward @ back).trace() / 2,
            (rate.T @ rate).trace() / 2,
            -(rate @ rate).trace() / 2,
        )

    return printed


def _norms_miss(form: Any, ends: Ends) -> Number:
    product = (ends[1] - ends[0]) @ definitions.exponential(mp, _line(ends, mp.mpf(1) / 3))
    return max(abs(each - _size(product) ** 2) for each in form(ends))


def _straight(ends: Ends) -> Number:
    """||B_2 - B_1|| = sqrt(-tr((B_2 - B_1)^2) / 2), as printed."""
    rate = ends[1] - ends[0]
    return mp.sqrt(-(rate @ rate).trace() / 2)


def _by_speed(ends: Ends) -> Number:
    """The integral of |dexp_c(b - a)| for space: of sqrt(|v|^2 - 2 c_4(|c|^2) |c x v|^2), c_4 Stumpff's function."""
    with mp.workdps(2 * mp.dps):
        return measures.rotation_curve_length(mp, *map(_vector, ends))[()]


def _vector(matrix: Array) -> Array:
    vector: Array = exactly([matrix[2, 1], matrix[0, 2], matrix[1, 0]])
    return vector


def _at_mid_speed(ends: Ends) -> Number:
    """The speed at t = 1/2, for the mean of all speeds."""
    return _size(_velocity(ends, mp.mpf(1) / 2))


def _length_misses(form: Any, case: tuple[Ends, int]) -> Number:
    ends, number = case
    return abs(form(ends) - _length(number)) / _length(number)


def _lengths() -> dict[str, Any]:
    found = {}
    for name, scale in (("", mp.one), ("3 ", mp.mpf(3)), ("2π ", 2 * mp.pi)):
        first, second = exactly([1, 0, 0]) * scale, exactly([0, 1, 0]) * scale
        found[f"{name}e1 to {name}e2: ||B_2 - B_1||"] = float(norm(mp, second - first))
        with mp.workdps(20):
            found[f"{name}e1 to {name}e2: length"] = float(measures.rotation_curve_length(mp, first, second)[()])
    return found


def _quotient(sign: int) -> Any:
    def printed(ends: Ends) -> Array:
        return definitions.exponential(mp, sign * (ends[1] - ends[0]))

    return printed


def _quotient_misses(form: Any, ends: Ends) -> Number:
    first, second = (definitions.exponential(mp, end) for end in ends)
    return distance(form(ends), first.T @ second)


def _unsteady(ends: Ends) -> Number:
    """How much the velocity in the body's axes, constant along a geodesic, changes along the curve."""
    rates = [
        definitions.exponential(mp, -_line(ends, t)) @ _velocity(ends, t) for t in (mp.zero, mp.mpf(1) / 4, mp.one)
    ]
    return max(difference(rate, rates[0]) for rate in rates[1:])


def _pairs() -> list[Ends]:
    return _commuting() + _others()


def _commute(ends: Ends) -> bool:
    return bool(difference(ends[0] @ ends[1], ends[1] @ ends[0]) < NOTHING)


def _geodesic_misses(form: Any, ends: Ends) -> int:
    """Whether it is told wrongly that the curve is a geodesic."""
    return int(form(ends) != (_unsteady(ends) < mp.mpf(10) ** -50))


def _logarithms_of_quotients() -> list[tuple[Array, Array, Array]]:
    """R_1, R_2 and a logarithm B of R_1^T R_2: the principal one, and others."""
    found = []
    for a, b, turns in (([1, 0, 0], [0, 1, 0], 0), ([1, 2, 2], [0, -1, 1], 0), ([1, 2, 0], [0, 1, 1], 1)):
        first, second = (so3.exp(mp, exactly(each)) for each in (a, b))
        w = so3.log(mp, first.T @ second)
        found.append((first, second, cross_matrix(mp, w * (1 + 2 * mp.pi * turns / norm(mp, w)))))
    return found


def _great_arc(side: str) -> Any:
    """R_1 e^{tB}, or e^{tB} R_1."""

    def printed(first: Array, matrix: Array, t: Number) -> Array:
        step = definitions.exponential(mp, t * matrix)
        pose: Array = first @ step if side == "right" else step @ first
        return pose

    return printed


def _not_arc(form: Curve, case: tuple[Array, Array, Array]) -> Number:
    """How far a curve is from passing from R_1 to R_2, and from a constant velocity in the axes of the body."""
    first, second, matrix = case
    quarter = mp.mpf(1) / 4
    times = (mp.zero, quarter, mp.one)
    poses = [form(first, matrix, t) for t in times]
    steps = [form(first, matrix, t).T @ form(first, matrix, t + quarter) for t in times]
    ends = difference(poses[0], first) + difference(poses[2], second)
    return ends + max(difference(step, steps[0]) for step in steps)


def _length_of_arc(half: int) -> Any:
    def printed(matrix: Array) -> Number:
        return mp.sqrt(-(matrix @ matrix).trace() / half)

    return printed


def _arc_misses(form: Any, case: tuple[Array, Array, Array]) -> Number:
    """How far a length is from the speed, which is constant, in the metric of the paper."""
    first, _, matrix = case
    arc = _great_arc("right")
    velocity = definitions.derivative(mp, lambda t: arc(first, matrix, t), mp.mpf(1) / 3)
    return abs(form(matrix) - _size(velocity))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.10.velocity",
        place="section 10, second line",
        statement="The derivative of e^{(1-t)B_1 + tB_2} is (B_2 - B_1) e^{(1-t)B_1 + tB_2}.",
        printed="(e^{(1-t)B_1 + tB_2})' = (B_2 - B_1) e^{(1-t)B_1 + tB_2}",
        verdict=Verdict.BOUND,
        domain="B_1 and B_2 commute. Otherwise it is dexp_C(B_2 - B_1) e^C, C = (1-t)B_1 + tB_2, with "
        "dexp_C(D) = D + [C, D]/2 + [C, [C, D]]/6 + ...",
        form=_printed_velocity("difference"),
        cases=_commuting,
        outside=_others,
        deviation=_velocity_misses,
        copies=(Copy("B_2 for B_2 - B_1", _printed_velocity("second")),),
        remark="This is where the length goes wrong; the lines that follow are right.",
    ),
    Claim(
        id="gallier.10.norm",
        place="section 10, third line to the last",
        statement="The size of (B_2 - B_1) e^C is that of B_2 - B_1, as e^C is a rotation.",
        printed="tr(e^{Cᵀ} Dᵀ D e^C)/2 = tr(Dᵀ D e^C e^{-C})/2 = tr(Dᵀ D)/2 = tr(-D²)/2",
        verdict=Verdict.CONFIRMED,
        form=_norm_of_product("once"),
        cases=_pairs,
        deviation=_norms_miss,
        copies=(Copy("e^C for e^{-C}", _norm_of_product("twice")),),
    ),
    Claim(
        id="gallier.10.length",
        place="section 10, and section 5",
        statement="The curve e^{(1-t)B_1 + tB_2} has the length ||B_2 - B_1||.",
        printed="L(γ) = (-(1/2) tr((B_2 - B_1)²))^{1/2}",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_straight,
        cases=lambda: [(_skew(*vectors), number) for number, vectors in enumerate(_ENDS)],
        deviation=_length_misses,
        correction=Correction(
            statement="The length is the integral of ||dexp_C(B_2 - B_1)||, C = (1-t)B_1 + tB_2 "
            "(measures.rotation_curve_length): ||B_2 - B_1|| at most, and equal to it if B_1 and B_2 commute.",
            form=_by_speed,
        ),
        copies=(Copy("the speed at t = 1/2", _at_mid_speed),),
        numbers=_lengths,
    ),
    Claim(
        id="gallier.10.commuting",
        place="section 10, after the length",
        statement="If B_1 and B_2 commute, R_1ᵀR_2 = e^{B_2 - B_1}.",
        printed="R_1ᵀ R_2 = (e^{B_1})ᵀ e^{B_2} = e^{-B_1} e^{B_2} = e^{B_2 - B_1}",
        verdict=Verdict.CONFIRMED,
        form=_quotient(1),
        cases=_commuting,
        deviation=_quotient_misses,
        copies=(Copy("e^{B_1 - B_2}", _quotient(-1)),),
    ),
    Claim(
        id="gallier.10.no_geodesic",
        place="section 10, after the length",
        statement="Unless B_1 and B_2 commute, e^{(1-t)B_1 + tB_2} is generally not a geodesic; if they do, it is one.",
        verdict=Verdict.CONFIRMED,
        form=_commute,
        cases=_pairs,
        deviation=_geodesic_misses,
        copies=(Copy("a geodesic always", lambda ends: True), Copy("never a geodesic", lambda ends: False)),
    ),
    Claim(
        id="gallier.10.geodesic",
        place="section 10, γ_g",
        statement="R_1 e^{tB} is a geodesic from R_1 to R_2, for any logarithm B of R_1ᵀR_2.",
        printed="γ_g(t) = R_1 e^{tB}, t ∈ [0, 1]",
        verdict=Verdict.CONFIRMED,
        form=_great_arc("right"),
        cases=_logarithms_of_quotients,
        deviation=_not_arc,
        copies=(Copy("e^{tB} R_1", _great_arc("left")),),
        remark="The shortest way if B is the principal logarithm.",
    ),
    Claim(
        id="gallier.10.length_of_geodesic",
        place="section 10, last line",
        statement="Its length is sqrt(-tr(B²)/2).",
        printed="L(γ_g) = (-(1/2) tr(B²))^{1/2}",
        verdict=Verdict.CONFIRMED,
        form=_length_of_arc(2),
        cases=_logarithms_of_quotients,
        deviation=_arc_misses,
        copies=(Copy("without 1/2", _length_of_arc(1)),),
    ),
)
