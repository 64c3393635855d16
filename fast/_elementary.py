"""Exponential and logarithm of single double-doubles."""

from __future__ import annotations

import math

from affinecert.fast._double_double import ONE, add, divide, multiply, multiply_add, scaled, subtract, times
from affinecert.fast._kernel import compiled
from affinecert.fast._numbers import shifted
from affinecert.fast._three_nodes import FACTORIAL_RECIPROCALS

# The logarithm of 2, within 2^-110 of itself.
LOG_TWO = complex(0.6931471805599453, 2.3190468138462996e-17)

# What is left after whole powers of 2, at most 0.35, is halved six times: then y^11 / 12! is below 2^-110.
HALVINGS = 6
EXPONENTIAL_TERMS = 11

# Results of larger exponents are infinite, of smaller ones zero, for any float64 that is left to be scaled by them.
MOST_EXPONENT = 5000.0


@compiled
def split_exponential(x: complex) -> tuple[complex, int]:
    """The exponential as a number in [0.7, 1.42] and the exponent of a power of two, however large.

    By the series of exp(y) - 1 and exp(2 y) - 1 = (exp(y) - 1) (2 + exp(y) - 1), y = (x - k log 2) / 64.
    """
    k = min(max(math.floor(x.real / LOG_TWO.real + 0.5), -MOST_EXPONENT), MOST_EXPONENT)
    rest = subtract(x, times(LOG_TWO, k))
    if abs(k) == MOST_EXPONENT:
        rest = 0j
    y = scaled(rest, 2.0**-HALVINGS)
    quotient = FACTORIAL_RECIPROCALS[EXPONENTIAL_TERMS - 1]
    for n in range(EXPONENTIAL_TERMS - 2, -1, -1):
        quotient = multiply_add(quotient, y, FACTORIAL_RECIPROCALS[n])
    less = multiply(quotient, y)
    for _ in range(HALVINGS):
        less = multiply_add(less, less, scaled(less, 2.0))
    return add(less, ONE), int(k)


@compiled
def logarithm(x: complex) -> complex:
    """The logarithm of a positive number.

    With x = 2^k m, m between the roots of 1/2 and 2, and y the rounded logarithm of m, what y lacks is the logarithm of
    q = m / exp(y), within q - 1 cubed 2 (q - 1) / (q + 1): below 2^-150.
    """
    mantissa, exponent = math.frexp(x.real)
    if mantissa < math.sqrt(0.5):
        exponent -= 1
    m = shifted(x, -exponent)
    y = math.log(m.real)
    power, k = split_exponential(complex(y, 0.0))
    power = shifted(power, k)
    rest = scaled(divide(subtract(m, power), add(m, power)), 2.0)
    return add(times(LOG_TWO, float(exponent)), add(complex(y, 0.0), rest))
