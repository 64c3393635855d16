"""Section 3: the determinant of A^P, which of the earlier homotopies degenerate, and figure 1."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import numbers, plane_rotation
from affinecert.properties.claims.kaji_2d.homotopies import exponential, linear, polar
from affinecert.properties.claims.kaji_2d.plane import (
    angle,
    determinant,
    maps,
    singular_values,
    zero_or_one,
)
from affinecert.properties.claims.precision import HOLDS, equals, mp
from affinecert.reference import homotopy2
from affinecert.reference._matrices import Array, Context, Number, array, scalar

Homotopy = Callable[[Array, Number], Array]
"""A(t), a function of A and t."""

TIMES = tuple(mp.mpf(k) / 8 for k in range(-40, 41))
"""Times on both sides of [0, 1]."""


def stretched(theta: Number, first: Number, second: Number) -> Array:
    """A map that turns by an angle, with these singular values; its axes are tilted."""
    tilt = plane_rotation(mp.mpf(1) / 3)
    product: Array = plane_rotation(theta) @ tilt @ array([[first, mp.zero], [mp.zero, second]]) @ tilt.T
    return product


def _maps_and_times() -> list[tuple[Array, Number]]:
    drawn = maps("determinant", 6)
    return list(zip(drawn, numbers("determinant", len(drawn), -2, 3), strict=True))


def _of_polar(m: Context, a: Array, t: Number) -> Number:
    return determinant(homotopy2.polar(m, a, scalar(t)))


def _product_of_growth(values: Any, sign: int = -1) -> Any:
    def printed(m: Context, a: Array, t: Number) -> Number:
        first, second = values(a)
        return ((first + sign) * t + 1) * ((second + sign) * t + 1)

    return printed


def _eigenvalues(a: Array) -> tuple[Number, Number]:
    middle, product = (a[0, 0] + a[1, 1]) / 2, determinant(a)
    root = mp.sqrt(mp.mpc(middle**2 - product))
    return middle + root, middle - root


def _vanishing(sign: int) -> Any:
    return lambda value: 1 / (1 + sign * value)


def _determinant_there(time: Any, case: tuple[Number, Number, Number]) -> Number:
    """The determinant of A^P at the time that belongs to the first of two singular values."""
    theta, first, second = case
    return abs(determinant(polar(stretched(theta, first, second), time(first))))


def _never_negative(homotopy: Homotopy, case: tuple[Number, Number, Number]) -> int:
    """Whether the determinant is nowhere negative, in times 1/8 apart and between those where a factor vanishes."""
    a = stretched(*case)
    ends = [1 / (1 - value) for value in case[1:] if value != 1]
    return zero_or_one(
        all(determinant(homotopy(a, t)) > -HOLDS for t in (*TIMES, sum(ends) / 2, *(4 * e for e in ends)))
    )


def _degenerates(homotopy: Homotopy, a: Array) -> int:
    """Whether it stays a map of positive determinant at all times that are tried."""
    return zero_or_one(all(determinant(homotopy(a, t)) > HOLDS for t in TIMES))


def logarithmic(a: Array, t: Number) -> Array:
    """The map exp(t log A) of Alexa 2002, of a map without negative eigenvalues: the Lagrange polynomial."""
    first, second = _eigenvalues(a)
    identity = array([[mp.one, mp.zero], [mp.zero, mp.one]])
    if first == second:
        nilpotent = a - first * identity
        whole = first**t * identity + t * first ** (t - 1) * nilpotent
    else:
        whole = (first**t * (a - second * identity) - second**t * (a - first * identity)) / (first - second)
    return array([[each.real for each in row] for row in whole])


def by_singular_values(a: Array, t: Number) -> Array:
    """R_(tα) ((1 - t) I + t D) R_(tβ) with A = R_α D R_β, one of the methods that Alexa et al. 2000 discuss."""
    first, second = singular_values(a)
    (p, q), (_, r) = a.T @ a
    beta = -mp.atan2(2 * q, p - r) / 2
    diagonal = array([[first, mp.zero], [mp.zero, second]])
    moved: Array = plane_rotation(t * (angle(a) - beta)) @ linear(diagonal, t) @ plane_rotation(t * beta)
    return moved


PREVIOUS: Mapping[str, Homotopy] = {
    "linear": linear,
    "polar, linear": polar,
    "singular values, linear": by_singular_values,
    "exp(t log A)": logarithmic,
}


def _previous_degenerates(methods: Mapping[str, Homotopy], case: tuple[str, Array]) -> int:
    name, a = case
    return _degenerates(methods[name], a)


FIGURE_1 = stretched(mp.pi / 3, mp.mpf(1.25), mp.mpf(1) / 11)
"""A map whose A^P collapses at t = 1.1."""


def _like_the_figure(methods: tuple[Homotopy, Homotopy], t: Number) -> int:
    """Whether the signs of the areas are others than: above, turned over after 1.1; below, positive."""
    above, below = (determinant(method(FIGURE_1, t)) for method in methods)
    collapse = mp.mpf(11) / 10
    expected = mp.sign(collapse - t) if abs(t - collapse) > HOLDS else 0
    found = mp.sign(above) if abs(above) > HOLDS else 0
    return zero_or_one(found != expected or below <= 0)


def _figure_1() -> Mapping[str, Any]:
    times = [mp.mpf(k) / 100 for k in (0, 50, 100, 110, 135)]
    areas = {
        name: tuple(mp.chop(determinant(each(FIGURE_1, t))) for t in times)
        for name, each in (("A^P", polar), ("A^E", exponential))
    }
    return {f"area by {name} at t = 0, 0.5, 1, 1.1, 1.35": found for name, found in areas.items()}


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.3.determinant_A_P",
        place="section 3, det A^P",
        statement="The determinant of A^P is the product of what becomes of the two singular values.",
        printed="det A^P(t) = ((λ₁ - 1) t + 1) ((λ₂ - 1) t + 1)",
        verdict=Verdict.CONFIRMED,
        form=_product_of_growth(singular_values),
        cases=_maps_and_times,
        deviation=equals(_of_polar),
        copies=(
            Copy("λ + 1 for λ - 1", _product_of_growth(singular_values, sign=1)),
            Copy("eigenvalues of A for singular values", _product_of_growth(_eigenvalues)),
        ),
    ),
    Claim(
        id="kaji_2d.3.determinant_A_P_vanishes",
        place="section 3, before det A^P",
        statement="The determinant of A^P can vanish: at t = 1 / (1 - λ).",
        verdict=Verdict.CONFIRMED,
        form=_vanishing(-1),
        cases=lambda: [
            (mp.mpf(theta), mp.mpf(first), mp.mpf(second))
            for theta, first, second in ((0, 0.5, 1), (0, 2, 1), (1, 0.125, 3), (-3, 4, 0.5), (2, 2, 2))
        ],
        deviation=_determinant_there,
        copies=(Copy("λ + 1 for λ - 1", _vanishing(1)),),
        remark="Never between 0 and 1: t is at least 1 for λ < 1, and negative for λ > 1.",
    ),
    Claim(
        id="kaji_2d.3.determinant_A_P_negative",
        place="section 3, after det A^P",
        statement="The determinant of A^P becomes negative for some t if a singular value is not 1.",
        printed="det A^P(t) becomes negative for some t when λ₁ ≠ 1 or λ₂ ≠ 1",
        verdict=Verdict.BOUND,
        domain="λ₁ ≠ λ₂; for similarities it is a square, and vanishes without a change of sign",
        form=polar,
        cases=lambda: [
            (mp.mpf(1), mp.mpf(first), mp.mpf(second))
            for first, second in ((2, 1), (0.5, 1), (2, 3), (0.5, 3), (1, 1.0625), (2, 2.0625))
        ],
        outside=lambda: [
            (mp.mpf(theta), mp.mpf(s), mp.mpf(s)) for theta, s in ((0, 2), (1, 0.5), (-2, 3), (3, 1.0625))
        ],
        deviation=_never_negative,
        copies=(Copy("A^E for A^P", exponential),),
    ),
    Claim(
        id="kaji_2d.3.previous_methods",
        place="section 3, non-degeneracy",
        statement="None of the previous methods always gives a map of positive determinant.",
        printed="Unfortunately, none of previous methods satisfy it.",
        verdict=Verdict.BOUND,
        domain="methods that mix A, S or singular values linearly; exp(t log A) [Ale02] has the determinant (det A)^t",
        form=PREVIOUS,
        cases=lambda: [(name, stretched(mp.pi, mp.mpf(0.5), mp.mpf(0.25))) for name in list(PREVIOUS)[:3]],
        outside=lambda: [("exp(t log A)", a) for a in maps("logarithm", 5) if a[0, 0] >= 0],
        deviation=_previous_degenerates,
        copies=(Copy("A^E for the method of equation 2", {**PREVIOUS, "polar, linear": exponential}),),
        remark="What [Ale02] lacks is existence: a map with two different negative eigenvalues has no real logarithm.",
    ),
    Claim(
        id="kaji_2d.3.singular_value_methods",
        place="section 3, before the remark",
        statement="The methods of Alexa et al. by singular values fail by a similar argument: the determinant is the "
        "same product.",
        verdict=Verdict.CONFIRMED,
        form=lambda m, a, t: determinant(by_singular_values(a, t)),
        cases=_maps_and_times,
        deviation=equals(_product_of_growth(singular_values)),
        copies=(
            Copy("powers of the singular values instead", lambda m, a, t: determinant(exponential(a, t))),
            Copy("A mixed linearly instead", lambda m, a, t: determinant(linear(a, t))),
        ),
        remark="For A = R_α D R_β the method R_(tα) ((1 - t) I + t D) R_(tβ).",
    ),
    Claim(
        id="kaji_2d.figure_1.collapse",
        place="figure 1",
        statement="Extrapolated to t = 1.35, a triangle collapses by A^P around t = 1.1 and turns over; by A^E never.",
        verdict=Verdict.CONFIRMED,
        form=(polar, exponential),
        cases=lambda: [mp.mpf(k) / 100 for k in (0, 25, 50, 75, 100, 109, 110, 111, 120, 135)],
        deviation=_like_the_figure,
        copies=(
            Copy("A^E above", (exponential, exponential)),
            Copy("A^P below", (polar, polar)),
        ),
        numbers=_figure_1,
        remark="On a triangle of our own: the figure's is not given. A collapse at 1.1 needs a singular value 1/11.",
    ),
)
"""What degenerates."""
