"""Polar factors: by the square of the matrix, by steps that have not arrived, on the wrong side, of reflections."""

from __future__ import annotations

import numpy as np

from affinecert.fast import polar
from affinecert.scoring import Verdict

from .defect import Array, block, seeded

Factors = tuple[Array, Array]


def transposed(matrix: Array) -> Array:
    """The transposed matrices."""
    return np.swapaxes(matrix, -1, -2)


def refusing(linear: Array) -> Array:
    """The matrices, refused as `fast` refuses them."""
    polar.decompose(linear)
    return linear


@seeded("polar.decompose", "nearly-singular-3d", Verdict.DEGRADED)
def by_the_square(linear: Array) -> Factors:
    """S² = LᵀL is formed, which halves the digits, and R = L S⁻¹."""
    values, vectors = np.linalg.eigh(transposed(refusing(linear)) @ linear)
    roots = np.sqrt(np.abs(values))[:, None, :]
    inverse = (vectors / np.maximum(roots, 1e-150)) @ transposed(vectors)
    return linear @ inverse, (vectors * roots) @ transposed(vectors)


@seeded("polar.decompose", "nearly-singular-3d")
def ten_unscaled_steps(linear: Array) -> Factors:
    """Newton's (R + R⁻ᵀ)/2, ten times: it halves the way from a small singular value to 1 a step."""
    rotation = refusing(linear)
    for _ in range(10):
        rotation = (rotation + transposed(np.linalg.inv(rotation))) / 2
    stretch = transposed(rotation) @ linear
    return rotation, (stretch + transposed(stretch)) / 2


@seeded("polar.decompose", "generic-3d")
def stretch_on_the_left(linear: Array) -> Factors:
    """The S of L = S R."""
    rotation, _ = polar.decompose(linear)
    return rotation, linear @ transposed(rotation)


@seeded("polar.decompose", "outside-3d")
def reflections_too(linear: Array) -> Factors:
    """U Vᵀ of the singular value decomposition, whatever its determinant."""
    u, values, v = np.linalg.svd(linear)
    return u @ v, (transposed(v) * values[:, None, :]) @ v


@seeded("polar.decompose", "rotation-2d")
def arctangent_of_a_quotient(linear: Array) -> Factors:
    """The angle of the plane as an arctangent in (-pi/2, pi/2)."""
    refusing(linear)
    with np.errstate(divide="ignore"):
        angle = np.arctan((linear[:, 1, 0] - linear[:, 0, 1]) / (linear[:, 0, 0] + linear[:, 1, 1]))
    rotation = np.stack([np.cos(angle), -np.sin(angle), np.sin(angle), np.cos(angle)], axis=-1).reshape(-1, 2, 2)
    return rotation, transposed(rotation) @ linear


@seeded("polar.decompose", "huge-or-tiny-3d", Verdict.NON_FINITE)
def norm_by_squares(linear: Array) -> Factors:
    """The scale that is divided out first is a sum of squares, which overflows."""
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        scale = block(np.sqrt(np.sum(refusing(linear) ** 2 * 1e200, axis=(-2, -1))) / 1e100)
        u, values, v = np.linalg.svd(np.nan_to_num(linear / scale, posinf=1.0, neginf=-1.0))
        return u @ v, scale * ((transposed(v) * values[:, None, :]) @ v)
