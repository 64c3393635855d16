"""Complex numbers whose two parts are double-doubles, for kernels: pairs (real part, imaginary part)."""

from __future__ import annotations

from affinecert.fast import _double_double as real
from affinecert.fast._double_double import exact_sum
from affinecert.fast._kernel import Array, compiled

Complex = tuple[complex, complex]


@compiled
def add(x: Complex, y: Complex) -> Complex:
    """The sum x + y."""
    return real.add(x[0], y[0]), real.add(x[1], y[1])


@compiled
def subtract(x: Complex, y: Complex) -> Complex:
    """The difference x - y."""
    return real.subtract(x[0], y[0]), real.subtract(x[1], y[1])


@compiled
def multiply(x: Complex, y: Complex) -> Complex:
    """The product x y."""
    return (
        real.subtract(real.multiply(x[0], y[0]), real.multiply(x[1], y[1])),
        real.add(real.multiply(x[0], y[1]), real.multiply(x[1], y[0])),
    )


@compiled
def conjugate(x: Complex) -> Complex:
    """The conjugate of x."""
    return x[0], -x[1]


@compiled
def multiple(x: Complex, factor: complex) -> Complex:
    """The product of x and a double-double."""
    return real.multiply(x[0], factor), real.multiply(x[1], factor)


@compiled
def squared(x: Complex) -> complex:
    """The squared modulus, a double-double."""
    return real.add(real.multiply(x[0], x[0]), real.multiply(x[1], x[1]))


@compiled
def difference(x: Array, y: Array) -> Complex:
    """The vector x - y of two points of the plane, exactly."""
    return exact_sum(x[0], -y[0]), exact_sum(x[1], -y[1])


@compiled
def number(parts: Array) -> Complex:
    """A complex number from an array (2, 2): real and imaginary part, each a pair."""
    return complex(parts[0, 0], parts[0, 1]), complex(parts[1, 0], parts[1, 1])


@compiled
def accumulate(x: Complex, parts: Array) -> None:
    """Adds x to a complex number in an array (2, 2)."""
    total = add(number(parts), x)
    parts[0, 0], parts[0, 1], parts[1, 0], parts[1, 1] = total[0].real, total[0].imag, total[1].real, total[1].imag
