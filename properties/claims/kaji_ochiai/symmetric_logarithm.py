"""Section 4.2: the logarithm of positive definite matrices by a quadratic polynomial."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_ochiai.symmetric_exponential import (
    as_cases,
    coefficients,
    ordered_eigenvalues,
    spectrum,
)
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference import sym3
from affinecert.reference._matrices import Array, Context, Number, array, identity, scalar


def _linear_parts() -> list[tuple[Array]]:
    corners = (
        [[2, 0, 0], [0, 1, 0], [0, 0, 3]],
        [[-1, 0, 0], [0, -2, 0], [0, 0, 1]],
        [[1, 3, 0], [0, 1, 0], [0, 0, 1]],
    )
    drawn = [(each,) for each in arrays("linear parts", 8, (3, 3), -2, 2) if definitions.determinant(each) > 0]
    return [*as_cases(corners), *drawn]


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
    return ordered_eigenvalues(m, square / ordered_eigenvalues(m, square)[1])


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


def _through_series(m: Context, linear: Array) -> Array:
    return np.asarray(sym3.log(m, linear.T @ linear) / 2)


_NEAR_IDENTITY = [[1.0 + 3e-12, 1e-12, 0.0], [0.0, 1.0, 1e-12], [0.0, 0.0, 1.0 - 2e-12]]


CLAIMS: tuple[Claim[Any, Any], ...] = (
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
