"""Homogeneous matrices in batches, (..., n, n), of float64 or of mpmath's numbers as objects: one code for both."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Poses = NDArray[Any]
Mask = NDArray[np.bool_]


def linear(pose: Poses) -> Poses:
    """The linear parts."""
    return pose[..., :-1, :-1]


def _adjugate(m: Poses) -> Poses:
    """The adjugates of linear parts, of the plane or of space: the inverse times the determinant."""
    if m.shape[-1] == 2:
        rows = [[m[..., 1, 1], -m[..., 0, 1]], [-m[..., 1, 0], m[..., 0, 0]]]
    else:
        first, second, third = m[..., 0, :], m[..., 1, :], m[..., 2, :]
        columns = [_cross(second, third), _cross(third, first), _cross(first, second)]
        return np.stack(columns, axis=-1)
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def _cross(a: Poses, b: Poses) -> Poses:
    """The vector products."""
    pairs = ((1, 2), (2, 0), (0, 1))
    return np.stack([a[..., i] * b[..., j] - a[..., j] * b[..., i] for i, j in pairs], axis=-1)


def determinant(pose: Poses) -> Poses:
    """The determinants of the linear parts."""
    m = linear(pose)
    return np.asarray((m[..., 0, :] * _adjugate(m)[..., :, 0]).sum(axis=-1))


def inverse(pose: Poses) -> Poses:
    """The inverse affine maps."""
    m = linear(pose)
    inverted = _adjugate(m) / determinant(pose)[..., None, None]
    result = pose.copy()
    result[..., :-1, :-1] = inverted
    result[..., :-1, -1] = -(inverted @ pose[..., :-1, -1:])[..., 0]
    return result


def size(matrix: Poses) -> Poses:
    """The Frobenius norms."""
    return np.asarray(np.sqrt((matrix * matrix).sum(axis=(-2, -1))))


def distance(a: Poses, b: Poses) -> Poses:
    """The Frobenius norms of differences, relative to the larger of the two."""
    return np.asarray(size(a - b) / np.maximum(size(a), size(b)))


def unlike_rotation(matrix: Poses, *, scaled: bool = False) -> Poses:
    """How far Q^T Q is from I for linear parts Q; ``scaled``, from a multiple of I."""
    gram = np.swapaxes(matrix, -1, -2) @ matrix
    if scaled:
        gram = gram / (np.trace(gram, axis1=-2, axis2=-1) / gram.shape[-1])[..., None, None]
    return size(gram - np.eye(gram.shape[-1]))
