"""Section 7.3: parabolic predictions of new poses, with the listing ``left``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.definitions import inverse
from affinecert.properties.claims.draws import arrays, numbers
from affinecert.properties.claims.precision import FAILS, distance, mp
from affinecert.properties.claims.rossignac_vinacua.poses import controls, morph, power
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Number, array, identity, tangent

Left = Callable[[Array, Array, Array], Array]
"""A prediction between the first two of three poses."""


def _carried(pose: Array, start: Array, end: Array, t: Number) -> Array:
    """SAM of four arguments: the pose F_X carried from F_A towards F_B."""
    found: Array = power(mp, end @ inverse(mp, start), t) @ pose
    return found


def left(near: float = 0.625, far: float = 0.125) -> Left:
    """SAM(SAM(F_A, 0.625, F_B), F_C, .125, F_B), as printed."""

    def predicted(a: Array, b: Array, c: Array) -> Array:
        return _carried(morph(mp, a, b, mp.mpf(near)), c, b, mp.mpf(far))

    return predicted


def towards_c(a: Array, b: Array, c: Array) -> Array:
    """With F_B and F_C exchanged in the outer call."""
    return _carried(morph(mp, a, b, mp.mpf(0.625)), b, c, mp.mpf(0.125))


def _neville(a: Array, b: Array, c: Array) -> Array:
    """The same point of the parabola by Neville's algorithm, from the legs at 1/2 and -1/2."""
    half = mp.mpf(1) / 2
    return morph(mp, morph(mp, a, b, half), morph(mp, b, c, -half), half / 2)


def _weights(form: Sequence[Fraction], _case: int) -> Any:
    """The difference to the weights of the values at 0, 1, 2 and 3 in their cubic interpolant at 3/2, exactly.

    ``form`` are the weights of A, B and C in a prediction between A and B; two of them are averaged.
    """
    right = (*reversed(form), Fraction(0))
    mean = [(x + y) / 2 for x, y in zip(right, reversed(right), strict=True)]
    at, truth = Fraction(3, 2), []
    for k in range(4):
        weight = Fraction(1)
        for other in range(4):
            weight *= Fraction(1) if other == k else (at - other) / (k - other)
        truth.append(weight)
    return float(max(abs(x - y) for x, y in zip(mean, truth, strict=True)))


_PRINTED_WEIGHTS = (Fraction(3, 8), Fraction(3, 8) + Fraction(3, 8), -Fraction(1, 8))
"""In translations left is 3/8 F_A + 5/8 F_B + 1/8 (F_B - F_C)."""


def _generators() -> list[tuple[Array, list[Number]]]:
    generators = [tangent(mp, identity(mp, 2) * 0, array([mp.one, mp.zero]))]
    for size in (2, 3):
        drawn = arrays("commuting poses", 2, (size, size + 1), -1, 1)
        generators += [tangent(mp, each[:, :size], each[:, size]) for each in drawn]
    scales = numbers("along one motion", 3 * len(generators), -0.5, 0.5)
    return [(generator, scales[3 * k : 3 * k + 3]) for k, generator in enumerate(generators)]


def _off_parabola(left: Left, case: tuple[Array, list[Number]]) -> Number:
    """Of poses exp(a_i C), the distance from exp(a C), a the parabola through (0, a_0), (1/2, a_1), (1, a_2) at 1/4."""
    generator, (a, b, c) = case
    truth = sam.exponential(mp, (3 * a + 6 * b - c) / 8 * generator)
    return distance(left(*(sam.exponential(mp, each * generator) for each in (a, b, c))), truth)


def _disagreement(pair: tuple[Left, Left], case: tuple[Array, list[Number]]) -> Number:
    generator, scales = case
    first, second = (left(*(sam.exponential(mp, each * generator) for each in scales)) for left in pair)
    return distance(second, first)


def _agreement(pair: tuple[Left, Left], poses: tuple[Array, Array, Array]) -> int:
    return int(distance(pair[1](*poses), pair[0](*poses)) < FAILS)


def _threes() -> list[tuple[Array, Array, Array]]:
    drawn = [controls(f"threes of {size}", 6, size) for size in (2, 3)]
    return [(each[k], each[k + 1], each[k + 2]) for each in drawn for k in (0, 3)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.7.3.left",
        place="section 7.3, listing left",
        statement="left(F_A, F_B, F_C) is a quarter along the parabola through the poses, exactly so of exp(a_i C).",
        printed="left(F_A, F_B, F_C) = SAM(SAM(F_A, 0.625, F_B), F_C, .125, F_B)",
        verdict=Verdict.CONFIRMED,
        form=left(),
        cases=_generators,
        deviation=_off_parabola,
        copies=(
            Copy("leftControl of section 5.3, which makes a control pose", left(0.75, 0.25)),
            Copy("F_B and F_C exchanged", towards_c),
            Copy("0.5 for 0.625", left(0.5)),
        ),
        remark="The words call the parabola a quadratic Bezier motion; F_B is not its control pose but on it.",
    ),
    Claim(
        id="rossignac_vinacua.7.3.neville",
        place="section 7.3",
        statement="The average of two parabolic predictions is the middle of the cubic interpolant, as by Neville.",
        printed="(3/8, 6/8, -1/8), from both sides",
        verdict=Verdict.CONFIRMED,
        form=_PRINTED_WEIGHTS,
        cases=lambda: [0],
        deviation=_weights,
        copies=(Copy("the weights 1/4, 1, -1/4 of leftControl", (Fraction(1, 4), Fraction(1), Fraction(-1, 4))),),
        remark="The four weights are the classical -1/16, 9/16, 9/16, -1/16.",
    ),
    Claim(
        id="rossignac_vinacua.7.3.formulae_agree",
        place="section 7.3",
        statement="Formulae for the new vertices agree where averages commute: the printed one, and Neville's own.",
        verdict=Verdict.CONFIRMED,
        form=(left(), _neville),
        cases=_generators,
        deviation=_disagreement,
        copies=(Copy("leftControl of section 5.3", (left(0.75, 0.25), _neville)),),
    ),
    Claim(
        id="rossignac_vinacua.7.3.formulae_differ",
        place="section 7.3",
        statement="SAM averages do not commute: of poses in general those formulae give different results.",
        verdict=Verdict.CONFIRMED,
        form=(left(), _neville),
        cases=_threes,
        deviation=_agreement,
        copies=(Copy("twice the printed one", (left(), left())),),
    ),
)
