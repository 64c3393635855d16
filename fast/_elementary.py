"""Exponential, logarithm, sine, cosine and arctangent of double-doubles, for kernels to call.

The exponential, the sine and the cosine are Taylor series of a reduced argument; the logarithm and the arctangent are
one correction of their float64 values, by the exponential, and by the sine and the cosine. Every result is within
2^-102 of itself, also next to its zeros, as far as the argument is told by its double-double.
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from affinecert.fast._compensated import quick_two_sum
from affinecert.fast._double_double import (
    ONE,
    add,
    divide,
    exact_product,
    multiply,
    multiply_add,
    scaled,
    subtract,
    times,
)
from affinecert.fast._kernel import compiled
from affinecert.fast._numbers import shifted
from affinecert.fast._three_nodes import reciprocal


def parts(number: Fraction, count: int) -> tuple[float, ...]:
    """A number as a sum of so many float64, each the rest rounded."""
    found: list[float] = []
    for _ in range(count):
        found.append(float(number))
        number -= Fraction(found[-1])
    return tuple(found)


PI_FRACTION = Fraction("3.14159265358979323846264338327950288419716939937510582097494459")
PI = complex(*parts(PI_FRACTION, 2))
HALF_PI_1, HALF_PI_2, HALF_PI_3, HALF_PI_4 = parts(PI_FRACTION / 2, 4)

LOG_2_FRACTION = Fraction("0.693147180559945309417232121458176568075500134360255254120680009")
LOG_2 = complex(*parts(LOG_2_FRACTION, 2))
# To 24 bits, so that k log 2 is exact for the exponent k of any float64; and what is left of it.
LOG_2_FIRST = float(np.float32(LOG_2.real))
LOG_2_REST = complex(*parts(LOG_2_FRACTION - Fraction(LOG_2_FIRST), 2))

# Beyond it exp overflows, below its negative exp is 0.
MOST_EXPONENT = 750.0

# The reduced argument of exp is at most log(2)/2 < 0.35, and 0.35^n / n! < 2^-108 from n = 23 on; that of sine and
# cosine is at most pi/4 < 0.79, and 0.79^n / n! < 2^-108 from n = 29 on. So these hold 1 / n!, n < 29.
EXPONENTIAL_TERMS, TERMS = 23, 29
RECIPROCALS = np.array([reciprocal(math.factorial(n)) for n in range(TERMS)])

SQUARE_ROOT_OF_HALF = math.sqrt(0.5)


@compiled
def _exponential_less_one(x: complex) -> complex:
    """The difference e^x - 1 for |x| up to 0.35, relative to itself."""
    total = RECIPROCALS[EXPONENTIAL_TERMS - 1]
    for n in range(EXPONENTIAL_TERMS - 2, 0, -1):
        total = multiply_add(total, x, RECIPROCALS[n])
    return multiply(total, x)


@compiled
def split_exponential(x: complex) -> tuple[complex, int]:
    """The number e^x as one between 0.7 and 1.42, and the exponent of the power of two that it is multiplied by."""
    exponent = np.rint(x.real / LOG_2.real)
    rest = subtract(subtract(x, complex(exponent * LOG_2_FIRST, 0.0)), times(LOG_2_REST, exponent))
    return add(_exponential_less_one(rest), ONE), int(exponent)


@compiled
def exponential(x: complex) -> complex:
    """The number e^x; infinity beyond the range."""
    if not abs(x.real) < MOST_EXPONENT:
        return complex(math.exp(x.real), 0.0)
    mantissa, exponent = split_exponential(x)
    return shifted(mantissa, exponent)


@compiled
def exponential_less_one(x: complex) -> complex:
    """The difference e^x - 1, relative to itself."""
    return _exponential_less_one(x) if abs(x.real) < 0.35 else subtract(exponential(x), ONE)


@compiled
def logarithm(x: complex) -> complex:
    """The natural logarithm; minus infinity at 0, nan below.

    With x = 2^k m, m between the square roots of 1/2 and 2, and y = log(m) rounded, log(m) is y + 2 atanh(z), where
    z = (m - e^y) / (m + e^y) is so small that atanh(z) is z. Next to 1 the difference is that of m - 1 and e^y - 1.
    """
    if not 0.0 < x.real < math.inf:
        return complex(np.log(x.real), 0.0)
    mantissa, exponent = math.frexp(x.real)
    if mantissa < SQUARE_ROOT_OF_HALF:
        exponent -= 1
    m = shifted(x, -exponent)
    rough = complex(math.log(m.real), 0.0)
    grown = _exponential_less_one(rough)
    less = subtract(m, ONE)
    z = divide(subtract(less, grown), add(add(less, grown), scaled(ONE, 2.0)))
    return add(times(LOG_2, float(exponent)), add(rough, scaled(z, 2.0)))


@compiled
def sine_cosine(x: complex) -> tuple[complex, complex]:
    """The sine and the cosine of an angle in radians.

    Multiples of pi/2 are taken away exactly, but for 2^-200 of the angle. Beyond 2^52 the multiple is not known.
    """
    quarters = np.rint(x.real / HALF_PI_1)
    rest = subtract(x, exact_product(quarters, HALF_PI_1))
    rest = subtract(rest, exact_product(quarters, HALF_PI_2))
    rest = subtract(rest, exact_product(quarters, HALF_PI_3))
    rest = subtract(rest, complex(quarters * HALF_PI_4, 0.0))
    square = -multiply(rest, rest)
    sine, cosine = RECIPROCALS[TERMS - 2], RECIPROCALS[TERMS - 1]
    for n in range(TERMS - 4, 0, -2):
        sine = multiply_add(sine, square, RECIPROCALS[n])
        cosine = multiply_add(cosine, square, RECIPROCALS[n + 1])
    sine, cosine = multiply(sine, rest), multiply_add(cosine, square, ONE)
    quadrant = quarters - 4.0 * np.floor(quarters / 4.0)
    if quadrant in (1.0, 3.0):
        sine, cosine = cosine, -sine
    if quadrant in (2.0, 3.0):
        sine, cosine = -sine, -cosine
    return sine, cosine


@compiled
def arctangent2(y: complex, x: complex) -> complex:
    """The angle of the point (x, y), in (-pi, pi]; 0 at the origin.

    The angle in float64, corrected by that of the point turned back by it, which is so small that it is its tangent.
    """
    if y.real == 0.0 and x.real == 0.0:
        return 0j
    # A negative zero is none.
    rough = complex(math.atan2(y.real + 0.0, x.real), 0.0)
    sine, cosine = sine_cosine(rough)
    across = subtract(multiply(y, cosine), multiply(x, sine))
    along = x.real * cosine.real + y.real * sine.real
    high, low = quick_two_sum(rough.real, across.real / along)
    return complex(high, low)
