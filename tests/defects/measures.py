"""Measures: differences in the wrong frame, norms and averages of the wrong thing, formulas as printed."""

from __future__ import annotations

import numpy as np

from affinecert.fast import affine_lie, measures, so3

from .defect import Array, seeded, trace

NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)


def accelerations(steps: Array, points: Array) -> Array:
    """The mean lengths (N,) of second differences that steps (N, k, n, n) make of points (N, m, n - 1)."""
    places = np.concatenate([points, np.ones((*points.shape[:2], 1))], axis=-1)
    moved = places[:, None] @ np.swapaxes(steps, -1, -2)[..., :-1]
    return np.asarray(np.linalg.norm(np.diff(moved, axis=1), axis=-1).mean(axis=(1, 2)) * steps.shape[1] ** 2)


@seeded("measures.average_relative_acceleration", "generic-3d")
def in_the_fixed_frame(poses: Array, points: Array) -> Array:
    """M_(i+1) M_i^-1 for M_i^-1 M_(i+1): the velocity field of space, not that in the moving frame."""
    return accelerations(poses[:, 1:] @ np.linalg.inv(poses[:, :-1]), points)


@seeded("measures.average_relative_acceleration", "generic-2d")
def differences_of_places(poses: Array, points: Array) -> Array:
    """The acceleration of the points in space, without any frame."""
    return accelerations(poses[:, 1:] - poses[:, :-1], points)


@seeded("measures.average_relative_acceleration", "generic-3d")
def one_step_too_many(poses: Array, points: Array) -> Array:
    """The number of poses for that of the steps between them."""
    count = poses.shape[1]
    return np.asarray(measures.average_relative_acceleration(poses, points) * (count / (count - 1)) ** 2)


@seeded("measures.volume", "nearly-flat-3d")
def volume_by_elimination(poses: Array) -> Array:
    """LAPACK's determinant, and its logarithm's exponential: the sign is lost."""
    return np.asarray(np.exp(np.linalg.slogdet(poses[..., :-1, :-1])[1]))


@seeded("measures.volume", "inside-out-2d")
def product_of_singular_values(poses: Array) -> Array:
    """The product of singular values, which are never negative."""
    return np.asarray(np.prod(np.linalg.svd(poses[..., :-1, :-1], compute_uv=False), axis=-1))


@seeded("measures.degeneracy", "generic-2d")
def against_the_first_pose(poses: Array) -> Array:
    """The loss against the first pose, not against the smaller of the ends."""
    volumes = measures.volume(poses)
    return np.asarray(1 - volumes.min(axis=-1) / volumes[:, 0])


@seeded("measures.degeneracy", "inside-out-3d")
def size_of_the_volume(poses: Array) -> Array:
    """The least absolute volume: what is turned inside out is taken for sound."""
    volumes = np.abs(measures.volume(poses))
    return np.asarray(1 - volumes.min(axis=-1) / volumes[:, [0, -1]].min(axis=-1))


def deviations(source: Array, target: Array, times: Array) -> Array:
    """The deviations of all pairs (N, 66)."""
    moved = affine_lie.interpolate_orderings(source[:, None], target[:, None], times)
    corners = np.concatenate([source, np.ones((*source.shape[:2], 1))], axis=-1)
    maps = np.linalg.inv(corners)[:, None, None] @ moved
    apart = maps[:, :, measures.FIRST] - maps[:, :, measures.SECOND]
    return np.asarray(np.linalg.norm(apart, axis=(-2, -1)).max(axis=1))


@seeded("measures.path_deviation", "thin")
def mean_for_median(source: Array, target: Array, times: Array) -> Array:
    """The mean of all pairs."""
    found = deviations(source, target, times)
    return np.stack([found.max(axis=-1), found.mean(axis=-1)], axis=-1)


@seeded("measures.path_deviation", "thin")
def against_the_first_ordering(source: Array, target: Array, times: Array) -> Array:
    """The eleven deviations from the first ordering, not those of all pairs."""
    found = deviations(source, target, times)[:, :11]
    return np.stack([found.max(axis=-1), np.median(found, axis=-1)], axis=-1)


@seeded("measures.rotation_curve_length", "generic")
def as_printed(first: Array, second: Array) -> Array:
    """|b - a|, as if dexp kept lengths."""
    return np.asarray(np.linalg.norm(second - first, axis=-1))


@seeded("measures.rotation_curve_length", "generic")
def angle_between_the_ends(first: Array, second: Array) -> Array:
    """The geodesic from end to end."""
    relative = np.swapaxes(so3.exp(first), -1, -2) @ so3.exp(second)
    return np.asarray(np.arccos(np.clip((trace(relative) - 1) / 2, -1, 1)))


@seeded("measures.rotation_curve_length", "beyond-pi")
def five_nodes(first: Array, second: Array) -> Array:
    """One Gauss rule of five nodes, however long the way is."""
    return quadrature(first, second, 1e-8)


@seeded("measures.rotation_curve_length", "past-the-origin")
def formula_at_the_origin(first: Array, second: Array) -> Array:
    """Next to the origin the quotient by the angle is left out too early."""
    return quadrature(first, second, 1.0)


def quadrature(first: Array, second: Array, small: float) -> Array:
    """The length by one rule, dexp taken for the identity at angles that are small."""
    way = second - first
    total = np.zeros(len(first))
    for node, weight in zip((1 + NODES) / 2, WEIGHTS / 2, strict=True):
        c = first + node * way
        square = np.sum(c * c, axis=-1)
        angle = np.sqrt(square)
        part = (1 - (np.sin(angle / 2) / (angle / 2)) ** 2) / square
        bent = np.sum(way * way, axis=-1) - np.sum(np.cross(c, way) ** 2, axis=-1) * np.where(angle < small, 0, part)
        total += weight * np.sqrt(bent)
    return total
