"""Similarities of space and their logarithms (omega, v, lambda) as arrays of pairs, (..., 4, 4, 2) and (..., 7, 2).

With phi(z) = (e^z - 1) / z, the translation V v of the exponential is phi(lambda) v on the axis of omega, and across
it, in a plane of complex numbers, phi(lambda + i theta) v; V^-1 is 1/phi. Source: Gallier, Allen-Blanchette, Leonardos,
Motion interpolation in SIM(3), sections 2 to 5.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from affinecert.fast import _elementary
from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array
from affinecert.fast._rotation import ORTHOGONALITY
from affinecert.fast._stages import require
from affinecert.fast._wide_rotation import TWO_PI, orthogonalised, rotation, rotation_vector
from affinecert.fast.sim3 import LAST_ROW, NOT_POSITIVE, NOT_SIMILAR

Complex = tuple[Array, Array]
"""Real and imaginary parts."""

Jet = Sequence[Array]
"""The value of a curve, its derivative and its second derivative."""

ONE = np.array([1.0, 0.0])
THREE = np.array([3.0, 0.0])
LOG_2 = np.array([_elementary.LOG_2.real, _elementary.LOG_2.imag])

# Below it the series of phi, cut after z^6, errs by less than 2^-140 of phi; above it e^z - 1 loses 20 bits at most.
SMALL = 2.0**-20
COEFFICIENTS = tuple(wide.divide(ONE, wide.widen(np.array(float(math.factorial(k + 1))))) for k in range(7))


def dot(x: Array, y: Array) -> Array:
    """The scalar products of vectors (..., 3, 2)."""
    products = wide.multiply(x, y)
    return wide.add(wide.add(products[..., 0, :], products[..., 1, :]), products[..., 2, :])


def cross(x: Array, y: Array) -> Array:
    """The vector products."""
    first = wide.multiply(x[..., [1, 2, 0], :], y[..., [2, 0, 1], :])
    return wide.subtract(first, wide.multiply(x[..., [2, 0, 1], :], y[..., [1, 2, 0], :]))


def multiple(number: Array, x: Array) -> Array:
    """The products of numbers (..., 2) and vectors (..., k, 2)."""
    return wide.multiply(number[..., None, :], x)


def _total(first: Array, *others: Array) -> Array:
    for other in others:
        first = wide.add(first, other)
    return first


def _complex_product(x: Complex, y: Complex) -> Complex:
    real = wide.subtract(wide.multiply(x[0], y[0]), wide.multiply(x[1], y[1]))
    return real, wide.add(wide.multiply(x[0], y[1]), wide.multiply(x[1], y[0]))


def _by_i(x: Complex) -> Complex:
    return -x[1], x[0]


def _complex_inverse(x: Complex) -> Complex:
    square = wide.add(wide.multiply(x[0], x[0]), wide.multiply(x[1], x[1]))
    return wide.divide(x[0], square), wide.divide(-x[1], square)


def _phi(growth: Array, angle: Array) -> Complex:
    """The numbers phi(z), z = lambda + i theta."""
    z = growth, angle
    scale, (sine, cosine) = wide.exponential(growth), wide.sine_cosine(angle)
    grown = wide.subtract(wide.multiply(scale, cosine), ONE), wide.multiply(scale, sine)
    real, imaginary = _complex_product(grown, _complex_inverse(z))
    small = np.hypot(growth[..., 0], angle[..., 0]) < SMALL
    if small.any():
        real[small], imaginary[small] = _phi_series((growth[small], angle[small]))
    return real, imaginary


def _phi_series(z: Complex) -> Complex:
    series = wide.add(wide.multiply(z[0], COEFFICIENTS[-1]), COEFFICIENTS[-2]), wide.multiply(z[1], COEFFICIENTS[-1])
    for coefficient in reversed(COEFFICIENTS[:-2]):
        product = _complex_product(series, z)
        series = wide.add(product[0], coefficient), product[1]
    return series


def axis_angle(omega: Array) -> tuple[Array, Array]:
    """The unit axes, 0 where there is no angle, and the angles of rotation vectors."""
    angle = wide.square_root(dot(omega, omega))
    still = angle[..., 0] == 0.0
    axis = wide.divide(omega, np.where(still[..., None], ONE, angle)[..., None, :])
    return axis, angle


def _moved(tangent: Array, along: Array, across: Complex) -> Array:
    """The vector v of a tangent with its part on the axis of omega multiplied by one number, that across by another."""
    axis, _ = axis_angle(tangent[..., :3, :])
    v = tangent[..., 3:6, :]
    rest = wide.multiply(wide.subtract(along, across[0]), dot(axis, v))
    return _total(multiple(across[0], v), multiple(across[1], cross(axis, v)), multiple(rest, axis))


def exponential(tangent: Array) -> Array:
    """The similarities of tangents, lambda between -300 and 300."""
    omega, growth = tangent[..., :3, :], tangent[..., 6, :]
    _, angle = axis_angle(omega)
    linear = wide.multiply(rotation(omega), wide.exponential(growth)[..., None, None, :])
    along, _ = _phi(growth, np.zeros_like(growth))
    return wide.homogeneous(linear, _moved(tangent, along, _phi(growth, angle)))


def logarithms(argument: str, poses: Array) -> Array:
    """The principal logarithms of float64 poses (..., keys, 4, 4), (..., keys, 7, 2).

    3 lambda is the logarithm of the determinant, omega the rotation vector of the nearest rotation. Raises InputError
    for the first item (...) with a pose that is no similarity.
    """
    last_row = (poses[..., 3, :] == np.array([0.0, 0.0, 0.0, 1.0])).all(axis=(-2, -1))
    require(argument, np.asarray(last_row), LAST_ROW)
    exponent = np.frexp(np.abs(poses[..., :3, :3]).max(axis=(-2, -1)))[1]
    linear = wide.widen(np.ldexp(poses[..., :3, :3], -exponent[..., None, None]))
    volume = dot(linear[..., 0, :, :], cross(linear[..., 1, :, :], linear[..., 2, :, :]))
    require(argument, np.asarray((volume[..., 0] > 0.0).all(axis=-1)), NOT_POSITIVE)
    third = wide.divide(wide.logarithm(volume), THREE)
    turned = wide.divide(linear, wide.exponential(third)[..., None, None, :])
    defect = wide.product(wide.transposed(turned), turned)[..., 0] - np.eye(3)
    similar = (defect * defect).sum(axis=(-2, -1)) <= ORTHOGONALITY**2
    require(argument, np.asarray(similar.all(axis=-1)), NOT_SIMILAR)
    omega = rotation_vector(orthogonalised(turned))
    growth = wide.add(third, wide.times(LOG_2, exponent.astype(np.float64)))
    still = np.concatenate([omega, wide.widen(poses[..., :3, 3]), growth[..., None, :]], axis=-2)
    _, angle = axis_angle(omega)
    along, _ = _complex_inverse(_phi(growth, np.zeros_like(growth)))
    still[..., 3:6, :] = _moved(still, along, _complex_inverse(_phi(growth, angle)))
    return still


def _products(f: Jet, g: Jet, multiply: Callable[[Array, Array], Array] = wide.multiply) -> list[Array]:
    """The jet of a product, by Leibniz' rule."""
    middle = wide.add(multiply(f[0], g[1]), multiply(f[1], g[0]))
    last = _total(multiply(f[0], g[2]), 2.0 * multiply(f[1], g[1]), multiply(f[2], g[0]))
    return [multiply(f[0], g[0]), middle, last]


