"""Quaternions (w, x, y, z) as pairs, (..., 4, 2)."""

from __future__ import annotations

import numpy as np

from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array
from affinecert.fast._wide_rotation import rotation_vector
from affinecert.fast._wide_vectors import direction

# The product p q is that of the matrix with the entries p[INDEX] SIGN and q.
INDEX = np.array([[0, 1, 2, 3], [1, 0, 3, 2], [2, 3, 0, 1], [3, 2, 1, 0]])
SIGN = np.array([[1.0, -1.0, -1.0, -1.0], [1.0, 1.0, -1.0, 1.0], [1.0, 1.0, 1.0, -1.0], [1.0, -1.0, 1.0, 1.0]])

CONJUGATE = np.array([[1.0], [-1.0], [-1.0], [-1.0]])


def of_rotation(rotation: Array) -> Array:
    """The unit quaternion of a rotation, with w >= 0, and with w = 0 that of the principal rotation vector."""
    angle, axis = direction(rotation_vector(rotation))
    sine, cosine = wide.sine_cosine(0.5 * angle)
    return np.concatenate([cosine[..., None, :], wide.multiply(axis, sine[..., None, :])], axis=-2)


def conjugate(q: Array) -> Array:
    """The conjugate (w, -x, -y, -z)."""
    return np.asarray(q * CONJUGATE)


def product(p: Array, q: Array) -> Array:
    """The quaternion product p q."""
    return wide.product(p[..., INDEX, :] * SIGN[..., None], q[..., None, :])[..., 0, :]


def moved(translation: Array, q: Array) -> Array:
    """The product of a translation (..., 3, 2), as a quaternion, and q."""
    return product(np.concatenate([np.zeros_like(translation[..., :1, :]), translation], axis=-2), q)


def matrix(q: Array) -> Array:
    """The rotation x -> q x q* of a unit quaternion, (..., 3, 3, 2)."""
    unit = np.broadcast_to(wide.widen(np.eye(4)[1:]), (*q.shape[:-2], 3, 4, 2))
    images = product(product(q[..., None, :, :], unit), conjugate(q)[..., None, :, :])
    return np.swapaxes(images[..., 1:, :], -3, -2)
