"""Section 5: how smooth the exponential of a spliced spline is."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.reference import sim3, so3, splines
from affinecert.reference._matrices import Array, Number, array, homogeneous, norm, scalar

Motion = Callable[[Array, Number], Array]
"""A motion through poses: where it is at a time."""


X, Y, Z = exactly([1, 0, 0]), exactly([0, 1, 0]), exactly([0, 0, 1])


DIGITS = 220


_STEP = mp.mpf(10) ** -55


def _pose(axis: Array, angle: Number, scale: Any, translation: Sequence[int]) -> Array:
    return homogeneous(mp, so3.exp(mp, axis * angle) * mp.mpf(scale), exactly(list(translation)))


@cache
def four_poses() -> Array:
    """A_1 to A_4 of section 7."""
    with mp.workdps(DIGITS):
        third = 2 * mp.pi / 3
        return array(
            [
                _pose(X, third, 1, (-3, 0, -3)),
                _pose(X, 2 * third, 1.5, (3, 3, 2)),
                _pose(Y, mp.zero, 1, (-3, 3, 3)),
                _pose(Z, -third / 2, 1.5, (4, 0, -3)),
            ]
        )


@cache
def screw(radius: int = 0) -> Array:
    """The ten bodies of the screw motion; with a radius they move off the axis too."""
    with mp.workdps(DIGITS):
        third = 2 * mp.pi / 3
        return array(
            [_pose(Z, k * third, 1.2 if k in (3, 4) else 1.5, (radius * (k % 2), 0, 2 * k)) for k in range(10)]
        )


@cache
def _turns(move: int) -> Array:
    """Turns by 2, 4 and 5 about one axis, the second one moved across it."""
    with mp.workdps(DIGITS):
        return array([_pose(Z, mp.mpf(angle), 1, (move * (angle == 4), 0, 0)) for angle in (2, 4, 5)])


def printed_motion(poses: Array, t: Number) -> Array:
    """Exp of the spliced spline through the logarithms of strategy 1."""
    return splines.motion(mp, poses, scalar(t))


def smooth_motion(poses: Array, t: Number) -> Array:
    """The motion that is C2 on the group."""
    return splines.smooth_motion(mp, poses, scalar(t))


def _junctions(poses: Array) -> list[int]:
    _, lengths = splines.select_logarithms(mp, poses)
    return [int(time) for time in np.cumsum([max(int(n), 3) - 1 for n in lengths])[:-1]]


def _limits(curve: Callable[[Number], Array], time: int, side: int) -> tuple[Array, Array, Array]:
    """The value of a curve and its first two derivatives, from before (side -1) or behind."""
    values = [curve(time + side * _STEP * (k + _STEP)) for k in range(4)]
    first = (4 * values[1] - 3 * values[0] - values[2]) / (2 * side * _STEP)
    second = (2 * values[0] - 5 * values[1] + 4 * values[2] - values[3]) / _STEP**2
    return values[0], first, second


def jumps(curve: Callable[[Number], Array], time: int) -> list[Number]:
    """The jumps of the value and the first two derivatives, relative to their size before."""
    sides = [_limits(curve, time, side) for side in (-1, 1)]
    return [difference(before, behind) / (size(before) or 1) for before, behind in zip(*sides, strict=True)]


def not_smooth(form: Motion, poses: Array) -> Number:
    """The largest jump of the velocity and the acceleration at a junction."""
    with mp.workdps(DIGITS):
        return max((max(jumps(lambda t: form(poses, t), time)[1:]) for time in _junctions(poses)), default=mp.zero)


def _not_continuous(form: Motion, poses: Array) -> Number:
    with mp.workdps(DIGITS):
        return max((jumps(lambda t: form(poses, t), time)[0] for time in _junctions(poses)), default=mp.zero)


def _velocities() -> dict[str, Any]:
    with mp.workdps(DIGITS):
        before, behind = (_limits(lambda t: printed_motion(four_poses(), t), 2, side)[1] for side in (-1, 1))
        return {
            "velocity of the origin of A_2 before": before[:3, 3].astype(float),
            "behind": behind[:3, 3].astype(float),
            "jump of the velocity of the matrix": float(norm(mp, (before - behind).flat)),
            "velocity of the matrix before": float(norm(mp, before.flat)),
        }


def _with_kept_moves(poses: Array, t: Number) -> Array:
    """The same but for the logarithm that each later segment starts with, whose v is that of the one before."""
    points, lengths = splines.select_logarithms(mp, poses)
    points = points.copy()
    for start in np.cumsum([int(n) for n in lengths])[:-1]:
        points[start, 3:6] = points[start - 1, 3:6]
    return sim3.exp(mp, splines.evaluate(mp, points, lengths, scalar(t)))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.5.continuous",
        place="section 5, and abstract",
        statement="The exponential removes the jumps of the spliced spline: e^{c(t)} is continuous.",
        printed="Since the exponential map removes the discontinuities",
        verdict=Verdict.CONFIRMED,
        form=printed_motion,
        cases=lambda: [_turns(1), four_poses(), screw()],
        deviation=_not_continuous,
        copies=(Copy("v of Y kept for X where a sequence starts", _with_kept_moves),),
    ),
    Claim(
        id="gallier.5.twice_differentiable",
        place="abstract, section 1 and section 5",
        statement="As the first and second derivatives of the spliced spline c agree at the jumps, e^{c(t)} is C².",
        printed="in the end, we obtain C² continuous interpolating splines in SIM(3)",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=printed_motion,
        cases=lambda: [_turns(0), _turns(1), four_poses()],
        deviation=not_smooth,
        correction=Correction(
            statement="It is C⁰. It is C² if behind a jump from Y to X the spline has the derivatives that φ∘c has, φ "
            "the map from logarithms near Y to those near X with the same exponential (splines.smooth_motion).",
            form=smooth_motion,
        ),
        copies=(
            Copy(
                "half of the difference made up",
                lambda poses, t: (smooth_motion(poses, t) + printed_motion(poses, t)) / 2,
            ),
        ),
        numbers=_velocities,
        remark="The derivative of exp at Y is not that at X. Rotations about one axis with translations along it, such "
        "as screw motions, are the exception: there φ is a translation.",
    ),
)
