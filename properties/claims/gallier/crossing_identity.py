"""Section 5: what becomes of strategy 2, and of V, where rotations pass through the identity."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.gallier.inverse_of_v import phi
from affinecert.properties.claims.gallier.strategy_2 import prediction
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.reference import sim3, so3
from affinecert.reference._matrices import Array, Number, cross_matrix, homogeneous, identity, norm


def _winding_cases() -> list[int]:
    return [4, 5, 8]


def _few_turns_lost(form: Number, turns: int) -> Number:
    """How many turns more than one are kept of k_i turns, where the next axis is at this cosine."""
    axis, other = exactly([1, 0, 0]), exactly([form, mp.sqrt(1 - form**2), 0])
    step = (axis, mp.one, turns, other, mp.one)
    return max(abs(prediction(mp.nint)(step)) - 1, 0)


def _whole_turns(quotient: bool) -> Any:
    """(theta + 2 pi k) B / theta for theta = 0, with B_i / theta_i in place of B, or in place of B / theta."""

    def printed(axis: Array, count: Number) -> Array:
        theta, k = mp.zero, mp.nint(count / (2 * mp.pi))
        direction = axis if quotient else axis / theta
        omega: Array = (theta + 2 * mp.pi * k) * direction
        return omega

    return printed


def _not_whole(form: Any, case: tuple[Array, Number]) -> Number:
    """How far the logarithm of I is from one, and from the whole turns nearest to theta'_i."""
    axis, count = case
    found = form(axis, count)
    gap = norm(mp, found - axis * count)
    least = min(abs(2 * mp.pi * k - count) for k in range(-9, 10))
    return difference(so3.exp(mp, found), identity(mp, 3)) + abs(gap - least)


def _counts() -> list[tuple[Array, Number]]:
    return [(exactly([0, 0, 1]), mp.mpf(k)) for k in (1, 5, -8)] + [(exactly([1, 2, 2]) / 3, mp.mpf(20))]


def _v(growth: Number, angle: Number) -> Array:
    omega = cross_matrix(mp, exactly([1, 2, 2]) / 3 * angle)
    return definitions.integral_of_exponential(mp, growth * identity(mp, 3) + omega)


def _not_singular(form: Number, turns: int) -> Number:
    """The determinant of V at so many times this angle, lambda = 0."""
    return abs(definitions.determinant(_v(mp.zero, form * turns)))


def _small_inverse(form: Number, scale: Number) -> Number:
    """By how much the inverse of V, seen along the axis, has no coefficient of 6 or more; at that angle."""
    omega = cross_matrix(mp, exactly([0, 0, 1]) * form)
    v = definitions.integral_of_exponential(mp, mp.log(scale) * identity(mp, 3) + omega)
    return max(6 - size(definitions.inverse(mp, v)), mp.zero)


def _largest_coefficients() -> dict[str, Any]:
    found = {}
    for scale in (1.2, 1.01):
        for name, angle in (("2π", 2 * mp.pi), ("2π/3", 2 * mp.pi / 3)):
            omega = cross_matrix(mp, exactly([0, 0, 1]) * angle)
            v = definitions.integral_of_exponential(mp, mp.log(mp.mpf(scale)) * identity(mp, 3) + omega)
            found[f"scale {scale}, angle {name}"] = float(size(definitions.inverse(mp, v)))
    return found


def _meets_no_singular(form: Number, bodies: int) -> int:
    """0 if strategy 2 comes to a singular V among so many bodies, each turned 2 pi/3 further, of that scale."""
    axis = exactly([0, 0, 1])
    before = exactly([0] * 7)
    for k in range(bodies):
        turn = so3.exp(mp, axis * (2 * mp.pi * k / 3)) * form
        before = sim3.log_near(mp, homogeneous(mp, turn, exactly([0, 0, 2 * k])), before)
        if abs(phi(mp.mpc(before[6], norm(mp, before[:3])))) < mp.mpf(10) ** -30:
            return 0
    return 1


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.5.strategy_2.winding",
        place="section 5, after k by k_i",
        statement="If c is small, k_{i+1} can be a lot smaller than k_i: between axes that are orthogonal all turns "
        "but one are lost.",
        verdict=Verdict.CONFIRMED,
        form=mp.zero,
        cases=_winding_cases,
        deviation=_few_turns_lost,
        copies=(Copy("axes at 60 degrees, c = 1/2", mp.mpf(1) / 2),),
        remark="The curve unwinds these turns on its way, whatever the rotations are.",
    ),
    Claim(
        id="gallier.5.strategy_2.identity",
        place="section 5, strategy 2, θ_{i+1} = 0",
        statement="Where R_{i+1} = I, the logarithm of R_i over θ_i takes the place of that of R_{i+1}, and k_{i+1} is "
        "found as before.",
        printed="we replace 𝓑_{i+1} = 0 by 𝓑_i/θ_i, and find k_{i+1} as above (in this case, θ_{i+1} = 0)",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_whole_turns(quotient=False),
        cases=_counts,
        deviation=_not_whole,
        correction=Correction(
            statement="It takes the place of 𝓑_{i+1}/θ_{i+1}: B_{i+1} = 2πk_{i+1} 𝓑_i/θ_i with k_{i+1} the integer "
            "nearest to θ'_i/2π. Put for 𝓑_{i+1} it is divided by θ_{i+1} = 0.",
            form=_whole_turns(quotient=True),
        ),
        copies=(Copy("k one too large", lambda axis, count: _whole_turns(quotient=True)(axis, count + 2 * mp.pi)),),
        remark="Where R_i = I too, there is no axis to go on with.",
    ),
    Claim(
        id="gallier.5.strategy_2.singular",
        place="section 5, crossing I",
        statement="V is singular if θ'_i is a multiple of 2π, other than 0, and λ_i = 0.",
        verdict=Verdict.CONFIRMED,
        form=2 * mp.pi,
        cases=lambda: [1, -1, 3],
        deviation=_not_singular,
        copies=(Copy("a multiple of π", mp.pi),),
    ),
    Claim(
        id="gallier.5.strategy_2.large_inverse",
        place="section 5, crossing I",
        statement="Where θ'_i is a multiple of 2π and λ_i ≠ 0, the inverse of V tends to have large coefficients: "
        "2π/(α - 1) for one turn, more than 6 for scales α from 1/2 to 2.",
        verdict=Verdict.CONFIRMED,
        form=2 * mp.pi,
        cases=lambda: [mp.mpf(scale) for scale in (0.5, 0.75, 1.01, 1.5, 2)],
        deviation=_small_inverse,
        copies=(Copy("an angle of π", mp.pi), Copy("an angle of 5π/3", 5 * mp.pi / 3)),
        numbers=_largest_coefficients,
        remark="The bound of 6 is ours. That such motions wind is told of no example with numbers.",
    ),
    Claim(
        id="gallier.6.strategy_2",
        place="section 6 (also section 4, last paragraph)",
        statement="With strategy 2 V is often singular when angles cross multiples of 2π: at every third body, for "
        "one, of a screw motion by 2π/3 each time without growth.",
        verdict=Verdict.CONFIRMED,
        form=mp.one,
        cases=lambda: [4, 7, 10],
        deviation=_meets_no_singular,
        copies=(Copy("bodies scaled by 1.5", mp.mpf(1.5)),),
        remark="A translation along the axis, as that of the screw motion is, has a v all the same.",
    ),
)
