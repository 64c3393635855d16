"""Section 5: the inner product, and strategy 1 for the logarithms of rotations."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.gallier.rotation_logarithms import condition
from affinecert.properties.claims.gallier.similarities import skew
from affinecert.properties.claims.precision import difference, exactly, mp
from affinecert.reference import measures, sim3, so3
from affinecert.reference._matrices import Array, Number, cross_matrix, dot, homogeneous, norm

Choice = Callable[[Array, Array], Array]
"""Which rotation vector to take, of the one before and the principal one."""


def _vectors(name: str) -> list[tuple[Array, Array]]:
    simple = [(exactly([1, 0, 0]), exactly([0, 1, 0])), (exactly([1, 2, 3]), exactly([1, 2, 3]))]
    return simple + list(zip(arrays(name, 4, (3,), -3, 3), arrays(name + "'", 4, (3,), -3, 3), strict=True))


def _inner(a: Array, b: Array, half: int = 2) -> tuple[Number, Number]:
    """Both printed forms of the inner product of skew matrices."""
    return (a.T @ b).trace() / half, -(a @ b).trace() / half


def _inner_misses(form: Any, case: tuple[Array, Array]) -> Number:
    due = dot(mp, *case)
    return max(abs(each - due) for each in form(*(cross_matrix(mp, v) for v in case)))


def _adjoint_cases() -> list[tuple[Array, Array, Array]]:
    """Two skew matrices and a rotation, of R^3 and R^4."""
    space = [(cross_matrix(mp, a), cross_matrix(mp, b)) for a, b in _vectors("adjoint")[2:]]
    found = [(*pair, r) for pair, r in zip(space, rotations("adjoint", 4), strict=True)]
    a, b, c = (skew(each, 4) for each in arrays("adjoint 4", 3, (6,), -1, 1))
    return [*found, (a, b, definitions.exponential(mp, c))]


def _not_invariant(form: Any, case: tuple[Array, Array, Array]) -> Number:
    a, b, r = case
    return abs(form(r @ a @ r.T, r @ b @ r.T)[0] - form(a, b)[0])


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


def _shortest(before: Array, w: Array) -> Array:
    """The logarithm of the two whose curve from the one before is the shortest, in truth."""
    return min((w, second_choice(w)), key=lambda vector: _curve_length(before, vector))


def _curve_length(first: Array, second: Array) -> Number:
    with mp.workdps(40):
        return measures.rotation_curve_length(mp, first, second)[()]


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


def _two_ways() -> list[tuple[Array, Array]]:
    x = exactly([1, 0, 0])
    return [(x, x / 2), (exactly([-2, 0, 0]), x), (exactly([-2, 2, 0]), x), (exactly([-1, 2, 0]), 2 * x)]


def _longer_curve(form: Choice, case: tuple[Array, Array]) -> Number:
    """By how much the curve to the logarithm taken is longer than that to the other one, if it is."""
    before, w = case
    least = min(_curve_length(before, each) for each in (w, second_choice(w)))
    return max(_curve_length(before, form(before, w)) - least, mp.zero)


def _lengths_of_curves() -> dict[str, Any]:
    before, w = _two_ways()[2]
    found = {}
    for name, vector in (("B'", w), ("B''", second_choice(w))):
        found[f"distance to {name}"] = float(norm(mp, vector - before))
        found[f"length to {name}"] = float(_curve_length(before, vector))
    return found


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


Step = tuple[str, int]
"""A logarithm of a pose: its name, X or Y, and the number of the pose; X for Y where they are the same."""


def _sequences(less: int) -> Any:
    """Cuts X_0, (Y_1, X_1), ..., (Y_(m-1), X_(m-1)), Y_m into sequences as the paper says, with m_1 less that many."""

    def printed(jumps: Sequence[bool]) -> list[list[Step]]:
        m = len(jumps)
        same = [True, *(not jump for jump in jumps)]
        found, start = [], 0
        while True:
            end = max(j for j in range(start, m + 1) if all(same[start + less : j + 1 - less]))
            found.append([("X", start), *(("X" if same[i] else "Y", i) for i in range(start + 1, end + 1))])
            if end in (start, m):
                return found
            start = end

    return printed


def _legs_lost(form: Any, jumps: Sequence[bool]) -> int:
    """How many of the pairs (X_i, Y_(i+1)) are in no sequence, or not in order, and sequences that are none."""
    legs = [pair for sequence in form(jumps) for pair in pairwise(sequence)]
    due = [(("X", i), ("Y" if jump else "X", i + 1)) for i, jump in enumerate(jumps)]
    return len(set(legs) ^ set(due))


def _journeys() -> list[list[bool]]:
    """Whether Y_i is not X_i, for i = 1, ..., m."""
    return [[False, False], [True, False], [True, False, False], [False, True, False, True, True, False, False]]


def _similarities() -> list[tuple[Array, Array]]:
    """Poses and the tangents before, such that strategy 1 takes the other logarithm."""
    turns = [exactly(each) for each in ([2, 1, 1], [0, 0, -3], [1, -2, 1])]
    poses = [
        homogeneous(mp, so3.exp(mp, w) * mp.mpf(scale), exactly([1, 2, 3]))
        for w, scale in zip(turns, (1, 2, 0.5), strict=True)
    ]
    return [(pose, exactly([*(-w), 0, 0, 0, 0])) for pose, w in zip(poses, turns, strict=True)]


def _other_tangent(keep: bool) -> Any:
    """The tangent with the other logarithm of the rotation and v = V^-1 w, or the v of the principal one kept."""

    def printed(pose: Array, before: Array) -> Array:
        principal, other = sim3.log(mp, pose), sim3.log_next(mp, pose, before)
        moved = principal if keep else other
        return np.concatenate([other[:3], moved[3:6], other[6:]])

    return printed


def _other_exponential(form: Any, case: tuple[Array, Array]) -> Number:
    """How far the exponential of the other tangent is from the pose; 1 where it is the principal one after all."""
    found = form(*case)
    same = difference(found[:3], sim3.log(mp, case[0])[:3]) == 0
    return 1 if same else difference(sim3.exp(mp, found), case[0])


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
        id="gallier.5.inner_product",
        place="section 5, the inner product",
        statement="tr(B_1ᵀB_2)/2 = -tr(B_1B_2)/2 is the scalar product of the vectors (a, b, c) of the skew matrices.",
        printed="<B_1, B_2> = (1/2) tr(B_1ᵀ B_2) = -(1/2) tr(B_1 B_2)",
        verdict=Verdict.CONFIRMED,
        form=_inner,
        cases=lambda: _vectors("inner"),
        deviation=_inner_misses,
        copies=(Copy("without 1/2", lambda a, b: _inner(a, b, 1)),),
    ),
    Claim(
        id="gallier.5.bi_invariant",
        place="section 5 and section 10",
        statement="The inner product of so(n) is invariant under rotations, B ↦ RBRᵀ, and so the metric is "
        "bi-invariant.",
        verdict=Verdict.CONFIRMED,
        form=_inner,
        cases=_adjoint_cases,
        deviation=_not_invariant,
        copies=(
            Copy(
                "twice the weight on the entry (1, 2)",
                lambda a, b: ((a.T @ b).trace() / 2 + a[0, 1] * b[0, 1], -(a @ b).trace() / 2),
            ),
        ),
    ),
    Claim(
        id="gallier.5.metric",
        place="section 5, the intended motion",
        statement="The intended motion between two similarities minimises the length of e^{(1-t)X_1 + tX_2} in SIM(3).",
        verdict=Verdict.UNCHECKABLE,
        reason="a definition, and one that is left open: a metric is given for rotations only, none for "
        "SIM(3), and no logarithm is chosen by its scale or its translation",
    ),
    Claim(
        id="gallier.5.minimise",
        place="abstract, and section 5, before the two strategies",
        statement="Of the logarithms of R_2, the one nearest to B_1 makes the shortest curve e^{(1-t)B_1 + tB_2}.",
        printed="in order to minimize the length L(γ) = ||B_2 - B_1|| of the curve segment γ, it suffices to pick B_2 "
        "so that ||B_2 - B_1|| is minimized",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=strategy_1,
        cases=_two_ways,
        deviation=_longer_curve,
        correction=Correction(
            statement="Of the two logarithms of strategy 1 take the one whose curve is shorter, its length being the "
            "integral of |dexp(B_2 - B_1)|. Rotations about one axis need no more than ||B_2 - B_1||.",
            form=_shortest,
        ),
        copies=(Copy("the principal logarithm", lambda before, w: w),),
        numbers=_lengths_of_curves,
        remark="L is not ||B_2 - B_1|| unless B_1 and B_2 commute. At rotation vectors (-2, 2, 0) and (1, 0, 0) the "
        "nearer logarithm makes the longer curve, by a fifth. The strategies take the nearest logarithm, and no more.",
    ),
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
        id="gallier.5.sequences",
        place="section 5, the K sequences of logarithms",
        statement="The sequences are the longest ones of X_i and Y_(i+1), ..., Y_j with Y = X from one end to the "
        "other, and the next one starts with X_j.",
        printed="the longest subsequence (X_0, Y_1, ..., Y_{m_1}) such that Y_i = X_i for i = 1, ..., m_1; then "
        "(X_{m_1}, ...) such that Y_i = X_i for i = m_1, ..., m_1 + m_2",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_sequences(0),
        cases=_journeys,
        deviation=_legs_lost,
        correction=Correction(
            statement="Y_i = X_i is asked for i = 1, ..., m_1 - 1, and for i = m_1 + 1, ..., m_1 + m_2 - 1: at its "
            "last pose a sequence arrives with Y, whatever X is there. Every pair (X_i, Y_(i+1)) is in one sequence.",
            form=_sequences(1),
        ),
        remark="As printed the first sequence ends before the jump, the second one cannot start, and the way between "
        "is lost. The text goes on with Y_{m_1} ≠ X_{m_1}, and so means what is put right here.",
    ),
    Claim(
        id="gallier.5.same_exponential",
        place="section 5, at the ends of sequences (also abstract)",
        statement="Y ≠ X have the same exponential: both are logarithms of one similarity, v being V^-1 w with "
        "each one's own V.",
        printed="e^{Y_{m_1}} = e^{X_{m_1}}",
        verdict=Verdict.CONFIRMED,
        form=_other_tangent(keep=False),
        cases=_similarities,
        deviation=_other_exponential,
        copies=(Copy("v of X for v of Y", _other_tangent(keep=True)),),
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
