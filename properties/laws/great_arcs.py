"""The shorter great arc between two quaternions is the same from both ends, and from every side."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import Inexact, exact
from affinecert.properties.law import Law

BASIS = tuple(
    sign * np.array(matrix, dtype=np.float64)
    for sign in (1.0, -1.0)
    for matrix in (
        np.eye(4),
        [[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 0, -1], [0, 0, 1, 0]],
        [[0, 0, -1, 0], [0, 0, 0, 1], [1, 0, 0, 0], [0, -1, 0, 0]],
        [[0, 0, 0, -1], [0, 0, -1, 0], [0, 1, 0, 0], [1, 0, 0, 0]],
    )
)
"""What 1, i, j, k and their negatives take quaternions to, multiplied from the left."""


def _backwards(maps: Maps, start: Array, end: Array, time: Array) -> float:
    # The rounding of 1 - t changes a time relatively by u, which the sensitivity to it counts already.
    there = ask(maps, "quaternion.slerp", start, end, time)["quaternion"]
    back = ask(maps, "quaternion.slerp", end, start, np.asarray(1.0 - time))["quaternion"]
    # From q to p goes to -p where that is nearer, at the end of the opposite arc.
    opposite = exact(start) @ exact(end) < 0
    return there.misfit(Inexact(-back.value, back.error) if opposite else back)


def _turned(maps: Maps, start: Array, end: Array, time: Array, unit: Array) -> float:
    there = ask(maps, "quaternion.slerp", start, end, time)["quaternion"]
    seen = ask(maps, "quaternion.slerp", unit @ start, unit @ end, time)["quaternion"]
    return Inexact(exact(unit) @ there.value, there.error).misfit(seen)


LAWS = (
    Law(
        name="great_arcs.reversibility",
        statement="the arc from p to q at t is the one from q to p at 1 - t, or opposite to it if p . q < 0",
        source="Shoemake 1985",
        domain="unit quaternions, also at p . q = 0; all real t",
        needs=("quaternion.slerp",),
        inputs=strategies.inputs("quaternion.slerp"),
        residual=_backwards,
    ),
    Law(
        name="great_arcs.invariance",
        statement="the arc from u p to u q is u times the arc from p to q",
        source="Shoemake 1985",
        domain="unit quaternions p and q; every unit quaternion u, here those with one component; all real t",
        needs=("quaternion.slerp",),
        inputs=st.tuples(strategies.inputs("quaternion.slerp"), st.sampled_from(BASIS)).map(
            lambda both: (*both[0], both[1])
        ),
        residual=_turned,
    ),
)
