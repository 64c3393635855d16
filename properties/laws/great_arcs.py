"""The shorter great arc between two quaternions is the same from both ends, and from every side.

Where p . q = 0 both arcs are the shorter one. In numbers of 400 bits, a = pi/2 between quaternions: at p . q = 1e-40
the law holds with a plus, at -1e-40 with a minus, either arc keeping it. But from p to q by the one arc and back by the
other it is broken by 2 cos(t a) or 2 sin(t a), and each call makes its choice by its own rounding. So nothing is asked
of the two together where the products of rounding have either sign; each of them has to answer all the same.
"""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import UNDECIDED, UNIT, Inexact, exact, norm, real
from affinecert.properties.law import Law, OutOfDomain

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


def _decided(start: Array, end: Array) -> None:
    """OutOfDomain if roundings of p and q, each by u of its length, may give p . q the other sign."""
    p, q = exact(start), exact(end)
    if abs(real(p @ q)) <= UNDECIDED * 2 * UNIT * norm(p) * norm(q):
        raise OutOfDomain("orthogonal, where either arc is the shorter")


def _backwards(maps: Maps, start: Array, end: Array, time: Array) -> float:
    # The rounding of 1 - t changes a time relatively by u, which the sensitivity to it counts already.
    there = ask(maps, "quaternion.slerp", start, end, time)["quaternion"]
    back = ask(maps, "quaternion.slerp", end, start, np.asarray(1.0 - time))["quaternion"]
    _decided(start, end)
    # From q to p goes to -p where that is nearer, at the end of the opposite arc.
    opposite = exact(start) @ exact(end) < 0
    return there.misfit(Inexact(-back.value, back.error) if opposite else back)


def _turned(maps: Maps, start: Array, end: Array, time: Array, unit: Array) -> float:
    there = ask(maps, "quaternion.slerp", start, end, time)["quaternion"]
    seen = ask(maps, "quaternion.slerp", unit @ start, unit @ end, time)["quaternion"]
    _decided(start, end)
    return Inexact(exact(unit) @ there.value, there.error).misfit(seen)


DOMAIN = "unit quaternions p and q, but where p . q is 0 to within rounding; all real t"

LAWS = (
    Law(
        name="great_arcs.reversibility",
        statement="the arc from p to q at t is the one from q to p at 1 - t, or opposite to it if p . q < 0",
        source="Shoemake 1985",
        domain=DOMAIN,
        needs=("quaternion.slerp",),
        inputs=strategies.inputs("quaternion.slerp"),
        residual=_backwards,
    ),
    Law(
        name="great_arcs.invariance",
        statement="the arc from u p to u q is u times the arc from p to q",
        source="Shoemake 1985",
        domain=f"{DOMAIN}; every unit quaternion u, here those with one component",
        needs=("quaternion.slerp",),
        inputs=st.tuples(strategies.inputs("quaternion.slerp"), st.sampled_from(BASIS)).map(
            lambda both: (*both[0], both[1])
        ),
        residual=_turned,
    ),
)
