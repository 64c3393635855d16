"""The C1 curve through keys of a matrix group, in double-doubles (Li and Hao 2006; Bansal and Tatu, section 4.1).

Its segment i is A_i exp(t B_i) exp(t^2 C_i), with C_i = log(exp(-B_i) A_i^-1 A_(i+1)), B_0 = log(A_0^-1 A_1) and
B_(i+1) = exp(-C_i) B_i exp(C_i) + 2 C_i, the velocity in the moving frame where one segment ends and the next begins.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array


@dataclass(frozen=True)
class Group:
    """A group of matrices of pairs: the exponential from its Lie algebra, the principal logarithm, and the inverse."""

    exp: Callable[[Array], Array]
    log: Callable[[Array], Array]
    inverse: Callable[[Array], Array]


def segments(t: Array, keys: int) -> tuple[NDArray[np.int64], Array]:
    """The segments that hold the times t (...), counted from 0, and the times since their starts, which are exact.

    Key i has the time i. Before the first key the first segment goes on, and after the last key the last one.
    """
    index = np.clip(np.floor(t), 0, keys - 2).astype(np.int64)
    return index, t - index


def chosen(several: Array, index: NDArray[np.int64], item: int) -> Array:
    """Of several items (..., count, *item), an item having so many axes, those of the indices (...)."""
    batch = np.broadcast_shapes(several.shape[: -item - 1], index.shape)
    places = np.broadcast_to(index, batch)[(..., *(None,) * (item + 1))]
    wide_enough = np.broadcast_to(several, batch + several.shape[-item - 1 :])
    taken: Array = np.take_along_axis(wide_enough, places, axis=-item - 1)
    return taken.reshape(batch + several.shape[several.ndim - item :])


def _keys(keys: Array) -> list[Array]:
    return [keys[..., i, :, :, :] for i in range(keys.shape[-4])]


def curve(group: Group, keys: Array, t: Array) -> Array:
    """The points on the curves through keys (..., keys, k, k, 2) at the times t (...), (..., k, k, 2)."""
    first, second, *_ = several = _keys(keys)
    rates = [group.log(wide.product(group.inverse(first), second))]
    bends = [np.zeros_like(rates[0])]
    for here, there in pairwise(several[1:]):
        turn = group.exp(bends[-1])
        carried = wide.product(wide.product(group.inverse(turn), rates[-1]), turn)
        rates.append(wide.add(carried, 2.0 * bends[-1]))
        step = wide.product(group.inverse(here), there)
        bends.append(group.log(wide.product(group.exp(-rates[-1]), step)))
    index, time = segments(t, len(several))
    start, rate, bend = (chosen(each, index, 3) for each in (keys, np.stack(rates, axis=-4), np.stack(bends, axis=-4)))
    time = time[..., None, None]
    moved = wide.product(start, group.exp(wide.times(rate, time)))
    return wide.product(moved, group.exp(wide.times(wide.times(bend, time), time)))


def with_midpoints(group: Group, keys: Array) -> Array:
    """The keys, and between each two of them A_i exp(log(A_i^-1 A_(i+1)) / 2), (..., 2 keys - 1, k, k, 2)."""
    here, there = keys[..., :-1, :, :, :], keys[..., 1:, :, :, :]
    half = group.exp(0.5 * group.log(wide.product(group.inverse(here), there)))
    refined = np.empty((*keys.shape[:-4], 2 * keys.shape[-4] - 1, *keys.shape[-3:]))
    refined[..., ::2, :, :, :] = keys
    refined[..., 1::2, :, :, :] = wide.product(here, half)
    return refined
