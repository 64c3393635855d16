"""The catalogue of spliced cubic splines: through points, and through similarities by their logarithms."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from affinecert.catalogue.journeys import CROSSINGS, JOURNEYS, OUTSIDE, THROUGH_PI, Journeys
from affinecert.catalogue.parts import ENTRIES, LINEAR_BLOCKS, TIME, WHOLE
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Group, Map, Point, Regime
from affinecert.reference import splines as reference
from affinecert.sampling import scalar, signed

Lengths = tuple[int, ...]

Time = Callable[[Draw, float], tuple[float, float]]
"""A time, and its distance to what is difficult, given the time of the last knot."""


@dataclass(frozen=True)
class Segments:
    """What a regime draws its points from: ``lengths`` are numbers of points of segments, all with one sum."""

    name: str
    distance: str
    lengths: tuple[Lengths, ...]
    points: Callable[[Draw, Lengths, int], tuple[Array, float]]
    dims: int = 3
    share: float = 0.5

    def build(self, draw: Draw) -> tuple[Array, Array, float]:
        """The points, the lengths and the distance to what is difficult."""
        lengths = draw.choice(self.lengths)
        points, distance = self.points(draw, lengths, self.dims)
        return points, np.array(lengths, dtype=np.float64), distance


def _cloud(draw: Draw, lengths: Lengths, dims: int) -> tuple[Array, float]:
    size = draw.exponent(-3, 3)
    return size * np.array([[draw.uniform(-1.0, 1.0) for _ in range(dims)] for _ in range(sum(lengths))]), size


def _jumps(draw: Draw, lengths: Lengths, dims: int) -> tuple[Array, float]:
    """Segments that are small next to the jumps between them."""
    points, size = _cloud(draw, lengths, dims)
    ratio = draw.exponent(-15, -1)
    places = size / ratio * np.stack([draw.direction(dims) for _ in lengths])
    return points + np.repeat(places, lengths, axis=0), ratio


def _close(draw: Draw, lengths: Lengths, dims: int) -> tuple[Array, float]:
    """Points that differ by little."""
    points, size = _cloud(draw, lengths, dims)
    ratio = draw.exponent(-15, -1)
    return points + size / ratio * draw.direction(dims), ratio


def _equal(draw: Draw, lengths: Lengths, dims: int) -> tuple[Array, float]:
    """Two points, in any order."""
    points, size = _cloud(draw, lengths, dims)
    return points[[draw.choice((0, 1)) for _ in points]], size


def _different_sizes(draw: Draw, lengths: Lengths, dims: int) -> tuple[Array, float]:
    points, _ = _cloud(draw, lengths, dims)
    sizes = np.array([signed(draw, -60, 60) for _ in points])
    return points * sizes[:, None], float(np.min(np.abs(sizes)) / np.max(np.abs(sizes)))


def _huge_or_tiny(draw: Draw, lengths: Lengths, dims: int) -> tuple[Array, float]:
    points, size = _cloud(draw, lengths, dims)
    factor = draw.choice((draw.exponent(100, 280), draw.exponent(-280, -100)))
    return points / size * factor, factor


KINDS = (
    Segments("generic", "size", ((4, 4), (3, 5), (5, 3)), _cloud),
    Segments("one-segment", "size", ((6,),), _cloud),
    Segments("threes", "size", ((3, 3, 4), (3, 4, 3), (4, 3, 3)), _cloud, dims=2),
    Segments("nothing-but-threes", "size", ((3, 3, 3, 3),), _cloud, dims=1),
    Segments("twos", "size", ((2, 2, 4), (2, 4, 2), (4, 2, 2)), _cloud, dims=2),
    Segments("jumps", "size of the segments over the jumps", ((4, 3, 4), (3, 4, 4)), _jumps, dims=2),
    Segments("close-points", "distances over size", ((4, 5), (3, 6)), _close, dims=2),
    Segments("equal-points", "size", ((5, 4), (4, 5)), _equal),
    Segments("different-sizes", "least size over largest", ((4, 3), (3, 4)), _different_sizes, dims=2),
    Segments("huge-or-tiny", "size", ((5, 3), (3, 5)), _huge_or_tiny, dims=2),
)


def _inside(draw: Draw, last: float) -> tuple[float, float]:
    t = draw.uniform(0.0, last)
    return t, abs(t - round(t))


def _beyond(draw: Draw, last: float) -> tuple[float, float]:
    gap = draw.exponent(-3, 1)
    return draw.choice((-gap, last + gap)), gap


def _near_knots(draw: Draw, last: float) -> tuple[float, float]:
    gap = draw.exponent(-16, -1)
    return draw.choice(range(int(last) + 1)) + draw.choice((1.0, -1.0)) * gap, gap


def _at_knots(draw: Draw, last: float) -> tuple[float, float]:
    return float(draw.choice(range(int(last) + 1))), 0.0


def _behind_the_junction(draw: Draw, _: float) -> tuple[float, float]:
    """A time on the span where a smooth motion differs from the printed one, of poses like `THROUGH_PI`."""
    gap = draw.uniform(0.0, 1.0)
    return 2.0 + gap, gap


ABOUT_TIME: tuple[tuple[str, str, Time], ...] = (
    ("extrapolation", "distance of t from the knots", _beyond),
    ("near-knots", "distance of t from a knot", _near_knots),
    ("at-knots", "none", _at_knots),
)
"""Regimes about the time: name, distance, and how the time is drawn."""


def _last_knot(lengths: Array) -> float:
    return float(np.sum(np.maximum(lengths, 3.0) - 1.0))


def _of_points(kind: Segments) -> Regime:
    def build(draw: Draw) -> Point:
        points, lengths, distance = kind.build(draw)
        return Point((points, lengths), distance)

    return Regime(kind.name, build, kind.distance, kind.share)


def _of_points_and_time(kind: Segments, time: Time = _inside) -> Regime:
    def build(draw: Draw) -> Point:
        points, lengths, distance = kind.build(draw)
        t, gap = time(draw, _last_knot(lengths))
        return Point((points, lengths, scalar(t)), distance if time is _inside else gap)

    return Regime(kind.name, build, kind.distance, kind.share)


def _of_journeys(kind: Journeys, time: Time = _inside) -> Regime:
    def build(draw: Draw) -> Point:
        journey = kind.build(draw)
        t, gap = time(draw, journey.duration)
        return Point((journey.poses, scalar(t)), journey.distance if time is _inside else gap)

    return Regime(kind.name, build, kind.distance, kind.share)


BAD_LENGTHS = ((3.0, 6.0), (2.5, 5.5), (1.0, 7.0), (-3.0, 11.0), (0.0, 8.0))
"""Of 8 points: numbers of another sum, broken, and too small."""


def _outside(draw: Draw) -> Point:
    points, size = _cloud(draw, (8,), 2)
    return Point((points, np.array(draw.choice(BAD_LENGTHS))), size)


def _outside_with_time(draw: Draw) -> Point:
    point = _outside(draw)
    return Point((*point.inputs, scalar(draw.uniform(0.0, 6.0))), point.distance)


POINTS = Argument("points", ("points", "dims"), (ENTRIES,), "length")
LENGTHS = Argument("lengths", ("segments",), (), "1")
POSES = Argument("poses", ("keys", 4, 4), (Group(np.s_[:, :-1], "entries"),), "1, length")

LENGTHS_DOMAIN = "whole numbers from 2 on whose sum is the number of points"
POSES_DOMAIN = (
    "two poses or more, each, divided by the cube root of its determinant, within 1e-6 of a rotation, the nearest one "
    "counts; last rows 0 0 0 1; any real t"
)

MOTION_REMARK = (
    "Every entry of every pose is perturbed by a fraction of itself. Where two rotation vectors are equally near, or a "
    "pose is a half turn, the choice of logarithms jumps; the condition is that of the choice taken. At a junction the "
    "printed motion is not differentiable; the condition is that of times behind it."
)

ABOUT_JUNCTIONS = tuple(
    _of_journeys(replace(THROUGH_PI, name=name, distance=distance, share=0.2), time)
    for name, distance, time in (
        *ABOUT_TIME,
        ("behind-a-junction", "distance of t from the junction", _behind_the_junction),
    )
)
OUTSIDE_REGIME = _of_journeys(OUTSIDE)

MAPS = (
    Map(
        name="splines.de_boor",
        definition="the de Boor points d of the spliced cubic spline through points: continuous first and second "
        "derivatives, at junctions too, and second derivatives 0 at both ends",
        source="gallier, section 8",
        domain=LENGTHS_DOMAIN,
        arguments=(POINTS, LENGTHS),
        outputs=(("controls", "dims"),),
        blocks=(Block("controls", 0, WHOLE),),
        regimes=(*(_of_points(kind) for kind in KINDS), Regime("outside", _outside, "size", share=0.25)),
        reference=reference.de_boor,
        accuracy=8.0,
        cost=8.0,
    ),
    Map(
        name="splines.evaluate",
        definition="the spliced cubic spline through points at the time t, knots at the whole numbers; the later "
        "segment counts at a junction",
        source="gallier, section 8",
        domain=f"{LENGTHS_DOMAIN}; any real t",
        arguments=(POINTS, LENGTHS, TIME),
        outputs=(("dims",),),
        blocks=(Block("point", 0, WHOLE),),
        regimes=(
            *(_of_points_and_time(kind) for kind in KINDS),
            *(
                _of_points_and_time(replace(KINDS[0], name=name, distance=distance), time)
                for name, distance, time in ABOUT_TIME
            ),
            Regime("outside", _outside_with_time, "size", share=0.25),
        ),
        reference=reference.evaluate,
        accuracy=8.0,
        cost=3.0,
    ),
    Map(
        name="splines.motion",
        definition="e^c(t), c the spliced spline through the logarithms of the poses that strategy 1 selects",
        source="gallier, sections 5 and 8",
        domain=POSES_DOMAIN,
        arguments=(POSES, TIME),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=(*(_of_journeys(kind) for kind in JOURNEYS), *ABOUT_JUNCTIONS, OUTSIDE_REGIME),
        reference=reference.motion,
        continuation=reference.continue_motion,
        accuracy=8.0,
        cost=40.0,
        remark=MOTION_REMARK,
    ),
    Map(
        name="splines.smooth_motion",
        definition="splines.motion, but for the first span after a junction, where a quintic in the logarithms makes "
        "the velocity and the acceleration on the group continuous",
        source="gallier, sections 5 and 8, mended at the junctions",
        domain=POSES_DOMAIN,
        arguments=(POSES, TIME),
        outputs=((4, 4),),
        blocks=LINEAR_BLOCKS,
        regimes=(*(_of_journeys(kind) for kind in CROSSINGS), *ABOUT_JUNCTIONS, OUTSIDE_REGIME),
        reference=reference.smooth_motion,
        continuation=reference.continue_smooth_motion,
        accuracy=8.0,
        cost=50.0,
        remark=MOTION_REMARK,
    ),
)
