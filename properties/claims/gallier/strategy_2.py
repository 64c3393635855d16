"""Section 5: how strategy 2 finds the number of turns."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference._matrices import Array, Number, cross_matrix, dot

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


def prediction(rounding: Any) -> Any:
    """The integer k_(i+1) that the root of f' is rounded to."""

    def printed(step: Step) -> int:
        return int(rounding(_root(-1)(step)))

    return printed


def _not_least(form: Any, step: Step) -> Number:
    """By how much f is larger at the integer predicted than at the best one."""
    return _f(step, form(step)) - min(_f(step, k) for k in range(-12, 13))


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
        form=prediction(mp.nint),
        cases=_steps,
        deviation=_not_least,
        copies=(Copy("the integer below the root", prediction(mp.floor)),),
        remark="Half way between two integers both are best; the paper leaves the choice open.",
    ),
)
