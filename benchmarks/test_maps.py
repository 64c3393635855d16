"""Every map of `fast`, beside SciPy where it has the map, a plain copy of the output, and the reference."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from affinecert.benchmarks.workload import Accuracy, accuracy, batch
from affinecert.catalogue import CATALOGUE
from affinecert.errors import SubjectError
from affinecert.map import Array
from affinecert.subject import Subject, load

SIZES = (1, 100, 10_000, 1_000_000)
IMPLEMENTATIONS = ("copy", "fast", "scipy", "reference")

SECONDS = 0.2
"""The time that one benchmark may take, warming up not counted; at least MOST_PATIENT rounds are made in any case."""

ROUNDS = (3, 200)
"""The fewest and the most rounds: the fewest for a median, the most so that a table of all is made in minutes."""

ROUND = 50e-6
"""Seconds that a round lasts at least, by repetition: a thousand times the resolution of the clock."""

TOO_LONG = 2.0
"""Seconds for a single call above which a size is left out, as guessed from a batch of 100."""

TOO_LARGE = 2**30
"""Bytes of inputs and outputs above which a size is left out."""


@cache
def subject(name: str) -> Subject:
    """The built-in subject of that name."""
    return load(name)


@cache
def exactness(implementation: str, name: str) -> Accuracy:
    """The accuracy of an implementation on a map, measured once."""
    return accuracy(subject(implementation), name)


def offered(implementation: str, name: str) -> bool:
    """Whether there is anything to time; SciPy may not be installed."""
    try:
        return implementation == "copy" or name in subject(implementation).maps
    except SubjectError:
        if implementation != "scipy":
            raise
        return False


def work(implementation: str, name: str, inputs: tuple[Array, ...]) -> Callable[[], Any]:
    """The call to time. A copy is of the outputs of `fast`: memory traffic that no implementation can avoid."""
    if implementation != "copy":
        function = subject(implementation).maps[name]
        return lambda: function(*inputs)
    few = subject("fast").maps[name](*(array[:100] for array in inputs))
    arrays = [np.asarray(output) for output in (few if isinstance(few, tuple) else (few,))]
    outputs = [np.resize(array, (len(inputs[0]), *array.shape[1:])) for array in arrays]
    return lambda: [output.copy() for output in outputs]


def elapsed(call: Callable[[], Any]) -> float:
    """The seconds of one call."""
    started = time.perf_counter()
    call()
    return time.perf_counter() - started


def nbytes(result: Any) -> int:
    """The bytes of the arrays that a call returned."""
    return sum(np.asarray(output).nbytes for output in (result if isinstance(result, tuple) else (result,)))


def why_not(implementation: str, name: str, size: int) -> str | None:
    """Why a size is left out, judged by a small batch."""
    if implementation == "reference" and size > 1:
        return "the reference is timed on single items"
    if size <= 100:
        return None
    inputs = batch(CATALOGUE[name], 100)
    call = work(implementation, name, inputs)
    call()
    if (seconds := elapsed(call) * size / 100) > TOO_LONG:
        return f"about {seconds:.0f} s a call"
    items = sum(array.nbytes for array in inputs) + nbytes(subject("fast").maps[name](*inputs))
    if items * size / 100 > TOO_LARGE:
        return f"{items * size / 100 / 2**30:.1f} GiB of arrays"
    return None


@pytest.mark.parametrize("implementation", IMPLEMENTATIONS)
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", sorted(CATALOGUE))
def test_map(benchmark: BenchmarkFixture, name: str, size: int, implementation: str) -> None:
    """The time of an implementation of a map on a batch."""
    if not offered(implementation, name):
        pytest.skip(f"{implementation} has no {name}")
    reason = why_not(implementation, name, size)
    if reason is not None:
        pytest.skip(reason)
    call = work(implementation, name, batch(CATALOGUE[name], size))
    call()  # compiles the kernel, and touches the pages
    once = elapsed(call)
    iterations = max(1, round(ROUND / once))
    rounds = round(SECONDS / (once * iterations))
    benchmark.group = f"{name}, {size} items"
    benchmark.extra_info.update(map=name, size=size, implementation=implementation)
    if implementation in {"fast", "scipy"}:
        worst = exactness(implementation, name)
        benchmark.extra_info.update(worst_forward=str(worst.forward), worst_scaled=str(worst.scaled))
    benchmark.pedantic(call, rounds=min(max(rounds, ROUNDS[0]), ROUNDS[1]), iterations=iterations)
