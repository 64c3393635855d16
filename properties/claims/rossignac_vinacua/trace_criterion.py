"""Section 5.1: the trace of a 2 by 2 matrix, which tells whether it has a real logarithm."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import exactly, mp
from affinecert.properties.claims.rossignac_vinacua.reduction import exists
from affinecert.reference._matrices import Array, Context, Number, identity


def _half_trace(m: Context, linear: Array, sign: int = -1) -> tuple[Number, Number]:
    """Half the trace, and d_L as printed."""
    half = (linear[0, 0] + linear[1, 1]) / 2
    return half, half**2 + sign * (linear[0, 0] * linear[1, 1] - linear[0, 1] * linear[1, 0])


def _bad(factor: int = 2, sign: int = -1) -> Any:
    def condition(linear: Array) -> bool:
        half, d = _half_trace(mp, linear, sign)
        return bool(d >= 0 and 2 * half <= -factor * mp.sqrt(d))

    return condition


def _plane_maps() -> list[Array]:
    simple = [[[-1, 0], [0, -2]], [[-1, 0], [0, -9]], [[1, 0], [0, 2]], [[0, -1], [1, 0]], [[-1, 1], [0, -1]]]
    drawn = [each for each in arrays("plane", 60, (2, 2), -3, 3) if definitions.determinant(each) > 0]
    return [exactly(each) for each in simple] + drawn


def _decided_otherwise(condition: Any, linear: Array) -> int:
    return int(condition(linear) is exists(linear))


def _roots(sign: int = -1) -> Any:
    def eigenvalues(linear: Array) -> tuple[Number, ...]:
        half, d = _half_trace(mp, linear, sign)
        return half + mp.sqrt(d), half - mp.sqrt(d)

    return eigenvalues


def _no_eigenvalues(roots: Any, linear: Array) -> Number:
    return max(abs(definitions.determinant(linear - root * identity(mp, 2))) for root in roots(linear))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.5.1.bad_trace",
        place="section 5.1",
        statement="Apart from multiples of a half turn, an orientation-preserving 2 by 2 matrix has no real logarithm "
        "if and only if d_L >= 0 and trace(L) <= -2 sqrt(d_L).",
        printed="d_L ≥ 0, trace(L) ≤ -2 √d_L, d_L = (trace(L) / 2)² - det(L)",
        verdict=Verdict.CONFIRMED,
        form=_bad(),
        cases=_plane_maps,
        deviation=_decided_otherwise,
        copies=(
            Copy("-4 √d_L for -2 √d_L", _bad(factor=4)),
            Copy("(trace(L) / 2)² + det(L) for d_L", _bad(sign=1)),
        ),
        remark="With det > 0 and d_L >= 0 the sign of the trace alone decides; the comparison with sqrt(d_L) adds "
        "nothing but rounding.",
    ),
    Claim(
        id="rossignac_vinacua.5.1.d_L",
        place="section 5.1",
        statement="The eigenvalues of a 2 by 2 matrix are trace(L)/2 ± sqrt(d_L).",
        printed="d_L = (trace(L) / 2)² - det(L)",
        verdict=Verdict.CONFIRMED,
        form=_roots(),
        cases=_plane_maps,
        deviation=_no_eigenvalues,
        copies=(Copy("+ det(L) for - det(L)", _roots(1)),),
        remark="The paper calls d_L the discriminant of the characteristic polynomial, of which it is a quarter.",
        losses=(
            Loss(
                where="d_L of a symmetric matrix next to the identity: ((l11 - l22) / 2)² + l12 l21 loses nothing",
                formula=lambda m, linear: _half_trace(m, linear)[1],
                truth=lambda m, linear: ((linear[0, 0] - linear[1, 1]) / 2) ** 2 + linear[0, 1] * linear[1, 0],
                at=([[1, 1e-9], [1e-9, 1]],),
                digits=16,
            ),
        ),
    ),
)