def turned_back(tangent: Array) -> Array:
    """The tangents with the same exponentials whose rotation vectors are 2 pi shorter, or turned over."""
    nothing = np.zeros_like(tangent)
    return turned_back_curve((tangent, nothing, nothing))[0]


def turned_back_curve(tangents: Jet) -> list[Array]:
    """The curve of tangents with the same exponentials whose rotation vectors are 2 pi shorter, or turned over.

    Of a curve (omega, v, lambda) with a rotation vector theta n, theta not 0, that is (theta - 2 pi) n with the v'
    for which V' v' = V v. As e^z - 1 is the same on the axis and across it for both, v' is v on the axis, and across it
    (z - 2 pi i) / z v = v - 2 pi w v, z = lambda + i theta, w = i / z, whose derivative is w' = i w^2 z'.
    """
    omega, v = [c[..., :3, :] for c in tangents], [c[..., 3:6, :] for c in tangents]
    growth = [c[..., 6, :] for c in tangents]
    n, angle = _polar(omega)
    w = _complex_inverse((angle[0], -growth[0]))
    square, rate = _complex_product(w, w), (growth[1], angle[1])
    first = _by_i(_complex_product(square, rate))
    bend = _complex_product(square, (growth[2], angle[2]))
    twice = _complex_product(_complex_product(w, first), rate)
    second = _by_i((wide.add(2.0 * twice[0], bend[0]), wide.add(2.0 * twice[1], bend[1])))
    real, imaginary = zip(w, first, second, strict=True)
    part = _products(_products(n, v, dot), n, multiple)
    across = [wide.subtract(x, y) for x, y in zip(v, part, strict=True)]
    lost = zip(_products(real, across, multiple), _products(imaginary, _products(n, v, cross), multiple), strict=True)
    return [
        np.concatenate(
            [
                wide.subtract(turn, wide.multiply(TWO_PI, axis)),
                wide.subtract(move, wide.multiply(TWO_PI, wide.add(*less))),
                grow[..., None, :],
            ],
            axis=-2,
        )
        for turn, axis, move, less, grow in zip(omega, n, v, lost, growth, strict=True)
    ]


def _polar(omega: Jet) -> tuple[list[Array], list[Array]]:
    """The jets of the unit axis and of the angle of a rotation vector that is not 0."""
    axis, angle = axis_angle(omega[0])
    rate = dot(axis, omega[1])
    swing = wide.divide(wide.subtract(omega[1], multiple(rate, axis)), angle[..., None, :])
    change = wide.add(dot(axis, omega[2]), dot(swing, omega[1]))
    rest = wide.subtract(omega[2], wide.add(multiple(change, axis), 2.0 * multiple(rate, swing)))
    return [axis, swing, wide.divide(rest, angle[..., None, :])], [angle, rate, change]
