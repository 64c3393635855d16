"""Section 5.3: the bi-arc of two Bezier motions that goes through the pose in the middle."""

from __future__ import annotations

from typing import Any

from affinecert.errors import InputError
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import distance, mp, size
from affinecert.properties.claims.rossignac_vinacua.listings import (
    EIGHTHS,
    Poses,
    bezier,
    biarc,
    carried,
    jump,
    left_control,
    local_velocity,
    ordinary_poses,
    regular_poses,
    steady,
    undefined,
    with_good_legs,
    with_stretched_legs,
)
from affinecert.reference._matrices import Array, Number

HALF = mp.mpf(1) / 2


def _control(near: str = "0.75", share: str = "0.25") -> Any:
    def control(start: Array, middle: Array, end: Array) -> Array:
        return carried(steady(start, mp.mpf(near), middle), end, mp.mpf(share), middle)

    return control


def _literal_control(start: Array, middle: Array, end: Array) -> Array:
    """SAM(F_X, F_A, t, F_B) taken as the product of the pose SAM(F_A, t, F_B) and F_X."""
    pose: Array = steady(end, mp.mpf("0.25"), middle) @ steady(start, mp.mpf("0.75"), middle)
    return pose


def _chord_control(start: Array, middle: Array, end: Array) -> Array:
    """A pose on the morph from the first to the last, carried towards the one in the middle."""
    return steady(steady(start, mp.mpf("0.25"), end), HALF, middle)


def _missing_control(control: Any, poses: Poses) -> int:
    """Whether one of the control poses F_L and F_R is missing."""
    first, middle, last = poses
    try:
        control(first, middle, last)
        control(last, middle, first)
    except InputError:
        return 1
    return 0


def _misses_a_pose(motion: Any, poses: Poses) -> Number:
    return max(distance(motion(poses, k * HALF), poses[k]) for k in range(3))


def _late_biarc(poses: Poses, t: Number) -> Array:
    """The second arc at the parameter 2 t - 1/2."""
    first, middle, last = poses
    if t <= HALF:
        return biarc(poses, t)
    return bezier(middle, left_control(last, middle, first), last, 2 * t - HALF)


def _jump_of_biarc(control: Any, poses: Poses) -> Number:
    try:
        return jump(lambda t: biarc(poses, t, control), HALF)
    except InputError:  # no such curve
        return mp.inf


def _not_half_way(control: Any, poses: Poses) -> Number:
    """How far F_B is from SAM(F_L, 1/2, F_R)."""
    first, middle, last = poses
    return distance(steady(control(first, middle, last), HALF, control(last, middle, first)), middle)


def _steady_biarc(poses: Poses, _: None) -> int:
    """Whether the velocity in the moving frame is the same at 1/8 and at 3/8."""
    one, other = (local_velocity(lambda t: biarc(poses, t), mp.mpf(k) / 8) for k in (1, 3))
    return int(size(one - other) < mp.mpf(10) ** -9)


def _not_reversible(motion: Any, poses: Poses) -> Number:
    first, middle, last = poses
    try:
        return max(distance(motion(poses, t), motion((last, middle, first), 1 - t)) for t in EIGHTHS)
    except InputError:  # no such curve
        return mp.inf


