"""Appendix A.2.2: the logarithm of rotations and rigid motions."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.rigid_exponential import average
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.precision import distance, equals, exactly, mp
from affinecert.reference import so3
from affinecert.reference._matrices import (
    Array,
    Context,
    Number,
    array,
    cross_matrix,
    homogeneous,
    identity,
    norm,
    tangent,
)

AXIS = exactly([2, 3, 6]) / 7


def _turn(angle: Number) -> Array:
    return so3.exp(mp, AXIS * angle)


def _rotations() -> list[tuple[Array]]:
    """A quarter turn, seeded ones, and rotations next to none and next to half a turn."""
    quarter = exactly([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    small = mp.mpf(2) ** -24
    return [(quarter,), *((each,) for each in rotations("rotations", 8)), (_turn(small),), (_turn(mp.pi - small),)]


def _excluded() -> list[tuple[Array]]:
    """No turn, and half turns."""
    half_turns = [[1, 0, 0], [0, -1, 0], [0, 0, -1]], [[-1, 0, 0], [0, 0, 1], [0, 1, 0]]
    return [(identity(mp, 3),), *((exactly(each),) for each in half_turns)]


def _motions() -> list[tuple[Array, Array]]:
    translations = [exactly([1, 0, 0]), *arrays("translations", 10, (3,), -2, 2)]
    return [(rotation, t) for (rotation,), t in zip(_rotations(), translations, strict=True)]


def _angle(factor: int = 1, minus: int = 1) -> Any:
    def printed(m: Context, rotation: Array) -> Number:
        return m.acos((rotation.trace() - minus) / (2 * factor))

    return printed


def _logarithm(factor: int = 2, sign: int = -1) -> Any:
    def printed(m: Context, rotation: Array) -> Array:
        theta = m.acos((rotation.trace() - 1) / 2)
        omega: Array = theta / (factor * m.sin(theta)) * (rotation + sign * rotation.T)
        return omega

    return printed


def _principal(m: Context, rotation: Array) -> Array:
    return cross_matrix(m, so3.log(m, rotation))


def _axis(m: Context, rotation: Array) -> Array:
    """The direction of R - R^T."""
    skew = rotation - rotation.T
    vector = array([skew[2, 1], skew[0, 2], skew[1, 0]])
    axis: Array = vector / norm(m, vector)
    return axis


def _principal_axis(m: Context, rotation: Array) -> Array:
    return _axis(m, _principal(m, rotation))


def _principal_angle(m: Context, rotation: Array) -> Number:
    return norm(m, so3.log(m, rotation))


def _blocks(*, inverted: bool = True) -> Any:
    def printed(m: Context, rotation: Array, t: Array) -> Array:
        omega = _principal(m, rotation)
        v = definitions.integral_of_exponential(m, omega)
        return tangent(m, omega, (definitions.inverse(m, v) if inverted else v) @ t)

    return printed


def _is_logarithm(form: Any, case: tuple[Array, Array]) -> Number:
    """How far the exponential is from the motion."""
    return distance(definitions.exponential(mp, form(mp, *case)), homogeneous(mp, *case))


def _of_rotation(power: int) -> Any:
    """V as printed in terms of R in place of Omega, with the given power in its last term."""

    def printed(m: Context, rotation: Array) -> Array:
        theta = m.acos((rotation.trace() - 1) / 2)
        first, second = (1 - m.cos(theta)) / theta**2, (theta - m.sin(theta)) / theta**3
        last = rotation @ rotation if power == 2 else rotation @ rotation @ rotation
        v: Array = identity(m, 3) + first * rotation + second * last
        return v

    return printed


def _of_logarithm(power: int, sign: int = -1) -> Any:
    return lambda m, rotation: average(power, sign)(m, _principal(m, rotation))


def _integral(m: Context, rotation: Array) -> Array:
    return definitions.integral_of_exponential(m, _principal(m, rotation))


def _float64(angle: Number) -> tuple[Any, ...]:
    """The rotation by that angle, to float64."""
    return ([[float(entry) for entry in row] for row in _turn(angle)],)


def _loss(where: str, formula: Any, truth: Any, angle: Number, digits: int) -> Loss:
    return Loss(where=where, formula=formula, truth=truth, at=_float64(angle), digits=digits)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.2.2.motion",
        place="appendix A.2.2, log(A)",
        statement="The logarithm of a rigid motion has the blocks log(R) and V⁻¹ t, V of A.2.1 at Ω = log(R).",
        printed="log(A) = [[log(R), V⁻¹ t], [0, 0]]",
        verdict=Verdict.CONFIRMED,
        form=_blocks(),
        cases=_motions,
        deviation=_is_logarithm,
        copies=(Copy("V t for V⁻¹ t", _blocks(inverted=False)),),
    ),
    Claim(
        id="bansal_tatu.A.2.2.rotation",
        place="appendix A.2.2, log(R)",
        statement="The logarithm of a rotation is its skew part, scaled.",
        printed="log(R) = (θ / (2 sin θ)) (R - Rᵀ), θ = arccos((Tr(R) - 1) / 2)",
        verdict=Verdict.BOUND,
        domain="0 < θ < π; at θ = π the skew part is 0, and at both ends the formula is 0/0",
        form=_logarithm(),
        cases=_rotations,
        outside=_excluded,
        deviation=equals(_principal),
        copies=(
            Copy("sin θ for 2 sin θ", _logarithm(factor=1)),
            Copy("R + Rᵀ for R - Rᵀ", _logarithm(sign=1)),
        ),
        losses=(
            _loss("the angle 1e-9, whose trace is 3: 0/0", _logarithm(), _principal, mp.mpf(10) ** -9, 16),
            _loss("1e-4 before π", _logarithm(), _principal, mp.pi - mp.mpf(10) ** -4, 7),
            _loss("1e-6 before π", _logarithm(), _principal, mp.pi - mp.mpf(10) ** -6, 12),
            _loss("1e-8 before π", _logarithm(), _principal, mp.pi - mp.mpf(10) ** -8, 15),
            _loss("1e-8 before π, the axis alone", _axis, _principal_axis, mp.pi - mp.mpf(10) ** -8, 8),
        ),
        remark="The case of the identity, which A.2.1 makes, is missing here. The quaternion of R serves both ends.",
    ),
    Claim(
        id="bansal_tatu.A.2.2.theta",
        place="appendix A.2.2, θ",
        statement="The angle of a rotation in [0, π] is arccos((Tr(R) - 1) / 2).",
        printed="θ = arccos((Tr(R) - 1) / 2)",
        verdict=Verdict.CONFIRMED,
        form=_angle(),
        cases=lambda: [*_rotations(), *_excluded()],
        deviation=equals(_principal_angle),
        copies=(
            Copy("4 for 2", _angle(2)),
            Copy("Tr(R) for Tr(R) - 1", _angle(minus=0)),
        ),
        losses=(
            _loss("the angle 1e-4", _angle(), _principal_angle, mp.mpf(10) ** -4, 7),
            _loss("the angle 1e-6", _angle(), _principal_angle, mp.mpf(10) ** -6, 12),
            _loss("the angle 1e-9: 0", _angle(), _principal_angle, mp.mpf(10) ** -9, 16),
            _loss("1e-8 before π", _angle(), _principal_angle, mp.pi - mp.mpf(10) ** -8, 7),
        ),
        remark="Where rounding makes the trace of a rotation next to the identity exceed 3, it is not a number.",
    ),
    Claim(
        id="bansal_tatu.A.2.2.V",
        place="appendix A.2.2, V",
        statement="The V of the logarithm is a polynomial in the rotation matrix R itself, as printed.",
        printed="V = I + ((1 - cos θ) / θ²) R + ((θ - sin θ) / θ³) R³",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_of_rotation(3),
        cases=_rotations,
        deviation=equals(_integral),
        correction=Correction(
            statement="V = I + ((1 - cos θ) / θ²) Ω + ((θ - sin θ) / θ³) Ω², Ω = log(R)",
            form=_of_logarithm(2),
        ),
        copies=(
            Copy("R for Ω", _of_rotation(2)),
            Copy("Ω³ for Ω²", _of_logarithm(3)),
            Copy("θ + sin θ for θ - sin θ", _of_logarithm(2, 1)),
        ),
    ),
)
