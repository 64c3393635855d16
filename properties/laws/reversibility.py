"""The way back is the way there, run backwards."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask, truth
from affinecert.properties.culver import without_half_turns
from affinecert.properties.inexact import CTX, UNDECIDED, UNIT, affine, exact, norm
from affinecert.properties.law import Law, OutOfDomain
from affinecert.properties.special import CANONICAL


def _backwards(time: Array) -> Array:
    # The rounding of 1 - t changes a time relatively by u, which the sensitivity to it counts already.
    return np.asarray(1.0 - time)


def _solids(name: str, maps: Maps, source: Array, target: Array, time: Array) -> float:
    _clear_of_half_turns(source, target)
    there = ask(maps, name, source, target, time)
    back = ask(maps, name, target, source, _backwards(time))
    return there["vertices"].misfit(back["vertices"])


def _clear_of_half_turns(source: Array, target: Array) -> None:
    """OutOfDomain if the rotation from one alignment to the other is by pi, or too close to tell it from pi."""
    (first, first_error), (second, second_error) = _alignment(source), _alignment(target)
    relative = first.T @ second
    sine = norm(relative - relative.T) / CTX.sqrt(8)  # |R - R^T|_F = sqrt(8) sin(angle)
    if relative.trace() < 1 and sine <= UNDECIDED * (first_error + second_error):
        raise OutOfDomain("a relative rotation by pi")


def _alignment(vertices: Array) -> tuple[Any, Any]:
    """The rotation that aligns a tetrahedron, or a triangle and its normal, and the error it may have."""
    known = truth("affine_lie.represent", vertices if len(vertices) == 4 else _raised(vertices), CANONICAL)
    return exact(known.high[0][:3, :3]), UNIT * (CTX.sqrt(3) + CTX.mpf(known.sensitivity[0]))


def _raised(triangle: Array) -> Array:
    """The tetrahedron over a triangle, moved to the origin, whose last edge is normal to it and of a like length."""
    first, second = exact(triangle[1:]) - exact(triangle[0])
    normal = np.cross(first, second)
    length = max(abs(first)) / (max(abs(normal)) or 1)
    return np.array([0 * first, first, second, length * normal], dtype=np.float64)


def _morphs(maps: Maps, start: Array, end: Array, time: Array) -> float:
    between = affine(end) @ affine(start).inverse()
    without_half_turns(between.linear.value)
    there = ask(maps, "sam.morph", start, end, time)
    back = ask(maps, "sam.morph", end, start, _backwards(time))
    return there.affine.misfit(back.affine)


def _splines(maps: Maps, points: Array, lengths: Array, time: Array) -> float:
    last = float(np.sum(np.maximum(lengths, 3.0) - 1.0))
    back = np.asarray(last - time)
    if not (time % 1.0 and back % 1.0):
        raise OutOfDomain("a knot, where the value of the other segment may count")
    there = ask(maps, "splines.evaluate", points, lengths, time)
    return there["point"].misfit(ask(maps, "splines.evaluate", points[::-1], lengths[::-1], back)["point"])


def _curves(maps: Maps, *arguments: Array) -> float:
    *poses, time = arguments
    there = ask(maps, "curves.bezier_quadratic", *poses, time)
    back = ask(maps, "curves.bezier_quadratic", *poses[::-1], _backwards(time))
    return there.affine.misfit(back.affine)


def _meshes(maps: Maps, source: Array, target: Array, triangles: Array, time: Array) -> float:
    there = ask(maps, "mesh2.symmetric", source, target, triangles, time)
    back = ask(maps, "mesh2.symmetric", target, source, triangles, _backwards(time))
    return there["vertices"].misfit(back["vertices"])


def _law(name: str, source: str, domain: str, residual: Callable[..., float]) -> Law:
    return Law(
        name=f"reversibility.{name}",
        statement="the interpolant from p to q at t is the one from q to p at 1 - t",
        source=source,
        domain=domain,
        needs=(name,),
        inputs=strategies.inputs(name),
        residual=residual,
    )


LEMMA, HALF_TURN = (
    "bansal_tatu, Lemma 5",
    "all pairs whose alignments differ by an angle below pi, by more than rounding; at pi exactly the law is false, "
    "for log(R^-1) = log(R) there, and the way back turns on instead of back",
)

LAWS = (
    _law("affine_lie.interpolate_tetrahedra", LEMMA, HALF_TURN, partial(_solids, "affine_lie.interpolate_tetrahedra")),
    _law("affine_lie.interpolate_triangles", LEMMA, HALF_TURN, partial(_solids, "affine_lie.interpolate_triangles")),
    _law(
        "sam.morph",
        "rossignac_vinacua, section 2.3 (3)",
        "C B^-1 with a real logarithm and no negative eigenvalue; at a double one the law is false as above",
        _morphs,
    ),
    Law(
        name="reversibility.splines.evaluate",
        statement="the spliced spline through the points in reverse at T - t is the one through the points at t",
        source="gallier, section 8: its conditions are the same in both directions",
        domain="segments of two points or more; all real t but whole numbers: at a junction the later segment counts",
        needs=("splines.evaluate",),
        inputs=strategies.inputs("splines.evaluate"),
        residual=_splines,
    ),
    _law(
        "curves.bezier_quadratic",
        "rossignac_vinacua, sections 2.3 (3) and 5.3",
        "as for curves.bezier_quadratic",
        _curves,
    ),
    _law(
        "mesh2.symmetric",
        "kaji_2d, section 4, improvements",
        "triangles that turn by less than pi; at pi the way back turns on instead of back",
        _meshes,
    ),
)
