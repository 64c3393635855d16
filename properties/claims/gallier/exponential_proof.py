"""Section 2, the proof of theorem 2.3: its integrals."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.draws import numbers
from affinecert.properties.claims.gallier.similarity_exponential import v_of_both
from affinecert.properties.claims.precision import equals, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, cross_matrix, identity, norm
from affinecert.reference._quadrature import gauss_legendre


def _integral(m: Context, function: Callable[[Number], Number]) -> Number:
    """The integral over [0, 1] of a function that turns by a few radians."""
    return m.fsum(w * function(t) for t, w in gauss_legendre(m, 48, m.zero, m.one))


def _integrand(powers: tuple[int, int]) -> Any:
    """e^{lambda t} (I + sin(theta t) / (theta t^p) Omega t + (1 - cos(theta t)) / (theta^2 t^q) Omega^2 t^2)."""

    def printed(m: Context, growth: Number, omega: Array, t: Number) -> Array:
        theta, matrix = norm(m, omega), cross_matrix(m, omega)
        first = m.sin(theta * t) / (theta * t ** powers[0])
        second = (1 - m.cos(theta * t)) / (theta**2 * t ** powers[1])
        value: Array = m.exp(growth * t) * (identity(m, 3) + first * matrix * t + second * (matrix @ matrix) * t**2)
        return value

    return printed


def _true_integrand(m: Context, growth: Number, omega: Array, t: Number) -> Array:
    value: Array = m.exp(growth * t) * definitions.exponential(m, t * cross_matrix(m, omega))
    return value


def _times() -> list[tuple[Number, Array, Number]]:
    first, second = exactly([1, 0, 0]), exactly([1, 2, 2])
    half = mp.mpf(1) / 2
    return [(mp.zero, first, mp.one), (mp.zero, first, half), (mp.one, second, half), (-mp.one, second, half / 2)]


def _split(sign: int) -> Any:
    """The four integrals of the second line, by quadrature."""

    def printed(m: Context, growth: Number, omega: Array) -> Array:
        theta, matrix = norm(m, omega), cross_matrix(m, omega)
        square = matrix @ matrix
        alone = _integral(m, lambda t: m.exp(growth * t))
        sine = _integral(m, lambda t: m.exp(growth * t) * m.sin(theta * t) / theta)
        cosine = _integral(m, lambda t: m.exp(growth * t) * m.cos(theta * t) / theta**2)
        v: Array = alone * identity(m, 3) + sine * matrix + alone / theta**2 * square + sign * cosine * square
        return v

    return printed


def _growths_and_turns() -> list[tuple[Number, Array]]:
    return [(mp.one, exactly([1, 0, 0])), (-mp.one, exactly([0, 2, -1])), (mp.mpf(1) / 4, exactly([1, 2, 2]))]


def _growths_and_angles() -> list[tuple[Number, Number]]:
    drawn = zip(numbers("rates", 5, -3, 3), numbers("angles", 5, 0, 6), strict=True)
    return [(mp.one, mp.one), *((growth, angle) for growth, angle in drawn if growth and angle)]


def _complex(sign: int) -> Any:
    """(e^{lambda + i theta} - 1) / (lambda + i theta)."""

    def printed(m: Context, growth: Number, theta: Number) -> Number:
        z = m.mpc(growth, theta)
        return (m.exp(z) + sign) / z

    return printed


def _true_complex(m: Context, growth: Number, theta: Number) -> Number:
    """The integrals of e^{lambda t} cos(theta t) and of e^{lambda t} sin(theta t), as one number."""
    return m.mpc(_true_cosine(m, growth, theta), _true_sine(m, growth, theta))


def _sine(sign: int = -1) -> Any:
    def printed(m: Context, growth: Number, theta: Number) -> Number:
        e = m.exp(growth)
        return (theta * (1 + sign * e * m.cos(theta)) + e * growth * m.sin(theta)) / (growth**2 + theta**2)

    return printed


def _true_sine(m: Context, growth: Number, theta: Number) -> Number:
    return _integral(m, lambda t: m.exp(growth * t) * m.sin(theta * t))


def _cosine(sign: int = 1) -> Any:
    def printed(m: Context, growth: Number, theta: Number) -> Number:
        e = m.exp(growth)
        return (growth * (e * m.cos(theta) - 1) + sign * e * theta * m.sin(theta)) / (growth**2 + theta**2)

    return printed


def _true_cosine(m: Context, growth: Number, theta: Number) -> Number:
    return _integral(m, lambda t: m.exp(growth * t) * m.cos(theta * t))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.2.3.proof.integrand",
        place="theorem 2.3, proof, first line for V (twice)",
        statement="e^{λt} e^{tΩ} by Rodrigues' formula.",
        printed="e^{λt} (I_3 + (sin θt/θ) Ωt + ((1 - cos θt)/(θ²t²)) Ω²t²)",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_integrand((0, 2)),
        cases=_times,
        deviation=equals(_true_integrand),
        correction=Correction(
            statement="The first quotient is sin θt/(θt), as the second one has t² below: the angle of tΩ is θt.",
            form=_integrand((1, 2)),
        ),
        copies=(Copy("t for t² below 1 - cos θt", _integrand((1, 1))),),
        remark="The lines that follow have it right.",
    ),
    Claim(
        id="gallier.2.3.proof.split",
        place="theorem 2.3, proof, second line for V",
        statement="V is a sum of four integrals, of e^{λt} alone and with sine and cosine.",
        printed="∫e^{λt} dt I + ∫e^{λt} sin θt/θ dt Ω + ∫e^{λt}/θ² dt Ω² - ∫e^{λt} cos θt/θ² dt Ω²",
        verdict=Verdict.CONFIRMED,
        form=_split(-1),
        cases=_growths_and_turns,
        deviation=equals(v_of_both),
        copies=(Copy("+ for - before the last integral", _split(1)),),
    ),
    Claim(
        id="gallier.2.3.proof.complex_integral",
        place="theorem 2.3, proof, the primitive of e^{λt + iθt}",
        statement="The integrals with cosine and sine are the real and imaginary part of one of e^{λt + iθt}.",
        printed="∫_0^1 e^{λt + iθt} dt = (e^{λ + iθ} - 1)/(λ + iθ)",
        verdict=Verdict.CONFIRMED,
        form=_complex(-1),
        cases=_growths_and_angles,
        deviation=equals(_true_complex),
        copies=(Copy("e^{λ + iθ} + 1 for e^{λ + iθ} - 1", _complex(1)),),
    ),
    Claim(
        id="gallier.2.3.proof.sine_integral",
        place="theorem 2.3, proof",
        statement="The integral of e^{λt} sin θt.",
        printed="∫_0^1 e^{λt} sin θt dt = (θ(1 - e^λ cos θ) + e^λ λ sin θ)/(λ² + θ²)",
        verdict=Verdict.CONFIRMED,
        form=_sine(),
        cases=_growths_and_angles,
        deviation=equals(_true_sine),
        copies=(Copy("1 + e^λ cos θ for 1 - e^λ cos θ", _sine(1)),),
        losses=(
            Loss(
                where="λ = 1e-4, θ = 1e-4",
                formula=_sine(),
                truth=_true_sine,
                at=(1e-4, 1e-4),
                digits=8,
            ),
            Loss(
                where="λ = 1e-16, θ = 1e-8: 0 for 5e-9", formula=_sine(), truth=_true_sine, at=(1e-16, 1e-8), digits=16
            ),
        ),
    ),
    Claim(
        id="gallier.2.3.proof.cosine_integral",
        place="theorem 2.3, proof",
        statement="The integral of e^{λt} cos θt.",
        printed="∫_0^1 e^{λt} cos θt dt = (λ(e^λ cos θ - 1) + e^λ θ sin θ)/(λ² + θ²)",
        verdict=Verdict.CONFIRMED,
        form=_cosine(),
        cases=_growths_and_angles,
        deviation=equals(_true_cosine),
        copies=(Copy("- e^λ θ sin θ for + e^λ θ sin θ", _cosine(-1)),),
        losses=(
            Loss(
                where="λ = 1e-8, θ = 1e-12",
                formula=_cosine(),
                truth=_true_cosine,
                at=(1e-8, 1e-12),
                digits=8,
            ),
        ),
    ),
)
