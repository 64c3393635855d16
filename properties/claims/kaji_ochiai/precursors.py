"""Section 6: matrices, Clifford algebras and polar factors."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import rotations
from affinecert.properties.claims.kaji_ochiai.other_parametrisations import redundancy
from affinecert.properties.claims.precision import difference, exactly, mp
from affinecert.reference import quaternion, sym3
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity

HALF_TURN = exactly([[-1, 0, 0], [0, -1, 0], [0, 0, 1]])


QUARTER_TURN = exactly([[0, -1, 0], [1, 0, 0], [0, 0, 1]])


def _not_degenerate(pair: tuple[Array, Array], weight: Number) -> Number:
    return abs(definitions.determinant(pair[0] * weight + pair[1] * (1 - weight)))


def _is_rotation(weights: tuple[int, int], pair: tuple[Array, Array]) -> int:
    total = pair[0] * weights[0] + pair[1] * weights[1]
    return int(difference(total.T @ total, identity(mp, 3)) < 1e-12)


def _turn_pairs() -> list[tuple[Array, Array]]:
    turns = rotations("summed", 6)
    return [(identity(mp, 3), identity(mp, 3)), (identity(mp, 3), QUARTER_TURN), *zip(turns, turns[::-1], strict=True)]


def _law_of_plane(conjugated: bool) -> Any:
    """The product (p + q e)(r + s e) with e z = z* e and e e = 0; or with e z = z e."""

    def product(m: Context, p: Number, q: Number, r: Number, s: Number) -> tuple[Number, Number]:
        return p * r, p * s + q * (m.conj(r) if conjugated else r)

    return product


def _not_a_motion(law: Any, case: tuple[Number, Number, Number, Number]) -> Number:
    """How far the law is from that of the rigid motions z -> p^2 z + 2 p q of the plane."""
    p, q, r, s = case
    a, b = law(mp, *case)
    z = mp.mpc(2, 1)
    return abs(a**2 * z + 2 * a * b - (p**2 * (r**2 * z + 2 * r * s) + 2 * p * q))


def _plane_motions() -> list[tuple[Number, Number, Number, Number]]:
    """Complex numbers p and r of length 1, q and s any."""
    units = [mp.mpc(1, 0), mp.mpc(0, 1), mp.mpc(3, 4) / 5, mp.mpc(-5, 12) / 13]
    shifts = [mp.mpc(1, 2), mp.mpc(-2, 1), mp.mpc(0.5, 0)]
    return [(p, q, r, shifts[0]) for p in units for r in units[1:] for q in shifts[1:]]


def motion_of_dual(numbers: Array) -> Array:
    """The rigid motion of an invertible dual quaternion q + e r: it turns by q, and shifts by 2 (r q*) / |q|^2."""
    q, r = numbers[:4], numbers[4:]
    length = q @ q
    shift = 2 * quaternion.product(r, quaternion.conjugate(q))[1:] / length
    turn = array(
        [quaternion.product(quaternion.product(q, unit), quaternion.conjugate(q))[1:] for unit in np.eye(4)[1:]]
    ).T
    return homogeneous(mp, turn / length, shift)


def _turn_of_dual(numbers: Array) -> Array:
    """The turn only."""
    return motion_of_dual(numbers)[:3, :3]


def _straight(m: Context, first: Array, last: Array, t: Number) -> Array:
    between: Array = first * (1 - t) + last * t
    return between


def _by_logarithms(m: Context, first: Array, last: Array, t: Number) -> Array:
    return sym3.exp(m, sym3.log(m, first) * (1 - t) + sym3.log(m, last) * t)


def _stays_definite(between: Any, case: tuple[Array, Array, Number]) -> int:
    found = between(mp, *case)
    return int(all(definitions.determinant(found[:k, :k]) > 0 for k in (1, 2, 3)))


def _extrapolated() -> list[tuple[Array, Array, Number]]:
    unit, longer = identity(mp, 3), exactly([[3, 0, 0], [0, 1, 0], [0, 0, 1]])
    slanted = exactly([[2, 1, 0], [1, 1, 0], [0, 0, 1]])
    return [(unit, longer, mp.mpf(-1)), (longer, unit, mp.mpf(2)), (unit, slanted, mp.mpf(-2))]


def _mean_is_unit(pair: tuple[Array, Array], _: None) -> int:
    mean = (pair[0] + pair[1]) / 2
    return int(abs(mean @ mean - 1) < 1e-12)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.6.matrices.degenerate",
        place="section 6, matrices",
        statement="A weighted sum of matrices of rotations may be degenerate.",
        verdict=Verdict.CONFIRMED,
        form=(identity(mp, 3), HALF_TURN),
        cases=lambda: [mp.mpf("0.5")],
        deviation=_not_degenerate,
        copies=(Copy("a quarter turn for the half turn", (identity(mp, 3), QUARTER_TURN)),),
    ),
    Claim(
        id="kaji_ochiai.6.matrices.rotations",
        place="section 6, matrices",
        statement="The sum of two rotations of space is no rotation.",
        verdict=Verdict.CONFIRMED,
        form=(1, 1),
        cases=_turn_pairs,
        deviation=_is_rotation,
        copies=(Copy("2 R - R' for R + R', which is one for R = R'", (2, -1)),),
        remark="In the plane it may be one: two rotations by an angle of 2π/3 between them.",
    ),
    Claim(
        id="kaji_ochiai.6.anti_commutative_dual_complex_numbers",
        place="section 6, Clifford algebras",
        statement="The unit anti-commutative dual complex numbers multiply as the rigid motions of the plane.",
        verdict=Verdict.CONFIRMED,
        form=_law_of_plane(conjugated=True),
        cases=_plane_motions,
        deviation=_not_a_motion,
        copies=(Copy("commuting ones, ε z = z ε", _law_of_plane(conjugated=False)),),
        remark="p + qε moves z to p² z + 2pq; the symbol of the group is lost in this copy.",
    ),
    Claim(
        id="kaji_ochiai.6.dual_quaternions.dimension",
        place="section 6, Clifford algebras",
        statement="Their parameter spaces are of greater dimension than the groups: dual quaternions by 2.",
        verdict=Verdict.CONFIRMED,
        form=motion_of_dual,
        cases=lambda: [exactly([1, 0, 0, 0, 0, 0, 0, 0]), exactly([1, 2, -1, 1, 0.5, 1, 0, -2])],
        deviation=lambda chart, at: abs(redundancy(chart, at) - 2),
        copies=(Copy("their turns only", _turn_of_dual),),
    ),
    Claim(
        id="kaji_ochiai.6.clifford_constructions",
        place="section 6, Clifford algebras",
        statement="No construction by Clifford algebras is known for all of Aff+(3); those that are known are special.",
        verdict=Verdict.UNCHECKABLE,
        reason="It tells what is known, and the symbols of the groups are lost.",
    ),
    Claim(
        id="kaji_ochiai.6.shoemake.extrapolation",
        place="section 6, Shoemake; table 2, extrapolation",
        statement="Linear extrapolation of the scale-shear parts leaves the positive definite matrices.",
        verdict=Verdict.CONFIRMED,
        form=_straight,
        cases=_extrapolated,
        deviation=_stays_definite,
        copies=(Copy("of their logarithms, as φ does", _by_logarithms),),
    ),
    Claim(
        id="kaji_ochiai.6.shoemake.unit_quaternions",
        place="section 6, Shoemake",
        statement="The unit quaternions are no linear space: a mean of two is none.",
        verdict=Verdict.CONFIRMED,
        form=(exactly([1, 0, 0, 0]), exactly([0, 1, 0, 0])),
        cases=lambda: [None],
        deviation=_mean_is_unit,
        copies=(Copy("one quaternion twice", (exactly([1, 0, 0, 0]), exactly([1, 0, 0, 0]))),),
    ),
)
