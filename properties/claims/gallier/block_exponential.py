"""Section 2, propositions 2.1 and 2.2: the exponential of (Gamma, u; 0, 0), and of Gamma = lambda I + Omega."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays, numbers
from affinecert.properties.claims.gallier.similarities import generators, off_group
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp
from affinecert.reference._matrices import (
    Array,
    Context,
    Number,
    homogeneous,
    identity,
    tangent,
)
from affinecert.reference._quadrature import gauss_legendre


def _series(m: Context, gamma: Array, shift: int = 1) -> Array:
    """I + the sum of Gamma^k / (k + shift)! over k >= 1."""
    total = term = identity(m, len(gamma))
    for k in range(1, 90):
        term = term @ gamma / (k + shift)
        total = total + term
    found: Array = total
    return found


def _matrices() -> list[tuple[Array, Array]]:
    simple = [([[1]], [1]), ([[0, 1], [0, 0]], [1, 2]), ([[1, 2], [3, 4]], [1, 0])]
    drawn = zip(arrays("gamma", 3, (3, 3), -1, 1), arrays("u", 3, (3,), -2, 2), strict=True)
    return [(exactly(gamma), exactly(u)) for gamma, u in simple] + list(drawn)


def _block(shift: int) -> Any:
    def printed(m: Context, gamma: Array, u: Array) -> Array:
        return homogeneous(m, definitions.exponential(m, gamma), _series(m, gamma, shift) @ u)

    return printed


def _exponential_of_tangent(m: Context, gamma: Array, u: Array) -> Array:
    return definitions.exponential(m, tangent(m, gamma, u))


def _integral(power: int) -> Any:
    """The integral of e^{t^power Gamma} over [0, 1], by quadrature."""

    def printed(m: Context, gamma: Array) -> Array:
        nodes = gauss_legendre(m, 34, m.zero, m.one)
        total: Array = sum(w * definitions.exponential(m, t**power * gamma) for t, w in nodes)
        return total

    return printed


def _power(lowered: int) -> Any:
    """The k-th power of (Gamma, u; 0, 0), as the induction has it."""

    def printed(gamma: Array, u: Array, k: int) -> Array:
        powers = [identity(mp, len(gamma))]
        for _ in range(k):
            powers.append(powers[-1] @ gamma)
        return tangent(mp, powers[k], powers[k - lowered] @ u)

    return printed


def _power_misses(form: Any, case: tuple[Array, Array]) -> Number:
    gamma, u = case
    matrix = power = tangent(mp, gamma, u)
    worst = mp.zero
    for k in range(1, 6):
        worst = max(worst, difference(form(gamma, u, k), power))
        power = power @ matrix
    return worst


def _primitive(factorial_of: int) -> Any:
    """The bracket of the proof, t I + the sum of t^(k+1) Gamma^k / (k + 1)!."""

    def printed(gamma: Array, t: Number) -> Array:
        with mp.workdps(300):
            total: Array = t * identity(mp, len(gamma))
            term = t * identity(mp, len(gamma))
            for k in range(1, 140):
                term = term @ gamma * t / (k + factorial_of)
                total = total + term
            return total

    return printed


def _primitive_misses(form: Any, case: tuple[Array, Array]) -> Number:
    gamma, _ = case
    t = mp.mpf(3) / 4
    slope = definitions.derivative(mp, lambda s: form(gamma, s), t)
    return distance(slope, definitions.exponential(mp, t * gamma))


def _growths_and_matrices() -> list[tuple[Number, Array, Array]]:
    """lambda, any matrix Omega, and u."""
    drawn = zip(numbers("lambda", 6, -2, 2), _matrices(), strict=True)
    return [(growth, *both) for growth, both in drawn]


def _factored(inner: bool) -> Any:
    """(e^lambda e^Omega, V u; 0, 1)."""

    def printed(m: Context, growth: Number, omega: Array, u: Array) -> Array:
        exponent = omega * growth if inner else omega
        gamma = growth * identity(m, len(u)) + omega
        return homogeneous(m, m.exp(growth) * definitions.exponential(m, exponent), _series(m, gamma) @ u)

    return printed


def _of_growth_and_matrix(m: Context, growth: Number, omega: Array, u: Array) -> Array:
    return _exponential_of_tangent(m, growth * identity(m, len(u)) + omega, u)


def _commuting(sign: int) -> Any:
    """e^{lambda t I} e^{t Omega}."""

    def printed(m: Context, growth: Number, omega: Array, _u: Array) -> Array:
        t = m.mpf(2) / 3
        product: Array = m.exp(growth * t) * definitions.exponential(m, sign * t * omega)
        return product

    return printed


def _together(m: Context, growth: Number, omega: Array, _u: Array) -> Array:
    return definitions.exponential(m, (growth * identity(m, len(omega)) + omega) * 2 / 3)


def _weighted_integral(rate: int) -> Any:
    """The integral of e^{lambda t} e^{t Omega}, by quadrature."""

    def printed(m: Context, growth: Number, omega: Array, _u: Array) -> Array:
        nodes = gauss_legendre(m, 34, m.zero, m.one)
        total: Array = sum(w * m.exp(rate * growth * t) * definitions.exponential(m, t * omega) for t, w in nodes)
        return total

    return printed


def _v_of_any(m: Context, growth: Number, omega: Array, _u: Array) -> Array:
    return definitions.integral_of_exponential(m, growth * identity(m, len(omega)) + omega)


def _image(symmetric: bool) -> Any:
    """The exponential of (lambda I + Omega, u; 0, 0), Omega skew, or with a symmetric part of 1/100 in one place."""

    def printed(growth: Number, omega: Array, u: Array) -> Array:
        gamma = growth * identity(mp, len(u)) + omega
        if symmetric:
            gamma[0, 0] += mp.mpf(1) / 100
        return _exponential_of_tangent(mp, gamma, u)

    return printed


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.2.1.exponential",
        place="Proposition 2.1",
        statement="The exponential of (Γ, u; 0, 0) is (e^Γ, Vu; 0, 1), with V the sum of Γ^k/(k+1)!; Γ any matrix.",
        printed="e^B = (e^Γ, Vu; 0, 1), V = I_n + Σ_{k≥1} Γ^k/(k+1)!",
        verdict=Verdict.CONFIRMED,
        form=_block(1),
        cases=_matrices,
        deviation=equals(_exponential_of_tangent),
        copies=(Copy("k! for (k+1)!", _block(0)),),
    ),
    Claim(
        id="gallier.2.1.integral",
        place="Proposition 2.1, second part",
        statement="V is the integral of e^{tΓ} over [0, 1].",
        printed="V = ∫_0^1 e^{tΓ} dt",
        verdict=Verdict.CONFIRMED,
        form=_integral(1),
        cases=lambda: [(gamma,) for gamma, _ in _matrices()[1:5]],
        deviation=equals(definitions.integral_of_exponential),
        copies=(Copy("e^{t²Γ} for e^{tΓ}", _integral(2)),),
    ),
    Claim(
        id="gallier.2.1.powers",
        place="Proposition 2.1, proof",
        statement="The n-th power of (Γ, u; 0, 0) is (Γ^n, Γ^(n-1) u; 0, 0).",
        printed="B^n = (Γ^n, Γ^{n-1} W; 0, 0)",
        verdict=Verdict.CONFIRMED,
        form=_power(1),
        cases=_matrices,
        deviation=_power_misses,
        copies=(Copy("Γ^n for Γ^(n-1)", _power(0)),),
        remark="W is printed for u, and n stands both for the power and for the size of Γ.",
    ),
    Claim(
        id="gallier.2.1.primitive",
        place="Proposition 2.1, proof of the second part",
        statement="tI + Σ t^(k+1) Γ^k/(k+1)! is a primitive of e^{tΓ}.",
        printed="[tI + Σ_{k≥1} t^{k+1} Γ^k/(k+1)!]",
        verdict=Verdict.CONFIRMED,
        form=_primitive(1),
        cases=lambda: _matrices()[:4],
        deviation=_primitive_misses,
        copies=(Copy("k! for (k+1)!", _primitive(0)),),
    ),
    Claim(
        id="gallier.2.2.exponential",
        place="Proposition 2.2",
        statement="For any matrix Ω, the exponential of (λI + Ω, u; 0, 0) is (e^λ e^Ω, Vu; 0, 1), with V the sum of "
        "(λI + Ω)^k/(k+1)!.",
        printed="e^B = (e^λ e^Ω, Vu; 0, 1), V = I_n + Σ_{k≥1} (λI + Ω)^k/(k+1)!",
        verdict=Verdict.CONFIRMED,
        form=_factored(inner=False),
        cases=_growths_and_matrices,
        deviation=equals(_of_growth_and_matrix),
        copies=(Copy("e^λ e^{λΩ} for e^λ e^Ω", _factored(inner=True)),),
    ),
    Claim(
        id="gallier.2.2.factors",
        place="Proposition 2.2, proof",
        statement="λI commutes with Ω, and so the exponential of t(λI + Ω) is e^{λt} e^{tΩ}.",
        printed="e^{t(λI + Ω)} = e^{λtI} e^{tΩ}",
        verdict=Verdict.CONFIRMED,
        form=_commuting(1),
        cases=_growths_and_matrices,
        deviation=equals(_together),
        copies=(Copy("e^{-tΩ} for e^{tΩ}", _commuting(-1)),),
    ),
    Claim(
        id="gallier.2.2.integral",
        place="Proposition 2.2",
        statement="V is the integral of e^{λt} e^{tΩ} over [0, 1].",
        printed="V = ∫_0^1 e^{λtI} e^{tΩ} dt",
        verdict=Verdict.CONFIRMED,
        form=_weighted_integral(1),
        cases=lambda: _growths_and_matrices()[1:5],
        deviation=equals(_v_of_any),
        copies=(Copy("e^{-λt} for e^{λt}", _weighted_integral(-1)),),
    ),
    Claim(
        id="gallier.2.2.similarity",
        place="section 2, after Proposition 2.2",
        statement="If Ω is skew, e^Ω is a rotation, and the exponential of (λI + Ω, u; 0, 0) is in SIM(n).",
        verdict=Verdict.CONFIRMED,
        form=_image(symmetric=False),
        cases=generators,
        deviation=lambda form, case: off_group(form(*case)),
        copies=(Copy("a symmetric part, 1/100 in the first place", _image(symmetric=True)),),
    ),
)
