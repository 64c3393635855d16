"""Section 5.3: quadratic Bezier motions of three poses."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.precision import distance, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.listings import (
    EIGHTHS,
    Poses,
    bezier,
    jump,
    ordinary_poses,
    steady,
    undefined,
    with_good_legs,
    with_stretched_legs,
)
from affinecert.reference._matrices import Array, Number

HALF = mp.mpf(1) / 2


def _swapped_bezier(start: Array, middle: Array, end: Array, t: Number) -> Array:
    """The two legs in the wrong order."""
    return steady(steady(middle, t, end), t, steady(start, t, middle))


def _hurried_bezier(start: Array, middle: Array, end: Array, t: Number) -> Array:
    """The last interpolation at the parameter t^2."""
    return steady(steady(start, t, middle), t**2, steady(middle, t, end))


def _one_leg_bezier(start: Array, middle: Array, end: Array, t: Number) -> Array:
    """The legs at t and 1 - t where both are at t, from the middle on."""
    return steady(steady(start, t, middle), t, steady(middle, t if t <= HALF else 1 - t, end))


def _wrong_ends(curve: Any, poses: Poses) -> Number:
    return max(distance(curve(*poses, mp.zero), poses[0]), distance(curve(*poses, mp.one), poses[2]))


def _translations() -> list[Poses]:
    """Three translations of the plane."""
    moved = [exactly([[1, 0, x], [0, 1, y], [0, 0, 1]]) for x, y in ((1, 2), (3, -1), (4, 4), (0, 0))]
    return [(moved[0], moved[1], moved[2]), (moved[3], moved[2], moved[1])]


def _no_parabola(curve: Any, poses: Poses) -> Number:
    """How far a curve of translations is from their quadratic Bezier curve."""
    first, middle, last = poses
    curves = ((1 - t) ** 2 * first + 2 * t * (1 - t) * middle + t**2 * last - curve(*poses, t) for t in EIGHTHS)
    return max(map(size, curves))


def _passes(poses: Poses, _: None) -> int:
    """Whether the Bezier motion comes within 1/100 of its middle pose, of all 65 poses that are tried."""
    return int(any(size(_bezier(poses, mp.mpf(k) / 64) - poses[1]) < mp.mpf(1) / 100 for k in range(65)))


def _jump_within(curve: Any, poses: Poses) -> Number:
    """The largest jump of the velocity at three times within."""
    return max(jump(lambda s: curve(*poses, s), mp.mpf(k) / 4) for k in (1, 2, 3))


def _bezier(poses: Poses, t: Number) -> Array:
    first, middle, last = poses
    return bezier(first, middle, last, t)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.5.3.bezier_ends",
        place="section 5.3, the listing bezier",
        statement="The quadratic Bezier motion leads from F_A to F_C.",
        printed="SAM(SAM(F_A, t, F_B), t, SAM(F_B, t, F_C))",
        verdict=Verdict.CONFIRMED,
        form=bezier,
        cases=ordinary_poses,
        deviation=_wrong_ends,
        copies=(Copy("the two legs in the other order", _swapped_bezier),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.bezier_of_translations",
        place="section 5.3",
        statement="The Bezier motion is a parabolic curve in the space of affinities: of translations it is the "
        "quadratic Bezier curve.",
        verdict=Verdict.CONFIRMED,
        form=bezier,
        cases=_translations,
        deviation=_no_parabola,
        copies=(Copy("t² for the last t", _hurried_bezier),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.bezier_misses",
        place="section 5.3 and figure 7 (c)",
        statement="The quadratic Bezier motion does not go through F_B.",
        verdict=Verdict.CONFIRMED,
        form=ordinary_poses()[0],
        cases=lambda: [None],
        deviation=_passes,
        copies=(Copy("F_B = F_A", (ordinary_poses()[0][0], ordinary_poses()[0][0], ordinary_poses()[0][1])),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.bezier_smooth",
        place="section 5.3 and figure 7 (c)",
        statement="The quadratic Bezier motion has no discontinuity of velocity.",
        verdict=Verdict.CONFIRMED,
        form=bezier,
        cases=ordinary_poses,
        deviation=_jump_within,
        copies=(Copy("the second leg runs back from the middle on", _one_leg_bezier),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.bezier_exists",
        place="section 5.3",
        statement="The Bezier motion is there whenever the steady morphs from F_A to F_B and from F_B to F_C are.",
        verdict=Verdict.BOUND,
        domain="(F_C F_B⁻¹)^t (F_B F_A⁻¹)^(1 - t) has a real logarithm for all t in [0, 1]; turned by 90 degrees and "
        "stretched by 2 and 1/2 they have, by 4 and 1/4 not",
        form=_bezier,
        cases=with_good_legs,
        outside=with_stretched_legs(4, 8),
        deviation=undefined,
        copies=(Copy("the chord from F_A to F_C for the second leg", lambda p, t: bezier(p[0], p[2], p[2], t)),),
        remark="F_A = 1, F_B = [[0, -4], [1/4, 0]], F_C = diag(-1/16, -16): nothing between the legs at t = 1/2.",
    ),
)
