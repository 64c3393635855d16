"""Affine maps of space and tetrahedra as elements (E, A, s) of SE(3) x G_A x G_S, and their interpolation.

T = A S E: E a rigid motion, S the scaling by s, A upper triangular with first column 1 0 0 and positive diagonal.
Everything is computed in double-double arithmetic and rounded once.

Source: Bansal and Tatu, "Affine interpolation in a Lie group framework", 2019.
"""

from __future__ import annotations

from itertools import permutations
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast import _affine_stages as stages
from affinecert.fast import _wide
from affinecert.fast._exact import orientation, orientation_of_vertices
from affinecert.fast._growth import logarithms, powers
from affinecert.fast._kernel import Array, checked
from affinecert.fast._spectrum import PRIMARY
from affinecert.fast._stages import refuse, run, settle

DETERMINANT = "the determinant of the linear part is not positive"
DEGENERATE = "degenerate, or negatively oriented: det[u_1 - u_0, u_2 - u_0, u_3 - u_0] is not positive"
NO_AREA = "degenerate: the triangle has no area"

# The orderings of a tetrahedron's vertices that keep its orientation, in lexicographic order.
ORDERINGS = np.array([order for order in permutations(range(4)) if np.linalg.det(np.eye(4)[list(order)]) > 0])


class Representation(NamedTuple):
    """The factors of T = A S E: ``rigid`` E (..., 4, 4), ``shear`` A (..., 3, 3) and ``scale`` s (...)."""

    rigid: Array
    shear: Array
    scale: Array


class _Frame(NamedTuple):
    """A rotation, an upper triangular matrix of positive diagonal and a vector, in double-doubles."""

    rotation: Array
    upper: Array
    displacement: Array


def _factors(affine: Array) -> _Frame:
    rotation, upper, displacement, sign = stages.factors(affine)
    settle(sign, 0.0, orientation, affine[..., :3, :3])
    refuse(sign, -1.0, "affine", DETERMINANT, sign.shape)
    return _Frame(rotation, upper, displacement)


def _frame(name: str, vertices: Array) -> _Frame:
    rotation, upper, displacement, sign = run(stages.frame, vertices)
    settle(sign, 0.0, orientation_of_vertices, vertices)
    refuse(sign, -1.0, name, DEGENERATE if vertices.shape[-2] == 4 else NO_AREA, sign.shape)
    return _Frame(rotation, upper, displacement)


def _powers(frame: _Frame, t: Array) -> tuple[Array, Array, Array]:
    """The power of the upper triangular matrix, and rotation and translation of the power of the rigid motion."""
    nodes, exponents, turn = run(stages.nodes, frame.upper, frame.rotation)
    log, ratio, setting = run(logarithms, nodes, exponents, np.array(PRIMARY))
    power, quotient = run(powers, exponents, np.array(PRIMARY), log, ratio, setting, t[..., None])
    upper, rotation, displacement = run(stages.grown, frame.upper, turn, frame.displacement, t, log, power, quotient)
    return upper, rotation, displacement


def _represented(frame: _Frame, upper: Array) -> Representation:
    """The factors, rounded, of the affine map of that upper triangular s A and that rigid motion."""
    shear, scale = run(stages.split, upper)
    rigid = np.zeros((*scale.shape, 4, 4))
    rigid[..., :3, :3], rigid[..., :3, 3], rigid[..., 3, 3] = frame.rotation[..., 0], frame.displacement[..., 0], 1.0
    return Representation(rigid, shear, scale)


def decompose(affine: ArrayLike) -> Representation:
    """The one E, A and s with T = A S E (Theorem 1): L = s A R is the RQ factorisation of the linear part.

    affine (..., 4, 4); gives E (..., 4, 4), A (..., 3, 3) and s (...). Raises InputError for a wrong shape or dtype,
    numbers that are not finite, a last row other than 0 0 0 1, and a determinant that is not positive.

    >>> rigid, shear, scale = decompose(np.diag([2.0, 4.0, 6.0, 1.0]))
    >>> shear, scale
    (array([[1., 0., 0.],
           [0., 2., 0.],
           [0., 0., 3.]]), array(2.))
    """
    (matrix,), _, _ = checked({"affine": (4, 4)}, (affine,))
    frame = _factors(matrix)
    return _represented(frame, frame.upper)


