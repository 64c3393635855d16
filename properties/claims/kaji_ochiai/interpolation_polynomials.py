"""Appendix B: functions of symmetric matrices by polynomials of degree two."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_ochiai.symmetric_exponential import spectrum
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, identity

Numbers = tuple[Number, ...]


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


CLAIMS: tuple[Claim[Any, Any], ...] = (
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
        verdict=Verdict.CONFIRMED,
        form=_eq13(),
        cases=_distinct_matrices,
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
)
