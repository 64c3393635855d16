"""Section 7.3: four-point subdivision of poses by SAMs, with the listings ``subdivide`` and ``left``."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.definitions import inverse
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import FAILS, distance, mp
from affinecert.properties.claims.rossignac_vinacua.poses import affines, congruent, controls, morph, power
from affinecert.properties.claims.rossignac_vinacua.predictions import Left, left, towards_c
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Number, array, homogeneous, identity, norm

_Poses = Sequence[Array]
_Average = Callable[[Array, Array, Number], Array]
_Step = Callable[[_Poses], list[Array]]


def _sam(start: Array, end: Array, t: Number) -> Array:
    return morph(mp, start, end, t)


def _straight(start: Array, end: Array, t: Number) -> Array:
    found: Array = (1 - t) * start + t * end
    return found


def _listing(predict: Left = left(), average: _Average = _sam) -> _Step:  # noqa: B008 (a pure function)
    """The listing subdivide(), with its indices."""

    def subdivided(p: _Poses) -> list[Array]:
        n, f_l, f_r, q = len(p), {}, {}, {}
        for i in range(1, n - 1):
            f_l[i] = predict(p[i - 1], p[i], p[i + 1])
            f_r[i] = predict(p[i + 1], p[i], p[i - 1])
        for i in range(n):
            q[2 * i] = p[i]
        for i in range(1, n - 2):
            q[2 * i + 1] = average(f_r[i], f_l[i + 1], mp.mpf(1) / 2)
        q[1], q[2 * n - 3] = f_l[1], f_r[n - 2]
        return [q[i] for i in range(2 * n - 1)]

    return subdivided


def _refined(p: _Poses) -> list[Array]:
    """The middles of the spans only: the motion stays the same polySAM."""
    middles = [_sam(a, b, mp.mpf(1) / 2) for a, b in itertools.pairwise(p)]
    return [*itertools.chain(*zip(p, middles, strict=False)), p[-1]]


def _smoothed(p: _Poses) -> list[Array]:
    """As the listing, and then the old inner poses are moved half way to the middle of their neighbours."""
    q = _listing()(p)
    inner = {k: _sam(q[k], _sam(q[k - 1], q[k + 1], mp.mpf(1) / 2), mp.mpf(1) / 2) for k in range(2, len(q) - 1, 2)}
    return [inner.get(k, pose) for k, pose in enumerate(q)]


def _straightened(p: _Poses) -> list[Array]:
    """As many samples of the SAM from the first pose to the last."""
    count = 2 * len(p) - 1
    return [_sam(p[0], p[-1], mp.mpf(k) / (count - 1)) for k in range(count)]


def _translations(values: Sequence[Number]) -> list[Array]:
    unit = identity(mp, 2)
    return [homogeneous(mp, unit, array([value, 2 * value])) for value in values]


def _polynomials() -> list[tuple[list[Number], int]]:
    """Coefficients, and how many keys; cubic from four keys on."""
    return [([0, 1], 3), ([1, -2, 3], 3), ([1, -2, 3], 4), ([0, 0, 0, 1], 6), ([2, -1, 0.5, 0.25], 7)]


def _off_polynomial(step: _Step, case: tuple[list[Number], int]) -> Number:
    """Of translations by a polynomial, the distance from it at the half ways; a cubic one's ends are left out."""
    coefficients, count = case

    def value(t: Number) -> Number:
        return sum((c * t**k for k, c in enumerate(coefficients)), start=mp.zero)

    found = step(_translations([value(mp.mpf(k)) for k in range(count)]))
    truth = _translations([value(mp.mpf(k) / 2) for k in range(2 * count - 1)])
    ends = 0 if len(coefficients) < 4 else 2
    kept = range(ends, 2 * count - 1 - ends)
    return max(distance(found[k], truth[k]) for k in kept)


def _sequences() -> list[list[Array]]:
    return [
        controls(f"sequence of {size} and {count}", count, size) for size, count in ((2, 3), (2, 4), (2, 6), (3, 5))
    ]


def _not_through(step: _Step, poses: list[Array]) -> Number:
    """Whether the count is 2 n - 1 with the old poses at the even places: the greatest distance."""
    found = step(poses)
    if len(found) != 2 * len(poses) - 1:
        return mp.inf
    return max(distance(found[2 * k], pose) for k, pose in enumerate(poses))


def _computable(form: tuple[_Step, int], count: int) -> int:
    """Whether the listing fails on so many poses: what is read was never written."""
    step, extra = form
    try:
        return int(len(step(controls("computable", count + extra))) != 2 * count - 1)
    except KeyError:
        return 1


