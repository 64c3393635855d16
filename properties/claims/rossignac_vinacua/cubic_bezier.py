"""Section 7.3: cubic Bezier motions cascaded from SAMs, and motions of several spans."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

from affinecert.errors import InputError
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.definitions import derivative, inverse
from affinecert.properties.claims.draws import affine, arrays, numbers
from affinecert.properties.claims.precision import FAILS, distance, mp
from affinecert.properties.claims.rossignac_vinacua.poses import controls, morph
from affinecert.reference import curves, sam
from affinecert.reference._matrices import Array, Number, array, homogeneous, identity, scalar, tangent

_Poses = tuple[Array, ...]
_Curve = Callable[[_Poses, Number], Array]


def _bezier(poses: _Poses, t: Number) -> Array:
    """The listings of sections 5.3 and 7.3, the cubic one calling the quadratic one twice."""
    if len(poses) == 3:
        a, b, c = poses
        return morph(mp, morph(mp, a, b, t), morph(mp, b, c, t), t)
    a, b, c, d = poses
    return morph(mp, _bezier((a, b, c), t), _bezier((b, c, d), t), t)


def _shared_ends(poses: _Poses, t: Number) -> Array:
    """The second call gets F_A for F_B."""
    a, b, c, d = poses
    return morph(mp, _bezier((a, b, c), t), _bezier((a, c, d), t), t)


def _interpolating(poses: _Poses, t: Number) -> Array:
    """Through all four poses, by Neville's algorithm: not a Bezier curve."""

    def through(some: _Poses, first: int) -> Array:
        if len(some) == 1:
            return some[0]
        time = (3 * t - first) / (len(some) - 1)
        return morph(mp, through(some[:-1], first), through(some[1:], first + 1), time)

    return through(poses, 0)


def _steady(poses: _Poses, t: Number) -> Array:
    return morph(mp, poses[0], poses[-1], t)


def _poly_sam(poses: _Poses, t: Number) -> Array:
    return curves.poly_sam(mp, array([pose.tolist() for pose in poses]), scalar(t * (len(poses) - 1)))


def _spans(poses: _Poses, t: Number) -> Array:
    """The spans of the poly-SAM, each gone through at a changing speed."""
    whole = mp.floor(t * (len(poses) - 1))
    rest = t * (len(poses) - 1) - whole
    return _poly_sam(poses, (whole + rest * rest) / (len(poses) - 1))


def _commuting() -> list[tuple[Array, list[Number]]]:
    """Generators, and numbers by which they are multiplied to make logarithms of control poses."""
    half = mp.mpf(1) / 2
    generators = [tangent(mp, identity(mp, 2) * 0, array([mp.one, mp.zero]))]
    for size in (2, 3):
        generators += [tangent(mp, each[:, :size], each[:, size]) for each in arrays("one", 2, (size, size + 1), -1, 1)]
    scales = [half * each for each in numbers("commuting", 4 * len(generators), -1, 1)]
    return [(generator, scales[4 * k : 4 * k + 4]) for k, generator in enumerate(generators)]


def _not_bernstein(curve: _Curve, case: tuple[Array, list[Number]]) -> Number:
    """The distance of the curve of poses exp(a_i C) from exp(a(t) C), a(t) the Bezier curve of the numbers a_i."""
    generator, scales = case
    poses = tuple(sam.exponential(mp, scale * generator) for scale in scales)
    worst = mp.zero
    for t in (mp.mpf(1) / 4, mp.mpf(2) / 3):
        mixed = sum(mp.binomial(3, k) * t**k * (1 - t) ** (3 - k) * scale for k, scale in enumerate(scales))
        worst = max(worst, distance(curve(poses, t), sam.exponential(mp, mixed * generator)))
    return worst


def _wrong_ends(curve: _Curve, poses: _Poses) -> Number:
    """Of the ends as Bezier curves have them: first and last pose, and there three times the velocity of the legs."""
    start, end = (derivative(mp, lambda t: curve(poses, t), mp.mpf(t)) for t in (0, 1))
    return max(
        distance(curve(poses, mp.zero), poses[0]),
        distance(curve(poses, mp.one), poses[-1]),
        distance(start, 3 * sam.log(mp, poses[1] @ inverse(mp, poses[0])) @ poses[0]),
        distance(end, 3 * sam.log(mp, poses[-1] @ inverse(mp, poses[-2])) @ poses[-1]),
    )


def _unequal_steps(curve: _Curve, poses: _Poses, times: list[Number]) -> Number:
    at = [curve(poses, t) for t in times]
    steps = [after @ inverse(mp, before) for before, after in itertools.pairwise(at)]
    return max(distance(step, steps[0]) for step in steps[1:])


def _is_steady(curve: _Curve, poses: _Poses) -> int:
    return int(_unequal_steps(curve, poses, [mp.mpf(k) / 4 for k in range(5)]) < FAILS)


def _one_sided(curve: _Curve, poses: _Poses, t: Number, side: int) -> Array:
    """The derivative from one side, by differences of third order; -1 is the side of the past."""
    with mp.workdps(180):
        h = side * mp.mpf(10) ** -40
        f = [curve(poses, t + k * h) for k in range(4)]
        found: Array = (-11 * f[0] + 18 * f[1] - 9 * f[2] + 2 * f[3]) / (6 * h)
    return found


