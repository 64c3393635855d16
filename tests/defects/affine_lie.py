"""The representation T = A S E: wrong orders, wrong sides, and parts that are interpolated as if they were numbers."""

from __future__ import annotations

from itertools import permutations

import numpy as np

from affinecert.fast import affine_lie, scale, se3, shear, so3

from .defect import Array, block, column, homogeneous, parts, seeded, times
from .so3 import axis_by_antisymmetric_part

CANONICAL = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1]])
EVEN = [list(order) for order in permutations(range(4)) if round(np.linalg.det(np.eye(4)[list(order)])) == 1]
Representation = tuple[Array, Array, Array]


def triangular_factors(affine: Array) -> Representation:
    """T = A S E by LAPACK's QR of the rows in reverse, with the signs as they come."""
    linear, translation = parts(affine)
    q, r = np.linalg.qr(np.swapaxes(linear[:, ::-1], -1, -2))
    triangle = np.swapaxes(r, -1, -2)[:, ::-1, ::-1]
    rotation = np.swapaxes(q, -1, -2)[:, ::-1]
    size = triangle[:, 0, 0]
    rigid = homogeneous(rotation, np.linalg.solve(triangle, translation[..., None])[..., 0])
    return rigid, triangle / block(size), size


def powers(representation: Representation, t: Array) -> Representation:
    """Each part to the power t."""
    rigid, normal, size = representation
    return (
        np.asarray(se3.exp(column(t) * se3.log(rigid))),
        np.asarray(shear.exp(column(t) * shear.log(normal))),
        np.asarray(scale.exp(t * scale.log(size))),
    )


def vertices(rigid: Array, normal: Array, size: Array) -> Array:
    """The tetrahedra (N, 4, 3) of a representation."""
    inverse = np.linalg.inv(np.asarray(affine_lie.compose(rigid, normal, size)))
    linear, translation = parts(inverse)
    return np.asarray(CANONICAL @ np.swapaxes(linear, -1, -2) + translation[:, None])


@seeded("affine_lie.decompose", "generic")
def qr_for_rq(affine: Array) -> Representation:
    """The rotation on the left of the triangle: T = E S A."""
    linear, translation = parts(affine)
    rotation, triangle = np.linalg.qr(linear)
    signs = np.sign(np.diagonal(triangle, axis1=-2, axis2=-1))
    rotation, triangle = rotation * signs[:, None], triangle * signs[..., None]
    size = triangle[:, 0, 0]
    position = np.linalg.solve(triangle, translation[..., None])[..., 0]
    return homogeneous(rotation, position), triangle / block(size), size


@seeded("affine_lie.decompose", "generic")
def signs_of_lapack(affine: Array) -> Representation:
    """The diagonal of the triangle is not made positive."""
    return triangular_factors(affine)


@seeded("affine_lie.decompose", "generic")
def scale_by_volume(affine: Array) -> Representation:
    """s is the cube root of the determinant, not the first entry of the triangle."""
    rigid, normal, size = affine_lie.decompose(affine)
    volume = np.cbrt(np.linalg.det(affine[:, :3, :3]))
    return rigid, normal * block(size / volume), volume


@seeded("affine_lie.decompose", "generic")
def translation_of_the_whole(affine: Array) -> Representation:
    """E takes the translation of T, which has still to be divided by A S."""
    rigid, normal, size = affine_lie.decompose(affine)
    return homogeneous(rigid[:, :3, :3], affine[:, :3, 3]), normal, size


@seeded("affine_lie.compose", "generic")
def rigid_last(rigid: Array, normal: Array, size: Array) -> Array:
    """E S A for A S E."""
    linear, translation = parts(rigid)
    return homogeneous(block(size) * linear @ normal, translation)


@seeded("affine_lie.compose", "generic")
def translation_not_scaled(rigid: Array, normal: Array, size: Array) -> Array:
    """The translation is sheared, not scaled."""
    linear, translation = parts(rigid)
    return homogeneous(block(size) * normal @ linear, times(normal, translation))


@seeded("affine_lie.interpolate", "generic")
def translation_in_proportion(affine: Array, t: Array) -> Array:
    """The translation of E is multiplied by t, apart from its rotation."""
    rigid, normal, size = powers(affine_lie.decompose(affine), t)
    whole = affine_lie.decompose(affine).rigid
    return np.asarray(affine_lie.compose(homogeneous(rigid[:, :3, :3], column(t) * whole[:, :3, 3]), normal, size))


@seeded("affine_lie.interpolate", "generic")
def scale_in_proportion(affine: Array, t: Array) -> Array:
    """1 - t + t s for s^t."""
    rigid, normal, _ = powers(affine_lie.decompose(affine), t)
    return np.asarray(affine_lie.compose(rigid, normal, 1 - t + t * affine_lie.decompose(affine).scale))


@seeded("affine_lie.interpolate", "generic")
def parts_in_the_wrong_order(affine: Array, t: Array) -> Array:
    """E^t S^t A^t; S commutes, the others do not."""
    rigid, normal, size = powers(affine_lie.decompose(affine), t)
    return rigid_last(rigid, normal, size)  # type: ignore[no-any-return]


