"""Morphs in a Lie group, by logarithms of poses: see `affinecert.reference.morphs`."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from affinecert.reference import _domain, _ways, affine_lie, sam, sim3
from affinecert.reference._branches import nearest
from affinecert.reference._matrices import Array, Context, array, cross, homogeneous, identity, norm
from affinecert.reference._ways import mixed


def alexa_2002(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """exp((1 - t) log B + t log C), with the logarithms of `sam.log`.

    Alexa, Linear combination of transformations (2002). Raises InputError, besides, if B or C has no real logarithm.
    """
    with _ways.affine(ctx, start, end, t):
        tangents = (
            mixed(first, last, t)
            for first in sam.logarithms(ctx, "start", start)
            for last in sam.logarithms(ctx, "end", end)
        )
        return nearest(ctx, near, (sam.exponential(ctx, tangent) for tangent in tangents))


def lie(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """From B Delta to C Delta as `affine_lie.interpolate_tetrahedra`, Delta the standard simplex 0, e_1, e_2, e_3.

    In the plane the same of its poses in space that leave the third coordinate alone. Half a turn is by +pi from C
    back to B, and so by -pi from B to C. Bansal and Tatu, equation 4.
    """
    with _ways.affine(ctx, start, end, t):
        goal = None if near is None else _tetrahedron(ctx, near)
        solid = affine_lie.interpolate_tetrahedra(ctx, _tetrahedron(ctx, start), _tetrahedron(ctx, end), t, goal)
        size = len(start) - 1
        edges = (solid[1 : size + 1] - solid[0]).T
        return homogeneous(ctx, edges[:size], solid[0, :size])


def sim(ctx: Context, start: Array, end: Array, t: Array, near: Array | None = None) -> Array:
    """exp((1 - t) X + t Y), X = `sim3.log`(B) and Y = `sim3.log_next`(C, X), (4, 4), (4, 4), () -> (4, 4).

    Gallier, Allen-Blanchette and Leonardos, section 5. B and C stand for the similarities of the nearest rotations.
    Raises InputError if one is no similarity to within 1e-6.
    """
    with _ways.affine(ctx, start, end, t):
        _similar(ctx, "start", start)
        _similar(ctx, "end", end)
        tangents = (
            mixed(first, last, t)
            for first in _both_ways_round(ctx, start, sim3.log(ctx, start))
            for last in _both_ways_round(ctx, end, sim3.log_next(ctx, end, first))
        )
        return nearest(ctx, near, (sim3.exp(ctx, tangent) for tangent in tangents))


def _tetrahedron(ctx: Context, pose: Array) -> Array:
    """The image of the standard simplex, vertices in rows, (4, 3); in the plane that of the pose in space."""
    size = len(pose) - 1
    edges, origin = identity(ctx, 3), array([ctx.zero] * 3)
    edges[:size, :size], origin[:size] = pose[:-1, :-1], pose[:-1, -1]
    return np.concatenate([origin[None], edges.T + origin])


def _similar(ctx: Context, name: str, pose: Array) -> None:
    """Refuses a pose that is no similarity."""
    linear = pose[:3, :3]
    _domain.similarity(ctx, name, linear.T @ linear, linear[0] @ cross(linear[1], linear[2]))


def _both_ways_round(ctx: Context, pose: Array, tangent: Array) -> Iterator[Array]:
    """A logarithm of a similarity, and then the one that turns the rest of 2 pi the other way round."""
    yield tangent
    angle = norm(ctx, tangent[:3])
    if angle:
        yield sim3.log_near(ctx, pose, tangent * (1 - 2 * ctx.pi / angle))
