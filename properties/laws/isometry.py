"""An interpolation of a rigid motion is rigid all the way."""

from __future__ import annotations

from functools import partial

import numpy as np
from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import special, strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import precisely
from affinecert.properties.law import Law

STATEMENT = "if |T x - T y| = |x - y| for all x and y, then |T_t x - T_t y| = |x - y|"


def _residual(name: str, maps: Maps, pose: Array, time: Array) -> float:
    linear = ask(maps, name, pose, time).affine.linear
    return (linear.T @ linear).misfit(precisely(np.eye(len(linear.value))))


def _linear_residual(name: str, maps: Maps, pose: Array, time: Array) -> float:
    linear = ask(maps, name, pose[:-1, :-1], time).whole
    return (linear.T @ linear).misfit(precisely(np.eye(len(linear.value))))


def _homotopy(name: str, source: str) -> Law:
    return Law(
        name=f"isometry.{name}",
        statement=STATEMENT,
        source=source,
        domain="rotations of the plane, to within the rounding of their entries; all real t",
        needs=(name,),
        inputs=st.tuples(special.rigid_maps(2), strategies.times()),
        residual=partial(_linear_residual, name),
    )


LAWS = (
    Law(
        name="isometry.affine_lie",
        statement=STATEMENT,
        source="bansal_tatu, Lemma 4",
        domain="rigid motions, to within the rounding of their entries; all real t",
        needs=("affine_lie.interpolate",),
        inputs=st.tuples(special.rigid_maps(3), strategies.times()),
        residual=partial(_residual, "affine_lie.interpolate"),
    ),
    Law(
        name="isometry.sam",
        statement=STATEMENT,
        source="rossignac_vinacua, sections 2.3 (5) and 6.3.1",
        domain="rigid motions of the plane and of space, to within the rounding of their entries, that still have a "
        "real logarithm once rounded (by about pi they may have none); all real t",
        needs=("sam.power",),
        inputs=st.tuples(special.rigid_maps(2) | special.rigid_maps(3), strategies.times()),
        residual=partial(_residual, "sam.power"),
    ),
    _homotopy("homotopy2.polar", "kaji_2d, section 3, equation 2"),
    _homotopy("homotopy2.exponential", "kaji_2d, section 3, equation 3"),
)
