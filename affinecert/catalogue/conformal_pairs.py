"""Pairs of poses in space that are rigid, or similar, by the turn from one to the other."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from affinecert.catalogue import turns
from affinecert.catalogue.pose_pairs import Ends, Pair, placed
from affinecert.catalogue.turns import Turn, Turns
from affinecert.draw import Draw
from affinecert.map import Array
from affinecert.sampling import any_rotation, quarter_turns

Scale = Callable[[Draw], float]


def _apart_by(kind: Turns, scale: Scale, starts: tuple[Array, ...] = ()) -> Callable[[Draw, int], Ends]:
    """Poses apart by a turn of that kind, each of its own scale; the start is any, or one of ``starts``."""

    def build(draw: Draw, size: int) -> Ends:
        turn, start = kind.build(draw), draw.choice(starts) if starts else any_rotation(draw, size)
        return placed(draw, scale(draw) * start), placed(draw, scale(draw) * turn.matrix @ start), turn.distance

    return build


def _near_pi(draw: Draw) -> Turn:
    # Poses tell the angle between them to a few u; none closer to pi than 1e-12 is surely on its side of the jump.
    gap = draw.exponent(-12, 0)
    return turns.short_of_pi(draw.direction(3), gap, gap)


ANYWHERE = (
    turns.GENERIC,
    turns.NEAR_IDENTITY,
    turns.COORDINATE_AXIS,
    Turns("near-pi", "pi - angle", _near_pi),
    turns.OFF_MANIFOLD,
)
"""Turns from any pose."""

EXACT = (turns.AT_PI, turns.COORDINATE_AXIS_AT_PI)
"""Turns from poses of entries 0 and +-1, which keep the half turn exact."""


def _pairs(scale: Scale) -> tuple[Pair, ...]:
    return (
        *(Pair(kind.name, kind.distance, _apart_by(kind, scale)) for kind in ANYWHERE),
        *(Pair(kind.name, kind.distance, _apart_by(kind, scale, quarter_turns())) for kind in EXACT),
    )


def _not_rigid(draw: Draw, size: int) -> Ends:
    """One rigid pose, and one whose linear part is no rotation."""
    turn, start = turns.no_rotation(draw), any_rotation(draw, size)
    first, last = draw.choice(((start, turn.matrix), (turn.matrix, start)))
    return placed(draw, first), placed(draw, last), turn.distance


def _not_similar(draw: Draw, size: int) -> Ends:
    """One pose that is a similarity, and one stretched in a direction, or reflected."""
    stretch, start, bad = draw.exponent(-5, 1), any_rotation(draw, size), any_rotation(draw, size)
    bad = bad * np.array(draw.choice(((1 + stretch, 1.0, 1.0), (1.0, 1.0, -1.0))))
    first, last = draw.choice(((start, bad), (bad, start)))
    return placed(draw, draw.exponent(-3, 3) * first), placed(draw, draw.exponent(-3, 3) * last), stretch


RIGID = (*_pairs(lambda draw: 1.0), Pair("outside", "stretch", _not_rigid, share=0.5))
SIMILAR = (*_pairs(lambda draw: draw.exponent(-3, 3)), Pair("outside", "stretch", _not_similar, share=0.5))
