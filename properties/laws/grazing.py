"""Where a line on a moving surface grazes the envelope of what the surface sweeps."""

from __future__ import annotations

import numpy as np

from affinecert.map import Array
from affinecert.properties import strategies
from affinecert.properties.answer import rounded
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import Inexact, exact, precisely
from affinecert.properties.law import Law


def _orthogonal(maps: Maps, matrix: Array, point: Array, tangent: Array, normal: Array) -> float:
    parameter = ask(maps, "curves.grazing_parameter", matrix, point, tangent, normal).whole
    there = precisely(point) + parameter * precisely(tangent)
    velocity = ask(maps, "sam.velocity", matrix, rounded(there, "point"))["velocity"]
    across = precisely(normal) @ velocity
    return across.misfit(Inexact(exact(np.zeros(()))))


LAWS = (
    Law(
        name="grazing.curves",
        statement="the velocity at the grazing point is orthogonal to the normal: n . (log(L) (q + s t) + v) = 0",
        source="rossignac_vinacua, section 7.2; for s as equation 8 prints it, the statement is false",
        domain="A with a real logarithm, n . log(L) t other than zero; of the plane and of space",
        needs=("curves.grazing_parameter", "sam.velocity"),
        inputs=strategies.inputs("curves.grazing_parameter"),
        residual=_orthogonal,
    ),
)
