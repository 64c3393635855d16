"""Generators: the matrices whose exponentials are rotations, rigid motions, similarities and elements of G_A.

For libraries that have a general matrix exponential or logarithm: what they are given, and what is read off.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.map import Array

SHEAR_ROWS = (0, 1, 0, 1, 2)
SHEAR_COLUMNS = (1, 1, 2, 2, 2)
"""Where alpha_1 to alpha_5 stand in an element of G_A, [[1, α1, α3], [0, α2, α4], [0, 0, α5]]."""

NEGLIGIBLE = 1e6 * np.finfo(np.float64).eps
"""An imaginary part so small, relative to the largest entry, is rounding; the same for every subject."""


def similar(rotation: Array, translation: Array, growth: Array) -> Array:
    """The matrices (N, 4, 4) [[g I + [omega]x, v], [0, 0]] of vectors (N, 3), (N, 3) and numbers (N,)."""
    x, y, z = rotation.T
    matrix = np.zeros((len(rotation), 4, 4))
    matrix[:, 0, 1], matrix[:, 0, 2], matrix[:, 1, 2] = -z, y, -x
    matrix[:, 1, 0], matrix[:, 2, 0], matrix[:, 2, 1] = z, -y, x
    matrix[:, :3, 3] = translation
    matrix[:, range(3), range(3)] = growth[:, None]
    return matrix


def sheared(shear_twist: Array) -> Array:
    """The matrices (N, 3, 3) [[0, a1, a3], [0, a2, a4], [0, 0, a5]] of vectors (N, 5)."""
    matrix = np.zeros((len(shear_twist), 3, 3))
    matrix[:, SHEAR_ROWS, SHEAR_COLUMNS] = shear_twist
    return matrix


def vector(matrix: Any) -> Any:
    """The vectors (N, 3) omega of matrices (N, n, n) with [omega]x above: half the difference to the transpose."""
    return (
        np.stack(
            [matrix[:, 2, 1] - matrix[:, 1, 2], matrix[:, 0, 2] - matrix[:, 2, 0], matrix[:, 1, 0] - matrix[:, 0, 1]],
            axis=-1,
        )
        / 2
    )


def tangent(logarithm: Any) -> Any:
    """The tangents (N, 7) of the logarithms (N, 4, 4) of similarities."""
    growth = np.trace(logarithm, axis1=1, axis2=2)[:, None] / 3
    return np.concatenate([vector(logarithm), logarithm[:, :3, 3], growth], axis=-1)


def real(matrices: Any) -> Any:
    """The matrices (N, n, n) without imaginary parts that are rounding: real if none is left."""
    sizes = np.max(np.abs(matrices), axis=(1, 2), keepdims=True)
    rounding = np.all(np.abs(matrices.imag) <= NEGLIGIBLE * sizes, axis=(1, 2), keepdims=True)
    cleaned = np.where(rounding, matrices.real, matrices)
    return cleaned if np.any(cleaned.imag) else cleaned.real
