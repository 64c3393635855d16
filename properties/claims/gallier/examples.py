"""Section 7: the examples."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.gallier.spliced_motion import (
    DIGITS,
    Motion,
    four_poses,
    jumps,
    not_smooth,
    printed_motion,
    screw,
    smooth_motion,
)
from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference import sim3, splines
from affinecert.reference._matrices import Array, Number, array, norm, scalar


def _by_principal_logarithms(poses: Array, t: Number) -> Array:
    return splines.principal_motion(mp, poses, scalar(t))


def _trajectory_jump(form: Motion, point: Array) -> Number:
    """The largest jump of the velocity and acceleration of a point of the body at A_2."""
    place = np.append(point, mp.one)
    with mp.workdps(DIGITS):
        return max(jumps(lambda t: form(four_poses(), t) @ place, 2)[1:])


def _apart(poses: Array, t: Number) -> Array:
    """The splines through the logarithms of each sequence by itself, with no second derivative at its ends."""
    points, lengths = splines.select_logarithms(mp, poses)
    start, begin = 0, 0
    for length in map(int, lengths):
        time = max(length, 3) - 1
        if t < begin + time or start + length == len(points):
            own = points[start : start + length]
            return sim3.exp(mp, splines.evaluate(mp, own, array([mp.mpf(length)]), scalar(t - begin)))
        start, begin = start + length, begin + time
    raise ValueError("no sequence")


def _passes_smoothly(form: Motion, poses: Array) -> int:
    """0 if the motion is continuous at A_2, and its velocity jumps there by a tenth at least."""
    with mp.workdps(DIGITS):
        place, velocity, _ = jumps(lambda t: form(poses, t), 2)
    return 0 if place < mp.mpf(10) ** -50 and velocity > mp.mpf(1) / 10 else 1


def _angle(pose: Array) -> Number:
    return norm(mp, sim3.log(mp, pose)[:3])


def _right_way(form: Any, poses: Array) -> int:
    """0 if the rotation from A_1 to A_2 comes near to the identity, and nowhere near to a half turn."""
    motion, duration = form
    angles = [_angle(motion(poses, duration * mp.mpf(k) / 16)) for k in range(17)]
    return 0 if min(angles) < mp.mpf(1) / 2 and max(angles) < mp.mpf("2.2") else 1


def _turned_forward(form: Motion, poses: Array) -> int:
    """0 if a motion about the z-axis turns back somewhere between its first four bodies."""
    times = [mp.mpf(k) / 8 for k in range(25)]
    steps = [before[:2, :2].T @ then[:2, :2] for before, then in pairwise(form(poses, t) for t in times)]
    return 0 if any(step[1, 0] < 0 for step in steps) else 1


def _turn(form: int, poses: Array) -> Number:
    """The angle of the pose of that number."""
    return _angle(poses[form - 1])


def _segments_miss(form: tuple[int, ...], poses: Array) -> int:
    _, lengths = splines.select_logarithms(mp, poses)
    return int(tuple(int(n) for n in lengths) != form)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.7.first_examples",
        place="section 7, before figure 4",
        statement="The first examples, figures 1 to 3.",
        verdict=Verdict.UNCHECKABLE,
        reason="neither text nor figures are in the copy at hand",
    ),
    Claim(
        id="gallier.7.unturned",
        place="section 7, the four transformations",
        statement="The rotation part of A_2 is the identity.",
        printed="Observe that the rotation part of A_2 is the identity rotation.",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=2,
        cases=lambda: [four_poses()],
        deviation=_turn,
        correction=Correction(statement="That of A_3 is; A_2 is turned by 4π/3.", form=3),
        copies=(Copy("A_4", 4),),
    ),
    Claim(
        id="gallier.7.two_splines",
        place="section 7, the four transformations",
        statement="The passage through π makes two splines of the logarithms, from A_1 to A_2, and through A_2, A_3, "
        "A_4.",
        verdict=Verdict.CONFIRMED,
        form=(2, 3),
        cases=lambda: [four_poses()],
        deviation=_segments_miss,
        copies=(Copy("from A_1 to A_3, and from A_3 to A_4", (3, 2)), Copy("one spline", (4,))),
    ),
    Claim(
        id="gallier.7.figure_5",
        place="section 7, figure 5",
        statement="The trajectory of a point of the ellipsoid, by the spline of the right logarithms, is C² at A_2.",
        printed="Figure 5: C²-continuous trajectory of a point during the motion",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=printed_motion,
        cases=lambda: [exactly(point) for point in ([0, 0, 0], [1, 0, 0], [1, 2, 3])],
        deviation=_trajectory_jump,
        correction=Correction(statement="It is continuous; that of splines.smooth_motion is C².", form=smooth_motion),
        remark="The point of the figure is not told. The centre of the body arrives with velocity (-4.07, -5.82, 2.45) "
        "and leaves with (-3.89, -0.79, 0.40).",
    ),
    Claim(
        id="gallier.7.figure_6",
        place="section 7, figure 6",
        statement="With two splines joined without regard to derivatives, the trajectory is not even C¹ at A_2.",
        verdict=Verdict.CONFIRMED,
        form=_apart,
        cases=lambda: [four_poses()],
        deviation=_passes_smoothly,
        copies=(Copy("the motion that is C² on the group", smooth_motion),),
        remark="Nor is that of figure 5.",
    ),
    Claim(
        id="gallier.7.figure_7",
        place="section 7, figure 7",
        statement="With the spline through the principal logarithms the body turns the wrong way from A_1 to A_2, "
        "through the unturned pose in place of the half turn.",
        verdict=Verdict.CONFIRMED,
        form=(_by_principal_logarithms, 1),
        cases=lambda: [four_poses()],
        deviation=_right_way,
        copies=(Copy("the logarithms of strategy 1", (printed_motion, 2)),),
    ),
    Claim(
        id="gallier.7.screw",
        place="section 7, figures 11 and 12",
        statement="The screw motion of ten bodies, turned by 2π/3 and moved by (0, 0, 2) each time, is C².",
        verdict=Verdict.CONFIRMED,
        form=screw(),
        cases=lambda: [printed_motion],
        deviation=lambda form, motion: not_smooth(motion, form),
        copies=(Copy("every other body moved by 1 across the axis", screw(1)),),
        remark="Smooth since all turn about the axis along which they move; the logarithms make four sequences.",
    ),
    Claim(
        id="gallier.7.figure_13",
        place="section 7, figure 13",
        statement="With principal logarithms the bodies of the screw motion turn back on their way.",
        verdict=Verdict.CONFIRMED,
        form=_by_principal_logarithms,
        cases=lambda: [screw()],
        deviation=_turned_forward,
        copies=(Copy("the logarithms of strategy 1", printed_motion),),
    ),
    Claim(
        id="gallier.7.figures",
        place="section 7, figures 4 and 8 to 12",
        statement="Renderings of the ellipsoids and of the motions.",
        verdict=Verdict.UNCHECKABLE,
        reason="the figures are not in the copy at hand, and the text gives neither the ellipsoids nor the points",
    ),
)
