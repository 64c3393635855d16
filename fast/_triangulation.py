"""Triangulations: their indices, signed areas, pieces, and angles that agree from triangle to triangle."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import csgraph

from affinecert.errors import InputError
from affinecert.fast._kernel import Array
from affinecert.fast._wide import multiply, subtract, widen

Indices = NDArray[np.intp]

NO_TRIPLES = "not triples of different vertices"
IN_PIECES = "not one piece with all vertices"

# Areas of pairs are within 2^-100 of the products of edges; this far above, the sign is sure and 40 bits are right.
SURE = 2.0**-60


def indices(triangles: Array, count: int) -> Indices:
    """The triangles (faces, 3) as integers; InputError for what is no mesh of one piece with so many vertices."""
    with np.errstate(invalid="ignore"):  # what is no index is told by the comparison
        whole = triangles.astype(np.intp)
    first, second, third = whole.T
    distinct = (first != second) & (second != third) & (third != first)
    if not (np.array_equal(whole, triangles) and ((whole >= 0) & (whole < count)).all() and distinct.all()):
        raise InputError("triangles", NO_TRIPLES)
    edges = sparse.coo_array((np.ones(2 * len(whole)), (np.tile(first, 2), whole[:, 1:].T.ravel())), (count, count))
    if csgraph.connected_components(edges, directed=False)[0] > 1:
        raise InputError("triangles", IN_PIECES)
    return whole


def twice_areas(vertices: Array, triangles: Indices) -> Array:
    """Twice the signed areas of triangles of the plane, pairs (faces, 2): 0 exactly where there is none."""
    (x, y), (z, w) = (
        np.moveaxis(subtract(widen(vertices[triangles[:, k]]), widen(vertices[triangles[:, 0]])), -2, 0) for k in (1, 2)
    )
    product, other = multiply(x, w), multiply(y, z)
    areas = subtract(product, other)
    doubtful = np.abs(areas[:, 0]) <= SURE * (np.abs(product[:, 0]) + np.abs(other[:, 0]))
    for face in np.flatnonzero(doubtful):
        areas[face] = _exact_twice_area(vertices[triangles[face]])
    return areas


def _exact_twice_area(corners: Array) -> tuple[float, float]:
    (a, b), (c, d), (e, f) = ([Fraction(x) for x in corner] for corner in corners.tolist())
    return _pair((c - a) * (f - b) - (d - b) * (e - a))


def normals(vertices: Array, triangles: Indices) -> tuple[Array, Array, Array]:
    """The edges of triangles of space from the first vertex, and their vector product, pairs (faces, 3, 2).

    The product is 0 exactly where there is no area.
    """
    first, second, third = (widen(vertices[triangles[:, k]]) for k in range(3))
    edges = subtract(second, first), subtract(third, first)
    product = cross(*edges)
    bound = np.prod([np.abs(edge[..., 0]).max(axis=-1) for edge in edges], axis=0)
    for face in np.flatnonzero(np.abs(product[..., 0]).max(axis=-1) <= SURE * bound):
        product[face] = _exact_normal(vertices[triangles[face]])
    return *edges, product


def cross(a: Array, b: Array) -> Array:
    """The vector products of vectors of pairs, (..., 3, 2)."""
    turned = [np.roll(x, shift, axis=-2) for x, shift in ((a, -1), (b, -2), (a, -2), (b, -1))]
    return subtract(multiply(turned[0], turned[1]), multiply(turned[2], turned[3]))


def _exact_normal(corners: Array) -> list[tuple[float, float]]:
    first, *others = ([Fraction(x) for x in corner] for corner in corners.tolist())
    u, v = ([x - y for x, y in zip(other, first, strict=True)] for other in others)
    return [_pair(u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2]) for i in range(3)]


def _pair(number: Fraction) -> tuple[float, float]:
    high = float(number)
    return high, float(number - Fraction(high))


def coherent_turns(angles: Array, triangles: Indices) -> Array:
    """Whole turns to add to the angles of triangles, (faces,), so that neighbours differ by half a turn at most.

    They spread from the first triangle of each piece, always over the edge where the two angles differ least; where a
    mesh has holes, triangles that meet later may still be turns apart.
    """
    first, second = _neighbours(triangles)
    steps = np.rint((angles[first] - angles[second]) / (2 * math.pi))
    # A minimum spanning tree; edges of weight 0 would not count as edges, so 1 is added to all.
    misfit = 1.0 + np.abs(angles[first] - angles[second] - 2 * math.pi * steps)
    count = len(angles)
    tree = csgraph.minimum_spanning_tree(sparse.coo_array((misfit, (first, second)), (count, count))).tocoo()
    roots = np.unique(csgraph.connected_components(tree, directed=False)[1], return_index=True)[1]
    # A last node beside all roots makes one tree of the pieces.
    rows = np.concatenate([tree.row, roots], dtype=np.intp)
    columns = np.concatenate([tree.col, np.full(len(roots), count)], dtype=np.intp)
    whole = sparse.coo_array((np.ones(len(rows)), (rows, columns)), (count + 1, count + 1))
    parents = csgraph.breadth_first_order(whole, count, directed=False)[1][:count]
    before = np.where(parents == count, angles, angles[np.where(parents == count, 0, parents)])
    turns = np.append(np.rint((before - angles) / (2 * math.pi)), 0.0)
    # Every triangle adds what its parent has, whose parent then is twice as far.
    parents = np.append(parents, count)
    while (parents != count).any():
        turns = turns + turns[parents]
        parents = parents[parents]
    return turns[:count]


def pieces(triangles: Indices) -> Indices:
    """The number of the piece that each triangle belongs to, pieces being connected by edges."""
    count = len(triangles)
    first, second = _neighbours(triangles)
    edges = sparse.coo_array((np.ones(len(first)), (first, second)), (count, count))
    return np.asarray(csgraph.connected_components(edges, directed=False)[1], dtype=np.intp)


def _neighbours(triangles: Indices) -> tuple[Indices, Indices]:
    """The pairs of triangles that share an edge, as two arrays."""
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    faces = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort((edges[:, 0], edges[:, 1]))
    same = (edges[order[1:]] == edges[order[:-1]]).all(axis=1)
    return faces[order[:-1][same]], faces[order[1:][same]]
