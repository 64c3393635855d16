"""How far a point gets on a spiral: the powers of similarities, as pairs.

A similarity W that moves p by d moves it by g(log z) d under W^t, where g(l) = (e^(t l) - 1) / (e^l - 1) and z is W's
scale along its axis, and as a complex number its scale and turn in the plane across.
"""

from __future__ import annotations

import numpy as np

from affinecert.fast import _wide as wide
from affinecert.fast._double_double import add, divide, multiply, multiply_add, scaled, subtract, times
from affinecert.fast._elementary import exponential, exponential_less_one, sine_cosine
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._stages import run

NUMBER = (2,)


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


@kernel(inputs={"log": NUMBER, "angle": NUMBER, "t": ()}, outputs=(NUMBER, NUMBER))
def _progress(log: Array, angle: Array, t: float, real: Array, imaginary: Array, _status: Array) -> None:
    l, a = complex(log[0], log[1]), complex(angle[0], angle[1])
    x, y = _complex_exponential_less_one(l, a)
    u, v = _complex_exponential_less_one(times(l, t), times(a, t))
    square = multiply_add(x, x, multiply(y, y))
    if square.real > 0.0:
        first = divide(add(multiply(u, x), multiply(v, y)), square)
        second = divide(subtract(multiply(v, x), multiply(u, y)), square)
    else:
        # So small that its square underflows: the quotient is t to the last bit.
        first, second = complex(t, 0.0), 0j
    real[0], real[1] = first.real, first.imag
    imaginary[0], imaginary[1] = second.real, second.imag


def progress(log: Array, angle: Array, t: Array) -> tuple[Array, Array]:
    """Real and imaginary part of (z^t - 1) / (z - 1) for the z of that logarithm of its size and that angle; t at 1."""
    real, imaginary = run(_progress, log, angle, t)
    return real, imaginary


def complex_product(a: tuple[Array, Array], b: tuple[Array, Array]) -> tuple[Array, Array]:
    """The product of complex numbers, each its real and its imaginary part."""
    real = wide.subtract(wide.multiply(a[0], b[0]), wide.multiply(a[1], b[1]))
    return real, wide.add(wide.multiply(a[0], b[1]), wide.multiply(a[1], b[0]))


def spiral(turn: Array, log_ratio: Array, t: Array, way: Array) -> Array:
    """How W^t moves a point that W moves by ``way``, (..., d, 2), W turning by the logarithm ``turn`` and scaling.

    turn (..., 1, 2) in the plane and (..., 3, 2) in space; log_ratio (..., 2), the logarithm of the scale; t (...).
    """
    if turn.shape[-2] == 1:
        grown = progress(log_ratio, turn[..., 0, :], t)
        return np.stack(complex_product(grown, (way[..., 0, :], way[..., 1, :])), axis=-2)
    length, axis = direction(turn)
    along = wide.multiply(axis, _inner(axis, way)[..., None, :])
    across = wide.subtract(way, along)
    real, imaginary = progress(log_ratio, length, t)
    straight, _ = progress(log_ratio, np.zeros_like(length), t)
    parts = ((straight, along), (real, across), (imaginary, _cross(axis, across)))
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
