"""Section 5, the example of three rotations about the z-axis: which logarithms make the intended motion."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.precision import difference, mp
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Number, array, cross_matrix, norm

ANGLES = (Fraction(2, 3), Fraction(4, 3), Fraction(5, 3))
"""The angles of R_1, R_2 and R_3, over pi."""

Printed = list[list[Fraction]]
"""A printed matrix over pi."""


def _matrix(upper: Any, lower: Any) -> Printed:
    """The printed matrix with these entries over pi in places (1, 2) and (2, 1), and zeros."""
    zero = Fraction(0)
    return [[zero, Fraction(upper), zero], [Fraction(lower), zero, zero], [zero, zero, zero]]


B_1, B_2, B_3 = _matrix("-2/3", "2/3"), _matrix("2/3", "-2/3"), _matrix("1/3", "-1/3")
OTHER_2, OTHER_3 = _matrix("-4/3", "4/3"), _matrix("-1/3", "1/3")


def _numbers(printed: Printed) -> Array:
    return array([[mp.pi * entry.numerator / entry.denominator for entry in row] for row in printed])


def _rotation(angle: Fraction) -> Array:
    """The matrix as printed, of the cosine and the sine of the angle."""
    turn = mp.pi * angle.numerator / angle.denominator
    cosine, sine, zero = mp.cos(turn), mp.sin(turn), mp.zero
    return array([[cosine, -sine, zero], [sine, cosine, zero], [zero, zero, mp.one]])


def _length(matrix: Array) -> Number:
    """The norm of a skew matrix in the inner product of the paper."""
    return mp.sqrt((matrix.T @ matrix).trace() / 2)


def _not_principal(form: tuple[Printed, ...], case: int) -> Number:
    return difference(_numbers(form[case]), cross_matrix(mp, so3.log(mp, _rotation(ANGLES[case]))))


def _not_other(form: Printed, case: int) -> Number:
    """How far a matrix is from the logarithm of R_case that is not principal and has its angle below 2 pi."""
    rotation, matrix = _rotation(ANGLES[case]), _numbers(form)
    angle = 2 * mp.pi - norm(mp, so3.log(mp, rotation))
    return difference(definitions.exponential(mp, matrix), rotation) + abs(_length(matrix) - angle)


Interpolant = Callable[[Fraction], Printed]
"""What is printed as (1-t) B + t B', a function of t."""


def _interpolant(constant: Any, rate: Any) -> Interpolant:
    """The matrix whose entry in place (2, 1) is that line, and its opposite in place (1, 2)."""

    def printed(t: Fraction) -> Printed:
        lower = Fraction(constant) + Fraction(rate) * t
        return _matrix(-lower, lower)

    return printed


PAIRS = ((B_1, B_2), (B_1, OTHER_2), (OTHER_2, B_3), (B_2, B_3))
INTERPOLANTS = (
    _interpolant("2/3", "-4/3"),
    _interpolant("2/3", "2/3"),
    _interpolant("4/3", "-5/3"),
    _interpolant("-2/3", "1/3"),
)
"""(1 - 2t) B_1, (1 + t) 2 pi/3, 4 pi/3 - t 5 pi/3 and -pi/3 (2 - t)."""


def _entries(printed: Printed) -> list[Fraction]:
    return [entry for row in printed for entry in row]


def _not_between(form: tuple[Interpolant, ...], case: int) -> Fraction:
    """How far an interpolant is from the line between its two logarithms, exactly."""
    first, second = map(_entries, PAIRS[case])
    gaps = [
        abs((1 - t) * a + t * b - found)
        for t in (Fraction(0), Fraction(1, 3), Fraction(1))
        for a, b, found in zip(first, second, _entries(form[case](t)), strict=True)
    ]
    return max(gaps)


Passage = tuple[int, Fraction, Fraction]
"""An interpolant, a time, and the angle over pi that its rotation has then."""


