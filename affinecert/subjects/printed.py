"""The papers' closed forms in float64, as a reader would code them: the prey on which the hunt proves itself.

bansal_tatu, appendix A.2 for SE(3) and G_A; rossignac_vinacua, appendix A for A^t; gallier, Theorem 2.3 and sections 4
and 5 for SIM(3). Nothing is mended numerically: a
quotient stays a quotient, a branch is taken where its condition holds with `==`. Slips of print are corrected, and each
correction is told. Single items, one call each.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import version
from typing import Any

import numpy as np

from affinecert.map import Array
from affinecert.subject import Subject
from affinecert.subjects.printed_sam import exists, fixed_point
from affinecert.subjects.printed_sam import log as sam_log


def cross(omega: Array) -> Array:
    """The matrix Omega with Omega p = omega x p."""
    x, y, z = omega
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def angle_of(generator: Array) -> np.float64:
    """The angle sqrt(-tr(Omega^2) / 2), bansal_tatu A.2.1."""
    return np.float64(np.sqrt(-0.5 * np.trace(generator @ generator)))


def so3_exp(omega: Array) -> Array:
    """Rodrigues' formula, bansal_tatu A.2.1."""
    generator = cross(omega)
    if np.linalg.norm(generator) == 0:
        return np.eye(3)
    theta = angle_of(generator)
    return np.asarray(
        np.eye(3) + np.sin(theta) / theta * generator + (1 - np.cos(theta)) / theta**2 * generator @ generator
    )


def so3_log(rotation: Array) -> Array:
    """The vector of theta / (2 sin theta) (R - R^T) with theta = arccos((tr R - 1) / 2), bansal_tatu A.2.2.

    Both ends are weak: arccos of the trace where theta -> 0, the antisymmetric part where theta -> pi. The identity,
    where the quotient is 0/0, is taken apart, as the paper does for the exponential.
    """
    theta = np.arccos((np.trace(rotation) - 1) / 2)
    if theta == 0:
        return np.zeros(3)
    generator = theta / (2 * np.sin(theta)) * (rotation - rotation.T)
    return np.array([generator[2, 1], generator[0, 2], generator[1, 0]])


def left_jacobian(omega: Array) -> Array:
    """V, with exp (Omega, v; 0, 0) = (exp Omega, V v; 0, 1), bansal_tatu A.2.1 and A.2.2.

    The paper prints the last power as Omega^3 (in A.2.2 R and R^3); the series sum Omega^k / (k + 1)! gives Omega^2.
    """
    generator = cross(omega)
    if np.linalg.norm(generator) == 0:
        return np.eye(3)
    theta = angle_of(generator)
    first = (1 - np.cos(theta)) / theta**2
    second = (theta - np.sin(theta)) / theta**3
    return np.asarray(np.eye(3) + first * generator + second * generator @ generator)


def se3_exp(twist: Array) -> Array:
    """The pose (exp Omega, V v; 0, 1), bansal_tatu A.2.1."""
    pose = np.eye(4)
    pose[:3, :3] = so3_exp(twist[:3])
    pose[:3, 3] = left_jacobian(twist[:3]) @ twist[3:]
    return pose


def se3_log(pose: Array) -> Array:
    """The twist (log R, V^-1 t), bansal_tatu A.2.2."""
    omega = so3_log(pose[:3, :3])
    return np.concatenate([omega, np.linalg.solve(left_jacobian(omega), pose[:3, 3])])


