"""First and second divided differences of exp and log, accurate at nodes however close or far apart.

f[x, y] = (f(x) - f(y)) / (x - y), f'(x) where x = y; f[x, y, z] = (f[x, y] - f[y, z]) / (x - z), f''(x)/2 where all
three coincide. They are the entries off the diagonal of f of a triangular matrix.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._compensated import Vector, fma
from affinecert.fast._kernel import compiled

# exp of half of this is still far from overflow.
LARGE_EXPONENT = 700.0

# For the second difference of exp, nodes within this width are a cluster and get the series. Just outside, where the
# difference of first differences cancels most, it magnifies their errors by (f(1) + f(2)) / (f(1) - f(2)) < 3 times
# at most, f(a) = (1 - e^-a) / a.
EXP_CLUSTER = 2.0

# Its Taylor series about the middle of a cluster, in complete homogeneous polynomials h_k(r, -r, m), |h_k| <= k/2 + 1
# for r, |m| <= 1, over (k + 2)!: cut after k = 17, the rest is under 10/20!, 2^-56 of the sum, which is over 0.4.
EXP_COEFFICIENTS = tuple(1.0 / math.factorial(k + 2) for k in range(18))

# For the second difference of log, nodes within this ratio are a cluster and get the quadrature. Just outside, the
# difference of first differences magnifies their errors by less than 3.5.
LOG_CLUSTER = 4.0

# The integrand's poles are at least 3 half-widths from the middle of the interval, if the nodes are within a factor of
# 2 of the middle: Gauss's rule with n points converges like (3 + sqrt(8))^-2n, which is below 2^-55 for n = 11.
POINTS, WEIGHTS = (array / 2 for array in np.polynomial.legendre.leggauss(11))
POINTS = POINTS + 0.5


@compiled
def product(a: float, b: float, c: float) -> float:
    """The product a b c, in an order that overflows or underflows only if the product does."""
    first = a * b
    least, most = (a, b) if abs(a) < abs(b) else (b, a)
    if abs(first) > 1e280 and abs(c) < 1.0:
        return most * c * least
    if abs(first) < 1e-280 and abs(c) > 1.0:
        return least * c * most
    return first * c


@compiled
def times_exp(a: float, x: float, b: float) -> float:
    """The product a e^x b; e^x may overflow or underflow where the product does not."""
    if a == 0.0:
        return 0.0
    if abs(x) < LARGE_EXPONENT:
        return product(a, math.exp(x), b)
    root = math.exp(0.5 * x)
    return product(a * root, root, b)


@compiled
def decay(x: float) -> float:
    """The function (1 - e^-x) / x of x >= 0; 1 at 0."""
    return -math.expm1(-x) / x if x > 0.0 else 1.0


@compiled
def exp_first(factor: float, x: float, y: float) -> float:
    """The first divided difference of exp at x and y, times a factor: e^y (1 - e^-(y - x)) / (y - x) for x <= y."""
    return times_exp(factor, max(x, y), decay(abs(x - y)))


@compiled
def exp_second(factor: float, too: float, x: float, y: float, z: float) -> float:
    """The second divided difference of exp at x, y and z, times two factors."""
    x, y, z = ordered(x, y, z)
    width = z - x
    if width > EXP_CLUSTER:
        # e^z exp[x - z, y - z, 0], for nodes at most 0.
        near = z - y
        difference = (decay(near) - math.exp(-near) * decay(y - x)) / width
        return scaled_exp(factor, too, z, difference)
    radius = 0.5 * width
    middle = x + radius
    offset = y - middle
    square = radius * radius
    # h_k(r, -r, m) = m h_(k-1) + (r^k if k is even)
    h, power, total = 0.0, 1.0, 0.0
    for k in range(0, 18, 2):
        h = fma(offset, h, power)
        total = fma(h, EXP_COEFFICIENTS[k], total)
        h *= offset
        total = fma(h, EXP_COEFFICIENTS[k + 1], total)
        power *= square
    return scaled_exp(factor, too, middle, total)


@compiled
def scaled_exp(factor: float, too: float, x: float, b: float) -> float:
    """The product of two factors, e^x and b."""
    if factor == 0.0 or too == 0.0:
        return 0.0
    root = math.exp(0.5 * x)
    return product(factor * root, too * root, b)


@compiled
def log_first(x: float, y: float) -> float:
    """The first divided difference of log at x, y > 0: log1p((y - x)/x) / (y - x) for x <= y."""
    x, y = min(x, y), max(x, y)
    if x == y:
        return 1.0 / x
    gap = y - x
    ratio = gap / x
    return (math.log1p(ratio) if ratio < math.inf else math.log(y) - math.log(x)) / gap


@compiled
def log_second(x: float, y: float, z: float) -> float:
    """The second divided difference of log at x, y, z > 0, which is negative.

    For a cluster it is minus the integral over s > 0 of 1/((x + s)(y + s)(z + s)), where no term cancels another; s is
    c p/(1 - p) for p in (0, 1), c the geometric mean of the extremes.
    """
    x, y, z = ordered(x, y, z)
    if z > LOG_CLUSTER * x:
        return (log_first(y, z) - log_first(x, y)) / (z - x)
    c = math.sqrt(x) * math.sqrt(z)
    total = 0.0
    for i in range(POINTS.size):
        p = POINTS[i]
        q = 1.0 - p
        total += WEIGHTS[i] * q / (fma(p, c, q * x) * fma(p, c, q * y) * fma(p, c, q * z))
    return -c * total


@compiled
def ordered(x: float, y: float, z: float) -> Vector:
    """The three in ascending order."""
    low, high = min(x, y), max(x, y)
    return min(low, z), max(low, min(high, z)), max(high, z)
