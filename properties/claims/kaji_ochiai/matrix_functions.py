"""Appendix A: functions of matrices."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference import sam
from affinecert.reference._existence import Logarithm, logarithm
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity


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
)
