"""The catalogue of blends of triangulated shapes of space."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from affinecert.catalogue import turns
from affinecert.catalogue.parts import ENTRIES, NORM, WHOLE
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Map, Point, Regime
from affinecert.reference import mesh3 as reference
from affinecert.sampling import any_rotation, signed, vector

Triangles = tuple[tuple[int, int, int], ...]

HINGE: Triangles = ((0, 1, 2), (2, 1, 3))
"""Two triangles with an edge in common."""

TETRAHEDRON: Triangles = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))
"""A closed surface."""

TRIANGLE: Triangles = ((0, 1, 2),)

PLACES = {
    HINGE: np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.3]]),
    TETRAHEDRON: np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, 0.3, 1.0]]),
    TRIANGLE: np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
}
"""About where the vertices of each mesh are."""

TARGETS = 2


@dataclass(frozen=True)
class Shapes:
    """A shape at rest, (vertices, 3), its targets, and the distance to what makes them difficult."""

    rest: Array
    targets: Array
    triangles: Triangles
    distance: float


def _moved(draw: Draw, triangles: Triangles, size: float = 0.2) -> Array:
    """The vertices of a mesh, each moved by up to that."""
    places = PLACES[triangles]
    return places + size * np.array([draw.uniform(0.0, 1.0) * draw.direction(3) for _ in places])


def _generic(triangles: Triangles, draw: Draw) -> Shapes:
    """Targets turned by up to 1.5 as a whole: the triangles by less than 2.7."""
    angles = [draw.uniform(0.0, 1.5) for _ in range(TARGETS)]
    targets = [
        draw.uniform(0.5, 2.0) * _moved(draw, triangles) @ turns.about(draw.direction(3), angle, angle).matrix
        for angle in angles
    ]
    return Shapes(_moved(draw, triangles), np.array(targets), triangles, math.pi - max(angles))


def _near_rest(draw: Draw) -> Shapes:
    gap, rest = draw.exponent(-16, -1), _moved(draw, HINGE)
    targets = [rest + gap * draw.direction(rest.size).reshape(rest.shape) for _ in range(TARGETS)]
    return Shapes(rest, np.array(targets), HINGE, gap)


def _large_rotation(draw: Draw) -> Shapes:
    """All triangles turned by nearly pi, about nearly one axis."""
    gap, rest, axis = draw.exponent(-8, 0), _moved(draw, HINGE), draw.direction(3)
    turn = turns.short_of_pi(axis, gap, gap).matrix
    targets = [rest @ turn.T + gap / 40 * draw.direction(rest.size).reshape(rest.shape) for _ in range(TARGETS)]
    return Shapes(rest, np.array(targets), HINGE, gap)


def _thin(draw: Draw) -> Shapes:
    """Shapes flattened along the plane of the hinge, at rest or in a target."""
    ratio, shapes = draw.exponent(-6, -1), _generic(HINGE, draw)
    frame = any_rotation(draw)
    flat = frame @ np.diag([1.0, ratio, ratio]) @ frame.T
    if draw.choice((True, False)):
        return replace(shapes, rest=shapes.rest @ flat, distance=ratio)
    return replace(shapes, targets=np.array([shapes.targets[0], shapes.targets[1] @ flat]), distance=ratio)


def _far(draw: Draw) -> Shapes:
    shapes, away = _generic(HINGE, draw), [vector(draw, 0, 8) for _ in range(1 + TARGETS)]
    targets = shapes.targets + np.array(away[1:])[:, None]
    return replace(shapes, rest=shapes.rest + away[0], targets=targets, distance=float(np.linalg.norm(away[0])))


def _huge_or_tiny(draw: Draw) -> Shapes:
    shapes, exponent = _generic(HINGE, draw), draw.choice(range(-300, 301))
    rest, targets = np.ldexp(shapes.rest, exponent), np.ldexp(shapes.targets, exponent + draw.choice(range(-20, 21)))
    return replace(shapes, rest=rest, targets=targets, distance=2.0**exponent)


def _outside(draw: Draw) -> Shapes:
    """A triangle without area."""
    shapes = _generic(HINGE, draw)
    if draw.choice((True, False)):
        return replace(shapes, rest=shapes.rest[[0, 1, 2, draw.choice((1, 2))]])
    return replace(shapes, targets=shapes.targets[:, [0, 1, 2, 2]])


def _between(draw: Draw) -> list[float]:
    first = draw.uniform(0.0, 1.0)
    return [first, draw.uniform(0.0, 1.0 - first)]


def _at_an_end(draw: Draw) -> list[float]:
    return draw.choice(([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]))


def _beyond(draw: Draw) -> list[float]:
    return [signed(draw, -1, 0.3) for _ in range(TARGETS)]


def _regime(
    name: str,
    build: Callable[[Draw], Shapes],
    distance: str,
    weights: Callable[[Draw], list[float]] = _between,
    share: float = 0.12,
) -> Regime:
    def point(draw: Draw) -> Point:
        shapes = build(draw)
        triangles = np.array(shapes.triangles, dtype=np.float64)
        return Point((shapes.rest, shapes.targets, triangles, np.array(weights(draw))), shapes.distance)

    return Regime(name, point, distance, share)


GENERIC = partial(_generic, HINGE)

MAPS = (
    Map(
        name="mesh3.blend",
        definition="the U that minimises the sum of area_j |A_j - A_j'|_F^2: A_j' the blend of the affine maps of "
        "triangle j and its unit normal from rest to targets, A_j any affine map of that triangle to that of U; the "
        "barycentre is b + sum of w_i (b_i - b)",
        source="kaji_ochiai, section 5.3",
        domain="a mesh in one piece, all of whose triangles have an area; any weights",
        arguments=(
            Argument("rest", ("vertices", 3), (NORM,), "length"),
            Argument("targets", ("targets", "vertices", 3), (NORM,), "length"),
            Argument("triangles", ("faces", 3), ()),
            Argument("weights", ("targets",), (ENTRIES,), "1"),
        ),
        outputs=(("vertices", 3),),
        blocks=(Block("vertices", 0, WHOLE),),
        regimes=(
            _regime("generic", GENERIC, "pi - angle"),
            _regime("closed", partial(_generic, TETRAHEDRON), "pi - angle", share=0.05),
            _regime("one-triangle", partial(_generic, TRIANGLE), "pi - angle"),
            _regime("near-rest", _near_rest, "distance of rest and targets"),
            _regime("large-rotation", _large_rotation, "pi - angle"),
            _regime("thin", _thin, "ratio of height and length"),
            _regime("tiny-next-to-huge", _far, "distance from the origin"),
            _regime("huge-or-tiny", _huge_or_tiny, "scale"),
            _regime("at-the-ends", GENERIC, "pi - angle", _at_an_end),
            _regime("extrapolation", GENERIC, "pi - angle", _beyond),
            _regime("outside", _outside, "none"),
        ),
        reference=reference.blend,
        accuracy=8.0,
        cost=60.0,
        remark="Condition against perturbations of the shapes as vectors of all coordinates, the targets together, "
        "each relative to its length: a shape far from the origin counts with its distance. Where a triangle turns by "
        "pi exactly the map jumps, and the condition is beyond all bounds. Indices are exact.",
    ),
)
