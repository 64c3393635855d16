"""Section 5: strategy 1 for the logarithms of rotations, and what it says of V."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.gallier.inverse_of_v import condition
from affinecert.properties.claims.precision import difference, exactly, mp
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Number, norm

Choice = Callable[[Array, Array], Array]
"""Which rotation vector to take, of the one before and the principal one."""


def second_choice(w: Array, sign: int = -1) -> Array:
    """-(2 pi - theta) B' / theta, the other logarithm of strategy 1."""
    theta = norm(mp, w)
    other: Array = sign * (2 * mp.pi - theta) * w / theta
    return other


def strategy_1(before: Array, w: Array) -> Array:
    """Strategy 1: of the principal logarithm and the other one the nearer one; 0 for no rotation."""
    if not any(w):
        return w
    return min((w, second_choice(w)), key=lambda vector: norm(mp, vector - before))


def strategy_2(before: Array, w: Array) -> Array:
    """Strategy 2: of all logarithms the nearest one, where there is a rotation."""
    theta = norm(mp, w)
    if not theta:
        return so3.log_near(mp, so3.exp(mp, w), before)
    return min(_all(w), key=lambda vector: norm(mp, vector - before))


def _all(w: Array) -> list[Array]:
    """Logarithms of the same rotation as that of w, which is no multiple of whole turns."""
    return [w * (1 + 2 * mp.pi * k / norm(mp, w)) for k in range(-5, 6)]


def _other_misses(form: Any, case: tuple[Array]) -> Number:
    return difference(so3.exp(mp, form(*case)), so3.exp(mp, *case))


def _principal_vectors() -> list[tuple[Array]]:
    return [(v,) for v in (exactly(each) for each in ([1, 0, 0], [0, 0, 3], [1, 2, 2], [-1, 1, 2]))]


def _steps() -> list[tuple[Array, Array]]:
    """Principal rotation vectors, the one before and the one to choose for."""
    z, none = exactly([0, 0, 1]), exactly([0, 0, 0])
    third = 2 * mp.pi / 3
    simple = [(z * third, -z * third), (z, z * 2), (z * 3, none), (z * 3, z * -3), (z * 3, z / -4), (none, z * 3)]
    drawn = zip(arrays("before", 6, (3,), -1.75, 1.75), arrays("then", 6, (3,), -1.75, 1.75), strict=True)
    return simple + list(drawn)


def _not_nearest(form: Choice, case: tuple[Array, Array]) -> Number:
    """By how much a logarithm is farther from the one before than the nearest one of all; what is no rotation is 0."""
    before, w = case
    others = _all(w) if any(w) else [w, *_all(before * 2 * mp.pi / norm(mp, before))]
    least = min(norm(mp, other - before) for other in others)
    return norm(mp, form(before, w) - before) - least


def _angle_range(form: Number, case: tuple[Array, Array]) -> Number:
    """By how much the angle of the logarithm of strategy 1 is beyond that given, if it is."""
    return max(norm(mp, strategy_1(*case)) - form + mp.mpf(10) ** -60, mp.zero) if any(case[1]) else mp.zero


def _chosen_angles() -> list[tuple[Array, Array]]:
    """As before, with one whose angle comes near to 2 pi: from next to a half turn to a small one back."""
    z = exactly([0, 0, 1])
    return [*_steps(), (-z * (mp.pi - mp.mpf(1) / 1000), z / 500)]


def _kept() -> list[tuple[Array, Array, Number]]:
    """Steps for which strategy 1 takes the principal logarithm, and lambda."""
    steps = [case for case in _steps() if difference(strategy_1(*case), case[1]) == 0]
    return [(*case, growth) for case in steps for growth in (mp.zero, mp.one)]


def _not_kept() -> list[tuple[Array, Array, Number]]:
    """Steps for which it takes the other one, lambda = 0."""
    steps = [case for case in _chosen_angles() if difference(strategy_1(*case), case[1])]
    z = exactly([0, 0, 1])
    return [(*case, mp.zero) for case in [*steps, (z * 3, -z * (mp.pi - mp.mpf(1) / 1000))]]


def _badly_conditioned(form: Number, case: tuple[Array, Array, Number]) -> Number:
    before, w, growth = case
    return max(condition(growth, norm(mp, strategy_1(before, w))) - form - mp.mpf(10) ** -60, mp.zero)


def _conditions() -> dict[str, Any]:
    return {f"angle 2π - {gap:g}": float(condition(mp.zero, 2 * mp.pi - gap)) for gap in (1, 0.01, 0.0001)}