@seeded("affine_lie.interpolate", "near-pi")
def rotation_by_antisymmetric_part(affine: Array, t: Array) -> Array:
    """The rotation's logarithm is taken from R - Rᵀ."""
    rigid, normal, size = powers(affine_lie.decompose(affine), t)
    rotation = affine_lie.decompose(affine).rigid[:, :3, :3]
    turned = homogeneous(so3.exp(column(t) * axis_by_antisymmetric_part(rotation)), rigid[:, :3, 3])
    return np.asarray(affine_lie.compose(turned, normal, size))


@seeded("affine_lie.represent", "generic")
def canonical_ignored(tetrahedron: Array, canonical: Array) -> Representation:
    """The standard canonical tetrahedron, whatever is given."""
    rigid, normal, size = affine_lie.represent(tetrahedron, CANONICAL)
    return rigid, normal, size


@seeded("affine_lie.represent", "generic")
def decomposed_as_a_whole(tetrahedron: Array, canonical: Array) -> Representation:
    """The map from the tetrahedron to the canonical one is decomposed; its E depends on the canonical one then."""
    edges = [np.swapaxes(v[:, 1:] - v[:, :1], -1, -2) for v in (tetrahedron, canonical)]
    linear = edges[1] @ np.linalg.inv(edges[0])
    whole = homogeneous(linear, canonical[:, 0] - times(linear, tetrahedron[:, 0]))
    rigid, normal, size = affine_lie.decompose(whole)
    return rigid, normal, size


@seeded("affine_lie.represent", "generic")
def quotient_of_shears_reversed(tetrahedron: Array, canonical: Array) -> Representation:
    """A_p A_Δ⁻¹ for A_Δ⁻¹ A_p."""
    rigid, normal, size = affine_lie.represent(tetrahedron, CANONICAL)
    _, other, unit = affine_lie.represent(canonical, CANONICAL)
    return rigid, normal @ np.linalg.inv(other), size / unit


@seeded("affine_lie.interpolate_tetrahedra", "generic")
def quotient_on_the_other_side(source: Array, target: Array, t: Array) -> Array:
    """p exp(t log q p⁻¹) for p exp(t log p⁻¹ q), in the rigid part."""
    p, q = affine_lie.represent(source, CANONICAL), affine_lie.represent(target, CANONICAL)
    quotient = (q.rigid @ np.linalg.inv(p.rigid), np.linalg.inv(p.shear) @ q.shear, q.scale / p.scale)
    rigid, normal, size = powers(quotient, t)
    return vertices(p.rigid @ rigid, p.shear @ normal, p.scale * size)


@seeded("affine_lie.interpolate_tetrahedra", "generic")
def logarithms_in_proportion(source: Array, target: Array, t: Array) -> Array:
    """exp((1 - t) log p + t log q)."""
    p, q = affine_lie.represent(source, CANONICAL), affine_lie.represent(target, CANONICAL)
    back = column(1 - t)
    return vertices(
        np.asarray(se3.exp(back * se3.log(p.rigid) + column(t) * se3.log(q.rigid))),
        np.asarray(shear.exp(back * shear.log(p.shear) + column(t) * shear.log(q.shear))),
        p.scale ** (1 - t) * q.scale**t,
    )


@seeded("affine_lie.interpolate_triangles", "generic")
def corner_on_a_straight_line(source: Array, target: Array, t: Array) -> Array:
    """The first vertex moves straight, and the edges as they should."""
    moved = np.asarray(affine_lie.interpolate_triangles(source, target, t))
    corner = block(1 - t) * source[:, :1] + block(t) * target[:, :1]
    return np.asarray(moved - moved[:, :1] + corner)


@seeded("affine_lie.interpolate_triangles", "generic")
def edges_in_proportion(source: Array, target: Array, t: Array) -> Array:
    """Every vertex moves straight."""
    return np.asarray(block(1 - t) * source + block(t) * target)


@seeded("affine_lie.interpolate_orderings", "generic")
def left_in_the_new_order(source: Array, target: Array, t: Array) -> Array:
    """The vertices of each interpolant stay in the order in which they were interpolated."""
    results = np.asarray(affine_lie.interpolate_orderings(source, target, t))
    return np.stack([results[:, number, order] for number, order in enumerate(EVEN)], axis=1)


@seeded("affine_lie.interpolate_orderings", "generic")
def permutation_for_its_inverse(source: Array, target: Array, t: Array) -> Array:
    """The order is undone by the permutation, not by its inverse: right for those that are their own inverse."""
    results = np.asarray(affine_lie.interpolate_orderings(source, target, t))
    return np.stack([results[:, number, order][:, order] for number, order in enumerate(EVEN)], axis=1)


@seeded("affine_lie.interpolate_orderings", "generic")
def one_ordering_for_all(source: Array, target: Array, t: Array) -> Array:
    """The first ordering's interpolant, twelve times."""
    return np.repeat(np.asarray(affine_lie.interpolate_tetrahedra(source, target, t))[:, None], 12, axis=1)