def _passages(*, last: Fraction = Fraction(4, 5)) -> list[Passage]:
    """What is printed: I half way, a half turn half way, a half turn at 1/5 and I at 4/5."""
    half, zero, one = Fraction(1, 2), Fraction(0), Fraction(1)
    return [(0, half, zero), (1, half, one), (2, Fraction(1, 5), one), (2, last, zero)]


def _passes_by(form: list[Passage], case: int) -> Number:
    interpolant, t, angle = form[case]
    rotation = definitions.exponential(mp, _numbers(INTERPOLANTS[interpolant](t)))
    return difference(rotation, _rotation(angle))


def _longer(form: tuple[tuple[Printed, Printed, int], ...], case: int) -> Number:
    """How far the logarithms are from those of R_i and R_(i+1), and how much longer than a geodesic their line is."""
    first, second, index = form[case]
    ends = [_rotation(ANGLES[index]), _rotation(ANGLES[index + 1])]
    logarithms = [_numbers(first), _numbers(second)]
    gaps = [difference(definitions.exponential(mp, b), r) for b, r in zip(logarithms, ends, strict=True)]
    geodesic = norm(mp, so3.log(mp, ends[0].T @ ends[1]))
    return max(*gaps, abs(_length(logarithms[1] - logarithms[0]) - geodesic))


def _crossings() -> list[tuple[Number, Number]]:
    """Angles on both sides of pi, less than pi apart."""
    return [(mp.mpf(a) / 4, mp.mpf(b) / 4) for a, b in ((8, 16), (12, 13), (10, 20), (1, 13))]


