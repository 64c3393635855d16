"""Symmetric matrices: closed forms that divide by gaps of eigenvalues, and eigenvalues clamped or taken by halves."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from affinecert.fast import sym3
from affinecert.scoring import Verdict

from .defect import Array, block, seeded


def symmetric(matrix: Array) -> Array:
    """The symmetric parts."""
    return np.asarray((matrix + np.swapaxes(matrix, -1, -2)) / 2)


def by_eigenvectors(matrix: Array, function: Callable[[Array], Array]) -> Array:
    """A function of symmetric matrices by LAPACK's eigenvectors, its lower triangles being read."""
    values, vectors = np.linalg.eigh(matrix)
    return np.asarray((vectors * function(values)[:, None, :]) @ np.swapaxes(vectors, -1, -2))


def refusing(matrix: Array) -> Array:
    """The matrices, refused as `fast` refuses them."""
    sym3.log(matrix)
    return matrix


@seeded("sym3.exp", "meeting")
def three_lagrange_polynomials(matrix: Array) -> Array:
    """Proposition B.1, which divides by every gap of the eigenvalues."""
    part = symmetric(matrix)
    values = np.linalg.eigvalsh(part)
    total = np.zeros_like(part)
    for i in range(3):
        x, y, z = (values[:, (i + k) % 3] for k in range(3))
        factors = (part - block(y) * np.eye(3)) @ (part - block(z) * np.eye(3))
        total += block(np.exp(x) / ((x - y) * (x - z))) * factors
    return total


@seeded("sym3.exp", "triple", Verdict.DEGRADED)
def second_order_for_small_eigenvalues(matrix: Array) -> Array:
    """The exponential of what is left of the mean as I + Z + Z²/2, where |Z| is below 0.01."""
    part = symmetric(matrix)
    mean = np.trace(part, axis1=-2, axis2=-1) / 3
    rest = part - block(mean) * np.eye(3)
    series = block(np.exp(mean)) * (np.eye(3) + rest + rest @ rest / 2)
    small = np.linalg.norm(rest, axis=(-2, -1)) < 0.01
    return np.where(block(small), series, sym3.exp(matrix))


@seeded("sym3.exp", "generic")
def entry_by_entry(matrix: Array) -> Array:
    """The exponential of each entry."""
    return np.asarray(np.exp(matrix))


@seeded("sym3.exp", "asymmetric", Verdict.DEGRADED)
def lower_triangle(matrix: Array) -> Array:
    """The lower triangle alone counts."""
    return by_eigenvectors(matrix, np.exp)


@seeded("sym3.log", "graded")
def all_at_once(matrix: Array) -> Array:
    """LAPACK's eigenvalues, each with the error of the largest, and none below 0."""
    return by_eigenvectors(refusing(matrix), lambda values: np.log(np.abs(values)))


@seeded("sym3.log", "ill-conditioned", Verdict.DEGRADED)
def clamped(matrix: Array) -> Array:
    """Eigenvalues below 1e-10 are taken as 1e-10."""
    return by_eigenvectors(refusing(matrix), lambda values: np.log(np.maximum(values, 1e-10)))


@seeded("sym3.log", "triple", Verdict.DEGRADED)
def second_order_about_the_mean(matrix: Array) -> Array:
    """log m + X - X²/2, where S = m (I + X) and |X| is below 0.01."""
    part = symmetric(refusing(matrix))
    mean = np.trace(part, axis1=-2, axis2=-1) / 3
    rest = part / block(mean) - np.eye(3)
    small = np.linalg.norm(rest, axis=(-2, -1)) < 0.01
    return np.where(block(small), block(np.log(mean)) * np.eye(3) + rest - rest @ rest / 2, sym3.log(matrix))


@seeded("sym3.log", "outside")
def signs_forgotten(matrix: Array) -> Array:
    """Eigenvalues are taken without their signs."""
    return by_eigenvectors(matrix, lambda values: np.log(np.abs(values) + 1e-300))


@seeded("sym3.power", "generic")
def straight_line(matrix: Array, t: Array) -> Array:
    """(1 - t) I + t S."""
    return np.asarray(block(1 - t) * np.eye(3) + block(t) * matrix)


@seeded("sym3.power", "extrapolation")
def time_clamped(matrix: Array, t: Array) -> Array:
    """The time is kept in [0, 1]."""
    return np.asarray(sym3.power(matrix, np.clip(t, 0.0, 1.0)))


@seeded("sym3.power", "ill-conditioned", Verdict.DEGRADED)
def small_eigenvalues_as_none(matrix: Array, t: Array) -> Array:
    """Eigenvalues below 1e-10 are taken as 0."""
    values, vectors = np.linalg.eigh(refusing(matrix))
    powers = np.where(values < 1e-10, 0.0, np.abs(values) ** t[:, None])
    return np.asarray((vectors * powers[:, None, :]) @ np.swapaxes(vectors, -1, -2))
