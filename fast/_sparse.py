"""Sparse equations of meshes: assembled triangle by triangle, factored once, and refined to double-double accuracy."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import SuperLU, splu
from threadpoolctl import ThreadpoolController

from affinecert.fast._kernel import Array
from affinecert.fast._triangulation import Indices
from affinecert.fast._wide import add, divide, subtract, times, widen

# What is missing of a solution is about the next step: below this part of it, it would not change the rounded result
# but for a part of 2^-7 of all roundings.
ENOUGH = 2.0**-60
# Where equations are so ill-conditioned that the pairs' own rounding keeps steps larger, these may end here: their
# condition makes more of a rounding of the input.
SETTLED = 2.0**-50
# Exact factors ask for steps of their own length. Steps that should be so many times as long are along directions in
# which nothing resists.
FLAT = 2.0**40
# Two to four steps are usual, twenty where equations are singular but for the last bits.
MOST_STEPS = 60

# Eight units of rounding are added to the diagonal, relative to it: factors then are positive definite, as conjugate
# gradients need them, though rounding may have made the matrix indefinite.
RAISED = 1.0 + 2.0**-50


@dataclass(frozen=True)
class Pattern:
    """Where the entries of a Hermitian matrix are, in compressed columns, and where each summand goes.

    ``places`` are those of the entries of the triangles' 3 x 3 blocks and then of single entries; ``kept`` tells the
    entries between vertices that are free, ``diagonal`` the places on the diagonal, ``given`` those of the others.
    """

    columns: NDArray[np.intc]
    rows: NDArray[np.intc]
    places: Indices
    kept: NDArray[np.bool_]
    diagonal: Indices
    given: Indices

    def matrix(self, summands: NDArray[Any]) -> Any:
        """The matrix of the summands at the places, with rows and columns of the identity for what is given.

        It is raised on the diagonal by so little that only a matrix that is nearly singular is changed.
        """
        size = len(self.rows)
        entries: NDArray[Any] = np.bincount(self.places, summands.real, size)
        if np.iscomplexobj(summands):
            entries = entries + 1j * np.bincount(self.places, summands.imag, size)
        entries[self.diagonal] *= RAISED
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
        diagonal=diagonal,
        given=diagonal[~free],
    )


def total(x: Array) -> Array:
    """The sum of pairs over the first axis."""
    while len(x) > 1:
        half = len(x) // 2
        x = np.concatenate([add(x[:half], x[half : 2 * half]), x[2 * half :]])
    result: Array = x[0]
    return result


def mean(x: Array) -> Array:
    """The mean of pairs over the first axis."""
    return divide(total(x), widen(np.array(float(len(x)))))


@cache
def _libraries() -> ThreadpoolController:
    """The libraries that have been loaded; it takes milliseconds to find them."""
    return ThreadpoolController()


def without_threads_of_blas() -> AbstractContextManager[Any]:
    """Holds BLAS to one thread: more only get into each other's way on the narrow blocks of sparse factors.

    Two threads take twice the processor time of one on two idle processors, and up to ten times on busy ones.
    """
    held: AbstractContextManager[Any] = _libraries().limit(limits=1, user_api="blas")
    return held


def factored(matrix: Any) -> SuperLU | None:
    """The factors of a Hermitian positive definite matrix, pivots on the diagonal; None if it is singular.

    Column by column: meshes of the plane leave too few rows for panels of several to pay (15 % slower).
    """
    kept = {"SymmetricMode": True}
    try:
        return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, panel_size=1, options=kept)
    except RuntimeError:
        return None


def refined(start: Array, slope: Callable[[Array], Array], solve: Callable[[Array], Array]) -> Array | None:
    """The pairs x with slope(x) = 0, from a start, by conjugate gradients; None if they do not come to an end.

    ``slope`` is of pairs, linear, symmetric and negative definite; ``solve`` gives in float64 about the step that takes
    it to 0. Were it exact, this were a single step; as it is, each one brings as many digits as the equations leave it,
    and where that is none in a few directions, conjugate gradients still find these.
    """
    x, rest = start, slope(start)
    step = way = solve(rest[..., 0])
    work, settled = np.sum(rest[..., 0] * step), False
    for _ in range(MOST_STEPS):
        change = subtract(rest, slope(add(x, widen(way))))
        resistance = np.sum(way * change[..., 0])
        if not work <= FLAT * resistance or work == 0.0:
            return x if settled or not rest.any() else None
        length = work / resistance
        x, rest = add(x, times(widen(way), length)), subtract(rest, times(change, length))
        step = solve(rest[..., 0])
        missing, size = np.max(np.abs(step)), np.max(np.abs(x[..., 0]))
        if missing <= ENOUGH * size:
            return x
        settled = missing <= SETTLED * size
        before, work = work, np.sum(rest[..., 0] * step)
        way = step + work / before * way
    return x if settled else None
