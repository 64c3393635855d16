"""Appendix A.2: the exponential of a 2x2 matrix C in closed form, by its eigenvalues."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.definitions import eigenvalues, exponential, inverse
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import distance, equals, exactly, mp, size
from affinecert.reference._matrices import Array, Context, Number, array


def _d(m: Context, c: Array) -> Number:
    """The printed d_C."""
    return ((c[0, 0] + c[1, 1]) / 2) ** 2 - (c[0, 0] * c[1, 1] - c[0, 1] * c[1, 0])


def _d_with(sign: int, divisor: int = 2) -> Any:
    def printed(m: Context, c: Array) -> Number:
        return ((c[0, 0] + c[1, 1]) / divisor) ** 2 - (c[0, 0] * c[1, 1] + sign * c[0, 1] * c[1, 0])

    return printed


def _no_gap(form: Any, case: tuple[Array]) -> Number:
    """How far from the square of half the difference of the eigenvalues, relative to the square of C."""
    (c,) = case
    first, second = eigenvalues(mp, c)
    return abs(form(mp, c) - ((first - second) / 2) ** 2) / size(c) ** 2


def _lambdas(m: Context, c: Array, divisor: int = 2) -> tuple[Number, Number]:
    mean, root = (c[0, 0] + c[1, 1]) / divisor, m.sqrt(_d(m, c))
    return mean + root, mean - root


def _no_roots(form: Any, case: tuple[Array]) -> Number:
    """How far two numbers are from the roots of the characteristic polynomial, by their sum and product."""
    (c,) = case
    first, second = form(mp, c)
    trace, det = c[0, 0] + c[1, 1], c[0, 0] * c[1, 1] - c[0, 1] * c[1, 0]
    return max(distance(first + second, trace), distance(first * second, det))


def _vectors(m: Context, c: Array, sign: int = -1) -> Array:
    """The printed V."""
    root, z = m.sqrt(_d(m, c)), (c[0, 0] - c[1, 1]) / 2
    return array([[c[0, 1] / (root - z), sign * c[0, 1] / (root + z)], [m.one, m.one]])


def _no_eigenvectors(form: Any, case: tuple[Array]) -> Number:
    """How far C V is from V diag(λ_1, λ_2); infinite where the columns of V are dependent."""
    (c,) = case
    v = form(mp, c)
    if abs(v[0, 0] * v[1, 1] - v[0, 1] * v[1, 0]) < mp.mpf(10) ** -30 * size(v):
        return mp.inf
    return distance(c @ v, v * array(list(_lambdas(mp, c))))


def _based(m: Context, c: Array, basis: Array) -> Array:
    found: Array = basis @ exponential(m, c) @ inverse(m, basis)
    return found


def _transposed(m: Context, c: Array, basis: Array) -> Array:
    found: Array = basis @ exponential(m, c) @ basis.T
    return found


def _exponential_in(m: Context, c: Array, basis: Array) -> Array:
    return exponential(m, basis @ c @ inverse(m, basis))


def _equation_11(sign: int = 1, *, exchanged: bool = False) -> Any:
    """The printed matrix; for ``exchanged`` with C_2 and C_3 in each other's place."""

    def printed(m: Context, c: Array, t: Number) -> Array:
        root, z = m.sqrt(_d(m, c)), (c[0, 0] - c[1, 1]) / 2
        first, second = (m.exp(each * t) for each in _lambdas(m, c))
        c2, c3 = (c[1, 0], c[0, 1]) if exchanged else (c[0, 1], c[1, 0])
        upper = ((root + z) * first + sign * (root - z) * second) / root
        lower = ((root - z) * first + sign * (root + z) * second) / root
        gap = (first - second) / root
        whole: Array = array([[upper, c2 * gap], [c3 * gap, lower]]) / 2
        return whole

    return printed


def _true(m: Context, c: Array, t: Number) -> Array:
    return exponential(m, t * c)


def _imaginary(form: Any, case: tuple[Array, Number]) -> Number:
    """The largest imaginary part, relative to the largest number."""
    found = form(mp, *case)
    return max(abs(mp.im(each)) for each in found.flat) / size(found)


def _matrices() -> list[Array]:
    simple = [[[0, 1], [1, 0]], [[0, -1], [1, 0]], [[1, 2], [3, 4]]]
    drawn = [each for each in arrays("C", 7, (2, 2), -2, 2) if _d(mp, each) and each[0, 1] and each[1, 0]]
    return [*map(exactly, simple), *drawn]


def _triangular() -> list[Array]:
    """With c_2 or c_3 or both zero."""
    return [exactly(each) for each in ([[1, 0], [0, 2]], [[1, 0], [3, 2]], [[2, 5], [0, -1]], [[0, 0], [0, -1]])]


def _double() -> list[Array]:
    return [exactly(each) for each in ([[0, 1], [0, 0]], [[1, 1], [-1, 3]])]


def _timed(matrices: list[Array]) -> list[tuple[Array, Number]]:
    return [(c, mp.mpf(k + 1) / 3) for k, c in enumerate(matrices)]


def _turning() -> list[tuple[Array, Number]]:
    drawn = arrays("turning", 16, (2, 2), -2, 2)
    return [case for case in _timed([exactly([[0, -1], [1, 0]]), *drawn]) if _d(mp, case[0]) < 0]


