"""Appendix A.1.1: G_A is a Lie group."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import shear
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import distance, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, array
from affinecert.reference.shear import parameters

Member = Callable[..., Array]
Chart = Callable[[Context, Array], Array]
Allowed = Callable[[Number, Number], bool]


def _without_corner(m: Context, a1: Number, a2: Number, _: Number, a4: Number, a5: Number) -> Array:
    return shear(m, a1, a2, m.zero, a4, a5)


def _same_shears(m: Context, a1: Number, a2: Number, a3: Number, _: Number, a5: Number) -> Array:
    return shear(m, a1, a2, a3, a1, a5)


def _symmetric_corner(m: Context, a1: Number, a2: Number, a3: Number, a4: Number, a5: Number) -> Array:
    member = shear(m, a1, a2, a3, a4, a5)
    member[2, 0] = a3
    return member


def _pairs() -> list[tuple[Array, Array]]:
    simple = exactly([1, 1, 0, 0, 1]), exactly([0, 1, 0, 1, 1])
    return [simple, *((_positive(pair[0]), _positive(pair[1])) for pair in arrays("shears", 6, (2, 5), -2, 2))]


def _positive(alpha: Array) -> Array:
    return array([alpha[0], abs(alpha[1]) + 1, alpha[2], alpha[3], abs(alpha[4]) + mp.mpf(1) / 4])


def _outside(member: Member, matrix: Array) -> Number:
    """How far a matrix is from the one of that form with its parameters; 1 if a stretch is not positive."""
    found = parameters(matrix)
    return distance(matrix, member(mp, *found)) if found[1] > 0 and found[4] > 0 else mp.one


def _product(member: Member, case: tuple[Array, Array]) -> Number:
    return _outside(member, member(mp, *case[0]) @ member(mp, *case[1]))


def _inverse(member: Member, case: tuple[Array, Array]) -> Number:
    return max(_outside(member, definitions.inverse(mp, member(mp, *alpha))) for alpha in case)


def _chart(order: tuple[int, ...] = (0, 1, 2, 3, 4)) -> Chart:
    def phi(_: Context, member: Array) -> Array:
        coordinates: Array = parameters(member)[list(order)]
        return coordinates

    return phi


def _unread(chart: Chart, case: tuple[Array, Array]) -> Number:
    """How far members are from those that their coordinates give back."""
    return max(distance(chart(mp, shear(mp, *alpha)), alpha) for alpha in case)


def _stretches() -> list[tuple[Number, Number]]:
    small = mp.mpf(2) ** -60
    return [(a, b) for a in (mp.one, mp.zero, small, -small) for b in (mp.one, mp.mpf(1) / 4, mp.zero, mp.mpf(3))]


def _singular(allowed: Allowed, case: tuple[Number, Number]) -> bool:
    """Whether a matrix is let in that has no inverse, or a border from which every neighbourhood leaves the set."""
    if not allowed(*case):
        return False
    member = shear(mp, mp.one, case[0], mp.one, mp.one, case[1])
    step = min(case) / 2 or mp.mpf(2) ** -100
    steps = [(sign * step, other * step) for sign in (-1, 1) for other in (-1, 1)]
    return definitions.determinant(member) == 0 or not all(allowed(case[0] + x, case[1] + y) for x, y in steps)


def _unclosed(allowed: Allowed, case: tuple[Number, Number]) -> bool:
    """Whether an invertible matrix is kept out that is a limit of members."""
    near = all(allowed(case[0] + mp.mpf(2) ** -k, case[1] + mp.mpf(2) ** -k) for k in range(50, 200, 30))
    return near and case[0] * case[1] != 0 and not allowed(*case)


SUBGROUP: dict[str, Any] = {
    "verdict": Verdict.CONFIRMED,
    "form": shear,
    "cases": _pairs,
    "copies": (
        Copy("the corner α3 is 0", _without_corner),
        Copy("α4 = α1", _same_shears),
        Copy("α3 below the diagonal too", _symmetric_corner),
    ),
}

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.1.product",
        place="appendix A.1.1, 'G_A is a subgroup in GL(3)'",
        statement="The product of two matrices of G_A is in G_A.",
        printed="G_A = {[[1, α1, α3], [0, α2, α4], [0, 0, α5]] | α2, α5 ∈ R+}",
        deviation=_product,
        **SUBGROUP,
    ),
    Claim(
        id="bansal_tatu.A.1.1.inverse",
        place="appendix A.1.1, 'G_A is a subgroup in GL(3)'",
        statement="The inverse of a matrix of G_A is in G_A.",
        deviation=_inverse,
        **SUBGROUP,
    ),
    Claim(
        id="bansal_tatu.A.1.1.chart",
        place="appendix A.1.1, φ",
        statement="φ(A) = (α1, ..., α5) is a chart of G_A: the parameters determine the matrix, and it them.",
        printed="φ: G_A → R⁵, φ(A) = (α1, α2, α3, α4, α5)",
        verdict=Verdict.CONFIRMED,
        form=_chart(),
        cases=_pairs,
        deviation=_unread,
        copies=(
            Copy("α4 for α5", _chart((0, 1, 2, 3, 3))),
            Copy("the entries row by row: (α1, α3, α2, α4, α5)", _chart((0, 2, 1, 3, 4))),
        ),
        remark="Its image is not all of R⁵ but the part where α2, α5 > 0.",
    ),
    Claim(
        id="bansal_tatu.A.1.1.open",
        place="appendix A.1.1, the set",
        statement="Every matrix of G_A is invertible, and the parameters of G_A form an open set: α2, α5 > 0.",
        printed="α2, α5 ∈ R+",
        verdict=Verdict.CONFIRMED,
        form=lambda a2, a5: a2 > 0 and a5 > 0,
        cases=_stretches,
        deviation=_singular,
        copies=(
            Copy("α2, α5 ≥ 0, as section 3 prints", lambda a2, a5: a2 >= 0 and a5 >= 0),
            Copy("α2 + α5 > 0 for both", lambda a2, a5: a2 + a5 > 0),
        ),
        remark="The definition of section 3 prints ≥ for >.",
    ),
    Claim(
        id="bansal_tatu.A.1.1.closed",
        place="appendix A.1.1, 'linear Lie group'",
        statement="G_A is closed in GL(3): the limit of matrices of G_A is in G_A if it is invertible.",
        verdict=Verdict.CONFIRMED,
        form=lambda a2, a5: a2 > 0 and a5 > 0,
        cases=_stretches,
        deviation=_unclosed,
        copies=(
            Copy("α5 > 1/4 for α5 > 0", lambda a2, a5: a2 > 0 and a5 > mp.mpf(1) / 4),
            Copy("the identity is left out", lambda a2, a5: a2 > 0 and a5 > 0 and (a2, a5) != (1, 1)),
        ),
        remark="By the closed subgroup theorem it is a Lie group for that alone.",
    ),
)
