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
    squares share belong to the end.
    """
    rows: list[dict[int, Number]] = [{} for _ in range(size)]
    right = [ctx.zero] * size
    for weight, terms, goal in squares:
        rest = goal - sum((c * known[i] for i, c in terms if i in known), ctx.zero)
        free = [(i, c) for i, c in terms if i not in known]
        for i, c in free:
            weighted = weight * c
            right[i] += weighted * rest
            for j, other in free:
                if j <= i:
                    rows[i][j] = rows[i].get(j, ctx.zero) + weighted * other
    unknown = [i for i in range(size) if i not in known]
    scale = {k: rows[k].get(k, ctx.zero) for k in unknown}
    for k in reversed(unknown):
        if negligible(ctx, rows[k].get(k, ctx.zero), scale[k]):
            return None
        row = [(j, entry) for j, entry in rows[k].items() if j < k]
        for i, entry in row:
            factor = entry / rows[k][k]
            right[i] -= factor * right[k]
            for j, other in row:
                if j <= i:
                    rows[i][j] = rows[i].get(j, ctx.zero) - factor * other
    x = dict(known)
    for k in unknown:
        x[k] = (right[k] - sum((entry * x[j] for j, entry in rows[k].items() if j < k), ctx.zero)) / rows[k][k]
    return array([x[k] for k in range(size)])
