"""Sparse equations of meshes: assembled triangle by triangle, factored once, and refined to double-double accuracy."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import SuperLU, splu

from affinecert.fast._kernel import Array
from affinecert.fast._triangulation import Indices
from affinecert.fast._wide import add, widen

# The size of a step, at the rate of the step before, foretells the next one: below this part of the solution it would
# not change the rounded result, but for a part of 2^-7 of all roundings.
ENOUGH = 2.0**-60
# Each step at least halves the error, or the equations count as singular: so these come from 1 to 2^-60.
MOST_STEPS = 60


@dataclass(frozen=True)
class Pattern:
    """Where the entries of a Hermitian matrix are, in compressed columns, and where each summand goes.

    ``places`` are those of the entries of the triangles' 3 x 3 blocks and then of single entries; ``kept`` tells the
    entries between vertices that are free, and ``given`` the places on the diagonal of the others.
    """

    columns: NDArray[np.intc]
    rows: NDArray[np.intc]
    places: Indices
    kept: NDArray[np.bool_]
    given: Indices

    def matrix(self, summands: NDArray[Any]) -> Any:
        """The matrix of the summands at the places, with rows and columns of the identity for what is given."""
        size = len(self.rows)
        entries = np.bincount(self.places, summands.real, size) + 1j * np.bincount(self.places, summands.imag, size)
        entries[~self.kept] = 0.0
        entries[self.given] = 1.0
        count = len(self.columns) - 1
        return sparse.csc_array((entries, self.rows, self.columns), (count, count))


def pattern(triangles: Indices, rows: Indices, columns: Indices, free: NDArray[np.bool_]) -> Pattern:
    """The pattern of triangles on vertices some of which are free, and of single entries in those rows and columns."""
    count = len(free)
    keys = np.concatenate(
        [
            (triangles[:, None, :] * count + triangles[:, :, None]).ravel(),
            columns * count + rows,
            np.arange(count) * (count + 1),
        ]
    )
    entries, places = np.unique(keys, return_inverse=True)
    column, row = np.divmod(entries, count)
    starts = np.searchsorted(column, np.arange(count + 1))
    diagonal = places[len(places) - count :]
    return Pattern(
        columns=starts.astype(np.intc),
        rows=row.astype(np.intc),
        places=places[: len(places) - count],
        kept=free[row] & free[column],
        given=diagonal[~free],
    )


def total(x: Array) -> Array:
    """The sum of pairs over the first axis."""
    while len(x) > 1:
        half = len(x) // 2
        x = np.concatenate([add(x[:half], x[half : 2 * half]), x[2 * half :]])
    return x[0]


def factored(matrix: Any) -> SuperLU | None:
    """The factors of a Hermitian positive definite matrix, pivots on the diagonal; None if it is singular."""
    try:
        return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    except RuntimeError:
        return None


def refined(start: Array, slope: Callable[[Array], Array], solve: Callable[[Array], Array]) -> Array | None:
    """The pairs x with slope(x) = 0, from a start, or None if the steps do not grow smaller.

    ``slope`` is of pairs, and linear; ``solve`` gives the float64 step that takes it to about 0.
    """
    x, last = start, np.inf
    for _ in range(MOST_STEPS):
        step = solve(slope(x)[..., 0])
        x = add(x, widen(step))
        size = np.max(np.abs(step), initial=0.0)
        if not size <= last / 2:
            return None
        if size * (size / last if np.isfinite(last) else 1.0) <= ENOUGH * np.max(np.abs(x[..., 0]), initial=0.0):
            return x
        last = size
    return None