def _jump(curve: _Curve, poses: _Poses) -> Number:
    """The greatest jump of the velocity at the thirds of the time and in the middle; infinite where the curve ends."""
    try:
        times = [mp.mpf(1) / 3, mp.mpf(1) / 2, mp.mpf(2) / 3]
        return max(distance(_one_sided(curve, poses, t, -1), _one_sided(curve, poses, t, 1)) for t in times)
    except InputError:
        return mp.inf


def _is_smooth(curve: _Curve, poses: _Poses) -> int:
    """Whether the velocity is continuous at a third or at two thirds of the time."""
    times = [mp.mpf(1) / 3, mp.mpf(2) / 3]
    jumps = (distance(_one_sided(curve, poses, t, -1), _one_sided(curve, poses, t, 1)) for t in times)
    return int(min(jumps) < FAILS)


def _spans_of(curve: _Curve, poses: _Poses) -> Number:
    """How far each of the three spans is from steady, and the ends of spans from the control poses."""
    worst = mp.zero
    for span in range(3):
        times = [(span + mp.mpf(k) / 4) / 3 for k in range(4)]
        worst = max(worst, _unequal_steps(curve, poses, times), distance(curve(poses, times[0]), poses[span]))
    return worst


def _four() -> list[_Poses]:
    poses = []
    for size in (2, 3):
        drawn = controls(f"four of {size}", 8, size)
        poses += [tuple(drawn[:4]), tuple(drawn[4:])]
    return poses


def _crossed() -> list[_Poses]:
    """Quarter turns along two ellipses: half way there is no SAM between the legs."""
    unit = identity(mp, 3)
    first, second = affine([[0, -4], [0.25, 0]], [0, 0]), affine([[0, -0.25], [4, 0]], [0, 0])
    moved = homogeneous(mp, identity(mp, 2), array([mp.one, mp.zero]))
    return [(unit, first, second @ first, second @ first), (moved, first, second @ first, second @ first @ moved)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.7.3.cubic_of_commuting",
        place="section 7.3, listing bezier",
        statement="The cascade of SAMs is the equivalent of a cubic Bezier curve: of poses exp(a_i C) it makes "
        "exp(a(t) C), a(t) the Bezier curve of the a_i.",
        printed="bezier(F_A, F_B, F_C, F_D, t) = SAM(bezier(F_A, F_B, F_C, t), t, bezier(F_B, F_C, F_D, t))",
        verdict=Verdict.CONFIRMED,
        form=_bezier,
        cases=_commuting,
        deviation=_not_bernstein,
        copies=(
            Copy("F_A for F_B in the second call", _shared_ends),
            Copy("a curve through the control poses", _interpolating),
        ),
    ),
    Claim(
        id="rossignac_vinacua.7.3.cubic_ends",
        place="section 7.3, listing bezier",
        statement="As a Bezier curve the cubic motion goes from F_A to F_D, and leaves and arrives along the legs at "
        "three times their velocity.",
        verdict=Verdict.CONFIRMED,
        form=_bezier,
        cases=_four,
        deviation=_wrong_ends,
        copies=(
            Copy("F_A for F_B in the second call", _shared_ends),
            Copy("a curve through the control poses", _interpolating),
        ),
    ),
    Claim(
        id="rossignac_vinacua.7.3.cubic_not_steady",
        place="section 7.3",
        statement="The cubic Bezier motion is in general not steady.",
        verdict=Verdict.CONFIRMED,
        form=_bezier,
        cases=_four,
        deviation=_is_steady,
        copies=(Copy("the SAM from F_A to F_D", _steady),),
    ),
    Claim(
        id="rossignac_vinacua.7.3.cubic_smooth",
        place="section 7.3",
        statement="The cubic Bezier motion is smooth.",
        verdict=Verdict.BOUND,
        domain="all SAMs of the cascade exist, also those between computed poses; SAMs between the control poses alone "
        "do not ensure that",
        form=_bezier,
        cases=_four,
        outside=_crossed,
        deviation=_jump,
        copies=(Copy("a polySAM of the four poses", _poly_sam),),
        remark="Between legs M and N the cascade needs log(N^t M^(1-t)): of quarter turns along an "
        "upright and a lying ellipse it has none half way.",
    ),
    Claim(
        id="rossignac_vinacua.7.3.polysam_steady",
        place="section 7.3, figure 13",
        statement="A polySAM of four control poses has three spans, each steady, from one control pose to the next.",
        verdict=Verdict.CONFIRMED,
        form=_poly_sam,
        cases=_four,
        deviation=_spans_of,
        copies=(
            Copy("the spans at changing speed", _spans),
            Copy("a cubic motion through the poses", _interpolating),
        ),
    ),
    Claim(
        id="rossignac_vinacua.7.3.polysam_jumps",
        place="section 7.3, figure 13",
        statement="The velocity of a polySAM is in general discontinuous at the control poses.",
        verdict=Verdict.CONFIRMED,
        form=_poly_sam,
        cases=_four,
        deviation=_is_smooth,
        copies=(Copy("a cubic Bezier motion of the poses", _bezier),),
    ),
    Claim(
        id="rossignac_vinacua.7.3.cubic_pleasing",
        place="section 7.3",
        statement="The cubic Bezier motion is pleasing and easily controlled.",
        verdict=Verdict.UNCHECKABLE,
        reason="a matter of taste and of use; no study is given",
    ),
)
