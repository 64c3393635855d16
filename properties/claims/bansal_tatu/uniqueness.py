"""Section 3.4, Theorem 1: affine maps, pairs of tetrahedra, and the uniqueness of T = A S E."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.samples import (
    CANONICAL,
    HALF_TURN,
    TIMES,
    at,
    between,
    columns,
    embedded,
    inverse,
    maps,
    mirrored,
    moved,
    rigid_maps,
    scaling,
    tetrahedra,
    tetrahedron_pairs,
)
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import difference, distance, exactly, mp, size
from affinecert.reference import affine_lie, polar, se3, shear, so3
from affinecert.reference._matrices import Array, Number, homogeneous, norm

Parts = tuple[Array, Array, Number]
"""E (4, 4), A (3, 3) and s."""


def _quotient(source: Array, target: Array) -> Array:
    """Y X^-1 of the matrices of homogeneous vertices."""
    result: Array = columns(target) @ inverse(columns(source))
    return result


def _swapped_quotient(source: Array, target: Array) -> Array:
    result: Array = inverse(columns(source)) @ columns(target)
    return result


def _not_the_map(find: Callable[[Array, Array], Array], pair: tuple[Array, Array]) -> Number:
    """How far it is from an affine map X -> Y of positive determinant; the map is one alone if X is invertible."""
    source, target = pair
    found = find(source, target)
    wrong = max(distance(found @ columns(source), columns(target)), size(found[3] - exactly([0, 0, 0, 1])))
    unique = definitions.determinant(columns(source)) != 0
    return max(wrong, -definitions.determinant(found[:3, :3])) if unique else mp.inf


def _not_an_image(image: Callable[[Array, Array], Array], case: tuple[Array, Array]) -> Number:
    """How far Y is from a non-degenerate tetrahedron, oriented as X is, from which T goes back to X."""
    pose, source = case
    target = image(pose, source)
    volume = definitions.determinant(target[1:] - target[0])
    back = moved(inverse(pose), target)
    return max(distance(back, source), 0 if volume > 0 else 1)


def _maps_and_tetrahedra() -> list[tuple[Array, Array]]:
    return list(zip(maps(), (*tetrahedra(), *tetrahedra()), strict=False))


def _decomposed(pose: Array) -> Parts:
    rigid, matrix, scale = affine_lie.decompose(mp, pose)
    return rigid, matrix, scale[()]


def _other_way_round(pose: Array) -> Parts:
    """The factors of T = E S A."""
    rigid, matrix, scale = _decomposed(inverse(pose))
    return inverse(rigid), inverse(matrix), 1 / scale


def _polar(pose: Array) -> Parts:
    """With the rotation of the polar decomposition."""
    rotation, _ = polar.decompose(mp, pose[:3, :3])
    linear = pose[:3, :3] @ rotation.T
    scale = norm(mp, linear[:, 0])
    return homogeneous(mp, rotation, inverse(linear) @ pose[:3, 3]), linear / scale, scale


def _not_recovered(decompose: Callable[[Array], Parts], parts: Parts) -> Number:
    rigid, matrix, scale = parts
    return distance(decompose(embedded(matrix) @ scaling(scale) @ rigid), parts)


def _factors() -> list[Parts]:
    shears = [shear.exp(mp, alpha) for alpha in (exactly([1, 0, 0, 0, 0]), *arrays("factors", 5, (5,), -2, 2))]
    return [
        (rigid, matrix, mp.mpf(k + 1) / 3) for k, (rigid, matrix) in enumerate(zip(rigid_maps(), shears, strict=True))
    ]


def _unpaired(find: Callable[[Array, Array], Array], pair: tuple[Array, Array]) -> Number:
    """How far the map between two tetrahedra is from an orientation-preserving one between them."""
    source, target = pair
    found = find(source, target)
    misplaced = distance(moved(found, source), target)
    return max(misplaced, 0 if definitions.determinant(found[:3, :3]) > 0 else 1)


def _shortest(pose: Array) -> list[Array]:
    """The interpolants at t = 1/4, E^t by each of the shortest logarithms of E."""
    rigid, matrix, scale = _decomposed(pose)
    t = TIMES[0]
    upper = embedded(shear.exp(mp, shear.log(mp, matrix) * t)) @ scaling(scale**t)
    axis, angle = so3.axis_angle(mp, rigid[:3, :3])
    angles = sorted((angle + 2 * mp.pi * k for k in (-1, 0, 1)), key=abs)
    shortest = [each for each in angles if abs(each) - abs(angles[0]) < mp.mpf(10) ** -60]
    twists = [se3.continue_log(mp, np.concatenate([axis * each, exactly([0, 0, 0])]), rigid) for each in shortest]
    return [upper @ se3.exp(mp, twist * t) for twist in twists]


def _orderings(pose: Array) -> list[Array]:
    """The maps at t = 1/4 from the canonical tetrahedron, by the orderings of its vertices."""
    goal = moved(pose, CANONICAL)
    return [between(CANONICAL, each) for each in affine_lie.interpolate_orderings(mp, CANONICAL, goal, at(TIMES[0]))]


def _apart(interpolants: Callable[[Array], list[Array]], pose: Array) -> Number:
    """How far interpolants at one time are apart."""
    first, *others = interpolants(pose)
    return max((difference(first, other) for other in others), default=mp.zero)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.theorem_1.1",
        place="section 3.4, Theorem 1 (1)",
        statement="One affine map takes a non-degenerate tetrahedron to another of the same orientation, and it "
        "preserves orientation.",
        printed="T Δ_X = Δ_Y",
        verdict=Verdict.CONFIRMED,
        form=_quotient,
        cases=tetrahedron_pairs,
        deviation=_not_the_map,
        copies=(Copy("X⁻¹Y for Y X⁻¹", _swapped_quotient),),
    ),
    Claim(
        id="bansal_tatu.theorem_1.2",
        place="section 3.4, Theorem 1 (2)",
        statement="An orientation-preserving affine map takes each non-degenerate tetrahedron to one, which keeps the "
        "orientation, and from which T⁻¹ leads back.",
        verdict=Verdict.CONFIRMED,
        form=moved,
        cases=_maps_and_tetrahedra,
        deviation=_not_an_image,
        copies=(Copy("T⁻¹ for T", lambda pose, source: moved(inverse(pose), source)),),
    ),
    Claim(
        id="bansal_tatu.theorem_1.3",
        place="section 3.4, Theorem 1 (3)",
        statement="The factors of T = A S E are unique: those of a product A S E are A, S and E again.",
        printed="T = A S E",
        verdict=Verdict.CONFIRMED,
        form=_decomposed,
        cases=_factors,
        deviation=_not_recovered,
        copies=(
            Copy("T = E S A", _other_way_round),
            Copy("the rotation of the polar decomposition", _polar),
        ),
        remark="The linear part s A R is an RQ factorisation, so that a pure stretch S along oblique axes has R ≠ I.",
    ),
    Claim(
        id="bansal_tatu.3.4.bijection",
        place="section 3.4, after Theorem 1",
        statement="Orientation-preserving affine maps correspond one to one to pairs of non-degenerate tetrahedra, one "
        "of which is fixed.",
        verdict=Verdict.BOUND,
        domain="pairs of tetrahedra of one orientation",
        form=between,
        cases=tetrahedron_pairs,
        outside=lambda: [(source, mirrored(target)) for source, target in tetrahedron_pairs()[:3]],
        deviation=_unpaired,
        copies=(Copy("the pair exchanged", lambda source, target: between(target, source)),),
    ),
    Claim(
        id="bansal_tatu.1.unique_interpolation",
        place="section 1, contribution (3)",
        statement="The interpolation is unique, given a correspondence and an order of the vertices.",
        verdict=Verdict.BOUND,
        domain="rotations E by less than π; at π two logarithms are as short",
        form=_shortest,
        cases=maps,
        outside=lambda: [affine(HALF_TURN), affine(HALF_TURN, (1, 0, 1)), affine(2 * HALF_TURN)],
        deviation=_apart,
        copies=(Copy("any order of the vertices", _orderings),),
    ),
)
