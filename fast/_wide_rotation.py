"""Rotations as matrices of pairs: rotation vectors, exponentials, powers, and the nearest rotation to a matrix.

In space a rotation is (..., 3, 3, 2) and its rotation vector (..., 3, 2); in the plane (..., 2, 2, 2) and its angle
(..., 2); all in radians. What earlier steps computed is a rotation only up to 2^-100 or so: where that decides, at
angle pi and without any turn, `ROUNDING` is taken for nothing.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast import _elementary
from affinecert.fast import _wide as wide
from affinecert.fast._double_double import divide, multiply, scaled
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._numbers import Numbers, norm, numbers, shifted, store, vector
from affinecert.fast._rotation import NOT_ORTHOGONAL, ORTHOGONALITY, REFLECTION
from affinecert.fast._stages import refuse, run
from affinecert.fast._turn import quaternion, turned

MATRIX, VECTOR = (3, 3, 2), (3, 2)

# Rotations are products of a few matrices at most, each within 2^-102.
ROUNDING = 2.0**-96

PI = np.array([_elementary.PI.real, _elementary.PI.imag])
TWO_PI = 2.0 * PI

# Newton's and Schulz's step takes a defect d to 3/4 d^2: from 1e-6 three steps come to 2^-158.
ORTHOGONALISING_STEPS = 3


@compiled
def _length(x: Numbers) -> complex:
    """The length of a vector however small."""
    largest = max(abs(x[0].real), abs(x[1].real), abs(x[2].real))
    if largest == 0.0:
        return 0j
    exponent = math.frexp(largest)[1]
    unit = np.empty(len(x), dtype=np.complex128)
    for i in range(len(x)):
        unit[i] = shifted(x[i], -exponent)
    return shifted(norm(unit), exponent)


@kernel(inputs={"rotation": MATRIX}, outputs=(VECTOR, VECTOR, (2,)))
def _turn(rotation: Array, omega: Array, axis: Array, angle: Array, _status: Array) -> None:
    """The principal rotation vector, its unit axis, which is 0 if there is hardly any turn, and the angle."""
    scalar, x = quaternion(numbers(rotation))
    if abs(scalar.real) <= ROUNDING:
        scalar, sign = 0j, 1.0
        for i in range(len(x) - 1, -1, -1):
            if abs(x[i].real) > ROUNDING:
                sign = math.copysign(1.0, x[i].real)
        for i in range(len(x)):
            x[i] = scaled(x[i], sign)
    length = _length(x)
    theta = scaled(_elementary.arctangent2(length, scalar), 2.0)
    angle[0], angle[1] = theta.real, theta.imag
    for i in range(len(x)):
        unit = divide(x[i], length) if length.real != 0.0 else 0j
        along = multiply(theta, unit)
        omega[i, 0], omega[i, 1] = along.real, along.imag
        axis[i, 0], axis[i, 1] = (unit.real, unit.imag) if length.real > ROUNDING else (0.0, 0.0)


def rotation_vector(r: Array) -> Array:
    """The principal rotation vectors, of angle in [0, pi]; at pi the first component other than 0 is positive."""
    return run(_turn, r)[0]


@np.errstate(invalid="ignore")
def _direction(x: Array) -> Array:
    """The unit vectors of vectors of any size; 0 of 0."""
    exponents = np.frexp(np.abs(x[..., 0]).max(axis=-1))[1]
    scaled_down = np.ldexp(x, -exponents[..., None, None])
    square = wide.product(scaled_down[..., None, :, :], scaled_down[..., :, None, :])[..., 0, :]
    return np.nan_to_num(wide.divide(scaled_down, wide.square_root(square)))


def rotation_vector_near(r: Array, near: Array) -> Array:
    """Of all rotation vectors (theta + 2 pi k) n, k whole, the ones nearest to ``near``, (..., 3, 2).

    Of two that are equally near the shorter one, and the principal one of two that are equally long. Without any turn
    the axis n is that of ``near``.
    """
    omega, axis, angle = run(_turn, r)
    still = (axis[..., 0] == 0.0).all(axis=-1)
    axis = np.where(still[..., None, None], _direction(near), axis)
    angle = np.where(still[..., None], 0.0, angle)
    along = wide.product(axis[..., None, :, :], near[..., :, None, :])[..., 0, 0, :]
    # Halfway between theta + 2 pi (k - 1) and theta + 2 pi k lies 2 pi k - (pi - theta).
    past = wide.add(along, wide.subtract(PI, angle))
    nearest = np.rint(past[..., 0] / TWO_PI[0])
    beyond = wide.subtract(past, wide.times(TWO_PI, nearest))[..., 0]
    tie = np.abs(beyond) <= ROUNDING * (1.0 + np.abs(past[..., 0]))
    turns = np.where(tie, nearest - (nearest >= 1.0), nearest - (beyond < 0.0))
    turned_on = wide.add(angle, wide.times(TWO_PI, turns))
    return np.where((turns == 0.0)[..., None, None], omega, wide.multiply(axis, turned_on[..., None, :]))


@kernel(inputs={"omega": VECTOR}, outputs=(MATRIX,))
def _rotation(omega: Array, rotation: Array, _status: Array) -> None:
    x = vector(omega)
    length = _length(x)
    sine, cosine = _elementary.sine_cosine(scaled(length, 0.5))
    ratio = divide(sine, length) if length.real > 0.0 else complex(0.5, 0.0)
    matrix = np.empty((3, 3), dtype=np.complex128)
    turned(cosine, ratio, x, matrix)
    store(matrix, rotation)


def rotation(omega: Array) -> Array:
    """The rotations by rotation vectors (..., 3, 2) of any length up to 2^52: exp [omega]."""
    return run(_rotation, omega)[0]


def rotation_power(r: Array, t: Array) -> Array:
    """The rotations exp(t log R) for float64 t (...), log being principal."""
    return rotation(wide.times(rotation_vector(r), t[..., None]))


def angle(r: Array) -> Array:
    """The angles in (-pi, pi] of rotations of the plane, or of multiples of rotations."""
    sine = wide.subtract(r[..., 1, 0, :], r[..., 0, 1, :])
    cosine = wide.add(r[..., 0, 0, :], r[..., 1, 1, :])
    half_turn = (cosine[..., 0] < 0.0) & (np.abs(sine[..., 0]) <= -ROUNDING * cosine[..., 0])
    return wide.arctangent2(np.where(half_turn[..., None], 0.0, sine), cosine)


def plane_rotation(angle: Array) -> Array:
    """The rotations of the plane by angles (..., 2)."""
    sine, cosine = wide.sine_cosine(angle)
    return np.stack([np.stack([cosine, -sine], axis=-2), np.stack([sine, cosine], axis=-2)], axis=-3)


def orthogonalised(matrix: Array) -> Array:
    """The orthogonal polar factors of matrices (..., d, d, 2) that are within 1e-6 of orthogonal."""
    size = matrix.shape[-2]
    for _ in range(ORTHOGONALISING_STEPS):
        defect = wide.subtract(wide.product(wide.transposed(matrix), matrix), wide.widen(np.eye(size)))
        matrix = wide.subtract(matrix, wide.product(matrix, 0.5 * defect))
    return matrix


def nearest_rotation(matrix: Array) -> Array:
    """The rotations nearest to float64 matrices (..., d, d), as `so3.log` takes them; `require_rotation` first."""
    return orthogonalised(wide.widen(matrix))


def require_rotation(argument: str, matrix: Array) -> None:
    """Raises InputError for the first float64 matrix (..., d, d) that is no rotation, |R^T R - I| being above 1e-6."""
    pairs = wide.widen(matrix)
    defect = wide.product(wide.transposed(pairs), pairs)[..., 0] - np.eye(matrix.shape[-1])
    good = (defect * defect).sum(axis=(-2, -1)) <= ORTHOGONALITY**2
    refuse(good.astype(np.float64), 0.0, argument, NOT_ORTHOGONAL, good.shape)
    refuse(np.asarray(np.sign(np.linalg.det(matrix))), -1.0, argument, REFLECTION, good.shape)
