"""Culver's theorem, by counting Jordan blocks in rational arithmetic: what the paper's conditions are held against."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from typing import Any

import numpy as np

from affinecert.properties.claims.precision import mp
from affinecert.reference._matrices import Array, identity

Block = tuple[int, int]
"""Eigenvalue and size of a Jordan block."""


def has_real_logarithm(blocks: tuple[Block, ...]) -> bool:
    """Whether an invertible matrix has a real logarithm: negative eigenvalues' blocks come in pairs (Culver 1966)."""
    return all(count % 2 == 0 for (value, _), count in Counter(blocks).items() if value < 0)


def matrix_of(blocks: tuple[Block, ...]) -> Array:
    """An integer matrix with those Jordan blocks, in a basis that is not theirs."""
    size = sum(each for _, each in blocks)
    middle = np.full((size, size), 0, dtype=object)
    at = 0
    for value, length in blocks:
        for k in range(at, at + length):
            middle[k, k] = value
            if k > at:
                middle[k - 1, k] = 1
        at += length
    change = np.array([[int(j >= i) for j in range(size)] for i in range(size)], dtype=object)
    back = np.array([[int(j == i) - int(j == i + 1) for j in range(size)] for i in range(size)], dtype=object)
    similar: Array = change.T @ (change @ middle @ back) @ back.T
    return similar


def real_logarithm(value: int, size: int) -> tuple[Array, Array]:
    """Two equal blocks of a negative eigenvalue, in real form, and a real logarithm of them."""
    unit, turn = identity(mp, 2), np.array([[0, -mp.pi], [mp.pi, 0]], dtype=object)
    step = np.array([[mp.mpf(int(j == i + 1)) for j in range(size)] for i in range(size)], dtype=object)
    whole, power, log = identity(mp, size), step / value, step * mp.zero
    for k in range(1, size):
        log = log + (-1) ** (k + 1) * power / k
        power = power @ step / value
    pair = np.kron(whole * value + step, unit)
    generator = np.kron(whole, unit * mp.log(-value) + turn) + np.kron(log, unit)
    return pair, generator


def blocks_of(matrix: Any, value: int) -> tuple[int, ...]:
    """The numbers of Jordan blocks of the sizes 1, 2, ... that a rational matrix has for an eigenvalue."""
    size = len(matrix)
    shifted = np.array(matrix, dtype=object) - value * np.eye(size, dtype=int).astype(object)
    power, ranks = np.eye(size, dtype=int).astype(object), [size]
    for _ in range(size + 1):
        power = power @ shifted
        ranks.append(_rank(power))
    return tuple(ranks[k - 1] - 2 * ranks[k] + ranks[k + 1] for k in range(1, size + 1))


def integer_matrix_has_real_logarithm(matrix: Any) -> bool:
    """The same of an integer matrix that is invertible and whose negative eigenvalues are integers above -20."""
    return all(count % 2 == 0 for value in range(-20, 0) for count in blocks_of(matrix, value))


def _rank(matrix: Any) -> int:
    rows = [[Fraction(int(each)) for each in row] for row in matrix]
    rank = 0
    for column in range(len(rows)):
        pivot = next((k for k in range(rank, len(rows)) if rows[k][column]), None)
        if pivot is None:
            continue
        rows[rank], rows[pivot] = rows[pivot], rows[rank]
        for k in range(rank + 1, len(rows)):
            factor = rows[k][column] / rows[rank][column]
            rows[k] = [x - factor * y for x, y in zip(rows[k], rows[rank], strict=True)]
        rank += 1
    return rank
