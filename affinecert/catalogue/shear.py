"""The catalogue of G_A, the shears: exponential and logarithm, each parameter scored alone."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from affinecert.catalogue import shears
from affinecert.catalogue.parts import ENTRIES
from affinecert.catalogue.shears import Shears, assemble
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Group, Map, Point, Regime
from affinecert.reference import shear as reference

UPPER = np.s_[[0, 1, 0, 1, 2], [1, 1, 2, 2, 2]]
"""Where a shear keeps alpha_1, ..., alpha_5."""

SHEAR = Argument("shear", (3, 3), (Group(UPPER, "entries"),), "1")


def alpha_blocks(output: int) -> tuple[Block, ...]:
    """The five parameters of the shear that is output number ``output``."""
    places = enumerate(zip(*UPPER, strict=True), start=1)
    return tuple(Block(f"alpha_{number}", output, place) for number, place in places)


def _regimes(build: Callable[[Shears, Draw], tuple[Array, float]]) -> tuple[Regime, ...]:
    """A regime for each kind of shear, as twists or as matrices."""

    def regime(kind: Shears) -> Regime:
        def point(draw: Draw) -> Point:
            parameters, distance = build(kind, draw)
            return Point((parameters,), distance)

        return Regime(kind.name, point, kind.distance)

    return tuple(regime(kind) for kind in shears.ALL)


def _cancelling(f: Callable[[float], float], first: float, draw: Draw) -> tuple[Array, float]:
    """(a1, ..., a5) for which the two terms of corner a3 f[first, a5] + a1 a4 f[first, a2, a5] nearly cancel."""
    second, fifth = first + draw.uniform(0.5, 1.0), first - draw.uniform(0.3, 0.6)
    to_second = (f(second) - f(first)) / (second - first)
    to_fifth = (f(fifth) - f(first)) / (fifth - first)
    a1, a4, rest = draw.uniform(0.5, 2), draw.uniform(-2, -0.5), draw.exponent(-16, 0)
    corner = -a1 * a4 * (to_fifth - to_second) / (fifth - second) / to_fifth * (1 + rest)
    return np.array([a1, second, corner, a4, fifth]), rest


def _cancelling_exp(draw: Draw) -> Point:
    twist, rest = _cancelling(math.exp, 0.0, draw)
    return Point((twist,), rest)


def _cancelling_log(draw: Draw) -> Point:
    alpha, rest = _cancelling(math.log, 1.0, draw)
    return Point((assemble(alpha),), rest)


def _outside(draw: Draw) -> Point:
    matrix, _ = shears.matrix(shears.GENERIC, draw)
    size = draw.exponent(-16, 1)
    place = draw.choice((1, 2))
    matrix[place, place] = draw.choice((-size, 0.0))
    return Point((matrix,), size)


MAPS = (
    Map(
        name="shear.exp",
        definition="exp [[0, a1, a3], [0, a2, a4], [0, 0, a5]]",
        source="bansal_tatu, A.2.3",
        domain="every (a1, ..., a5)",
        arguments=(Argument("shear_twist", (5,), (ENTRIES,), "1"),),
        outputs=((3, 3),),
        blocks=alpha_blocks(0),
        regimes=(*_regimes(shears.twist), Regime("cancelling", _cancelling_exp, "what is left of alpha_3")),
        reference=reference.exp,
        inverse="shear.log",
        cost=1.2,
    ),
    Map(
        name="shear.log",
        definition="log [[1, alpha_1, alpha_3], [0, alpha_2, alpha_4], [0, 0, alpha_5]], as (a1, ..., a5)",
        source="bansal_tatu, A.2.4",
        domain="alpha_2 > 0 and alpha_5 > 0",
        arguments=(SHEAR,),
        outputs=((5,),),
        blocks=tuple(Block(f"alpha_{number}", 0, (number - 1,)) for number in range(1, 6)),
        regimes=(
            *_regimes(shears.matrix),
            Regime("cancelling", _cancelling_log, "what is left of alpha_3"),
            Regime("outside", _outside, "size of the entry that is not positive", share=0.25),
        ),
        reference=reference.log,
        inverse="shear.exp",
        cost=1.2,
    ),
)
