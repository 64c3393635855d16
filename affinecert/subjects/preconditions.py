"""What libraries that take any matrix want of their users: the refusals that adapters make in their stead."""

from __future__ import annotations

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