def _short_way(form: Any, case: tuple[Number, Number]) -> Number:
    """0 if the line from the first logarithm to the one chosen for the second is longer than from angle to angle."""
    first, second = (so3.exp(mp, array([mp.zero, mp.zero, angle])) for angle in case)
    start = so3.log(mp, first)
    return 0 if norm(mp, form(second, start) - start) > case[1] - case[0] + mp.mpf(1) / 100 else 1


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="gallier.abstract.long_way",
        place="abstract, and section 5",
        statement="Where a rotation about one axis passes through π, the principal logarithm makes it go the long way.",
        printed="Whenever a rotation crosses through π, the principal logarithm is not the correct choice and the "
        "motion goes the long way",
        verdict=Verdict.CONFIRMED,
        form=lambda rotation, start: so3.log(mp, rotation),
        cases=_crossings,
        deviation=_short_way,
        copies=(Copy("the logarithm nearest to the one before", lambda r, start: so3.log_near(mp, r, start)),),
    ),
    Claim(
        id="gallier.5.example.principal",
        place="section 5, matrices B_1, B_2 and B_3",
        statement="The principal logarithms of the turns by 2π/3, 4π/3 and 5π/3 about the z-axis; B_2 = -B_1.",
        printed="B_1 = (0, -2π/3, 0; 2π/3, 0, 0; 0, 0, 0), B_2 = (0, 2π/3, 0; -2π/3, 0, 0; 0, 0, 0), "
        "B_3 = (0, π/3, 0; -π/3, 0, 0; 0, 0, 0)",
        verdict=Verdict.CONFIRMED,
        form=(B_1, B_2, B_3),
        cases=lambda: range(3),
        deviation=_not_principal,
        copies=(Copy("the opposite of B_3", (B_1, B_2, OTHER_3)), Copy("B'_2 for B_2", (B_1, OTHER_2, B_3))),
    ),
    Claim(
        id="gallier.5.example.other_of_2",
        place="section 5, matrix B'_2",
        statement="B'_2 is the other logarithm of R_2, with the angle 2π - 2π/3 = 4π/3.",
        printed="B'_2 = (0, -4π/3, 0; 4π/3, 0, 0; 0, 0, 0)",
        verdict=Verdict.CONFIRMED,
        form=OTHER_2,
        cases=lambda: [1],
        deviation=_not_other,
        copies=(Copy("the opposite matrix", _matrix("4/3", "-4/3")),),
    ),
    Claim(
        id="gallier.5.example.interpolants",
        place="section 5, the first four interpolants",
        statement="(1-t) B + t B' of B_1 and B_2, B_1 and B'_2, B'_2 and B_3, B_2 and B_3.",
        printed="(1-2t) B_1; (1+t)2π/3; 4π/3 - t5π/3; -π/3(2-t) in place (2, 1)",
        verdict=Verdict.CONFIRMED,
        form=INTERPOLANTS,
        cases=lambda: range(4),
        deviation=_not_between,
        copies=(
            Copy("4π/3 - t4π/3 for 4π/3 - t5π/3", (*INTERPOLANTS[:2], _interpolant("4/3", "-4/3"), INTERPOLANTS[3])),
            Copy("-π/3(2+t) for -π/3(2-t)", (*INTERPOLANTS[:3], _interpolant("-2/3", "-1/3"))),
        ),
    ),
    Claim(
        id="gallier.5.example.passages",
        place="section 5, where the interpolants pass",
        statement="From B_1 to B_2 the motion passes through I at t = 1/2, from B_1 to B'_2 through the half turn at "
        "1/2, and from B'_2 to B_3 through the half turn at 1/5 and through I at 4/5.",
        verdict=Verdict.CONFIRMED,
        form=_passages(),
        cases=lambda: range(4),
        deviation=_passes_by,
        copies=(Copy("I at 3/5", _passages(last=Fraction(3, 5))),),
    ),
    Claim(
        id="gallier.5.example.intended",
        place="section 5, the intended interpolants",
        statement="From B_1 to B'_2 and from B_2 to B_3 the motion is the intended one, the short way.",
        verdict=Verdict.CONFIRMED,
        form=((B_1, OTHER_2, 0), (B_2, B_3, 1)),
        cases=lambda: range(2),
        deviation=_longer,
        copies=(
            Copy("from B_1 to B_2", ((B_1, B_2, 0), (B_2, B_3, 1))),
            Copy("from B'_2 to B_3", ((B_1, OTHER_2, 0), (OTHER_2, B_3, 1))),
        ),
    ),
    Claim(
        id="gallier.5.example.other_of_3",
        place="section 5, matrix B'_3",
        statement="B'_3 is the other logarithm of R_3, the turn by 5π/3.",
        printed="the angle 2π - 5π/3 = π/3 given by B'_3 = (0, -π/3, 0; π/3, 0, 0; 0, 0, 0)",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=OTHER_3,
        cases=lambda: [2],
        deviation=_not_other,
        correction=Correction(
            statement="B'_3 has 5π/3 = 2π - π/3 in place of π/3, the principal angle being π/3; what is printed is the "
            "opposite of B_3, a logarithm of the turn by π/3.",
            form=_matrix("-5/3", "5/3"),
        ),
        copies=(Copy("the opposite matrix", _matrix("5/3", "-5/3")),),
    ),
    Claim(
        id="gallier.5.example.intended_on",
        place="section 5, the last interpolant",
        statement="From B'_2 to B'_3 the motion is the intended one, the short way from R_2 to R_3.",
        printed="(1-t)B'_2 + tB'_3 = (0, -(4π/3 - tπ), 0; 4π/3 - tπ, 0, 0; 0, 0, 0), and this is also the intended "
        "interpolant",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=((OTHER_2, OTHER_3, 1),),
        cases=lambda: [0],
        deviation=_longer,
        correction=Correction(
            statement="With B'_3 put right the interpolant is 4π/3 + tπ/3, and that is the intended one; as printed it "
            "turns back by π, and ends at the wrong rotation.",
            form=((OTHER_2, _matrix("-5/3", "5/3"), 1),),
        ),
        copies=(Copy("from B_2 to B'_3 put right", ((B_2, _matrix("-5/3", "5/3"), 1),)),),
    ),
)
