"""Natural cubic splines in double-double: what each value counts for in the spline at a time.

With the second derivatives M_i, M = 0 at both ends, the spline between the knots x_i and x_i+1, of distance h, is

    a y_i + b y_i+1 - a b h^2 / 6 ((1 + a) M_i + (1 + b) M_i+1),    a = (x_i+1 - t) / h, b = (t - x_i) / h,

and T M = D y, T symmetric and tridiagonal, where D takes differences of the slopes of the chords. So the weights of
the values y are those of a straight line, less D^T T^-1 of the two factors of M: one system for each time.
"""

from __future__ import annotations

import numpy as np

from affinecert.fast._double_double import ONE, add, divide, exact_sum, multiply, scaled, subtract
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._numbers import Numbers, store_vector


@compiled
def _solve(widths: Numbers, right: Numbers) -> None:
    """Solves for the second derivatives at the inner knots, in place; they are 0 at the first and the last."""
    last = len(widths)
    pivots = np.empty(last + 1, dtype=np.complex128)
    for i in range(1, last):
        pivots[i] = scaled(add(widths[i - 1], widths[i]), 2.0)
        if i > 1:
            factor = divide(widths[i - 1], pivots[i - 1])
            pivots[i] = subtract(pivots[i], multiply(factor, widths[i - 1]))
            right[i] = subtract(right[i], multiply(factor, right[i - 1]))
    for i in range(last - 1, 0, -1):
        if i < last - 1:
            right[i] = subtract(right[i], multiply(widths[i], right[i + 1]))
        right[i] = divide(right[i], pivots[i])


@kernel(
    inputs={"knots": ("keys",), "t": ()},
    outputs=(("keys", 2),),
    refusals=(("knots", "not strictly increasing"),),
)
def natural_spline_weights(knots: Array, t: float, weights: Array, status: Array) -> None:
    """The weights of the values at the knots; outside of these the cubic of the nearest span goes on."""
    last = len(knots) - 1
    widths, total = np.empty(last, dtype=np.complex128), np.zeros(last + 1, dtype=np.complex128)
    span = 0
    for i in range(last):
        widths[i] = exact_sum(knots[i + 1], -knots[i])
        if not widths[i].real > 0.0:
            status[0] = 1
        if i > 0 and knots[i] <= t:
            span = i
    a = divide(exact_sum(knots[span + 1], -t), widths[span])
    b = divide(exact_sum(t, -knots[span]), widths[span])
    # The factors of the second derivatives, six times; T likewise, so that it has whole multiples of the widths.
    bend = multiply(multiply(a, b), multiply(widths[span], widths[span]))
    inner = np.zeros(last + 1, dtype=np.complex128)
    inner[span], inner[span + 1] = multiply(bend, add(ONE, a)), multiply(bend, add(ONE, b))
    inner[0] = inner[last] = 0j
    _solve(widths, inner)
    total[span], total[span + 1] = a, b
    for i in range(last):
        slope = divide(subtract(inner[i], inner[i + 1]), widths[i])
        total[i] = add(total[i], slope)
        total[i + 1] = subtract(total[i + 1], slope)
    store_vector(total, weights)
