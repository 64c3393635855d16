"""The catalogue of SO(3): exponential, logarithm, and the logarithm nearest to a given vector."""

from __future__ import annotations

import math

import numpy as np

from affinecert.catalogue import turns
from affinecert.catalogue.parts import ENTRIES, NORM, WHOLE
from affinecert.draw import Draw
from affinecert.map import Argument, Array, Block, Map, Point, Regime
from affinecert.reference import so3 as reference
from affinecert.sampling import signed, vector

ROTATION = Argument("rotation", (3, 3), (ENTRIES,), "1", manifold="rotations")


def _outside(draw: Draw) -> Point:
    turn = turns.no_rotation(draw)
    return Point((turn.matrix,), turn.distance)


def _on_the_axis(draw: Draw, turn: turns.Turn) -> tuple[Array, Array]:
    """``near`` within 3 < pi of one of the logarithms along the axis, and anywhere across it."""
    along = 2 * math.pi * draw.choice(range(-3, 4)) + signed(draw, -8, math.log10(3))
    across = np.cross(turn.axis, draw.direction(3)) * draw.exponent(-3, 1)
    return turn.matrix, turn.vector + along * turn.axis + across


def _generic(draw: Draw) -> Point:
    turn = turns.GENERIC.build(draw)
    return Point((turn.matrix, vector(draw, -2, 1.5)), turn.distance)


def _principal(draw: Draw) -> Point:
    turn = draw.choice((turns.GENERIC, turns.NEAR_PI, turns.AT_PI)).build(draw)
    return Point((turn.matrix, np.zeros(3)), turn.distance)


def _identity(draw: Draw) -> Point:
    near = vector(draw, -8, 3)
    return Point((np.eye(3), near), float(np.linalg.norm(near)))


def _tie(draw: Draw) -> Point:
    turn = turns.GENERIC.build(draw)
    # Which side is nearer is decided by near . axis, told to about 1e-15: a tie closer than 1e-10 would be a guess.
    gap = signed(draw, -10, 0)
    halfway = (2 * draw.choice(range(-3, 3)) + 1) * math.pi
    return Point((turn.matrix, turn.vector + (halfway + gap) * turn.axis), abs(gap))


def _far(draw: Draw) -> Point:
    turn = draw.choice((turns.GENERIC, turns.NEAR_IDENTITY)).build(draw)
    near = vector(draw, 2, 8)
    return Point((turn.matrix, near), float(np.linalg.norm(near)))


MAPS = (
    Map(
        name="so3.exp",
        definition="R = exp([omega]x), the rotation by the angle |omega| about omega",
        source="bansal_tatu, A.2.1",
        domain="every omega in R^3",
        arguments=(Argument("omega", (3,), (NORM,), "radian"),),
        outputs=((3, 3),),
        blocks=(Block("rotation", 0, WHOLE),),
        regimes=turns.regimes(turns.VECTORS, lambda _, turn: (turn.vector,)),
        reference=reference.exp,
        inverse="so3.log",
    ),
    Map(
        name="so3.log",
        definition="the shortest omega with exp([omega]x) = R; at angle pi its first non-zero entry is positive",
        source="bansal_tatu, A.2.2",
        domain="R within 1e-6 of a rotation (|R^T R - I|_F, det R > 0); the nearest rotation counts",
        arguments=(ROTATION,),
        outputs=((3,),),
        blocks=(Block("rotation_vector", 0, WHOLE),),
        regimes=(
            *turns.regimes(turns.MATRICES, lambda _, turn: (turn.matrix,)),
            Regime("outside", _outside, "stretch", share=0.5),
        ),
        reference=reference.log,
        continuation=reference.continue_log,
        inverse="so3.exp",
        cost=2.5,
    ),
    Map(
        name="so3.log_near",
        definition="of all omega with exp([omega]x) = R the one nearest to `near`; the shorter one in a tie",
        source="gallier, section 5, strategy 2",
        domain="R as for so3.log; every `near` in R^3",
        arguments=(ROTATION, Argument("near", (3,), (NORM,), "radian")),
        outputs=((3,),),
        blocks=(Block("rotation_vector", 0, WHOLE),),
        regimes=(
            Regime("generic", _generic, "angle"),
            *turns.regimes((turns.NEAR_IDENTITY, turns.TINY, turns.NEAR_PI, turns.AT_PI), _on_the_axis),
            Regime("principal", _principal, "angle, pi - angle, or a component of the axis"),
            Regime("at-identity", _identity, "length of near"),
            Regime("near-tie", _tie, "distance from a tie"),
            Regime("huge-near", _far, "length of near"),
        ),
        reference=reference.log_near,
        continuation=reference.continue_log_near,
        cost=3.0,
    ),
)
