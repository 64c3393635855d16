"""Appendix A.2.1: the exponential of rotations and rigid motions."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import equals, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, cross_matrix, homogeneous, identity, norm, tangent


def theta(m: Context, omega: Array, factor: Number = 2) -> Number:
    """The angle sqrt(-Tr(Omega^2) / 2), as printed."""
    return m.sqrt(-(omega @ omega).trace() / factor)


def _rotation(exponent: int = 2, sign: int = -1) -> Any:
    def printed(m: Context, omega: Array) -> Array:
        angle = theta(m, omega)
        first, second = m.sin(angle) / angle, (1 + sign * m.cos(angle)) / angle**exponent
        rotation: Array = identity(m, 3) + first * omega + second * (omega @ omega)
        return rotation

    return printed


def average(power: int, sign: int = -1) -> Any:
    """V with the given power of Omega in its last term, as printed."""

    def printed(m: Context, omega: Array) -> Array:
        angle = theta(m, omega)
        first, second = (1 - m.cos(angle)) / angle**2, (angle + sign * m.sin(angle)) / angle**3
        last = omega @ omega if power == 2 else omega @ omega @ omega
        v: Array = identity(m, 3) + first * omega + second * last
        return v

    return printed


def _motion(sign: int = 1, *, about: bool = False) -> Any:
    """The block matrix with the integral for V; of -Omega for a sign -1, and exp(Omega) itself if ``about``."""

    def printed(m: Context, omega: Array, t: Array) -> Array:
        rotation = definitions.exponential(m, omega)
        v = rotation if about else definitions.integral_of_exponential(m, sign * omega)
        return homogeneous(m, rotation, v @ t)

    return printed


def _exponential(m: Context, omega: Array, t: Array) -> Array:
    return definitions.exponential(m, tangent(m, omega, t))


def _without_rotation(factor: Number = 1) -> Any:
    def printed(m: Context, _: Array, t: Array) -> Array:
        return homogeneous(m, identity(m, 3), factor * t)

    return printed


def _angle(m: Context, omega: Array) -> Number:
    """The length of the rotation vector."""
    return norm(m, (omega[2, 1], omega[0, 2], omega[1, 0]))


def _skew_matrices() -> list[tuple[Array]]:
    vectors = [exactly(each) for each in ([1, 0, 0], [0, 1, -1], [1, 2, 2])]
    vectors += [each for each in arrays("skew", 6, (3,), -4, 4) if any(each)]
    return [(cross_matrix(mp, each),) for each in vectors]


def _twists() -> list[tuple[Array, Array]]:
    velocities = [exactly([0, 1, 0]), *arrays("velocities", 9, (3,), -2, 2)]
    return [(omega, v) for (omega,), v in zip(_skew_matrices(), velocities, strict=False)]


def _translations() -> list[tuple[Array, Array]]:
    return [(omega * 0, v) for omega, v in _twists()]


def _about_z(angle: float) -> tuple[Any, ...]:
    return ([[0, -angle, 0], [angle, 0, 0], [0, 0, 0]],)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.2.1.zero",
        place="appendix A.2.1, the case |Ω| = 0",
        statement="Without rotation the exponential is the translation by t.",
        printed="if |Ω|_F = 0 then exp(A) = [[I, t], [0, 1]]",
        verdict=Verdict.CONFIRMED,
        form=_without_rotation(),
        cases=_translations,
        deviation=equals(_exponential),
        copies=(Copy("t / 2 for t", _without_rotation(mp.mpf(1) / 2)),),
    ),
    Claim(
        id="bansal_tatu.A.2.1.motion",
        place="appendix A.2.1, exp(A)",
        statement="The exponential of a twist has the blocks exp(Ω) and V t, V the integral of exp(s Ω) over [0, 1].",
        printed="exp(A) = [[exp(Ω), V t], [0, 1]]",
        verdict=Verdict.CONFIRMED,
        form=_motion(),
        cases=_twists,
        deviation=equals(_exponential),
        copies=(
            Copy("V of -Ω, which is V transposed", _motion(-1)),
            Copy("exp(Ω) t for V t", _motion(about=True)),
        ),
    ),
    Claim(
        id="bansal_tatu.A.2.1.theta",
        place="appendix A.2.1, θ",
        statement="The angle of rotation, the length of its vector, is θ = sqrt(-Tr(Ω²) / 2).",
        printed="θ = sqrt(-Tr(Ω²) / 2)",
        verdict=Verdict.CONFIRMED,
        form=theta,
        cases=_skew_matrices,
        deviation=equals(_angle),
        copies=(Copy("Tr(Ω²) for Tr(Ω²) / 2: the Frobenius norm", lambda m, omega: theta(m, omega, 1)),),
        losses=(
            Loss(where="at 1e-170 the square underflows", formula=theta, truth=_angle, at=_about_z(1e-170), digits=16),
            Loss(
                where="at 1e-160 the square is subnormal", formula=theta, truth=_angle, at=_about_z(1e-160), digits=11
            ),
        ),
    ),
    Claim(
        id="bansal_tatu.A.2.1.rotation",
        place="appendix A.2.1, exp(Ω)",
        statement="The exponential of a skew matrix is given by Rodrigues' formula.",
        printed="exp(Ω) = I + (sin θ / θ) Ω + ((1 - cos θ) / θ²) Ω², θ = sqrt(-Tr(Ω²) / 2)",
        verdict=Verdict.CONFIRMED,
        form=_rotation(),
        cases=_skew_matrices,
        deviation=equals(definitions.exponential),
        copies=(
            Copy("θ³ for θ² below 1 - cos θ", _rotation(exponent=3)),
            Copy("1 + cos θ for 1 - cos θ", _rotation(sign=1)),
        ),
        losses=(
            Loss(
                where="the angle 1e-170, whose square is 0: 0/0, though |Ω|_F is not 0",
                formula=_rotation(),
                truth=definitions.exponential,
                at=_about_z(1e-170),
                digits=16,
            ),
        ),
        remark="1 - cos θ is lost for θ < 1e-8, but is multiplied by Ω² there, so exp(Ω) itself is not.",
    ),
    Claim(
        id="bansal_tatu.A.2.1.V",
        place="appendix A.2.1, V",
        statement="The translation of exp(A) is V t, V the integral of exp(s Ω) over s in [0, 1].",
        printed="V = I + ((1 - cos θ) / θ²) Ω + ((θ - sin θ) / θ³) Ω³",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=average(3),
        cases=_skew_matrices,
        deviation=equals(definitions.integral_of_exponential),
        correction=Correction(statement="V = I + ((1 - cos θ) / θ²) Ω + ((θ - sin θ) / θ³) Ω²", form=average(2)),
        copies=(Copy("θ + sin θ for θ - sin θ", average(2, sign=1)),),
        losses=(
            Loss(
                where="the translation at angle 1e-8: the coefficient of Ω is 0 for 1/2",
                formula=lambda m, omega: average(2)(m, omega)[0, 1:2],
                truth=lambda m, omega: definitions.integral_of_exponential(m, omega)[0, 1:2],
                at=_about_z(1e-8),
                digits=16,
            ),
            Loss(
                where="the translation across at angle 1e-4",
                formula=lambda m, omega: average(2)(m, omega)[0, 1:2],
                truth=lambda m, omega: definitions.integral_of_exponential(m, omega)[0, 1:2],
                at=_about_z(1e-4),
                digits=8,
            ),
            Loss(
                where="the coefficient (θ - sin θ) / θ³ at 1e-5",
                formula=lambda m, angle: (angle - m.sin(angle)) / angle**3,
                truth=lambda m, angle: (angle - m.sin(angle)) / angle**3,
                at=(1e-5,),
                digits=11,
            ),
            Loss(
                where="the angle 1e-120, whose cube is 0: 0/0",
                formula=average(2),
                truth=definitions.integral_of_exponential,
                at=_about_z(1e-120),
                digits=16,
            ),
        ),
    ),
)
