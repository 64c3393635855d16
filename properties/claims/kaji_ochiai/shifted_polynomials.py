"""Appendix B, after Proposition B.1: the coefficients with the middle eigenvalue shifted to 0."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.kaji_ochiai.interpolation_polynomials import Numbers
from affinecert.properties.claims.precision import equals, mp
from affinecert.reference._matrices import Context, Number


def _shifted_terms(m: Context, f: Any, l1: Number, l3: Number, slip: str = "") -> Numbers:
    """The printed s, t and u of the shifted eigenvalues l1, 0, l3."""
    s = f(l1) / (l1 * (l1 - l3))
    t = f(m.zero) / (l3 * l1)
    u = f(l3) / ((l3 - l1) * (l3 if slip != "u" else l1))
    return s, t, u


def _terms_of_eq13(m: Context, f: Any, l1: Number, l3: Number) -> Numbers:
    """S, t and u of equation 13 with the middle eigenvalue 0."""
    zero = m.zero
    return (
        f(l1) / ((l1 - zero) * (l1 - l3)),
        f(zero) / ((zero - l3) * (zero - l1)),
        f(l3) / ((l3 - l1) * (l3 - zero)),
    )


def _a(m: Context, f: Any, l1: Number, l3: Number, slip: int = 0) -> Number:
    return f(m.zero) + slip * f(l1)


def _b_line(line: int, sign: int = 1) -> Any:
    """The printed lines for b: from s, t, u; over a common denominator; with f(0) taken off."""

    def b(m: Context, f: Any, l1: Number, l3: Number) -> Number:
        s, t, u = _shifted_terms(m, f, l1, l3)
        zero = f(m.zero)
        if line == 1:
            return -s * l3 - t * (l3 + l1) - sign * u * l1
        if line == 2:
            bracket = -f(l1) * l3**2 - zero * (l1 - l3) * (l3 + sign * l1) + f(l3) * l1**2
        else:
            bracket = -(f(l1) - zero) * l3**2 + sign * (f(l3) - zero) * l1**2
        return bracket / (l1 * l3 * (l1 - l3))

    return b


def _t2(m: Context, f: Any, slope: Number, x: Number) -> Number:
    """The rest (f(x) - f(0) - f'(0) x) / x^2."""
    return (f(x) - f(m.zero) - slope * x) / x**2


def _b_by_rest(sign: int = -1) -> Any:
    def b(m: Context, f: Any, l1: Number, l3: Number) -> Number:
        slope = _slope(m, f)
        return slope + sign * l1 * l3 * (_t2(m, f, slope, l1) - _t2(m, f, slope, l3)) / (l1 - l3)

    return b


def _c_by_sum(order: int = 1) -> Any:
    def c(m: Context, f: Any, l1: Number, l3: Number) -> Number:
        s, t, u = _shifted_terms(m, f, l1, l3)
        return s + order * t + u

    return c


def _slope(m: Context, f: Any) -> Number:
    return definitions.derivative(m, f, m.zero)


def _interpolant(k: int) -> Any:
    """Coefficient k of the polynomial of degree two with the values of f at l1, 0 and l3, by divided differences."""

    def coefficient(m: Context, f: Any, l1: Number, l3: Number) -> Number:
        first = (f(l1) - f(m.zero)) / l1
        second = ((f(l3) - f(l1)) / (l3 - l1) - first) / l3
        return (f(m.zero), first - second * l1, second)[k]

    return coefficient


def _shifted_log(x: Number) -> Number:
    return mp.log(x + 3)


def _functions() -> list[tuple[Any, Number, Number]]:
    nodes = [(1, -1), (2, -0.5), (0.5, -2.5), (0.125, -0.25)]
    return [(f, mp.mpf(a), mp.mpf(b)) for f in (mp.exp, _shifted_log) for a, b in nodes]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.B.shifted.stu",
        place="appendix B, after Proposition B.1",
        statement="With the middle eigenvalue shifted to 0 the terms of equation 13 are these.",
        printed="s = f(λ1) / (λ1(λ1 - λ3)), t = f(0) / (λ3λ1), u = f(λ3) / ((λ3 - λ1)λ3)",
        verdict=Verdict.CONFIRMED,
        form=_shifted_terms,
        cases=_functions,
        deviation=equals(_terms_of_eq13),
        copies=(Copy("λ1 for the last λ3 in u", lambda m, f, x, z: _shifted_terms(m, f, x, z, "u")),),
    ),
    Claim(
        id="kaji_ochiai.B.shifted.a",
        place="appendix B, the first coefficient",
        statement="The constant coefficient is f(0).",
        printed="a = tλ3λ1 = f(0)",
        verdict=Verdict.CONFIRMED,
        form=_a,
        cases=_functions,
        deviation=equals(_interpolant(0)),
        copies=(Copy("f(0) + f(λ1)", lambda m, f, x, z: _a(m, f, x, z, 1)),),
    ),
    Claim(
        id="kaji_ochiai.B.shifted.b.line_1",
        place="appendix B, the second coefficient, first line",
        statement="b from s, t and u.",
        printed="b = -sλ3 - t(λ3 + λ1) - uλ1",
        verdict=Verdict.CONFIRMED,
        form=_b_line(1),
        cases=_functions,
        deviation=equals(_interpolant(1)),
        copies=(Copy("+ uλ1", _b_line(1, -1)),),
    ),
    Claim(
        id="kaji_ochiai.B.shifted.b.line_2",
        place="appendix B, the second coefficient, second line",
        statement="b over one denominator.",
        printed="b = {-f(λ1)λ3² - f(0)(λ1 - λ3)(λ3 + λ1) + f(λ3)λ1²} / (λ1λ3(λ1 - λ3))",
        verdict=Verdict.CONFIRMED,
        form=_b_line(2),
        cases=_functions,
        deviation=equals(_interpolant(1)),
        copies=(Copy("λ3 - λ1 for λ3 + λ1", _b_line(2, -1)),),
    ),
    Claim(
        id="kaji_ochiai.B.shifted.b.line_3",
        place="appendix B, the second coefficient, third line",
        statement="b with f(0) taken off the other values.",
        printed="b = {-(f(λ1) - f(0))λ3² + (f(λ3) - f(0))λ1²} / (λ1λ3(λ1 - λ3))",
        verdict=Verdict.CONFIRMED,
        form=_b_line(3),
        cases=_functions,
        deviation=equals(_interpolant(1)),
        copies=(Copy("- for + in the bracket", _b_line(3, -1)),),
    ),
    Claim(
        id="kaji_ochiai.B.shifted.b.line_4",
        place="appendix B, the second coefficient, last line",
        statement="b by the rests T2(x) = (f(x) - f(0) - f'(0)x) / x², which have limits at 0.",
        printed="b = f'(0) - λ1λ3(T2(λ1) - T2(λ3)) / (λ1 - λ3)",
        verdict=Verdict.CONFIRMED,
        form=_b_by_rest(),
        cases=_functions,
        deviation=equals(_interpolant(1)),
        copies=(Copy("+ for -", _b_by_rest(1)),),
        remark="For exp T2 is e2 of equation 6.",
    ),
    Claim(
        id="kaji_ochiai.B.shifted.c.line_1",
        place="appendix B, the third coefficient, first line",
        statement="c is the sum of s, t and u.",
        printed="c = s + t + u",
        verdict=Verdict.CONFIRMED,
        form=_c_by_sum(),
        cases=_functions,
        deviation=equals(_interpolant(2)),
        copies=(Copy("s - t + u", _c_by_sum(-1)),),
    ),
    Claim(
        id="kaji_ochiai.B.shifted.c.rest",
        place="appendix B, the third coefficient, to the end",
        statement="The remaining lines for c.",
        verdict=Verdict.UNCHECKABLE,
        reason="The copy of the paper at hand breaks off within the second line.",
        remark="They have to end in c = (λ1T2(λ1) - λ3T2(λ3)) / (λ1 - λ3), of which the c of equation 6 is the case "
        "of exp; that one is checked.",
    ),
)
