"""Logarithms and powers on three nodes, without eigenvectors and without subtractions that cancel.

The nodes are the eigenvalues of a 3 x 3 matrix L: a pair m + s and m - s, real or conjugate, told by m and
delta = s^2 (of either sign, or 0), and a real one, mu. A function f of L is

    f(L) = mean I + slope N + bend (N^2 - delta I),    N = L - m I,

with mean = (f(m + s) + f(m - s)) / 2, slope = f[m + s, m - s] and bend = f[m + s, m - s, mu] (Newton's form of the
interpolating polynomial; brackets are divided differences). A function is held here as its `Values`: mean, slope, the
value ``single`` = f(mu), and bend. Sums and products of functions are sums and products of these (Leibniz' rule for
divided differences), whether nodes coalesce or not. A 2 x 2 matrix has the pair only.

All numbers are double-doubles. Nodes are divided by an even power of two, 2^exponent, so that nothing leaves the range;
slope and bend are those with respect to the divided N. The logarithm is taken by repeated square roots,
log L = 2^k log L^(1 / 2^k), and the exponential by repeated squaring: only sums, products, quotients and square roots.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._double_double import (
    ONE,
    add,
    divide,
    multiply,
    multiply_add,
    scaled,
    square_root,
    subtract,
    times,
)
from affinecert.fast._kernel import compiled

Values = tuple[complex, complex, complex, complex]
"""A function on the nodes: mean, slope, single, bend."""

Gaps = tuple[complex, complex]
"""What products need to know of the nodes: delta, and mu - m."""

UNITY: Values = (ONE, 0j, ONE, 0j)

# Square roots are taken until |U - 1| <= 0.2 on the nodes. Then z = (U - 1) / (U + 1) has |z|^2 <= 0.0124 < 2^-6.3, and
# 17 terms of atanh(z) / z = 1 + z^2 / 3 + z^4 / 5 + ... leave less than 2^-107.
NEAR_ONE = 0.2
ATANH_TERMS = 17
# The logarithm of a float64 is below 745 in size, and 745 / 2^12 < 0.19; what is more is not finite.
MOST_ROOTS = 13

# The exponential is halved until its argument is at most 1/8: 8^-k / (k + 1)! is below 2^-107 from k = 18 on.
SMALL_ARGUMENT = 0.125
EXPONENTIAL_TERMS = 18

# Where (mu - (m + s)) (mu - (m - s)) is above this part of the largest node squared, the bend is taken from its
# definition, which then loses 4 bits or so; else by Leibniz' rule, which loses as many bits as the nodes are apart.
SEPARATED = 2.0**-4


def reciprocal(n: int) -> complex:
    """The fraction 1 / n as a double-double: the remainder of the rounded quotient is exact."""
    high = 1.0 / n
    numerator, denominator = high.as_integer_ratio()
    return complex(high, (denominator - n * numerator) / (n * denominator))


ODD_RECIPROCALS = np.array([reciprocal(2 * i + 1) for i in range(ATANH_TERMS)])
FACTORIAL_RECIPROCALS = np.array([reciprocal(math.factorial(k + 1)) for k in range(EXPONENTIAL_TERMS)])


@compiled
def product(f: Values, g: Values, gaps: Gaps) -> Values:
    """The values of the product of two functions."""
    delta, gap = gaps
    slopes = multiply(f[1], g[1])
    tangent = multiply_add(gap, f[1], f[0])
    return (
        multiply_add(f[0], g[0], multiply(slopes, delta)),
        multiply_add(f[0], g[1], multiply(f[1], g[0])),
        multiply(f[2], g[2]),
        add(multiply_add(f[3], g[2], multiply(g[3], tangent)), slopes),
    )


@compiled
def multiple(f: Values, factor: float) -> Values:
    """The values of a function times a float64."""
    return times(f[0], factor), times(f[1], factor), times(f[2], factor), times(f[3], factor)


@compiled
def one_more(f: Values) -> Values:
    """The values of f + 1."""
    return add(f[0], ONE), f[1], add(f[2], ONE), f[3]


@compiled
def separation(m: complex, delta: complex, mu: complex) -> complex:
    """The product (mu - (m + s)) (mu - (m - s)), or 0 where mu is too near to the pair to divide by it."""
    gap = subtract(mu, m)
    distance = subtract(multiply(gap, gap), delta)
    largest = max(abs(m.real) + math.sqrt(abs(delta.real)), abs(mu.real))
    return distance if distance.real > SEPARATED * largest * largest else 0j


@compiled
def bent(f: Values, gap: complex, distance: complex) -> Values:
    """The same values, the bend from its definition where the nodes are separated."""
    if distance.real == 0.0:
        return f
    rest = subtract(subtract(f[2], f[0]), multiply(f[1], gap))
    return f[0], f[1], f[2], divide(rest, distance)


@compiled
def _two_over_one_more(u: Values, determinant: complex, gap: complex) -> Values:
    """The function 2 / (u + 1); ``determinant`` is the product of u over the pair."""
    factor = divide(scaled(ONE, 2.0), add(add(determinant, ONE), scaled(u[0], 2.0)))
    mean, slope = multiply(factor, add(u[0], ONE)), -multiply(factor, u[1])
    one_more_single = add(u[2], ONE)
    bend = multiply_add(u[3], multiply_add(gap, slope, mean), multiply(u[1], slope))
    return mean, slope, divide(scaled(ONE, 2.0), one_more_single), -divide(bend, one_more_single)


@compiled
def _root(mean: complex, slope: complex, u: Values, gap: complex) -> Values:
    """The square root of u, its mean and slope being known."""
    single = square_root(u[2])
    bend = divide(
        subtract(u[3], multiply(slope, slope)),
        add(single, multiply_add(gap, slope, mean)),
    )
    return mean, slope, single, bend


@compiled
def _first_root(m: complex, determinant: complex, mu: complex, gaps: Gaps, half_turn: bool) -> Values:
    """The square root of x on the nodes; no two real nodes are negative, unless ``half_turn``.

    With ``half_turn`` the pair is the double value m < 0, and slopes refer to a unit N with N^2 = -1 (delta = -1)
    instead: the square root of m is sqrt(-m) N.
    """
    delta, gap = gaps
    node = (m, ONE, mu, 0j)
    modulus = square_root(determinant)
    if half_turn:
        return 0j, square_root(-m), square_root(mu), 0j
    if m.real >= 0.0:
        mean = square_root(scaled(add(m, modulus), 0.5))
    else:
        # m + |node| would cancel; it is -delta / (|node| - m).
        mean = divide(square_root(-delta), square_root(scaled(subtract(modulus, m), 2.0)))
    return _root(mean, scaled(divide(ONE, mean), 0.5), node, gap)


@compiled
def logarithm(
    m: complex, determinant: complex, mu: complex, gaps: Gaps, exponent: int, half_turn: bool
) -> tuple[Values, Values]:
    """The values of log(x) and of log(x) / (x - 1), on the nodes times 2^exponent.

    From L - 1 = (L^(1/2) + 1) (L^(1/4) + 1) ... (U + 1) (U - 1) with U = L^(1 / 2^k),

        log(L) / (L - 1) = 2^k log(U) / (U - 1) / ((L^(1/2) + 1) (L^(1/4) + 1) ... (U + 1)),

    which is as accurate near 1 as anywhere; and log U = 2 atanh(z), log(U) / (U - 1) = 2 / (U + 1) atanh(z) / z with
    z = (U - 1) / (U + 1).
    """
    delta, gap = gaps
    half = math.ldexp(1.0, exponent // 2)
    first = _first_root(m, determinant, mu, gaps, half_turn)
    u = scaled(first[0], half), scaled(first[1], half), scaled(first[2], half), scaled(first[3], half)
    pair = scaled(scaled(square_root(determinant), half), half)
    spread = math.sqrt(abs(delta.real))
    factor = _two_over_one_more(u, pair, gap)
    ratio = factor
    doubling = 4.0
    for _ in range(MOST_ROOTS):
        if abs(u[0].real - 1.0) + abs(u[1].real) * spread <= NEAR_ONE and abs(u[2].real - 1.0) <= NEAR_ONE:
            break
        pair = square_root(pair)
        mean = square_root(scaled(add(u[0], pair), 0.5))
        u = _root(mean, scaled(divide(u[1], mean), 0.5), u, gap)
        factor = _two_over_one_more(u, pair, gap)
        ratio = product(ratio, factor, gaps)
        doubling *= 2.0
    z = subtract(ONE, factor[0]), -factor[1], subtract(ONE, factor[2]), -factor[3]
    squared = product(z, z, gaps)
    series = (ODD_RECIPROCALS[ATANH_TERMS - 1], 0j, ODD_RECIPROCALS[ATANH_TERMS - 1], 0j)
    for i in range(ATANH_TERMS - 2, -1, -1):
        series = product(series, squared, gaps)
        series = add(series[0], ODD_RECIPROCALS[i]), series[1], add(series[2], ODD_RECIPROCALS[i]), series[3]
    return multiple(product(z, series, gaps), doubling), product(product(ratio, factor, gaps), series, gaps)


@compiled
def exponential(x: Values, gaps: Gaps, distance: complex) -> tuple[Values, Values]:
    """The values of exp(x) and of (exp(x) - 1) / x for the function with values x; ``distance`` as by `separation`.

    By the series of (exp(y) - 1) / y for y = x / 2^k, and (exp(2 y) - 1) / (2 y) = (exp(y) - 1) / y (exp(y) + 1) / 2.
    """
    gap = gaps[1]
    size = max(abs(x[0].real) + abs(x[1].real) * math.sqrt(abs(gaps[0].real)), abs(x[2].real))
    halvings = max(0, math.frexp(size / SMALL_ARGUMENT)[1])
    y = multiple(x, math.ldexp(1.0, -halvings))
    quotient = (FACTORIAL_RECIPROCALS[EXPONENTIAL_TERMS - 1], 0j, FACTORIAL_RECIPROCALS[EXPONENTIAL_TERMS - 1], 0j)
    for k in range(EXPONENTIAL_TERMS - 2, -1, -1):
        quotient = product(quotient, y, gaps)
        term = FACTORIAL_RECIPROCALS[k]
        quotient = add(quotient[0], term), quotient[1], add(quotient[2], term), quotient[3]
    # The bend of exp(y) - 1, not of exp(y): relative to it, nothing is lost however small y.
    power = one_more(bent(product(y, quotient, gaps), gap, distance))
    for _ in range(halvings):
        quotient = multiple(product(quotient, one_more(power), gaps), 0.5)
        power = bent(product(power, power, gaps), gap, distance)
    return power, quotient
