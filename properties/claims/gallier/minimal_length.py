"""Section 5: the inner product of so(n), and which logarithm makes the shortest curve."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.gallier.similarities import skew
from affinecert.properties.claims.gallier.strategy_1 import Choice, second_choice, strategy_1
from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference import measures
from affinecert.reference._matrices import Array, Number, cross_matrix, dot, norm


def _vectors(name: str) -> list[tuple[Array, Array]]:
    simple = [(exactly([1, 0, 0]), exactly([0, 1, 0])), (exactly([1, 2, 3]), exactly([1, 2, 3]))]
    return simple + list(zip(arrays(name, 4, (3,), -3, 3), arrays(name + "'", 4, (3,), -3, 3), strict=True))


def _inner(a: Array, b: Array, half: int = 2) -> tuple[Number, Number]:
    """Both printed forms of the inner product of skew matrices."""
    return (a.T @ b).trace() / half, -(a @ b).trace() / half


def _inner_misses(form: Any, case: tuple[Array, Array]) -> Number:
    due = dot(mp, *case)
    return max(abs(each - due) for each in form(*(cross_matrix(mp, v) for v in case)))


def _adjoint_cases() -> list[tuple[Array, Array, Array]]:
    """Two skew matrices and a rotation, of R^3 and R^4."""
    space = [(cross_matrix(mp, a), cross_matrix(mp, b)) for a, b in _vectors("adjoint")[2:]]
    found = [(*pair, r) for pair, r in zip(space, rotations("adjoint", 4), strict=True)]
    a, b, c = (skew(each, 4) for each in arrays("adjoint 4", 3, (6,), -1, 1))
    return [*found, (a, b, definitions.exponential(mp, c))]


def _not_invariant(form: Any, case: tuple[Array, Array, Array]) -> Number:
    a, b, r = case
    return abs(form(r @ a @ r.T, r @ b @ r.T)[0] - form(a, b)[0])


def _shortest(before: Array, w: Array) -> Array:
    """The logarithm of the two whose curve from the one before is the shortest, in truth."""
    return min((w, second_choice(w)), key=lambda vector: _curve_length(before, vector))


def _curve_length(first: Array, second: Array) -> Number:
    with mp.workdps(40):
        return measures.rotation_curve_length(mp, first, second)[()]


def _two_ways() -> list[tuple[Array, Array]]:
    x = exactly([1, 0, 0])
    return [(x, x / 2), (exactly([-2, 0, 0]), x), (exactly([-2, 2, 0]), x), (exactly([-1, 2, 0]), 2 * x)]


def _longer_curve(form: Choice, case: tuple[Array, Array]) -> Number:
    """By how much the curve to the logarithm taken is longer than that to the other one, if it is."""
    before, w = case
    least = min(_curve_length(before, each) for each in (w, second_choice(w)))
    return max(_curve_length(before, form(before, w)) - least, mp.zero)


def _lengths_of_curves() -> dict[str, Any]:
    before, w = _two_ways()[2]
    found = {}
    for name, vector in (("B'", w), ("B''", second_choice(w))):
        found[f"distance to {name}"] = float(norm(mp, vector - before))
        found[f"length to {name}"] = float(_curve_length(before, vector))
    return found


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.5.inner_product",
        place="section 5, the inner product",
        statement="tr(B_1ᵀB_2)/2 = -tr(B_1B_2)/2 is the scalar product of the vectors (a, b, c) of the skew matrices.",
        printed="<B_1, B_2> = (1/2) tr(B_1ᵀ B_2) = -(1/2) tr(B_1 B_2)",
        verdict=Verdict.CONFIRMED,
        form=_inner,
        cases=lambda: _vectors("inner"),
        deviation=_inner_misses,
        copies=(Copy("without 1/2", lambda a, b: _inner(a, b, 1)),),
    ),
    Claim(
        id="gallier.5.bi_invariant",
        place="section 5 and section 10",
        statement="The inner product of so(n) is invariant under rotations, B ↦ RBRᵀ, and so the metric is "
        "bi-invariant.",
        verdict=Verdict.CONFIRMED,
        form=_inner,
        cases=_adjoint_cases,
        deviation=_not_invariant,
        copies=(
            Copy(
                "twice the weight on the entry (1, 2)",
                lambda a, b: ((a.T @ b).trace() / 2 + a[0, 1] * b[0, 1], -(a @ b).trace() / 2),
            ),
        ),
    ),
    Claim(
        id="gallier.5.metric",
        place="section 5, the intended motion",
        statement="The intended motion between two similarities minimises the length of e^{(1-t)X_1 + tX_2} in SIM(3).",
        verdict=Verdict.UNCHECKABLE,
        reason="a definition, and one that is left open: a metric is given for rotations only, none for "
        "SIM(3), and no logarithm is chosen by its scale or its translation",
    ),
    Claim(
        id="gallier.5.minimise",
        place="abstract, and section 5, before the two strategies",
        statement="Of the logarithms of R_2, the one nearest to B_1 makes the shortest curve e^{(1-t)B_1 + tB_2}.",
        printed="in order to minimize the length L(γ) = ||B_2 - B_1|| of the curve segment γ, it suffices to pick B_2 "
        "so that ||B_2 - B_1|| is minimized",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=strategy_1,
        cases=_two_ways,
        deviation=_longer_curve,
        correction=Correction(
            statement="Of the two logarithms of strategy 1 take the one whose curve is shorter, its length being the "
            "integral of |dexp(B_2 - B_1)|. Rotations about one axis need no more than ||B_2 - B_1||.",
            form=_shortest,
        ),
        copies=(Copy("the principal logarithm", lambda before, w: w),),
        numbers=_lengths_of_curves,
        remark="L is not ||B_2 - B_1|| unless B_1 and B_2 commute. At rotation vectors (-2, 2, 0) and (1, 0, 0) the "
        "nearer logarithm makes the longer curve, by a fifth. The strategies take the nearest logarithm, and no more.",
    ),
)
