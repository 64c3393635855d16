"""Sections 5.2, 5.2.2 and 6.5: what the order of the vertices does to the interpolation."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import permutations
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.samples import (
    CANONICAL,
    REGULAR,
    at,
    between,
    embedded,
    inverse,
    maps,
    moved,
    scaling,
    tetrahedra,
)
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import difference, distance, mp
from affinecert.reference import affine_lie, sam, se3, shear
from affinecert.reference._matrices import Array, Number

Order = tuple[int, ...]
"""The numbers of the vertices in turn."""
Paths = Callable[[Array, Array, Number], Array]
"""The affine maps at t between two tetrahedra, by each of the twelve orderings, (12, 4, 4)."""

HALF = mp.mpf(1) / 2


def by_lie(source: Array, target: Array, t: Number) -> Array:
    """The maps at t by each of the orderings, (12, 4, 4)."""
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


def apart(paths: Paths, case: tuple[Array, Array]) -> Number:
    """How far apart the orderings lead half way."""
    pose, source = case
    first, *others = paths(source, moved(pose, source), HALF)
    return max(difference(first, other) for other in others)


def _alike(paths: Paths, case: tuple[Array, Array]) -> int:
    return int(apart(paths, case) < mp.mpf(10) ** -12)


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
            statement="T_t^O is the affine map from the source to the tetrahedron of equation 4", form=by_lie
        ),
        remark="Were A_O, S_O, E_O the factors of T, they would be the same for all orderings (Theorem 1), and u = 0.",
    ),
    Claim(
        id="bansal_tatu.5.2.2.dependence",
        place="section 5.2.2",
        statement="If there is a shear between the tetrahedra, the path depends on the order of the vertices.",
        verdict=Verdict.CONFIRMED,
        form=by_lie,
        cases=_sheared,
        deviation=_alike,
        copies=(Copy("the steady affine morph", _by_sam),),
    ),
)
