"""The catalogue of G_S, the uniform scales: exponential and logarithm."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from affinecert.catalogue.parts import ENTRIES, WHOLE
from affinecert.draw import Draw
from affinecert.map import Argument, Block, Map, Point, Regime
from affinecert.reference import scale as reference
from affinecert.sampling import scalar, signed


def _exponent(low: float, high: float) -> Callable[[Draw], Point]:
    """A log_scale of either sign and of size 10**e, e in [low, high]."""

    def build(draw: Draw) -> Point:
        log_scale = signed(draw, low, high)
        return Point((scalar(log_scale),), abs(log_scale))

    return build


def _near_one(draw: Draw) -> Point:
    steps = round(draw.exponent(0, 15)) * draw.choice((2.0**-52, -(2.0**-53)))
    return Point((scalar(1 + steps),), abs(steps))


def _scale(low: float, high: float) -> Callable[[Draw], Point]:
    """A scale of size 10**e, e in [low, high]."""

    def build(draw: Draw) -> Point:
        scale = draw.exponent(low, high)
        return Point((scalar(scale),), scale)

    return build


def _outside(draw: Draw) -> Point:
    size = draw.exponent(-300, 300)
    return Point((scalar(draw.choice((0.0, -size))),), size)


MAPS = (
    Map(
        name="scale.exp",
        definition="s = exp(log_scale)",
        source="bansal_tatu, A.2.5",
        domain="every real number",
        arguments=(Argument("log_scale", (), (ENTRIES,), "1"),),
        outputs=((),),
        blocks=(Block("scale", 0, WHOLE),),
        regimes=(
            Regime("generic", _exponent(-3, 1), "|log_scale|"),
            Regime("near-identity", _exponent(-16, -3), "|log_scale|"),
            Regime("tiny", _exponent(-300, -16), "|log_scale|"),
            Regime("huge", _exponent(1, float(np.log10(700.0))), "|log_scale|"),
        ),
        reference=reference.exp,
        inverse="scale.log",
        cost=0.6,
    ),
    Map(
        name="scale.log",
        definition="log s",
        source="bansal_tatu, A.2.5",
        domain="s > 0",
        arguments=(Argument("scale", (), (ENTRIES,), "1"),),
        outputs=((),),
        blocks=(Block("log_scale", 0, WHOLE),),
        regimes=(
            Regime("generic", _scale(-2, 2), "scale"),
            Regime("near-identity", _near_one, "|scale - 1|"),
            Regime("tiny", _scale(-300, -2), "scale"),
            Regime("huge", _scale(2, 300), "scale"),
            Regime("outside", _outside, "|scale|", share=0.25),
        ),
        reference=reference.log,
        inverse="scale.exp",
        cost=0.6,
    ),
)
