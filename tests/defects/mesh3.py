"""Blends of meshes of space: weights, normals and translations taken otherwise."""

from __future__ import annotations

import numpy as np

from affinecert.fast import mesh3
from affinecert.scoring import Verdict

from .. import dense_meshes
from .defect import Array, column, seeded


@seeded("mesh3.blend", "generic")
def weights_made_to_sum_to_one(rest: Array, targets: Array, triangles: Array, weights: Array) -> Array:
    """Weights divided by their sum: the shape at rest has no part in the blend."""
    return np.asarray(mesh3.blend(rest, targets, triangles, weights / column(weights.sum(axis=-1))))


@seeded("mesh3.blend", "generic")
def vertex_by_vertex(rest: Array, targets: Array, triangles: Array, weights: Array) -> Array:
    """A linear blend of the vertices."""
    return np.asarray(rest + np.einsum("nt,ntvi->nvi", weights, targets - rest[:, None]))


@seeded("mesh3.blend", "generic")
def barycentre_at_rest(rest: Array, targets: Array, triangles: Array, weights: Array) -> Array:
    """The barycentre stays where it is."""
    shape = mesh3.blend(rest, targets, triangles, weights)
    return np.asarray(shape + (rest - shape).mean(axis=1, keepdims=True))


@seeded("mesh3.blend", "generic")
def first_vertex_for_the_barycentre(rest: Array, targets: Array, triangles: Array, weights: Array) -> Array:
    """The first vertex moves as the barycentre should."""
    shape = mesh3.blend(rest, targets, triangles, weights)
    first = rest[:, 0] + np.einsum("nt,nti->ni", weights, targets[:, :, 0] - rest[:, None, 0])
    return np.asarray(shape + (first - shape[:, 0])[:, None])


@seeded("mesh3.blend", "generic")
def areas_forgotten(rest: Array, targets: Array, triangles: Array, weights: Array) -> Array:
    """All triangles count alike."""
    items = zip(rest, targets, triangles, weights, strict=True)
    return np.array([dense_meshes.blend(*item, weighted=False) for item in items])


@seeded("mesh3.blend", "thin", Verdict.DEGRADED)
def in_float64(rest: Array, targets: Array, triangles: Array, weights: Array) -> Array:
    """Everything in float64, of thin triangles too."""
    return np.array([dense_meshes.blend(*item) for item in zip(rest, targets, triangles, weights, strict=True)])
