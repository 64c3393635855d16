"""Double-double arithmetic: numbers kept as an unevaluated sum high + low of two float64, about 106 bits.

A number is held in one complex128, high as its real part and low as its imaginary part, so that formulas nest and
arrays of numbers are ordinary arrays. High is always the sum rounded to float64: to round a result is to take its real
part. Negation is the complex one; for every other operation there is a function here. Results are within a few units
of 2^-106 while everything stays between 2^-960 and 2^1020; callers scale their inputs by powers of two first.

Source: Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
arithmetic", 2017: algorithm 6 for the sum, 11 and 9 for the products, 17 for the quotient (with an accurate sum). The
square root is one Newton step, as in Hida, Li, Bailey, "Algorithms for quad-double precision floating point
arithmetic", 2001.
"""

from __future__ import annotations

import math

from affinecert.fast._compensated import fma, quick_two_sum, two_product, two_sum
from affinecert.fast._kernel import compiled

ONE = complex(1.0, 0.0)


@compiled
def exact_sum(x: float, y: float) -> complex:
    """The sum x + y of two float64, exactly."""
    high, low = two_sum(x, y)
    return complex(high, low)


@compiled
def exact_product(x: float, y: float) -> complex:
    """The product x y of two float64, exactly."""
    high, low = two_product(x, y)
    return complex(high, low)


@compiled
def add(a: complex, b: complex) -> complex:
    """The sum a + b, within 3 units of 2^-106 of itself, however much cancels."""
    high, low = two_sum(a.real, b.real)
    tail, rest = two_sum(a.imag, b.imag)
    high, low = quick_two_sum(high, low + tail)
    high, low = quick_two_sum(high, low + rest)
    return complex(high, low)


@compiled
def subtract(a: complex, b: complex) -> complex:
    """The difference a - b."""
    return add(a, -b)


@compiled
def multiply(a: complex, b: complex) -> complex:
    """The product a b."""
    high, low = two_product(a.real, b.real)
    high, low = quick_two_sum(high, low + fma(a.real, b.imag, a.imag * b.real))
    return complex(high, low)


@compiled
def multiply_add(a: complex, b: complex, c: complex) -> complex:
    """The sum a b + c."""
    return add(multiply(a, b), c)


@compiled
def scaled(a: complex, factor: float) -> complex:
    """The product of a and a power of two, exactly."""
    return complex(a.real * factor, a.imag * factor)


@compiled
def times(a: complex, x: float) -> complex:
    """The product of a and a float64."""
    high, low = two_product(a.real, x)
    high, low = quick_two_sum(high, fma(a.imag, x, low))
    return complex(high, low)


@compiled
def divide(a: complex, b: complex) -> complex:
    """The quotient a / b."""
    first = a.real / b.real
    rest = subtract(a, times(b, first))
    high, low = quick_two_sum(first, rest.real / b.real)
    return complex(high, low)


@compiled
def square_root(a: complex) -> complex:
    """The square root of a number that is not negative; 0 for a negative one."""
    if a.real <= 0.0:
        return 0j
    root = math.sqrt(a.real)
    high, low = quick_two_sum(root, (fma(-root, root, a.real) + a.imag) / (2.0 * root))
    return complex(high, low)
