"""Appendices A and B: functions of matrices, and the derivation of equations 6 and 7."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_ochiai.symmetric_functions import spectrum
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference import sam
from affinecert.reference._existence import Logarithm, logarithm
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity

Numbers = tuple[Number, ...]


def _linear_maps() -> list[Array]:
    """Regular matrices P, and among them no orthogonal ones."""
    drawn = [each for each in arrays("bases", 20, (3, 3), -2, 2) if abs(definitions.determinant(each)) > 0.5]
    return [exactly([[1, 1, 0], [0, 1, 0], [0, 0, 2]]), *drawn[:5]]


def _conjugated(inverse_last: bool) -> Any:
    def conjugated(m: Context, p: Array, matrix: Array) -> Array:
        inverse = definitions.inverse(m, p)
        found: Array = p @ matrix @ inverse if inverse_last else inverse @ matrix @ p
        return found

    return conjugated


def _log(m: Context, matrix: Array) -> Array:
    """The principal logarithm of a linear map."""
    return sam.log(m, homogeneous(m, matrix, array([m.zero] * 3)))[:3, :3]


def _not_natural(conjugated: Any, case: tuple[Array, Array]) -> Number:
    """How far exp and log of P A P^-1 are from a conjugate of those of A."""
    p, matrix = case
    moved = p @ matrix @ definitions.inverse(mp, p)
    exponential = definitions.exponential(mp, matrix)
    gaps = [difference(definitions.exponential(mp, moved), conjugated(mp, p, exponential))]
    gaps.append(difference(_log(mp, p @ exponential @ definitions.inverse(mp, p)), conjugated(mp, p, matrix)))
    return max(gaps)


def _conjugations() -> list[tuple[Array, Array]]:
    return list(zip(_linear_maps(), arrays("conjugated", 6, (3, 3), -0.5, 0.5), strict=True))


def _through_diagonal(function: Any) -> Any:
    """P diag(f(d)) P^-1 of P diag(d) P^-1."""

    def of_matrix(m: Context, p: Array, d: Array) -> Array:
        images = identity(m, 3) * array([function(m, each) for each in d])
        found: Array = p @ images @ definitions.inverse(m, p)
        return found

    return of_matrix


def _composed(m: Context, p: Array, d: Array) -> Array:
    return definitions.exponential(m, p @ (identity(m, 3) * d) @ definitions.inverse(m, p))


def _diagonalisations() -> list[tuple[Array, Array]]:
    values = [exactly([0, 1, 1]), *arrays("diagonals", 5, (3,), -2, 2)]
    return list(zip(_linear_maps(), values, strict=True))


def _symmetric_cases() -> list[Array]:
    corners = [exactly([[2, 0, 0], [0, 1, 0], [0, 0, 0]]), exactly([[0, 1, 1], [1, 0, 1], [1, 1, 0]])]
    return corners + [each + each.T for each in arrays("appendix B", 4, (3, 3), -1, 1)]


def _remainder(sign: int) -> Any:
    """The remainder of the series of exp, cut off after 90 terms, on division by the characteristic polynomial."""

    def evaluated(m: Context, y: Array) -> Array:
        trace = y.trace()
        minors = (trace**2 - (y @ y).trace()) / 2
        leading = [m.one, -trace, sign * minors, -definitions.determinant(y)]
        rest = [m.one / m.factorial(k) for k in range(90, -1, -1)]
        for k in range(len(rest) - 3):
            head = rest[k]
            for j in range(4):
                rest[k + j] = rest[k + j] - head * leading[j]
        c, b, a = rest[-3:]
        found: Array = a * identity(m, 3) + b * y + c * (y @ y)
        return found

    return evaluated


def _characteristic(sign: int) -> Any:
    """The characteristic polynomial x^3 - tr x^2 + (sum of minors) x - det at the matrix."""

    def at_itself(m: Context, y: Array) -> Array:
        trace = y.trace()
        minors = (trace**2 - (y @ y).trace()) / 2
        found: Array = y @ y @ y - trace * (y @ y) + minors * y - identity(m, 3) * (sign * definitions.determinant(y))
        return found

    return at_itself


def _distinct() -> list[Numbers]:
    return [tuple(mp.mpf(x) for x in each) for each in ((1, 0, -1), (3, 1, 0), (0.5, 0.25, -2), (2, 1.5, -0.125))]


def lagrange(m: Context, f: Any, l1: Number, l2: Number, l3: Number, slip: str = "") -> Numbers:
    """The coefficients a, b, c of equation 13."""
    s = f(l1) / ((l1 - l2) * (l1 - l3))
    t = f(l2) / ((l2 - l3) * (l2 - l1 if slip != "sign of t" else l1 - l2))
    u = f(l3) / ((l3 - l1) * (l3 - l2))
    a = s * l2 * l3 + t * l3 * l1 + u * l1 * l2
    b = -s * (l2 + l3) - t * (l3 + l1) - (u * (l1 + l2) if slip != "b" else u * (l1 + l3))
    return a, b, s + t + u


def _vandermonde(slip: str = "") -> Any:
    """The rows (1, x, x^2) of the printed system; or with x^3 in the last column."""

    def misses(m: Context, f: Any, nodes: Numbers) -> Number:
        a, b, c = lagrange(m, f, *nodes)
        power = 3 if slip == "cubes" else 2
        return max(abs(a + b * x + c * x**power - f(x)) for x in nodes)

    return misses


def _system_fails(system: Any, nodes: Numbers) -> Number:
    return max(system(mp, f, nodes) for f in (mp.exp, lambda x: mp.log(x + 3)))


def _eq13(slip: str = "") -> Any:
    """A I + b Y + c Y^2 with the coefficients of equation 13."""

    def evaluated(m: Context, y: Array, nodes: Numbers) -> Array:
        a, b, c = lagrange(m, m.exp, nodes[0], nodes[1], nodes[2], slip)
        found: Array = a * identity(m, 3) + b * y + c * (y @ y)
        return found

    return evaluated


def _distinct_matrices() -> list[tuple[Array, Numbers]]:
    return [(each, tuple(spectrum(mp, each))) for k, each in enumerate(_symmetric_cases()) if k != 1]


def _double_matrices() -> list[tuple[Array, Numbers]]:
    values = exactly([[1, 1, 1], [2, 1, 1], [1, 1, -1]])
    return [(identity(mp, 3) * each, tuple(each)) for each in values]


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
        id="kaji_ochiai.A.conjugation",
        place="appendix A",
        statement="For f = exp or log, f(PAP⁻¹) = P f(A) P⁻¹ for every regular P.",
        verdict=Verdict.CONFIRMED,
        form=_conjugated(inverse_last=True),
        cases=_conjugations,
        deviation=_not_natural,
        copies=(Copy("P⁻¹ f(A) P", _conjugated(inverse_last=False)),),
    ),
    Claim(
        id="kaji_ochiai.A.eq11",
        place="appendix A, equation 11",
        statement="A function of a diagonalisable matrix is that of its eigenvalues.",
        printed="f(A) = P diag(f(d1), ..., f(dn)) P⁻¹",
        verdict=Verdict.CONFIRMED,
        form=_through_diagonal(lambda m, x: m.exp(x)),
        cases=_diagonalisations,
        deviation=equals(_composed),
        copies=(Copy("1 + x for exp x", _through_diagonal(lambda m, x: 1 + x)),),
    ),
    Claim(
        id="kaji_ochiai.A.log_existence",
        place="appendix A, last sentence",
        statement="The real logarithm does not always exist: diag(-1, -2, 1) has none.",
        verdict=Verdict.CONFIRMED,
        form=[[-1, 0, 0], [0, -2, 0], [0, 0, 1]],
        cases=lambda: [None],
        deviation=lambda linear, _: int(logarithm(linear) is not Logarithm.NONE),
        copies=(Copy("-1 for -2: a half turn", [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]),),
        remark="That it is not unique, where it exists, is in section 4.3.",
    ),
    Claim(
        id="kaji_ochiai.B.cayley_hamilton",
        place="appendix B, before equation 12",
        statement="The characteristic polynomial vanishes at the matrix.",
        printed="p_Y(Y) = 0",
        verdict=Verdict.CONFIRMED,
        form=_characteristic(1),
        cases=lambda: [(each,) for each in _symmetric_cases()],
        deviation=lambda form, case: difference(form(mp, *case), case[0] * 0),
        copies=(Copy("+ for - before the determinant", _characteristic(-1)),),
    ),
    Claim(
        id="kaji_ochiai.B.eq12",
        place="appendix B, equation 12",
        statement="exp(Y) is the remainder, at Y, of the series on division by the characteristic polynomial.",
        printed="f(x) = q(x) p_Y(x) + r(x), f(Y) = r(Y) = aI + bY + cY²",
        verdict=Verdict.CONFIRMED,
        form=_remainder(1),
        cases=lambda: [(each,) for each in _symmetric_cases()],
        deviation=equals(definitions.exponential),
        copies=(Copy("- for + before the sum of the minors", _remainder(-1)),),
        remark="The series of the logarithm converges near I only; there r is the polynomial with its values at the "
        "eigenvalues.",
    ),
    Claim(
        id="kaji_ochiai.B.vandermonde",
        place="appendix B, the linear system",
        statement="a, b, c of equation 13 solve the Vandermonde system of the eigenvalues.",
        printed="(1, λ1, λ1²; 1, λ2, λ2²; 1, λ3, λ3²) (a, b, c) = (f(λ1), f(λ2), f(λ3))",
        verdict=Verdict.CONFIRMED,
        form=_vandermonde(),
        cases=_distinct,
        deviation=_system_fails,
        copies=(Copy("cubes for squares", _vandermonde("cubes")),),
    ),
    Claim(
        id="kaji_ochiai.B.1",
        place="Proposition B.1, equation 13",
        statement="For distinct eigenvalues f(Y) = aI + bY + cY² with these coefficients.",
        printed="s = f(λ1) / ((λ1 - λ2)(λ1 - λ3)), ..., a = sλ2λ3 + tλ3λ1 + uλ1λ2, "
        "b = -s(λ2 + λ3) - t(λ3 + λ1) - u(λ1 + λ2), c = s + t + u",
        verdict=Verdict.BOUND,
        domain="the eigenvalues are distinct, as the proposition says; else s, t, u have no value",
        form=_eq13(),
        cases=_distinct_matrices,
        outside=_double_matrices,
        deviation=equals(lambda m, y, _: definitions.exponential(m, y)),
        copies=(
            Copy("(λ2 - λ3)(λ1 - λ2) in t", _eq13("sign of t")),
            Copy("u(λ1 + λ3) in b", _eq13("b")),
        ),
        losses=(
            Loss(
                where="the coefficients for eigenvalues 1, 1 - 1e-6 and 1 - 3e-6",
                formula=lambda m, x, y, z: lagrange(m, m.exp, x, y, z),
                truth=lambda m, x, y, z: lagrange(m, m.exp, x, y, z),
                at=(1.0, 1.0 - 1e-6, 1.0 - 3e-6),
                digits=16,
            ),
        ),
    ),
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
