"""Interpolation of triangulated shapes of the plane as piecewise affine maps (Kaji et al., section 4 and appendix).

Triangle i is moved by the affine map of linear part A_i from the source p to the target q, and A_i(t) = R_(t theta) S^t
is its exponential homotopy (`homotopy2.exponential`). The shape at the time t has those vertices v that make

    sum_i area_i E_i(A_i(t), B_i) + constraints

least, where B_i, linear in v, is the linear part of the map from triangle i of the source to that of v. What is least
over s and delta as well, in the errors that are invariant under similarities, is left to the same minimisation: the
entries x, y of s R_delta = x I + y J, J = [[0, -1], [1, 0]], are unknowns like v.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from affinecert.errors import InputError
from affinecert.reference import _domain, homotopy2
from affinecert.reference._exact import determinant_sign
from affinecert.reference._least_squares import Square, minimiser
from affinecert.reference._matrices import Array, Context, Number, array, scalar
from affinecert.reference._precision import span
from affinecert.reference._triangulation import Triple, pieces, triples


@dataclass(frozen=True)
class Face:
    """A triangle at the time t: its vertices, the inverse of its edges (columns p_2 - p_1, p_3 - p_1), area and A(t).

    ``corners`` are the places of its vertices seen from their centroid.
    """

    vertices: Triple
    inverse: Array
    corners: Array
    area: Number
    goal: Array


Energy = Callable[[Context, Face, int], Iterator[Square]]
"""The squares of the error of one face; the number is that of the first unknown it may use for itself."""


@dataclass(frozen=True)
class Locus:
    """A vertex that must be at a place; exactly so if there is no weight."""

    vertex: int
    place: Array
    weight: Number | None = None


def frobenius(ctx: Context, source: Array, target: Array, triangles: Array, t: Array) -> Array:
    """The minimiser of E^F, the sum of area |A - B|_F^2; the first vertex moves linearly (Alexa et al. 2000).

    Source and target (vertices, 2), triangles (faces, 3) of indices, t () -> (vertices, 2). Raises InputError for
    triangles that are no triples of different vertices, vertices without a triangle, a mesh in pieces, and triangles
    of source and target that have no area or not the same orientation.
    """
    faces = _faces(ctx, source, target, triangles, t)
    return _interpolated(ctx, len(source), [(face, _frobenius) for face in faces], [_first(source, target, t)])


def points(ctx: Context, source: Array, target: Array, triangles: Array, t: Array) -> Array:
    """The minimiser of E^S, the sum of area min sum_k |s R_delta A p_k + d - v_k|^2 over s, delta and d.

    So the corners p_k are compared up to similarity, translations included (Werman and Weinshall 1995). The first and
    the last vertex are given as for `similarity`. Raises InputError as that does.
    """
    faces = _faces(ctx, source, target, triangles, t)
    _require_edges(faces, [ctx.zero] * len(faces))
    return _interpolated(ctx, len(source), [(face, _points) for face in faces], _ends(ctx, source, target, t))


def similarity(ctx: Context, source: Array, target: Array, triangles: Array, t: Array) -> Array:
    """The minimiser of E^R, the sum of area min |s R_delta A - B|_F^2 over s and delta (equation 4).

    The first vertex moves linearly, and the vector from it to the last one by the exponential homotopy of the
    similarity that takes it from source to target. Raises InputError as `frobenius` does, where these two vertices are
    in one place, and for pieces that are connected by vertices only: the error leaves their angles free.
    """
    faces = _faces(ctx, source, target, triangles, t)
    _require_edges(faces, [ctx.zero] * len(faces))
    return _interpolated(ctx, len(source), [(face, _similarity) for face in faces], _ends(ctx, source, target, t))


def balanced(ctx: Context, source: Array, target: Array, triangles: Array, t: Array, balance: Array) -> Array:
    """The minimiser of the sum of area (w E^F + (1 - w) E^R), w in [0, 1] the ``balance`` (faces,) of each face.

    The first and the last vertex are given as for `similarity`. Raises InputError as it does, but for pieces with some
    w above 0, and for other w.
    """
    _domain.finite(ctx, "balance", balance)
    if any(not 0 <= w <= 1 for w in balance):
        raise InputError("balance", "not in [0, 1]")
    faces = _faces(ctx, source, target, triangles, t)
    _require_edges(faces, list(balance))
    mixed = [(face, _mixture(w)) for face, w in zip(faces, balance, strict=True)]
    return _interpolated(ctx, len(source), mixed, _ends(ctx, source, target, t))


def constrained(
    ctx: Context, source: Array, target: Array, triangles: Array, t: Array, place: Array, weight: Array
) -> Array:
    """The minimiser of E^F + weight |v_last - place|^2; the first vertex moves linearly.

    place (2,), weight () positive. Raises InputError as `frobenius` does, and for a weight that is not positive.
    """
    _domain.finite(ctx, "place", place)
    _domain.finite(ctx, "weight", weight)
    _domain.positive("weight", weight[()])
    faces = _faces(ctx, source, target, triangles, t)
    loci = [_first(source, target, t), Locus(len(source) - 1, place, weight[()])]
    return _interpolated(ctx, len(source), [(face, _frobenius) for face in faces], loci)


def symmetric(ctx: Context, source: Array, target: Array, triangles: Array, t: Array) -> Array:
    """The minimiser of E^F(t) from source to target plus E^F(1 - t) from target to source; the first vertex as there.

    Raises InputError as `frobenius` does.
    """
    there = _faces(ctx, source, target, triangles, t)
    back = _faces(ctx, target, source, triangles, scalar(1 - t[()]))
    return _interpolated(
        ctx, len(source), [(face, _frobenius) for face in [*there, *back]], [_first(source, target, t)]
    )


def _faces(ctx: Context, source: Array, target: Array, triangles: Array, t: Array) -> list[Face]:
    for name, argument in (("source", source), ("target", target), ("triangles", triangles), ("t", t)):
        _domain.finite(ctx, name, argument)
    return [
        _face(ctx, ctx.prec, triple, tuple(source[[*triple]].flat), tuple(target[[*triple]].flat), t.item())
        for triple in triples(triangles, len(source))
    ]


# A mesh whose derivatives are taken is asked for again with a single vertex moved, and most faces stay as they were.
@lru_cache(maxsize=256)
def _face(
    ctx: Context, _: int, vertices: Triple, before: tuple[Number, ...], after: tuple[Number, ...], t: Number
) -> Face:
    """The triangle of those vertices, given all coordinates in source and target, and the precision."""
    source, target = (array(each).reshape(3, 2) for each in (before, after))
    # Differences and products are exact, so that a turn by pi leaves the two entries equal that tell its side.
    with ctx.extraprec(2 * span(source, target)):
        edges, goals = (array([points[1] - points[0], points[2] - points[0]]).T for points in (source, target))
        sign = determinant_sign(edges)
        if sign == 0:
            raise InputError("source", "a triangle without area")
        if determinant_sign(goals) != sign:
            raise InputError("target", "a triangle without area, or turned over")
        (a, b), (c, d) = edges
        double = a * d - b * c
        adjugate = array([[d, -b], [-c, a]])
        linear = goals @ adjugate / double
        return Face(
            vertices=vertices,
            inverse=adjugate / double,
            corners=source - sum(source) / 3,
            area=abs(double) / 2,
            goal=homotopy2.exponential(ctx, linear, scalar(t)),
        )


def _require_edges(faces: list[Face], balance: list[Number]) -> None:
    """Refuses several pieces that are connected by vertices only, if E^F has no share in one of them."""
    parts = pieces([face.vertices for face in faces])
    if len(parts) > 1 and not all(any(balance[number] for number in part) for part in parts):
        raise InputError("triangles", "pieces that hang together by vertices only, free to turn and to collapse")


def _first(source: Array, target: Array, t: Array) -> Locus:
    return Locus(0, source[0] + (target[0] - source[0]) * t[()])


def _ends(ctx: Context, source: Array, target: Array, t: Array) -> list[Locus]:
    """The first vertex on its line, and the last as the similarity of the two vertices takes it."""
    for name, shape in (("source", source), ("target", target)):
        if not any(shape[-1] - shape[0]):
            raise InputError(name, "the first and the last vertex are in one place")
    # As for faces: a turn by pi leaves y exactly 0.
    with ctx.extraprec(2 * span(source, target)):
        (a, b), (c, d) = source[-1] - source[0], target[-1] - target[0]
        length = a * a + b * b
        x, y = (a * c + b * d) / length, (a * d - b * c) / length
        moved = homotopy2.exponential(ctx, array([[x, -y], [y, x]]), t)
        first = _first(source, target, t)
        return [first, Locus(len(source) - 1, first.place + moved @ array([a, b]))]


def _interpolated(ctx: Context, count: int, faces: list[tuple[Face, Energy]], loci: list[Locus]) -> Array:
    """The vertices that make the sum of the faces' errors, and of the loci's, least."""
    known = {2 * each.vertex + axis: each.place[axis] for each in loci if each.weight is None for axis in (0, 1)}
    squares: list[Square] = []
    size = 2 * count
    for face, energy in faces:
        mine = [Square(face.area * s.weight, s.terms, s.goal) for s in energy(ctx, face, size)]
        squares += mine
        size = max(size, 1 + max(i for square in mine for i, _ in square.terms))
    for each in loci:
        if each.weight is not None:
            squares += [Square(each.weight, [(2 * each.vertex + axis, ctx.one)], each.place[axis]) for axis in (0, 1)]
    solution = minimiser(ctx, squares, size, known)
    if solution is None:
        raise InputError("triangles", "the minimiser is not unique")
    vertices: Array = solution[: 2 * count].reshape(count, 2)
    return vertices


def _entry(ctx: Context, face: Face, row: int, column: int) -> list[tuple[int, Number]]:
    """An entry of B = [v_2 - v_1, v_3 - v_1] times the inverse of the source's edges, as terms in v."""
    second, third = face.inverse[:, column]
    return [(2 * i + row, c) for i, c in zip(face.vertices, (-second - third, second, third), strict=True)]


