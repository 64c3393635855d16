"""The indices of triangulations."""

from __future__ import annotations

from affinecert.errors import InputError
from affinecert.reference._matrices import Array, array

Triple = tuple[int, int, int]


def triples(triangles: Array, count: int) -> list[Triple]:
    """The triangles as indices; refuses what is no mesh of one piece."""
    triples: list[Triple] = [(int(i), int(j), int(k)) for i, j, k in triangles]
    whole = array(triples).reshape(-1, 3)
    if (whole != triangles).any() or any(
        len({*each}) < 3 or not 0 <= min(each) <= max(each) < count for each in triples
    ):
        raise InputError("triangles", "not triples of different vertices")
    reached, before = {0}, -1
    while len(reached) > before:
        before = len(reached)
        reached |= {i for each in triples if reached & {*each} for i in each}
    if len(reached) < count:
        raise InputError("triangles", "not one piece with all vertices")
    return triples


def pieces(triples: list[Triple]) -> list[set[int]]:
    """The triangles, by their numbers, in pieces that are connected by edges."""
    found: list[tuple[set[int], set[frozenset[int]]]] = []
    for number, (i, j, k) in enumerate(triples):
        edges = {frozenset(edge) for edge in ((i, j), (j, k), (k, i))}
        near = [piece for piece in found if piece[1] & edges]
        found = [piece for piece in found if piece not in near]
        numbers, all_edges = (set().union(*sets) for sets in zip(*near, strict=True)) if near else (set(), set())
        found.append((numbers | {number}, all_edges | edges))
    return [numbers for numbers, _ in found]
