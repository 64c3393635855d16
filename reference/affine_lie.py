"""Affine maps and tetrahedra as elements (E, A, s) of SE(3) x G_A x G_S, and their interpolation (Bansal and Tatu)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import permutations

import numpy as np

from affinecert.errors import InputError
from affinecert.reference import _domain, se3
from affinecert.reference._alignment import align_edges, align_rows, divide, power, split
from affinecert.reference._exact import determinant_sign
from affinecert.reference._matrices import Array, Context, array, cross, homogeneous, norm
from affinecert.reference._precision import span


def _is_even(order: tuple[int, ...]) -> bool:
    return sum(a > b for i, b in enumerate(order) for a in order[:i]) % 2 == 0


# The orderings of a tetrahedron's vertices that keep its orientation, in lexicographic order.
ORDERINGS = tuple(order for order in permutations(range(4)) if _is_even(order))


def decompose(ctx: Context, affine: Array) -> tuple[Array, Array, Array]:
    """The unique E (4, 4), A (3, 3), s () with T = A S E, of an affine map T (4, 4).

    L = s A R is the RQ factorisation of the linear part (Theorem 1). Raises InputError if the last row is not 0 0 0 1
    or det L is not positive.
    """
    _domain.affine(ctx, "affine", affine)
    with ctx.extraprec(3 * span(affine)):
        upper, rotation = align_rows(ctx, affine[:3, :3])
        shear, scale = split(ctx, upper)
        return homogeneous(ctx, rotation, _solve(upper, affine[:3, 3])), shear, scale


def compose(ctx: Context, rigid: Array, shear: Array, scale: Array) -> Array:
    """The affine map T = A S E (4, 4) of E (4, 4), A (3, 3) and s (): equation 1.

    Raises InputError if E is no rigid motion to within 1e-6, A is not in G_A or s is not positive.
    """
    rotation, translation = se3.parts(ctx, "rigid", rigid)
    _domain.rotation(ctx, "rigid", rotation, rotation.T @ rotation)
    _domain.shear(ctx, "shear", shear)
    _domain.finite(ctx, "scale", scale)
    _domain.positive("scale", scale[()])
    with ctx.extraprec(3 * span(rigid, shear, scale)):
        upper = shear * scale[()]
        return homogeneous(ctx, upper @ rotation, upper @ translation)


def interpolate(ctx: Context, affine: Array, t: Array, near: Array | None = None) -> Array:
    """T_t = exp(t log A) exp(t log S) exp(t log E), (4, 4), () -> (4, 4): equation 2; any real t.

    The logarithms are principal, and where the rotation of E is by exactly pi as `so3.log` has it. Given ``near``, of
    the two logarithms of E next to angle pi the one that brings T_t nearer to it: so T_t is continued through pi.
    Raises InputError as `decompose` does.
    """
    _domain.affine(ctx, "affine", affine)
    _domain.finite(ctx, "t", t)
    with ctx.extraprec(3 * span(affine) + 2 * span(t)):
        upper, rotation = align_rows(ctx, affine[:3, :3])
        powers = se3.powers(ctx, rotation, _solve(upper, affine[:3, 3]), t[()])
        upper = power(ctx, upper, t[()])
        return _nearest(ctx, near, (homogeneous(ctx, upper @ r, upper @ d) for r, d in powers))


def represent(ctx: Context, tetrahedron: Array, canonical: Array) -> tuple[Array, Array, Array]:
    """The E (4, 4), A (3, 3), s () of a tetrahedron (4, 3), vertices in rows, against a canonical one (4, 3).

    E brings the first vertex to the origin, the first edge to the x axis and the first face into the xy plane; then
    A S brings it onto the canonical tetrahedron aligned in the same way: T = E_canonical^-1 A S E (section 5.1,
    equation 7). The usual (0,0,0), (1,0,0), (1,1,0), (0,0,1) is aligned already, and T = A S E (section 3). Raises
    InputError if det[u_1 - u_0, u_2 - u_0, u_3 - u_0] of either is not positive.
    """
    with ctx.extraprec(3 * span(tetrahedron, canonical)):
        rotation, upper = _align(ctx, "tetrahedron", tetrahedron)
        _, goal = _align(ctx, "canonical", canonical)
        shear, scale = split(ctx, divide(ctx, goal, upper))
        return homogeneous(ctx, rotation, -(rotation @ tetrahedron[0])), shear, scale


def interpolate_tetrahedra(ctx: Context, source: Array, target: Array, t: Array, near: Array | None = None) -> Array:
    """The tetrahedron p exp(t log p^-1 q) between two, (4, 3), (4, 3), () -> (4, 3): equation 4; any real t.

    With aligned edges U and rigid parts E = [R, -R u_0] of source p and target q, the edges become (U_q U_p^-1)^t U_p
    and the rigid part E_p (E_p^-1 E_q)^t; the canonical tetrahedron drops out (Theorem 2). Logarithms and ``near`` as
    in `interpolate`. Raises InputError if a tetrahedron is degenerate or negatively oriented.
    """
    return _between(ctx, source, target, t, near)


def interpolate_triangles(ctx: Context, source: Array, target: Array, t: Array, near: Array | None = None) -> Array:
    """The triangle between two triangles of space, (3, 3), (3, 3), () -> (3, 3), vertices in rows; any real t.

    It is `interpolate_tetrahedra` with the triangles' unit normals for third edges, without the fourth vertex. Raises
    InputError if a triangle has no area.
    """
    return _between(ctx, source, target, t, near)


def interpolate_orderings(ctx: Context, source: Array, target: Array, t: Array, near: Array | None = None) -> Array:
    """`interpolate_tetrahedra` for each of the 12 even orderings of the vertices, (4, 3), (4, 3), () -> (12, 4, 3).

    In the lexicographic order of the orderings, each tetrahedron given back in the original order of its vertices
    (section 5.2). Raises InputError if a tetrahedron is degenerate or negatively oriented.
    """
    results = np.empty((len(ORDERINGS), 4, 3), dtype=object)
    for k, order in enumerate(map(list, ORDERINGS)):
        goal = None if near is None else near[k][order]
        results[k][order] = _between(ctx, source[order], target[order], t, goal)
    return results


def _continuation(interpolation: Callable[..., Array]) -> Callable[..., Array]:
    """The interpolation with the value near which to stay as first argument."""

    def continued(ctx: Context, base: Array, *inputs: Array) -> Array:
        return interpolation(ctx, *inputs, near=base)

    return continued


continue_interpolate = _continuation(interpolate)
continue_interpolate_tetrahedra = _continuation(interpolate_tetrahedra)
continue_interpolate_triangles = _continuation(interpolate_triangles)
continue_interpolate_orderings = _continuation(interpolate_orderings)


def _between(ctx: Context, source: Array, target: Array, t: Array, near: Array | None) -> Array:
    """The interpolant of two tetrahedra, or of two triangles."""
    _domain.finite(ctx, "t", t)
    with ctx.extraprec(3 * span(source, target) + 2 * span(t)):
        start, start_upper = _align(ctx, "source", source)
        end, end_upper = _align(ctx, "target", target)
        rotation = start.T @ end
        powers = se3.powers(ctx, rotation, source[0] - rotation @ target[0], t[()])
        edges = start.T @ power(ctx, divide(ctx, end_upper, start_upper), t[()]) @ start_upper
        origin = np.zeros((1, 3), dtype=object)
        shape = np.concatenate([origin, edges.T])[: len(source)]
        # The inverse of E_p (r, d) is x -> r^T (R_p^T x + u_0 - d).
        return _nearest(ctx, near, ((shape + (source[0] - d)) @ r for r, d in powers))


def _align(ctx: Context, name: str, vertices: Array) -> tuple[Array, Array]:
    """The alignment of a tetrahedron's or a triangle's edges; refuses what has no positive volume, or no area."""
    _domain.finite(ctx, name, vertices)
    edges = vertices[1:] - vertices[0]
    if len(edges) == 3 and determinant_sign(edges) <= 0:
        raise InputError(name, "degenerate, or negatively oriented: det[u_1 - u_0, u_2 - u_0, u_3 - u_0] <= 0")
    if not any(cross(edges[0], edges[1])):
        raise InputError(name, "degenerate: the triangle has no area")
    return align_edges(ctx, edges)


def _solve(upper: Array, vector: Array) -> Array:
    """The solution x of U x = b for an upper triangular U."""
    z = vector[2] / upper[2, 2]
    y = (vector[1] - upper[1, 2] * z) / upper[1, 1]
    x = (vector[0] - upper[0, 1] * y - upper[0, 2] * z) / upper[0, 0]
    return array([x, y, z])


def _nearest(ctx: Context, near: Array | None, candidates: Iterator[Array]) -> Array:
    """The first candidate; or given ``near``, the one nearest to it."""
    if near is None:
        return next(candidates)
    return min(candidates, key=lambda candidate: norm(ctx, (candidate - near).flat))
