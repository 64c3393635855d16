"""Section 4, last paragraph: how well V is conditioned for principal logarithms."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import mp
from affinecert.reference._matrices import Number


def condition(growth: Number, angle: Number) -> Number:
    """The condition number of V, a normal matrix: the ratio of its eigenvalues' absolute values."""
    first, second = (abs(phi(z)) for z in (growth, mp.mpc(growth, angle)))
    return max(first, second) / min(first, second)


def phi(z: Number) -> Number:
    """(e^z - 1) / z, and 1 for 0."""
    return (mp.exp(z) - 1) / z if z else mp.one


def _growths_and_angles() -> list[tuple[Number, Number]]:
    growths = [mp.zero, mp.one, -mp.one, mp.mpf(1) / 100, mp.mpf(-20)]
    return [(growth, mp.pi * part / 8) for growth in growths for part in range(9)]


def _worse(form: Number, case: tuple[Number, Number]) -> Number:
    return max(condition(*case) - form - mp.mpf(10) ** -60, mp.zero)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.4.inverse",
        place="section 4, last paragraph (also section 6)",
        statement="For principal logarithms V is invertible, and its inverse makes no numerical trouble: for angles up "
        "to π the condition number of V is at most π/2, whatever λ is.",
        printed="the matrix V is invertible and we never encountered numerical problems computing the inverse of V",
        verdict=Verdict.CONFIRMED,
        form=mp.pi / 2,
        cases=_growths_and_angles,
        deviation=_worse,
        copies=(Copy("3/2 for π/2", mp.mpf(3) / 2),),
        remark="π/2 is ours; the paper gives no bound.",
    ),
)
