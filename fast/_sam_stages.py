"""The stages of the steady affine maps: compiled kernels that hand double-doubles to one another.

A linear part is L = 2^exponent times a matrix whose largest entry is of size 1, so that no stage leaves the range;
its eigenvalues and functions of it follow `affinecert.fast._three_nodes`. Splitting the work in stages lets the maps
share them, and each is compiled once.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._double_double import add, exact_sum, subtract
from affinecert.fast._growth import VALUES, values, write
from affinecert.fast._kernel import Array, compiled, kernel
from affinecert.fast._linear_equations import matrix_quotient, solution
from affinecert.fast._matrix_function import applied
from affinecert.fast._numbers import Numbers, image, numbers, shifted
from affinecert.fast._spectrum import HALF_TURN, settled, spectrum

LAST_ROW = "the last row is not 0 ... 0 1"

MATRIX = ("n-1", "n-1", 2)


@compiled
def _has_last_row(affine: Array) -> bool:
    size = affine.shape[0] - 1
    good = bool(affine[size, size] == 1.0)
    for j in range(size):
        good = good and bool(affine[size, j] == 0.0)
    return good


@kernel(inputs={"affine": ("n", "n")}, outputs=(MATRIX, ()), refusals=(("affine", LAST_ROW),), sizes=(3, 4))
def linear_part(affine: Array, linear: Array, exponent: Array, status: Array) -> None:
    """The linear part of an affine map, and its exponent."""
    if not _has_last_row(affine):
        status[0] = 1
    size = affine.shape[0] - 1
    largest = 0.0
    for i in range(size):
        for j in range(size):
            largest = max(largest, abs(affine[i, j]))
    power = math.frexp(largest)[1]
    power += power & 1
    exponent[0] = power
    for i in range(size):
        for j in range(size):
            linear[i, j, 0], linear[i, j, 1] = math.ldexp(affine[i, j], -power), 0.0


@compiled
def _column(affine: Array, j: int) -> Numbers:
    """A column of an affine map without its last row."""
    size = affine.shape[0] - 1
    column = np.empty(size, dtype=np.complex128)
    for i in range(size):
        column[i] = complex(affine[i, j], 0.0)
    return column


@compiled
def _linear(affine: Array) -> Numbers:
    size = affine.shape[0] - 1
    matrix = np.empty((size, size), dtype=np.complex128)
    for i in range(size):
        for j in range(size):
            matrix[i, j] = complex(affine[i, j], 0.0)
    return matrix


@kernel(
    inputs={"start": ("n", "n"), "end": ("n", "n")},
    outputs=(MATRIX, (), ()),
    refusals=(("start", LAST_ROW), ("end", LAST_ROW)),
    sizes=(3, 4),
)
def quotient(start: Array, end: Array, linear: Array, exponent: Array, sign: Array, status: Array) -> None:
    """The linear part of C B^-1, C the end and B the start, its exponent, and the sign of det B, 0 if not sure."""
    if not _has_last_row(start):
        status[0] = 1
    elif not _has_last_row(end):
        status[0] = 2
    exponent[0], sign[0] = matrix_quotient(_linear(end), _linear(start), linear)


@kernel(inputs={"affine": ("n", "n")}, outputs=(("n-1",), ()))
def fixed(affine: Array, point: Array, sure: Array, _status: Array) -> None:
    """The solution q of (I - L) q = t, and whether I - L is surely not singular."""
    matrix = _linear(affine)
    for i in range(len(matrix)):
        for j in range(len(matrix)):
            matrix[i, j] = exact_sum(1.0 if i == j else 0.0, -affine[i, j])
    sure[0] = 1.0 if solution(matrix, _column(affine, len(matrix)), point) else 0.0


@kernel(inputs={"linear": ("k", "k", 2)}, outputs=(VALUES, ()))
def eigenvalues(linear: Array, nodes: Array, existence: Array, _status: Array) -> None:
    """The eigenvalues of a linear part, and whether it has a real logarithm, as `affinecert.fast._spectrum` has it."""
    existence[0], found = spectrum(numbers(linear))
    write(settled(found), nodes)


@kernel(
    inputs={
        "affine": ("n", "n"),
        "linear": MATRIX,
        "existence": (),
        "setting": VALUES,
        "log": VALUES,
        "ratio": VALUES,
    },
    outputs=(("n", "n"),),
)
def tangent(
    affine: Array,
    linear: Array,
    existence: float,
    setting: Array,
    log: Array,
    ratio: Array,
    logarithm: Array,
    _status: Array,
) -> None:
    """The logarithm [[log L, v], [0, 0]], v = log(L) (L - I)^-1 t."""
    matrix = numbers(linear)
    m, delta, mu, _ = values(setting)
    nodes, half_turn = (m, delta, mu), existence == HALF_TURN
    size = len(matrix)
    for j in range(size + 1):
        function = values(log) if j < size else values(ratio)
        vector = _column(affine, j)
        if j < size:
            for i in range(size):
                vector[i] = complex(1.0 if i == j else 0.0, 0.0)
        column = applied(matrix, nodes, half_turn, function, vector, image(matrix, vector))
        for i in range(size):
            logarithm[i, j] = column[i].real
        logarithm[size, j] = 0.0


@kernel(
    inputs={
        "affine": ("n", "n"),
        "point": ("n-1",),
        "linear": MATRIX,
        "existence": (),
        "setting": VALUES,
        "log": VALUES,
        "ratio": VALUES,
    },
    outputs=(("n-1",),),
)
def rate(
    affine: Array,
    point: Array,
    linear: Array,
    existence: float,
    setting: Array,
    log: Array,
    ratio: Array,
    velocity: Array,
    _status: Array,
) -> None:
    """The velocity log(L) p + v."""
    matrix = numbers(linear)
    m, delta, mu, _ = values(setting)
    nodes, half_turn = (m, delta, mu), existence == HALF_TURN
    position, vector = _column(affine, 0), _column(affine, len(matrix))
    for i in range(len(matrix)):
        position[i] = complex(point[i], 0.0)
    turning = applied(matrix, nodes, half_turn, values(log), position, image(matrix, position))
    moving = applied(matrix, nodes, half_turn, values(ratio), vector, image(matrix, vector))
    for i in range(len(matrix)):
        velocity[i] = add(turning[i], moving[i]).real


@kernel(
    inputs={
        "start": ("n", "n"),
        "end": ("n", "n"),
        "t": (),
        "linear": MATRIX,
        "exponent": (),
        "existence": (),
        "setting": VALUES,
        "power": VALUES,
        "quotient": VALUES,
    },
    outputs=(("n", "n"),),
)
def motion(
    start: Array,
    end: Array,
    t: float,
    linear: Array,
    exponent: float,
    existence: float,
    setting: Array,
    power: Array,
    quotient: Array,
    pose: Array,
    _status: Array,
) -> None:
    """The pose A^t B for A = C B^-1, C the end and B the start: exactly these at t = 1 and t = 0.

    Products of A and B are taken from C, so that errors of the quotient weigh little. With the translations b and c,
    that of the pose is b + g(L) (c - b), g(x) = (x^t - 1) / (x - 1), or L^t b + g(L) (c - L b): the former if L
    lengthens, so that L b does not swamp c, the latter if it shortens, so that b does not.
    """
    matrix = numbers(linear)
    size = len(matrix)
    m, delta, mu, _ = values(setting)
    nodes, half_turn = (m, delta, mu), existence == HALF_TURN
    largest = max(abs(m.real) + math.sqrt(abs(delta.real)), abs(mu.real))
    lengthens = math.frexp(largest)[1] + exponent > 0.0
    for j in range(size + 1):
        column, moved = _column(start, j), _column(end, j)
        for i in range(size):
            if j < size:
                moved[i] = shifted(moved[i], -int(exponent))
            elif lengthens:
                moved[i] = subtract(moved[i], column[i])
        if j == size and not lengthens:
            turned = image(matrix, column)
            for i in range(size):
                moved[i] = subtract(moved[i], shifted(turned[i], int(exponent)))
            column = applied(matrix, nodes, half_turn, values(power), column, turned)
        if j < size:
            column = applied(matrix, nodes, half_turn, values(power), column, moved)
        else:
            moved = applied(matrix, nodes, half_turn, values(quotient), moved, image(matrix, moved))
        for i in range(size):
            pose[i, j] = add(column[i], moved[i]).real if j == size else column[i].real
        pose[size, j] = 1.0 if j == size else 0.0
    if t in (0.0, 1.0):
        for i in range(size):
            for j in range(size + 1):
                pose[i, j] = start[i, j] if t == 0.0 else end[i, j]
