"""Section 4.1: the exponential of symmetric matrices by a quadratic polynomial."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, array, identity

SIMPLE = ([[2, 0, 0], [0, 1, 0], [0, 0, 0]], [[0, 1, 0], [1, 0, 0], [0, 0, 3]], [[1, 2, 0], [2, 0, -1], [0, -1, 2]])
DOUBLE = ([[1, 0, 0], [0, 1, 0], [0, 0, -1]], [[0, 1, 1], [1, 0, 1], [1, 1, 0]], [[0, -1, 1], [-1, 0, 1], [1, 1, 0]])
TRIPLE = ([[0, 0, 0], [0, 0, 0], [0, 0, 0]], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
"""Symmetric matrices by the multiplicity of their eigenvalues."""


def spectrum(m: Context, matrix: Array) -> list[Number]:
    """The eigenvalues by the cubic formula, the largest first; equal ones where its arccosine is of ±1."""
    mean = matrix.trace() / 3
    shifted = matrix - identity(m, 3) * mean
    radius = m.sqrt((shifted @ shifted).trace() / 6)
    if not radius:
        return [mean] * 3
    cosine = definitions.determinant(shifted / radius) / 2
    angle = m.acos(max(-m.one, min(m.one, cosine))) / 3
    return [mean + 2 * radius * m.cos(angle + 2 * m.pi * k / 3) for k in (0, 2, 1)]


def as_cases(*groups: Sequence[Any]) -> list[tuple[Array]]:
    """Groups of matrices as cases of one matrix each."""
    return [(exactly(each),) for group in groups for each in group]


def _symmetric(name: str, count: int) -> list[tuple[Array]]:
    return [(each + each.T,) for each in arrays(name, count, (3, 3), -1.5, 1.5)]


def _generic() -> list[tuple[Array]]:
    return [*as_cases(SIMPLE), *_symmetric("symmetric", 4)]


def ordered_eigenvalues(m: Context, matrix: Array) -> Array:
    """The eigenvalues of a symmetric matrix by its diagonalisation, the largest first."""
    return array(sorted(m.eigsy(m.matrix(matrix.tolist()), eigvals_only=True), reverse=True))


def _cubic(shift: int = 2) -> Any:
    def formula(m: Context, matrix: Array) -> Array:
        found = spectrum(m, matrix)
        return array(found if shift == 2 else [2 * found[1] - each for each in reversed(found)])

    return formula


def e2(m: Context, x: Number) -> Number:
    """(exp(x) - 1 - x) / x^2, at 0 its limit; summed as a series where the quotient cancels, but in float64."""
    if not x:
        return m.one / 2
    if m is mp and abs(x) < 0.1:
        return m.nsum(lambda k: x**k / m.factorial(k + 2), [0, 60])
    return (m.exp(x) - 1 - x) / x**2


def e2_short(m: Context, x: Number) -> Number:
    """The approximation of second order that is printed."""
    return m.one / 2 + x / 6 + x * x / 24


def coefficients(m: Context, one: Number, three: Number, f: Any = e2, *, sign: int = -1, less: int = 1) -> Any:
    """The coefficients b and c of equation 6, of the shifted eigenvalues."""
    b = 1 + sign * one * three * (f(m, one) - f(m, three)) / (one - three)
    c = m.one / 2 + (one * (2 * f(m, one) - less) - three * (2 * f(m, three) - less)) / (2 * (one - three))
    return b, c


def exponential(middle: int = 1, f: Any = e2, **slip: int) -> Any:
    """Equation 6; the ``middle`` eigenvalue is subtracted."""

    def printed(m: Context, y: Array) -> Array:
        eigenvalues = spectrum(m, y)
        center = eigenvalues[middle]
        b, c = coefficients(m, eigenvalues[0] - center, eigenvalues[2] - center, f, **slip)
        z = y - identity(m, 3) * center
        found: Array = m.exp(center) * (identity(m, 3) + b * z + c * (z @ z))
        return found

    return printed


def _c_of(m: Context, one: Number, three: Number) -> Number:
    return coefficients(m, one, three)[1]


def _shifted(order: int) -> Any:
    """The eigenvalues of Y - lambda_2 I, as printed; or of Y - lambda_3 I."""

    def eigenvalues(m: Context, y: Array) -> Array:
        found = spectrum(m, y)
        return array([found[0] - found[order], m.zero, found[2] - found[order]])

    return eigenvalues


def _of_shifted(m: Context, y: Array) -> Array:
    return ordered_eigenvalues(m, y - identity(m, 3) * ordered_eigenvalues(m, y)[1])


def _nearly(matrix: Any, gap: str) -> tuple[Array]:
    """A matrix with equal eigenvalues, whose eigenvalues are parted by about so much."""
    return (exactly(matrix) + exactly([[3, 1, 0], [1, 0, 1], [0, 1, -2]]) * mp.mpf(gap),)


def _colliding() -> list[tuple[Array]]:
    return [_nearly(each, gap) for each in (*DOUBLE, TRIPLE[1]) for gap in ("1e-9", "1e-18")]


def _with_more_digits(form: Any) -> Any:
    """A form that is evaluated with so many digits that its small denominators cost none."""

    def evaluated(m: Context, matrix: Array) -> Array:
        with m.workdps(3 * m.dps):
            found: Array = form(m, matrix)
            return found

    return evaluated


def _truncated(count: int) -> Any:
    return lambda x: sum(mp.one * x**k / mp.factorial(k + 2) for k in range(count))


def _beyond_third_order(approximation: Any, x: Number) -> Number:
    """How far the error is beyond |x|^3 / 120 by more than a quarter of x, in parts of that."""
    with mp.workdps(120):
        truth = (mp.exp(x) - 1 - x) / x**2
        return max(abs(approximation(x) - truth) * 120 / abs(x) ** 3 - 1 - abs(x) / 4, mp.zero)


def _small_doubles() -> list[tuple[Array]]:
    """Matrices of a double eigenvalue whose eigenvalues are about 0.003 apart."""
    return [(exactly(each) * mp.mpf("0.003") + identity(mp, 3) * k,) for k, each in enumerate(DOUBLE)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.4.1.cubic_formula",
        place="section 4.1, before equation 6",
        statement="The eigenvalues are obtained by the cubic formula: mean + 2r cos((arccos(det / 2r³) + 2πk) / 3).",
        verdict=Verdict.CONFIRMED,
        form=_cubic(),
        cases=lambda: [*_generic(), *as_cases(DOUBLE[:1], TRIPLE)],
        deviation=equals(ordered_eigenvalues),
        copies=(Copy("the negative arccosine's, mirrored at the middle one", _cubic(shift=1)),),
        losses=(
            Loss(
                where="the gap of eigenvalues 1 and 1 + 1e-9, a third one 3",
                formula=lambda m, y: spectrum(m, y)[1] - spectrum(m, y)[2],
                truth=lambda m, y: y[0, 0] - y[1, 1],
                at=([[1.0 + 1e-9, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 3.0]],),
                digits=16,
            ),
        ),
        remark="Where two meet, the arccosine is near 1 or -1 and loses half of the digits. Equations 6 and 7 forgive "
        "it: what the eigenvalues lack, the polynomial has.",
    ),
    Claim(
        id="kaji_ochiai.4.1.shift",
        place="section 4.1, before equation 6",
        statement="Z = Y - λ2 I has the eigenvalues λ1 - λ2, 0 and λ3 - λ2.",
        printed="the eigenvalues of Z are λ1', 0, λ3'",
        verdict=Verdict.CONFIRMED,
        form=_shifted(1),
        cases=lambda: [*_generic(), *as_cases(DOUBLE[:1])],
        deviation=equals(_of_shifted),
        copies=(Copy("λ3 for λ2", _shifted(2)),),
    ),
    Claim(
        id="kaji_ochiai.4.1.eq6",
        place="section 4.1, equation 6",
        statement="exp(Y), Y symmetric, is this quadratic polynomial of Z, with e2(x) = (exp x - 1 - x) / x².",
        printed="exp(Y) = exp(λ2)(I + bZ + cZ²), b = 1 - λ1'λ3'(e2(λ1') - e2(λ3')) / (λ1' - λ3'), "
        "c = 1/2 + (λ1'(2e2(λ1') - 1) - λ3'(2e2(λ3') - 1)) / (2(λ1' - λ3'))",
        verdict=Verdict.BOUND,
        domain="λ1 ≠ λ3, with e2(0) = 1/2; at a triple eigenvalue b and c are 0/0",
        form=exponential(),
        cases=lambda: [*_generic(), *as_cases(DOUBLE[:1])],
        outside=lambda: as_cases(TRIPLE),
        deviation=equals(definitions.exponential),
        copies=(
            Copy("+ for - in b", exponential(sign=1)),
            Copy("c without - 1 in both brackets, the half left", exponential(less=0)),
        ),
        losses=(
            Loss(
                where="c at λ1' = 3e-9, λ3' = -2e-9, with e2 as defined",
                formula=_c_of,
                truth=_c_of,
                at=(3e-9, -2e-9),
                digits=16,
            ),
        ),
        remark="Errors of b and c are forgiven, as they cancel on the eigenvectors; what fails is 0/0.",
    ),
    Claim(
        id="kaji_ochiai.4.1.eq6.convergence",
        place="section 4.1, after equation 6",
        statement="As eigenvalues collide, two or all three, the formula converges to the exponential.",
        printed="We may have small denominators. Nevertheless, the above formula converges",
        verdict=Verdict.CONFIRMED,
        form=_with_more_digits(exponential(f=lambda m, x: (m.exp(x) - 1 - x) / x**2)),
        cases=_colliding,
        deviation=equals(definitions.exponential),
        copies=(
            Copy("λ1 for the eigenvalue λ2 that is subtracted", _with_more_digits(exponential(middle=0))),
            Copy("+ for - in b", _with_more_digits(exponential(sign=1))),
        ),
    ),
    Claim(
        id="kaji_ochiai.4.1.e2_approximation",
        place="section 4.1, after equation 6",
        statement="e2 is 1/2 + x/6 + x²/24 to second order: wrong by about |x|³/120.",
        printed="e2(λ') ≈ 1/2 + λ'/6 + λ'²/24",
        verdict=Verdict.CONFIRMED,
        form=_truncated(3),
        cases=lambda: [mp.mpf(sign * 2) ** -k for k in (30, 10, 5, 1) for sign in (1, -1)],
        deviation=_beyond_third_order,
        copies=(Copy("without x²/24", _truncated(2)),),
        remark="In float64 it is exact to rounding below |x| = 2e-5 only, where the quotient has lost 9 digits.",
    ),
    Claim(
        id="kaji_ochiai.4.1.e2_remedy",
        place="section 4.1, after equation 6",
        statement="With the approximation of e2 for small λ1', λ3' equation 6 has a value where eigenvalues coincide.",
        printed="In practice, when λ' is small we can use the second order approximation",
        verdict=Verdict.BOUND,
        domain="two eigenvalues coincide; at three, and so at Y = 0, (λ1' - λ3') is 0 still and b, c are 0/0",
        form=exponential(f=e2_short),
        cases=lambda: [(each[0],) for each in _small_doubles()],
        outside=lambda: as_cases(TRIPLE),
        deviation=lambda form, case: max(difference(form(mp, *case), definitions.exponential(mp, *case)) - 1e-11, 0),
        copies=(Copy("c without - 1 in both brackets, the half left", exponential(less=0, f=e2_short)),),
        remark="At λ1' = λ3' take b = 1, c = 1/2. The identity map, most frequent of all, has Y = 0.",
    ),
)