def _one_axis() -> list[list[Number]]:
    """Angles of rotations about one axis, each less than pi further."""
    third = mp.pi / 3
    return [[2 * third, 4 * third, 5 * third], [mp.mpf(k) for k in (1, 3, 4, 6)], [third * k for k in range(10)]]


def _goes_round(form: Any, angles: Sequence[Number]) -> Number:
    """By how much the lines of a strategy, from its logarithm of one rotation to that of the next, are too long.

    The form says which logarithm is taken next, and whether the next choice starts from that or from the principal one.
    """
    choose, goes_on = form
    axis = exactly([2, 1, 2]) / 3
    logs = [so3.log(mp, so3.exp(mp, axis * angle)) for angle in angles]
    before, worst = logs[0], mp.zero
    for w, previous, angle in zip(logs[1:], angles, angles[1:], strict=False):
        chosen = choose(before, w)
        worst = max(worst, abs(norm(mp, chosen - before) - (angle - previous)))
        before = chosen if goes_on else w
    return worst


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.5.strategy_1.other",
        place="section 5, strategy 1",
        statement="-(2π - θ)B'/θ is a logarithm of the same rotation as the principal one, B' of angle θ.",
        printed="B'' = -(2π - θ) B'/θ",
        verdict=Verdict.CONFIRMED,
        form=second_choice,
        cases=_principal_vectors,
        deviation=_other_misses,
        copies=(Copy("+ for -", lambda w: second_choice(w, 1)),),
    ),
    Claim(
        id="gallier.5.strategy_1.nearest",
        place="section 5, strategy 1",
        statement="Of a rotation's logarithms one of B' and B'', 0 for R = I, is the nearest one of all to a principal "
        "logarithm B_i.",
        printed="pick the matrix B_{i+1} among B' and B'' which minimizes -(1/2) tr((B_{i+1} - B_i)²)",
        verdict=Verdict.CONFIRMED,
        form=strategy_1,
        cases=_steps,
        deviation=_not_nearest,
        copies=(
            Copy("the principal logarithm", lambda before, w: w),
            Copy("the farther one of the two", lambda b, w: second_choice(w) if any(w) and w @ b > 0 else w),
        ),
        remark="It starts from the principal B_i even where Y_i was taken, so that a motion reversed need not have the "
        "same logarithms. Ties are left open: a half turn has two principal logarithms.",
    ),
    Claim(
        id="gallier.5.strategy_1.intended",
        place="section 5, strategy 1",
        statement="With strategy 1 rotations do not go the long way: about one axis, by less than π each time.",
        verdict=Verdict.CONFIRMED,
        form=(strategy_1, False),
        cases=_one_axis,
        deviation=_goes_round,
        copies=(
            Copy("principal logarithms", (lambda before, w: w, False)),
            Copy("strategy 1 from the logarithm that was taken, not from the principal one", (strategy_1, True)),
        ),
    ),
    Claim(
        id="gallier.5.strategy_2.intended",
        place="section 5, strategy 2",
        statement="With strategy 2 rotations do not go the long way: about one axis, by less than π each time.",
        verdict=Verdict.CONFIRMED,
        form=(strategy_2, True),
        cases=_one_axis,
        deviation=_goes_round,
        copies=(Copy("strategy 1 in its place", (strategy_1, True)),),
    ),
    Claim(
        id="gallier.5.strategy_1.range",
        place="section 5, last paragraph, and section 6",
        statement="The angles of strategy 1 are in [0, π].",
        printed="the angles are in the range [0, π]",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=mp.pi,
        cases=_chosen_angles,
        deviation=_angle_range,
        correction=Correction(
            statement="They are in [0, 2π): those of the X in [0, π], those of a Y ≠ X in [π, 2π), as near to 2π as "
            "one likes.",
            form=2 * mp.pi,
        ),
        copies=(Copy("[0, 2π - 1/400)", 2 * mp.pi - mp.mpf(1) / 400),),
        remark="The paper's own B'_2 has the angle 4π/3.",
    ),
    Claim(
        id="gallier.6.invertible",
        place="section 6, the first task",
        statement="As the angles are in [0, π], V is always invertible, without any problem: its condition number is "
        "at most π/2.",
        printed="because we only deal with angles in [0, π], the matrix V is always invertible, without any problem",
        verdict=Verdict.BOUND,
        domain="poses at which strategy 1 takes the principal logarithm. At the others the angle is in (π, 2π), and V "
        "is invertible, but for λ = 0 its condition number (θ/2)/sin(θ/2) has no bound",
        form=mp.pi / 2,
        cases=_kept,
        outside=_not_kept,
        deviation=_badly_conditioned,
        copies=(Copy("3/2", mp.mpf(3) / 2),),
        numbers=_conditions,
        remark="π/2 is ours; the paper gives no number.",
    ),
)
