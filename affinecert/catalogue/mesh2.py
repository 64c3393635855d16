"""The catalogue of global interpolation: small triangulated shapes of the plane, by their way from source to target."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from affinecert.catalogue.parts import ENTRIES, NORM, TIME, WHOLE
from affinecert.catalogue.times import about_time, timed
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Map, Point, Regime
from affinecert.reference import mesh2 as reference
from affinecert.sampling import any_rotation, scalar, signed, vector

Triangles = tuple[tuple[int, int, int], ...]

FAN: Triangles = ((0, 1, 2), (0, 2, 3), (0, 3, 1))
"""Three triangles about a vertex: the smallest mesh in which they get into each other's way."""

WHEEL: Triangles = ((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1))
"""Five of them."""

STRIP: Triangles = ((0, 1, 2), (2, 1, 3), (2, 3, 4))
"""Three triangles in a row, all vertices on the boundary: no similarity is refused them one by one."""

TRIANGLE: Triangles = ((0, 1, 2),)


@dataclass(frozen=True)
class Shapes:
    """A source and a target, (vertices, 2), of the same triangles, and the distance to what makes them difficult."""

    source: Array
    target: Array
    triangles: Triangles
    distance: float


def about_a_vertex(spokes: int, draw: Draw) -> Array:
    """A vertex and that many about it, counterclockwise; no height of a triangle is below 0.1."""
    step = 2 * math.pi / spokes
    angles = [step * (k + draw.uniform(-0.1, 0.1)) for k in range(spokes)]
    ends = [draw.uniform(0.7, 1.4) * np.array([math.cos(angle), math.sin(angle)]) for angle in angles]
    return np.array([0.1 * draw.direction(2), *ends])


def strip(draw: Draw) -> Array:
    """Five vertices on two lines, in turns."""
    return np.array([[k / 2 + draw.uniform(-0.2, 0.2), 1 - k % 2 + draw.uniform(-0.2, 0.2)] for k in range(5)])


def triangle(draw: Draw) -> Array:
    """Three vertices counterclockwise."""
    return np.array([[0.0, 0.0], [draw.uniform(0.5, 1.5), 0.0], [draw.uniform(-1, 1), draw.uniform(0.5, 1.5)]])


SHAPES: Mapping[Triangles, Callable[[Draw], Array]] = {
    FAN: partial(about_a_vertex, 3),
    WHEEL: partial(about_a_vertex, 5),
    STRIP: strip,
    TRIANGLE: triangle,
}
"""How the vertices of each mesh are drawn."""


def relabelled(draw: Draw, shapes: Shapes) -> Shapes:
    """The same shapes, their vertices in another order: the first and the last one are anywhere."""
    count = len(shapes.source)
    order = sorted(range(count), key=lambda _: draw.uniform(0.0, 1.0))
    place = {vertex: number for number, vertex in enumerate(order)}
    triangles = tuple((place[i], place[j], place[k]) for i, j, k in shapes.triangles)
    return replace(shapes, source=shapes.source[order], target=shapes.target[order], triangles=triangles)


def turned(shape: Array, angle: float) -> Array:
    """The shape turned about the origin."""
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.asarray(shape @ np.array([[cosine, sine], [-sine, cosine]]))


def _generic(triangles: Triangles, draw: Draw) -> Shapes:
    source, target = (SHAPES[triangles](draw) for _ in range(2))
    # Of their own the triangles turn by less than 1.6.
    angle = draw.uniform(-1.5, 1.5)
    return Shapes(source, draw.uniform(0.5, 2) * turned(target, angle), triangles, math.pi - abs(angle))


def _near_identity(draw: Draw) -> Shapes:
    source, gap = SHAPES[FAN](draw), draw.exponent(-16, -1.5)
    return Shapes(source, source + gap * draw.direction(8).reshape(4, 2), FAN, gap)


