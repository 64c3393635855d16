"""Measures of motions: how unsteady one is, how long, what becomes of volume, and how far orderings lead apart."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, pairwise

import numpy as np

from affinecert.errors import InputError
from affinecert.reference import _domain, affine_lie
from affinecert.reference._exact import adjugate, determinant, integers
from affinecert.reference._matrices import Array, Context, Number, array, cross, dot, homogeneous, norm, scalar
from affinecert.reference._precision import closeness, negligible, span
from affinecert.reference._quadrature import gauss_legendre
from affinecert.reference._stumpff import stumpff

# Rotation vectors of at most so many radians, ten turns: nobody interpolates over more, and the time grows with them.
LONGEST = 64


def average_relative_acceleration(ctx: Context, poses: Array, points: Array) -> Array:
    """The mean acceleration of points in the moving frame, (poses, n, n), (points, n - 1) -> ().

    A path is given by its poses M_0, ..., M_k at equal steps of time, 1 in all. In the frame of M_i the point x moves
    by M_i^-1 M_(i+1) x - x during a step: the velocity is k times that, the acceleration k times the difference of two
    successive velocities, and its length is averaged over the points and the k - 1 inner times (Rossignac and Vinacua,
    sections 1 and 2.4). 0 for a steady motion. Raises InputError for fewer than three poses or no point, a
    last row other than 0 ... 0 1, and a determinant that is not positive.
    """
    _path(ctx, poses)
    _domain.finite(ctx, "points", points)
    if len(poses) < 3:
        raise InputError("poses", "shape: at least three are due")
    if not len(points):
        raise InputError("points", "shape: at least one is due")
    steps = len(poses) - 1
    with ctx.extraprec(4 * span(poses[:, :-1], points)):
        places = np.concatenate([points, np.full((len(points), 1), ctx.one)], axis=1)
        moved = [places @ displacement.T for displacement in _displacements(ctx, poses)]
        lengths = [_change(ctx, *both) for before, after in pairwise(moved) for both in zip(before, after, strict=True)]
        return scalar(ctx.fsum(lengths) * steps * steps / len(lengths))


def _displacements(ctx: Context, poses: Array) -> Iterator[Array]:
    """The matrices M_i^-1 M_(i+1) - I without their last row."""
    for pose, following in pairwise(poses):
        yield _inverse(ctx, pose[:-1, :-1]) @ (following - pose)[:-1]


def _change(ctx: Context, before: Array, after: Array) -> Number:
    """The distance of two displacements: nothing, where a steady motion leaves no more than rounding."""
    change = norm(ctx, after - before)
    return ctx.zero if negligible(ctx, change, norm(ctx, before) + norm(ctx, after)) else change


def volume(ctx: Context, poses: Array) -> Array:
    """The signed volumes along a path, the determinants of its poses' linear parts, (poses, n, n) -> (poses,).

    Raises InputError for a last row other than 0 ... 0 1.
    """
    _domain.finite(ctx, "poses", poses)
    for pose in poses:
        _domain.last_row("poses", pose)
    return array([_determinant(ctx, pose) for pose in poses])


def degeneracy(ctx: Context, poses: Array) -> Array:
    """How far a path falls below the volumes of its ends: 1 - min det L_i / min(det L_0, det L_k), (poses, n, n) -> ().

    0 where no pose has less volume than both ends, 1 where one is flat, more where one is turned inside out. Raises
    InputError for no pose, a last row other than 0 ... 0 1, and an end whose determinant is not positive.
    """
    if not len(poses):
        raise InputError("poses", "shape: at least one is due")
    volumes = volume(ctx, poses)
    least = min(volumes[0], volumes[-1])
    if not least > 0:
        raise InputError("poses", "determinant of an end is not positive")
    lowest = min(volumes)
    with ctx.extraprec(closeness(least - lowest, least)):
        return scalar((least - lowest) / least)


def path_deviation(ctx: Context, source: Array, target: Array, times: Array) -> Array:
    """How far the order of a tetrahedron's vertices bends its interpolation, (4, 3), (4, 3), (times,) -> (2,).

    With T_t the affine map from the source to what `affine_lie.interpolate_orderings` makes of it, one for each of the
    twelve orderings, two orderings deviate by the largest Frobenius norm |T_t - T'_t|, as homogeneous matrices, over
    the times; given are the maximum and the median of the 66 pairs (Bansal and Tatu, section 5.2). Raises InputError
    for no time, and for a tetrahedron that is degenerate or negatively oriented.
    """
    _domain.finite(ctx, "times", times)
    if not len(times):
        raise InputError("times", "shape: at least one is due")
    with ctx.extraprec(3 * span(source, target)):
        results = [affine_lie.interpolate_orderings(ctx, source, target, scalar(t)) for t in times]
        paths = np.array([[_affine(ctx, source, vertices) for vertices in result] for result in results])
        pairs = combinations(range(paths.shape[1]), 2)
        deviations = sorted(
            max(norm(ctx, difference.flat) for difference in paths[:, i] - paths[:, j]) for i, j in pairs
        )
        return array([deviations[-1], (deviations[len(deviations) // 2 - 1] + deviations[len(deviations) // 2]) / 2])


def rotation_curve_length(ctx: Context, first: Array, second: Array) -> Array:
    """The length of the curve exp((1 - s) [a]x + s [b]x), s from 0 to 1, in SO(3), (3,), (3,) -> ().

    In the metric <A, B> = tr(A^T B) / 2, in which a turn by an angle is as long as the angle. With c = (1 - s) a + s b
    it is the integral of |dexp_c (b - a)|, where dexp_c = sum_k [c]x^k / (k + 1)!. Gallier, Allen-Blanchette and
    Leonardos print |b - a| (section 10), to which it comes only if a and b are parallel. Raises InputError for a vector
    longer than `LONGEST`.

    As |dexp_c v|^2 = |v|^2 - 2 c_4(|c|^2) |c x v|^2, c_4 Stumpff's function, and c x (b - a) = a x b all along, it is a
    smooth integral of one variable.
    """
    for name, vector in (("first", first), ("second", second)):
        _domain.finite(ctx, name, vector)
        if dot(ctx, vector, vector) > LONGEST**2:
            raise InputError(name, f"longer than {LONGEST} radians")
    difference = second - first
    length = norm(ctx, difference)
    if not length:
        return scalar(ctx.zero)
    direction = difference / length
    start, across = dot(ctx, first, direction), cross(first, direction)
    square = dot(ctx, across, across)
    edges = _edges(ctx, start, start + length, ctx.sqrt(square))
    count = 2 * (ctx.prec // _BITS_A_PAIR) + 2
    nodes = [node for low, high in pairwise(edges) for node in gauss_legendre(ctx, count, low, high)]
    return scalar(ctx.fsum(w * ctx.sqrt(1 - 2 * square * stumpff(ctx, x * x + square)[4]) for x, w in nodes))


# A rule of n nodes on a panel of `_edges` errs by 4.35**(-2n) or less, so two nodes bring 8.4 bits. For truth half of
# the precision is enough: an error that is the same function of the input at every step does no harm to differences.
_BITS_A_PAIR = 20


def _edges(ctx: Context, low: Number, high: Number, distance: Number) -> list[Number]:
    """The edges of panels from low to high, s = 0 the nearest place to the origin of a line at that distance from it.

    The integrand is analytic but at i times about +-2 sin(distance / 2), if the line passes beyond angle pi, and at
    places whose imaginary part is 7 or more. So panels are 4 long, and next to 0 shorter: from x to 3 x. Where singular
    places stand at i x, Bernstein's ellipse for [x, 3 x] is that of |z + sqrt(z^2 - 1)| at z = -2 + i, or 4.35.
    """
    widest = ctx.mpf(4)
    nearest = 2 * abs(ctx.sin(distance / 2)) if distance > 3 else widest
    reach = max(abs(low), abs(high))
    # The kink that is left of singularities nearer than this is as small as their distance squared.
    width = max(nearest, ctx.ldexp(reach, -(ctx.prec // 4)))
    sides = [ctx.zero]
    while sides[-1] < reach:
        sides.append(min(3 * sides[-1] or width, sides[-1] + widest))
    return [low, *sorted(x for side in sides for x in {side, -side} if low < x < high), high]


def _path(ctx: Context, poses: Array) -> None:
    _domain.finite(ctx, "poses", poses)
    for pose in poses:
        _domain.affine(ctx, "poses", pose)


def _determinant(ctx: Context, pose: Array) -> Number:
    numerators, exponent = integers(pose[:-1, :-1])
    return ctx.ldexp(ctx.mpf(determinant(numerators)), exponent * len(numerators))


def _affine(ctx: Context, source: Array, image: Array) -> Array:
    """The affine map from one tetrahedron to another, homogeneous."""
    linear = (_inverse(ctx, source[1:] - source[0]) @ (image[1:] - image[0])).T
    return homogeneous(ctx, linear, image[0] - linear @ source[0])


def _inverse(ctx: Context, matrix: Array) -> Array:
    """The inverse of a matrix, each entry rounded once."""
    numerators, exponent = integers(matrix)
    unit = ctx.ldexp(ctx.one / determinant(numerators), -exponent)
    inverse: Array = array([[ctx.mpf(x) for x in row] for row in adjugate(numerators)]) * unit
    return inverse
