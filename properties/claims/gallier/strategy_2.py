"""Section 5: strategy 2, which keeps count of turns, and what becomes of V then."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.gallier.rotation_logarithms import phi
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.reference import sim3, so3
from affinecert.reference._matrices import Array, Number, cross_matrix, dot, homogeneous, identity, norm

Step = tuple[Array, Number, int, Array, Number]
"""The axis, the principal angle and the turns k_i of one logarithm, and the axis and principal angle of the next."""


def _steps() -> list[Step]:
    x, y = exactly([1, 0, 0]), exactly([0, 1, 0])
    oblique, other = exactly([1, 2, 2]) / 3, exactly([2, -1, 2]) / 3
    third = exactly([2, 3, 6]) / 7
    return [
        (x, mp.one, 0, x, mp.mpf(2)),
        (x, mp.mpf(3), 2, x, mp.one),
        (x, mp.mpf(2), 1, -x, mp.mpf(3)),
        (x, mp.mpf(3), 4, y, mp.one),
        (oblique, mp.mpf(2), 3, third, mp.mpf(1) / 2),
        (oblique, mp.mpf(3), -2, other, mp.mpf(3)),
        (third, mp.mpf(1) / 4, 5, oblique, mp.mpf(3)),
    ]


def _count(step: Step) -> Number:
    """The angle theta'_i = theta_i + 2 pi k_i."""
    return step[1] + 2 * mp.pi * step[2]


def _before(step: Step) -> Array:
    """B_i."""
    return cross_matrix(mp, step[0] * _count(step))


def _principals(step: Step) -> tuple[Array, Array]:
    """The principal logarithms of both rotations."""
    return cross_matrix(mp, step[0] * step[1]), cross_matrix(mp, step[3] * step[4])


def _f(step: Step, k: Number) -> Number:
    """f(k) as it is defined: -tr (B_i - (theta + 2 pi k) B / theta)^2."""
    gap = _before(step) - (step[4] + 2 * mp.pi * k) * cross_matrix(mp, step[3])
    return -(gap @ gap).trace()


def _slope(step: Step, k: Number) -> Number:
    """The derivative of f, which is quadratic, by a central difference: exact."""
    return (_f(step, k + 1) - _f(step, k - 1)) / 2


def _misses(truth: Callable[[Step, Number], Number]) -> Any:
    def deviation(form: Any, step: Step) -> Number:
        return max(abs(form(step, mp.mpf(k)) - truth(step, mp.mpf(k))) for k in (-2, 0, 1, 5))

    return deviation


def _expanded(sign: int) -> Any:
    def printed(step: Step, k: Number) -> Number:
        before, (_, principal), theta = _before(step), _principals(step), step[4]
        angle = theta + 2 * mp.pi * k
        mixed = 2 * (before @ principal).trace() * angle / theta
        return -(before @ before).trace() + sign * mixed - angle**2 * (principal @ principal).trace() / theta**2

    return printed


def _derivative(factor: int) -> Any:
    def printed(step: Step, k: Number) -> Number:
        before, (_, principal), theta = _before(step), _principals(step), step[4]
        mixed = (before @ principal).trace() * 4 * mp.pi / theta
        return mixed + theta * factor * mp.pi + k * 16 * mp.pi**2

    return printed


def cosine(step: Step) -> Number:
    """The cosine of the angle between the axes."""
    return dot(mp, step[0], step[3])


def _derivative_by_cosine(sign: int) -> Any:
    def printed(step: Step, k: Number) -> Number:
        return sign * 8 * mp.pi * cosine(step) * _count(step) + step[4] * 8 * mp.pi + k * 16 * mp.pi**2

    return printed


def _cosines(counted: bool = True) -> Any:
    """C by B_i and theta'_i (or theta_i), and c by both principal logarithms."""

    def printed(step: Step) -> tuple[Number, Number]:
        first, second = _principals(step)
        angle = _count(step) if counted else step[1]
        by_count = -(_before(step) @ second).trace() / (2 * angle * step[4])
        return by_count, -(first @ second).trace() / (2 * step[1] * step[4])

    return printed


def _cosine_misses(form: Any, step: Step) -> Number:
    return max(abs(each - cosine(step)) for each in form(step))


def _root(sign: int) -> Any:
    """(c theta'_i - theta) / 2 pi."""

    def printed(step: Step) -> Number:
        return (cosine(step) * _count(step) + sign * step[4]) / (2 * mp.pi)

    return printed


def _root_by_turns(with_cosine: bool) -> Any:
    """C k_i + (c theta_i - theta) / 2 pi."""

    def printed(step: Step) -> Number:
        c = cosine(step)
        return (c if with_cosine else 1) * step[2] + (c * step[1] - step[4]) / (2 * mp.pi)

    return printed