def _large_rotation(draw: Draw) -> Shapes:
    """All triangles turned by nearly pi, to one side of it."""
    source, gap = SHAPES[FAN](draw), signed(draw, -8, 0)
    # With heights above 0.1, an edge moved by 0.02 of the gap turns a triangle by a fifth of it at most.
    target = source + abs(gap) / 100 * draw.direction(8).reshape(4, 2)
    return Shapes(source, -turned(target, -gap), FAN, abs(gap))


def _thin(draw: Draw) -> Shapes:
    """Shapes flattened along any directions, one or both."""
    ratio = draw.exponent(-8, -1)
    flat = [shape @ any_rotation(draw, 2) * np.array([1.0, ratio]) for shape in (SHAPES[FAN](draw), SHAPES[FAN](draw))]
    source, target = flat[0], draw.choice((SHAPES[FAN](draw), flat[1]))
    return Shapes(source, target, FAN, ratio)


def _far(draw: Draw) -> Shapes:
    shapes = _generic(FAN, draw)
    away = [vector(draw, 0, 8, 2) for _ in range(2)]
    return replace(
        shapes, source=shapes.source + away[0], target=shapes.target + away[1], distance=float(np.linalg.norm(away[0]))
    )


def _huge_or_tiny(draw: Draw) -> Shapes:
    shapes = _generic(FAN, draw)
    exponent, ratio = draw.choice(range(-300, 301)), draw.choice(range(-20, 21))
    source, target = np.ldexp(shapes.source, exponent), np.ldexp(shapes.target, exponent + ratio)
    return replace(shapes, source=source, target=target, distance=2.0**exponent)


def _outside(draw: Draw) -> Shapes:
    """A triangle turned over in the target, or without area in one of both."""
    shapes = _generic(FAN, draw)
    kind = draw.choice(("turned over", "source", "target"))
    if kind == "turned over":
        return replace(shapes, target=shapes.target * np.array([1.0, draw.choice((-1.0, 0.0))]))
    flat = getattr(shapes, kind).copy()
    flat[1] = flat[2]
    return replace(shapes, **{kind: flat})


def _regime(name: str, build: Callable[[Draw], Shapes], distance: str, share: float = 0.2) -> Regime:
    def point(draw: Draw) -> Point:
        shapes = relabelled(draw, build(draw))
        return Point((shapes.source, shapes.target, np.array(shapes.triangles, dtype=np.float64)), shapes.distance)

    return Regime(name, point, distance, share)


GENERIC = _regime("generic", partial(_generic, FAN), "pi - angle")

REGIMES = (
    *timed(
        (
            GENERIC,
            _regime("wheel", partial(_generic, WHEEL), "pi - angle", share=0.1),
            _regime("strip", partial(_generic, STRIP), "pi - angle"),
            _regime("one-triangle", partial(_generic, TRIANGLE), "pi - angle"),
            _regime("near-identity", _near_identity, "distance of source and target"),
            _regime("large-rotation", _large_rotation, "pi - angle"),
            _regime("thin", _thin, "ratio of height and length"),
            _regime("tiny-next-to-huge", _far, "distance from the origin"),
            _regime("huge-or-tiny", _huge_or_tiny, "scale"),
            _regime("outside", _outside, "none"),
        )
    ),
    *(replace(regime, share=0.2) for regime in about_time(GENERIC)),
)
"""Source, target, triangles and t."""


def _with(more: Callable[[Draw, tuple[Array, ...]], tuple[Array, ...]]) -> tuple[Regime, ...]:
    """The regimes, with further inputs."""

    def extended(regime: Regime) -> Regime:
        def build(draw: Draw) -> Point:
            point = regime.build(draw)
            return Point((*point.inputs, *more(draw, point.inputs)), point.distance)

        return replace(regime, build=build)

    return tuple(map(extended, REGIMES))


def _balance(draw: Draw, inputs: tuple[Array, ...]) -> tuple[Array, ...]:
    """Weights of E^F in [0, 1], now and then at the ends."""
    return (np.array([draw.choice((0.0, 1.0, draw.uniform(0, 1), draw.uniform(0, 1))) for _ in inputs[2]]),)


