"""Section 4.1: C1 curves through many affine maps, after Li and Hao, in G_A, G_S and SE(3) and composed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.product_group import group_logarithm
from affinecert.properties.claims.bansal_tatu.samples import at, embedded, inverse, maps, scaling
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, distance, exactly, mp
from affinecert.reference import affine_lie, curves, shear
from affinecert.reference._matrices import Array, Number, array, cross_matrix, norm, tangent

Segment = tuple[Array, Array, Array]
"""A_i, B_i and C_i of N_i(t) = A_i exp(t B_i) exp(t^2 C_i)."""


@dataclass(frozen=True)
class Keys:
    """Keys in one of the groups, and the B_0 that the curve starts with."""

    group: str
    keys: tuple[Array, ...]
    start: Array


def _exponential(matrix: Array) -> Array:
    return definitions.exponential(mp, matrix)


def _bend(sign: int = -1) -> Callable[[str, Array, Array, Array], Array]:
    """Equation 5, C_i of A_i, A_(i+1) and B_i."""

    def printed(group: str, here: Array, there: Array, rate: Array) -> Array:
        return group_logarithm(group, _exponential(rate * sign) @ inverse(here) @ there)

    return printed


def _rate(factor: int = 2, *, exchanged: bool = False) -> Callable[[Array, Array, Array, Array], Array]:
    """Equation 6, B_(i+1) of A_i, A_(i+1), B_i and C_i."""

    def printed(here: Array, there: Array, rate: Array, bend: Array) -> Array:
        step = inverse(here) @ there
        turned = step @ rate @ inverse(step) if exchanged else inverse(step) @ rate @ step
        result: Array = turned + factor * bend
        return result

    return printed


def _point(segment: Segment, t: Number) -> Array:
    here, rate, bend = segment
    result: Array = here @ _exponential(rate * t) @ _exponential(bend * t**2)
    return result


def _velocity(segment: Segment, t: Number) -> Array:
    """The velocity in the moving frame, N^-1 N'."""
    result: Array = inverse(_point(segment, t)) @ definitions.derivative(mp, lambda s: _point(segment, s), t)
    return result


def _smooth(factor: int = 2) -> Callable[[Keys], list[Segment]]:
    """The segments of the C1 curve, with that factor in equation 6."""
    bend, rate = _bend(), _rate(factor)

    def segments(given: Keys) -> list[Segment]:
        found, current = [], given.start
        for here, there in pairwise(given.keys):
            curved = bend(given.group, here, there, current)
            found.append((here, current, curved))
            current = rate(here, there, current, curved)
        return found

    return segments


def _geodesics(given: Keys) -> list[Segment]:
    """The segments of the curve that is geodesic between keys."""
    pairs = pairwise(given.keys)
    return [(here, (rate := group_logarithm(given.group, inverse(here) @ there)), rate * 0) for here, there in pairs]


def _break(segments: list[Segment], given: Keys) -> Number:
    """How far a curve is from one through its keys."""
    ends = [(_point(each, mp.zero), _point(each, mp.one)) for each in segments]
    return distance(ends, list(pairwise(given.keys)))


def _jump(segments: list[Segment]) -> Number:
    """The largest change of velocity at a key."""
    return max(difference(_velocity(before, mp.one), _velocity(after, mp.zero)) for before, after in pairwise(segments))


def _rough(curve: Callable[[Keys], list[Segment]], given: Keys) -> Number:
    segments = curve(given)
    return max(_break(segments, given), _jump(segments))


def _not_merely_continuous(curve: Callable[[Keys], list[Segment]], given: Keys) -> Number:
    """How far a curve is from a continuous one; 1 if its velocity is continuous, too."""
    segments = curve(given)
    return max(_break(segments, given), int(_jump(segments) < mp.mpf(1) / 1000))


def _off_end(bend: Callable[[str, Array, Array, Array], Array], given: Keys) -> Number:
    here, there = given.keys[:2]
    segment = here, given.start, bend(given.group, here, there, given.start)
    return distance(_point(segment, mp.one), there)


def _velocity_off(rate: Callable[[Array, Array, Array, Array], Array], given: Keys) -> Number:
    here, there = given.keys[:2]
    bend = _bend()(given.group, here, there, given.start)
    return distance(rate(here, there, given.start, bend), _velocity((here, given.start, bend), mp.one))


@cache
def _factors() -> tuple[tuple[Array, ...], tuple[Array, ...], tuple[Array, ...]]:
    """The A_i, S_i and E_i of four affine maps."""
    parts = [affine_lie.decompose(mp, pose) for pose in maps()[4:8]]
    return (
        tuple(matrix for _, matrix, _ in parts),
        tuple(exactly([[scale[()]]]) for _, _, scale in parts),
        tuple(rigid for rigid, _, _ in parts),
    )


@cache
def _keys() -> tuple[Keys, ...]:
    """Three keys in each group; B_0 as in the paper's experiments, and another one."""
    twist, alpha = arrays("start twist", 1, (6,), -1, 1)[0], arrays("start shear", 1, (5,), -1, 1)[0]
    others = {
        "G_A": shear.matrix(mp, alpha, mp.zero),
        "G_S": exactly([[-1]]),
        "SE(3)": tangent(mp, cross_matrix(mp, twist[:3]), twist[3:]),
    }
    found = []
    for (group, other), keys in zip(others.items(), _factors(), strict=True):
        usual = Keys(group, keys[:3], group_logarithm(group, inverse(keys[0]) @ keys[1]))
        found += [usual, replace(usual, start=other)]
    return tuple(found)


