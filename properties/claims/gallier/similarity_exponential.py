"""Section 2: the exponential of a similarity's logarithm, propositions 2.1 and 2.2 and the clauses of theorem 2.3."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays, numbers
from affinecert.properties.claims.gallier.similarities import generators, off_group
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp
from affinecert.reference._matrices import (
    Array,
    Context,
    Number,
    cross_matrix,
    homogeneous,
    identity,
    norm,
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


def rodrigues(m: Context, omega: Array, divisor: int = 2) -> Array:
    """e^Omega of Omega = [omega]x as printed, with its two branches."""
    theta = norm(m, omega)
    if not theta:
        return identity(m, 3)
    matrix = cross_matrix(m, omega)
    square = matrix @ matrix
    rotation: Array = identity(m, 3) + m.sin(theta) / theta * matrix + (1 - m.cos(theta)) / theta**divisor * square
    return rotation


def _rotation(m: Context, omega: Array) -> Array:
    return definitions.exponential(m, cross_matrix(m, omega))


def _vectors() -> list[tuple[Array]]:
    simple = [exactly(each) for each in ([0, 0, 0], [1, 0, 0], [0, 1, -1], [1, 2, 2])]
    return [(each,) for each in simple + arrays("axes", 4, (3,), -4, 4) + [exactly([0, 0, 1]) * mp.pi]]


def _growing() -> list[tuple[Number]]:
    return [(growth,) for growth in (mp.one, -mp.one, *numbers("only growth", 5, -5, 5)) if growth]


def _clause_2(sign: int) -> Any:
    def printed(m: Context, growth: Number) -> Array:
        v: Array = (m.exp(growth) + sign) / growth * identity(m, 3)
        return v

    return printed


def _v_of_growth(m: Context, growth: Number) -> Array:
    return definitions.integral_of_exponential(m, growth * identity(m, 3))


def _clause_3(swapped: bool = False) -> Any:
    def printed(m: Context, omega: Array) -> Array:
        theta, matrix = norm(m, omega), cross_matrix(m, omega)
        first, second = (1 - m.cos(theta)) / theta**2, (theta - m.sin(theta)) / theta**3
        if swapped:
            first, second = second, first
        v: Array = identity(m, 3) + first * matrix + second * (matrix @ matrix)
        return v

    return printed


def _v_of_turn(m: Context, omega: Array) -> Array:
    return definitions.integral_of_exponential(m, cross_matrix(m, omega))


def v_clause_4(growth_term: Any = None, third: int = -1, second: int = -1, inner: int = 1) -> Any:
    """V where neither theta nor lambda is zero; signs of the coefficients can be changed, and (e^lambda - 1)/lambda."""

    def printed(m: Context, growth: Number, omega: Array) -> Array:
        theta, matrix, e = norm(m, omega), cross_matrix(m, omega), m.exp(growth)
        alone = (e - 1) / growth if growth_term is None else growth_term
        both = growth**2 + theta**2
        b = (theta * (1 - e * m.cos(theta)) + inner * e * growth * m.sin(theta)) / (theta * both)
        c = (
            alone / theta**2
            + second * e * m.sin(theta) / (theta * both)
            + third * growth * (e * m.cos(theta) - 1) / (theta**2 * both)
        )
        v: Array = alone * identity(m, 3) + b * matrix + c * (matrix @ matrix)
        return v

    return printed


def v_of_both(m: Context, growth: Number, omega: Array) -> Array:
    """V by its definition."""
    return definitions.integral_of_exponential(m, growth * identity(m, 3) + cross_matrix(m, omega))


def _both() -> list[tuple[Number, Array]]:
    simple = [(mp.one, exactly([1, 0, 0])), (-mp.one, exactly([1, 2, 2]))]
    drawn = zip(numbers("growth", 6, -3, 3), arrays("turn", 6, (3,), -4, 4), strict=True)
    return simple + [(growth, turn) for growth, turn in drawn if growth and any(turn)]


def _convention(value: int) -> Any:
    """The fourth clause at lambda = 0, with that for (e^lambda - 1) / lambda."""

    def printed(m: Context, omega: Array) -> Array:
        v: Array = v_clause_4(growth_term=m.mpf(value))(m, m.zero, omega)
        return v

    return printed


def _printed_exponential(growth_first: bool = True) -> Any:
    """Theorem 2.3 with all its clauses; a copy takes V = I wherever theta = 0."""

    def printed(m: Context, growth: Number, omega: Array, u: Array) -> Array:
        theta = norm(m, omega)
        if not theta and (not growth or not growth_first):
            v = identity(m, 3)
        elif not theta:
            v = _clause_2(-1)(m, growth)
        elif not growth:
            v = _clause_3()(m, omega)
        else:
            v = v_clause_4()(m, growth, omega)
        return homogeneous(m, m.exp(growth) * rodrigues(m, omega), v @ u)

    return printed


def _exponential(m: Context, growth: Number, omega: Array, u: Array) -> Array:
    return _exponential_of_tangent(m, growth * identity(m, 3) + cross_matrix(m, omega), u)


def _every_clause() -> list[tuple[Number, Array, Array]]:
    still, turned = exactly([0, 0, 0]), exactly([0, 0, 2])
    u = exactly([1, 2, 3])
    four = [(mp.zero, still, u), (mp.one, still, u), (mp.zero, turned, u), (mp.one, turned, u)]
    return four + [(*both, u) for both in _both()]


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
    Claim(
        id="gallier.2.3.rodrigues",
        place="section 2, Rodrigues' formula, and theorem 2.3",
        statement="The exponential of a skew matrix of space, with a branch for 0.",
        printed="e^Ω = I + (sin θ/θ) Ω + ((1 - cos θ)/θ²) Ω² if θ ≠ 0, e^0 = I, θ = sqrt(a² + b² + c²)",
        verdict=Verdict.CONFIRMED,
        form=rodrigues,
        cases=_vectors,
        deviation=equals(_rotation),
        copies=(Copy("θ for θ² below 1 - cos θ", lambda m, omega: rodrigues(m, omega, 1)),),
        losses=(
            Loss(
                where="an entry of second order at the rotation vector (1e-8, 1e-8, 0): 0 for 5e-17",
                formula=lambda m, omega: rodrigues(m, omega)[0, 1:2],
                truth=lambda m, omega: _rotation(m, omega)[0, 1:2],
                at=([1e-8, 1e-8, 0],),
                digits=16,
            ),
        ),
    ),
    Claim(
        id="gallier.2.3.clause_1",
        place="theorem 2.3, clause 1",
        statement="V = I if θ = 0 and λ = 0.",
        printed="V = I_3",
        verdict=Verdict.CONFIRMED,
        form=lambda m, omega: identity(m, 3),
        cases=lambda: [(exactly([0, 0, 0]),)],
        deviation=equals(_v_of_turn),
        copies=(Copy("I/2 for I", lambda m, omega: identity(m, 3) / 2),),
    ),
    Claim(
        id="gallier.2.3.clause_2",
        place="theorem 2.3, clause 2, and its proof",
        statement="V = ((e^λ - 1)/λ) I if θ = 0 and λ ≠ 0: the integral of e^{λt} over [0, 1].",
        printed="V = ((e^λ - 1)/λ) I_3",
        verdict=Verdict.CONFIRMED,
        form=_clause_2(-1),
        cases=_growing,
        deviation=equals(_v_of_growth),
        copies=(Copy("e^λ + 1 for e^λ - 1", _clause_2(1)),),
        losses=tuple(
            Loss(
                where=f"λ = {growth:g}: e^λ - 1 cancels",
                formula=_clause_2(-1),
                truth=_v_of_growth,
                at=(growth,),
                digits=digits,
            )
            for growth, digits in ((1e-8, 8), (1e-12, 12), (1e-16, 16))
        ),
        remark="expm1(λ)/λ loses nothing.",
    ),
    Claim(
        id="gallier.2.3.clause_3",
        place="theorem 2.3, clause 3",
        statement="V if θ ≠ 0 and λ = 0, that of a rigid motion.",
        printed="V = I_3 + ((1 - cos θ)/θ²) Ω + ((θ - sin θ)/θ³) Ω²",
        verdict=Verdict.CONFIRMED,
        form=_clause_3(),
        cases=lambda: _vectors()[1:],
        deviation=equals(_v_of_turn),
        copies=(Copy("the coefficients of Ω and Ω² exchanged", _clause_3(swapped=True)),),
        losses=(
            Loss(
                where="the whole matrix at the angle 1e-8",
                formula=_clause_3(),
                truth=_v_of_turn,
                at=([0, 0, 1e-8],),
                digits=8,
            ),
            Loss(
                where="the entry of first order at the angle 1e-8: 0 for 5e-9",
                formula=lambda m, omega: _clause_3()(m, omega)[1, 0:1],
                truth=lambda m, omega: _v_of_turn(m, omega)[1, 0:1],
                at=([0, 0, 1e-8],),
                digits=16,
            ),
            Loss(
                where="the entry of first order at the angle 1e-4",
                formula=lambda m, omega: _clause_3()(m, omega)[1, 0:1],
                truth=lambda m, omega: _v_of_turn(m, omega)[1, 0:1],
                at=([0, 0, 1e-4],),
                digits=8,
            ),
        ),
        remark="2 sin²(θ/2)/θ² loses nothing; θ - sin θ needs a series for small θ.",
    ),
    Claim(
        id="gallier.2.3.clause_4",
        place="theorem 2.3, clause 4, and the last line of its proof",
        statement="V if θ ≠ 0 and λ ≠ 0.",
        printed="V = ((e^λ - 1)/λ) I + ((θ(1 - e^λ cos θ) + e^λ λ sin θ)/(θ(λ² + θ²))) Ω + ((e^λ - 1)/(λθ²) - "
        "e^λ sin θ/(θ(λ² + θ²)) - λ(e^λ cos θ - 1)/(θ²(λ² + θ²))) Ω²",
        verdict=Verdict.CONFIRMED,
        form=v_clause_4(),
        cases=_both,
        deviation=equals(v_of_both),
        copies=(
            Copy("+ e^λ sin θ for - e^λ sin θ in the coefficient of Ω²", v_clause_4(second=1)),
            Copy("+ λ(e^λ cos θ - 1) for - λ(e^λ cos θ - 1)", v_clause_4(third=1)),
            Copy("- e^λ λ sin θ for + e^λ λ sin θ in the coefficient of Ω", v_clause_4(inner=-1)),
        ),
        losses=(
            *(
                Loss(
                    where=f"the whole matrix at λ = {growth:g}, angle {angle:g}",
                    formula=v_clause_4(),
                    truth=v_of_both,
                    at=(growth, [0, 0, angle]),
                    digits=digits,
                )
                for growth, angle, digits in ((1e-12, 1.0, 12), (1e-16, 1.0, 16), (1e-8, 1e-8, 8))
            ),
            Loss(
                where="the entry of first order at λ = 1e-8, angle 1e-8",
                formula=lambda m, growth, omega: v_clause_4()(m, growth, omega)[1, 0:1],
                truth=lambda m, growth, omega: v_of_both(m, growth, omega)[1, 0:1],
                at=(1e-8, [0, 0, 1e-8]),
                digits=16,
            ),
        ),
        remark="V has to be summed as a series, or by halving λ and θ and doubling V as often. The "
        "coefficient of Ω² has no digit right at θ = 1e-8 either, but then Ω² is small.",
    ),
    Claim(
        id="gallier.2.3.convention",
        place="theorem 2.3, after the clauses",
        statement="With (e^λ - 1)/λ = 1 at λ = 0, the third clause is the fourth at λ = 0.",
        verdict=Verdict.CONFIRMED,
        form=_convention(1),
        cases=lambda: _vectors()[1:],
        deviation=equals(_v_of_turn),
        copies=(Copy("0 for 1", _convention(0)),),
        remark="In exact arithmetic. In float64 a small λ ≠ 0 goes to the fourth clause, and loses what λ is below 1.",
    ),
    Claim(
        id="gallier.2.3.exponential",
        place="theorem 2.3",
        statement="The exponential of (λI + Ω, u; 0, 0) by Rodrigues' formula and the four clauses for V.",
        printed="e^B = (e^λ e^Ω, Vu; 0, 1)",
        verdict=Verdict.CONFIRMED,
        form=_printed_exponential(),
        cases=_every_clause,
        deviation=equals(_exponential),
        copies=(Copy("V = I wherever θ = 0", _printed_exponential(growth_first=False)),),
        losses=(
            Loss(
                where="the translation at λ = 1e-16, angle 1",
                formula=lambda m, *case: _printed_exponential()(m, *case)[:3, 3],
                truth=lambda m, *case: _exponential(m, *case)[:3, 3],
                at=(1e-16, [0, 0, 1.0], [0, 0, 1.0]),
                digits=16,
            ),
        ),
    ),
)
