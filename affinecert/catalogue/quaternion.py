"""The catalogue of quaternions: interpolation along the shorter great arc."""

from __future__ import annotations

import math

import numpy as np

from affinecert.catalogue.parts import NORM, TIME, WHOLE
from affinecert.catalogue.times import about_time, timed
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Map, Point, Regime
from affinecert.reference import quaternion as reference
from affinecert.sampling import off_by_ulps, signed


def _turned(p: Array, axis: Array, angle: float) -> Array:
    """The quaternion product of p and (cos a, sin a axis): the unit quaternion at that angle from p, towards p axis."""
    w, x, y, z = p
    across = np.array([[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]]) @ axis
    return np.asarray(math.cos(angle) * p + math.sin(angle) * across)


def _at_angle(draw: Draw, angle: float) -> tuple[Array, Array]:
    p = draw.direction(4)
    return p, _turned(p, draw.direction(3), angle)


def _generic(draw: Draw) -> Point:
    angle = draw.uniform(0.0, math.pi)
    return Point(_at_angle(draw, angle), angle)


def _near_coincident(draw: Draw) -> Point:
    gap = draw.exponent(-16, 0)
    return Point(_at_angle(draw, gap), gap)


def _near_antipodal(draw: Draw) -> Point:
    gap = draw.exponent(-16, 0)
    p, q = _at_angle(draw, gap)
    return Point((p, -q), gap)


def _coincident(draw: Draw) -> Point:
    p = draw.direction(4)
    return Point((p, p.copy()), float(np.min(np.abs(p))))


def _antipodal(draw: Draw) -> Point:
    p = draw.direction(4)
    return Point((p, -p), float(np.min(np.abs(p))))


def _orthogonal(draw: Draw) -> Point:
    """P and p i, p j or p k, up to sign: their products cancel exactly, by pairs."""
    p = draw.choice((draw.direction(4), draw.choice(tuple(np.eye(4)))))
    order, signs = draw.choice(
        (((1, 0, 3, 2), (-1, 1, 1, -1)), ((2, 3, 0, 1), (-1, -1, 1, 1)), ((3, 2, 1, 0), (-1, 1, -1, 1)))
    )
    return Point((p, draw.choice((1.0, -1.0)) * np.array(signs) * p[list(order)]), float(np.min(np.abs(p))))


def _near_orthogonal(draw: Draw) -> Point:
    # Quaternions tell their inner product to an ulp or two; none nearer to 0 than 1e-12 is surely of its sign.
    gap = signed(draw, -12, 0)
    return Point(_at_angle(draw, math.pi / 2 + gap), abs(gap))


def _tiny_components(draw: Draw) -> Point:
    tiny = draw.exponent(-300, -8)
    p, q = (draw.direction(4) * np.array([draw.choice((1.0, tiny)) for _ in range(3)] + [1.0]) for _ in range(2))
    # By hypot, which no tiny component makes underflow; a last component of nearly 0 is replaced.
    p[3], q[3] = (component if abs(component) > 0.1 else 1.0 for component in (p[3], q[3]))
    return Point((p / math.hypot(*p), q / math.hypot(*q)), tiny)


def _off_by_ulps(draw: Draw) -> Point:
    angle = draw.choice((draw.uniform(0.0, math.pi), draw.exponent(-8, 0)))
    p, q = _at_angle(draw, angle)
    return Point((off_by_ulps(draw, p, 4), off_by_ulps(draw, q, 4)), angle)


def _off_unit(draw: Draw) -> Point:
    # A tenth within the 1e-6 that a length may differ from 1.
    noise = draw.exponent(-15, -6.05)
    p, q = _generic(draw).inputs
    return Point((p * (1 + draw.choice((noise, -noise))), q * (1 + draw.choice((noise, -noise)))), noise)


def _outside(draw: Draw) -> Point:
    stretch = draw.exponent(-5, 1)
    good, bad = _generic(draw).inputs
    bad = bad * draw.choice((1 + stretch, 1 / (1 + stretch), 0.0))
    return Point(draw.choice(((good, bad), (bad, good))), stretch)


GENERIC = Regime("generic", _generic, "angle")

MAPS = (
    Map(
        name="quaternion.slerp",
        definition="(sin((1 - t) a) p + sin(t a) q) / sin a, cos a = p . q; -q for q where p . q < 0",
        source="Shoemake 1985",
        domain="lengths within 1e-6 of 1, normalised first; every t",
        arguments=(Argument("start", (4,), (NORM,), "1"), Argument("end", (4,), (NORM,), "1"), TIME),
        outputs=((4,),),
        blocks=(Block("quaternion", 0, WHOLE),),
        regimes=(
            *timed(
                (
                    GENERIC,
                    Regime("near-coincident", _near_coincident, "angle"),
                    Regime("coincident", _coincident, "smallest component"),
                    Regime("near-antipodal", _near_antipodal, "pi - angle"),
                    Regime("antipodal", _antipodal, "smallest component"),
                    Regime("near-orthogonal", _near_orthogonal, "|angle - pi/2|"),
                    Regime("orthogonal", _orthogonal, "smallest component"),
                    Regime("tiny-components", _tiny_components, "tiny components"),
                    Regime("off-by-ulps", _off_by_ulps, "angle"),
                    Regime("off-unit", _off_unit, "distance of the lengths from 1"),
                    Regime("outside", _outside, "distance of a length from 1", share=0.5),
                )
            ),
            *about_time(GENERIC),
        ),
        reference=reference.slerp,
        continuation=reference.continue_slerp,
        accuracy=8.0,
        cost=1.5,
    ),
)
