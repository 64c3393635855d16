"""Section 4.4, table 1: what closed forms, Padé approximants and diagonalisation lose in float64."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import numpy as np

from affinecert.map import Array
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.kaji_ochiai import closed_forms
from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference import sym3

COUNT = 48
"""Matrices of a regime."""


TABLE_1 = "section 4.4, table 1, errors"


Method = Callable[[Array], Array]


def random_frames(generator: np.random.Generator, count: int) -> Array:
    """Random orthogonal matrices, (count, 3, 3)."""
    return np.asarray(np.linalg.qr(generator.normal(size=(count, 3, 3)))[0])


@cache
def _symmetric(regime: str) -> Array:
    """Symmetric matrices: with eigenvalues apart, with two or three within a gap, or multiples of I."""
    generator = np.random.default_rng(list(regime.encode()))
    kind, _, gap = regime.partition(" ")
    spread = generator.normal(size=(COUNT, 3)) * (1.5 if kind == "generic" else float(gap or 0))
    if kind == "double":
        spread[:, 2] = generator.uniform(-2, 2, COUNT)
    if kind == "triple":
        return np.asarray(np.eye(3) * (np.arange(-COUNT // 2, COUNT // 2) / 16)[:, None, None])
    if kind != "generic":
        spread += generator.normal(size=(COUNT, 1))
    frames = random_frames(generator, COUNT)
    matrices = (frames * spread[:, None, :]) @ frames.transpose(0, 2, 1)
    return np.asarray((matrices + matrices.transpose(0, 2, 1)) / 2)


@cache
def _exponentials(regime: str) -> tuple[Array, Array]:
    """Matrices and the truth: their exponentials, rounded."""
    matrices = _symmetric(regime)
    return matrices, np.array([sym3.exp(mp, exactly(each)) for each in matrices], dtype=np.float64)


@cache
def _logarithms(regime: str) -> tuple[Array, Array]:
    """Positive definite matrices and the truth: their logarithms, rounded."""
    if regime == "triple":
        values = np.arange(1, COUNT + 1) / 16
        return np.eye(3) * values[:, None, None], np.eye(3) * np.log(values)[:, None, None]
    matrices = _exponentials(regime)[1] if regime != "identity" else np.eye(3) + 1e-8 * _symmetric("generic")
    return matrices, np.array([sym3.log(mp, exactly(each)) for each in matrices], dtype=np.float64)


def _worst(method: Method, given: tuple[Array, Array]) -> float:
    """The largest error of a method, relative to the truth in the Frobenius norm; infinite if it is not a number."""
    with np.errstate(all="ignore"):
        errors = np.linalg.norm(method(given[0]) - given[1], axis=(1, 2))
    worst = float((errors / np.maximum(np.linalg.norm(given[1], axis=(1, 2)), 1e-300)).max())
    return worst if np.isfinite(worst) else float("inf")


def _beyond(most: float, truths: Any) -> Any:
    """How far the worst error in a regime is beyond a bound, in parts of that."""
    return lambda method, regime: max(_worst(method, truths(regime)) / most - 1, 0.0)


def _table(methods: Mapping[str, Method], truths: Any, *regimes: str) -> Any:
    def numbers() -> Mapping[str, Any]:
        return {
            f"{name}, {regime}": f"{_worst(method, truths(regime)):.2g}"
            for regime in regimes
            for name, method in methods.items()
        }

    return numbers


EXPONENTIALS: Mapping[str, Method] = {
    "closed form": closed_forms.exponential,
    "Padé": closed_forms.pade_exponential,
    "diagonalisation": closed_forms.diagonalised(np.exp),
}


LOGARITHMS: Mapping[str, Method] = {
    "closed form": closed_forms.logarithm,
    "Padé": closed_forms.pade_logarithm,
    "diagonalisation": closed_forms.diagonalised(np.log),
}


def _approximated(x: Array) -> Array:
    return 0.5 + x / 6 + x * x / 24


def _quotient(x: Array) -> Array:
    return (np.exp(x) - 1 - x) / x**2


def _rough_l2(x: Array) -> Array:
    """L2 without the second order."""
    d = x - 1
    return np.where(np.abs(d) < closed_forms.SMALL, -d / 2, (np.log(x) - d) / np.where(d == 0, 1.0, d))


def _slipped_l2(x: Array) -> Array:
    """L2 with a wrong approximation near 1."""
    d = x - 1
    return np.where(np.abs(d) < 0.125, -d / 2 + d * d / 4, closed_forms.l2(x))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.4.4.exp.generic",
        place=TABLE_1,
        statement="On random matrices the closed exponential errs by less than 1e-14.",
        verdict=Verdict.CONFIRMED,
        form=closed_forms.exponential,
        cases=lambda: ["generic"],
        deviation=_beyond(1e-14, _exponentials),
        copies=(
            Copy("the approximation of e2 for all arguments", lambda y: closed_forms.exponential(y, _approximated)),
        ),
        numbers=_table(EXPONENTIALS, _exponentials, "generic"),
        remark="The cells of the table are lost. Numbers are worst errors of 48 matrices, relative in the Frobenius "
        "norm: it does better than both competitors.",
    ),
    Claim(
        id="kaji_ochiai.4.4.exp.coinciding",
        place=TABLE_1,
        statement="So it does where eigenvalues coincide or nearly do, with the approximation of e2.",
        verdict=Verdict.BOUND,
        domain="two eigenvalues coincide, or three nearly; not all three exactly, where b and c are 0/0",
        form=closed_forms.exponential,
        cases=lambda: ["double 1e-3", "double 1e-6", "double 1e-12", "nearly 1e-3", "nearly 1e-8", "nearly 1e-12"],
        outside=lambda: ["triple"],
        deviation=_beyond(1e-14, _exponentials),
        copies=(Copy("e2 as defined", lambda y: closed_forms.exponential(y, _quotient)),),
        numbers=_table(EXPONENTIALS, _exponentials, "double 1e-6", "nearly 1e-8", "triple"),
        remark="The eigenvalues of the cubic formula err by 1e-8 and more there: the polynomial forgives it.",
    ),
    Claim(
        id="kaji_ochiai.4.4.log.generic",
        place=TABLE_1,
        statement="On random matrices the closed logarithm errs by less than 1e-12.",
        verdict=Verdict.CONFIRMED,
        form=closed_forms.logarithm,
        cases=lambda: ["generic"],
        deviation=_beyond(1e-12, _logarithms),
        copies=(
            Copy(
                "1/4 for 1/3 in the approximation of L2, and that up to 1/8",
                lambda s: closed_forms.logarithm(s, _slipped_l2),
            ),
        ),
        numbers=_table(LOGARITHMS, _logarithms, "generic", "identity"),
        remark="Near I the logarithm is small and its error that of I: of 1e-8 none of the three keeps more than half.",
    ),
    Claim(
        id="kaji_ochiai.4.4.log.coinciding",
        place=TABLE_1,
        statement="So it does where eigenvalues coincide or nearly do, with an approximation of L2.",
        verdict=Verdict.BOUND,
        domain="two eigenvalues coincide, or three nearly; not all three exactly, as of every similarity, where a and "
        "c are 0/0",
        form=closed_forms.logarithm,
        cases=lambda: ["double 1e-3", "double 1e-6", "double 1e-12", "nearly 1e-3", "nearly 1e-8", "nearly 1e-12"],
        outside=lambda: ["triple"],
        deviation=_beyond(1e-12, _logarithms),
        copies=(Copy("the approximation of first order", lambda s: closed_forms.logarithm(s, _rough_l2)),),
        numbers=_table(LOGARITHMS, _logarithms, "double 1e-6", "nearly 1e-8", "triple"),
    ),
    Claim(
        id="kaji_ochiai.4.4.timing",
        place="section 4.4, table 1, times; section 4.1",
        statement="The closed formulae are faster than Padé approximants and than diagonalisation.",
        printed="computed by a closed formula and the computational cost is much cheaper than that of diagonalisation",
        verdict=Verdict.UNCHECKABLE,
        reason="Times are those of a machine, and the cells of the table are lost.",
        remark="Measured in turns by `python -m pytest --pyargs affinecert.benchmarks.test_closed_forms "
        "--benchmark-only`, on arrays of 10 000 matrices, one thread, three runs: diagonalisation (LAPACK through "
        "NumPy) takes 3.0 to 3.9 times as long as the closed exponential and 3.5 to 3.9 times as long as the closed "
        "logarithm (NumPy), SciPy's expm 15 to 18 times. SciPy's logm, a call for each of 100 matrices, takes 570 to "
        "600 times as long, mostly overhead.",
    ),
)
