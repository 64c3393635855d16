"""Rotations of rotation vectors."""

from __future__ import annotations

import math

import numpy as np

from affinecert.scoring import Verdict

from .report import Array, reported
from .sound import cross, exp


@reported(
    "kornia/kornia#3947",
    "axis_angle_to_rotation_matrix returns non-orthogonal matrices: det = 0.9999974535249636 in float64 at every "
    "angle, because eps is added to theta in the axis normalization",
    "so3.exp",
    exp,
)
def axis_shortened(omega: Array) -> Array:
    """The axis is divided by the angle plus 1e-6; below 1e-3 the rotation is I + [omega]x."""
    angle = math.hypot(*omega)
    if angle < 1e-3:
        return np.asarray(np.eye(3) + cross(omega))
    axis = omega / (angle + 1e-6)
    turn = math.sin(angle) * cross(axis)
    return np.asarray(math.cos(angle) * np.eye(3) + turn + (1 - math.cos(angle)) * np.outer(axis, axis))


@reported("JuliaGeometry/Rotations.jl#9", "RodriguesVec -> RotMatrix problems", "so3.exp", exp)
def size_of_the_sine(omega: Array) -> Array:
    """The real part of the quaternion is taken without its sign, so that 2 pi - a turns like 2 pi + a."""
    angle = math.hypot(*omega)
    w, (x, y, z) = abs(math.cos(angle / 2)), math.sin(angle / 2) * omega / angle
    turn = cross(np.array([x, y, z]))
    return np.asarray(np.eye(3) + 2 * w * turn + 2 * turn @ turn)


@reported("leggedrobotics/raisimLib#32", "bug on math::angleAxisToQuaternion", "so3.exp", exp)
def indices_shifted(omega: Array) -> Array:
    """The imaginary part is written one place to the left, over the real one; the last place stays 0."""
    angle = math.hypot(*omega)
    w, x, y = math.sin(angle / 2) * omega / angle
    turn = cross(np.array([x, y, 0.0]))
    return np.asarray(np.eye(3) + 2 * w * turn + 2 * turn @ turn)


@reported("SlimDX/slimdx#239", "Quaternion.RotationAxis does not use normalized axis", "so3.exp", exp)
def axis_not_normalised(omega: Array) -> Array:
    """sin(a/2) multiplies the axis as it comes, here omega, and the quaternion is normalised."""
    angle = math.hypot(*omega)
    q = np.array([math.cos(angle / 2), *(math.sin(angle / 2) * omega)])
    w, vector = q[0] / np.linalg.norm(q), q[1:] / np.linalg.norm(q)
    turn = cross(vector)
    return np.asarray(np.eye(3) + 2 * w * turn + 2 * turn @ turn)


@reported(
    "PhotonVision/photonvision#933", "Incorrect conversion of Rodrigues from OpenCV", "so3.exp", exp, Verdict.NON_FINITE
)
def zero_divided(omega: Array) -> Array:
    """The zero vector, no rotation, is normalised."""
    angle = np.linalg.norm(omega)
    axis = omega / angle
    return np.asarray(np.eye(3) + np.sin(angle) * cross(axis) + (1 - np.cos(angle)) * cross(axis) @ cross(axis))
