"""Section 6.1: the differential equations of constant velocity, and how many of their solutions lead to a pose."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays, plane_rotation
from affinecert.properties.claims.precision import difference, distance, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.listings import power
from affinecert.properties.claims.rossignac_vinacua.motions import (
    TIMES,
    all_maps,
    by,
    has_eigenvalue_1,
    maps,
    parabolic_maps,
    singular_maps,
    steady_motion,
    unsteadiness,
)
from affinecert.properties.claims.rossignac_vinacua.reduction import exists
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, homogeneous, identity

EXACT = mp.mpf(10) ** -50

QUARTER = [[0, -1], [1, 0]]


def _equation_5(to_the_left: int = 0, to_the_right: int = 1) -> Any:
    """The M of L' = M L, from L and L': L^-1, so many times, before and after L'."""

    def generator(linear: Array, derivative: Array) -> Array:
        inverse, found = definitions.inverse(mp, linear), derivative
        for _ in range(to_the_left):
            found = inverse @ found
        for _ in range(to_the_right):
            found = found @ inverse
        return found

    return generator


def _local_motions() -> list[tuple[Array, Array]]:
    """Start and constant velocity in the moving frame."""
    starts = [identity(mp, 2), identity(mp, 2), exactly([[2, 1], [0, 1]])]
    plane = zip(starts, arrays("velocities", 3, (2, 2), -2, 2), strict=True)
    return [*plane, (identity(mp, 3), exactly([[1, 2, 0], [0, 1, -1], [0.5, 0, 0]]))]


def _not_constant(generator: Any, case: tuple[Array, Array]) -> Number:
    """How far M is from constant along the motion B exp(t X), which has the constant local velocity X."""
    start, velocity = case
    found = []
    for t in TIMES:
        linear = start @ definitions.exponential(mp, t * velocity)
        found.append(generator(linear, linear @ velocity))
    return max(distance(each, found[0]) for each in found[1:])


def _equation_6(order: str = "L^-1 t'") -> Any:
    """The (sigma, tau) of t' = L (sigma, tau)."""

    def constants(linear: Array, derivative: Array) -> Array:
        if order == "t'":
            return derivative
        found: Array = definitions.inverse(mp, linear) @ derivative
        return found

    return constants


def _no_constants(constants: Any, end: Array) -> Number:
    """How far they are from the translation of log A along the motion A^t."""
    velocity = sam.log(mp, end)[:-1, -1]
    gaps = []
    for t in TIMES:
        derivative = definitions.derivative(mp, steady_motion(end), t)[:-1, -1]
        gaps.append(distance(constants(power(end, t)[:-1, :-1], derivative), velocity))
    return max(gaps)


def _velocities() -> list[tuple[Array]]:
    return [(exactly(each),) for each in ([[0, -1], [1, 0]], [[1, 1], [0, 1]])] + [
        (each,) for each in arrays("solutions", 4, (3, 3), -1, 1)
    ]


def _solution(transposed: bool = False) -> Any:
    """The path exp(t M)."""

    def path(velocity: Array, t: Number) -> Array:
        return definitions.exponential(mp, t * (velocity.T if transposed else velocity))

    return path


def _no_solution(path: Any, case: tuple[Array]) -> Number:
    """How far a path is from one with L' = M L, L(0) = 1, and from the power series of its solution."""
    (velocity,) = case
    gaps = [difference(path(velocity, mp.zero), identity(mp, len(velocity)))]
    for t in TIMES[1:]:
        derivative = definitions.derivative(mp, lambda s: path(velocity, s), t)
        gaps.append(distance(derivative, velocity @ path(velocity, t)))
    return max(gaps)


def _turning(*turns: float) -> list[Array]:
    """Velocities of the plane that turn by such angles in a unit of time: on circles and on spirals."""
    angles = [mp.mpf(turn) for turn in turns]
    circles = [exactly([[0, -angle, 2], [angle, 0, 1], [0, 0, 0]]) for angle in angles]
    spirals = [exactly([[0.5, -2 * angle, 0], [angle / 2, 0.5, 1], [0, 0, 0]]) for angle in angles]
    return [*circles, *spirals]


def _slow() -> list[Array]:
    without_turn = [exactly([[0.25, 0, 1], [0, -0.5, 2], [0, 0, 0]]), exactly([[0, 1, 1], [0.5, 0.25, 0], [0, 0, 0]])]
    return [*without_turn, *_turning(1, 2.5, 3.125)]


def _constant_velocity(factor: Number = 1) -> Any:
    def motion(velocity: Array, t: Number) -> Array:
        return definitions.exponential(mp, t**factor * velocity)

    return motion


def _not_a_power(motion: Any, velocity: Array) -> Number:
    """How far a motion is from A^t, A being its pose at 1."""
    end = motion(velocity, mp.one)
    return max(distance(motion(velocity, t), power(end, t)) for t in (mp.mpf(1) / 4, mp.mpf(2)))


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
        id="rossignac_vinacua.6.1.equation_5",
        place="section 6.1, equation 5",
        statement="Where the velocity in the moving frame is constant, L' = M L with a constant matrix M.",
        printed="dL(t)/dt = M ∘ L(t)",
        verdict=Verdict.CONFIRMED,
        form=_equation_5(),
        cases=_local_motions,
        deviation=_not_constant,
        copies=(Copy("L' = M", _equation_5(0, 0)), Copy("L' = L M L", _equation_5(1, 1))),
        remark="The velocity in the moving frame itself is L⁻¹ L': it is M only if the motion starts from the "
        "identity, or from a pose that commutes with M. In equation 6 the order is that of the moving frame.",
    ),
    Claim(
        id="rossignac_vinacua.6.1.equation_6",
        place="section 6.1, equation 6",
        statement="Along A^t the translation has t' = L(t) (σ, τ) with constants σ, τ: the translation of log A.",
        printed="dt(t)/dt = L(t) ([σ, τ]ᵀ)",
        verdict=Verdict.CONFIRMED,
        form=_equation_6(),
        cases=all_maps,
        deviation=_no_constants,
        copies=(Copy("t' = (σ, τ)", _equation_6("t'")),),
    ),
    Claim(
        id="rossignac_vinacua.6.1.solutions",
        place="section 6.1",
        statement="The solution of equation 5 with L(0) = 1 is L(t) = exp(t M).",
        printed="L(t) = e^{tM}",
        verdict=Verdict.CONFIRMED,
        form=_solution(),
        cases=_velocities,
        deviation=_no_solution,
        copies=(Copy("M transposed", _solution(transposed=True)),),
    ),
    Claim(
        id="rossignac_vinacua.6.1.constant_velocity",
        place="section 6.1",
        statement="A^t has constant velocity in the moving frame.",
        verdict=Verdict.CONFIRMED,
        form=steady_motion,
        cases=all_maps,
        deviation=unsteadiness,
        copies=(Copy("rARAP", by("rarap")), Copy("ASAP", by("asap")), Copy("the linear morph", by("linear"))),
    ),
    Claim(
        id="rossignac_vinacua.6.1.equivalent",
        place="section 6.1",
        statement="A motion from the identity whose velocity in the moving frame is constant is A^t, A being its pose "
        "at 1: the two definitions of a steady motion are equivalent.",
        verdict=Verdict.BOUND,
        domain="it turns by less than 180 degrees in a unit of time; A^t is the shortest turn",
        form=_constant_velocity(),
        cases=_slow,
        outside=lambda: _turning(3.25, 4, 7),
        deviation=_not_a_power,
        copies=(Copy("t² for t", _constant_velocity(2)),),
    ),
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
