"""Building blocks that regimes share: sizes, rotations, frames and homogeneous matrices, made from a `Draw`."""

from __future__ import annotations

import math

import numpy as np

from affinecert.draw import Draw
from affinecert.map import Array


def signed(draw: Draw, low: float, high: float) -> float:
    """A number of either sign and of size 10**e, e uniform in [low, high]."""
    return draw.choice((1.0, -1.0)) * draw.exponent(low, high)


def eighths(draw: Draw, low: int, high: int) -> float:
    """A multiple of 1/8 in [low/8, high/8]: a number of few bits, so that small products and sums of it are exact."""
    return draw.choice(range(low, high + 1)) / 8


def short(number: float) -> float:
    """The number rounded to four significant bits, for the same purpose."""
    fraction, exponent = math.frexp(number)
    return math.ldexp(round(fraction * 16) / 16, exponent)


def vector(draw: Draw, low: float = -3, high: float = 3, size: int = 3) -> Array:
    """A vector in any direction, of length 10**e, e uniform in [low, high]; (size,)."""
    return draw.exponent(low, high) * draw.direction(size)


def scalar(number: float) -> Array:
    """The number as a 0-d array: how scalars are handed to maps."""
    return np.array(number, dtype=np.float64)


def quaternion_matrix(w: float, x: float, y: float, z: float) -> Array:
    """The rotation of the unit quaternion (w, x, y, z), (3, 3); exactly symmetric for w = 0, the half turn."""
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def any_rotation(draw: Draw, size: int = 3) -> Array:
    """A rotation of the plane (size 2) or of space (size 3), none preferred."""
    if size == 2:
        cosine, sine = draw.direction(2)
        return np.array([[cosine, -sine], [sine, cosine]])
    return quaternion_matrix(*draw.direction(4))


def well_conditioned(draw: Draw, size: int) -> Array:
    """A linear map of positive determinant with singular values in [1/2, 2], (size, size)."""
    values = [draw.uniform(0.5, 2.0) for _ in range(size)]
    return any_rotation(draw, size) @ np.diag(values) @ any_rotation(draw, size)


def permuted(draw: Draw, matrix: Array) -> Array:
    """The matrix in permuted coordinates: similar to it, with the very same entries."""
    order = sorted(range(len(matrix)), key=lambda _: draw.uniform(0.0, 1.0))
    return matrix[np.ix_(order, order)]


def oblique(draw: Draw, matrix: Array) -> Array:
    """Q M Q^-1 with a small integer matrix Q of determinant 1; exact for a matrix M whose entries have few bits.

    Q is a product of elementary shears by 1 or 2, one for each entry off the diagonal. The maximum norm of |Q| |Q^-1|
    reaches 725 over all such Q of space: 10 bits more than M takes must fit in 53.
    """
    size = len(matrix)
    steps = [(i, j) for i in range(size) for j in range(i)] + [(j, i) for i in range(size) for j in range(i)]
    for row, column in steps:
        coefficient = draw.choice((1.0, -1.0, 2.0, -2.0))
        shear, inverse = np.eye(size), np.eye(size)
        shear[row, column], inverse[row, column] = coefficient, -coefficient
        matrix = shear @ matrix @ inverse
    return matrix


def half_turns() -> tuple[Array, ...]:
    """The nine rotations by pi whose entries are 0 and +-1; symmetric, and exact in float64."""
    axes = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)]
    return tuple(2 * np.outer(axis, axis) / np.dot(axis, axis) - np.eye(3) for axis in axes)


def quarter_turns(size: int = 3) -> tuple[Array, ...]:
    """Rotations by 0, 90 and 120 degrees whose entries are 0 and +-1; exact in float64."""
    if size == 2:
        return tuple(np.array([[c, -s], [s, c]], dtype=np.float64) for c, s in ((1, 0), (0, 1), (0, -1)))
    cycle = np.eye(3)[[1, 2, 0]]
    quarter = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    return (np.eye(3), cycle, cycle.T, quarter, quarter.T, cycle @ quarter @ cycle.T, cycle.T @ quarter @ cycle)


def off_by_ulps(draw: Draw, array: Array, ulps: int) -> Array:
    """The array with each entry moved by up to that many of its last places, zeros left alone."""
    steps = np.array([draw.choice(range(-ulps, ulps + 1)) for _ in range(array.size)]).reshape(array.shape)
    moved = array + steps * np.spacing(np.abs(array))
    return np.where(array == 0, array, moved)


def homogeneous(linear: Array, translation: Array) -> Array:
    """The affine map x -> linear x + translation as a homogeneous matrix, its last row (0, ..., 0, 1)."""
    size = len(linear)
    matrix = np.eye(size + 1)
    matrix[:size, :size] = linear
    matrix[:size, size] = translation
    return matrix
