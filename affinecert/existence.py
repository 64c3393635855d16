"""The sweep over sam.exists: `fast` against the exact decision, on random matrices and adversaries near the border."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass

import numpy as np

from affinecert.executor import executor
from affinecert.map import Array

CHUNK = 20_000
"""Matrices a task: about a second of exact arithmetic."""


@dataclass(frozen=True)
class Sweep:
    """The outcome: matrices tried, how many of them have a real logarithm, and those that `fast` decides wrongly."""

    tried: int
    exist: int
    wrong: tuple[tuple[tuple[float, ...], ...], ...]


def _gaussian(generator: np.random.Generator, count: int, size: int) -> Array:
    return generator.standard_normal((count, size, size))


def _integers(generator: np.random.Generator, count: int, size: int) -> Array:
    """Small integers: the border itself is hit all the time, exactly."""
    return generator.integers(-4, 5, (count, size, size)).astype(np.float64)


def _negative_double_root(generator: np.random.Generator, count: int, size: int) -> Array:
    """P J P^-1 with a double negative eigenvalue, defective half of the time; exact, as P is unimodular."""
    middle = np.zeros((count, size, size))
    middle[:, [0, 1], [0, 1]] = -generator.integers(1, 9, (count, 1))
    middle[:, 0, 1] = generator.integers(0, 2, count)
    if size == 3:
        middle[:, 2, 2] = generator.integers(1, 9, count)
    lower, upper = np.tril(np.ones((size, size)), -1), np.triu(np.ones((size, size)), 1)
    shears = generator.integers(-2, 3, (2, count, size, size)) * np.stack([lower, upper])[:, None] + np.eye(size)
    change = shears[0] @ shears[1]
    # The inverse of a unimodular integer matrix is one; rint restores it from its rounded value.
    return np.asarray(change @ middle @ np.rint(np.linalg.inv(change)))


def _scaled(generator: np.random.Generator, matrices: Array) -> Array:
    """Times powers of two, exactly: the decision does not change, the size of every intermediate result does."""
    return np.ldexp(matrices, generator.integers(-300, 301, (len(matrices), 1, 1)))


def _nudged(generator: np.random.Generator, matrices: Array) -> Array:
    """Every entry moved by at most two units in the last place."""
    return matrices + generator.integers(-2, 3, matrices.shape) * np.spacing(matrices)


def _near_border(generator: np.random.Generator, count: int, size: int) -> Array:
    """The discriminant of one 2x2 block is made as small as rounding lets it be, in a random frame."""
    blocks = np.zeros((count, size, size))
    a, b, d = -generator.random((3, count)) - 0.5
    blocks[:, 0, 0], blocks[:, 1, 1], blocks[:, 0, 1] = a, d, b
    blocks[:, 1, 0] = -((a - d) ** 2) / (4 * b) * (1 + generator.integers(-3, 4, count) * 2.0**-52)
    if size == 3:
        blocks[:, 2, 2] = generator.random(count) + 0.5
        change = generator.integers(-2, 3, (count, 3, 3)) * np.tril(np.ones((3, 3)), -1) + np.eye(3)
        return np.asarray(change @ blocks @ np.rint(np.linalg.inv(change)))
    return blocks


KINDS: Mapping[str, Callable[[np.random.Generator, int, int], Array]] = {
    "gaussian": _gaussian,
    "integers": _integers,
    "integers nudged": lambda g, count, size: _nudged(g, _integers(g, count, size)),
    "double root": _negative_double_root,
    "double root scaled": lambda g, count, size: _scaled(g, _negative_double_root(g, count, size)),
    "double root nudged": lambda g, count, size: _nudged(g, _scaled(g, _negative_double_root(g, count, size))),
    "near the border": _near_border,
    "near the border nudged": lambda g, count, size: _nudged(g, _near_border(g, count, size)),
}
"""The generators, by name; each makes ``count`` square matrices of a size."""


def try_chunk(kind: str, size: int, count: int, seed: int) -> Sweep:
    """One chunk; matrices whose determinant is not safely positive are turned over or left out."""
    from affinecert.fast import sam as fast_sam  # noqa: PLC0415
    from affinecert.reference import sam as reference_sam  # noqa: PLC0415

    generator = np.random.default_rng([seed, size, list(KINDS).index(kind)])
    linear = KINDS[kind](generator, count, size)
    exponents = np.frexp(np.max(np.abs(linear), axis=(1, 2), keepdims=True))[1]
    with np.errstate(divide="ignore"):  # of singular matrices, which are left out
        determinant = np.linalg.det(np.ldexp(linear, -exponents))
    linear[determinant < 0, 0] *= -1.0
    linear = linear[np.abs(determinant) > 1e-9]
    affine = np.zeros((len(linear), size + 1, size + 1))
    affine[:, :size, :size] = linear
    affine[:, size, size] = 1.0
    answers = fast_sam.exists(affine)
    exact = np.array([reference_sam.exists_exactly(rows) for rows in linear.tolist()], dtype=bool)
    wrong = linear[answers != exact].tolist()
    return Sweep(len(linear), int(exact.sum()), tuple(tuple(map(tuple, rows)) for rows in wrong))


def sweep(
    count: int = 10_000_000,
    seed: int = 0,
    jobs: int = 1,
    progress: Callable[[int, int], None] = lambda done, all_: None,
) -> Sweep:
    """At least ``count`` matrices, spread evenly over the kinds and over the plane and space."""
    tried, exist, number = 0, 0, 0
    wrong: list[tuple[tuple[float, ...], ...]] = []
    with executor(jobs) as submit:
        pending: set[Future[Sweep]] = set()
        while tried < count or pending:
            while tried + CHUNK * len(pending) < count and len(pending) < 2 * jobs:
                kind = list(KINDS)[number // 2 % len(KINDS)]
                pending.add(submit(try_chunk, kind, 2 + number % 2, CHUNK, seed + number))
                number += 1
            finished, pending = wait(pending, return_when=FIRST_COMPLETED)
            for future in finished:
                part = future.result()
                tried, exist = tried + part.tried, exist + part.exist
                wrong += part.wrong
            progress(min(tried, count), count)
    return Sweep(tried, exist, tuple(wrong))
