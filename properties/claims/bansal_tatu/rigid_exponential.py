"""Appendices A.2.1 and A.2.2: exponential and logarithm of rotations and rigid motions (in part)."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.precision import equals, exactly, mp
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Context, Number, cross_matrix, identity


def _theta(m: Context, omega: Array) -> Number:
    """The angle sqrt(-Tr(Omega^2) / 2), as printed."""
    return m.sqrt(-(omega @ omega).trace() / 2)


def _rotation(exponent: int = 2, sign: int = -1) -> Any:
    def printed(m: Context, omega: Array) -> Array:
        theta = _theta(m, omega)
        first, second = m.sin(theta) / theta, (1 + sign * m.cos(theta)) / theta**exponent
        rotation: Array = identity(m, 3) + first * omega + second * (omega @ omega)
        return rotation

    return printed


def _v(power: int, sign: int = -1) -> Any:
    """V with the given power of Omega in its last term."""

    def printed(m: Context, omega: Array) -> Array:
        theta = _theta(m, omega)
        first, second = (1 - m.cos(theta)) / theta**2, (theta + sign * m.sin(theta)) / theta**3
        last = omega @ omega if power == 2 else omega @ omega @ omega
        v: Array = identity(m, 3) + first * omega + second * last
        return v

    return printed


def _skew_matrices() -> list[tuple[Array]]:
    vectors = [exactly(each) for each in ([1, 0, 0], [0, 1, -1], [1, 2, 2])]
    vectors += [each for each in arrays("skew", 6, (3,), -4, 4) if any(each)]
    return [(cross_matrix(mp, each),) for each in vectors]


def _unit_rotations() -> list[tuple[Array]]:
    return [(rotation,) for rotation in rotations("rotations", 8)]


def _half_turns() -> list[tuple[Array]]:
    return [(exactly([[1, 0, 0], [0, -1, 0], [0, 0, -1]]),)]


def _logarithm(factor: int = 2) -> Any:
    def printed(m: Context, rotation: Array) -> Array:
        theta = m.acos((rotation.trace() - 1) / 2)
        omega: Array = theta / (factor * m.sin(theta)) * (rotation - rotation.T)
        return omega

    return printed


def _principal(m: Context, rotation: Array) -> Array:
    return cross_matrix(m, so3.log(m, rotation))


CLAIMS: tuple[Claim[Any, Any], ...] = (
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
    ),
    Claim(
        id="bansal_tatu.A.2.1.V",
        place="appendix A.2.1, V",
        statement="The translation of exp(A) is V t, V the integral of exp(s Ω) over s in [0, 1].",
        printed="V = I + ((1 - cos θ) / θ²) Ω + ((θ - sin θ) / θ³) Ω³",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_v(3),
        cases=_skew_matrices,
        deviation=equals(definitions.integral_of_exponential),
        correction=Correction(statement="V = I + ((1 - cos θ) / θ²) Ω + ((θ - sin θ) / θ³) Ω²", form=_v(2)),
        copies=(Copy("θ + sin θ for θ - sin θ", _v(2, sign=1)),),
        losses=(
            Loss(
                where="the translation at angle 1e-8: the coefficient of Ω is 0 for 1/2",
                formula=lambda m, omega: _v(2)(m, omega)[0, 1:2],
                truth=lambda m, omega: definitions.integral_of_exponential(m, omega)[0, 1:2],
                at=([[0, -1e-8, 0], [1e-8, 0, 0], [0, 0, 0]],),
                digits=16,
            ),
        ),
    ),
    Claim(
        id="bansal_tatu.A.2.2.rotation",
        place="appendix A.2.2, log(R)",
        statement="The logarithm of a rotation is its skew part, scaled.",
        printed="log(R) = (θ / (2 sin θ)) (R - Rᵀ), θ = arccos((Tr(R) - 1) / 2)",
        verdict=Verdict.BOUND,
        domain="0 < θ < π; at θ = π the skew part is 0, and the formula 0/0",
        form=_logarithm(),
        cases=_unit_rotations,
        outside=_half_turns,
        deviation=equals(_principal),
        copies=(Copy("sin θ for 2 sin θ", _logarithm(factor=1)),),
    ),
)
