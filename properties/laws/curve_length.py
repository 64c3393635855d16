"""A curve of rotations is no shorter than the geodesic between its ends, and no longer than the line that makes it."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import CTX, exact, norm, ratio, real
from affinecert.properties.law import Law
from affinecert.reference import so3


def _residual(maps: Maps, first: Array, second: Array) -> float:
    length = ask(maps, "measures.rotation_curve_length", first, second)["length"]
    value, line = real(length.value.item()), norm(exact(second) - exact(first))
    ends = [so3.exp(CTX, np.vectorize(CTX.mpf, otypes=[object])(vector)) for vector in (first, second)]
    angle = so3.axis_angle(CTX, ends[0].T @ ends[1])[1]
    return max(ratio(value - line, length.error), ratio(angle - value, length.error))


REGIMES = ("generic", "nearly-equal", "parallel", "past-the-origin", "beyond-pi")
"""Those whose truth is quick: next to 2 pi the quadrature takes ten times as long."""

LAWS = (
    Law(
        name="curve_length.bounds",
        statement="exp [c]x, c from a to b in a line, is as long as the angle between its ends at least, and |b - a| "
        "at most",
        source="gallier, section 10, corrected: what is printed as the length is its upper bound",
        domain="all rotation vectors of at most 64 radians",
        needs=("measures.rotation_curve_length",),
        inputs=st.one_of([strategies.regime("measures.rotation_curve_length", name) for name in REGIMES]),
        residual=_residual,
    ),
)
