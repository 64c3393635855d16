"""Interpolation of triangulated shapes of the plane as piecewise affine maps.

Triangle i is moved by the affine map of linear part A_i from the source to the target, and A_i(t) is a homotopy from I
to it (`affinecert.fast.homotopy2`). The shape at the time t has those vertices v that make the sum of the errors
E_i(A_i(t), B_i), and of constraints, least; B_i, linear in v, is the linear part of the map from triangle i of the
source to that of v.

    E^F  |A - B|_F^2
    E^R  min |s R_delta A - B|_F^2 over s and delta
    E^S  min sum_k |s R_delta A p_k + d - v_k|^2 over s, delta and d, p_k and v_k the three corners

E^S is meant up to similarity, d included; as printed, without d, it would depend on the origin. Sparse equations are
factored in float64, for E^F once, for E^R and E^S at each time, as their matrix changes (the appendix says that it does
not). Everything else is computed in double-double arithmetic; the solution is refined, and rounded once.

Source: Kaji, Hirose, Sakata, Mizoguchi, Anjyo, "Mathematical analysis on affine maps for 2D shape interpolation", 2012,
section 4 and appendix.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from affinecert.errors import InputError
from affinecert.fast._batches import each
from affinecert.fast._kernel import Array, Shape, as_float64, checked
from affinecert.fast._mesh_constraints import (
    Barycentre,
    Constraint,
    Edge,
    Held,
    Locus,
    ends_as_a_similarity,
    first_linearly,
    pulled_last,
    read,
)
from affinecert.fast._mesh_problem import Hold, Options, moving

__all__ = [
    "Barycentre",
    "Edge",
    "Locus",
    "balanced",
    "constrained",
    "frobenius",
    "interpolate",
    "points",
    "similarity",
    "symmetric",
]

Energy = Literal["frobenius", "similarity", "points"]
Homotopy = Literal["linear", "polar", "exponential"]
Angles = Literal["principal", "coherent"]

MESH: Mapping[str, Shape] = {"source": ("vertices", 2), "target": ("vertices", 2), "triangles": ("faces", 3), "t": ()}

# Each thread has factors of its own, a hundred megabytes for a hundred thousand triangles.
MOST_WORKERS = 4


def interpolate(
    source: ArrayLike,
    target: ArrayLike,
    triangles: ArrayLike,
    t: ArrayLike,
    *,
    homotopy: Homotopy = "exponential",
    energy: Energy = "similarity",
    weights: ArrayLike | None = None,
    balance: ArrayLike | None = None,
    constraints: Iterable[Constraint] | None = None,
    symmetric: bool = False,
    angles: Angles = "principal",
    workers: int | None = None,
) -> Array:
    """The shapes between two triangulated shapes of the plane.

    source and target (vertices, 2), triangles (faces, 3) of indices from 0, and t (...), any number; gives (...,
    vertices, 2). Triangles may have either orientation, the same one in both shapes.

    ``energy`` is "frobenius" (E^F), "similarity" (E^R) or "points" (E^S), and ``homotopy`` the one of the triangles'
    linear parts. The errors are weighted with the areas in the source, or with ``weights`` (faces,). With a
    ``balance`` w in [0, 1], one or (faces,), "similarity" means w E^F + (1 - w) E^R. ``constraints`` are terms `Locus`,
    `Edge` and `Barycentre`; without any, the first vertex moves linearly, and for E^R and E^S the last vertex moves
    about it by the exponential homotopy of the similarity that takes one edge between them to the other: for these
    errors see neither rotation nor size, and would be least in a single point. (The first vertex is that of Alexa,
    Cohen-Or and Levin; "(1 - t) p_1 + t p_1" in the paper is a misprint for "(1 - t) p_1 + t q_1".) If ``symmetric``,
    those of the way back at 1 - t are added to the errors, with the areas of the target.

    Angles of rotation are "principal", in (-pi, pi], or "coherent": with whole turns added so that they change by half
    a turn at most between neighbours, from the first triangle on. E^R and E^S do not depend on them.

    ``workers`` is the number of threads that share the times, by default one for each processor, at most 4; the result
    does not depend on it. Raises InputError for wrong shapes and dtypes, numbers that are not finite, triangles that
    are no triples of different vertices, a mesh that is not one piece with all vertices or, where E^F has no share in
    it, not connected by edges, a triangle without area or turned over, weights that are not positive, a balance outside
    [0, 1], and constraints that leave the minimiser undetermined.

    >>> square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    >>> turned = square @ [[0.0, 2.0], [-2.0, 0.0]]
    >>> interpolate(square, turned, [[0, 1, 2], [0, 2, 3]], 0.5).round(6) + 0.0
    array([[ 0.,  0.],
           [ 1.,  1.],
           [ 0.,  2.],
           [-1.,  1.]])
    """
    (first, last, moments), _, _ = checked(
        {"source": ("vertices", 2), "target": ("vertices", 2), "t": ()}, (source, target, t)
    )
    for name, shape in (("source", first), ("target", last)):
        if shape.ndim > 2:
            raise InputError(name, f"shape {shape.shape} where (vertices, 2) is due")
    faces = _faces(triangles)
    for name, value, values in (
        ("energy", energy, Energy),
        ("homotopy", homotopy, Homotopy),
        ("angles", angles, Angles),
    ):
        if value not in get_args(values):
            raise InputError(name, f"{value!r} where one of {', '.join(map(repr, get_args(values)))} is due")
    options = Options(
        energy=energy,
        homotopy=homotopy,
        weights=None if weights is None else _positive(weights, len(faces)),
        balance=None if balance is None else _balance(balance, len(faces), energy),
        symmetric=symmetric,
        coherent=angles == "coherent",
    )

    def hold(start: Array, end: Array, exponent: int) -> Held:
        if constraints is None:
            return (first_linearly if energy == "frobenius" else ends_as_a_similarity)(start, end, exponent)
        held = read(constraints, len(start), moments.shape, exponent)
        held.require(start, rigid=energy == "frobenius" or bool(np.any(options.balance)))
        return held

    threads = min(workers or min(os.cpu_count() or 1, MOST_WORKERS), moments.size)
    frames = moving(first, last, faces, options, hold)(moments.ravel(), threads)
    return frames.reshape(*moments.shape, *first.shape)


def _faces(triangles: ArrayLike) -> Array:
    """Triangles given by whole numbers of any dtype, (faces, 3), as float64."""
    array = np.asarray(triangles)
    if array.dtype.kind not in "iuf":
        raise InputError("triangles", f"dtype {array.dtype} where whole numbers are due")
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError("triangles", f"shape {array.shape} where (faces, 3) is due")
    return array.astype(np.float64)


def _positive(weights: ArrayLike, count: int) -> Array:
    array = as_float64("weights", weights)
    if array.shape != (count,):
        raise InputError("weights", f"shape {array.shape} where ({count},) is due")
    if not (np.isfinite(array) & (array > 0.0)).all():
        raise InputError("weights", "not positive and finite")
    return array


def _balance(balance: ArrayLike, count: int, energy: str) -> Array:
    array = as_float64("balance", balance)
    if array.shape not in ((), (count,)):
        raise InputError("balance", f"shape {array.shape} where () or ({count},) is due")
    if energy != "similarity":
        raise InputError("balance", f"given for {energy!r}; it is between E^F and E^R, the energy 'similarity'")
    if not ((array >= 0.0) & (array <= 1.0)).all():
        raise InputError("balance", "not in [0, 1]")
    return np.broadcast_to(array, count)


def frobenius(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike) -> Array:
    """`interpolate` with E^F, weighted with areas: the first vertex moves linearly.

    source and target (..., vertices, 2), triangles (..., faces, 3) as float64, t (...); gives (..., vertices, 2).
    Raises InputError as `interpolate` does.
    """
    return _each(MESH, (source, target, triangles, t), lambda: (Options(), first_linearly))


def points(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike) -> Array:
    """`interpolate` with E^S, weighted with areas: the first and the last vertex move as a similarity has it.

    Shapes and errors are those of `frobenius`; besides, these two vertices must not be in one place.
    """
    return _each(MESH, (source, target, triangles, t), lambda: (Options("points"), ends_as_a_similarity))


def similarity(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike) -> Array:
    """`interpolate` with E^R, weighted with areas: the first and the last vertex move as a similarity has it.

    Shapes and errors are those of `points`.
    """
    return _each(MESH, (source, target, triangles, t), lambda: (Options("similarity"), ends_as_a_similarity))


def balanced(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike, balance: ArrayLike) -> Array:
    """`interpolate` with w E^F + (1 - w) E^R, w the balance, (..., faces), in [0, 1].

    Otherwise as `similarity`.
    """

    def settled(share: Array) -> tuple[Options, Hold]:
        return Options("similarity", balance=_balance(share, len(share), "similarity")), ends_as_a_similarity

    return _each({**MESH, "balance": ("faces",)}, (source, target, triangles, t, balance), settled)


def constrained(
    source: ArrayLike,
    target: ArrayLike,
    triangles: ArrayLike,
    t: ArrayLike,
    place: ArrayLike,
    weight: ArrayLike,
) -> Array:
    """`interpolate` with E^F, the first vertex moving linearly, and a `Locus` of the last vertex.

    place (..., 2) is where it should be, weight (...) positive. Otherwise as `frobenius`.
    """

    def settled(goal: Array, pull: Array) -> tuple[Options, Hold]:
        if not pull > 0.0:
            raise InputError("weight", "not positive")
        return Options(), pulled_last(goal, float(pull))

    inputs = {**MESH, "place": (2,), "weight": ()}
    return _each(inputs, (source, target, triangles, t, place, weight), settled)


def symmetric(source: ArrayLike, target: ArrayLike, triangles: ArrayLike, t: ArrayLike) -> Array:
    """`interpolate` with E^F, symmetrised: the way back is the same backwards. The first vertex moves linearly.

    Shapes and errors are those of `frobenius`.
    """
    return _each(MESH, (source, target, triangles, t), lambda: (Options(symmetric=True), first_linearly))


def _each(
    inputs: Mapping[str, Shape], arguments: tuple[ArrayLike, ...], settled: Callable[..., tuple[Options, Hold]]
) -> Array:
    """The shapes of a batch; ``settled`` makes options and constraints of the arguments after the time."""

    def prepare(source: Array, target: Array, triangles: Array, *more: Array) -> Callable[[Array], Array]:
        shapes = moving(source, target, triangles, *settled(*more))
        return lambda t: shapes(t[None], 1)[0]

    return each(inputs, arguments, "t", prepare, ("vertices", 2))
