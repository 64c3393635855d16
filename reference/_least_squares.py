"""Minimisers of sums of squares: the normal equations, assembled term by term and solved by elimination."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from affinecert.reference._matrices import Array, Context, Number, array
from affinecert.reference._precision import negligible


class Square(NamedTuple):
    """The term weight (sum of coefficient x_index - goal)^2 of a sum of squares."""

    weight: Number
    terms: Sequence[tuple[int, Number]]
    goal: Number


def minimiser(ctx: Context, squares: Iterable[Square], size: int, known: Mapping[int, Number]) -> Array | None:
    """The one x, (size,), that makes a sum of squares least, where some of its entries are given; None if not unique.

    The normal equations are eliminated from the last unknown to the first, zeros left out: unknowns that only few
    squares share belong to the end. Goals and given entries may be vectors, for sums of squares that differ in them
    only; they stand on the left of products, where an mpf would first look for a number in them.
    """
    rows, right = _normal_equations(ctx, squares, size, known)
    unknown = [i for i in range(size) if i not in known]
    scale = {k: rows[k].get(k, ctx.zero) for k in unknown}
    for k in reversed(unknown):
        if negligible(ctx, rows[k].get(k, ctx.zero), scale[k]):
            return None
        _eliminate(ctx, rows, right, k)
    x = dict(known)
    for k in unknown:
        rest = right[k]
        for j, entry in _before(rows[k], k):
            rest = rest - x[j] * entry
        x[k] = rest / rows[k][k]
    return array([x[k] for k in range(size)])


def _normal_equations(
    ctx: Context, squares: Iterable[Square], size: int, known: Mapping[int, Number]
) -> tuple[list[dict[int, Number]], list[Number]]:
    """The lower triangle of the matrix, a dictionary a row, and the right side."""
    rows: list[dict[int, Number]] = [{} for _ in range(size)]
    right: list[Number] = [None] * size
    for weight, terms, goal in squares:
        rest = goal
        for i, c in terms:
            if i in known:
                rest = rest - known[i] * c
        free = [(i, c) for i, c in terms if i not in known]
        for i, c in free:
            weighted = weight * c
            right[i] = rest * weighted if right[i] is None else right[i] + rest * weighted
            for j, other in free:
                if j <= i:
                    rows[i][j] = rows[i].get(j, ctx.zero) + weighted * other
    return rows, right


def _eliminate(ctx: Context, rows: list[dict[int, Number]], right: list[Number], k: int) -> None:
    """Takes unknown k out of the equations before it."""
    row = _before(rows[k], k)
    for i, entry in row:
        factor = entry / rows[k][k]
        right[i] = right[i] - right[k] * factor
        for j, other in row:
            if j <= i:
                rows[i][j] = rows[i].get(j, ctx.zero) - factor * other


def _before(row: Mapping[int, Number], k: int) -> list[tuple[int, Number]]:
    """The entries of a row left of the diagonal."""
    return [(j, entry) for j, entry in row.items() if j < k]
