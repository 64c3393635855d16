"""Section 6: matrices, Clifford algebras and Lie algebras, and what the logarithm exists for."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.kaji_ochiai.other_parametrisations import redundancy
from affinecert.properties.claims.kaji_ochiai.subspaces import CLASSES, outside
from affinecert.properties.claims.kaji_ochiai.symmetric_functions import exponential, logarithm
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.properties.laws.subclasses import Subclass
from affinecert.reference import quaternion, sym3
from affinecert.reference._existence import Logarithm
from affinecert.reference._existence import logarithm as real_logarithm
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


def _motion_of_dual(numbers: Array) -> Array:
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
    return _motion_of_dual(numbers)[:3, :3]


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


def _integer_maps() -> list[Array]:
    """Integer matrices, some with negative eigenvalues, simple or double."""
    corners = [
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[-1, 0, 0], [0, -2, 0], [0, 0, 1]],
        [[-1, 1, 0], [0, -1, 0], [0, 0, 1]],
    ]
    drawn = (16 * each for each in arrays("roots", 8, (3, 3), -0.5, 0.5))
    found = [np.array(each, dtype=object) for each in corners]
    return found + [np.vectorize(int, otypes=[object])(each) for each in drawn]


def _power_without_logarithm(power: int, root: Array) -> int:
    """Whether an integer power of a regular map has positive determinant, and no real logarithm."""
    matrix = root
    for _ in range(power - 1):
        matrix = matrix @ root
    if definitions.determinant(matrix) <= 0:
        return 0
    return int(real_logarithm(matrix.tolist()) is Logarithm.NONE)


def _root_of_exponential(part: int) -> Any:
    return lambda m, x: definitions.exponential(m, x / part)


def _not_a_root(root: Any, case: tuple[Array]) -> Number:
    found = root(mp, *case)
    return difference(found @ found, definitions.exponential(mp, *case))


def _orthogonal(matrix: Array) -> Array:
    """A rational orthogonal matrix, as a multiple of it by an integer, from Cayley's transform of three integers."""
    a, b, c = matrix
    unit, skew = np.eye(3, dtype=int).astype(object), np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]], dtype=object)
    squares = a * a + b * b + c * c
    # (I + K)(I - K)^-1 with (I - K)^-1 = (I + K + v v^T) / (1 + |v|^2).
    product: Array = (unit + skew) @ (unit + skew + np.outer(matrix, matrix).astype(object))
    assert difference(product.T @ product, unit * (1 + squares) ** 2) == 0
    return product


