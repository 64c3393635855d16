"""Sections 4.1 and 4.2: exponential and logarithm of symmetric matrices by quadratic polynomials."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference import sym3
from affinecert.reference._matrices import Array, Context, Number, array, identity, scalar

SIMPLE = ([[2, 0, 0], [0, 1, 0], [0, 0, 0]], [[0, 1, 0], [1, 0, 0], [0, 0, 3]], [[1, 2, 0], [2, 0, -1], [0, -1, 2]])
DOUBLE = ([[1, 0, 0], [0, 1, 0], [0, 0, -1]], [[0, 1, 1], [1, 0, 1], [1, 1, 0]], [[0, -1, 1], [-1, 0, 1], [1, 1, 0]])
TRIPLE = ([[0, 0, 0], [0, 0, 0], [0, 0, 0]], [[1, 0, 0], [0, 1, 0], [0, 0, 1]])


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


def _matrices(*groups: Sequence[Any]) -> list[tuple[Array]]:
    return [(exactly(each),) for group in groups for each in group]


def _symmetric(name: str, count: int) -> list[tuple[Array]]:
    return [(each + each.T,) for each in arrays(name, count, (3, 3), -1.5, 1.5)]


def _generic() -> list[tuple[Array]]:
    return [*_matrices(SIMPLE), *_symmetric("symmetric", 4)]


def _linear_parts() -> list[tuple[Array]]:
    corners = (
        [[2, 0, 0], [0, 1, 0], [0, 0, 3]],
        [[-1, 0, 0], [0, -2, 0], [0, 0, 1]],
        [[1, 3, 0], [0, 1, 0], [0, 0, 1]],
    )
    drawn = [(each,) for each in arrays("linear parts", 8, (3, 3), -2, 2) if definitions.determinant(each) > 0]
    return [*_matrices(corners), *drawn]


def _eigenvalues(m: Context, matrix: Array) -> Array:
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
    return _eigenvalues(m, y - identity(m, 3) * _eigenvalues(m, y)[1])


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


def _l2(power: int = 1) -> Any:
    """(log x - (x - 1)) / (x - 1), at 1 its limit."""

    def l2(m: Context, x: Number) -> Number:
        return (m.log(x) - (x - 1)) / (x - 1) ** power if x != 1 else m.zero

    return l2


def logarithm(l2: Any = None, half: int = 2, sign: int = -1) -> Any:
    """Equation 7, of the linear part; S is the square root of its L^T L."""
    f = l2 or _l2()

    def printed(m: Context, linear: Array) -> Array:
        square = linear.T @ linear
        eigenvalues = spectrum(m, square)
        one, three = eigenvalues[0] / eigenvalues[1], eigenvalues[2] / eigenvalues[1]
        z = square / eigenvalues[1]
        a = -1 + (three * f(m, one) + sign * one * f(m, three)) / (one - three)
        c = (f(m, one) - f(m, three)) / (one - three)
        found: Array = ((a + m.log(eigenvalues[1])) * identity(m, 3) - (a + c) * z + c * (z @ z)) / half
        return found

    return printed


def _is_logarithm(form: Any, case: tuple[Array]) -> Number:
    """How far exp of twice a matrix, by the series, is from L^T L; and the matrix from being symmetric."""
    (linear,) = case
    found = form(mp, linear)
    square = linear.T @ linear
    return max(difference(definitions.exponential(mp, 2 * found), square), difference(found, found.T))


def _normalised(by: int) -> Any:
    def eigenvalues(m: Context, linear: Array) -> Array:
        found = spectrum(m, linear.T @ linear)
        return array([each / found[by] for each in found])

    return eigenvalues


def _of_normalised(m: Context, linear: Array) -> Array:
    square = linear.T @ linear
    return _eigenvalues(m, square / _eigenvalues(m, square)[1])


def _inverse_stretch(half: int) -> Any:
    """S^-1 by equation 6 of -log S, whose eigenvalues are -(log lambda_i) / 2 of those of L^T L."""

    def inverse(m: Context, linear: Array) -> Array:
        square = linear.T @ linear
        reused = [-m.log(each) / half for each in reversed(spectrum(m, square))]
        y = -logarithm()(m, linear)
        one, three = reused[0] - reused[1], reused[2] - reused[1]
        z = y - identity(m, 3) * reused[1]
        b, c = coefficients(m, one, three)
        found: Array = m.exp(reused[1]) * (identity(m, 3) + b * z + c * (z @ z))
        return found

    return inverse


def _definite_symmetric(m: Context, linear: Array) -> Array:
    return np.asarray(linear.T @ linear)


def _square_of_map(m: Context, linear: Array) -> Array:
    return np.asarray(linear @ linear)


def _not_definite(form: Any, case: tuple[Array]) -> Number:
    matrix = form(mp, *case)
    minors = [definitions.determinant(matrix[:k, :k]) for k in (1, 2, 3)]
    return max(difference(matrix, matrix.T), *(mp.one * (minor <= 0) for minor in minors))


def _root(sign: int) -> Any:
    """The symmetric root with eigenvalues sqrt(d), the least one times a sign."""

    def root(m: Context, linear: Array) -> Array:
        d, q = m.eigsy(m.matrix((linear.T @ linear).tolist()))
        roots = [m.sqrt(each) * (sign if k == 0 else 1) for k, each in enumerate(d)]
        return array((q * m.diag(roots) * q.T).tolist())

    return root


def _power_root(m: Context, linear: Array) -> Array:
    return sym3.power(m, linear.T @ linear, scalar(m.one / 2))


def _small_doubles() -> list[tuple[Array]]:
    """Matrices of a double eigenvalue whose eigenvalues are about 0.003 apart."""
    return [(exactly(each) * mp.mpf("0.003") + identity(mp, 3) * k,) for k, each in enumerate(DOUBLE)]


def _through_series(m: Context, linear: Array) -> Array:
    return np.asarray(sym3.log(m, linear.T @ linear) / 2)


_NEAR_IDENTITY = [[1.0 + 3e-12, 1e-12, 0.0], [0.0, 1.0, 1e-12], [0.0, 0.0, 1.0 - 2e-12]]

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.4.1.cubic_formula",
        place="section 4.1, before equation 6",
        statement="The eigenvalues are obtained by the cubic formula: mean + 2r cos((arccos(det / 2r³) + 2πk) / 3).",
        verdict=Verdict.CONFIRMED,
        form=_cubic(),
        cases=lambda: [*_generic(), *_matrices(DOUBLE[:1], TRIPLE)],
        deviation=equals(_eigenvalues),
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
        cases=lambda: [*_generic(), *_matrices(DOUBLE[:1])],
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
        cases=lambda: [*_generic(), *_matrices(DOUBLE[:1])],
        outside=lambda: _matrices(TRIPLE),
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
        outside=lambda: _matrices(TRIPLE),
        deviation=lambda form, case: max(difference(form(mp, *case), definitions.exponential(mp, *case)) - 1e-11, 0),
        copies=(Copy("c without - 1 in both brackets, the half left", exponential(less=0, f=e2_short)),),
        remark="At λ1' = λ3' take b = 1, c = 1/2. The identity map, most frequent of all, has Y = 0.",
    ),
    Claim(
        id="kaji_ochiai.4.2.positive_definite",
        place="section 4.2, first paragraph",
        statement="ᵗÂÂ is symmetric and positive definite.",
        verdict=Verdict.CONFIRMED,
        form=_definite_symmetric,
        cases=_linear_parts,
        deviation=_not_definite,
        copies=(Copy("Â² for ᵗÂÂ", _square_of_map),),
    ),
    Claim(
        id="kaji_ochiai.4.2.unique_root",
        place="section 4.2, first paragraph",
        statement="Its positive definite square root, and so the logarithm of that, is uniquely determined.",
        verdict=Verdict.CONFIRMED,
        form=_root(1),
        cases=_linear_parts,
        deviation=equals(_power_root),
        copies=(Copy("one eigenvalue of the other sign: another square root", _root(-1)),),
        remark="Among all square roots it is one of eight or more.",
    ),
    Claim(
        id="kaji_ochiai.4.2.normalised",
        place="section 4.2, before equation 7",
        statement="Z = ᵗÂÂ / λ2 has the eigenvalues λ1/λ2, 1 and λ3/λ2.",
        printed="the eigenvalues of Z are λ1', 1, λ3'",
        verdict=Verdict.CONFIRMED,
        form=_normalised(1),
        cases=_linear_parts,
        deviation=equals(_of_normalised),
        copies=(Copy("λ1 for λ2", _normalised(0)),),
    ),
    Claim(
        id="kaji_ochiai.4.2.eq7",
        place="section 4.2, equation 7",
        statement="The logarithm of S is this quadratic polynomial of Z, with L2(x) = (log x - (x - 1)) / (x - 1).",
        printed="log(S) = (1/2) ((a + log λ2) I - (a + c) Z + c Z²), a = -1 + (λ3'L2(λ1') - λ1'L2(λ3')) / (λ1' - λ3'), "
        "c = (L2(λ1') - L2(λ3')) / (λ1' - λ3')",
        verdict=Verdict.BOUND,
        domain="λ1 ≠ λ3, with L2(1) = 0; at a triple eigenvalue, as of every similarity, a and c are 0/0",
        form=logarithm(),
        cases=lambda: [*_linear_parts(), (exactly([[2, 0, 0], [0, 1, 0], [0, 0, 1]]),)],
        outside=lambda: [
            (exactly(each),) for each in ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, -2, 0], [2, 0, 0], [0, 0, 2]])
        ],
        deviation=_is_logarithm,
        copies=(
            Copy("(x - 1)² for x - 1 in L2, as e2 has it", logarithm(l2=_l2(2))),
            Copy("+ for - in a", logarithm(sign=1)),
            Copy("without 1/2", logarithm(half=1)),
        ),
        losses=(
            Loss(
                where="log S for a map 3e-12 from the identity",
                formula=logarithm(),
                truth=_through_series,
                at=(_NEAR_IDENTITY,),
                digits=12,
            ),
        ),
        remark="The definition of L2 is lost in this copy; the printed a and c are right for this one and for no power "
        "of (x - 1) besides.",
    ),
    Claim(
        id="kaji_ochiai.4.2.inverse_stretch",
        place="section 4.2, after equation 7",
        statement="S⁻¹ is equation 6 of -log S, whose eigenvalues -(1/2) log λ_i need no second cubic.",
        printed="we compute it by the formula (6); we can reuse the values of λ",
        verdict=Verdict.CONFIRMED,
        form=_inverse_stretch(2),
        cases=_linear_parts,
        deviation=equals(lambda m, linear: sym3.power(m, linear.T @ linear, scalar(-m.one / 2))),
        copies=(Copy("log λ_i for half of it", _inverse_stretch(1)),),
    ),
    Claim(
        id="kaji_ochiai.4.2.l2_approximation",
        place="section 4.2, after equation 7",
        statement="A second order approximation of L2 for small λ' - 1.",
        verdict=Verdict.UNCHECKABLE,
        reason="The formula is missing in the copy of the paper at hand.",
        remark="It has to be L2(x) ≈ -(x - 1)/2 + (x - 1)²/3; (λ1' - λ3') stays 0 at a triple eigenvalue.",
    ),
)