_NEAR = [[0.0, 1.0], [1e-20, 0.0]]
_MEETING = [[1.0, 1.0], [1e-30, 1.0]]

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.A.2.d_C",
        place="appendix A.2",
        statement="d_C is positive, zero or negative as the eigenvalues of C are real, equal or complex: it is the "
        "square of half their difference.",
        printed="d_C = ((c_1 + c_4) / 2)² - (c_1 c_4 - c_2 c_3)",
        verdict=Verdict.CONFIRMED,
        form=_d,
        cases=lambda: [(c,) for c in (*_matrices(), *_triangular(), *_double())],
        deviation=_no_gap,
        copies=(Copy("c_1 c_4 + c_2 c_3", _d_with(1)), Copy("the trace not halved", _d_with(-1, 1))),
        remark="The discriminant of the characteristic polynomial, which the text calls it, is 4 d_C. As printed d_C "
        "cancels where eigenvalues are close; z² + c_2 c_3 is better.",
        losses=(
            Loss(
                where="eigenvalues 1 ± 1e-10",
                formula=_d,
                truth=_d,
                at=([[1.0, 1.0], [1e-20, 1.0]],),
                digits=16,
            ),
            Loss(
                where="eigenvalues 1 ± 1e-4",
                formula=_d,
                truth=_d,
                at=([[1.0, 1.0], [1e-8, 1.0]],),
                digits=8,
            ),
        ),
    ),
    Claim(
        id="rossignac_vinacua.A.2.eigenvalues",
        place="appendix A.2",
        statement="The eigenvalues of C are (c_1 + c_4) / 2 ± sqrt(d_C), complex ones too.",
        printed="λ = (c_1 + c_4) / 2 ± sqrt(d_C)",
        verdict=Verdict.CONFIRMED,
        form=_lambdas,
        cases=lambda: [(c,) for c in (*_matrices(), *_triangular(), *_double())],
        deviation=_no_roots,
        copies=(Copy("the trace not halved", lambda m, c: _lambdas(m, c, 1)),),
    ),
    Claim(
        id="rossignac_vinacua.A.2.eigenvectors",
        place="appendix A.2",
        statement="The columns of V are linearly independent eigenvectors of C.",
        printed="V = (c_2 / (sqrt(d_C) - z), -c_2 / (sqrt(d_C) + z); 1, 1), z = (c_1 - c_4) / 2",
        verdict=Verdict.BOUND,
        domain="c_2 c_3 ≠ 0 and d_C ≠ 0; sqrt(d_C) = ±z if c_2 or c_3 is 0, and the columns agree if d_C is",
        form=_vectors,
        cases=lambda: [(c,) for c in _matrices()],
        outside=lambda: [(c,) for c in (*_triangular(), _double()[1])],
        deviation=_no_eigenvectors,
        copies=(Copy("c_2 for -c_2", lambda m, c: _vectors(m, c, 1)),),
        remark="Formula 11, which is derived by it, holds there all the same as long as d_C ≠ 0.",
    ),
    Claim(
        id="rossignac_vinacua.A.2.change_of_basis",
        place="appendix A.2",
        statement="The exponential commutes with a change of basis.",
        printed="e^(V D V⁻¹) = V e^D V⁻¹",
        verdict=Verdict.CONFIRMED,
        form=_based,
        cases=lambda: list(zip(_matrices(), arrays("bases", len(_matrices()), (2, 2), -2, 2), strict=True)),
        deviation=equals(_exponential_in),
        copies=(Copy("the transpose for the inverse", _transposed),),
    ),
    Claim(
        id="rossignac_vinacua.A.2.equation_11",
        place="equation 11",
        statement="The exponential of t C in closed form, for d_C ≠ 0.",
        printed="e^(tC) = 1/2 (((√d + z) e^(λ_1 t) + (√d - z) e^(λ_2 t)) / √d, (c_2 / √d)(e^(λ_1 t) - e^(λ_2 t)); "
        "(c_3 / √d)(e^(λ_1 t) - e^(λ_2 t)), ((√d - z) e^(λ_1 t) + (√d + z) e^(λ_2 t)) / √d)",
        verdict=Verdict.CONFIRMED,
        form=_equation_11(),
        cases=lambda: _timed(_matrices()),
        deviation=equals(_true),
        copies=(
            Copy("minus in the diagonal", _equation_11(-1)),
            Copy("c_2 and c_3 exchanged", _equation_11(exchanged=True)),
        ),
        losses=(
            Loss(
                where="eigenvalues ±1e-10: their exponentials cancel",
                formula=_equation_11(),
                truth=_true,
                at=(_NEAR, 1.0),
                digits=10,
            ),
            Loss(
                where="eigenvalues 1 ± 1e-15: d_C is 0",
                formula=_equation_11(),
                truth=_true,
                at=(_MEETING, 1.0),
                digits=16,
            ),
        ),
        remark="e^(mt) (cosh(st) + sinh(st)/s (C - m)), m = (c_1 + c_4)/2, s² = z² + c_2 c_3, with sinh(x)/x as a "
        "function of its own (sin(x)/x for s² < 0) loses nothing and includes d_C = 0.",
    ),
    Claim(
        id="rossignac_vinacua.A.2.real",
        place="appendix A.2",
        statement="For real C equation 11 is real also where d_C < 0: sums of the exponentials are real, differences "
        "imaginary.",
        verdict=Verdict.CONFIRMED,
        form=_equation_11(),
        cases=_turning,
        deviation=_imaginary,
        copies=(Copy("minus in the diagonal", _equation_11(-1)),),
    ),
    Claim(
        id="rossignac_vinacua.A.2.special",
        place="appendix A.2",
        statement="Equation 11 holds where c_2 or c_3 or both are zero, although the eigenvectors V do not.",
        verdict=Verdict.CONFIRMED,
        form=_equation_11(),
        cases=lambda: _timed(_triangular()),
        deviation=equals(_true),
        copies=(
            Copy("minus in the diagonal", _equation_11(-1)),
            Copy("c_2 and c_3 exchanged", _equation_11(exchanged=True)),
        ),
    ),
)
