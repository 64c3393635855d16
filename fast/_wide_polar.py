"""The polar factors of linear maps, in double-double: a stage of its own, shared by all maps that need them."""

from __future__ import annotations

import numpy as np

from affinecert.fast._double_double import add, multiply_add, scaled
from affinecert.fast._jacobi import polar_rotation
from affinecert.fast._kernel import Array, kernel
from affinecert.fast._numbers import numbers, reduced, shifted, store
from affinecert.fast._stages import run


@kernel(inputs={"linear": ("d", "d", 2)}, outputs=(("d", "d", 2), ("d", "d", 2)), sizes=(2, 3))
def _polar(linear: Array, rotation: Array, stretch: Array, _status: Array) -> None:
    matrix = numbers(linear)
    size = matrix.shape[0]
    exponent = reduced(matrix)
    turn = polar_rotation(matrix)
    product = np.zeros((size, size), dtype=np.complex128)
    for i in range(size):
        for j in range(size):
            for k in range(size):
                product[i, j] = multiply_add(turn[k, i], matrix[k, j], product[i, j])
    for i in range(size):
        for j in range(size):
            mean = scaled(add(product[i, j], product[j, i]), 0.5)
            entry = shifted(mean, exponent)
            stretch[i, j, 0], stretch[i, j, 1] = entry.real, entry.imag
    store(turn, rotation)


def polar(linear: Array) -> tuple[Array, Array]:
    """The rotation R and the symmetric positive definite S with L = R S, for det L > 0.

    linear (..., d, d, 2), d = 2 or 3, pairs; gives rotation and stretch, pairs of the same shape. S is the symmetric
    part of R^T L: its error is that of a rounding of L, however close L is to singular.
    """
    rotation, stretch = run(_polar, linear)
    return rotation, stretch
