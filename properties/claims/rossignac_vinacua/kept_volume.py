"""Section 6.3.3: A^t keeps area or volume if A does."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import equals, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.motions_from_identity import TIMES, by, steady_motion
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number


def _volume_keeping() -> list[Array]:
    """Of determinant 1: with real, equal and complex eigenvalues."""
    return [
        affine([[2, 0], [0, 0.5]], [1, 2]),
        affine([[1, 1], [0, 1]], [0, 1]),
        affine([[0, -2], [0.5, 1]], [1, 0]),
        affine([[-0.5, -4], [0.25, 0]], [1, 1]),
        affine([[1, 2, 0], [0, 1, 1], [1, 2, 1]], [0, 1, 0]),
        affine([[0, -4, 1], [1, 0.5, 0], [0, 0, 0.25]], [1, 1, 1]),
    ]


def _unit_determinant() -> list[Array]:
    return [each for each in _volume_keeping() if definitions.determinant(each[:-1, :-1]) == 1]


def _changes_volume(make: Any, end: Array) -> Number:
    motion = make(end)
    return max(abs(definitions.determinant(motion(t)[:-1, :-1]) - 1) for t in TIMES)


def _exponential_of_trace(factor: int = 1) -> Any:
    def formula(m: Context, matrix: Array) -> Number:
        return m.exp(matrix.trace() / factor)

    return formula


def _determinant_of_exponential(m: Context, matrix: Array) -> Number:
    return definitions.determinant(definitions.exponential(m, matrix))


def _matrices() -> list[tuple[Array]]:
    plane = [exactly(each) for each in ([[0, 0], [0, 0]], [[1, 0], [0, 2]], [[0, 1], [-1, 0]])]
    return [(each,) for each in (*plane, *arrays("exponents", 4, (3, 3), -2, 2))]


def _trace(power_of: int = 1) -> Any:
    """The trace of a power of log(L)."""

    def trace(generator: Array) -> Number:
        found = generator[:-1, :-1]
        for _ in range(power_of - 1):
            found = found @ generator[:-1, :-1]
        return found.trace()

    return trace


def _not_zero(trace: Any, end: Array) -> Number:
    return max(abs(trace(t * sam.log(mp, end))) for t in TIMES)


def _image_of_cube(corners: str = "determinant") -> Any:
    """The volume of the image of the unit cube, as the paper measures it."""

    def volume(m: Context, linear: Array) -> Number:
        if corners == "lengths":
            return m.sqrt(np.prod([column @ column for column in linear.T]))
        return definitions.determinant(linear)

    return volume


def _by_elimination(m: Context, linear: Array) -> Number:
    """The volume by heights over the sides before (Gram and Schmidt), for det > 0."""
    volume: Number = m.one
    sides: list[Array] = []
    for column in linear.T:
        height = column
        for side in sides:
            height = height - side * (side @ column) / (side @ side)
        sides.append(height)
        volume *= m.sqrt(height @ height)
    return volume


def _linear_parts() -> list[tuple[Array]]:
    drawn = [(each,) for each in arrays("cubes", 20, (3, 3), -2, 2) if definitions.determinant(each) > 0]
    return [(exactly([[2, 0], [0, 3]]),), (exactly([[1, 1], [0, 1]]),), *drawn[:5]]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.6.3.3.determinant",
        place="section 6.3.3",
        statement="A preserves area or volume if and only if det(L) = 1, for it multiplies them by det(L) > 0.",
        verdict=Verdict.CONFIRMED,
        form=_image_of_cube(),
        cases=_linear_parts,
        deviation=equals(_by_elimination),
        copies=(Copy("the product of the lengths of the edges", _image_of_cube("lengths")),),
    ),
    Claim(
        id="rossignac_vinacua.6.3.3.exponential",
        place="section 6.3.3",
        statement="det(exp B) = exp(trace B).",
        printed="det(e^B) = e^{trace B}",
        verdict=Verdict.CONFIRMED,
        form=_exponential_of_trace(),
        cases=_matrices,
        deviation=equals(_determinant_of_exponential),
        copies=(Copy("half the trace", _exponential_of_trace(2)),),
    ),
    Claim(
        id="rossignac_vinacua.6.3.3.trace",
        place="section 6.3.3",
        statement="If det(L) = 1, trace(t log(L)) = 0.",
        printed="trace(log(L)) = 0, trace(t log(L)) = t trace(log(L)) = 0",
        verdict=Verdict.CONFIRMED,
        form=_trace(),
        cases=_unit_determinant,
        deviation=_not_zero,
        copies=(Copy("log(L)² for log(L)", _trace(2)),),
    ),
    Claim(
        id="rossignac_vinacua.6.3.3.volume",
        place="section 6.3.3",
        statement="If A preserves area or volume, so does A^t for all t.",
        printed="det(L^t) = det(e^{t log(L)}) = e^{trace(t log(L))} = 1",
        verdict=Verdict.CONFIRMED,
        form=steady_motion,
        cases=_unit_determinant,
        deviation=_changes_volume,
        copies=(Copy("rARAP", by("rarap")), Copy("the linear morph", by("linear"))),
        remark="ASAP does so too.",
    ),
)
