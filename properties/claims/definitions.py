"""The definitions that printed formulas are held against: series, limits and characterisations, over a context ``m``.

The maps of `affinecert.reference` are definitions too (they share no formula with the papers, and tests hold them to
series and enclosures); what is here is what claims need besides.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.properties.claims.precision import size
from affinecert.reference._matrices import Array, Context, Number, identity


def exponential(m: Context, matrix: Array) -> Array:
    """The sum of X^k / k!, (n, n) -> (n, n): of X / 2^j, squared j times."""
    halvings = max(0, int(m.ceil(m.log(size(matrix), 2))) + 4) if size(matrix) else 0
    with m.extradps(10 + halvings // 3):
        scaled = matrix / m.mpf(2) ** halvings
        term = total = identity(m, len(matrix))
        k = 0
        while size(term) > m.eps * 2**-20:
            k += 1
            term = term @ scaled / k
            total = total + term
        for _ in range(halvings):
            total = total @ total
    found: Array = total * m.one
    return found


def integral_of_exponential(m: Context, matrix: Array) -> Array:
    """The integral of exp(s X) over s in [0, 1], the sum of X^k / (k + 1)!: V of a rigid motion or similarity."""
    n = len(matrix)
    bordered = np.full((2 * n, 2 * n), m.zero, dtype=object)
    bordered[:n, :n] = matrix
    bordered[:n, n:] = identity(m, n)
    integral: Array = exponential(m, bordered)[:n, n:]
    return integral


def inverse(m: Context, matrix: Array) -> Array:
    """The inverse of a matrix, by elimination with pivots."""
    n = len(matrix)
    rows = np.concatenate([matrix, identity(m, n)], axis=1)
    for k in range(n):
        pivot = max(range(k, n), key=lambda row: abs(rows[row, k]))
        rows[[k, pivot]] = rows[[pivot, k]]
        rows[k] = rows[k] / rows[k, k]
        for row in range(n):
            if row != k:
                rows[row] = rows[row] - rows[row, k] * rows[k]
    found: Array = rows[:, n:]
    return found


def eigenvalues(m: Context, matrix: Array) -> list[Number]:
    """The eigenvalues, complex ones too, of a square matrix."""
    found, _ = m.eig(m.matrix(matrix.tolist()))
    return list(found)


def derivative(m: Context, curve: Callable[[Number], Any], t: Number, order: int = 1) -> Any:
    """The derivative of a curve of numbers or arrays, by central differences of high precision.

    Its relative error is about 10^-(dps - 10) for curves that turn at rates about 1.
    """
    with m.workdps((m.dps + 10) * (order + 2)):
        # The error of the difference is h^2, the rounding's eps / h^order: with so many digits both are negligible.
        h = m.mpf(10) ** -((m.dps // (order + 2)) // 2 + 5)
        t = m.mpf(t)
        signs = [(-1) ** k * m.binomial(order, k) for k in range(order + 1)]
        total = sum(sign * curve(t + (order - 2 * k) * h) for k, sign in enumerate(signs))
        return total / (2 * h) ** order


def determinant(matrix: Array) -> Number:
    """The determinant by expansion along the first row: exact for rational entries."""
    if len(matrix) == 0:
        return 1
    rest = matrix[1:]
    signed = ((-1) ** k * entry * determinant(np.delete(rest, k, axis=1)) for k, entry in enumerate(matrix[0]) if entry)
    return sum(signed, start=0)
