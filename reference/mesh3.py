"""Blends of triangulated shapes of space, put together from blended affine maps of the triangles.

Kaji and Ochiai, A concise parametrisation of affine transformation, section 5.3.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from affinecert.errors import InputError
from affinecert.reference import _domain, kaji_ochiai
from affinecert.reference._least_squares import Square, minimiser
from affinecert.reference._matrices import Array, Context, Number, array, cross, homogeneous, norm
from affinecert.reference._triangulation import Triple, triples


def blend(ctx: Context, rest: Array, targets: Array, triangles: Array, weights: Array) -> Array:
    """The shape U between a rest shape and targets, (vertices, 3), (targets, vertices, 3), (faces, 3), (targets,).

    A_ij is the affine map that takes face j of the rest shape to that of target i, and unit normal to unit normal, and
    A'_j = Blend(w, A_1j, ..., A_nj) as in `kaji_ochiai.blend`. U minimises the sum over faces of area_j |A_j - A'_j|_F^2
    over all affine maps A_j that take face j to that of U: the image of the normal is at will, as if each face had a
    fourth vertex of its own. The barycentre is b + sum of w_i (b_i - b), b that of the rest shape. Gives (vertices, 3).
    Raises InputError for triangles that are no triples of different vertices, a mesh in pieces or not of all vertices,
    and triangles without area.
    """
    for name, argument in (("rest", rest), ("targets", targets), ("triangles", triangles), ("weights", weights)):
        _domain.finite(ctx, name, argument)
    squares: list[Square] = []
    for number, triple in enumerate(triples(triangles, len(rest))):
        frame, area = _frame(ctx, "rest", rest, triple)
        inverse = _inverse(frame, area)
        maps = [_frame(ctx, "targets", target, triple)[0] @ inverse for target in targets]
        poses = array([homogeneous(ctx, linear, array([ctx.zero] * 3)) for linear in maps])
        blended = kaji_ochiai.blend(ctx, poses, weights)[:3, :3]
        squares += _misfit(triple, len(rest) + number, inverse, area, blended)
    origin = array([ctx.zero] * 3)
    shape = minimiser(ctx, squares, len(rest) + len(triangles), {0: origin})
    if shape is None:
        raise InputError("triangles", "the minimiser is not unique")
    vertices = shape[: len(rest)]
    centre = _barycentre(rest)
    for weight, target in zip(weights, targets, strict=True):
        centre = centre + (_barycentre(target) - _barycentre(rest)) * weight
    moved: Array = vertices + (centre - _barycentre(vertices))
    return moved


def _frame(ctx: Context, name: str, vertices: Array, triple: Triple) -> tuple[Array, Number]:
    """The edges of a face and its unit normal, in columns, and twice its area."""
    first, second, third = (vertices[i] for i in triple)
    normal = cross(second - first, third - first)
    double = norm(ctx, normal)
    if not double:
        raise InputError(name, "a triangle without area")
    return array([second - first, third - first, normal / double]).T, double


def _inverse(frame: Array, double: Number) -> Array:
    """The inverse of a frame, whose determinant is twice the area."""
    first, second, normal = frame.T
    return array([cross(second, normal), cross(normal, first), cross(first, second)]) / double


def _misfit(triple: Triple, own: int, inverse: Array, double: Number, goal: Array) -> Iterator[Square]:
    """The squares of area |A - goal|_F^2, three coordinates at once; unknown ``own`` is the image of the normal."""
    for column in range(3):
        second, third, normal = inverse[:, column]
        coefficients = (-second - third, second, third, normal)
        yield Square(double / 2, list(zip((*triple, own), coefficients, strict=True)), goal[:, column])


def _barycentre(vertices: Array) -> Array:
    mean: Array = np.sum(vertices, axis=0) / len(vertices)
    return mean
