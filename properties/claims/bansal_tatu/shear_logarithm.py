"""Appendix A.2.4: the logarithm on G_A in five branches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.appendix_cases import shear
from affinecert.properties.claims.bansal_tatu.shear_branches import (
    Branch,
    Listing,
    Parameters,
    by_cases,
    corner,
    edge,
    with_condition,
)
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import distance, exactly, mp
from affinecert.reference import shear as reference
from affinecert.reference._matrices import Array, Context, Number, array

NEXT = 1 + 2.0**-52
"""The float64 after 1."""


def _last_only(sign: int = 1, power: int = 2) -> Branch:
    def printed(m: Context, a1: Number, _: Number, a3: Number, a4: Number, a5: Number) -> Array:
        log = m.log(a5)
        corner = log * (a3 * a5 - a3 + sign * a1 * a4) / (a5 - 1) ** power - a1 * a4 / (a5 - 1)
        return array([[0, a1, corner], [0, 0, a4 * log / (a5 - 1)], [0, 0, log]])

    return printed


def _middle_only(sign: int = 1, power: int = 2) -> Branch:
    def printed(m: Context, a1: Number, a2: Number, a3: Number, a4: Number, _: Number) -> Array:
        log = m.log(a2)
        corner = a1 * a4 * log / (a2 - 1) ** power - (a3 - a2 * a3 + sign * a1 * a4) / (a2 - 1)
        return array([[0, a1 * log / (a2 - 1), corner], [0, log, a4 * log / (a2 - 1)], [0, 0, 0]])

    return printed


def _unipotent(divisor: int = 2) -> Branch:
    def printed(_: Context, a1: Number, __: Number, a3: Number, a4: Number, ___: Number) -> Array:
        return array([[0, a1, a3 - (a1 * a4) / divisor], [0, 0, a4], [0, 0, 0]])

    return printed


def _equal(edge: int = 1, sign: int = 1) -> Branch:
    def printed(m: Context, a1: Number, a2: Number, a3: Number, a4: Number, _: Number) -> Array:
        log = m.log(a2)
        corner = a3 * log / (a2 - 1) + a1 * a4 / (a2 * (a2 - 1)) - sign * a1 * a4 * log / (a2 - 1) ** 2
        return array([[0, a1 * log / (a2 - 1), corner], [0, log, a4 / a2**edge], [0, 0, log]])

    return printed


def _distinct(sign: int = 1, *, swapped: bool = False) -> Branch:
    def printed(m: Context, a1: Number, a2: Number, a3: Number, a4: Number, a5: Number) -> Array:
        l2, l5 = m.log(a2), m.log(a5)
        below = a5 if swapped else a2
        corner = a1 * a4 * l2 / ((a2 - a5) * (below - 1))
        corner -= (a1 * a4 - a2 * a3 + sign * a3 * a5) * l5 / ((a2 - a5) * (a5 - 1))
        edge = a4 * l2 / (a2 - a5) - a4 * l5 / (a2 - a5)
        return array([[0, a1 * l2 / (a2 - 1), corner], [0, l2, edge], [0, 0, l5]])

    return printed


LISTING: Listing = (
    (lambda a2, a5: a2 == 1 and a5 != 1, _last_only()),
    (lambda a2, a5: a5 == 1 and a2 != 1, _middle_only()),
    (lambda a2, a5: a2 == a5 == 1, _unipotent()),
    (lambda a2, a5: a2 == a5 and a2 != 1, _equal()),
    (lambda a2, a5: True, _distinct()),
)
"""The conditions and branches in the order of print; the last is 'otherwise'."""


def _no_logarithm(form: Branch, alpha: Parameters) -> Number:
    """How far the exponential of the form is from the shear; real eigenvalues make its logarithm the principal one."""
    return distance(definitions.exponential(mp, form(mp, *alpha)), shear(mp, *alpha))


def _off_listing(listing: Listing, alpha: Parameters) -> Number:
    return _no_logarithm(lambda m, *given: by_cases(m, listing, *given), alpha)


def _logarithm(m: Context, *alpha: Number) -> Array:
    return reference.matrix(m, reference.log(m, shear(m, *alpha)), m.zero)


def _cases(a2: Callable[[Number], Number], a5: Callable[[Number], Number]) -> Callable[[], Sequence[Parameters]]:
    """Parameters with given a2 and a5, functions of a drawn positive number that is not 1."""

    def cases() -> Sequence[Parameters]:
        simple = exactly([1, 0, 0, 1, 2]), exactly([0, 0, 1, 0, 3]), exactly([1, 0, 1, 1, 0.5])
        drawn = [each for each in arrays("shears", 6, (5,), -2, 2) if abs(each[4]) not in {0, 1}]
        return [(a1, a2(abs(x)), a3, a4, a5(abs(x))) for a1, _, a3, a4, x in (*simple, *drawn)]

    return cases


def _all_cases() -> Sequence[Parameters]:
    """Every pair of stretches that are 1, less and more, and near to 1, 0 and each other."""
    small = mp.mpf(2) ** -30
    stretches = [mp.one, mp.mpf(2), mp.one / 2, 1 + small, 2 + small, small]
    return [(mp.one, a2, mp.mpf(2), mp.mpf(3), a5) for a2 in stretches for a5 in stretches]


def _loss(where: str, entry: Callable[[Branch], Callable[..., Number]], branch: Branch, at: Any, digits: int) -> Loss:
    return Loss(where=where, formula=entry(branch), truth=entry(_logarithm), at=at, digits=digits)


def _branch(number: int, condition: str, printed: str, **rest: Any) -> Claim[Any, Any]:
    return Claim(
        id=f"bansal_tatu.A.2.4.branch_{number}",
        place=f"appendix A.2.4, branch {number}",
        statement=f"The logarithm of a shear, {condition}.",
        printed=f"corner {printed}",
        verdict=Verdict.CONFIRMED,
        deviation=_no_logarithm,
        **rest,
    )


CLAIMS: tuple[Claim[Any, Any], ...] = (
    _branch(
        1,
        "if α2 = 1 and α5 ≠ 1",
        "log α5 (α3 α5 - α3 + α1 α4) / (α5 - 1)² - α1 α4 / (α5 - 1)",
        form=_last_only(),
        cases=_cases(lambda x: mp.one, lambda x: x),
        copies=(
            Copy("- α1 α4 in the bracket", _last_only(sign=-1)),
            Copy("α5 - 1 for its square", _last_only(power=1)),
        ),
        losses=(
            _loss("the corner at α5 = 1 + 1e-4", corner, _last_only(), (1.0, 1.0, 0.0, 1.0, 1.0001), 4),
            _loss("the corner at α5 = 1 + 1e-8", corner, _last_only(), (1.0, 1.0, 0.0, 1.0, 1 + 1e-8), 8),
            _loss("the corner at 1 + 2e-16", corner, _last_only(), (1.0, 1.0, 0.3, 0.7, NEXT), 16),
        ),
    ),
    _branch(
        2,
        "if α5 = 1 and α2 ≠ 1",
        "α1 α4 log α2 / (α2 - 1)² - (α3 - α2 α3 + α1 α4) / (α2 - 1)",
        form=_middle_only(),
        cases=_cases(lambda x: x, lambda x: mp.one),
        copies=(
            Copy("- α1 α4 in the bracket", _middle_only(sign=-1)),
            Copy("α2 - 1 for its square", _middle_only(power=1)),
        ),
        losses=(
            _loss("the corner at α2 = 1 + 1e-4", corner, _middle_only(), (1.0, 1.0001, 0.0, 1.0, 1.0), 4),
            _loss("the corner at α2 = 1 + 1e-8", corner, _middle_only(), (1.0, 1 + 1e-8, 0.0, 1.0, 1.0), 8),
            _loss("the corner at 1 + 2e-16", corner, _middle_only(), (1.0, NEXT, 0.3, 0.7, 1.0), 16),
        ),
    ),
    _branch(
        3,
        "if α2 = α5 = 1",
        "α3 - α1 α4 / 2",
        form=_unipotent(),
        cases=_cases(lambda x: mp.one, lambda x: mp.one),
        copies=(Copy("α1 α4 / 3", _unipotent(3)), Copy("+ α1 α4 / 2", _unipotent(-2))),
    ),
    _branch(
        4,
        "if α2 = α5 ≠ 1",
        "α3 log α2 / (α2 - 1) + α1 α4 / (α2 (α2 - 1)) - α1 α4 log α2 / (α2 - 1)²",
        form=_equal(),
        cases=_cases(lambda x: x, lambda x: x),
        copies=(
            Copy("α4 for α4 / α2 beside the corner", _equal(edge=0)),
            Copy("+ α1 α4 log α2 / (α2 - 1)²", _equal(sign=-1)),
        ),
        losses=(
            _loss("the corner at α2 = α5 = 1 + 1e-4", corner, _equal(), (1.0, 1.0001, 0.0, 1.0, 1.0001), 4),
            _loss("the corner at α2 = α5 = 1 + 1e-8", corner, _equal(), (1.0, 1 + 1e-8, 0.0, 1.0, 1 + 1e-8), 8),
            _loss("the corner at 1 + 2e-16", corner, _equal(), (1.0, NEXT, 0.3, 0.7, NEXT), 16),
        ),
    ),
    _branch(
        5,
        "otherwise",
        "α1 α4 log α2 / ((α2 - α5)(α2 - 1)) - (α1 α4 - α2 α3 + α3 α5) log α5 / ((α2 - α5)(α5 - 1))",
        form=_distinct(),
        cases=_cases(lambda x: x, lambda x: x + mp.mpf(3) / 2),
        copies=(
            Copy("- α3 α5", _distinct(sign=-1)),
            Copy("α5 - 1 for α2 - 1 below log α2", _distinct(swapped=True)),
        ),
        losses=(
            _loss("the corner at α2 = 2, α5 = 2 + 4e-16", corner, _distinct(), (1.0, 2.0, 0.3, 0.7, 2 + 2.0**-51), 16),
            _loss("the corner at α2 = 2, α5 = 2 + 1e-8", corner, _distinct(), (1.0, 2.0, 0.0, 1.0, 2 + 1e-8), 8),
            _loss("beside it at α2 = 2, α5 = 2 + 1e-8", edge, _distinct(), (1.0, 2.0, 0.0, 1.0, 2 + 1e-8), 7),
            _loss("the corner at 1 + 2e-6, 1 + 1e-6", corner, _distinct(), (1.0, 1 + 2e-6, 0.3, 0.7, 1 + 1e-6), 6),
            _loss("the corner at 1 + 2e-8, 1 + 1e-8", corner, _distinct(), (1.0, 1 + 2e-8, 0.3, 0.7, 1 + 1e-8), 9),
        ),
        remark="All branches are divided differences of log; taken as such, near the borders too, nothing is lost.",
    ),
    Claim(
        id="bansal_tatu.A.2.4.cases",
        place="appendix A.2.4, the conditions",
        statement="Of the four conditions at most one holds, and where none does, the last branch has a value.",
        verdict=Verdict.CONFIRMED,
        form=LISTING,
        cases=_all_cases,
        deviation=_off_listing,
        copies=(
            Copy("α2 = α5 without ≠ 1", with_condition(LISTING, 3, lambda a2, a5: a2 == a5)),
            Copy("α2 = 1 without α5 ≠ 1", with_condition(LISTING, 0, lambda a2, a5: a2 == 1)),
            Copy("α2 α5 = 1 for α2 = α5", with_condition(LISTING, 3, lambda a2, a5: a2 * a5 == 1 and a2 != 1)),
        ),
    ),
)