def shear_exp(shear_twist: Array) -> Array:
    """The five branches of bansal_tatu A.2.3, each right as printed."""
    a1, a2, a3, a4, a5 = shear_twist
    if a2 == 0 and a5 != 0:
        e5 = np.exp(a5)
        corner = (a1 * a4 * e5 + a3 * a5 * e5 - a1 * a4 * a5 - a1 * a4 - a3 * a5) / a5**2
        rows = [[1, a1, corner], [0, 1, a4 * (e5 - 1) / a5], [0, 0, e5]]
    elif a5 == 0 and a2 != 0:
        e2 = np.exp(a2)
        corner = (a1 * a4 * e2 - a1 * (1 + a2) * a4 + a2**2 * a3) / a2**2
        rows = [[1, a1 * (e2 - 1) / a2, corner], [0, e2, a4 * (e2 - 1) / a2], [0, 0, 1]]
    elif a2 == 0 and a5 == 0:
        rows = [[1, a1, a3 + a1 * a4 / 2], [0, 1, a4], [0, 0, 1]]
    elif a2 == a5:
        e2 = np.exp(a2)
        corner = (((a1 * a4 + a3) * a2 - a1 * a4) * e2 + a1 * a4 - a2 * a3) / a2**2
        rows = [[1, a1 * (e2 - 1) / a2, corner], [0, e2, a4 * e2], [0, 0, e2]]
    else:
        e2, e5 = np.exp(a2), np.exp(a5)
        mixed = a1 * a4 - a2 * a3
        numerator = -a2 * (mixed + a3 * a5) * e5 + a1 * a4 * a5 * e2 + (a2 - a5) * mixed
        corner = numerator / (a2 * a5 * (a2 - a5))
        rows = [[1, a1 * (e2 - 1) / a2, corner], [0, e2, a4 * (e2 - e5) / (a2 - a5)], [0, 0, e5]]
    return np.array(rows, dtype=np.float64)


def shear_log(shear: Array) -> Array:
    """The five branches of bansal_tatu A.2.4, each right as printed."""
    a1, a2, a3, a4, a5 = shear[(0, 1, 0, 1, 2), (1, 1, 2, 2, 2)]
    l2, l5 = np.log(a2), np.log(a5)
    if a2 == 1 and a5 != 1:
        corner = l5 * (a3 * a5 - a3 + a1 * a4) / (a5 - 1) ** 2 - a1 * a4 / (a5 - 1)
        return np.array([a1, 0, corner, a4 * l5 / (a5 - 1), l5])
    if a5 == 1 and a2 != 1:
        corner = a1 * a4 * l2 / (a2 - 1) ** 2 - (a3 - a2 * a3 + a1 * a4) / (a2 - 1)
        return np.array([a1 * l2 / (a2 - 1), l2, corner, a4 * l2 / (a2 - 1), 0])
    if a2 == a5 == 1:
        return np.array([a1, 0, a3 - a1 * a4 / 2, a4, 0])
    if a2 == a5:
        corner = a3 * l2 / (a2 - 1) + a1 * a4 / (a2 * (a2 - 1)) - a1 * a4 * l2 / (a2 - 1) ** 2
        return np.array([a1 * l2 / (a2 - 1), l2, corner, a4 / a2, l2])
    mixed = a1 * a4 - a2 * a3 + a3 * a5
    corner = a1 * a4 * l2 / ((a2 - a5) * (a2 - 1)) - mixed * l5 / ((a2 - a5) * (a5 - 1))
    return np.array([a1 * l2 / (a2 - 1), l2, corner, a4 * l2 / (a2 - a5) - a4 * l5 / (a2 - a5), l5])


def average(omega: Array, growth: float) -> Array:
    """V, with exp (lambda I + Omega, v; 0, 0) = (e^lambda exp Omega, V v; 0, 1), gallier, Theorem 2.3."""
    generator, square = cross(omega), omega @ omega
    theta, e = np.sqrt(square), np.exp(growth)
    if theta == 0 and growth == 0:
        return np.eye(3)
    if theta == 0:
        return np.asarray((e - 1) / growth * np.eye(3))
    if growth == 0:
        first, second, third = 1.0, (1 - np.cos(theta)) / theta**2, (theta - np.sin(theta)) / theta**3
    else:
        size = growth**2 + theta**2
        first = (e - 1) / growth
        second = (theta * (1 - e * np.cos(theta)) + e * growth * np.sin(theta)) / (theta * size)
        third = (e - 1) / (growth * theta**2) - e * np.sin(theta) / (theta * size)
        third -= growth * (e * np.cos(theta) - 1) / (theta**2 * size)
    return np.asarray(first * np.eye(3) + second * generator + third * generator @ generator)


