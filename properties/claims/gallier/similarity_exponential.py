"""Section 2, theorem 2.3: the exponential of a logarithm of a similarity of space, with the clauses for V."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays, numbers
from affinecert.properties.claims.precision import equals, exactly, mp
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


def _clause_4(growth_term: Any = None, third: int = -1, second: int = -1, inner: int = 1) -> Any:
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
        v: Array = _clause_4(growth_term=m.mpf(value))(m, m.zero, omega)
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
            v = _clause_4()(m, growth, omega)
        return homogeneous(m, m.exp(growth) * rodrigues(m, omega), v @ u)

    return printed


def _exponential(m: Context, growth: Number, omega: Array, u: Array) -> Array:
    return definitions.exponential(m, tangent(m, growth * identity(m, 3) + cross_matrix(m, omega), u))


def _every_clause() -> list[tuple[Number, Array, Array]]:
    still, turned = exactly([0, 0, 0]), exactly([0, 0, 2])
    u = exactly([1, 2, 3])
    four = [(mp.zero, still, u), (mp.one, still, u), (mp.zero, turned, u), (mp.one, turned, u)]
    return four + [(*both, u) for both in _both()]


CLAIMS: tuple[Claim[Any, Any], ...] = (
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
        form=_clause_4(),
        cases=_both,
        deviation=equals(v_of_both),
        copies=(
            Copy("+ e^λ sin θ for - e^λ sin θ in the coefficient of Ω²", _clause_4(second=1)),
            Copy("+ λ(e^λ cos θ - 1) for - λ(e^λ cos θ - 1)", _clause_4(third=1)),
            Copy("- e^λ λ sin θ for + e^λ λ sin θ in the coefficient of Ω", _clause_4(inner=-1)),
        ),
        losses=(
            *(
                Loss(
                    where=f"the whole matrix at λ = {growth:g}, angle {angle:g}",
                    formula=_clause_4(),
                    truth=v_of_both,
                    at=(growth, [0, 0, angle]),
                    digits=digits,
                )
                for growth, angle, digits in ((1e-12, 1.0, 12), (1e-16, 1.0, 16), (1e-8, 1e-8, 8))
            ),
            Loss(
                where="the entry of first order at λ = 1e-8, angle 1e-8",
                formula=lambda m, growth, omega: _clause_4()(m, growth, omega)[1, 0:1],
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