def _no_root(form: Any, step: Step) -> Number:
    return abs(_slope(step, form(step)))


def _prediction(rounding: Any) -> Any:
    def printed(step: Step) -> int:
        return int(rounding(_root(-1)(step)))

    return printed


def _not_least(form: Any, step: Step) -> Number:
    """By how much f is larger at the integer predicted than at the best one."""
    return _f(step, form(step)) - min(_f(step, k) for k in range(-12, 13))


def _winding_cases() -> list[int]:
    return [4, 5, 8]


def _few_turns_lost(form: Number, turns: int) -> Number:
    """How many turns too few are lost, of k_i turns, next to an axis at this cosine: all but one are to be."""
    axis, other = exactly([1, 0, 0]), exactly([form, mp.sqrt(1 - form**2), 0])
    step = (axis, mp.one, turns, other, mp.one)
    return max(turns - 1 - (turns - abs(_prediction(mp.nint)(step))), 0)


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
        id="gallier.5.strategy_2.expansion",
        place="section 5, f(k), and -tr(B²/θ²) = 2 below it",
        statement="f(k) = -tr(B_i - (θ + 2πk)B/θ)² expanded.",
        printed="f(k) = -tr(B_i²) + 2 tr(B_i B)(θ + 2πk)/θ - (θ + 2πk)² tr(B²/θ²)",
        verdict=Verdict.CONFIRMED,
        form=_expanded(1),
        cases=_steps,
        deviation=_misses(_f),
        copies=(Copy("- for + before 2 tr(B_i B)", _expanded(-1)),),
    ),
    Claim(
        id="gallier.5.strategy_2.derivative",
        place="section 5, f'(k)",
        statement="The derivative of f.",
        printed="f'(k) = tr(B_i B) 4π/θ + 8πθ + 16π²k",
        verdict=Verdict.CONFIRMED,
        form=_derivative(8),
        cases=_steps,
        deviation=_misses(_slope),
        copies=(Copy("4πθ for 8πθ", _derivative(4)),),
    ),
    Claim(
        id="gallier.5.strategy_2.cosine",
        place="section 5, c",
        statement="c is the scalar product of the unit vectors of both axes, by B_i and θ'_i or by the principal "
        "logarithm and θ_i.",
        printed="c = -(1/2) tr(B_i B_{i+1}/(θ'_i θ_{i+1})) = -(1/2) tr(𝓑_i 𝓑_{i+1}/(θ_i θ_{i+1}))",
        verdict=Verdict.CONFIRMED,
        form=_cosines(),
        cases=_steps,
        deviation=_cosine_misses,
        copies=(Copy("B_i with θ_i for θ'_i", _cosines(counted=False)),),
    ),
    Claim(
        id="gallier.5.strategy_2.derivative_by_cosine",
        place="section 5, f'(k) by c",
        statement="The derivative of f, by c.",
        printed="f'(k) = -8πcθ'_i + 8πθ_{i+1} + 16π²k",
        verdict=Verdict.CONFIRMED,
        form=_derivative_by_cosine(-1),
        cases=_steps,
        deviation=_misses(_slope),
        copies=(Copy("+ for - before 8πcθ'_i", _derivative_by_cosine(1)),),
    ),
    Claim(
        id="gallier.5.strategy_2.root",
        place="section 5, f'(k) = 0",
        statement="f is least, over real k, at (cθ'_i - θ_{i+1})/2π.",
        printed="k = (cθ'_i - θ_{i+1})/2π",
        verdict=Verdict.CONFIRMED,
        form=_root(-1),
        cases=_steps,
        deviation=_no_root,
        copies=(Copy("+ for - before θ_{i+1}", _root(1)),),
    ),
    Claim(
        id="gallier.5.strategy_2.root_by_turns",
        place="section 5, k by k_i",
        statement="The same by k_i.",
        printed="k = ck_i + (cθ_i - θ_{i+1})/2π",
        verdict=Verdict.CONFIRMED,
        form=_root_by_turns(with_cosine=True),
        cases=_steps,
        deviation=_no_root,
        copies=(Copy("k_i for ck_i", _root_by_turns(with_cosine=False)),),
    ),
    Claim(
        id="gallier.5.strategy_2.prediction",
        place="section 5, after k by k_i",
        statement="The formula predicts k_{i+1}: f being quadratic, its best integer is the one nearest to the root.",
        verdict=Verdict.CONFIRMED,
        form=_prediction(mp.nint),
        cases=_steps,
        deviation=_not_least,
        copies=(Copy("the integer below the root", _prediction(mp.floor)),),
        remark="Half way between two integers both are best; the paper leaves the choice open.",
    ),
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
