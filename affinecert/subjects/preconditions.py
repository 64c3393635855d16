"""What libraries that take any matrix want of their users: the refusals that adapters make in their stead."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from affinecert.map import Array

OFF_MANIFOLD = 1e-6
"""How far a matrix may be from a rotation in the catalogue's domain."""


def require_rotations(rotation: Array) -> None:
    """Refuse matrices (N, 3, 3) that are no rotations."""
    error = np.linalg.norm(np.swapaxes(rotation, 1, 2) @ rotation - np.eye(3), axis=(1, 2))
    if not np.all(error <= OFF_MANIFOLD) or np.any(np.linalg.det(rotation) <= 0):
        raise ValueError("not a rotation")


def require_affine(affine: Array) -> None:
    """Refuse matrices (N, n, n) that are no orientation-preserving affine maps."""
    size = affine.shape[-1] - 1
    if np.any(affine[:, size] != np.eye(size + 1)[size]) or np.any(np.linalg.slogdet(affine[:, :size, :size])[0] <= 0):
        raise ValueError("not an orientation-preserving affine map")


def require_last_row(pose: Array) -> None:
    """Refuse matrices (N, n, n) that do not end in 0 ... 0 1."""
    if np.any(pose[:, -1] != np.eye(pose.shape[-1])[-1]):
        raise ValueError("not homogeneous: the last row is not 0 ... 0 1")


def require_similarities(pose: Array) -> None:
    """Refuse matrices (N, 4, 4) that are no similarities."""
    require_affine(pose)
    linear = pose[:, :3, :3] / np.max(np.abs(pose[:, :3, :3]), axis=(1, 2), keepdims=True)
    require_rotations(linear * (np.sqrt(3.0) / np.linalg.norm(linear, axis=(1, 2), keepdims=True)))


def require_symmetric(matrix: Array) -> None:
    """Refuse matrices (N, n, n) that are not symmetric."""
    skew = np.linalg.norm(matrix - np.swapaxes(matrix, 1, 2), axis=(1, 2))
    if not np.all(skew <= OFF_MANIFOLD * np.linalg.norm(matrix, axis=(1, 2))):
        raise ValueError("not symmetric")


def require_positive(matrix: Array) -> None:
    """Refuse matrices (N, 3, 3) that are not symmetric, or whose symmetric part is not positive definite."""
    require_symmetric(matrix)
    clear = np.linalg.eigvalsh((matrix + np.swapaxes(matrix, 1, 2)) / 2)
    # Where rounding could make the difference, the leading minors are computed exactly.
    doubtful = ~(clear[:, 0] > 1e-12 * clear[:, -1])
    if not all(positive(item) for item in matrix[doubtful]):
        raise ValueError("not positive definite")


def positive(matrix: Array) -> bool:
    """Whether the symmetric part of a matrix (3, 3) is positive definite, in rational arithmetic."""
    twice = [
        [Fraction(x) + Fraction(y) for x, y in zip(row, column, strict=True)]
        for row, column in zip(matrix, matrix.T, strict=True)
    ]
    (a, b, c), (_, d, e), (_, _, f) = twice
    return a > 0 and a * d > b * b and a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d) > 0


def require_principal(matrix: Array, values: Any) -> Any:
    """The logarithms or powers of matrices (N, n, n); refused if they are complex and an eigenvalue is negative.

    There the principal ones are complex, and no others are promised. Anywhere else a complex value is handed on.
    """
    if np.iscomplexobj(values):
        eigenvalues = np.linalg.eigvals(matrix)
        if np.any((eigenvalues.imag == 0) & (eigenvalues.real < 0)):
            raise ValueError("an eigenvalue is negative")
    return values
