"""The C1 curve through keys of a matrix group (Li and Hao 2006, as Bansal and Tatu summarise it in section 4.1).

Its segment i is N_i(t) = A_i exp(t B_i) exp(t^2 C_i). Seen from the moving frame its velocity is

    N^-1 N' = exp(-t^2 C) B exp(t^2 C) + 2 t C,

B at t = 0 and exp(-C) B exp(C) + 2 C at t = 1, where the next segment takes it over as its B. Equation 6 prints the
conjugation by A_i^-1 A_(i+1) = exp(B) exp(C) for that by exp(C): the same, as exp(B) commutes with B.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

from affinecert.reference._matrices import Array, Context, Number

Function = Callable[[Context, Array], Array]


@dataclass(frozen=True)
class Group:
    """A group of matrices: the exponential from its Lie algebra's, the principal logarithm back, and the inverse."""

    exp: Function
    log: Function
    inverse: Function


def segment(ctx: Context, t: Number, keys: int) -> tuple[int, Number]:
    """The segment that holds the time t, counted from 0, and the time since its start.

    Key i has the time i. Before the first key the first segment goes on, and after the last key the last one.
    """
    index = min(max(int(ctx.floor(t)), 0), keys - 2)
    return index, t - index


def curve(ctx: Context, group: Group, keys: Sequence[Array], t: Number) -> Array:
    """The curve at the time t, which is i at key i; it starts with B_0 = log(A_0^-1 A_1), hence C_0 = 0."""
    index, time = segment(ctx, t, len(keys))
    rate = group.log(ctx, group.inverse(ctx, keys[0]) @ keys[1])
    bend = rate * 0
    for here, there in pairwise(keys[1 : index + 2]):
        turn = group.exp(ctx, bend)
        rate = group.inverse(ctx, turn) @ rate @ turn + 2 * bend
        bend = group.log(ctx, group.exp(ctx, -rate) @ group.inverse(ctx, here) @ there)
    point: Array = keys[index] @ group.exp(ctx, rate * time) @ group.exp(ctx, bend * time**2)
    return point


def with_midpoints(ctx: Context, group: Group, keys: Sequence[Array]) -> list[Array]:
    """The keys, and between each two of them A_i exp(log(A_i^-1 A_(i+1)) / 2)."""
    refined = [keys[0]]
    for here, there in pairwise(keys):
        refined += [here @ group.exp(ctx, group.log(ctx, group.inverse(ctx, here) @ there) / 2), there]
    return refined