def sim3_exp(tangent: Array) -> Array:
    """The similarity (e^lambda exp Omega, V v; 0, 1), gallier, Theorem 2.3."""
    pose = np.eye(4)
    pose[:3, :3] = np.exp(tangent[6]) * so3_exp(tangent[:3])
    pose[:3, 3] = average(tangent[:3], tangent[6]) @ tangent[3:6]
    return pose


def turn_and_growth(pose: Array) -> tuple[Array, np.float64]:
    """The principal rotation vector and lambda of a similarity (alpha R, w; 0, 1), gallier, section 4.

    alpha is the cube root of the determinant. Of R = I and of tr R = -1, where R - R^T is 0, the paper makes cases.
    """
    linear = pose[:3, :3]
    scale = np.cbrt(linear[0] @ np.cross(linear[1], linear[2]))
    rotation = linear / scale
    if np.trace(rotation) != -1:
        return so3_log(rotation), np.log(scale)
    squares = (rotation - np.eye(3)) / 2 + np.eye(3)
    row = np.argmax(np.diag(squares))
    axis = squares[row] / np.sqrt(squares[row, row])
    return np.pi * axis * np.sign(axis[np.flatnonzero(axis)[0]]), np.log(scale)


def with_velocity(omega: Array, growth: np.float64, pose: Array) -> Array:
    """The tangent with V v = w, gallier, section 4."""
    return np.concatenate([omega, np.linalg.solve(average(omega, growth), pose[:3, 3]), [growth]])


def sim3_log(pose: Array) -> Array:
    """The principal tangent, gallier, section 4."""
    return with_velocity(*turn_and_growth(pose), pose)


def sim3_log_next(pose: Array, previous: Array) -> Array:
    """Strategy 1 of gallier, section 5: B' or -(2 pi - theta) B' / theta, whichever is nearer to the previous one."""
    omega, growth = turn_and_growth(pose)
    theta = np.linalg.norm(omega)
    if theta != 0:
        other = -(2 * np.pi - theta) * omega / theta
        if np.linalg.norm(other - previous[:3]) < np.linalg.norm(omega - previous[:3]):
            omega = other
    return with_velocity(omega, growth, pose)


def sim3_log_near(pose: Array, near: Array) -> Array:
    """Strategy 2 of gallier, section 5: theta + 2 pi k, k the integer nearest to (c theta' - theta) / 2 pi."""
    omega, growth = turn_and_growth(pose)
    theta = np.linalg.norm(omega)
    length = np.linalg.norm(near[:3])
    if theta == 0 and length == 0:
        return with_velocity(omega, growth, pose)
    axis = omega / theta if theta != 0 else near[:3] / length
    k = np.round((axis @ near[:3] - theta) / (2 * np.pi))
    return with_velocity((theta + 2 * np.pi * k) * axis, growth, pose)


def each(function: Callable[..., Any]) -> Callable[..., Array]:
    """The function of single items as one of batches, by a loop."""

    def loop(*inputs: Array) -> Array:
        return np.stack([np.asarray(function(*item), dtype=np.float64) for item in zip(*inputs, strict=True)])

    return loop


subject = Subject(
    name="printed",
    version=version("affinecert"),
    maps={
        "so3.exp": each(so3_exp),
        "so3.log": each(so3_log),
        "se3.exp": each(se3_exp),
        "se3.log": each(se3_log),
        "sim3.exp": each(sim3_exp),
        "sim3.log": each(sim3_log),
        "sim3.log_next": each(sim3_log_next),
        "sim3.log_near": each(sim3_log_near),
        "shear.exp": each(shear_exp),
        "shear.log": each(shear_log),
        "sam.exists": each(exists),
        "sam.log": each(sam_log),
        "sam.fixed_point": each(fixed_point),
    },
    conventions={
        "all": "column vectors; those of the papers are the catalogue's",
        "scale": "the cube root of the determinant",
        "slips of print": "Omega^2, not Omega^3, in V (bansal_tatu A.2.1); a_12 in row 1 (rossignac_vinacua, eq. 12); "
        "arctangent of two arguments (eq. 18)",
    },
)
