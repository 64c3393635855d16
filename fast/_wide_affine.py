"""Exponentials, logarithms and steady powers of affine maps as homogeneous matrices of pairs, (..., n, n, 2), n = 3, 4.

Logarithms and powers are those of `affinecert.fast.sam`, by its stages: principal, and at a double negative eigenvalue
with two eigenvectors by its convention. They give a second result, which says where there is none. Matrices without low
parts are what they are; with low parts, one that is within `ROUNDING` of such a half turn counts as one.

Errors are within 2^-98 of the norm and the condition of the result's linear part and translation, powers' so many times
that as t log A is long. An angle e short of a half turn in space they are up to 1/e times larger, for there the
eigenvalues come from a polynomial whose coefficients are of size 1; and eigenvalues below 2^-120 of the largest entry
are lost.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from affinecert.fast import _wide as wide
from affinecert.fast._double_double import add
from affinecert.fast._elementary import RECIPROCALS
from affinecert.fast._existence import kind_of_sum, part, parting_of_sum
from affinecert.fast._growth import VALUES, logarithms, powers, values
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._linear_equations import Exponents
from affinecert.fast._matrix_function import ROUNDING, applied
from affinecert.fast._numbers import Numbers, image, numbers, shifted, store, vector
from affinecert.fast._sam_stages import eigenvalues
from affinecert.fast._spectrum import HALF_TURN, NONE, NOT_ORIENTED, PRIMARY, UNDECIDED
from affinecert.fast._stages import run, settle

MATRIX, VECTOR = ("k", "k", 2), ("k", 2)


# Entries below it are so small that nothing is gained by scaling them down.
SMALL_ENTRY = 2.0**-10

# Each sweep halves the exponents to come: what is within the range of float64 is done after eleven.
MOST_SWEEPS = 12

# The series is that of a matrix of norm at most 1/8: 8^-n / n! is below 2^-107 from n = 19 on.
SMALL_NORM = 0.125
TERMS = 19


@compiled
def _balanced(x: Numbers) -> Exponents:
    """Makes D^-1 X D of X, D of powers of two, whose exponents it returns.

    Of each index, the entries off the diagonal are then as large in the row as in the column, or small; so that a
    large translation or shear, of which powers know nothing, does not count as a large matrix.
    """
    size = len(x)
    exponents = np.zeros(size, dtype=np.int64)
    for _ in range(MOST_SWEEPS):
        for i in range(size):
            row, column = SMALL_ENTRY, SMALL_ENTRY
            for j in range(size):
                if j != i:
                    row, column = max(row, abs(x[i, j].real)), max(column, abs(x[j, i].real))
            shift = (math.frexp(row)[1] - math.frexp(column)[1]) // 2
            exponents[i] += shift
            for j in range(size):
                if j != i:
                    x[i, j], x[j, i] = shifted(x[i, j], -shift), shifted(x[j, i], shift)
    return exponents


@compiled
def _norm(matrix: Numbers) -> float:
    """The largest sum of a row."""
    largest = 0.0
    for i in range(len(matrix)):
        total = 0.0
        for j in range(len(matrix)):
            total += abs(matrix[i, j].real)
        largest = max(largest, total)
    return largest


@kernel(inputs={"tangent": MATRIX}, outputs=(MATRIX,))
def _exponential(tangent: Array, power: Array, _status: Array) -> None:
    """The series of exp(X / 2^k), squared k times, X being balanced; the last row comes out as 0 ... 0 1."""
    x = numbers(tangent)
    size = len(x)
    exponents = _balanced(x)
    halvings = max(0, math.frexp(_norm(x) / SMALL_NORM)[1])
    for i in range(size):
        for j in range(size):
            x[i, j] = shifted(x[i, j], -halvings)
    grown = np.zeros((size, size), dtype=np.complex128)
    for step in range(TERMS + halvings):
        grown = wide.matrix_product(grown, x if step < TERMS else grown)
        for i in range(size):
            if step < TERMS:
                grown[i, i] = add(grown[i, i], RECIPROCALS[TERMS - 1 - step])
    for i in range(size):
        for j in range(size):
            grown[i, j] = shifted(grown[i, j], exponents[i] - exponents[j])
    store(grown, power)


def affine_exponential(x: Array) -> Array:
    """The affine maps exp(X) of tangents X = [[linear, v], [0, 0]]."""
    return run(_exponential, x)[0]


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
