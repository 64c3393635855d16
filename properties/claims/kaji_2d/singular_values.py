"""Appendix: the exponential of equation 3 is well defined, and computed by singular values."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays, numbers, plane_rotation
from affinecert.properties.claims.kaji_2d.plane import determinant, growths
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp
from affinecert.reference import homotopy2, polar
from affinecert.reference._matrices import Array, Context, Number, array, scalar

Factors = tuple[Number, Number, Number, Number]
"""The angles α and β, and the singular values."""


def _diagonal(first: Number, second: Number) -> Array:
    return array([[first, mp.zero], [mp.zero, second]])


def _composed(alpha: Number, beta: Number, first: Number, second: Number) -> Array:
    product: Array = plane_rotation(alpha) @ _diagonal(first, second) @ plane_rotation(beta)
    return product


def _factors() -> list[Factors]:
    simple = [(0, 0, 2, 1), (1, 0, 2, 1), (0, 1, 1, 2), (1, -2, 3, 3), (-2, 0.5, 0.25, 4), (3, 2, 5, 0.125)]
    return [(mp.mpf(a), mp.mpf(b), mp.mpf(c), mp.mpf(d)) for a, b, c, d in simple]


def _polar_factors(sign: int = 1) -> Any:
    def printed(m: Context, alpha: Number, beta: Number, *values: Number) -> tuple[Array, Array]:
        turn = plane_rotation(sign * beta)
        return plane_rotation(alpha + sign * beta), turn.T @ _diagonal(*values) @ turn

    return printed


def _true_polar_factors(m: Context, *factors: Number) -> tuple[Array, Array]:
    return polar.decompose(m, _composed(*factors))


def _singular(a: Array) -> Factors:
    """Two rotations and a diagonal D of A = R_α D R_β, by double angles."""
    (p, q), (r, s) = a
    plus, minus = mp.atan2(r - q, p + s), mp.atan2(r + q, p - s)
    half_sum, half_gap = mp.hypot(p + s, r - q) / 2, mp.hypot(p - s, r + q) / 2
    return (plus + minus) / 2, (plus - minus) / 2, half_sum + half_gap, half_sum - half_gap


def _no_singular_values(factors: Any, a: Array) -> Number:
    """How far they are from the factors of A, with positive singular values."""
    found = factors(a)
    return max(distance(_composed(*found), a), mp.mpf(min(found[2:]) <= 0))


def _positive_maps() -> list[Array]:
    simple = [exactly(each) for each in ([[1, 0], [0, 1]], [[0, -1], [2, 0]], [[1, 1], [0, 1]], [[-1, 0], [0, -2]])]
    return [*simple, *[each for each in arrays("singular", 20, (2, 2), -2, 2) if determinant(each) > 0][:5]]


def _powers_and_times() -> list[tuple[Number, ...]]:
    return [(*each, t) for each, t in zip(_factors(), numbers("powers", 6, -2, 3), strict=True)]


def _power(sign: int = 1) -> Any:
    def printed(m: Context, alpha: Number, beta: Number, first: Number, second: Number, t: Number) -> Array:
        turn = plane_rotation(sign * beta)
        raised: Array = turn.T @ _diagonal(first**t, second**t) @ turn
        return raised

    return printed


def _true_power(m: Context, alpha: Number, beta: Number, first: Number, second: Number, t: Number) -> Array:
    """S^t, as A^E of S."""
    _, stretch = polar.decompose(m, _composed(alpha, beta, first, second))
    return homotopy2.exponential(m, (stretch + stretch.T) / 2, scalar(t))


def _conjugated(*, back: bool = False) -> Any:
    def printed(m: Context, u: Array, b: Array) -> Array:
        inverse = definitions.inverse(m, u)
        first, last = (u, inverse) if back else (inverse, u)
        product: Array = first @ definitions.exponential(m, b) @ last
        return product

    return printed


def _exponential_of_conjugate(m: Context, u: Array, b: Array) -> Array:
    return definitions.exponential(m, definitions.inverse(m, u) @ b @ u)


def _conjugations() -> list[tuple[Array, Array]]:
    simple = [([[1, 1], [0, 1]], [[1, 0], [0, 2]]), ([[0, 1], [1, 0]], [[0, 1], [0, 0]])]
    bases = [each for each in arrays("U", 9, (2, 2), -2, 2) if determinant(each)][:5]
    pairs = [(exactly(u), exactly(b)) for u, b in simple]
    return [*pairs, *zip(bases, arrays("B", 5, (2, 2), -2, 2), strict=True)]


def _other_factors(shift: Any) -> Any:
    """S^t by other factors of the same A."""

    def printed(*case: Number) -> tuple[Array, Array]:
        other = (*shift(*case[:4]), case[4])
        return _composed(*other[:4]), _power()(mp, *other)

    return printed


def _depends(other: Any, case: tuple[Number, ...]) -> Number:
    """How far another factorisation is from one of the same A with the same S^t."""
    a, raised = other(*case)
    return max(difference(a, _composed(*case[:4])), difference(raised, _power()(mp, *case)))


def _exchanged(alpha: Number, beta: Number, first: Number, second: Number) -> Factors:
    return alpha - mp.pi / 2, beta + mp.pi / 2, second, first


def _logarithm_of_stretch(m: Context, growth: Array, t: Number) -> Array:
    scaled: Array = growth * t
    return definitions.exponential(m, scaled)


def _growths_and_times() -> list[tuple[Array, Number]]:
    """Log S and t; also of the same eigenvalue twice."""
    drawn = [exactly([[1, 0], [0, 1]]), exactly([[1, 0], [0, -1]]), exactly([[0, 1], [1, 0]]), *growths("growth", 4)]
    return list(zip(drawn, numbers("growth", len(drawn), -2, 3), strict=True))


def _power_of_exponential(change: Any) -> Any:
    def form(m: Context, growth: Array, t: Number) -> Array:
        raised: Array = change(homotopy2.exponential(m, definitions.exponential(m, growth), scalar(t)), t)
        return raised

    return form


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.appendix.singular_values",
        place="appendix, well-definedness",
        statement="Each A of positive determinant is R_α D R_β with two rotations and D diagonal, positive.",
        printed="A = R_α D R_β",
        verdict=Verdict.CONFIRMED,
        form=_singular,
        cases=_positive_maps,
        deviation=_no_singular_values,
        copies=(
            Copy("β from the negative difference", lambda a: (_singular(a)[0], -_singular(a)[1], *_singular(a)[2:])),
            Copy("the singular values exchanged", lambda a: (*_singular(a)[:2], *_singular(a)[:1:-1])),
        ),
        remark="Library routines give orthogonal factors, often both reflections: turn a column of one and the row of "
        "the other before angles are taken.",
    ),
    Claim(
        id="kaji_2d.appendix.polar_factors",
        place="appendix, well-definedness",
        statement="The polar factors by the singular value decomposition.",
        printed="R_θ = R_(α+β), S = R_(-β) D R_β",
        verdict=Verdict.CONFIRMED,
        form=_polar_factors(),
        cases=_factors,
        deviation=equals(_true_polar_factors),
        copies=(Copy("-β for β", _polar_factors(sign=-1)),),
        remark="α + β may leave (-π, π]: bring it back, or A^E makes a turn too many.",
    ),
    Claim(
        id="kaji_2d.appendix.conjugation",
        place="appendix, well-definedness",
        statement="The exponential commutes with a change of the basis.",
        printed="exp(U⁻¹ B U) = U⁻¹ exp(B) U for any U, B ∈ GL(2)",
        verdict=Verdict.CONFIRMED,
        form=_conjugated(),
        cases=_conjugations,
        deviation=equals(_exponential_of_conjugate),
        copies=(Copy("U and U⁻¹ exchanged on the right", _conjugated(back=True)),),
        remark="B may be singular too: the second case is.",
    ),
    Claim(
        id="kaji_2d.appendix.power",
        place="appendix, well-definedness",
        statement="The power S^t by the singular value decomposition.",
        printed="S^t = R_(-β) D^t R_β",
        verdict=Verdict.CONFIRMED,
        form=_power(),
        cases=_powers_and_times,
        deviation=equals(_true_power),
        copies=(Copy("-β for β", _power(sign=-1)),),
    ),
    Claim(
        id="kaji_2d.appendix.well_defined",
        place="section 3, after equation 3; appendix, well-definedness",
        statement="S^t does not depend on which singular value decomposition of A is taken: another, with the singular "
        "values exchanged and the angles moved by π/2, gives the same.",
        verdict=Verdict.CONFIRMED,
        form=_other_factors(_exchanged),
        cases=_powers_and_times,
        deviation=_depends,
        copies=(
            Copy("singular values exchanged, the angles left", _other_factors(lambda a, b, c, d: (a, b, d, c))),
            Copy("π added to one angle", _other_factors(lambda a, b, c, d: (a + mp.pi, b, c, d))),
        ),
    ),
    Claim(
        id="kaji_2d.appendix.logarithm",
        place="section 3, after equation 3",
        statement="S^t = exp(t log S) is well defined for a positive definite symmetric S.",
        verdict=Verdict.CONFIRMED,
        form=_power_of_exponential(lambda power, t: power),
        cases=_growths_and_times,
        deviation=equals(_logarithm_of_stretch),
        copies=(Copy("the inverse of it", _power_of_exponential(lambda power, t: definitions.inverse(mp, power))),),
        remark="log S is the one symmetric logarithm. Others, with S a multiple of I, turn by 2π.",
    ),
)
"""Well-definedness of the exponential."""
