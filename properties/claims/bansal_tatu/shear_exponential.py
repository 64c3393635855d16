"""Appendix A.2.3: the exponential on G_A in five branches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from affinecert.properties.claims import definitions
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
from affinecert.properties.claims.precision import equals, exactly, mp
from affinecert.reference import shear
from affinecert.reference._matrices import Array, Context, Number, array


def _last_only(power: int = 2, sign: int = 1) -> Branch:
    def printed(m: Context, a1: Number, _: Number, a3: Number, a4: Number, a5: Number) -> Array:
        e = m.exp(a5)
        corner = (a1 * a4 * e + a3 * a5 * e - sign * a1 * a4 * a5 - a1 * a4 - a3 * a5) / a5**power
        return array([[1, a1, corner], [0, 1, a4 * (e - 1) / a5], [0, 0, e]])

    return printed


def _middle_only(power: int = 2, factor: int = 1) -> Branch:
    def printed(m: Context, a1: Number, a2: Number, a3: Number, a4: Number, _: Number) -> Array:
        e = m.exp(a2)
        corner = (a1 * a4 * e - a1 * (factor + a2) * a4 + a2**power * a3) / a2**2
        return array([[1, a1 * (e - 1) / a2, corner], [0, e, a4 * (e - 1) / a2], [0, 0, 1]])

    return printed


def _unipotent(divisor: int = 2) -> Branch:
    def printed(_: Context, a1: Number, __: Number, a3: Number, a4: Number, ___: Number) -> Array:
        return array([[1, a1, a3 + a1 * a4 / divisor], [0, 1, a4], [0, 0, 1]])

    return printed


def _equal(sign: int = 1, edge: int = 1) -> Branch:
    def printed(m: Context, a1: Number, a2: Number, a3: Number, a4: Number, _: Number) -> Array:
        e = m.exp(a2)
        corner = (((a1 * a4 + a3) * a2 - a1 * a4) * e + sign * a1 * a4 - a2 * a3) / a2**2
        return array([[1, a1 * (e - 1) / a2, corner], [0, e, a4 * e**edge], [0, 0, e]])

    return printed


def _distinct(sign: int = 1, *, swapped: bool = False) -> Branch:
    def printed(m: Context, a1: Number, a2: Number, a3: Number, a4: Number, a5: Number) -> Array:
        e2, e5 = m.exp(a2), m.exp(a5)
        first, second = (e2, e5) if swapped else (e5, e2)
        mixed = a1 * a4 - a2 * a3
        corner = -a2 * (mixed + a3 * a5) * first + a1 * a4 * a5 * second + sign * (a2 - a5) * mixed
        edge = a4 * ((e2 - e5) / (a2 - a5))
        return array([[1, a1 * (e2 - 1) / a2, corner / (a2 * a5 * (a2 - a5))], [0, e2, edge], [0, 0, e5]])

    return printed


LISTING: Listing = (
    (lambda a2, a5: a2 == 0 and a5 != 0, _last_only()),
    (lambda a2, a5: a5 == 0 and a2 != 0, _middle_only()),
    (lambda a2, a5: a2 == 0 and a5 == 0, _unipotent()),
    (lambda a2, a5: a2 == a5 and a2 != 0, _equal()),
    (lambda a2, a5: True, _distinct()),
)
"""The conditions and branches in the order of print; the last is 'otherwise'."""


def _exponential(m: Context, *alpha: Number) -> Array:
    return definitions.exponential(m, shear.matrix(m, array(alpha), m.zero))


def _off_listing(listing: Listing, alpha: Parameters) -> Any:
    return equals(_exponential)(lambda m, *given: by_cases(m, listing, *given), alpha)


def _cases(a2: Callable[[Number], Number], a5: Callable[[Number], Number]) -> Callable[[], Sequence[Parameters]]:
    """Parameters with given a2 and a5, functions of a drawn number that is not 0."""

    def cases() -> Sequence[Parameters]:
        simple = exactly([1, 0, 0, 1, 1]), exactly([0, 0, 1, 0, -1]), exactly([1, 0, 1, 1, 2])
        drawn = [each for each in arrays("shear twists", 6, (5,), -2, 2) if each[4]]
        return [(a1, a2(x), a3, a4, a5(x)) for a1, _, a3, a4, x in (*simple, *drawn)]

    return cases


def _all_cases() -> Sequence[Parameters]:
    """Every pair of signs and zeros of a2 and a5, and near zero and each other."""
    small = mp.mpf(2) ** -30
    stretches = [exactly(0), exactly(1), exactly(-1), small, 1 + small]
    return [(mp.one, a2, mp.mpf(2), mp.mpf(3), a5) for a2 in stretches for a5 in stretches]


def _loss(where: str, entry: Callable[[Branch], Callable[..., Number]], branch: Branch, at: Any, digits: int) -> Loss:
    return Loss(where=where, formula=entry(branch), truth=entry(_exponential), at=at, digits=digits)


def _branch(number: int, condition: str, printed: str, **rest: Any) -> Claim[Any, Any]:
    return Claim(
        id=f"bansal_tatu.A.2.3.branch_{number}",
        place=f"appendix A.2.3, branch {number}",
        statement=f"The exponential of a twist of shear, {condition}.",
        printed=f"corner {printed}",
        verdict=Verdict.CONFIRMED,
        deviation=equals(_exponential),
        **rest,
    )


CLAIMS: tuple[Claim[Any, Any], ...] = (
    _branch(
        1,
        "if α2 = 0 and α5 ≠ 0",
        "(α1 α4 e^α5 + α3 α5 e^α5 - α1 α4 α5 - α1 α4 - α3 α5) / α5²",
        form=_last_only(),
        cases=_cases(lambda x: mp.zero, lambda x: x),
        copies=(
            Copy("α5 for α5² below the corner", _last_only(power=1)),
            Copy("+ α1 α4 α5", _last_only(sign=-1)),
        ),
        losses=(
            _loss("the corner at α5 = 1e-4", corner, _last_only(), (1.0, 0.0, 0.0, 1.0, 1e-4), 8),
            _loss("the corner at α5 = 1e-8", corner, _last_only(), (1.0, 0.0, 0.0, 1.0, 1e-8), 16),
            _loss("beside the corner at α5 = 1e-8", edge, _last_only(), (1.0, 0.0, 0.0, 1.0, 1e-8), 8),
        ),
    ),
    _branch(
        2,
        "if α5 = 0 and α2 ≠ 0",
        "(α1 α4 e^α2 - α1 (1 + α2) α4 + α2² α3) / α2²",
        form=_middle_only(),
        cases=_cases(lambda x: x, lambda x: mp.zero),
        copies=(
            Copy("α2 α3 for α2² α3", _middle_only(power=1)),
            Copy("2 + α2 for 1 + α2", _middle_only(factor=2)),
        ),
        losses=(
            _loss("the corner at α2 = 1e-4", corner, _middle_only(), (1.0, 1e-4, 0.0, 1.0, 0.0), 8),
            _loss("the corner at α2 = 1e-8", corner, _middle_only(), (1.0, 1e-8, 0.0, 1.0, 0.0), 16),
        ),
    ),
    _branch(
        3,
        "if α2 = 0 and α5 = 0",
        "α3 + α1 α4 / 2",
        form=_unipotent(),
        cases=_cases(lambda x: mp.zero, lambda x: mp.zero),
        copies=(Copy("α1 α4 / 3", _unipotent(3)),),
    ),
    _branch(
        4,
        "if α2 = α5 ≠ 0",
        "(((α1 α4 + α3) α2 - α1 α4) e^α2 + α1 α4 - α2 α3) / α2²",
        form=_equal(),
        cases=_cases(lambda x: x, lambda x: x),
        copies=(
            Copy("- α1 α4 for + α1 α4", _equal(sign=-1)),
            Copy("α4 for α4 e^α2 beside the corner", _equal(edge=0)),
        ),
        losses=(
            _loss("the corner at α2 = α5 = 1e-4", corner, _equal(), (1.0, 1e-4, 0.0, 1.0, 1e-4), 8),
            _loss("the corner at α2 = α5 = 1e-8", corner, _equal(), (1.0, 1e-8, 0.0, 1.0, 1e-8), 16),
        ),
    ),
    _branch(
        5,
        "otherwise",
        "(-α2 (α1 α4 - α2 α3 + α3 α5) e^α5 + α1 α4 α5 e^α2 + (α2 - α5)(α1 α4 - α2 α3)) / (α2 α5 (α2 - α5))",
        form=_distinct(),
        cases=_cases(lambda x: x, lambda x: 1 + x / 2 if x != 2 else mp.one),
        copies=(
            Copy("- (α2 - α5)", _distinct(sign=-1)),
            Copy("e^α2 and e^α5 exchanged in the corner", _distinct(swapped=True)),
        ),
        losses=(
            _loss("the corner at α2 = 1, α5 = 1 + 1e-8", corner, _distinct(), (1.0, 1.0, 0.0, 1.0, 1 + 1e-8), 8),
            _loss("the corner at α2 = 1, α5 = 1 + 2e-16", corner, _distinct(), (1.0, 1.0, 0.3, 0.7, 1 + 2.0**-52), 15),
            _loss("beside it at α2 = 1, α5 = 1 + 1e-8", edge, _distinct(), (1.0, 1.0, 0.0, 1.0, 1 + 1e-8), 7),
            _loss("the corner at α2 = 1e-8, α5 = 1", corner, _distinct(), (1.0, 1e-8, 0.0, 1.0, 1.0), 8),
            _loss("the corner at α2 = 2e-6, α5 = 1e-6", corner, _distinct(), (1.0, 2e-6, 0.3, 0.7, 1e-6), 12),
            _loss("the corner at α2 = 2e-8, α5 = 1e-8", corner, _distinct(), (1.0, 2e-8, 0.3, 0.7, 1e-8), 16),
        ),
        remark="All branches are divided differences of exp; taken as such, near the borders too, nothing is lost.",
    ),
    Claim(
        id="bansal_tatu.A.2.3.cases",
        place="appendix A.2.3, the conditions",
        statement="Of the four conditions at most one holds, and where none does, the last branch has a value.",
        verdict=Verdict.CONFIRMED,
        form=LISTING,
        cases=_all_cases,
        deviation=_off_listing,
        copies=(
            Copy("α2 = α5 without ≠ 0", with_condition(LISTING, 3, lambda a2, a5: a2 == a5)),
            Copy("α2 = 0 without α5 ≠ 0", with_condition(LISTING, 0, lambda a2, a5: a2 == 0)),
            Copy("α2 = -α5 for α2 = α5", with_condition(LISTING, 3, lambda a2, a5: a2 == -a5 and a2 != 0)),
        ),
        remark="The conditions exclude each other, so their order does not matter. They are exact: near them, branch 5 "
        "runs, and is lost.",
    ),
)
