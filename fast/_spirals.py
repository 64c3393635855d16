"""How far and how fast a point gets on a spiral: powers and logarithms of similarities, as pairs.

A similarity W that moves p by d moves it by g(log z) d under W^t, where g(l) = (e^(t l) - 1) / (e^l - 1) and z is W's
scale along its axis, and as a complex number its scale and turn in the plane across. The velocity at which it leaves p
is h(log z) d, h(l) = l / (e^l - 1).
"""

from __future__ import annotations

import numpy as np

from affinecert.fast import _wide as wide
from affinecert.fast._double_double import ONE, add, divide, multiply, multiply_add, scaled, subtract, times
from affinecert.fast._elementary import exponential, exponential_less_one, sine_cosine
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._stages import run
from affinecert.fast._wide_vectors import cross, direction, inner

NUMBER = (2,)

ComplexNumbers = tuple[Array, Array]
"""Real and imaginary parts, pairs."""

# Below it, as long as t l is below it too, g(l) is t + t (t - 1) l / 2 and h(l) is 1 - l / 2 up to 2^-108.
STRAIGHT = 2.0**-54


@compiled
def _complex_exponential_less_one(log: complex, angle: complex) -> tuple[complex, complex]:
    """Real and imaginary part of e^(log + i angle) - 1, to the last bits of its size however small that is.

    With E = e^log - 1 it is E - 2 (1 + E) sin^2(angle/2) + i (1 + E) sin(angle).
    """
    less, grown = exponential_less_one(log), exponential(log)
    sine, cosine = sine_cosine(scaled(angle, 0.5))
    real = subtract(less, scaled(multiply(grown, multiply(sine, sine)), 2.0))
    return real, scaled(multiply(grown, multiply(sine, cosine)), 2.0)


@compiled
def _quotient(u: complex, v: complex, x: complex, y: complex) -> tuple[complex, complex]:
    """The quotient (u + i v) / (x + i y)."""
    square = multiply_add(x, x, multiply(y, y))
    real = divide(add(multiply(u, x), multiply(v, y)), square)
    return real, divide(subtract(multiply(v, x), multiply(u, y)), square)


@kernel(inputs={"log": NUMBER, "angle": NUMBER, "t": ()}, outputs=(NUMBER, NUMBER, NUMBER, NUMBER))
def _quotients(
    log: Array, angle: Array, t: float, real: Array, imaginary: Array, speed: Array, drift: Array, _status: Array
) -> None:
    """Real and imaginary parts of g and of h."""
    a, b = complex(log[0], log[1]), complex(angle[0], angle[1])
    if max(abs(a.real), abs(b.real)) * max(1.0, abs(t)) < STRAIGHT:
        bend = 0.5 * t * (t - 1.0)
        first, second = add(complex(t, 0.0), times(a, bend)), times(b, bend)
        third, fourth = subtract(ONE, scaled(a, 0.5)), scaled(b, -0.5)
    else:
        x, y = _complex_exponential_less_one(a, b)
        u, v = _complex_exponential_less_one(times(a, t), times(b, t))
        first, second = _quotient(u, v, x, y)
        third, fourth = _quotient(a, b, x, y)
    real[0], real[1], imaginary[0], imaginary[1] = first.real, first.imag, second.real, second.imag
    speed[0], speed[1], drift[0], drift[1] = third.real, third.imag, fourth.real, fourth.imag


def progress(log: Array, angle: Array, t: Array) -> ComplexNumbers:
    """The quotient (z^t - 1) / (z - 1), z of that logarithm of its size and of that angle; t for z = 1."""
    real, imaginary, _, _ = run(_quotients, log, angle, t)
    return real, imaginary


def rate(log: Array, angle: Array) -> ComplexNumbers:
    """The quotient log(z) / (z - 1), z of that logarithm of its size and of that angle; 1 for z = 1."""
    _, _, real, imaginary = run(_quotients, log, angle, np.array(0.0))
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
    """The velocity at which W^t takes off a point of space that W moves by ``way``, (..., 3, 2); W as in `spiral`."""
    angle, axis = direction(turn)
    return _about(axis, rate(log_ratio, np.zeros_like(angle))[0], rate(log_ratio, angle), way)


def _about(axis: Array, straight: Array, turned: ComplexNumbers, x: Array) -> Array:
    """The part of a vector along an axis times a real number, the one across times a complex number."""
    along = wide.multiply(axis, inner(axis, x)[..., None, :])
    across = wide.subtract(x, along)
    parts = ((straight, along), (turned[0], across), (turned[1], cross(axis, across)))
    first, second, third = (wide.multiply(part, factor[..., None, :]) for factor, part in parts)
    return wide.add(wide.add(first, second), third)
