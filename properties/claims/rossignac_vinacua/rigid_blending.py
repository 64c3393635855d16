"""Section 3.3.1: other motions between rigid poses, said to be unsteady."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import rotations
from affinecert.properties.claims.precision import HOLDS, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import (
    Morph,
    Pair,
    at,
    rigid_pairs,
    unit,
    unlike_steady,
    unsteadiness,
)
from affinecert.properties.claims.rossignac_vinacua.rigid_interpolation import (
    beside_axis,
    orthonormal,
    screw_parts,
)
from affinecert.properties.matrix.algebra import inverse
from affinecert.reference import morphs, sam, so3
from affinecert.reference._matrices import Array, Context, Number, dot, homogeneous, identity, norm


def _progress(form: Morph, pair: Pair, t: Number) -> tuple[Array, Number]:
    """The rotation vector of M(t) B^-1, and the translation along the axis of C B^-1."""
    axis = screw_parts(mp, pair[1] @ inverse(pair[0]))[0]
    motion = at(form, pair, t) @ inverse(pair[0])
    return so3.log(mp, motion[:3, :3]), dot(mp, axis, motion[:3, 3])


def _beside_screw(form: Morph, pair: Pair) -> Number:
    """How far M(t) B^-1 is from leaving the axis of C B^-1 where it is."""
    axis, centre, _, _ = screw_parts(mp, pair[1] @ inverse(pair[0]))
    motion = at(form, pair, 0.25) @ inverse(pair[0])
    return beside_axis(lambda *_: (axis, centre), motion)


def _even(form: Morph, pair: Pair) -> Number:
    """Whether angle or distance grow evenly, or both alike."""
    (some, part), (whole, length) = _progress(form, pair, 0.25), _progress(form, pair, 1)
    angle, way = norm(mp, some) / norm(mp, whole), part / length
    return mp.mpf(any(abs(gap) < HOLDS for gap in (angle - 0.25, way - 0.25, angle - way)))


def _discrepancies() -> dict[str, Any]:
    """The largest difference of angles, and of distances to one along the axis, between DLB and the screw."""
    found = {}
    for degrees in (45, 90, 135, 179):
        end = homogeneous(mp, so3.exp(mp, exactly([0, 0, 1]) * mp.radians(degrees)), exactly([0, 0, 1]))
        steps = [_progress(morphs.dual_quaternion_linear, (unit(3), end), mp.mpf(k) / 32) for k in range(1, 32)]
        angles = [abs(mp.degrees(norm(mp, turn)) - degrees * mp.mpf(k + 1) / 32) for k, (turn, _) in enumerate(steps)]
        ways = [abs(way - mp.mpf(k + 1) / 32) for k, (_, way) in enumerate(steps)]
        found[f"{degrees} degrees"] = (max(angles), max(ways))
    return found


def _iterative(m: Context, start: Array, end: Array, t: Array) -> Array:
    """DIB: b <- b exp((1 - t) log b^-1 B + t log b^-1 C) from b = DLB on, until it does not change."""
    blend = morphs.dual_quaternion_linear(m, start, end, t)
    for _ in range(10):
        back = inverse(blend)
        step = sam.log(m, back @ start) * (1 - t[()]) + sam.log(m, back @ end) * t[()]
        blend = blend @ sam.exponential(m, step)
        if size(step) < HOLDS:
            break
    return blend


def _is_steady(form: Morph, pair: Pair) -> Number:
    return mp.mpf(unsteadiness(form, pair) < HOLDS)


def _spline(frames: tuple[Array, ...]) -> Array:
    """The point of a uniform quadratic B-spline in the middle of three frames."""
    first, second, third = frames
    point: Array = (first + 6 * second + third) / 8
    return point


def _nested(frames: tuple[Array, ...]) -> Array:
    """The same by spherical linear interpolation in place of straight lines: de Boor's ratios 1/4, 3/4 and 1/2."""
    first, second, third = frames

    def between(a: Array, b: Array, t: float) -> Array:
        turned: Array = so3.exp(mp, so3.log(mp, b @ a.T) * t) @ a
        return turned

    return between(between(first, second, 0.75), between(second, third, 0.25), 0.5)


def _keeps_frames(form: Any, frames: tuple[Array, ...]) -> Number:
    return mp.mpf(orthonormal(form(frames)))


def _frames() -> list[tuple[Array, ...]]:
    turns = rotations("frames", 6)
    return [(identity(mp, 3), turns[2], turns[3]), tuple(turns[:3]), tuple(turns[3:])]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.3.3.1.dlb_axis",
        place="section 3.3.1",
        statement="Dual quaternion linear blending turns about the same fixed axis as ScLERP.",
        verdict=Verdict.CONFIRMED,
        form=morphs.dual_quaternion_linear,
        cases=rigid_pairs,
        deviation=_beside_screw,
        copies=(
            Copy("a rotation and the translation in a straight line", morphs.shoemake_duff),
            Copy("e^((1 - t) log B + t log C)", morphs.alexa_2002),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.1.dlb_uneven",
        place="section 3.3.1",
        statement="It changes the angle and the distance along the axis non-linearly, and each differently; the "
        "discrepancy is small.",
        verdict=Verdict.CONFIRMED,
        form=morphs.dual_quaternion_linear,
        cases=rigid_pairs,
        deviation=_even,
        copies=(Copy("ScLERP for DLB", morphs.sclerp),),
        numbers=_discrepancies,
        remark="The numbers are the largest discrepancies of the angle, in degrees, and of a distance of 1, for turns "
        "by so many degrees: small up to some 90 degrees.",
    ),
    Claim(
        id="rossignac_vinacua.3.3.1.dib",
        place="section 3.3.1",
        statement="Dual quaternion iterative blending (DIB) is an unsteady interpolation.",
        printed="two other unsteady solutions: DLB and DIB",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_iterative,
        cases=rigid_pairs,
        deviation=_is_steady,
        correction=Correction(
            statement="Of two poses DIB is ScLERP, the steady morph: the constant-speed, shortest path solution, as "
            "section 3.3.2 has it.",
            form=_iterative,
            deviation=unlike_steady,
        ),
        copies=(
            Copy("DLB, where it starts", morphs.dual_quaternion_linear),
            Copy("e^((1 - t) log B + t log C), which it iterates", morphs.alexa_2002),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.1.frames",
        place="section 3.3.1",
        statement="B-splines of reference frames do not preserve orthogonality.",
        verdict=Verdict.CONFIRMED,
        form=_spline,
        cases=_frames,
        deviation=_keeps_frames,
        copies=(Copy("de Boor's algorithm with great arcs for straight lines", _nested),),
    ),
)