def _locus(draw: Draw, inputs: tuple[Array, ...]) -> tuple[Array, ...]:
    """A place about where the last vertex is in source and target, and a weight."""
    source, target, _, t = inputs
    between = source[-1] + t * (target[-1] - source[-1])
    size = float(np.linalg.norm(source[-1] - source[0]))
    return between + 0.3 * size * draw.direction(2), scalar(draw.exponent(-3, 3))


def _map(
    name: str,
    definition: str,
    source: str,
    function: Callable[..., Any],
    cost: float,
    regimes: tuple[Regime, ...] = REGIMES,
    domain: str = "",
    more: tuple[Argument, ...] = (),
) -> Map:
    return Map(
        name=f"mesh2.{name}",
        definition=definition,
        source=source,
        domain="a mesh in one piece whose triangles keep their orientation and have an area; every t" + domain,
        arguments=(
            Argument("source", ("vertices", 2), (NORM,), "length"),
            Argument("target", ("vertices", 2), (NORM,), "length"),
            Argument("triangles", ("faces", 3), ()),
            TIME,
            *more,
        ),
        outputs=(("vertices", 2),),
        blocks=(Block("vertices", 0, WHOLE),),
        regimes=regimes,
        reference=function,
        accuracy=8.0,
        cost=cost,
        remark="Condition against perturbations of source and target as vectors of all coordinates, each relative to "
        "its length: a shape far from the origin counts with its distance. Where a triangle turns by pi exactly the "
        "map jumps, and the condition is beyond all bounds. Indices are exact.",
    )


AREA = "A_i(t) the exponential homotopy of triangle i, B_i the linear part of its map from source to v"
ENDS = "the first vertex moves linearly, and the last one about it as a similarity does (exponential homotopy)"

MAPS = (
    _map(
        "frobenius",
        f"the v that minimise E^F = sum of area_i |A_i(t) - B_i|_F^2; {AREA}; the first vertex moves linearly",
        "kaji_2d, section 4 (Alexa, Cohen-Or, Levin 2000)",
        reference.frobenius,
        12.0,
    ),
    _map(
        "points",
        "the v that minimise E^S = sum of area_i min over s, delta, d of sum_k |s R_delta A_i(t) p_k + d - v_k|^2, "
        f"over the corners k of triangle i; {ENDS}",
        "kaji_2d, section 4 (Werman and Weinshall 1995)",
        reference.points,
        20.0,
    ),
    _map(
        "similarity",
        f"the v that minimise E^R = sum of area_i min over s, delta of |s R_delta A_i(t) - B_i|_F^2; {AREA}; {ENDS}",
        "kaji_2d, section 4, equation 4",
        reference.similarity,
        16.0,
    ),
    _map(
        "balanced",
        f"the v that minimise the sum of area_i (w_i E_i^F + (1 - w_i) E_i^R), w the balance; {ENDS}",
        "kaji_2d, section 4, improvements",
        reference.balanced,
        18.0,
        _with(_balance),
        "; 0 <= w <= 1",
        (Argument("balance", ("faces",), (ENTRIES,), "1"),),
    ),
    _map(
        "constrained",
        "the v that minimise E^F + weight |v_last - place|^2; the first vertex moves linearly",
        "kaji_2d, section 4, loci",
        reference.constrained,
        12.0,
        _with(_locus),
        "; weight > 0",
        (Argument("place", (2,), (NORM,), "length"), Argument("weight", (), (ENTRIES,), "1")),
    ),
    _map(
        "symmetric",
        "the v that minimise E^F(t) from source to target plus E^F(1 - t) from target to source; the first vertex "
        "moves linearly",
        "kaji_2d, section 4, improvements (Baxter, Barla, Anjyo 2008)",
        reference.symmetric,
        18.0,
    ),
)
