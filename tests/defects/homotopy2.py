"""Homotopies of the plane: rotations whose angle is taken wrongly, and stretches that grow wrongly."""

from __future__ import annotations

import numpy as np

from affinecert.fast import homotopy2, polar, sam
from affinecert.scoring import Verdict

from .defect import Array, block, homogeneous, parts, seeded, trace


def turn(angle: Array) -> Array:
    """The rotations (N, 2, 2) by angles (N,)."""
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.stack([np.stack([cosine, -sine], axis=-1), np.stack([sine, cosine], axis=-1)], axis=-2)


def angle(rotation: Array) -> Array:
    """The angles in (-π, π] of rotations."""
    return np.asarray(np.arctan2(rotation[:, 1, 0], rotation[:, 0, 0]))


def straight(stretch: Array, t: Array) -> Array:
    """(1 - t) I + t S."""
    return np.asarray(block(1 - t) * np.eye(2) + block(t) * stretch)


def grown(stretch: Array, t: Array) -> Array:
    """Sᵗ by eigenvectors."""
    values, vectors = np.linalg.eigh(stretch)
    return np.asarray((vectors * values[:, None] ** block(t)) @ np.swapaxes(vectors, -1, -2))


@seeded("homotopy2.linear", "generic")
def backwards(linear: Array, t: Array) -> Array:
    """t I + (1 - t) A."""
    return straight(linear, 1 - t)


@seeded("homotopy2.linear", "generic")
def identity_forgotten(linear: Array, t: Array) -> Array:
    """t A."""
    return block(t) * linear


@seeded("homotopy2.polar", "generic")
def entry_by_entry(linear: Array, t: Array) -> Array:
    """A^L for A^P."""
    return straight(linear, t)


@seeded("homotopy2.polar", "generic")
def stretch_after_rotation(linear: Array, t: Array) -> Array:
    """((1 - t) I + t S) R for R ((1 - t) I + t S)."""
    rotation, stretch = polar.decompose(linear)
    return np.asarray(straight(stretch, t) @ turn(t * angle(rotation)))


@seeded("homotopy2.polar", "generic")
def angle_without_sign(linear: Array, t: Array) -> Array:
    """θ = arccos(tr R / 2), in [0, π]."""
    rotation, stretch = polar.decompose(linear)
    return np.asarray(turn(t * np.arccos(np.clip(trace(rotation) / 2, -1, 1))) @ straight(stretch, t))


@seeded("homotopy2.polar", "at-pi")
def half_turn_the_other_way(linear: Array, t: Array) -> Array:
    """θ in [-π, π)."""
    rotation, stretch = polar.decompose(linear)
    theta = angle(rotation)
    return np.asarray(turn(t * np.where(theta > 3.14159265, theta - 2 * np.pi, theta)) @ straight(stretch, t))


@seeded("homotopy2.exponential", "generic")
def stretch_in_a_straight_line(linear: Array, t: Array) -> Array:
    """A^P for A^E."""
    return np.asarray(homotopy2.polar(linear, t))


@seeded("homotopy2.exponential", "generic")
def power_of_the_whole(linear: Array, t: Array) -> Array:
    """Aᵗ = exp(t log A), which has no factors."""
    return parts(np.asarray(sam.power(homogeneous(linear, np.zeros((len(linear), 2))), t)))[0]


@seeded("homotopy2.exponential", "similarity", Verdict.NON_FINITE)
def quotient_of_equal_stretches(linear: Array, t: Array) -> Array:
    """(xᵗ - yᵗ) / (x - y), x and y the eigenvalues of S."""
    rotation, stretch = polar.decompose(linear)
    smaller, larger = np.linalg.eigvalsh(stretch).T
    slope = (larger**t - smaller**t) / (larger - smaller)
    power = block(smaller**t) * np.eye(2) + block(slope) * (stretch - block(smaller) * np.eye(2))
    return np.asarray(turn(t * angle(rotation)) @ power)


@seeded("homotopy2.exponential", "thin", Verdict.DEGRADED)
def stretch_by_its_square(linear: Array, t: Array) -> Array:
    """S² = Aᵀ A, whose smaller eigenvalue is lost."""
    rotation, _ = polar.decompose(linear)
    values, vectors = np.linalg.eigh(np.swapaxes(linear, -1, -2) @ linear)
    power = (vectors * np.abs(values[:, None]) ** block(t / 2)) @ np.swapaxes(vectors, -1, -2)
    return np.asarray(turn(t * angle(rotation)) @ power)


@seeded("homotopy2.exponential", "near-pi")
def angle_by_its_tangent(linear: Array, t: Array) -> Array:
    """θ = arctan of a quotient, in [-π/2, π/2]."""
    rotation, stretch = polar.decompose(linear)
    theta = np.arctan(rotation[:, 1, 0] / rotation[:, 0, 0])
    return np.asarray(turn(t * theta) @ grown(stretch, t))
