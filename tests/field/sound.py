"""The repaired formulas that the reports share, for one item: rotation vectors, rigid motions, similarities, arcs."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from .report import Array

ROUNDING = 1e-14
"""A matrix that is orthogonal up to this much is taken as it is: to project it would only add rounding."""


def cross(omega: Array) -> Array:
    """The matrix [omega]x."""
    x, y, z = omega
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def vee(matrix: Array) -> Array:
    """The vector of M - M^T: 2 sin(angle) times the axis, of a rotation."""
    return np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]])


def factors(linear: Array) -> tuple[Array, Array]:
    """The polar factors R and S; refuses what is singular or inside out."""
    if np.linalg.slogdet(linear)[0] <= 0:
        raise ValueError("the determinant is not positive")
    left, values, right = np.linalg.svd(linear)
    return left @ right, right.T @ np.diag(values) @ right


def proper(matrix: Array) -> Array:
    """The nearest rotation, by Newton's steps, which keep small entries to their last digits; refuses reflections."""
    defect = np.linalg.norm(matrix.T @ matrix - np.eye(3))
    if defect > 1e-6 or np.linalg.det(matrix) < 0:
        raise ValueError("not a rotation")
    if defect <= ROUNDING:
        return matrix
    for _ in range(2):
        matrix = matrix @ (3 * np.eye(3) - matrix.T @ matrix) / 2
    return matrix


def quaternion(rotation: Array) -> Array:
    """The quaternion (w, x, y, z), from the largest of four columns; its pivot is positive, w perhaps is not."""
    (a, b, c), (d, e, f), (g, h, i) = rotation
    columns = np.array(
        [
            [1 + a + e + i, h - f, c - g, d - b],
            [h - f, 1 + a - e - i, b + d, c + g],
            [c - g, b + d, 1 - a + e - i, f + h],
            [d - b, c + g, f + h, 1 - a - e + i],
        ]
    )
    pivot = columns[np.argmax(np.diag(columns))]
    return np.asarray(pivot / np.linalg.norm(pivot))


def shortest(quaternion: Array) -> Array:
    """The rotation vector of at most pi of q or -q: the angle by atan2, at exactly pi the first component positive."""
    w, vector = quaternion[0], quaternion[1:]
    sine = math.hypot(*vector)
    if sine == 0:
        return np.zeros(3)
    sign = math.copysign(1.0, w if w != 0 else next(x for x in vector if x != 0))
    return np.asarray(sign * 2 * math.atan2(sine, abs(w)) / sine * vector)


def log(matrix: Array) -> Array:
    """The rotation vector: nearest rotation, largest pivot, atan2."""
    return shortest(quaternion(proper(matrix)))


def sine_ratio(angle: float) -> float:
    """sin(a)/a."""
    return math.sin(angle) / angle if angle else 1.0


def versine_ratio(angle: float) -> float:
    """(1 - cos a)/a^2, by the half angle."""
    return sine_ratio(angle / 2) ** 2 / 2


def cubic_ratio(angle: float) -> float:
    """(a - sin a)/a^3, by its series where that cancels."""
    return 1 / 6 - angle**2 / 120 + angle**4 / 5040 if angle < 1e-2 else (angle - math.sin(angle)) / angle**3


def cotangent_ratio(angle: float) -> float:
    """(1 - (a/2) cot(a/2))/a^2, by its series where that cancels."""
    if angle < 1e-2:
        return 1 / 12 + angle**2 / 720 + angle**4 / 30240
    return (1 - angle / 2 / math.tan(angle / 2)) / angle**2


def exp(
    omega: Array,
    first: Callable[[float], float] = sine_ratio,
    second: Callable[[float], float] = versine_ratio,
) -> Array:
    """Rodrigues' formula, with these coefficients of [omega]x and of its square."""
    angle, turn = math.hypot(*omega), cross(omega)
    return np.asarray(np.eye(3) + first(angle) * turn + second(angle) * (turn @ turn))


def pose(linear: Array, translation: Array) -> Array:
    """The homogeneous matrix."""
    matrix = np.eye(len(linear) + 1)
    matrix[:-1, :-1], matrix[:-1, -1] = linear, translation
    return matrix


def se3_exp(twist: Array) -> Array:
    """The rigid motion of (omega, v)."""
    omega, v = twist[:3], twist[3:]
    return pose(exp(omega), exp(omega, versine_ratio, cubic_ratio) @ v)


def se3_log(matrix: Array) -> Array:
    """The twist (omega, v) of a rigid motion."""
    omega, translation = log(matrix[:3, :3]), matrix[:3, 3]
    return np.concatenate([omega, unwound(omega, translation)])


def unwound(omega: Array, translation: Array) -> Array:
    """The v that the turn by omega carries to the translation."""
    turned = np.cross(omega, translation)
    return np.asarray(translation - turned / 2 + cotangent_ratio(math.hypot(*omega)) * np.cross(omega, turned))


def winding(omega: Array, growth: float) -> tuple[float, complex]:
    """The eigenvalues of V of a similarity: along the axis (e^g - 1)/g, across it (e^z - 1)/z, z = g + i angle."""
    across = complex(growth, math.hypot(*omega))
    along = math.expm1(growth) / growth if growth else 1.0
    return along, complex(np.expm1(across) / across) if across else 1.0


def spread(omega: Array, along: float, across: complex, vector: Array) -> Array:
    """The matrix with these eigenvalues along and across omega, applied to a vector."""
    angle = math.hypot(*omega)
    axis = omega / angle if angle else np.zeros(3)
    part = axis * (axis @ vector)
    return np.asarray(along * part + across.real * (vector - part) + across.imag * np.cross(axis, vector))


def sim3_exp(tangent: Array) -> Array:
    """The similarity of (omega, v, growth), turn and growth coupled."""
    omega, v, growth = tangent[:3], tangent[3:6], float(tangent[6])
    return pose(math.exp(growth) * exp(omega), spread(omega, *winding(omega, growth), v))


def sim3_log(matrix: Array) -> Array:
    """The tangent (omega, v, growth) of a similarity."""
    growth = float(np.log(np.linalg.det(matrix[:3, :3])) / 3)
    omega = log(matrix[:3, :3] / math.exp(growth))
    along, across = winding(omega, growth)
    return np.concatenate([omega, spread(omega, 1 / along, 1 / across, matrix[:3, 3]), [growth]])


def slerp(start: Array, end: Array, t: float) -> Array:
    """The shorter great arc: normalised first, the angle by atan2, and no division where the ends are one."""
    p, q = start / np.linalg.norm(start), end / np.linalg.norm(end)
    q = -q if start @ end < 0 else q
    angle = 2 * math.atan2(np.linalg.norm(p - q), np.linalg.norm(p + q))
    if angle == 0:
        return np.asarray(p)
    return np.asarray((math.sin((1 - t) * angle) * p + math.sin(t * angle) * q) / math.sin(angle))


def sclerp(start: Array, end: Array, t: float) -> Array:
    """B exp(t log(B^-1 C))."""
    first, last = proper(start[:3, :3]), proper(end[:3, :3])
    step = pose(first.T @ last, first.T @ (end[:3, 3] - start[:3, 3]))
    return np.asarray(pose(first, start[:3, 3]) @ se3_exp(t * se3_log(step)))
