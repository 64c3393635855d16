"""Poses for the checks: affine maps of the plane and of space in short dyadic numbers, and steady morphs of them."""

from __future__ import annotations

from affinecert.properties.claims.definitions import determinant
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import mp
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, homogeneous, identity, scalar


def affines(name: str, count: int, size: int = 2) -> list[Array]:
    """So many affine maps with a real logarithm and a fixed point, (size + 1, size + 1)."""
    drawn = arrays(name, 8 * count, (size, size + 1), -2, 2)
    maps = [homogeneous(mp, each[:, :size], each[:, size]) for each in drawn]
    unit = identity(mp, size)
    turned = [each for each in maps if determinant(each[:-1, :-1]) > 0 and determinant(each[:-1, :-1] - unit) != 0]
    return [each for each in turned if sam.exists(mp, each)][:count]


def controls(name: str, count: int, size: int = 2) -> list[Array]:
    """So many poses about as large and turned alike, so that steady morphs and cascades of them exist."""
    drawn = arrays(name, count, (size, size + 1), -0.375, 0.375)
    unit = identity(mp, size)
    return [homogeneous(mp, unit + each[:, :size], 4 * each[:, size]) for each in drawn]


def congruent(name: str, count: int, most: Number = mp.one) -> list[Array]:
    """So many rigid poses of the plane, turned by angles up to ``most``."""
    drawn = arrays(name, count, (3,), -1, 1)
    poses = []
    for angle, x, y in drawn:
        cosine, sine = mp.cos(most * angle), mp.sin(most * angle)
        poses.append(affine([[cosine, -sine], [sine, cosine]], [2 * x, 2 * y]))
    return poses


def power(m: Context, matrix: Array, t: Number) -> Array:
    """A^t = exp(t log A), the definition that printed forms are held against."""
    return sam.power(m, matrix, scalar(t))


def morph(m: Context, start: Array, end: Array, t: Number) -> Array:
    """SAM(B, t, C) = (C B^-1)^t B."""
    return sam.morph(m, start, end, scalar(t))
