"""Section 4, case 2: logarithms of rotations of space that are no half turns."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays, numbers
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Context, Number, cross_matrix, norm

_TURNS = range(-3, 4)


def unit_vectors(name: str, count: int) -> list[Array]:
    """Unit vectors: an axis, (1, 2, 2) / 3, and drawn ones."""
    simple = [exactly([1, 0, 0]), exactly([0, 0, 1]), exactly([1, 2, 2]) / 3, exactly([-2, 0, 1]) / mp.sqrt(5)]
    return simple + [each / norm(mp, each) for each in arrays(name, count, (3,), -1, 1) if any(each)]


def _rotation(omega: Array) -> Array:
    return definitions.exponential(mp, cross_matrix(mp, omega))


def _axes_and_angles() -> list[tuple[Array, Number]]:
    """Unit axes and angles of logarithms, whole turns and more among them, that are no multiples of pi."""
    angles = [mp.one, mp.mpf(3), mp.mpf(4), -mp.mpf(2), mp.mpf(9), -mp.mpf(15), *numbers("angles", 3, 0.1, 3)]
    return list(zip(unit_vectors("logs", 8), angles, strict=False))


def _by_skew_part(factor: int) -> Any:
    """Theta / (2 sin theta) (R - R^T), theta any angle with 1 + 2 cos theta = tr R."""

    def printed(rotation: Array, theta: Number) -> Array:
        if abs(1 + 2 * mp.cos(theta) - rotation.trace()) > mp.mpf(10) ** -60:
            raise ValueError("not an angle of that rotation")
        omega: Array = theta / (factor * mp.sin(theta)) * (rotation - rotation.T)
        return omega

    return printed


def _set_misses(form: Any, case: tuple[Array, Number]) -> Number:
    """How far the logarithm that R = e^Omega was made of, is from the one of its angle in the set."""
    axis, angle = case
    omega = cross_matrix(mp, axis * angle)
    return distance(form(definitions.exponential(mp, omega), angle), omega)


def _principal() -> Any:
    """Theta / (2 sin theta) (R - R^T), theta the arc cosine of (tr R - 1) / 2 in float64 too."""

    def printed(m: Context, omega: Array) -> Array:
        rotation = so3.exp(mp, exactly(omega)) if m is mp else exactly(_rounded(omega), m)
        theta = m.acos((rotation.trace() - 1) / 2)
        found: Array = theta / (2 * m.sin(theta)) * (rotation - rotation.T)
        return found

    return printed


def _rounded(omega: Array) -> list[list[float]]:
    """The rotation matrix of a vector, rounded to float64."""
    return [[float(x) for x in row] for row in so3.exp(mp, exactly(omega))]


def _skew(m: Context, omega: Array) -> Array:
    return cross_matrix(m, omega)


def _other(step: int) -> Any:
    """(theta + k step pi) B / theta."""

    def printed(principal: Array, theta: Number, k: int) -> Array:
        other: Array = (theta + k * step * mp.pi) * principal / theta
        return other

    return printed


def _other_misses(form: Any, case: tuple[Array, Number]) -> Number:
    axis, angle = case
    principal = cross_matrix(mp, axis * angle)
    rotation = definitions.exponential(mp, principal)
    return max(difference(definitions.exponential(mp, form(principal, angle, k)), rotation) for k in _TURNS)


def _principal_cases() -> list[tuple[Array, Number]]:
    return [(axis, angle) for axis, angle in _axes_and_angles() if 0 < angle < mp.pi]


def _not_unique(form: Any, case: tuple[Array, Number]) -> int:
    """How many logarithms besides one have their angle in (0, most), most given."""
    axis, angle = case
    omegas = [axis * (angle + 2 * mp.pi * k) for k in _TURNS]
    return abs([0 < norm(mp, omega) < form for omega in omegas].count(True) - 1)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.4.2.all_logarithms",
        place="section 4, case 2",
        statement="If R ≠ I and tr R ≠ -1, the logarithms of R are (θ/(2 sin θ))(R - Rᵀ) for all θ with "
        "1 + 2 cos θ = tr R.",
        printed="exp^{-1}(R) = {(θ/(2 sin θ))(R - Rᵀ) | 1 + 2 cos θ = tr(R)}",
        verdict=Verdict.CONFIRMED,
        form=_by_skew_part(2),
        cases=_axes_and_angles,
        deviation=_set_misses,
        copies=(Copy("sin θ for 2 sin θ", _by_skew_part(1)),),
    ),
    Claim(
        id="gallier.4.2.principal",
        place="section 4, case 2",
        statement="The logarithm with its angle in (0, π) is unique, and is (θ/(2 sin θ))(R - Rᵀ).",
        printed="B = (θ/(2 sin θ))(R - Rᵀ), 0 < θ < π",
        verdict=Verdict.CONFIRMED,
        form=_principal(),
        cases=lambda: [(axis * angle,) for axis, angle in _principal_cases()],
        deviation=equals(_skew),
        copies=(
            Copy(
                "the angle of the transpose, 2π - θ",
                lambda m, omega: _principal()(m, omega) * (2 * m.pi - norm(m, omega)) / norm(m, omega),
            ),
        ),
        losses=(
            Loss(
                where="π - θ = 1e-4: (π - θ)² goes into tr R + 1",
                formula=_principal(),
                truth=_skew,
                at=([0.0, 0.0, 3.14149265358979],),
                digits=8,
            ),
            Loss(
                where="π - θ = 1e-8: the arc cosine is π, or its neighbour",
                formula=_principal(),
                truth=_skew,
                at=([0.0, 1.8849555861538759, 2.5132741148718345],),
                digits=16,
            ),
            Loss(
                where="θ = 1e-9: the arc cosine is 0, and the formula 0/0",
                formula=_principal(),
                truth=_skew,
                at=([0.0, 0.0, 1e-9],),
                digits=16,
            ),
        ),
        remark="These are the tolerances that section 4 asks for. The quaternion of R needs none: the axis is its "
        "vector part, and the angle 2 atan2(|vector|, scalar).",
    ),
    Claim(
        id="gallier.4.2.unique",
        place="section 4, case 2",
        statement="Among all logarithms of R one only has its angle in (0, π).",
        printed="there is a unique skew-symmetric B with corresponding θ satisfying 0 < θ < π such that e^B = R",
        verdict=Verdict.CONFIRMED,
        form=mp.pi,
        cases=_principal_cases,
        deviation=_not_unique,
        copies=(Copy("(0, 2π)", 2 * mp.pi),),
    ),
    Claim(
        id="gallier.4.2.determinations",
        place="section 4, case 2 (also strategy 2 in section 5)",
        statement="The other logarithms of R are (θ + 2πk) B/θ, B the principal one and θ its angle.",
        printed="(θ + k2π) B/θ, k ∈ Z",
        verdict=Verdict.CONFIRMED,
        form=_other(2),
        cases=_principal_cases,
        deviation=_other_misses,
        copies=(Copy("kπ for k2π", _other(1)),),
    ),
)
