"""Section 4.4, table 2: maps through their parameters and back, in float64."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from affinecert.map import Array
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.kaji_ochiai import closed_forms
from affinecert.properties.claims.kaji_ochiai.float_accuracy import COUNT, Method, random_frames

TABLE_2 = "section 4.4, table 2, errors"


@cache
def _flat(least: float) -> Array:
    """Linear maps of positive determinant, whose least singular value is given and the others between 1/2 and 2."""
    generator = np.random.default_rng(7)
    stretch = generator.uniform(0.5, 2, (COUNT, 3))
    stretch[:, 2] = least
    left, right = random_frames(generator, COUNT), random_frames(generator, COUNT)
    linears = (left * stretch[:, None, :]) @ right
    return np.asarray(linears * np.sign(np.linalg.det(linears))[:, None, None])


def _skewness(split: Any, least: float) -> float:
    """The median of how far R^T R is from I, for the rotations that are split off flat maps; infinite if undefined."""
    with np.errstate(all="ignore"):
        turns, _ = split(_flat(least))
        found = float(np.median(np.linalg.norm(turns.transpose(0, 2, 1) @ turns - np.eye(3), axis=(1, 2))))
    return found if np.isfinite(found) else float("inf")


def _does_not_grow(split: Any, least: float) -> int:
    """Whether the error grows by less than a hundred times, where a least singular value of 1 is made smaller."""
    return int(_skewness(split, least) < 100 * _skewness(split, 1.0))


def _wrong(split: Any, least: float) -> float:
    """How far the round trip of flat maps errs beyond 1e-12, in the median, in parts of that."""
    with np.errstate(all="ignore"):
        back = closed_forms.round_trip(split)(_flat(least))
        error = float(np.median(np.linalg.norm(back - _flat(least), axis=(1, 2))))
    return max(error / 1e-12 - 1, 0.0) if np.isfinite(error) else float("inf")


@cache
def _random_linears() -> Array:
    linears = np.random.default_rng(3).normal(size=(120, 3, 3))
    return np.asarray(linears * np.sign(np.linalg.det(linears))[:, None, None])


def _without_logarithm() -> Array:
    """Which of the random matrices have a negative eigenvalue."""
    eigenvalues = np.linalg.eigvals(_random_linears())
    return np.asarray(((np.abs(eigenvalues.imag) < 1e-12) & (eigenvalues.real < 0)).any(axis=1))


def _squared_errors(method: Method) -> Array:
    linears = _random_linears()
    with np.errstate(all="ignore"):
        return np.asarray(np.linalg.norm(method(linears) - linears, axis=(1, 2)) ** 2)


OURS = closed_forms.round_trip(closed_forms.factors)


HIGHAM = closed_forms.round_trip(closed_forms.factors_by_higham)


def _not_huge(method: Method, _: None) -> int:
    """Whether a method errs little without a logarithm, or much with one."""
    errors, without = _squared_errors(method), _without_logarithm().astype(bool)
    return int(errors[without].max() < 1 or errors[np.logical_not(without)].max() > 1e-16)


def _errs(method: Method, _: None) -> float:
    return max(float(_squared_errors(method).max()) / 1e-8 - 1, 0.0)


def _errors_of_table_2() -> Mapping[str, Any]:
    rows = {"ours": OURS, "Higham's polar factor, then closed forms": HIGHAM, "Alexa": closed_forms.alexa_round_trip}
    numbers = {f"{name}, worst squared error": f"{_squared_errors(rows[name]).max():.2g}" for name in rows}
    return numbers | {"share without a logarithm": f"{_without_logarithm().mean():.2g}"}


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.4.4.small_determinants",
        place="section 4.4, second paragraph",
        statement="For maps of very small determinant the error of the closed forms grows: R = ÂS⁻¹ is no rotation.",
        verdict=Verdict.CONFIRMED,
        form=closed_forms.factors,
        cases=lambda: [1e-2, 1e-4, 1e-6],
        deviation=_does_not_grow,
        copies=(Copy("Higham's iteration for the polar factor", closed_forms.factors_by_higham),),
        numbers=lambda: {
            f"RᵀR - I, least singular value {least:g}": f"{_skewness(closed_forms.factors, least):.2g}"
            for least in (1.0, 1e-2, 1e-4, 1e-6, 1e-8)
        },
        remark="It grows as the square of the condition, for ᵗÂÂ squares it: at 1e-8 nothing is left.",
    ),
    Claim(
        id="kaji_ochiai.4.4.higham_first",
        place="section 4.4, second paragraph",
        statement="With Higham's iteration for the polar decomposition, the formulae do for nearly singular maps.",
        verdict=Verdict.CONFIRMED,
        form=closed_forms.factors_by_higham,
        cases=lambda: [1e-2, 1e-4, 1e-6, 1e-8],
        deviation=_wrong,
        copies=(Copy("the polar factor by equations 7 and 6", closed_forms.factors),),
    ),
    Claim(
        id="kaji_ochiai.4.4.higham_efficiency",
        place="section 4.4, second paragraph",
        statement="Higham's iteration is more efficient than a singular value decomposition.",
        verdict=Verdict.UNCHECKABLE,
        reason="Times are those of a machine and of two implementations, which are not named.",
    ),
    Claim(
        id="kaji_ochiai.4.4.alexa_error",
        place=TABLE_2 + "; section 4.4, last paragraph",
        statement="Due to the lack of surjectivity, and only to that, Alexa's method has a huge error.",
        verdict=Verdict.CONFIRMED,
        form=closed_forms.alexa_round_trip,
        cases=lambda: [None],
        deviation=_not_huge,
        copies=(Copy("the parametrisation of the paper", OURS),),
        numbers=_errors_of_table_2,
        remark="Of matrices with normal entries and positive determinant about a third have no logarithm.",
    ),
    Claim(
        id="kaji_ochiai.4.4.own_error",
        place=TABLE_2,
        statement="The parametrisation of the paper gives random maps back: squared errors are below 1e-8.",
        verdict=Verdict.CONFIRMED,
        form=OURS,
        cases=lambda: [None],
        deviation=_errs,
        copies=(Copy("the real part of the logarithm, Alexa's method", closed_forms.alexa_round_trip),),
    ),
)
