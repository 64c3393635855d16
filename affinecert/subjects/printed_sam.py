"""Extraction of Affinity Roots as rossignac_vinacua print it (appendix A), in float64: a part of the subject `printed`.

The plane by the paper's algorithm 1; space by splitting off one real eigenvalue, which leaves a plane (A.6). The paper
prints L with a_12 below a_21 (equation 12), against its own equations (13) to (16); here a_12 stands in the first row.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.map import Array


class NoLogarithmError(ValueError):
    """Procedure G3: there is no real logarithm."""


def exists(affine: Array) -> float:
    """Algorithm 1, as far as it says whether A^t exists: all but G3."""
    linear = affine[:-1, :-1]
    if len(linear) == 3:
        linear = _split(linear)[1]
    return float(procedure(linear) != "G3")


def fixed_point(affine: Array) -> Array:
    """The q with (L - 1) q = -t, equation 21."""
    return _solve(affine[:-1, :-1] - np.eye(len(affine) - 1), -affine[:-1, -1])


def log(affine: Array) -> Array:
    """The logarithm (C, v; 0, 0) with C = log L; v = -C q if there is one fixed point q, and by A.4 or A.6 if not."""
    linear, translation = affine[:-1, :-1], affine[:-1, -1]
    generator = np.zeros_like(affine)
    if len(linear) == 2:
        generator[:-1, :-1], generator[:-1, -1] = _plane(linear, translation)
        return generator
    value, plane, basis = _split(linear)
    coordinates = _solve(basis, translation)
    inside = np.zeros((3, 3))
    inside[0, 0] = np.log(value)
    # Along the eigenvector: exponential scaling about the fixed point, or a translation at constant speed.
    moved = coordinates[:1] if value == 1 else inside[0, 0] / (value - 1) * coordinates[:1]
    inside[1:, 1:], rest = _plane(plane, coordinates[1:])
    generator[:-1, :-1] = basis @ inside @ np.linalg.inv(basis)
    generator[:-1, -1] = basis @ np.concatenate([moved, rest])
    return generator


def _solve(matrix: Array, right: Array) -> Array:
    return np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)


def _split(linear: Array) -> tuple[float, Array, Array]:
    """The largest real eigenvalue; L on the plane of the others; and the basis: its eigenvector, then that plane."""
    values, vectors = np.linalg.eig(linear)
    place = int(np.argmax(np.where(values.imag == 0, values.real, -np.inf)))
    value = float(values[place].real)
    left_values, left_vectors = np.linalg.eig(linear.T)
    normal = left_vectors[:, np.argmin(np.abs(left_values - value))].real
    # The invariant plane is orthogonal to the left eigenvector.
    plane = np.linalg.svd(normal[None])[2][1:].T
    basis = np.column_stack([vectors[:, place].real, plane])
    return value, _solve(basis, linear @ basis)[1:, 1:], basis


def _invariants(linear: Array) -> tuple[np.float64, np.float64]:
    """The numbers r = trace / 2 and d = r^2 - det, A.5."""
    r = np.float64(np.trace(linear) / 2)
    return r, np.float64(r * r - (linear[0, 0] * linear[1, 1] - linear[0, 1] * linear[1, 0]))


def procedure(linear: Array) -> str:
    """The case selection of algorithm 1."""
    r, d = _invariants(linear)
    if d < 0:
        return "G1"
    s = np.sqrt(d)
    if r > s:
        return "G2" if r + s != 1 and r - s != 1 else "S1"
    if s == 0 and linear[0, 1] == 0 and linear[1, 0] == 0:
        return "S2"
    return "G3"


def _plane(linear: Array, translation: Array) -> tuple[Array, Array]:
    """C = log L in the plane, and the translation part v of log A."""
    chosen = procedure(linear)
    if chosen == "G3":
        raise NoLogarithmError("no real logarithm (G3)")
    moving = linear - np.eye(2)
    if chosen == "S1":
        return _singular(linear, moving, translation)
    r, d = _invariants(linear)
    if chosen == "S2":
        scale = np.log(-r)
        generator = np.array([[scale, -math.pi], [math.pi, scale]])
    elif chosen == "G1":
        root = np.sqrt(-d)
        # Equation 18 gives tan theta; the quadrant is that of r.
        theta = np.arctan2(root, r)
        generator = _from_parts(linear, np.log(r / np.cos(theta)), theta / root)
    else:
        root = np.sqrt(d)
        chi = r / root
        y = np.log((chi + 1) / (chi - 1)) / 2
        generator = _from_parts(linear, np.log(2 * r / (np.exp(y) + np.exp(-y))), y / root)
    return generator, generator @ _solve(moving, translation)


def _from_parts(linear: Array, x: np.float64, ratio: np.float64) -> Array:
    """C from x (equation 15) and y / sqrt(d): equations 16, 14, 13 and 19, after a_12 has cancelled from them.

    The root in equation 16 is 2 sqrt(d).
    """
    z = (linear[0, 0] - linear[1, 1]) / 2 * ratio
    return np.array([[x + z, linear[0, 1] * ratio], [linear[1, 0] * ratio, x - z]])


def _singular(linear: Array, moving: Array, translation: Array) -> tuple[Array, Array]:
    """S1, where 1 is an eigenvalue: translation, scaling in one direction, or shear (A.4)."""
    other = np.trace(linear) - 1
    if other == 1:
        # L = 1 or a shear: log A ends after the second power, as (L - 1)^2 = 0.
        return moving, translation - moving @ translation / 2
    # The translation along the eigenvector of `other` belongs to the scaling, the rest goes at constant speed.
    scaled = moving @ translation / (other - 1)
    rate = np.log(other) / (other - 1)
    return rate * moving, translation - scaled + rate * scaled
