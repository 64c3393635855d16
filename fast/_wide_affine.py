"""Exponentials, logarithms and steady powers of affine maps as homogeneous matrices of pairs, (..., n, n, 2), n = 3, 4.

Logarithms and powers are those of `affinecert.fast.sam`, by its stages: principal, and at a double negative eigenvalue
with two eigenvectors by its convention. They give a second result, which says where there is none.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from affinecert.fast import _wide as wide
from affinecert.fast._double_double import ONE, add, scaled
from affinecert.fast._existence import kind_of_sum, part, parting_of_sum
from affinecert.fast._growth import VALUES, logarithms, powers, values
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._matrix_function import ROUNDING, applied
from affinecert.fast._numbers import Numbers, image, numbers, store, store_vector, vector
from affinecert.fast._sam_stages import eigenvalues
from affinecert.fast._spectrum import HALF_TURN, NONE, NOT_ORIENTED, PRIMARY, UNDECIDED
from affinecert.fast._stages import run, settle
from affinecert.fast._three_nodes import EXPONENTIAL_TERMS, FACTORIAL_RECIPROCALS, SMALL_ARGUMENT

MATRIX, VECTOR = ("k", "k", 2), ("k", 2)


@compiled
def _largest(matrix: NDArray[np.float64]) -> float:
    """The largest sum of a row."""
    largest = 0.0
    for i in range(len(matrix)):
        total = 0.0
        for j in range(len(matrix)):
            total += abs(matrix[i, j])
        largest = max(largest, total)
    return largest


@compiled
def _halvings(matrix: Numbers) -> int:
    """How often the matrix X is to be halved for the series of its exponential.

    The powers X^k, k > 1, are at most a^k in norm for the larger a of |X^2|^(1/2) and |X^3|^(1/3), which knows that
    large entries off the diagonal may not grow with k (Al-Mohy and Higham, "A new scaling and squaring algorithm for
    the matrix exponential", 2009, theorem 4.2).
    """
    size, peak = len(matrix), 0.0
    for i in range(size):
        for j in range(size):
            peak = max(peak, abs(matrix[i, j].real))
    if peak == 0.0:
        return 0
    x, square, cube = np.empty((size, size)), np.zeros((size, size)), np.zeros((size, size))
    for i in range(size):
        for j in range(size):
            x[i, j] = matrix[i, j].real / peak
    for i in range(size):
        for j in range(size):
            for k in range(size):
                square[i, j] += x[i, k] * x[k, j]
    for i in range(size):
        for j in range(size):
            for k in range(size):
                cube[i, j] += square[i, k] * x[k, j]
    growth = peak * max(math.sqrt(_largest(square)), _largest(cube) ** (1.0 / 3.0))
    return max(0, math.frexp(growth / SMALL_ARGUMENT)[1])


@compiled
def _plus(matrix: Numbers, multiple: complex) -> Numbers:
    """The matrix plus a multiple of the unit matrix."""
    total = matrix.copy()
    for i in range(len(matrix)):
        total[i, i] = add(matrix[i, i], multiple)
    return total


@kernel(inputs={"linear": MATRIX, "velocity": VECTOR}, outputs=(MATRIX, VECTOR))
def _exponential(linear: Array, velocity: Array, power: Array, translation: Array, _status: Array) -> None:
    """The linear part e^X, and the translation (e^X - 1)/X v.

    By the series of Q = (e^Y - 1) / Y for Y = X / 2^k, and (e^2Y - 1) / 2Y = Q (e^Y + 1) / 2.
    """
    x = numbers(linear)
    halvings = _halvings(x)
    factor = math.ldexp(1.0, -halvings)
    quotient = np.zeros(x.shape, dtype=np.complex128)
    for i in range(len(x)):
        for j in range(len(x)):
            x[i, j] = scaled(x[i, j], factor)
    for k in range(EXPONENTIAL_TERMS - 1, -1, -1):
        quotient = _plus(wide.matrix_product(quotient, x), FACTORIAL_RECIPROCALS[k])
    grown = _plus(wide.matrix_product(x, quotient), ONE)
    for _ in range(halvings):
        quotient = wide.matrix_product(quotient, _plus(grown, ONE))
        grown = wide.matrix_product(grown, grown)
    moved = image(quotient, vector(velocity))
    for i in range(len(moved)):
        moved[i] = scaled(moved[i], factor)
    store(grown, power)
    store_vector(moved, translation)


def affine_exponential(x: Array) -> Array:
    """The affine maps exp(X) of tangents X = [[linear, v], [0, 0]]."""
    return wide.homogeneous(*run(_exponential, wide.linear_part(x), wide.translation(x)))


@kernel(
    inputs={
        "linear": MATRIX,
        "translation": VECTOR,
        "existence": (),
        "setting": VALUES,
        "function": VALUES,
        "quotient": VALUES,
    },
    outputs=(MATRIX, VECTOR),
)
def _function(
    linear: Array,
    translation: Array,
    existence: float,
    setting: Array,
    function: Array,
    quotient: Array,
    result: Array,
    moved: Array,
    _status: Array,
) -> None:
    """The parts f(L) and g(L) t of a function f of an affine map, g(x) = (f(x) - f(1)) / (x - 1)."""
    matrix = numbers(linear)
    m, delta, mu, _ = values(setting)
    nodes, half_turn = (m, delta, mu), existence == HALF_TURN
    size = len(matrix)
    for j in range(size + 1):
        x = vector(translation)
        if j < size:
            for i in range(size):
                x[i] = complex(1.0 if i == j else 0.0, 0.0)
        f = values(function) if j < size else values(quotient)
        y = applied(matrix, nodes, half_turn, f, x, image(matrix, x))
        for i in range(size):
            if j < size:
                result[i, j, 0], result[i, j, 1] = y[i].real, y[i].imag
            else:
                moved[i, 0], moved[i, 1] = y[i].real, y[i].imag


def _double_by_rounding(linear: Array, nodes: Array) -> NDArray[np.bool_]:
    """Whether, up to rounding, the pair of eigenvalues is a double negative one with two eigenvectors.

    That is, (L - m I)(L - mu I) = 0 in space, L - m I = 0 in the plane. Only of matrices with low parts: the others
    are what they are.
    """
    m, delta, mu = nodes[..., 0, :], nodes[..., 1, 0], nodes[..., 3, :]
    unit = np.eye(linear.shape[-2])[..., None]
    rest = wide.subtract(linear, unit * m[..., None, None, :])
    if linear.shape[-2] == 3:
        rest = wide.product(rest, wide.subtract(linear, unit * mu[..., None, None, :]))
    nothing = (np.abs(rest[..., 0]) <= ROUNDING).all(axis=(-2, -1))
    inexact = (linear[..., 1] != 0.0).any(axis=(-2, -1))
    return np.asarray(inexact & (m[..., 0] < 0.0) & (np.abs(delta) <= ROUNDING) & nothing)


class _Logarithm(NamedTuple):
    """A linear part divided by 2^exponent, and log(x) and log(x) / (x - 1) on its eigenvalues."""

    linear: Array
    exponent: Array
    existence: Array
    setting: Array
    log: Array
    ratio: Array


def _logarithm(a: Array) -> _Logarithm:
    whole = wide.linear_part(a)
    exponent = np.frexp(np.abs(whole[..., 0]).max(axis=(-2, -1)))[1]
    exponent += exponent & 1
    linear = np.ldexp(whole, -exponent[..., None, None, None])
    nodes, existence = run(eigenvalues, linear)
    existence[_double_by_rounding(linear, nodes)] = HALF_TURN
    doubtful = existence == UNDECIDED
    high, low = linear[..., 0], linear[..., 1]
    settle(existence, UNDECIDED, kind_of_sum, high, low)
    part(nodes, doubtful & (existence == PRIMARY), parting_of_sum, high, low)
    log, ratio, setting = run(logarithms, nodes, exponent.astype(np.float64), existence)
    return _Logarithm(linear, exponent.astype(np.float64), existence, setting, log, ratio)


def _defined(matrix: Array, existence: Array) -> Array:
    """The matrices, nan where there is no logarithm."""
    return np.where(((existence == NONE) | (existence == NOT_ORIENTED))[..., None, None, None], np.nan, matrix)


def affine_logarithm(a: Array) -> tuple[Array, Array]:
    """The principal logarithms [[log L, v], [0, 0]], and what there is of them.

    The second result (...) is NONE, PRIMARY, HALF_TURN or NOT_ORIENTED as in `affinecert.fast._spectrum`; at NONE and
    NOT_ORIENTED the first one is nan.
    """
    known = _logarithm(a)
    parts = run(_function, known.linear, wide.translation(a), known.existence, known.setting, known.log, known.ratio)
    return _defined(wide.tangent(*parts), known.existence), known.existence


def affine_power(a: Array, t: Array) -> tuple[Array, Array]:
    """The steady powers exp(t log A) for float64 t (...), and what there is of a logarithm, as in `affine_logarithm`.

    Exactly I at t = 0 and A at t = 1.
    """
    known = _logarithm(a)
    power, quotient = run(powers, known.exponent, known.existence, known.log, known.ratio, known.setting, t)
    parts = run(_function, known.linear, wide.translation(a), known.existence, known.setting, power, quotient)
    time, unit = t[..., None, None, None], wide.widen(np.eye(a.shape[-2]))
    moved = np.where(time == 0.0, unit, np.where(time == 1.0, a, wide.homogeneous(*parts)))
    return _defined(moved, known.existence), known.existence