def _composed(order: str) -> Callable[[Number], Array]:
    """The product of the three curves at a time, in an order."""
    shears, scales, rigids = _factors()

    def point(t: Number) -> Array:
        factors = {
            "A": embedded(curves.shear_curve(mp, array(shears), at(t))),
            "S": scaling(curves.scale_curve(mp, array([each[0, 0] for each in scales]), at(t))[()]),
            "E": curves.rigid_curve(mp, array(rigids), at(t)),
        }
        first, second, third = (factors[letter] for letter in order)
        result: Array = first @ second @ third
        return result

    return point


def _off_key(curve: Callable[[Number], Array], case: tuple[int, Array]) -> Number:
    number, key = case
    return distance(curve(mp.mpf(number)), key)


@cache
def _excess(curve: Callable[..., Array]) -> Number:
    """By how much a curve through five maps is longer than the chords between them, in the space of their entries."""
    keys = array(maps()[4:9])
    points = [curve(mp, keys, at(mp.mpf(k) / 16)) for k in range(16 * 4 + 1)]
    chords, length = (
        mp.fsum(norm(mp, (after - before).flat) for before, after in pairwise(poses)) for poses in (keys, points)
    )
    return length / chords - 1


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.4.1.piecewise",
        place="section 4.1",
        statement="Interpolated pair by pair, a sequence of maps is joined by a continuous curve that is not "
        "differentiable.",
        verdict=Verdict.CONFIRMED,
        form=_geodesics,
        cases=lambda: _keys()[::2],
        deviation=_not_merely_continuous,
        copies=(Copy("the C1 curve", _smooth()),),
        remark="In general: it is smooth through keys at equal steps of one motion.",
    ),
    Claim(
        id="bansal_tatu.4.1.equation_5",
        place="section 4.1, equation 5",
        statement="With C_i = log(exp(-B_i) A_i⁻¹ A_(i+1)) the segment A_i exp(t B_i) exp(t² C_i) ends at A_(i+1).",
        printed="C_i = log(exp(-B_i) A_i⁻¹ A_(i+1))",
        verdict=Verdict.CONFIRMED,
        form=_bend(),
        cases=_keys,
        deviation=_off_end,
        copies=(Copy("exp(B_i)", _bend(1)),),
    ),
    Claim(
        id="bansal_tatu.4.1.equation_6",
        place="section 4.1, equation 6",
        statement="The velocity at the end of segment i is B_(i+1) = A_(i+1)⁻¹ A_i B_i A_i⁻¹ A_(i+1) + 2 C_i.",
        printed="B_(i+1) = A_(i+1)⁻¹ A_i B_i A_i⁻¹ A_(i+1) + 2 C_i",
        verdict=Verdict.CONFIRMED,
        form=_rate(),
        cases=_keys,
        deviation=_velocity_off,
        copies=(Copy("C_i for 2 C_i", _rate(1)), Copy("A_i and A_(i+1) exchanged", _rate(exchanged=True))),
        remark="exp(-C_i) B_i exp(C_i) + 2 C_i is the same. The B_i and C_i are numbered from 0, not from 1.",
    ),
    Claim(
        id="bansal_tatu.4.1.smooth",
        place="section 4.1",
        statement="For any B_0 in the Lie algebra equations 5 and 6 have a solution, and the curve passes through the "
        "keys with a continuous velocity, in G_A as in G_S and SE(3).",
        verdict=Verdict.CONFIRMED,
        form=_smooth(),
        cases=_keys,
        deviation=_rough,
        copies=(
            Copy("geodesics between the keys", _geodesics),
            Copy("C_i for 2 C_i in equation 6", _smooth(1)),
        ),
    ),
    Claim(
        id="bansal_tatu.4.1.composition",
        place="section 4.1, after equation 6",
        statement="The curve of affine maps is composed as N^SE(3)(t) N^S(t) N^A(t).",
        printed="T_i(t) = N_i^SE(3)(t) · N_i^S(t) · N_i^A(t)",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_composed("ESA"),
        cases=lambda: list(enumerate(maps()[4:8])),
        deviation=_off_key,
        correction=Correction(statement="N^A(t) N^S(t) N^SE(3)(t), as T_i = A_i S_i E_i", form=_composed("ASE")),
        copies=(Copy("N^A N^SE(3) N^S", _composed("AES")),),
    ),
    Claim(
        id="bansal_tatu.6.4.subdivision",
        place="sections 4.1 and 6.4, figure 8",
        statement="With the maps at t = 0.5 added to the sequence, the trajectory becomes smoother.",
        verdict=Verdict.CONFIRMED,
        form=curves.subdivided_curve,
        cases=lambda: [curves.affine_curve],
        deviation=lambda curve, plain: int(_excess(curve) > _excess(plain) / 2),
        copies=(Copy("no map added", curves.affine_curve),),
        numbers=lambda: {
            "longer than the chords, the C1 curve through 5 maps": _excess(curves.affine_curve),
            "longer than the chords, the maps at t = 0.5 added": _excess(curves.subdivided_curve),
        },
        remark="Their left column is not differentiable, their right one is. Of C1 curves, too, the one through more "
        "maps is better: equation 6 hands each overshoot on to the next segment, reversed, and it does not die out.",
    ),
)
