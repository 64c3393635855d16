"""Section 6.1: the differential equations of constant velocity in the moving frame, equations 5 and 6."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, distance, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.listings import power
from affinecert.properties.claims.rossignac_vinacua.motions_from_identity import (
    TIMES,
    all_maps,
    by,
    steady_motion,
    unsteadiness,
)
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Number, identity


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
)
