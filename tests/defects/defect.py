"""What a seeded defect is, and the few pieces of linear algebra that the defects are written with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from affinecert.scoring import Verdict

Array = NDArray[Any]


@dataclass(frozen=True)
class Defect:
    """A bug that somebody could well write; the regime where it has to be seen, and as what."""

    name: str
    map: str
    function: Callable[..., Any]
    regime: str
    verdict: Verdict


DEFECTS: list[Defect] = []


def seeded(
    entry: str, regime: str, verdict: Verdict = Verdict.WRONG
) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Enters a function of that map among the defects; its name and docstring say what is wrong with it."""

    def enter(function: Callable[..., Any]) -> Callable[..., Any]:
        DEFECTS.append(Defect(function.__name__, entry, function, regime, verdict))
        return function

    return enter


def skew(omega: Array) -> Array:
    """The cross product matrices (N, 3, 3) of vectors (N, 3)."""
    x, y, z = np.moveaxis(omega, -1, 0)
    zero = np.zeros_like(x)
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(*x.shape, 3, 3)


def unskew(matrix: Array) -> Array:
    """The vectors (N, 3) of the antisymmetric parts of matrices (N, 3, 3)."""
    twice = matrix - np.swapaxes(matrix, -1, -2)
    return np.stack([twice[:, 2, 1], twice[:, 0, 2], twice[:, 1, 0]], axis=-1) / 2


def trace(matrix: Array) -> Array:
    """The traces (N,) of matrices (N, n, n)."""
    return np.asarray(np.trace(matrix, axis1=-2, axis2=-1))


def homogeneous(linear: Array, translation: Array) -> Array:
    """The affine maps (N, n, n) of linear parts (N, n - 1, n - 1) and translations (N, n - 1)."""
    size = translation.shape[-1]
    affine = np.zeros((len(linear), size + 1, size + 1))
    affine[:, :size, :size] = linear
    affine[:, :size, size] = translation
    affine[:, size, size] = 1.0
    return affine


def parts(affine: Array) -> tuple[Array, Array]:
    """The linear parts and translations of affine maps (N, n, n)."""
    return affine[:, :-1, :-1], affine[:, :-1, -1]


def times(matrix: Array, vector: Array) -> Array:
    """The products (N, m) of matrices (N, m, m) and vectors (N, m)."""
    return np.asarray((matrix @ vector[..., None])[..., 0])


def column(number: Array) -> Array:
    """Numbers (N,) as (N, 1), to multiply vectors."""
    return number[:, None]


def block(number: Array) -> Array:
    """Numbers (N,) as (N, 1, 1), to multiply matrices."""
    return number[:, None, None]