def _stretched(matrix: Array) -> Array:
    """A map of GL+(3), which is connected and not compact: a rotation after a stretch."""
    return np.asarray(_orthogonal(matrix) @ np.array([[9, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=object))


def _lacks_logarithm(member: Any, case: tuple[Array, int]) -> int:
    numbers, sign = case
    matrix = member(numbers) * sign
    if definitions.determinant(matrix) < 0:  # a logarithm makes the determinant exp of its trace
        return 1
    return int(real_logarithm(matrix.tolist()) is Logarithm.NONE)


def _integers(*signs: int) -> list[tuple[Array, int]]:
    triples = ([0, 0, 0], [1, 0, 0], [1, -2, 3], [9, 1, 2], [0, 40, 1])
    return [(np.array(each, dtype=object), sign) for each in triples for sign in signs]


def _algebra(extra: int) -> Any:
    """An element of the Lie algebra of a class; with an extra symmetric generator if told."""

    def element(numbers: Array, subclass: Subclass) -> Array:
        x = numbers[3:6] if subclass.turns else numbers[3:6] * 0
        scale = numbers[6] if subclass.stretch != "none" else numbers[6] * 0
        shift = numbers[:3] if subclass.moves else numbers[:3] * 0
        matrix = np.full((4, 4), mp.zero, dtype=object)
        matrix[:3, :3] = [[scale, -x[2], x[1]], [x[2], scale, -x[0]], [-x[1], x[0], scale]]
        matrix[:3, 3] = shift
        matrix[0, 1] += extra
        matrix[1, 0] += extra
        return matrix

    return element


def _exponential_leaves(algebra: Any, case: tuple[str, Array]) -> Number:
    name, numbers = case
    return outside(definitions.exponential(mp, algebra(numbers, CLASSES[name])), CLASSES[name])


def _subgroups() -> list[tuple[str, Array]]:
    return list(
        zip(("SO(3)", "R^3", "R+", "CO+(3)", "SE(3)", "Sim+(3)"), arrays("algebra", 6, (7,), -1, 1), strict=True)
    )


def _by_closed_forms(half: int) -> Any:
    """The polar factors by equations 7 and 6 only."""

    def factors(m: Context, linear: Array) -> tuple[Array, Array]:
        log_stretch = logarithm(half=half)(m, linear)
        rotation: Array = linear @ exponential()(m, -log_stretch)
        return rotation, exponential()(m, log_stretch)

    return factors


def _polar(m: Context, linear: Array) -> tuple[Array, Array]:
    """The factors U V and V^T D V of L = U D V."""
    u, d, v = m.svd_r(m.matrix(linear.tolist()))
    return array((u * v).tolist()), array((v.T * m.diag(list(d)) * v).tolist())


def _linears() -> list[tuple[Array]]:
    corners = [exactly([[2, 1, 0], [0, 1, 0], [0, 0, 1]]), exactly([[-1, 0, 0], [0, -2, 0], [0, 0, 1]])]
    drawn = [each for each in arrays("polar", 8, (3, 3), -2, 2) if definitions.determinant(each) > 0]
    return [(each,) for each in corners + drawn]


def _lie_elements() -> list[tuple[Array]]:
    return [(each,) for each in arrays("Lie elements", 4, (3, 3), -2, 2)]


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
        form=_motion_of_dual,
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
    Claim(
        id="kaji_ochiai.6.compact_surjective",
        place="section 6, Lie algebras",
        statement="If a group is compact, its exponential map is surjective.",
        printed="When G is compact, this is surjective",
        verdict=Verdict.BOUND,
        domain="compact and connected, as SO(3); of O(3), compact too, it misses all reflections",
        form=_orthogonal,
        cases=lambda: _integers(1),
        outside=lambda: _integers(-1),
        deviation=_lacks_logarithm,
        copies=(Copy("a stretch after the rotations: GL+(3), connected and not compact", _stretched),),
    ),
    Claim(
        id="kaji_ochiai.6.subgroups",
        place="section 6, Lie algebras",
        statement="The exponential of the subalgebra of a subgroup stays in the subgroup: condition (V).",
        verdict=Verdict.CONFIRMED,
        form=_algebra(0),
        cases=_subgroups,
        deviation=_exponential_leaves,
        copies=(Copy("one symmetric generator besides", _algebra(1)),),
    ),
    Claim(
        id="kaji_ochiai.6.squares.if",
        place="section 6, the image of the exponential map",
        statement="A = B² of a regular real B has a real logarithm.",
        printed="A is in the image of the exponential map if and only if A = B² for some B",
        verdict=Verdict.CONFIRMED,
        form=2,
        cases=_integer_maps,
        deviation=_power_without_logarithm,
        copies=(Copy("B³ for B²", 3), Copy("B for B²", 1)),
    ),
    Claim(
        id="kaji_ochiai.6.squares.only_if",
        place="section 6, the image of the exponential map",
        statement="What has a logarithm X is a square, of exp(X/2).",
        verdict=Verdict.CONFIRMED,
        form=_root_of_exponential(2),
        cases=_lie_elements,
        deviation=_not_a_root,
        copies=(Copy("exp(X/3)", _root_of_exponential(3)),),
    ),
    Claim(
        id="kaji_ochiai.6.not_so_many",
        place="section 6, the image of the exponential map",
        statement="Maps without a logarithm are not so many.",
        verdict=Verdict.UNCHECKABLE,
        reason="How many are few is not said, nor among which maps.",
        remark="Of 3 by 3 matrices with independent normal entries and positive determinant 34 % have none, by "
        "200 000 drawn: whoever meets general maps has to provide for them.",
    ),
    Claim(
        id="kaji_ochiai.6.polar_by_closed_forms",
        place="section 6, the relation to the polar decomposition",
        statement="The closed forms give the polar decomposition, R = Â exp(-log S), S = exp(log S).",
        printed="the above relation provides an alternative method to compute the polar decomposition",
        verdict=Verdict.CONFIRMED,
        form=_by_closed_forms(2),
        cases=_linears,
        deviation=equals(_polar),
        copies=(Copy("log(ᵗÂÂ) for its half", _by_closed_forms(1)),),
        remark="In float64 for well conditioned maps only, and not for similarities: see section 4.4.",
    ),
)
