"""How far and how fast a point gets on a spiral: powers and logarithms of similarities, as pairs.

A similarity W that moves p by d moves it by g(log z) d under W^t, where g(l) = (e^(t l) - 1) / (e^l - 1) and z is W's
scale along its axis, and as a complex number its scale and turn in the plane across. The velocity with which it leaves p
is h(log z) d, h(l) = l / (e^l - 1).
"""

from __future__ import annotations

import numpy as np

from affinecert.fast import _wide as wide
from affinecert.fast._double_double import ONE, add, divide, multiply, multiply_add, scaled, subtract, times
from affinecert.fast._elementary import exponential, exponential_less_one, sine_cosine
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._stages import run

NUMBER = (2,)

ComplexNumbers = tuple[Array, Array]
"""Real and imaginary parts, pairs."""


@compiled
def _complex_exponential_less_one(log: complex, angle: complex) -> tuple[complex, complex]:
    """Real and imaginary part of e^(log + i angle) - 1, to the last bits of its size however small that is.

    With E = e^log - 1 it is E - 2 (1 + E) sin^2(angle/2) + i (1 + E) sin(angle).
    """
    less = exponential_less_one(log)
    grown = exponential(log)
    half_sine, half_cosine = sine_cosine(scaled(angle, 0.5))
    real = subtract(less, scaled(multiply(grown, multiply(half_sine, half_sine)), 2.0))
    return real, scaled(multiply(grown, multiply(half_sine, half_cosine)), 2.0)


@compiled
def _quotient(u: complex, v: complex, x: complex, y: complex, square: complex) -> tuple[complex, complex]:
    """The quotient (u + i v) / (x + i y), the square of the divisor's size being given."""
    real = divide(add(multiply(u, x), multiply(v, y)), square)
    return real, divide(subtract(multiply(v, x), multiply(u, y)), square)


@kernel(inputs={"log": NUMBER, "angle": NUMBER, "t": ()}, outputs=(NUMBER, NUMBER, NUMBER, NUMBER))
def _progress(
    log: Array, angle: Array, t: float, real: Array, imaginary: Array, speed: Array, drift: Array, _status: Array
) -> None:
    """Real and imaginary parts of g and of h."""
    a, b = complex(log[0], log[1]), complex(angle[0], angle[1])
    x, y = _complex_exponential_less_one(a, b)
    u, v = _complex_exponential_less_one(times(a, t), times(b, t))
    square = multiply_add(x, x, multiply(y, y))
    # Where the square underflows g is t to the last bit, and h is 1.
    first, second, third, fourth = complex(t, 0.0), 0j, ONE, 0j
    if square.real > 0.0:
        first, second = _quotient(u, v, x, y, square)
        third, fourth = _quotient(a, b, x, y, square)
    real[0], real[1], imaginary[0], imaginary[1] = first.real, first.imag, second.real, second.imag
    speed[0], speed[1], drift[0], drift[1] = third.real, third.imag, fourth.real, fourth.imag


def progress(log: Array, angle: Array, t: Array) -> ComplexNumbers:
    """The quotient (z^t - 1) / (z - 1), z of that logarithm of its size and of that angle; t for z = 1."""
    real, imaginary, _, _ = run(_progress, log, angle, t)
    return real, imaginary


def rate(log: Array, angle: Array) -> ComplexNumbers:
    """The quotient log(z) / (z - 1), z of that logarithm of its size and of that angle; 1 for z = 1."""
    _, _, real, imaginary = run(_progress, log, angle, np.array(0.0))
    return real, imaginary


def complex_product(a: ComplexNumbers, b: ComplexNumbers) -> ComplexNumbers:
    """The product of complex numbers."""
    real = wide.subtract(wide.multiply(a[0], b[0]), wide.multiply(a[1], b[1]))
    return real, wide.add(wide.multiply(a[0], b[1]), wide.multiply(a[1], b[0]))


def spiral(turn: Array, log_ratio: Array, t: Array, way: Array) -> Array:
    """How W^t moves a point that W moves by ``way``, (..., d, 2), W turning by the logarithm ``turn`` and scaling.

    turn (..., 1, 2) in the plane and (..., 3, 2) in space; log_ratio (..., 2), the logarithm of the scale; t (...).
    """
    if turn.shape[-2] == 1:
        grown = progress(log_ratio, turn[..., 0, :], t)
        return np.stack(complex_product(grown, (way[..., 0, :], way[..., 1, :])), axis=-2)
    angle, axis = direction(turn)
    return _about(axis, progress(log_ratio, np.zeros_like(angle), t)[0], progress(log_ratio, angle, t), way)


def velocity(turn: Array, log_ratio: Array, way: Array) -> Array:
    """The velocity v with which W^t moves a point of space that W moves by ``way``, both (..., 3, 2), as in `spiral`."""
    angle, axis = direction(turn)
    return _about(axis, rate(log_ratio, np.zeros_like(angle))[0], rate(log_ratio, angle), way)


def _about(axis: Array, straight: Array, turned: ComplexNumbers, x: Array) -> Array:
    """The vector x times a real number along an axis, and in the plane across times a complex one."""
    along = wide.multiply(axis, _inner(axis, x)[..., None, :])
    across = wide.subtract(x, along)
    parts = ((straight, along), (turned[0], across), (turned[1], _cross(axis, across)))
    first, second, third = (wide.multiply(part, factor[..., None, :]) for factor, part in parts)
    return wide.add(wide.add(first, second), third)


def _inner(a: Array, b: Array) -> Array:
    return wide.product(a[..., None, :, :], b[..., :, None, :])[..., 0, 0, :]


def direction(x: Array) -> tuple[Array, Array]:
    """Length and unit vector; 0 and 0 for a vector without any."""
    exponent = np.frexp(np.abs(x[..., 0]).max(axis=-1))[1]
    unit = np.ldexp(x, -exponent[..., None, None])
    length = wide.square_root(_inner(unit, unit))
    some = length[..., 0] > 0.0
    divisor = np.where(some[..., None], length, 1.0)[..., None, :]
    return np.ldexp(length, exponent[..., None]), np.where(some[..., None, None], wide.divide(unit, divisor), 0.0)


def _cross(a: Array, b: Array) -> Array:
    (a1, a2, a3), (b1, b2, b3) = (np.moveaxis(x, -2, 0) for x in (a, b))
    entries = ((a2, b3, a3, b2), (a3, b1, a1, b3), (a1, b2, a2, b1))
    return np.stack([wide.subtract(wide.multiply(p, q), wide.multiply(r, s)) for p, q, r, s in entries], axis=-2)
