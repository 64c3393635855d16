"""The catalogue of measures: unsteadiness, volumes and their loss, deviation of orderings, length in SO(3)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import replace

import numpy as np

from affinecert.catalogue import paths, tetrahedra, turns
from affinecert.catalogue.parts import ENTRIES, NORM, WHOLE
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Group, Map, Point, Regime
from affinecert.reference import measures as reference
from affinecert.sampling import signed

POSES = Argument("poses", ("poses", "n", "n"), (Group(np.s_[:, :-1, :-1]), Group(np.s_[:, :-1, -1])), "1, length")

BY_NORM = "the condition is that against the linear parts of all poses as one vector, and their translations as another"


def _alone(_: Draw, poses: Array) -> tuple[Array, ...]:
    return (poses,)


def _with_points(draw: Draw, poses: Array) -> tuple[Array, ...]:
    size = poses.shape[-1] - 1
    points = np.array([draw.exponent(-1, 1) * draw.direction(size) for _ in range(size)])
    return poses, points


def _vectors(name: str, distance: str, build: Callable[[Draw], tuple[Array, Array, float]], share: float) -> Regime:
    def point(draw: Draw) -> Point:
        first, second, gap = build(draw)
        return Point((first, second), gap)

    return Regime(name, point, distance, share)


def _any_two(draw: Draw) -> tuple[Array, Array, float]:
    first, second = turns.GENERIC.build(draw).vector, turns.GENERIC.build(draw).vector
    return first, second, float(np.linalg.norm(second - first))


def _small(draw: Draw) -> tuple[Array, Array, float]:
    size = draw.exponent(-30, -1)
    return size * draw.direction(3), size * draw.direction(3), size


def _nearly_equal(draw: Draw) -> tuple[Array, Array, float]:
    first, gap = turns.GENERIC.build(draw).vector, draw.exponent(-15, -1)
    return first, first + gap * draw.direction(3), gap


def _parallel(draw: Draw) -> tuple[Array, Array, float]:
    axis = draw.direction(3)
    first, second = draw.uniform(-math.pi, math.pi), draw.uniform(-math.pi, math.pi)
    return first * axis, second * axis, abs(second - first)


def _past_the_origin(draw: Draw) -> tuple[Array, Array, float]:
    first, gap = turns.GENERIC.build(draw).vector, draw.exponent(-15, -1)
    return first, -draw.uniform(0.1, 1.0) * first + gap * draw.direction(3), gap


def _near_two_pi(draw: Draw) -> tuple[Array, Array, float]:
    """A line that touches the sphere of vectors of length 2 pi, whose rotations are all the identity, but for a gap."""
    gap = signed(draw, -15, 0)
    nearest = draw.direction(3)
    along = np.cross(nearest, draw.direction(3))
    middle = (2 * math.pi + gap) * nearest
    return middle - draw.uniform(0.0, 2.0) * along, middle + draw.uniform(0.0, 2.0) * along, abs(gap)


def _beyond_pi(draw: Draw) -> tuple[Array, Array, float]:
    first, second = (draw.uniform(math.pi, 9.0) * draw.direction(3) for _ in range(2))
    return first, second, float(np.linalg.norm(second - first))


def _too_long(draw: Draw) -> tuple[Array, Array, float]:
    beyond = draw.exponent(-12, 8)
    long, short = (reference.LONGEST + beyond) * draw.direction(3) * (1 + 1e-14), draw.direction(3)
    first, second = draw.choice(((long, short), (short, long)))
    return first, second, beyond


def _timed(regimes: Iterable[Regime]) -> tuple[Regime, ...]:
    """The regimes, one case of each, with one time in [0, 1] after their inputs."""

    def timed(regime: Regime) -> Regime:
        def build(draw: Draw) -> Point:
            point = regime.build(draw)
            return Point((*point.inputs, np.array([draw.uniform(0.0, 1.0)])), point.distance)

        return replace(regime, build=build, share=0.05)

    return tuple(timed(regime) for regime in regimes)


def _vertices(name: str) -> Argument:
    return Argument(name, (4, 3), (ENTRIES,), "length")


MAPS = (
    Map(
        name="measures.average_relative_acceleration",
        definition="mean over points x and i of |k^2 (M_i^-1 M_(i+1) - M_(i-1)^-1 M_i) x|, poses M_0, ..., M_k",
        source="rossignac_vinacua, sections 1 and 2.4; bansal_tatu, section 6.1",
        domain="at least three poses of positive determinant, last rows 0 ... 0 1; at least one point",
        arguments=(POSES, Argument("points", ("points", "n-1"), (NORM,), "length")),
        outputs=((),),
        blocks=(Block("acceleration", 0, WHOLE),),
        regimes=paths.regimes(
            (
                paths.GENERIC,
                paths.SMOOTH,
                paths.STEADY,
                paths.EXACTLY_STEADY,
                paths.FAR,
                paths.THIN,
                paths.OUTSIDE,
            ),
            3,
            _with_points,
            0.25,
        ),
        reference=reference.average_relative_acceleration,
        accuracy=8.0,
        cost=4.0,
        remark=BY_NORM,
    ),
    Map(
        name="measures.volume",
        definition="det L_i of each pose of a path",
        source="rossignac_vinacua, section 6.4; bansal_tatu, Lemma 3",
        domain="last rows 0 ... 0 1",
        arguments=(POSES,),
        outputs=(("poses",),),
        blocks=(Block("volume", 0, WHOLE),),
        regimes=paths.regimes(
            (paths.GENERIC, paths.FLAT, paths.NEARLY_FLAT, paths.INSIDE_OUT, paths.HUGE_OR_TINY, paths.NO_POSES),
            3,
            _alone,
            0.25,
        ),
        reference=reference.volume,
        accuracy=8.0,
        cost=0.5,
        remark=BY_NORM,
    ),
    Map(
        name="measures.degeneracy",
        definition="1 - min over i of det L_i / min(det L_0, det L_k): 0 if no volume is lost, 1 where all is",
        source="rossignac_vinacua, section 6.4",
        domain="ends of positive determinant, last rows 0 ... 0 1",
        arguments=(POSES,),
        outputs=((),),
        blocks=(Block("degeneracy", 0, WHOLE),),
        regimes=paths.regimes(
            (paths.GENERIC, paths.FLAT, paths.NEARLY_FLAT, paths.INSIDE_OUT, paths.NO_LOSS, paths.OUTSIDE),
            3,
            _alone,
            0.25,
        ),
        reference=reference.degeneracy,
        accuracy=8.0,
        cost=0.5,
        remark=BY_NORM,
    ),
    Map(
        name="measures.path_deviation",
        definition="maximum and median, over pairs of the 12 orderings, of max over t of |T_t - T'_t|, homogeneous",
        source="bansal_tatu, section 5.2.2",
        domain="both tetrahedra of positive volume, right-handed; at least one time",
        arguments=(_vertices("source"), _vertices("target"), Argument("times", ("times",), (ENTRIES,), "1")),
        outputs=((2,),),
        blocks=(Block("deviation", 0, WHOLE),),
        # The truth of one case takes some 400 interpolations a time.
        regimes=_timed(
            (
                tetrahedra.GENERIC,
                tetrahedra.RIGID,
                tetrahedra.NEAR_IDENTITY,
                tetrahedra.THIN,
                tetrahedra.OUTSIDE,
            )
        ),
        reference=reference.path_deviation,
        accuracy=8.0,
        cost=330.0,
        remark="far from angle pi of the aligned tetrahedra's relative rotation, where the interpolations jump",
    ),
    Map(
        name="measures.rotation_curve_length",
        definition="integral over s in [0, 1] of |dexp_c (b - a)|, c = (1 - s) a + s b: the length of exp [c]x",
        source="gallier, section 10, whose |b - a| holds for parallel a and b only",
        domain="both vectors of at most 64 radians",
        arguments=(Argument("first", (3,), (NORM,), "radian"), Argument("second", (3,), (NORM,), "radian")),
        outputs=((),),
        blocks=(Block("length", 0, WHOLE),),
        regimes=(
            _vectors("generic", "difference of the vectors", _any_two, 0.3),
            _vectors("near-identity", "length of the vectors", _small, 0.2),
            _vectors("nearly-equal", "difference of the vectors", _nearly_equal, 0.2),
            _vectors("parallel", "difference of the vectors", _parallel, 0.2),
            _vectors("past-the-origin", "distance of the line from 0", _past_the_origin, 0.2),
            _vectors("near-two-pi", "distance of the line from 2 pi", _near_two_pi, 0.1),
            _vectors("beyond-pi", "difference of the vectors", _beyond_pi, 0.2),
            _vectors("outside", "excess of the length", _too_long, 0.25),
        ),
        reference=reference.rotation_curve_length,
        accuracy=8.0,
        cost=30.0,
    ),
)
