"""Kaji and Ochiai's closed exponential and logarithm of symmetric matrices, beside what they compete with.

The claim is a ratio: in every round the closed form and its competitor take turns, forth and back, so that whatever
slows the machine down slows both. ``extra_info`` has the median of the rounds' ratios, as ``times_closed_form``.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping
from functools import cache

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture
from threadpoolctl import threadpool_limits

from affinecert.map import Array
from affinecert.properties.claims.kaji_ochiai import closed_forms

TURNS = 15
"""Rounds of closed form, competitor, competitor, closed form."""

MANY, FEW = 10_000, 100
"""Matrices a call; SciPy's logarithm takes a millisecond for each, and is timed on few."""

METHODS: Mapping[tuple[str, int], Mapping[str, Callable[[Array], Array]]] = {
    ("exp", MANY): {
        "closed form": closed_forms.exponential,
        "diagonalisation": closed_forms.diagonalised(np.exp),
        "Padé": closed_forms.pade_exponential,
    },
    ("log", MANY): {"closed form": closed_forms.logarithm, "diagonalisation": closed_forms.diagonalised(np.log)},
    ("log", FEW): {"closed form": closed_forms.logarithm, "Padé": closed_forms.pade_logarithm},
}


@cache
def matrices(function: str, size: int) -> Array:
    """Random symmetric matrices with normal entries, or their exponentials."""
    entries = np.random.default_rng(0).normal(size=(size, 3, 3))
    symmetric = (entries + entries.transpose(0, 2, 1)) / 2
    return np.asarray(symmetric if function == "exp" else closed_forms.diagonalised(np.exp)(symmetric))


def elapsed(method: Callable[[Array], Array], given: Array) -> float:
    """The seconds of one call."""
    started = time.perf_counter()
    method(given)
    return time.perf_counter() - started


def ratio(method: Callable[[Array], Array], closed_form: Callable[[Array], Array], given: Array) -> float:
    """How many times as long as the closed form a method takes: the median of the rounds' ratios."""
    rounds = [[elapsed(call, given) for call in (closed_form, method, method, closed_form)] for _ in range(TURNS)]
    return statistics.median((second + third) / (first + fourth) for first, second, third, fourth in rounds)


@pytest.mark.parametrize(
    ("function", "size", "method"), [(*key, method) for key, methods in METHODS.items() for method in methods]
)
def test_closed_form(benchmark: BenchmarkFixture, function: str, size: int, method: str) -> None:
    """The time of a method, and the ratio to that of the closed form; one thread each."""
    methods, given = METHODS[function, size], matrices(function, size)
    call = methods[method]
    call(given)  # touches the pages
    name = f"{function} of symmetric matrices"
    benchmark.group = f"{name}, {size} items"
    benchmark.extra_info.update(map=name, size=size, implementation=method)
    with threadpool_limits(1):
        benchmark.extra_info["times_closed_form"] = ratio(call, methods["closed form"], given)
        benchmark.pedantic(call, (given,), rounds=TURNS)
