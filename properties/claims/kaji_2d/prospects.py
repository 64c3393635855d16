"""Section 5 and what is said of the whole: flips of the global interpolation, three dimensions, other methods."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_2d.errors import frobenius, similarity
from affinecert.properties.claims.kaji_2d.minimisers import goals, interpolated
from affinecert.properties.claims.kaji_2d.plane import determinant, square, zero_or_one
from affinecert.properties.claims.kaji_2d.shapes import SQUARE, Error, Mesh, linear_parts, precise, rational
from affinecert.properties.claims.precision import HOLDS, exactly, mp
from affinecert.reference._matrices import Array, Number, array

Parts = Callable[[Error, Mesh, Array, Number], list[Array]]
"""The linear parts of the triangles of a mesh on its way to a target, at a time."""

WHEEL = Mesh(
    rational([[0, 0], [4, 0], [1, 4], [-3, 2], [-3, -2], [1, -4]]),
    ((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1)),
    "a wheel",
)


def _of_minimiser(error: Error, mesh: Mesh, target: Array, t: Number) -> list[Array]:
    return linear_parts(mesh, interpolated((mesh, target, t), error))


def _by_themselves(error: Error, mesh: Mesh, target: Array, t: Number) -> list[Array]:
    return goals(mesh, target, t)


def _turning_over() -> list[tuple[str, Mesh, Array]]:
    """Found by search: each triangle of the target has the orientation of the source."""
    square, wheel = precise(SQUARE), precise(WHEEL)
    found = [
        ("E^F", square, [[0, 0], [1, 2], [-2, -2], [2, 1]]),
        ("E^F", wheel, [[0, 0], [204, -23], [-39, 15], [-29, 11], [13, -5], [8, -3]]),
        ("E^R", wheel, [[0, 0], [13, 3], [0, 2], [-25, 9], [11, -4], [3, -1]]),
    ]
    return [(name, mesh, exactly(target)) for name, mesh, target in found]


def _sound(parts: Parts, case: tuple[str, Mesh, Array]) -> int:
    """Whether no triangle is turned over half way."""
    name, mesh, target = case
    error = frobenius if name == "E^F" else similarity
    return zero_or_one(min(determinant(each) for each in parts(error, mesh, target, mp.mpf(0.5))) > -HOLDS)


def _by_singular_values(a: Array, b: Array) -> Number:
    """The least |s R A - B|² over rotations R and real s, by the singular values of B Aᵀ: of plane and space."""
    product = b @ a.T
    values = sorted(abs(v) for v in mp.svd_r(mp.matrix(product.tolist()), compute_uv=False))
    reflected = definitions.determinant(product) < 0
    # In the plane -1 is a rotation, and a reflection costs the smaller value; in space s = -1 makes one of it.
    if len(a) == 2 and reflected:
        values[0] = -values[0]
    return square(b) - sum(values) ** 2 / square(a)


def _with_reflections(a: Array, b: Array) -> Number:
    values = mp.svd_r(mp.matrix((b @ a.T).tolist()), compute_uv=False)
    return square(b) - sum(abs(v) for v in values) ** 2 / square(a)


ERRORS: Mapping[str, Error] = {"E^F": frobenius, "E^R": _by_singular_values}


def _not_quadratic(errors: Any, case: tuple[str, Array, Array, Array]) -> Number:
    """How far the second difference E(B + C) - 2 E(B) + E(B - C) is from that at 0, relative to the maps."""
    name, a, b, c = case
    there, origin = (
        errors[name](a, middle + c) - 2 * errors[name](a, middle) + errors[name](a, middle - c) for middle in (b, b * 0)
    )
    return abs(there - origin) / (square(a) + square(b) + square(c))


def _unit(size: int, k: int) -> Array:
    return array([[mp.mpf(i == j == k) for j in range(size)] for i in range(size)])


def _maps(name: str, size: int) -> list[tuple[str, Array, Array, Array]]:
    one = sum((_unit(size, k) for k in range(1, size)), _unit(size, 0))
    drawn = [(name, *arrays(f"{name} {size} {k}", 3, (size, size), -2, 2)) for k in range(3)]
    return [(name, one, _unit(size, 0), _unit(size, 1)), *drawn]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.5.flips",
        place="section 5",
        statement="The global interpolation may flip triangles although the local homotopy A^E never does.",
        verdict=Verdict.CONFIRMED,
        form=_of_minimiser,
        cases=_turning_over,
        deviation=_sound,
        copies=(Copy("each triangle by itself", _by_themselves),),
        remark="Half way, for E^F and E^R alike. In the first case θ of the neighbours lies on both sides of π; in the "
        "others all θ are within less than π, but sizes change unlike. So E has to be defined for all B, not only in "
        "GL⁺.",
    ),
    Claim(
        id="kaji_2d.5.three_dimensions",
        place="section 5",
        statement="The method extends to three dimensions easily and directly: the errors stay quadratic in B.",
        verdict=Verdict.BOUND,
        domain="E^F in space, and the plane; not E^R in space, where the s R are no linear space",
        form=ERRORS,
        cases=lambda: [*_maps("E^F", 2), *_maps("E^R", 2), *_maps("E^F", 3)],
        outside=lambda: _maps("E^R", 3),
        deviation=_not_quadratic,
        copies=(Copy("reflections allowed in E^R", {**ERRORS, "E^R": _with_reflections}),),
        remark="In space E^R = |B|² - (σ₁ + σ₂ + σ₃)² / |A|², of the singular values of B Aᵀ: no linear equations. "
        "A^E, its determinant and E^F carry over.",
    ),
    Claim(
        id="kaji_2d.5.most_methods",
        place="abstract, section 5",
        statement="Most of the rigid interpolation methods are characterised in this framework.",
        verdict=Verdict.UNCHECKABLE,
        reason="Only [ACOL00] is put into it in full; the others are named, not derived.",
    ),
    Claim(
        id="kaji_2d.1.normal_equations",
        place="section 1",
        statement="[BBA08] presents algorithms that meet the demands (a) to (c) by normal equations.",
        verdict=Verdict.UNCHECKABLE,
        reason="A statement on another paper, which is not at hand.",
    ),
)
"""Prospects."""
