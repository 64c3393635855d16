"""A steady motion: T_t = T^t, so that equal times make equal steps and points move at a constant velocity."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import special, strategies
from affinecert.properties.answer import rounded
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import precisely
from affinecert.properties.law import Law


def _equal_steps(maps: Maps, matrix: Array, s: Array, t: Array) -> float:
    # The rounding of s + t changes a time relatively by u, which the sensitivity to it counts already.
    first, second, both = (
        ask(maps, "affine_lie.interpolate", matrix, np.asarray(time)).affine for time in (s, t, s + t)
    )
    return (first @ second).misfit(both)


def _constant_velocity(maps: Maps, matrix: Array, point: Array, time: Array) -> float:
    power = ask(maps, "sam.power", matrix, time).affine
    there = rounded(power(precisely(point)), "point")
    before, after = (ask(maps, "sam.velocity", matrix, place)["velocity"] for place in (point, there))
    return (power.linear @ before).misfit(after)


LAWS = (
    Law(
        name="steadiness.affine_lie",
        statement="T_s T_t = T_(s + t) where T is one of A, S and E alone, or A S",
        source="bansal_tatu, Lemma 1",
        domain="shears, scalings, rigid motions, and products of a shear and a scaling; all real s and t",
        needs=("affine_lie.interpolate",),
        inputs=st.tuples(special.one_component_maps(), strategies.times(), strategies.times()),
        residual=_equal_steps,
    ),
    Law(
        name="steadiness.sam",
        statement="the velocity at A^t p is L^t times that at p: it is constant in the moving frame",
        source="rossignac_vinacua, sections 2.3 (6) and 6.2",
        domain="A with a real logarithm, of the plane and of space; all p and all real t",
        needs=("sam.power", "sam.velocity"),
        inputs=st.tuples(strategies.inputs("sam.velocity"), strategies.times()).map(
            lambda drawn: (*drawn[0], drawn[1])
        ),
        residual=_constant_velocity,
    ),
)
