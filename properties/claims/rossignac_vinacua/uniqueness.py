"""Section 6.1: how many steady motions lead from one pose to another, and from which origin they are simple."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays, plane_rotation
from affinecert.properties.claims.precision import difference, distance, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.listings import power
from affinecert.properties.claims.rossignac_vinacua.motions_from_identity import (
    TIMES,
    has_eigenvalue_1,
    maps,
    parabolic_maps,
    singular_maps,
)
from affinecert.properties.claims.rossignac_vinacua.reduction import exists
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, homogeneous, identity

EXACT = mp.mpf(10) ** -50


QUARTER = [[0, -1], [1, 0]]


def _several(most: int, degrees: int) -> int:
    """Whether a rotation is reached by several steady motions that turn by less than ``most`` degrees."""
    turns = [degrees + 360 * k for k in range(-2, 3) if abs(degrees + 360 * k) < most]
    whole = plane_rotation(mp.radians(degrees))
    ends = (definitions.exponential(mp, mp.radians(turn) * exactly(QUARTER)) for turn in turns)
    if any(distance(end, whole) > EXACT for end in ends):
        raise ValueError("not that rotation")
    return int(len(turns) > 1)


def _positive_or_negative_turn(logarithm: Array) -> bool:
    return any(difference(logarithm, sign * mp.pi * exactly(QUARTER)) < EXACT for sign in (1, -1))


def _square(sign: int = -1, skew: bool = False) -> Any:
    def condition(logarithm: Array) -> bool:
        squared = difference(logarithm @ logarithm, sign * mp.pi**2 * identity(mp, 2)) < EXACT
        return bool(squared and (not skew or difference(logarithm, -logarithm.T) < EXACT))

    return condition


def _generators() -> list[Array]:
    """Generators that end at the half turn -1, and others."""
    turns = [
        QUARTER,
        [[0, 1], [-1, 0]],
        [[0, -2], [0.5, 0]],
        [[1, -2], [1, -1]],
        [[0, -0.5], [0.5, 0]],
        [[0, 1], [1, 0]],
    ]
    return [mp.pi * exactly(each) for each in turns]


def _misses_a_half_turn(condition: Any, logarithm: Array) -> int:
    reached = difference(definitions.exponential(mp, logarithm), -identity(mp, 2)) < EXACT
    return int(condition(logarithm) is not bool(reached))


def _at_fixed_point(factor: int = 1) -> Any:
    def origin(m: Context, end: Array) -> Array:
        found: Array = factor * sam.fixed_point(m, end)
        return found

    return origin


def _translation_left(origin: Any, end: Array) -> Number:
    """The largest translation part of the motion A^t, seen from another origin."""
    to = homogeneous(mp, identity(mp, len(end) - 1), origin(mp, end))
    back = definitions.inverse(mp, to)
    return max(size((back @ power(end, t) @ to)[:-1, -1]) for t in TIMES)


def _on_the_line(sign: int = -1) -> Any:
    """An origin c with log(L) (v + log(L) c) = 0, if there is one: -v / trace(log L), and 0 for a shear."""

    def origin(end: Array) -> Array:
        generator = sam.log(mp, end)
        linear, vector = generator[:-1, :-1], generator[:-1, -1]
        # Of the eigenvalue 1 twice all origins are alike: the square of log L is 0.
        rate = linear.trace()
        found: Array = sign * vector / rate if abs(rate) > EXACT else vector * mp.zero
        return found

    return origin


def _not_linear(origin: Any, end: Array) -> Number:
    """How far the translation, seen from an origin, is from t times an eigenvector of L."""
    if not has_eigenvalue_1(end):
        raise ValueError(f"{end} has a fixed point")
    to = homogeneous(mp, identity(mp, 2), origin(end))
    seen = definitions.inverse(mp, to) @ end @ to
    generator = sam.log(mp, seen)
    stretched = end[:-1, :-1] @ generator[:-1, -1] - generator[:-1, -1]
    paths = (power(seen, t)[:-1, -1] - t * generator[:-1, -1] for t in TIMES)
    return max(size(stretched), *map(size, paths))


def _end_of(sign: int = 1) -> Any:
    def end(velocity: Array) -> Array:
        found: Array = sign * definitions.exponential(mp, velocity)
        return found

    return end


def _end_is_bad(end: Any, velocity: Array) -> int:
    return int(not exists(end(velocity)))


def _linear_velocities() -> list[Array]:
    return [exactly([[0, 0], [0, 1]]), exactly([[0, -3], [3, 0]]), *arrays("ends", 6, (2, 2), -3, 3)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.6.1.unique",
        place="sections 6.1 and 2.3 (1)",
        statement="The steady motion between two poses is unique, turns by more than 360 degrees and half turns apart.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=360,
        cases=lambda: [90, 10, 170, -100, 179],
        deviation=_several,
        correction=Correction(
            statement="... turns by more than 180 degrees and half turns apart: a turn by 90 degrees is also reached "
            "by one of 270 degrees the other way.",
            form=180,
        ),
        copies=(Copy("200 degrees", 200),),
        remark="Picard's theorem gives one motion for each M; it does not give one M = log L.",
    ),
    Claim(
        id="rossignac_vinacua.6.1.half_turn",
        place="section 6.1",
        statement="A half turn of the plane is reached by two steady motions, turning to the left or to the right.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_positive_or_negative_turn,
        cases=_generators,
        deviation=_misses_a_half_turn,
        correction=Correction(
            statement="... by all with a velocity M such that M² = -π²: on circles and ellipses, to the left or right.",
            form=_square(),
        ),
        copies=(Copy("M² = π²", _square(sign=1)), Copy("skew M with M² = -π²", _square(skew=True))),
        remark="Only for the two that turn on circles is each pose of the way a rotation.",
    ),
    Claim(
        id="rossignac_vinacua.6.1.origin",
        place="section 6.1",
        statement="If 1 is no eigenvalue of L, the translation part is zero at all times if the origin is at the fixed "
        "point: σ = τ = 0.",
        verdict=Verdict.CONFIRMED,
        form=_at_fixed_point(),
        cases=maps,
        deviation=_translation_left,
        copies=(Copy("the origin opposite", _at_fixed_point(-1)),),
    ),
    Claim(
        id="rossignac_vinacua.6.1.eigenvector",
        place="section 6.1",
        statement="If 1 is an eigenvalue of L, there is an origin for which (σ, τ) is an eigenvector of L for it, and "
        "the translation is linear in t.",
        verdict=Verdict.BOUND,
        domain="L is no shear with a translation across; [[1, 1], [0, 1]] with (0, 1) takes all points along parabolas",
        form=_on_the_line(),
        cases=singular_maps,
        outside=parabolic_maps,
        deviation=_not_linear,
        copies=(Copy("the origin opposite", _on_the_line(1)),),
        remark="For a shear log(L)² = 0, and (σ, τ) has the same part across from all origins.",
    ),
    Claim(
        id="rossignac_vinacua.6.1.no_motion_without_logarithm",
        place="section 6.1",
        statement="If L has no real logarithm there is no motion of constant velocity to it: what is reached by "
        "exp(t M) has one.",
        verdict=Verdict.CONFIRMED,
        form=_end_of(),
        cases=_linear_velocities,
        deviation=_end_is_bad,
        copies=(Copy("-exp(M)", _end_of(-1)),),
    ),
)
