"""Homotopies from the identity to linear maps of the plane, in double-double and complex numbers.

The plane is that of complex numbers, a linear map is z -> a z + b conj(z), and its determinant |a|^2 - |b|^2. If that
is positive, a = |a| e^(i theta) tells the rotation of the polar decomposition A = R S, and S is z -> |a| z + u conj(z)
with u = b e^(-i theta), of eigenvalues |a| + |u| and |a| - |u|. Whatever grows of S is again z -> p z + r u conj(z)
with real p and r. A complex number is an array (..., 2, 2): real and imaginary part, each a pair (high, low).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from affinecert.fast import _wide as wide
from affinecert.fast._elementary import LOG_2
from affinecert.fast._kernel import Array
from affinecert.fast._wide import add, divide, multiply, square_root, subtract, times

ONE = np.array([1.0, 0.0])
LOG_OF_2 = np.array([LOG_2.real, LOG_2.imag])


class Growth(NamedTuple):
    """What becomes of S: z -> ``scale`` z + ``ratio`` u conj(z), both real pairs (..., 2)."""

    scale: Array
    ratio: Array


class Factors(NamedTuple):
    """Polar factors: theta, |a|, u and |u|, and the logarithms of both eigenvalues of S, (..., 2, 2)."""

    angle: Array
    modulus: Array
    slope: Array
    spread: Array
    logarithms: Array


def complex_product(a: Array, b: Array) -> Array:
    """The product of complex numbers."""
    parts = multiply(a[..., :, None, :], b[..., None, :, :])
    real = subtract(parts[..., 0, 0, :], parts[..., 1, 1, :])
    return np.stack([real, add(parts[..., 0, 1, :], parts[..., 1, 0, :])], axis=-2)


def conjugate(a: Array) -> Array:
    """The conjugate numbers."""
    return a * np.array([[1.0], [-1.0]])


def real_multiple(a: Array, x: Array) -> Array:
    """The products of complex numbers and real pairs."""
    return multiply(a, x[..., None, :])


def squared(a: Array) -> Array:
    """The squared moduli."""
    parts = multiply(a, a)
    return add(parts[..., 0, :], parts[..., 1, :])


@np.errstate(all="ignore")
def factors(a: Array, b: Array, determinant: Array) -> Factors:
    """The polar factors of z -> a z + b conj(z); the determinant, (..., 2), is given for it may cancel."""
    modulus, spread = square_root(squared(a)), square_root(squared(b))
    larger = add(modulus, spread)
    return Factors(
        angle=wide.arctangent2(a[..., 1, :], a[..., 0, :]),
        modulus=modulus,
        slope=divide(complex_product(b, conjugate(a)), modulus[..., None, :]),
        spread=spread,
        logarithms=wide.logarithm(np.stack([larger, divide(determinant, larger)], axis=-2)),
    )


def shifted(factors: Factors, exponent: Array) -> Factors:
    """The factors of the map times 2^exponent."""
    by = exponent[..., None]
    return Factors(
        angle=factors.angle,
        modulus=np.ldexp(factors.modulus, by),
        slope=np.ldexp(factors.slope, by[..., None]),
        spread=np.ldexp(factors.spread, by),
        logarithms=add(factors.logarithms, times(LOG_OF_2, by)),
    )


def linear(factors: Factors, t: Array) -> Growth:
    """The mixture (1 - t) I + t S, for a pair t."""
    mixed = add(subtract(ONE, t), multiply(factors.modulus, t))
    return Growth(mixed, np.broadcast_to(t, mixed.shape))


@np.errstate(all="ignore")
def exponential(factors: Factors, t: Array) -> Growth:
    """The power S^t, for a pair t."""
    powers = 0.5 * wide.exponential(multiply(factors.logarithms, t[..., None, :]))
    larger, smaller = powers[..., 0, :], powers[..., 1, :]
    ratio = divide(subtract(larger, smaller), factors.spread)
    return Growth(add(larger, smaller), np.where(factors.spread[..., :1] > 0.0, ratio, 0.0))


def turned(factors: Factors, growth: Growth, t: Array) -> tuple[Array, Array]:
    """The numbers a and b of R_(t theta) times what has grown of S."""
    sine, cosine = wide.sine_cosine(multiply(factors.angle, t))
    turn = np.stack([cosine, sine], axis=-2)
    grown = real_multiple(factors.slope, growth.ratio)
    return real_multiple(turn, growth.scale), complex_product(turn, grown)
