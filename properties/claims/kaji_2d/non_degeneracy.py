"""Section 3: the determinant of A^E, which is positive and monotonic."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays, numbers
from affinecert.properties.claims.kaji_2d.degeneration import TIMES, Homotopy, stretched
from affinecert.properties.claims.kaji_2d.homotopies import exponential, linear, polar
from affinecert.properties.claims.kaji_2d.plane import (
    built,
    determinant,
    edges,
    growths,
    maps,
    zero_or_one,
)
from affinecert.properties.claims.precision import HOLDS, equals, exactly, mp
from affinecert.reference import homotopy2
from affinecert.reference._matrices import Array, Context, Number, scalar


def _stays(homotopy: Homotopy, a: Array) -> int:
    """Whether it has no positive determinant at some time."""
    return zero_or_one(any(determinant(homotopy(a, t)) <= 0 for t in (*TIMES, mp.mpf(-40), mp.mpf(40))))


def _factors_and_times() -> list[tuple[Number, Array, Number]]:
    stretches = [exactly([[1, 0], [0, 0]]), exactly([[0, 1], [1, 0]]), *growths("log S, determinant", 6)]
    drawn = (numbers(name, len(stretches), low, 3) for name, low in (("angles", -3), ("times", -2)))
    return [(theta, growth, t) for growth, theta, t in zip(stretches, *drawn, strict=True)]


def _of_exponential(m: Context, theta: Number, growth: Array, t: Number) -> Number:
    return determinant(homotopy2.exponential(m, built(theta, growth), scalar(t)))


def _exponential_of_trace(number: Any) -> Any:
    return lambda m, theta, growth, t: m.exp(number(t * growth))


def _squares() -> list[tuple[Array]]:
    simple = [exactly(each) for each in ([[2]], [[0, -1], [1, 0]], [[1, 1], [0, 1]])]
    return [(each,) for each in (*simple, *(arrays("B", 1, (n, n), -1, 1)[0] for n in (2, 3, 4)))]


def _slope(m: Context, first: Number, second: Number, t: Number) -> Number:
    product = first * second
    return m.log(product) * m.exp(t * m.log(product))


def _slope_with(product: Any) -> Any:
    return lambda m, first, second, t: product(m, first, second) * m.exp(t * m.log(first * second))


def _true_slope(m: Context, first: Number, second: Number, t: Number) -> Number:
    a = stretched(mp.mpf(1), first, second)
    return definitions.derivative(m, lambda s: determinant(homotopy2.exponential(m, a, scalar(s))), t)


def _values_and_times() -> list[tuple[Number, Number, Number]]:
    simple = [(2, 1, 0.5), (0.5, 1, 0.5), (2, 3, 0), (4, 0.5, 1), (3, 0.25, -1)]
    return [(mp.mpf(a), mp.mpf(b), mp.mpf(t)) for a, b, t in simple]


def _not_monotonic(homotopy: Homotopy, a: Array) -> Number:
    """The change of the determinant where it is to be constant; whether it turns back, where det A is not 1."""
    found = [determinant(homotopy(a, t)) for t in TIMES[::4]]
    if abs(determinant(a) - 1) < HOLDS:
        return max(found) - min(found)
    direction = mp.sign(determinant(a) - 1)
    return zero_or_one(any((after - before) * direction <= 0 for before, after in pairwise(found)))


def _area_not_monotonic(homotopy: Homotopy, case: tuple[Array, Array]) -> Number:
    """The same of the area of a triangle that the homotopy moves, relative to its area before."""
    a, triangle = case
    area = determinant(edges(triangle))
    return _not_monotonic(lambda a, t: edges((homotopy(a, t) @ triangle.T).T) / mp.sqrt(abs(area)), a)


def _monotonic_cases() -> list[Array]:
    values = [(2, 1), (0.5, 0.25), (2, 0.75), (0.5, 1.75), (2, 0.5), (1, 1)]
    return [stretched(mp.mpf(1), mp.mpf(first), mp.mpf(second)) for first, second in values]


def _triangles() -> list[tuple[Array, Array]]:
    triangle = exactly([[1, 0], [3, 1], [0, 2]])
    return [(a, triangle) for a in _monotonic_cases()]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.3.determinant_exponential",
        place="section 3, before det A^E",
        statement="The determinant of the exponential of any matrix is the exponential of its trace.",
        printed="det(exp(B)) = exp(tr(B)) > 0",
        verdict=Verdict.CONFIRMED,
        form=lambda m, b: m.exp(b.trace()),
        cases=_squares,
        deviation=equals(lambda m, b: definitions.determinant(definitions.exponential(m, b))),
        copies=(
            Copy("the determinant of B for its trace", lambda m, b: m.exp(definitions.determinant(b))),
            Copy("the trace divided by the size", lambda m, b: m.exp(b.trace() / len(b))),
        ),
    ),
    Claim(
        id="kaji_2d.3.determinant_A_E",
        place="section 3, det A^E",
        statement="The determinant of A^E is the exponential of t tr(log S).",
        printed="det A^E(t) = det(R_θ^t) det(S^t) = exp(tr(t log S))",
        verdict=Verdict.CONFIRMED,
        form=_exponential_of_trace(lambda growth: growth.trace()),
        cases=_factors_and_times,
        deviation=equals(_of_exponential),
        copies=(
            Copy("the determinant for the trace", _exponential_of_trace(determinant)),
            Copy("-t for t", _exponential_of_trace(lambda growth: -growth.trace())),
        ),
        remark="It is (det A)^t: no polar factor is needed.",
    ),
    Claim(
        id="kaji_2d.3.non_degenerate",
        place="section 3, before and after equation 3; remark, property (c)",
        statement="A^E(t) has a positive determinant for every real t: it never reflects.",
        printed="det A^E(t) > 0",
        verdict=Verdict.CONFIRMED,
        form=exponential,
        cases=lambda: maps("positive", 4),
        deviation=_stays,
        copies=(Copy("A^P for A^E", polar), Copy("A^L for A^E", linear)),
    ),
    Claim(
        id="kaji_2d.3.slope",
        place="section 3, derivative of det A^E",
        statement="The derivative of the determinant of A^E.",
        printed="d/dt det A^E(t) = log(λ₁ λ₂) exp(t log(λ₁ λ₂))",
        verdict=Verdict.CONFIRMED,
        form=_slope,
        cases=_values_and_times,
        deviation=equals(_true_slope),
        copies=(
            Copy("log(λ₁ + λ₂) for the factor log(λ₁ λ₂)", _slope_with(lambda m, a, b: m.log(a + b))),
            Copy("log λ₁ log λ₂ for the factor", _slope_with(lambda m, a, b: m.log(a) * m.log(b))),
        ),
        losses=(
            Loss(
                where="area kept almost: singular values 1.001 and 0.999 (and 1e-12 more)",
                formula=_slope,
                truth=lambda m, first, second, t: (m.log(first) + m.log(second)) * (first * second) ** t,
                at=(1.001, 1 / 1.001 + 1e-12, 0.5),
                digits=12,
            ),
        ),
    ),
    Claim(
        id="kaji_2d.3.monotonic",
        place="section 3, after the derivative",
        statement="The determinant of A^E is constant if λ₁ λ₂ = 1, and else strictly monotonic over all times.",
        verdict=Verdict.CONFIRMED,
        form=exponential,
        cases=_monotonic_cases,
        deviation=_not_monotonic,
        copies=(Copy("A^P for A^E", polar), Copy("A^L for A^E", linear)),
    ),
    Claim(
        id="kaji_2d.3.area_monotonic",
        place="section 3, before figure 1",
        statement="So the area of a triangle moved by A^E changes monotonically.",
        verdict=Verdict.CONFIRMED,
        form=exponential,
        cases=_triangles,
        deviation=_area_not_monotonic,
        copies=(Copy("A^P for A^E", polar),),
        remark="Of a triangle by itself. In a mesh B is not A^E, and its triangles may even turn over.",
    ),
)
"""What does not."""