def _inserted(printed: tuple[int, ...], poses: list[Array]) -> int:
    """Whether other numbers of new poses than those are inserted, step after step."""
    new = []
    for _ in printed:
        finer = _SUBDIVIDED(poses)
        new.append(len(finer) - len(poses))
        poses = finer
    return int(tuple(new) != printed)


def _regular() -> list[tuple[Array, Array, int]]:
    steps = [affine([[1, 0], [0, 1]], [1, 0]), affine([[0, -1], [1, 0]], [1, 0]), affine([[2, 1], [0, 1]], [1, 1])]
    steps += [*affines("steps", 2), *affines("steps", 2, 3)]
    starts = [controls("starts", 1, len(step) - 1)[0] for step in steps]
    return list(zip(steps, starts, (3, 4, 5, 3, 4, 5, 3), strict=True))


def _irregular(step: _Step, case: tuple[Array, Array, int]) -> Number:
    """How far the poses M^k F, subdivided, are from M^(k/2) F."""
    constant, start, count = case
    found = step([power(mp, constant, mp.mpf(k)) @ start for k in range(count)])
    return max(distance(pose, power(mp, constant, mp.mpf(k) / 2) @ start) for k, pose in enumerate(found))


def _not_congruent(step: _Step, poses: list[Array]) -> Number:
    """The distance of the linear parts from rotations."""
    unit = identity(mp, 2)
    return max(distance(pose[:-1, :-1].T @ pose[:-1, :-1], unit) for pose in step(poses))


def _is_steady(step: _Step, poses: list[Array]) -> int:
    """Whether a sequence subdivided twice has all steps equal."""
    fine = step(step(poses))
    steps = [after @ inverse(mp, before) for before, after in itertools.pairwise(fine)]
    return int(max(distance(each, steps[0]) for each in steps[1:]) < FAILS)


_PREDICTIONS: Mapping[str, Callable[[int], tuple[range, range]]] = {
    "prose": lambda n: (range(n - 1), range(1, n)),
    "code": lambda n: (range(1, n - 1), range(1, n - 1)),
    "one fewer": lambda n: (range(1, n - 2), range(1, n - 1)),
}
"""Of which poses, by number, there is a left and a right prediction."""


def _wrong_predictions(form: str, count: int) -> int:
    """How many predictions lack a pose that they take (i - 1, i, i + 1), or lack themselves where a span takes them."""
    lefts, rights = _PREDICTIONS[form](count)
    impossible = sum(i == 0 or i == count - 1 for some in (lefts, rights) for i in some)
    # The span from i to i + 1 takes the right prediction of i, unless it is the first, and the left one of i + 1.
    wanted = [(rights, i) for i in range(1, count - 1)] + [(lefts, i + 1) for i in range(count - 2)]
    return impossible + sum(i not in some for some, i in wanted)


@functools.cache
def _jumps(step: _Step, steps: int = 4) -> tuple[float, ...]:
    """The greatest jump of the velocity of the polySAM of four poses between its spans, and after each step.

    Relative to the greatest velocity; that of a span of duration h is log(P_(i+1) P_i^-1) / h in the fixed frame.
    """
    poses: _Poses = controls("four of a polySAM", 4)
    found = []
    with mp.workdps(30):
        for level in range(steps + 1):
            duration = mp.mpf(2) ** -level
            rates = [sam.log(mp, after @ inverse(mp, before)) / duration for before, after in itertools.pairwise(poses)]
            jumps = [norm(mp, ((b - a) @ pose).flat) for a, b, pose in zip(rates, rates[1:], poses[1:], strict=False)]
            fastest = max(norm(mp, (rate @ pose).flat) for rate, pose in zip(rates, poses, strict=False))
            found.append(float(max(jumps) / fastest))
            if level < steps:
                poses = step(poses)
    return tuple(found)


def _not_decreasing(step: _Step, steps: int) -> int:
    jumps = _jumps(step, steps)
    return int(any(after > 0.999 * before for before, after in itertools.pairwise(jumps)))


def _measured_jumps() -> dict[str, float]:
    return {f"jump after {level} steps": jump for level, jump in enumerate(_jumps(_SUBDIVIDED))}