def compose(rigid: ArrayLike, shear: ArrayLike, scale: ArrayLike) -> Array:
    """The affine map T = A S E (equation 1).

    rigid E (..., 4, 4), shear A (..., 3, 3) and scale s (...); gives (..., 4, 4). Raises InputError for a wrong shape
    or dtype, numbers that are not finite, an E that is no rigid motion to within 1e-6, an A that is not in G_A, and
    an s that is not positive.
    """
    return stages.composed(rigid, shear, scale)[0]


def interpolate(affine: ArrayLike, t: ArrayLike) -> Array:
    """T_t = exp(t log A) exp(t log S) exp(t log E), where T = A S E (equation 2).

    affine (..., 4, 4) and t (...), any number; gives (..., 4, 4): exactly I at t = 0 and T at t = 1. The logarithm of E
    is the principal one; at angle pi that whose rotation vector has its first component not 0 positive. Raises
    InputError as `decompose` does, and for a t that is not finite.
    """
    (matrix, time), _, _ = checked({"affine": (4, 4), "t": ()}, (affine, t))
    frame = _factors(matrix)
    return run(stages.assembled, matrix, time, *_powers(frame, time))[0]


def represent(tetrahedron: ArrayLike, canonical: ArrayLike) -> Representation:
    """The E, A and s of a tetrahedron, against a canonical one.

    tetrahedron and canonical (..., 4, 3), vertices in rows; gives E (..., 4, 4), A (..., 3, 3), s (...). E brings the
    first vertex to the origin, the first edge to the x axis and the first face into the xy plane. A S E is the affine
    map to the canonical tetrahedron if that is placed so, as the usual (0,0,0), (1,0,0), (1,1,0), (0,0,1) is; any other
    is placed so first (sections 3 and 5.1, equation 7). Raises InputError for a wrong shape or dtype, numbers
    that are not finite, and a tetrahedron of a volume that is not positive.
    """
    inputs = {"tetrahedron": (4, 3), "canonical": (4, 3)}
    (vertices, goal), _, _ = checked(inputs, (tetrahedron, canonical))
    frame = _frame("tetrahedron", vertices)
    (upper,) = run(stages.divided, _frame("canonical", goal).upper, frame.upper)
    return _represented(frame, upper)


def interpolate_tetrahedra(source: ArrayLike, target: ArrayLike, t: ArrayLike) -> Array:
    """The tetrahedron p exp(t log(p^-1 q)), p and q representing the source and the target (equation 4).

    source and target (..., 4, 3), vertices in rows, and t (...), any number; gives (..., 4, 3): exactly the source at
    t = 0 and the target at t = 1. With U_p and U_q the edges that E_p and E_q have aligned, it is E^-1 applied to the
    edges U, E = E_p (E_p^-1 E_q)^t and U = (U_q U_p^-1)^t U_p; the canonical tetrahedron drops out (Theorem 2). Raises
    InputError as `represent` does, and for a t that is not finite.
    """
    return _between(source, target, t, 4)


def interpolate_triangles(source: ArrayLike, target: ArrayLike, t: ArrayLike) -> Array:
    """The triangle between two triangles: `interpolate_tetrahedra` with their unit normals for third edges.

    source and target (..., 3, 3), vertices in rows, and t (...), any number; gives (..., 3, 3). Raises InputError for a
    wrong shape or dtype, numbers that are not finite, and a triangle without area.
    """
    return _between(source, target, t, 3)


def interpolate_orderings(source: ArrayLike, target: ArrayLike, t: ArrayLike) -> Array:
    """`interpolate_tetrahedra` for each of the 12 orderings of the vertices that keep the orientation (section 5.2).

    source and target (..., 4, 3), t (...); gives (..., 12, 4, 3): the orderings in lexicographic order, each result
    given back in the original order of its vertices. Raises InputError as `interpolate_tetrahedra` does.
    """
    arguments = checked({"source": (4, 3), "target": (4, 3), "t": ()}, (source, target, t))[0]
    ordered = _between(*_reordered(*arguments), 4)
    back = np.argsort(ORDERINGS, axis=1)
    return np.take_along_axis(ordered, np.broadcast_to(back[..., None], ordered.shape), axis=-2)


