"""The pairs of poses on which the unsteadiness of morphs is compared, and the figure itself."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from affinecert.errors import InputError
from affinecert.map import Array
from affinecert.properties.matrix.domains import ALL, RIGID_POSES, SIMILARITIES, Domain
from affinecert.properties.matrix.motion import Ask

STEPS, PARTS = 50, 10
"""Bansal and Tatu take 50 poses; the grid is coarser than theirs, for the mean changes little by it."""


def _rigid(shift: tuple[float, float, float], i: int, j: int) -> Array:
    matrix = np.eye(4)
    matrix[i, i] = matrix[j, j] = 0.8
    matrix[j, i], matrix[i, j] = 0.6, -0.6
    matrix[:3, 3] = shift
    return matrix


FIRST, LAST = _rigid((0.0, 0.0, 0.0), 0, 1), _rigid((2.0, 1.0, 0.0), 1, 2)
GROWN = LAST * np.array([2.0, 2.0, 2.0, 1.0])

PAIRS: Mapping[Domain, tuple[Array, Array]] = {
    ALL: (
        np.array([[1.0, 0.25, 0.0], [0.0, 0.75, 0.0], [0.0, 0.0, 1.0]]),
        np.array([[0.0, -1.5, 2.0], [1.0, 0.5, 1.0], [0.0, 0.0, 1.0]]),
    ),
    SIMILARITIES: (FIRST, GROWN),
    RIGID_POSES: (FIRST, LAST),
}
"""For each domain that is some morph's own: a slanted triangle that turns by a quarter, is stretched and carried away,
as in figure 2 of Rossignac and Vinacua; and in space a turn about another axis, with growth or without."""


def unsteadiness(ask: Ask, domain: Domain) -> float | None:
    """The average relative acceleration between the standard poses of a domain; None where there is no morph."""
    # Numba takes as long to load as all else that a process needs to judge, and few get here.
    from affinecert.fast.measures import average_relative_acceleration, simplex_grid  # noqa: PLC0415

    start, end = PAIRS[domain]
    poses = np.array([ask(start[None], end[None], k / STEPS)[0] for k in range(STEPS + 1)])
    try:
        return float(average_relative_acceleration(poses, simplex_grid(len(start) - 1, PARTS)))
    except InputError:
        return None