def _frobenius(ctx: Context, face: Face, _: int) -> Iterator[Square]:
    for (row, column), goal in np.ndenumerate(face.goal):
        yield Square(ctx.one, _entry(ctx, face, row, column), goal)


def _similarity(ctx: Context, face: Face, own: int) -> Iterator[Square]:
    turned = _quarter_turned(face.goal)
    for row, column in np.ndindex(2, 2):
        similar = [(own, -face.goal[row, column]), (own + 1, -turned[row, column])]
        yield Square(ctx.one, [*_entry(ctx, face, row, column), *similar], ctx.zero)


def _points(ctx: Context, face: Face, own: int) -> Iterator[Square]:
    images = (face.goal @ face.corners.T).T
    for vertex, image in zip(face.vertices, images, strict=True):
        for axis, turned in ((0, -image[1]), (1, image[0])):
            similar = [(own, -image[axis]), (own + 1, -turned), (own + 2 + axis, -ctx.one)]
            yield Square(ctx.one, [(2 * vertex + axis, ctx.one), *similar], ctx.zero)


def _mixture(w: Number) -> Energy:
    """The error w E^F + (1 - w) E^R."""

    def mixed(ctx: Context, face: Face, own: int) -> Iterator[Square]:
        for weight, energy in ((w, _frobenius), (1 - w, _similarity)):
            if weight:
                yield from (Square(weight * s.weight, s.terms, s.goal) for s in energy(ctx, face, own))

    return mixed


def _quarter_turned(matrix: Array) -> Array:
    """J M."""
    return array([-matrix[1], matrix[0]])
