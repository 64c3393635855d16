"""Rigid motions: the bugs of V, which takes v to the translation, and of its inverse."""

from __future__ import annotations

import numpy as np

from affinecert.fast import se3, so3
from affinecert.scoring import Verdict

from .defect import Array, block, homogeneous, seeded, skew, times
from .so3 import versine_ratio


def cubic_ratio(angle: Array) -> Array:
    """(θ - sin θ)/θ³, by its series below 1."""
    terms = np.cumprod([np.full_like(angle, 1 / 6)] + [-(angle**2) / (k * (k + 1)) for k in range(4, 22, 2)], axis=0)
    return np.where(angle < 1, np.asarray(np.sum(terms, axis=0)), (angle - np.sin(angle)) / angle**3)


def exp(twist: Array, v_matrix: Array) -> Array:
    """The pose with a given V."""
    return homogeneous(so3.exp(twist[:, :3]), times(v_matrix, twist[:, 3:]))


def angles(twist: Array) -> Array:
    """The rotation angles of twists."""
    return np.asarray(np.linalg.norm(twist[:, :3], axis=-1))


def v(twist: Array) -> Array:
    """V = I + (1 - cos θ)/θ² Ω + (θ - sin θ)/θ³ Ω²."""
    turn, angle = skew(twist[:, :3]), angles(twist)
    return np.asarray(np.eye(3) + block(versine_ratio(angle)) * turn + block(cubic_ratio(angle)) * turn @ turn)


@seeded("se3.exp", "generic")
def cube_for_square(twist: Array) -> Array:
    """V with Ω³ for Ω², as the paper prints it."""
    turn, angle = skew(twist[:, :3]), angles(twist)
    cubic = block(cubic_ratio(angle)) * turn @ turn @ turn
    return exp(twist, np.eye(3) + block(versine_ratio(angle)) * turn + cubic)


@seeded("se3.exp", "near-identity", Verdict.DEGRADED)
def closed_form_to_the_end(twist: Array) -> Array:
    """(1 - cos θ)/θ² by subtraction down to 1e-9."""
    turn, angle = skew(twist[:, :3]), angles(twist)
    first = np.where(angle > 1e-9, (1 - np.cos(angle)) / angle**2, 0.5)
    return exp(twist, np.eye(3) + block(first) * turn + block(cubic_ratio(angle)) * turn @ turn)


@seeded("se3.exp", "generic")
def translation_as_it_is(twist: Array) -> Array:
    """V is forgotten."""
    return exp(twist, np.broadcast_to(np.eye(3), (len(twist), 3, 3)))


@seeded("se3.exp", "generic")
def v_transposed(twist: Array) -> Array:
    """Vᵀ for V."""
    return exp(twist, np.swapaxes(v(twist), -1, -2))


@seeded("se3.exp", "generic")
def translation_first(twist: Array) -> Array:
    """The twist is read as (v, ω)."""
    return np.asarray(se3.exp(np.roll(twist, 3, axis=-1)))


@seeded("se3.log", "generic")
def v_for_its_inverse(pose: Array) -> Array:
    """v = V t."""
    omega = so3.log(pose[:, :3, :3])
    return np.concatenate([omega, times(v(omega), pose[:, :3, 3])], axis=-1)


def log(pose: Array, coefficient: Array) -> Array:
    """The twist with V⁻¹ = I - Ω/2 + coefficient Ω²."""
    omega = so3.log(pose[:, :3, :3])
    turn = skew(omega)
    inverse = np.eye(3) - turn / 2 + block(coefficient) * turn @ turn
    return np.concatenate([omega, times(inverse, pose[:, :3, 3])], axis=-1)


@seeded("se3.log", "near-pi", Verdict.DEGRADED)
def quotient_at_pi(pose: Array) -> Array:
    """1/θ² - (1 + cos θ)/(2 θ sin θ), which is 0/0 at π."""
    angle = np.linalg.norm(so3.log(pose[:, :3, :3]), axis=-1)
    quotient = 1 / angle**2 - (1 + np.cos(angle)) / (2 * angle * np.sin(angle))
    return log(pose, np.where(angle > 0.1, quotient, 1 / 12 + angle**2 / 720 + angle**4 / 30240))


@seeded("se3.log", "generic")
def twelfth_everywhere(pose: Array) -> Array:
    """V⁻¹ = I - Ω/2 + Ω²/12, its series at 0, at every angle."""
    return log(pose, np.full(len(pose), 1 / 12))


@seeded("se3.log", "generic")
def half_forgotten(pose: Array) -> Array:
    """V⁻¹ with Ω for Ω/2."""
    twist = se3.log(pose)
    excess = times(skew(twist[:, :3]), pose[:, :3, 3]) / 2
    return np.concatenate([twist[:, :3], twist[:, 3:] - excess], axis=-1)
