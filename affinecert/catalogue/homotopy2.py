"""The catalogue of homotopies from the identity to a linear map of the plane: linear, polar and exponential."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.catalogue.parts import NORM, TIME, WHOLE
from affinecert.catalogue.times import about_time, timed
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Map, Point, Regime
from affinecert.reference import homotopy2 as reference
from affinecert.sampling import any_rotation, signed, well_conditioned


def turn(cosine: float, sine: float) -> Array:
    """The rotation with that cosine and sine, (2, 2)."""
    return np.array([[cosine, -sine], [sine, cosine]])


def stretch(draw: Draw, ratio: float) -> Array:
    """A symmetric positive definite matrix whose eigenvalues have that ratio, exactly symmetric."""
    axes = any_rotation(draw, 2)
    larger = draw.uniform(0.5, 2.0)
    matrix = axes @ np.diag([larger, larger * ratio]) @ axes.T
    return np.array([[matrix[0, 0], matrix[0, 1]], [matrix[0, 1], matrix[1, 1]]])


def _generic(draw: Draw) -> Point:
    angle = draw.uniform(-3.0, 3.0)
    ratio = draw.uniform(0.25, 1.0)
    return Point((turn(math.cos(angle), math.sin(angle)) @ stretch(draw, ratio),), math.pi - abs(angle))


def _near_identity(draw: Draw) -> Point:
    gap = draw.exponent(-16, -0.5)
    return Point((np.eye(2) + gap * draw.direction(4).reshape(2, 2),), gap)


def _near_pi(draw: Draw) -> Point:
    gap = signed(draw, -16, 0)
    return Point((turn(-math.cos(gap), math.sin(gap)) @ stretch(draw, draw.uniform(0.25, 1.0)),), abs(gap))


def _at_pi(draw: Draw) -> Point:
    ratio = draw.exponent(-3, 0)
    return Point((-stretch(draw, ratio),), ratio)


def _no_rotation(draw: Draw) -> Point:
    ratio = draw.exponent(-3, 0)
    return Point((stretch(draw, ratio),), ratio)


def _similarity(draw: Draw) -> Point:
    """Two stretches that differ by little or by nothing."""
    gap = draw.choice((0.0, draw.exponent(-16, -1)))
    scale = draw.exponent(-3, 3)
    cosine, sine = scale * draw.direction(2)
    return Point((turn(cosine, sine) @ (np.eye(2) + gap * np.diag([1.0, -1.0])),), gap)


def _thin(draw: Draw) -> Point:
    ratio = draw.exponent(-12, -1)
    return Point((any_rotation(draw, 2) @ stretch(draw, ratio),), ratio)


def _huge_or_tiny(draw: Draw) -> Point:
    # A power of two scales without rounding; 2^400 is 3e120.
    exponent = draw.choice(range(-400, 401))
    return Point((np.ldexp(well_conditioned(draw, 2), exponent),), 2.0**exponent)


def _collapse(draw: Draw) -> Point:
    """The eigenvalues of S and a time at which the one of (1 - t) I + t S is nearly 0."""
    gap = draw.exponent(-16, 0)
    smaller = draw.uniform(0.1, 0.5)
    time = (1 - gap) / (1 - smaller)
    return Point((any_rotation(draw, 2) @ stretch(draw, smaller), np.array(time)), gap)


def _outside(draw: Draw) -> Point:
    matrix = well_conditioned(draw, 2)
    matrix[draw.choice((0, 1))] *= draw.choice((-1.0, 0.0))
    return Point((matrix,), 0.0)


GENERIC = Regime("generic", _generic, "pi - angle")
NEAR_IDENTITY = Regime("near-identity", _near_identity, "distance from the identity")
NEAR_PI = Regime("near-pi", _near_pi, "pi - angle")
AT_PI = Regime("at-pi", _at_pi, "ratio of the stretches")
NO_ROTATION = Regime("no-rotation", _no_rotation, "ratio of the stretches")
SIMILARITY = Regime("similarity", _similarity, "relative gap of the stretches")
THIN = Regime("thin", _thin, "ratio of the stretches")
HUGE_OR_TINY = Regime("huge-or-tiny", _huge_or_tiny, "scale")
COLLAPSE = Regime("collapse", _collapse, "smaller eigenvalue of (1 - t) I + t S")
OUTSIDE = Regime("outside", _outside, "none", share=0.25)

ABOUT_TIME = about_time(GENERIC)

ROTATIONS = (GENERIC, NEAR_IDENTITY, NEAR_PI, AT_PI, NO_ROTATION, SIMILARITY, THIN, HUGE_OR_TINY, OUTSIDE)
"""What a map that takes the rotation apart is tried on."""


def _homotopy(
    name: str,
    definition: str,
    source: str,
    domain: str,
    regimes: tuple[Regime, ...],
    function: Callable[..., Any],
    continuation: Callable[..., Any] | None,
    cost: float,
) -> Map:
    return Map(
        name=f"homotopy2.{name}",
        definition=definition,
        source=source,
        domain=domain,
        arguments=(Argument("linear", (2, 2), (NORM,), "1"), TIME),
        outputs=((2, 2),),
        blocks=(Block("linear", 0, WHOLE),),
        regimes=regimes,
        reference=function,
        continuation=continuation,
        accuracy=8.0,
        cost=cost,
    )


MAPS = (
    _homotopy(
        "linear",
        "A^L = (1 - t) I + t A",
        "kaji_2d, section 3",
        "every A and t",
        (*timed((GENERIC, NEAR_IDENTITY, HUGE_OR_TINY)), *ABOUT_TIME),
        reference.linear,
        None,
        0.2,
    ),
    _homotopy(
        "polar",
        "A^P = R_(t theta) ((1 - t) I + t S), A = R_theta S with theta in (-pi, pi] and S symmetric positive definite",
        "kaji_2d, section 3, equation 2",
        "det A > 0, every t",
        (*timed(ROTATIONS), *ABOUT_TIME, COLLAPSE),
        reference.polar,
        reference.continue_polar,
        1.0,
    ),
    _homotopy(
        "exponential",
        "A^E = R_(t theta) S^t, A = R_theta S with theta in (-pi, pi] and S symmetric positive definite",
        "kaji_2d, section 3, equation 3",
        "det A > 0, every t",
        (*timed(ROTATIONS), *ABOUT_TIME),
        reference.exponential,
        reference.continue_exponential,
        2.0,
    ),
)