_SUBDIVIDED = _listing()

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.7.3.subdivide",
        place="section 7.3, listing subdivide",
        statement="On translations the listing is the four-point scheme: it reproduces cubics, at the ends quadratics.",
        printed="Q[2i+1] = SAM(F_R[i], 0.5, F_L[i+1]); Q[1] = F_L[1]; Q[2n-3] = F_R[n-2]",
        verdict=Verdict.CONFIRMED,
        form=_SUBDIVIDED,
        cases=_polynomials,
        deviation=_off_polynomial,
        copies=(
            Copy("leftControl for left", _listing(left(0.75, 0.25))),
            Copy("middles of the spans", _refined),
        ),
    ),
    Claim(
        id="rossignac_vinacua.7.3.subdivide_through",
        place="section 7.3, listing subdivide",
        statement="From n poses the listing makes 2n - 1, the given ones among them.",
        printed="2n - 1",
        verdict=Verdict.CONFIRMED,
        form=_SUBDIVIDED,
        cases=_sequences,
        deviation=_not_through,
        copies=(Copy("old poses are moved half way to the middle of the new ones", _smoothed),),
    ),
    Claim(
        id="rossignac_vinacua.7.3.subdivide_any_n",
        place="section 7.3, listing subdivide",
        statement="The listing takes n entries.",
        verdict=Verdict.BOUND,
        domain="n >= 3; of two poses it reads predictions F_L[1] and F_R[0] that do not exist",
        form=(_SUBDIVIDED, 0),
        cases=lambda: [3, 4, 5],
        outside=lambda: [2],
        deviation=_computable,
        copies=(Copy("one pose more than told", (_SUBDIVIDED, 1)),),
        remark="Two poses have a SAM; its middle is the new pose.",
    ),
    Claim(
        id="rossignac_vinacua.7.3.figure_13_counts",
        place="figure 13",
        statement="From four control poses the first step inserts three new ones, the second six.",
        printed="3, 6",
        verdict=Verdict.CONFIRMED,
        form=(3, 6),
        cases=lambda: [controls("four of a polySAM", 4)],
        deviation=_inserted,
        copies=(Copy("five in the second step", (3, 5)),),
    ),
    Claim(
        id="rossignac_vinacua.7.3.predictions_prose",
        place="section 7.3",
        statement="Each control pose except the last has a left prediction, each except the first a right one.",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form="prose",
        cases=lambda: [3, 4, 5],
        deviation=_wrong_predictions,
        correction=Correction(statement="Both are of each control pose except the first and the last.", form="code"),
        copies=(Copy("the left prediction of the last pose but one left out", "one fewer"),),
        remark="A prediction of pose i takes poses i - 1 and i + 1; the listing has it right.",
    ),
    Claim(
        id="rossignac_vinacua.7.3.subdivide_steady",
        place="section 7.3",
        statement="Subdivision of a regular pattern preserves steadiness.",
        verdict=Verdict.CONFIRMED,
        form=_SUBDIVIDED,
        cases=_regular,
        deviation=_irregular,
        copies=(
            Copy("the mean of predictions in a straight line", _listing(left(0.5))),
            Copy("F_B and F_C exchanged in left", _listing(towards_c)),
        ),
    ),
    Claim(
        id="rossignac_vinacua.7.3.subdivide_rigid",
        place="section 7.3",
        statement="Of congruent poses subdivision by SAMs makes congruent poses, as ScrewBender does by screws.",
        verdict=Verdict.CONFIRMED,
        form=_SUBDIVIDED,
        cases=lambda: [congruent("congruent", 4), congruent("more congruent", 5, mp.mpf(1.25))],
        deviation=_not_congruent,
        copies=(Copy("straight lines between the predictions", _listing(left(), _straight)),),
    ),
    Claim(
        id="rossignac_vinacua.7.3.subdivide_not_steady",
        place="section 7.3",
        statement="The motion that subdivision leads to is in general not steady.",
        verdict=Verdict.CONFIRMED,
        form=_SUBDIVIDED,
        cases=lambda: _sequences()[1:],
        deviation=_is_steady,
        copies=(Copy("samples of the SAM between the ends", _straightened),),
    ),
    Claim(
        id="rossignac_vinacua.7.3.subdivide_jumps",
        place="section 7.3, figure 13",
        statement="Each of four subdivision steps decreases the velocity discontinuities at the joints of the polySAM.",
        verdict=Verdict.CONFIRMED,
        form=_SUBDIVIDED,
        cases=lambda: [4],
        deviation=_not_decreasing,
        copies=(Copy("middles of the spans, the same polySAM", _refined),),
        numbers=_measured_jumps,
        remark="An experiment: four poses of the plane, the greatest jump relative to the greatest velocity.",
    ),
    Claim(
        id="rossignac_vinacua.7.3.four_steps_suffice",
        place="section 7.3, figure 13",
        statement="Four subdivision steps suffice to make a polySAM that appears perfectly smooth, and pleasant.",
        verdict=Verdict.UNCHECKABLE,
        reason="what the eye takes for smooth or pleasant; the control poses of the figure are not printed either",
    ),
    Claim(
        id="rossignac_vinacua.7.3.robust_and_fast",
        place="section 7.3",
        statement="As the primitive of subdivision SAM is robust and fast, and the construction the best tried.",
        verdict=Verdict.UNCHECKABLE,
        reason="no measurement, and the constructions that it is compared to are not given",
    ),
)