def maps_by_orderings(source: ArrayLike, target: ArrayLike, times: ArrayLike) -> Array:
    """The affine maps from the source to what `interpolate_orderings` makes of it at some times, in double-doubles.

    source and target (..., 4, 3), times (..., times); gives homogeneous matrices of pairs (high, low),
    (..., times, 12, 4, 4, 2). A point x goes to W^-1 (R^-1 U R (x - u) + u - v) for the alignment R of the source, its
    first vertex u, and the powers U and [W v].
    """
    inputs = {"source": (4, 3), "target": (4, 3), "times": ("times",)}
    first, last, moments = _reordered(*checked(inputs, (source, target, times))[0])
    first, last = first[..., None, :, :, :], last[..., None, :, :, :]
    start, end = _frame("source", first), _frame("target", last)
    upper, turn, shift = _powers_between(start, first[..., 0, :], end, last[..., 0, :], moments)
    origin, back = _wide.widen(first[..., 0, :]), _wide.transposed(turn)
    linear = _wide.product(_wide.transposed(start.rotation), _wide.product(upper, start.rotation))
    moved = _wide.subtract(_wide.subtract(origin, shift), _wide.image(linear, origin))
    return _wide.homogeneous(_wide.product(back, linear), _wide.image(back, moved))


def _reordered(first: Array, last: Array, time: Array) -> tuple[Array, Array, Array]:
    """Source and target in each ordering, (..., 12, 4, 3), and the time; refuses what is no tetrahedron."""
    for name, vertices in (("source", first), ("target", last)):
        _frame(name, vertices)
    return first[..., ORDERINGS, :], last[..., ORDERINGS, :], time[..., None]


def interpolate_edges(source: tuple[Array, Array], target: tuple[Array, Array], t: Array) -> tuple[Array, Array]:
    """The edges from the first vertex, and that, of the tetrahedron that `interpolate_tetrahedra` gives between two.

    source and target are each edges in rows (..., 3, 3), of positive determinant, and the first vertex (..., 3).
    """
    (first, origin), (last, goal) = source, target
    first, last = _with_first_vertex(first), _with_first_vertex(last)
    start, end = _frame("source", first), _frame("target", last)
    upper, turn, shift = _powers_between(start, origin, end, goal, t)
    edges = run(stages.carried_vertices, first, last, t, start.upper, start.rotation, upper, turn, np.zeros((3, 2)))[0]
    ends = origin[..., None, :], goal[..., None, :]
    vertex = run(stages.carried_vertices, *ends, t, start.upper, start.rotation, upper, turn, shift)[0]
    return edges[..., 1:, :], vertex[..., 0, :]


def _with_first_vertex(edges: Array) -> Array:
    """The tetrahedra with those edges from a first vertex at the origin."""
    vertices = np.zeros((*edges.shape[:-2], 4, 3))
    vertices[..., 1:, :] = edges
    return vertices


def _powers_between(start: _Frame, origin: Array, end: _Frame, goal: Array, t: Array) -> tuple[Array, Array, Array]:
    """The powers of what takes one alignment to another, each with its first vertex."""
    (ratio,) = run(stages.divided, end.upper, start.upper)
    turn, shift = run(stages.relative, start.rotation, origin, end.rotation, goal)
    return _powers(_Frame(turn, ratio, shift), t)


def _between(source: ArrayLike, target: ArrayLike, t: ArrayLike, count: int) -> Array:
    (first, last, time), _, _ = checked({"source": (count, 3), "target": (count, 3), "t": ()}, (source, target, t))
    start, end = _frame("source", first), _frame("target", last)
    powers_of = _powers_between(start, first[..., 0, :], end, last[..., 0, :], time)
    return run(stages.carried_vertices, first, last, time, start.upper, start.rotation, *powers_of)[0]
