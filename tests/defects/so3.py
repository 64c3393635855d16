"""Rotations: the bugs of Rodrigues' formula and of its inverse."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from affinecert.fast import so3
from affinecert.scoring import Verdict

from .defect import Array, block, column, seeded, skew, trace, unskew

Coefficient = Callable[[Array], Array]


def sine_ratio(angle: Array) -> Array:
    """sin(θ)/θ."""
    return np.asarray(np.sinc(angle / np.pi))


def versine_ratio(angle: Array) -> Array:
    """(1 - cos θ)/θ², by the half angle."""
    return np.asarray(np.sinc(angle / 2 / np.pi) ** 2 / 2)


def exp(omega: Array, first: Coefficient = sine_ratio, second: Coefficient = versine_ratio) -> Array:
    """Rodrigues' formula with the coefficients of Ω and Ω² given."""
    angle = np.linalg.norm(omega, axis=-1)
    turn = skew(omega)
    return np.asarray(np.eye(3) + block(first(angle)) * turn + block(second(angle)) * (turn @ turn))


@seeded("so3.exp", "tiny", Verdict.NON_FINITE)
def sine_over_angle_at_zero(omega: Array) -> Array:
    """sin(θ)/θ is evaluated at θ = 0."""
    return exp(omega, first=lambda angle: np.sin(angle) / angle)


@seeded("so3.exp", "near-identity", Verdict.DEGRADED)
def identity_below_a_millionth(omega: Array) -> Array:
    """Rotations by less than 1e-6 count as none."""
    still = np.linalg.norm(omega, axis=-1) < 1e-6
    return exp(np.where(column(still), 0.0, omega))


@seeded("so3.exp", "near-identity", Verdict.DEGRADED)
def taylor_sign(omega: Array) -> Array:
    """sin(θ)/θ = 1 + θ²/6 below 1e-2."""
    return exp(omega, first=lambda angle: np.where(angle < 1e-2, 1 + angle**2 / 6, sine_ratio(angle)))


@seeded("so3.exp", "near-identity", Verdict.DEGRADED)
def series_of_the_cosine(omega: Array) -> Array:
    """sin(θ)/θ = 1 - θ²/2 below 1e-2."""
    return exp(omega, first=lambda angle: np.where(angle < 1e-2, 1 - angle**2 / 2, sine_ratio(angle)))


@seeded("so3.exp", "near-identity", Verdict.DEGRADED)
def threshold_moved(omega: Array) -> Array:
    """sin(θ)/θ = 1 - θ²/6, good up to 1e-4, is used up to 0.3."""
    return exp(omega, first=lambda angle: np.where(angle < 0.3, 1 - angle**2 / 6, sine_ratio(angle)))


@seeded("so3.exp", "near-identity")
def half_forgotten(omega: Array) -> Array:
    """(1 - cos θ)/θ² = 1 - θ²/24 below 1e-2."""
    return exp(omega, second=lambda angle: np.where(angle < 1e-2, 1 - angle**2 / 24, versine_ratio(angle)))


@seeded("so3.exp", "generic")
def transposed(omega: Array) -> Array:
    """The matrix that acts on rows."""
    return np.swapaxes(exp(omega), -1, -2)


@seeded("so3.exp", "generic")
def float32_inside(omega: Array) -> Array:
    """The rotation vector passes through float32."""
    return exp(omega.astype(np.float32).astype(np.float64))


@seeded("so3.exp", "huge-angle", Verdict.DEGRADED)
def turns_of_nine_digits(omega: Array) -> Array:
    """Whole turns are taken off with 2π rounded to nine digits."""
    angle = column(np.linalg.norm(omega, axis=-1))
    return exp(np.where(angle > np.pi, omega * (np.fmod(angle, 6.28318531) / angle), omega))


@seeded("so3.log", "near-identity", Verdict.NON_FINITE)
def angle_by_acos(rotation: Array) -> Array:
    """θ = acos((tr R - 1)/2), which is flat at 0."""
    angle = np.arccos((trace(rotation) - 1) / 2)
    return column(angle / np.sin(angle)) * unskew(rotation)


@seeded("so3.log", "near-pi")
def axis_by_antisymmetric_part(rotation: Array) -> Array:
    """The angle by atan2, but the axis from R - Rᵀ, which vanishes at π."""
    vector = unskew(rotation)
    sine = np.linalg.norm(vector, axis=-1)
    angle = np.arctan2(sine, (trace(rotation) - 1) / 2)
    return column(np.where(sine > 0, angle / sine, 1.0)) * vector


@seeded("so3.log", "near-pi")
def no_pivot(rotation: Array) -> Array:
    """The quaternion is divided by its real part, never by a larger component."""
    real = np.sqrt(np.maximum(1 + trace(rotation), 0)) / 2
    imaginary = unskew(rotation) / column(2 * real)
    sine = np.linalg.norm(imaginary, axis=-1)
    return column(np.where(sine > 0, 2 * np.arctan2(sine, real) / sine, 2.0)) * imaginary


@seeded("so3.log", "off-manifold", Verdict.DEGRADED)
def no_projection(rotation: Array) -> Array:
    """A rotation that was rounded is not brought back to the manifold first."""
    vector = unskew(rotation)
    sine = np.linalg.norm(vector, axis=-1)
    usual = column(np.arctan2(sine, (trace(rotation) - 1) / 2) / sine) * vector
    return np.where(column(sine > 0.1), usual, so3.log(rotation))


@seeded("so3.log", "generic", Verdict.OTHER_BRANCH)
def off_by_two_pi(rotation: Array) -> Array:
    """The sign of the quaternion is not looked at, so that half of the angles lie beyond π."""
    omega = so3.log(rotation)
    angle = column(np.linalg.norm(omega, axis=-1))
    return np.where((omega[:, :1] < 0) & (angle > 1e-3), omega - omega / angle * (2 * np.pi), omega)


@seeded("so3.log", "at-pi", Verdict.OTHER_BRANCH)
def largest_component_positive(rotation: Array) -> Array:
    """At exactly π the largest component is made positive, not the first."""
    omega = so3.log(rotation)
    largest = np.take_along_axis(omega, column(np.argmax(np.abs(omega), axis=-1)), axis=-1)
    at_pi = np.all(unskew(rotation) == 0, axis=-1)
    return np.where(column(at_pi) & (largest < 0), -omega, omega)


@seeded("so3.log", "near-pi")
def axis_without_sign(rotation: Array) -> Array:
    """Near π the axis comes from R + Rᵀ, and its sign is left as it falls."""
    omega = so3.log(rotation)
    near = column(np.linalg.norm(omega, axis=-1)) > np.pi - 1e-2
    return np.where(near & (omega[:, :1] < 0), -omega, omega)


@seeded("so3.log_near", "generic")
def near_ignored(rotation: Array, near: Array) -> Array:
    """The principal logarithm, always."""
    return np.asarray(so3.log(rotation))


@seeded("so3.log_near", "generic")
def turns_cut_off(rotation: Array, near: Array) -> Array:
    """The turns towards the neighbour are cut off, not rounded."""
    omega = so3.log(rotation)
    angle = np.linalg.norm(omega, axis=-1)
    axis = omega / column(np.where(angle > 0, angle, 1.0))
    turns = np.trunc((np.sum(axis * near, axis=-1) - angle) / (2 * np.pi))
    return np.asarray(omega + column(2 * np.pi * turns) * axis)