def _one_sided_biarc(poses: Poses, t: Number) -> Array:
    """F_R = leftControl(F_B, F_C, F_A) for leftControl(F_C, F_B, F_A)."""
    first, middle, last = poses
    if t <= HALF:
        return biarc(poses, t)
    return bezier(middle, left_control(middle, last, first), last, 2 * t - 1)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.5.3.left_control",
        place="section 5.3, the listing leftControl",
        statement="The control poses F_L and F_R require steady morphs between F_A and F_B and between F_B and F_C "
        "only; there need be none between F_A and F_C.",
        printed="SAM(SAM(F_A, 0.75, F_B), F_C, .25, F_B)",
        verdict=Verdict.CONFIRMED,
        form=left_control,
        cases=lambda: [*with_good_legs(), *with_stretched_legs(4, 8)()],
        deviation=_missing_control,
        copies=(Copy("a control pose by the morph from F_A to F_C", _chord_control),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.biarc_exists",
        place="section 5.3",
        statement="The bi-arc only requires the steady morphs between F_A and F_B and between F_B and F_C.",
        verdict=Verdict.BOUND,
        domain="(F_B F_A⁻¹)^¼ (F_C F_B⁻¹)^¼ and the products on the way have real logarithms: so it is with turns by "
        "90 degrees, one stretched by 2 and one by 1/2, and not if by 8 and 1/8",
        form=biarc,
        cases=with_good_legs,
        outside=with_stretched_legs(8, 16),
        deviation=undefined,
        copies=(Copy("control poses by the morph from F_A to F_C", lambda p, t: biarc(p, t, _chord_control)),),
        remark="The arcs themselves take steady morphs from F_A to F_L, from F_L to F_B, and between these.",
    ),
    Claim(
        id="rossignac_vinacua.5.3.biarc_interpolates",
        place="section 5.3 and figure 7 (d)",
        statement="The bi-arc starts at F_A, passes at F_B exactly at t = 1/2, and ends at F_C.",
        printed="if (t <= 0.5) bezier(F_A, F_L, F_B, t*2) else bezier(F_B, F_R, F_C, (t-0.5)*2)",
        verdict=Verdict.CONFIRMED,
        form=biarc,
        cases=ordinary_poses,
        deviation=_misses_a_pose,
        copies=(Copy("2 t - 1/2 in the second arc", _late_biarc),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.biarc_smooth",
        place="section 5.3 and figure 7 (d)",
        statement="The bi-arc is C1 at F_B.",
        verdict=Verdict.CONFIRMED,
        form=left_control,
        cases=lambda: [*with_good_legs(), *with_stretched_legs(4)()],
        deviation=_jump_of_biarc,
        copies=(
            Copy("0.70 for 0.75", _control(near="0.70")),
            Copy("0.30 for 0.25", _control(share="0.30")),
            Copy("SAM(F_X, ...) as the product of the pose SAM(...) and F_X", _literal_control),
        ),
        remark="SAM with four arguments has to be (F_B F_A⁻¹)^t F_X, the motion applied to F_X. The arcs join smoothly "
        "wherever they exist, also where rossignac_vinacua.5.3.half_way fails.",
    ),
    Claim(
        id="rossignac_vinacua.5.3.half_way",
        place="section 5.3",
        statement="F_B is the mid-course pose of the steady morph from F_L to F_R.",
        verdict=Verdict.BOUND,
        domain="the eigenvalues of F_B F_L⁻¹ = (F_B F_A⁻¹)^¼ (F_C F_B⁻¹)^¼ have positive real parts: it turns by less "
        "than 90 degrees. Beyond that the morph from F_L to F_R turns the other way",
        form=left_control,
        cases=with_good_legs,
        outside=with_stretched_legs(4),
        deviation=_not_half_way,
        copies=(Copy("0.70 for 0.75", _control(near="0.70")),),
        remark="What makes the velocity continuous is F_R F_B⁻¹ = F_B F_L⁻¹, which always holds.",
    ),
    Claim(
        id="rossignac_vinacua.5.3.biarc_not_steady",
        place="section 5.3",
        statement="In general the bi-arc is not steady.",
        verdict=Verdict.CONFIRMED,
        form=ordinary_poses()[1],
        cases=lambda: [None],
        deviation=_steady_biarc,
        copies=(Copy("three poses of one steady motion", regular_poses()),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.symmetric",
        place="section 5.3",
        statement="With F_R = leftControl(F_C, F_B, F_A) the second arc is constructed as the first one, reversed.",
        verdict=Verdict.CONFIRMED,
        form=biarc,
        cases=ordinary_poses,
        deviation=_not_reversible,
        copies=(Copy("leftControl(F_B, F_C, F_A) for F_R", _one_sided_biarc),),
    ),
)
