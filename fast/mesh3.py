"""Blends of triangulated shapes of space: affine maps of the triangles are blended, and put together by least squares.

Everything but the factors of the sparse equations is computed in double-double arithmetic; the solution is refined, and
rounded once.

Source: Kaji and Ochiai, "A concise parametrisation of affine transformation", 2016, section 5.3.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast._batches import each
from affinecert.fast._kernel import Array
from affinecert.fast._sparse import factored, mean, pattern, refined, total, without_threads_of_blas
from affinecert.fast._stages import run
from affinecert.fast._surface_gradient import surface_gradient
from affinecert.fast._triangulation import Indices, cross, indices, normals
from affinecert.fast._wide import add, divide, multiply, product, rounded, square_root, subtract, times, widen
from affinecert.fast._wide_polar import polar
from affinecert.fast._wide_rotation import rotation, rotation_vector
from affinecert.fast._wide_symmetric import symmetric_exponential, symmetric_logarithm

NO_AREA = "a triangle without area"
NOT_UNIQUE = "the minimiser is not unique, or too ill-conditioned to be told"


@dataclass(frozen=True)
class _Blender:
    """What does not depend on the weights: logarithms of the maps of triangles, and the factored equations.

    ``vectors`` and ``logarithms`` are those of the polar factors, (targets, faces, 3, 2) and (targets, faces, 3, 3, 2);
    ``centres`` the barycentres of the rest shape and of the targets, (1 + targets, 3, 2).
    """

    triangles: Array
    edges: Array
    metric: Array
    vectors: Array
    logarithms: Array
    centres: Array
    count: int
    solve: Callable[[Array], Array]

    def at(self, weights: Array) -> Array:
        """The blended vertices, (vertices, 3)."""
        turn, growth, centre = (
            reduce(add, (times(part, weight) for part, weight in zip(parts, weights, strict=True)))
            for parts in (self.vectors, self.logarithms, subtract(self.centres[1:], self.centres[0]))
        )
        blended = product(rotation(turn), symmetric_exponential(growth))
        goals = np.swapaxes(product(blended, self.edges), -3, -2)

        def slope(moved: Array) -> Array:
            found = run(surface_gradient, self.triangles, self.metric, goals, moved)[0]
            found[0] = 0.0
            return found

        with without_threads_of_blas():
            moved = refined(np.zeros((self.count, 3, 2)), slope, self.solve)
        if moved is None:
            raise InputError("triangles", NOT_UNIQUE)
        shift = subtract(add(self.centres[0], centre), mean(moved))
        return rounded(add(moved, shift))


def blend(rest: ArrayLike, targets: ArrayLike, triangles: ArrayLike, weights: ArrayLike) -> Array:
    """The shape that blends targets, all triangulated like the shape at rest.

    rest (..., vertices, 3), targets (..., targets, vertices, 3), triangles (..., faces, 3) of indices from 0 as
    float64, weights (..., targets), any numbers; gives (..., vertices, 3): the shape at rest for weights 0, and a
    target for a weight of 1 beside 0. A_ij takes triangle j at rest to that of target i, and unit normal to unit
    normal; A_j' is their blend, with the weights, as `kaji_ochiai.blend` has it, rotation vectors principal. The
    vertices minimise the sum over triangles of area |A_j - A_j'|^2 on the plane of the triangle, A_j being what takes
    the triangle at rest there; their barycentre is b plus the sum of w_i (b_i - b), b that of the shape at rest. The
    equations depend on the shape at rest only: they are factored once for all weights. Raises InputError for a wrong
    shape or dtype, numbers that are not finite, triangles that are no triples of different vertices, a mesh that is not
    one piece with all vertices, and a triangle without area.

    >>> rest = np.array([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 2.0, 0.0]])
    >>> blend(rest, [4.0 * rest], [[0.0, 1.0, 2.0]], [0.5]).round(15) + 0.0
    array([[-2., -2.,  0.],
           [ 2., -2.,  0.],
           [ 0.,  4.,  0.]])
    """
    inputs = {
        "rest": ("vertices", 3),
        "targets": ("targets", "vertices", 3),
        "triangles": ("faces", 3),
        "weights": ("targets",),
    }
    return each(inputs, (rest, targets, triangles, weights), "weights", _prepared, ("vertices", 3))


def _prepared(rest: Array, targets: Array, triangles: Array) -> Callable[[Array], Array]:
    """What takes weights to the blended vertices."""
    faces = indices(triangles, len(rest))
    exponent = int(np.frexp(np.abs(rest).max())[1])
    shapes = [np.ldexp(shape, -exponent) for shape in (rest, *targets)]
    first, second, across = normals(shapes[0], faces)
    double = _length("rest", across)
    normal = divide(across, double[:, None, :])
    over = double[:, None, :]
    inverse = np.stack([divide(cross(second, normal), over), divide(cross(normal, first), over), normal], axis=-3)
    factors = [polar(product(_frame(shape, faces), inverse)) for shape in shapes[1:]]
    metric = _metric(first, second, double)
    blender = _Blender(
        triangles=triangles,
        edges=np.stack([first, second], axis=-2),
        metric=metric,
        vectors=np.array([rotation_vector(turn) for turn, _ in factors]),
        logarithms=np.array([symmetric_logarithm(stretch) for _, stretch in factors]),
        centres=np.array([mean(widen(shape)) for shape in shapes]),
        count=len(rest),
        solve=_solver(faces, metric[..., 0], len(rest)),
    )
    return lambda weights: np.ldexp(blender.at(weights), exponent)


def _frame(shape: Array, faces: Indices) -> Array:
    """The edges of triangles and their unit normals, in the columns of matrices of pairs (faces, 3, 3, 2)."""
    first, second, across = normals(shape, faces)
    return np.stack([first, second, divide(across, _length("targets", across)[:, None, :])], axis=-2)


def _length(name: str, across: Array) -> Array:
    """The lengths of vectors, none of which may be 0."""
    if not across.any(axis=(-2, -1)).all():
        raise InputError(name, NO_AREA)
    return square_root(_dot(across, across))


def _dot(a: Array, b: Array) -> Array:
    """The inner products of vectors of pairs, (..., 3, 2)."""
    return total(np.moveaxis(multiply(a, b), -2, 0))


def _metric(first: Array, second: Array, double: Array) -> Array:
    """The area times the inverse of the Gram matrix of both edges, as pairs (faces, 3, 2) for both squares and between.

    The determinant of that matrix is the square of twice the area.
    """
    adjugate = [_dot(second, second), -_dot(first, second), _dot(first, first)]
    return divide(np.stack(adjugate, axis=-2), 2.0 * double[:, None, :])


# The edges from the first vertex of a triangle, of its three vertices.
EDGES = np.array([[-1.0, 1.0, 0.0], [-1.0, 0.0, 1.0]])


def _solver(faces: Indices, metric: Array, count: int) -> Callable[[Array], Array]:
    """What gives a step, (vertices, 3), for half a gradient, the first vertex being at rest."""
    free = np.arange(count) > 0
    none = np.empty(0, dtype=np.intp)
    blocks = EDGES.T @ metric[:, [[0, 1], [1, 2]]] @ EDGES
    factors = factored(pattern(faces, none, none, free).matrix(blocks.ravel()))
    if factors is None:
        raise InputError("triangles", NOT_UNIQUE)
    return factors.solve
