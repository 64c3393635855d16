"""Upper triangular 3 x 3 matrices B of positive diagonal: quotients and powers, entry by entry, in double-double.

The entries of f(B) are f(b_i) on the diagonal, b_12 f[b_1, b_2] and b_23 f[b_2, b_3] next to it, and in the corner
b_13 f[b_1, b_3] + b_12 b_23 f[b_1, b_2, b_3], with divided differences: so rows of very different sizes do not disturb
one another.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._double_double import ONE, add, divide, multiply, multiply_add, scaled, subtract, times
from affinecert.fast._kernel import compiled
from affinecert.fast._numbers import Numbers, shifted
from affinecert.fast._three_nodes import SMALL_ARGUMENT, Values

Growth = tuple[complex, complex, complex]
"""At one node x: t log x, x^t, and x^t - 1."""

# Nodes within this ratio are near: their divided differences are taken together. Beyond the root of it at least, where
# differences of values are divided, these lose 3 bits at most.
NEAR = 2.0


@compiled
def quotient(u: Numbers, p: Numbers) -> Numbers:
    """The quotient U P^-1."""
    result = np.zeros((3, 3), dtype=np.complex128)
    for i in range(len(u)):
        result[i, i] = divide(u[i, i], p[i, i])
    for i in range(len(u) - 1):
        result[i, i + 1] = divide(subtract(u[i, i + 1], multiply(result[i, i], p[i, i + 1])), p[i + 1, i + 1])
    rest = subtract(u[0, 2], multiply_add(result[0, 0], p[0, 2], multiply(result[0, 1], p[1, 2])))
    result[0, 2] = divide(rest, p[2, 2])
    return result


@compiled
def closest(b: Numbers) -> tuple[int, int, int, bool]:
    """The two of the three diagonal entries with the smallest ratio, the third one, and whether the two are near."""
    best, smallest = 0, math.inf
    for i in range(len(b)):
        x, y = b[i, i].real, b[(i + 1) % 3, (i + 1) % 3].real
        ratio = max(x, y) / min(x, y)
        if ratio < smallest:
            best, smallest = i, ratio
    return best, (best + 1) % 3, (best + 2) % 3, smallest < NEAR


@compiled
def _difference(x: Growth, y: Growth) -> complex:
    """The difference x^t - y^t, as accurate for small t as for any."""
    if max(abs(x[0].real), abs(y[0].real)) < SMALL_ARGUMENT:
        return subtract(x[2], y[2])
    return subtract(x[1], y[1])


@compiled
def growth(node: complex, x: complex, power: complex, ratio: complex, t: float) -> Growth:
    """The growth at a node x, from log x, x^t and (x^t - 1) / (x - 1)."""
    return times(x, t), power, multiply(ratio, subtract(node, ONE))


@compiled
def pair_of(b: Numbers) -> tuple[Values, int]:
    """Nodes (m, delta, m^2 - delta, mu) for the power, and their exponent: a pair of diagonal entries, and the third.

    The pair are the two `closest` entries if these are near, else the first of them, twice.
    """
    i, j, k, near = closest(b)
    exponent = math.frexp(b[i, i].real)[1]
    exponent += exponent & 1
    first, second = shifted(b[i, i], -exponent), shifted(b[j if near else i, j if near else i], -exponent)
    s = scaled(subtract(first, second), 0.5)
    return (subtract(first, s), multiply(s, s), multiply(first, second), shifted(b[k, k], -exponent)), exponent


@compiled
def _at(functions: tuple[Values, Values, Values], node: complex, s: complex, t: float) -> Growth:
    """The growth at the node m + s of the pair."""
    log, power, ratio = functions
    return growth(
        node,
        multiply_add(log[1], s, log[0]),
        multiply_add(power[1], s, power[0]),
        multiply_add(ratio[1], s, ratio[0]),
        t,
    )


@compiled
def power(b: Numbers, t: float, functions: tuple[Values, Values, Values], single: Growth) -> Numbers:
    """The power B^t, from the functions log x, x^t and (x^t - 1) / (x - 1) on the nodes of `pair_of`.

    ``single`` is the growth at the second of the `closest` entries, of use if these are not near.
    """
    i, j, k, near = closest(b)
    _, exponent = pair_of(b)
    nodes = np.empty(3, dtype=np.complex128)
    for n in range(len(b)):
        nodes[n] = shifted(b[n, n], -exponent)
    log, grown, ratio = functions
    s = scaled(subtract(nodes[i], nodes[j]), 0.5) if near else 0j
    at_i, at_j = _at(functions, b[i, i], s, t), _at(functions, b[j, j], -s, t)
    if not near:
        at_j = single
    at_k = growth(b[k, k], log[2], grown[2], ratio[2], t)
    slope, bend = grown[1], grown[3]
    # First differences f[i, j], f[j, k] and f[k, i], then the second one.
    if not near:
        slope = divide(_difference(at_i, at_j), subtract(nodes[i], nodes[j]))
    spread = max(nodes[0].real, nodes[1].real, nodes[2].real) / min(nodes[0].real, nodes[1].real, nodes[2].real)
    if spread < NEAR:
        f_jk = multiply_add(bend, subtract(nodes[k], nodes[i]), slope)
        f_ki = multiply_add(bend, subtract(nodes[k], nodes[j]), slope)
    else:
        f_jk = divide(_difference(at_j, at_k), subtract(nodes[j], nodes[k]))
        f_ki = divide(_difference(at_k, at_i), subtract(nodes[k], nodes[i]))
        # Over the wider of two gaps.
        bend = divide(subtract(f_jk, slope), subtract(nodes[k], nodes[i]))
        if abs(nodes[k].real - nodes[j].real) > abs(nodes[k].real - nodes[i].real):
            bend = divide(subtract(f_ki, slope), subtract(nodes[k], nodes[j]))
    first = np.empty(3, dtype=np.complex128)
    # By the node that a difference leaves out.
    first[k], first[i], first[j] = slope, f_jk, f_ki
    result = np.zeros((3, 3), dtype=np.complex128)
    result[i, i], result[j, j], result[k, k] = at_i[1], at_j[1], at_k[1]
    upper, right = shifted(b[0, 1], -exponent), shifted(b[1, 2], -exponent)
    result[0, 1], result[1, 2] = multiply(upper, first[2]), multiply(right, first[0])
    corner = multiply(upper, multiply(right, bend))
    result[0, 2] = add(multiply(shifted(b[0, 2], -exponent), first[1]), corner)
    return result
