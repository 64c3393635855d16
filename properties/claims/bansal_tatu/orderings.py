"""Section 5.2: what the order of the vertices does to the interpolation."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import permutations
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.samples import (
    CANONICAL,
    REGULAR,
    affine,
    at,
    between,
    embedded,
    inverse,
    maps,
    moved,
    rigid_maps,
    scaling,
    tetrahedra,
)
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.precision import difference, distance, mp
from affinecert.reference import affine_lie, measures, sam, se3, shear
from affinecert.reference._matrices import Array, Number, array

Order = tuple[int, ...]
"""The numbers of the vertices in turn."""
Paths = Callable[[Array, Array, Number], Array]
"""The affine maps at t between two tetrahedra, by each of the twelve orderings, (12, 4, 4)."""

HALF = mp.mpf(1) / 2


def _relation(*, scaled: bool = False) -> Callable[[Array, Array], Array]:
    """E_q of E_p, for Δ_q = S E Δ_p."""

    def rigid(rigid_p: Array, similarity: Array) -> Array:
        scale = scaling(_growth(similarity))
        step = inverse(inverse(scale) @ similarity)
        moving: Array = scale @ rigid_p @ step @ inverse(scale) if scaled else rigid_p @ step
        return moving

    return rigid


def _growth(similarity: Array) -> Number:
    return mp.cbrt(definitions.determinant(similarity[:3, :3]))


def _other_relation(rigid: Callable[[Array, Array], Array], case: tuple[Array, Array]) -> Number:
    """How far (E_q, A_q, s_q) is from that E_q, A_p and s_p / s."""
    similarity, source = case
    p, q = (affine_lie.represent(mp, each, CANONICAL) for each in (source, moved(similarity, source)))
    return distance((q[0], q[1], q[2][()]), (rigid(p[0], similarity), p[1], p[2][()] / _growth(similarity)))


def _similarities() -> list[tuple[Array, Array]]:
    """Isometries and then similarities, with tetrahedra."""
    pairs = list(zip(rigid_maps(), tetrahedra(), strict=False))
    return [*pairs, (scaling(mp.mpf(2)), CANONICAL + 1), (scaling(mp.mpf(3)) @ rigid_maps()[2], REGULAR)]


def _by_lie(source: Array, target: Array, t: Number) -> Array:
    results = affine_lie.interpolate_orderings(mp, source, target, at(t))
    return np.array([between(source, each) for each in results])


def _by_sam(source: Array, target: Array, t: Number) -> Array:
    """The steady morphs of the simplices that begin with each of the vertices."""
    poses = [sam.power(mp, between(source[list(order)], target[list(order)]), at(t)) for order in affine_lie.ORDERINGS]
    return np.array(poses)


def _literally(source: Array, target: Array, t: Number) -> Array:
    """The products of the powers of the factors of p^-1 q, as section 5.2.2 prints them."""
    found = []
    for order in map(list, affine_lie.ORDERINGS):
        p, q = (affine_lie.represent(mp, each[order], CANONICAL) for each in (source, target))
        rigid = se3.exp(mp, se3.log(mp, inverse(p[0]) @ q[0]) * t)
        upper = shear.log(mp, shear.exp(mp, -shear.log(mp, p[1])) @ q[1])
        found.append(embedded(shear.exp(mp, upper * t)) @ scaling((q[2][()] / p[2][()]) ** t) @ rigid)
    return np.array(found)


def _off_target(paths: Paths, case: tuple[Array, Array]) -> Number:
    """How far the maps at t = 1 are from the affine map to the target."""
    pose, source = case
    return max(distance(each, pose) for each in paths(source, moved(pose, source), mp.one))


def _apart(paths: Paths, case: tuple[Array, Array]) -> Number:
    """How far apart the orderings lead half way."""
    pose, source = case
    first, *others = paths(source, moved(pose, source), HALF)
    return max(difference(first, other) for other in others)


def _isometries() -> list[tuple[Array, Array]]:
    return list(zip(rigid_maps(), (CANONICAL, REGULAR, *tetrahedra()[3:]), strict=False))


def _scalings() -> list[tuple[Array, Array]]:
    little = mp.mpf(17) / 16
    return [
        (scaling(little), CANONICAL),
        (scaling(mp.mpf(2)), REGULAR),
        (scaling(little) @ rigid_maps()[2], tetrahedra()[4]),
    ]


def _doubled() -> dict[str, Number]:
    times = array([-mp.log(mp.log(2), 2)])  # where 1 + t - 2^t, by which the centres of scaling differ, is largest
    source = REGULAR / mp.sqrt(3)
    most, median = measures.path_deviation(mp, source, 2 * source, times)
    return {"u for a regular tetrahedron in the unit sphere, doubled: maximum": most, "median": median}


def _alike(paths: Paths, case: tuple[Array, Array]) -> int:
    return int(_apart(paths, case) < mp.mpf(10) ** -12)


def _sheared() -> list[tuple[Array, Array]]:
    poses = [affine([[1, 1, 0], [0, 1, 0], [0, 0, 1]]), affine([[2, 0, 0], [0, 1, 0], [0, 0, 1]]), *maps()[4:]]
    poses = [each for each in poses if sam.exists(mp, each)]
    return list(zip(poses, (CANONICAL, CANONICAL, REGULAR, *tetrahedra()[3:]), strict=False))


def _oriented_orders(solid: Array) -> set[Order]:
    """The orders of the vertices in which a tetrahedron is oriented as before."""
    orders = permutations(range(4))
    return {each for each in orders if definitions.determinant(solid[list(each)][1:] - solid[each[0]]) > 0}


def _twelve() -> list[Order]:
    """The orders by first edge, to and fro, with the one order of the others that keeps orientation."""
    return [(i, j, *_rest(i, j)) for i in range(4) for j in range(4) if i != j]


def _rest(i: int, j: int) -> Order:
    k, m = (each for each in range(4) if each not in (i, j))
    inversions = (i > j) + sum(first > other for first in (i, j) for other in (k, m))
    return (k, m) if inversions % 2 == 0 else (m, k)


def _miscounted(orders: Sequence[Order], solid: Array) -> int:
    return len(set(orders) ^ _oriented_orders(solid)) + abs(len(orders) - 12)


def _undecided(key: Callable[[Order], object], solid: Array) -> int:
    """How many of the orders are not told from each other."""
    orders = _oriented_orders(solid)
    return len(orders) - len({key(each) for each in orders})


def _tangent(p: Array, q: Array) -> Array:
    return se3.log(mp, inverse(p) @ q)


def _tangents_apart(tangent: Callable[[Array, Array], Array], case: tuple[Array, Array]) -> Number:
    """How far log(E_p^-1 E_q) of the orderings are apart."""
    pose, source = case
    target = moved(pose, source)
    found = []
    for order in map(list, affine_lie.ORDERINGS):
        p, q = (affine_lie.represent(mp, each[order], CANONICAL)[0] for each in (source, target))
        found.append(tangent(p, q))
    return max(difference(found[0], other) for other in found[1:])


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.5.2.face_and_edge",
        place="section 5.2",
        statement="What the representation depends on in the order of the vertices is the first face and the first "
        "edge of it.",
        verdict=Verdict.CONFIRMED,
        form=lambda order: (frozenset(order[:3]), frozenset(order[:2])),
        cases=lambda: [CANONICAL, REGULAR],
        deviation=_undecided,
        copies=(
            Copy("the face alone", lambda order: frozenset(order[:3])),
            Copy("the edge alone", lambda order: frozenset(order[:2])),
        ),
        remark="The first edge with its direction tells as much: the orientation gives the face.",
    ),
    Claim(
        id="bansal_tatu.6.5.twelve_orderings",
        place="section 6.5",
        statement="There are 12 orderings of a tetrahedron's vertices: those that keep its orientation.",
        verdict=Verdict.CONFIRMED,
        form=_twelve(),
        cases=lambda: [CANONICAL, REGULAR],
        deviation=_miscounted,
        copies=(
            Copy("all 24 orders", list(permutations(range(4)))),
            Copy("the first two exchanged", [(each[1], each[0], *each[2:]) for each in _twelve()]),
        ),
    ),
    Claim(
        id="bansal_tatu.5.2.1.relation",
        place="section 5.2.1",
        statement="If Δ_q = S E Δ_p, then q = p (E⁻¹, I, 1/s).",
        printed="q_O = p_O (E⁻¹, I₃, 1/s)",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_relation(),
        cases=_similarities,
        deviation=_other_relation,
        correction=Correction(
            statement="q = (S E_p E⁻¹ S⁻¹, A_p, s_p / s): the translation of E_q is scaled, too",
            form=_relation(scaled=True),
        ),
        remark="S and the translation of E_p do not commute. It is right for isometries, s = 1.",
    ),
    Claim(
        id="bansal_tatu.5.2.1.tangent",
        place="section 5.2.1",
        statement="For isometries and uniform scalings the tangent vector log(p⁻¹q) is the same for all orderings.",
        printed="log((p_O)⁻¹ q_O) = log((E⁻¹, I₃, 1/s))",
        verdict=Verdict.BOUND,
        domain="isometries, s = 1",
        form=_tangent,
        cases=_isometries,
        outside=_scalings,
        deviation=_tangents_apart,
        copies=(Copy("q p⁻¹ for p⁻¹q", lambda p, q: se3.log(mp, q @ inverse(p))),),
    ),
    Claim(
        id="bansal_tatu.5.2.1.invariance",
        place="section 5.2.1",
        statement="The interpolation does not depend on the order of the vertices if the map is an isometry, a uniform "
        "scaling or both.",
        verdict=Verdict.BOUND,
        domain="isometries, s = 1; each ordering scales about a path of its own first vertex",
        form=_by_lie,
        cases=_isometries,
        outside=_scalings,
        deviation=_apart,
        copies=(Copy("the interpolant of a tetrahedron twice as large", lambda p, q, t: _by_lie(p, 2 * q, t)),),
        numbers=_doubled,
        remark="The shapes are the same up to translation; their places differ.",
    ),
    Claim(
        id="bansal_tatu.5.2.2.paths",
        place="section 5.2.2",
        statement="The interpolated maps of an ordering O are exp(t log A_O) exp(t log S_O) exp(t log E_O), with the "
        "factors of p_O⁻¹q_O: so at t = 1 they are the map to the target.",
        printed="T_t^O = exp(t log A_O) exp(t log S_O) exp(t log E_O)",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_literally,
        cases=_sheared,
        deviation=_off_target,
        correction=Correction(
            statement="T_t^O is the affine map from the source to the tetrahedron of equation 4", form=_by_lie
        ),
        remark="Were A_O, S_O, E_O the factors of T, they would be the same for all orderings (Theorem 1), and u = 0.",
    ),
    Claim(
        id="bansal_tatu.5.2.2.dependence",
        place="section 5.2.2",
        statement="If there is a shear between the tetrahedra, the path depends on the order of the vertices.",
        verdict=Verdict.CONFIRMED,
        form=_by_lie,
        cases=_sheared,
        deviation=_alike,
        copies=(Copy("the steady affine morph", _by_sam),),
    ),
)
