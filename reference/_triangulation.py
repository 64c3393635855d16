"""The indices of triangulations."""

from __future__ import annotations

from affinecert.errors import InputError
from affinecert.reference._matrices import Array

Triple = tuple[int, int, int]


def triples(triangles: Array, count: int) -> list[Triple]:
    """The triangles as indices; refuses what is no mesh of one piece."""
    triples = [(int(i), int(j), int(k)) for i, j, k in triangles]
    if any(int(x) != x or not 0 <= x < count for x in triangles.flat) or any(len({*each}) < 3 for each in triples):
        raise InputError("triangles", "not triples of different vertices")
    reached, before = {0}, -1
    while len(reached) > before:
        before = len(reached)
        reached |= {i for each in triples if reached & {*each} for i in each}
    if len(reached) < count:
        raise InputError("triangles", "not one piece with all vertices")
    return triples
