"""What every function of `affinecert.fast` promises of batches, and says of bad input; and when kernels compile."""

from __future__ import annotations

import importlib
import itertools
import math
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba.core.caching
import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert.case import generate
from affinecert.catalogue import CATALOGUE
from affinecert.errors import InputError
from affinecert.fast import scale, se3, shear, so3
from affinecert.fast._kernel import kernel
from affinecert.map import Map

MAPS = tuple(CATALOGUE.values())
SEVERAL = tuple(entry for entry in MAPS if len(entry.arguments) > 1)
FREE = {"times", "segments", "dims", "keys"}
"""Last sizes of arguments that may be any number."""

BATCH = 6


def named(entry: Map) -> str:
    return entry.name


def function(entry: Map) -> Callable[..., Any]:
    module = importlib.import_module(f"affinecert.fast.{entry.family}")
    return getattr(module, entry.name.partition(".")[2])  # type: ignore[no-any-return]


def as_tuple(result: Any) -> tuple[NDArray[Any], ...]:
    return result if isinstance(result, tuple) else (result,)


def accepted(entry: Map) -> tuple[NDArray[np.float64], ...]:
    """Arguments of a batch drawn from every regime, all of one shape, and none refused."""
    cases: list[tuple[NDArray[np.float64], ...]] = []
    shapes = None
    for regime in entry.regimes:
        for case in generate(entry, regime, 2, seed=1):
            if shapes not in (None, [x.shape for x in case.inputs]):
                continue
            try:
                function(entry)(*case.inputs)
            except InputError:
                continue
            shapes = [x.shape for x in case.inputs]
            cases.append(case.inputs)
    chosen = [cases[i % len(cases)] for i in range(BATCH)]
    return tuple(np.stack(column) for column in zip(*chosen, strict=True))


def same_bits(one: Any, other: Any) -> bool:
    return all(
        a.shape == b.shape and a.dtype == b.dtype and a.tobytes() == b.tobytes()
        for a, b in zip(as_tuple(one), as_tuple(other), strict=True)
    )


def run(code: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code], env=os.environ | environment, capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize("entry", MAPS, ids=named)
def test_an_item_alone_has_the_bits_it_has_in_a_batch(entry: Map) -> None:
    inputs = accepted(entry)
    whole = as_tuple(function(entry)(*inputs))
    for i in range(BATCH):
        alone = as_tuple(function(entry)(*(x[i] for x in inputs)))
        assert same_bits(alone, tuple(output[i] for output in whole))


@pytest.mark.parametrize("entry", MAPS, ids=named)
def test_any_batch_shape_and_any_memory_layout(entry: Map) -> None:
    inputs = accepted(entry)
    whole = as_tuple(function(entry)(*inputs))
    shaped = function(entry)(*(x.reshape(2, 1, 3, *x.shape[1:]) for x in inputs))
    assert same_bits(shaped, tuple(output.reshape(2, 1, 3, *output.shape[1:]) for output in whole))
    backwards = function(entry)(*(np.asfortranarray(x)[::-1] for x in inputs))
    assert same_bits(backwards, tuple(output[::-1] for output in whole))
    for x in inputs:
        x.flags.writeable = False
    assert same_bits(function(entry)(*inputs), whole)


@pytest.mark.parametrize("entry", SEVERAL, ids=named)
def test_arguments_broadcast(entry: Map) -> None:
    # The last argument varies: a time or a point goes with any of the others, as one matrix need not with another.
    *rest, last = accepted(entry)
    held = function(entry)(*(x[0] for x in rest), last)
    assert same_bits(held, function(entry)(*(np.repeat(x[:1], BATCH, axis=0) for x in rest), last))
    crossed = as_tuple(function(entry)(*(x[:1] for x in rest), last[:2, None]))
    assert all(output.shape[:2] == (2, 1) for output in crossed)


@pytest.mark.parametrize("entry", MAPS, ids=named)
def test_an_empty_batch_gives_an_empty_batch(entry: Map) -> None:
    inputs = accepted(entry)
    whole = as_tuple(function(entry)(*inputs))
    assert [o.shape for o in as_tuple(function(entry)(*(x[:0] for x in inputs)))] == [(0, *o.shape[1:]) for o in whole]
    hollow = as_tuple(function(entry)(*(np.empty((3, 0, *x.shape[1:])) for x in inputs)))
    assert [o.shape for o in hollow] == [(3, 0, *o.shape[1:]) for o in whole]


@pytest.mark.parametrize("entry", MAPS, ids=named)
def test_python_numbers_and_lists_are_taken(entry: Map) -> None:
    inputs = accepted(entry)
    assert same_bits(function(entry)(*(x.tolist() for x in inputs)), function(entry)(*inputs))
    item = tuple(x[0] for x in inputs)
    assert same_bits(function(entry)(*(x.tolist() for x in item)), function(entry)(*item))


@pytest.mark.parametrize("entry", MAPS, ids=named)
def test_wrong_shapes_are_named(entry: Map) -> None:
    inputs = accepted(entry)
    for number, argument in enumerate(entry.arguments):
        if not argument.shape:
            continue
        # Of a number of things, one less is another number of things.
        shorter = [inputs[number][..., :-1]] if argument.shape[-1] not in FREE else []
        for wrong in (*shorter, inputs[number].ravel()[0]):
            with pytest.raises(InputError, match=rf"^{argument.name}: shape .* is due") as caught:
                function(entry)(*inputs[:number], wrong, *inputs[number + 1 :])
            assert caught.value.argument == argument.name


@pytest.mark.parametrize("dtype", ["float32", "int64", "complex128", "object", "bool"])
@pytest.mark.parametrize("entry", MAPS, ids=named)
def test_other_dtypes_are_refused(entry: Map, dtype: str) -> None:
    inputs = accepted(entry)
    for number, argument in enumerate(entry.arguments):
        wrong = np.ones(inputs[number].shape, dtype=dtype)
        with pytest.raises(InputError, match=f"^{argument.name}: dtype {dtype} where float64 is due"):
            function(entry)(*inputs[:number], wrong, *inputs[number + 1 :])


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("entry", MAPS, ids=named)
def test_the_item_that_is_not_finite_is_named(entry: Map, bad: float) -> None:
    for number, argument in enumerate(entry.arguments):
        inputs = accepted(entry)
        inputs[number][(4, *(-1 for _ in inputs[number].shape[1:]))] = bad
        with pytest.raises(InputError, match=rf"^{argument.name}\[4\]: not finite") as caught:
            function(entry)(*inputs)
        assert caught.value.index == (4,)


REFLECTION = np.diag([1.0, 1.0, -1.0])
SKEWED = np.eye(3) + 1e-5
MOVED = np.eye(4)
MOVED[:3, :3] = SKEWED
PROJECTIVE = np.eye(4)
PROJECTIVE[3, 0] = 1e-300
REFUSED: tuple[tuple[Callable[..., Any], Any, Any, str], ...] = (
    (so3.log, np.eye(3), SKEWED, "rotation[1, 2]: not a rotation: |R^T R - I| is above 1e-6"),
    (so3.log, np.eye(3), REFLECTION, "rotation[1, 2]: not a rotation: its determinant is negative"),
    (so3.log, np.eye(3), np.full((3, 3), 1e200), "rotation[1, 2]: not a rotation"),
    (se3.log, np.eye(4), MOVED, "pose[1, 2]: not a rotation"),
    (se3.log, np.eye(4), PROJECTIVE, "pose[1, 2]: last row"),
    (shear.log, np.eye(3), np.eye(3).T[::-1], "shear[1, 2]: not a shear"),
    (shear.log, np.eye(3), np.diag([1.0, 1.0, 0.0]), "shear[1, 2]: diagonal of the shear is not positive"),
    (shear.log, np.eye(3), np.diag([1.0, -1.0, 1.0]), "shear[1, 2]: diagonal of the shear is not positive"),
    (scale.log, 1.0, 0.0, "scale[1, 2]: not positive"),
    (scale.log, 1.0, -1.0, "scale[1, 2]: not positive"),
)


@pytest.mark.parametrize(("log", "good", "bad", "message"), REFUSED)
def test_the_item_outside_the_domain_is_named(log: Callable[..., Any], good: Any, bad: Any, message: str) -> None:
    batch = np.broadcast_to(good, (2, 3, *np.shape(good))).copy()
    log(batch)
    batch[1, 2] = bad
    with pytest.raises(InputError) as caught:
        log(batch)
    assert str(caught.value).startswith(message)
    assert caught.value.index == (1, 2)
    with pytest.raises(InputError) as caught:
        log(bad)
    assert caught.value.index == ()


def test_the_index_is_that_of_the_argument_itself() -> None:
    rotations = np.stack([np.eye(3), REFLECTION])
    with pytest.raises(InputError, match=r"^rotation\[1\]: not a rotation"):
        so3.log_near(rotations, np.zeros((4, 2, 3)))
    with pytest.raises(InputError, match=r"^rotation\[1, 0\]: not a rotation"):
        so3.log_near(rotations[:, None], np.zeros((2, 5, 3)))
    with pytest.raises(InputError, match=r"^rotation: not a rotation"):
        so3.log_near(REFLECTION, np.zeros((5, 3)))


def test_batches_that_do_not_broadcast() -> None:
    with pytest.raises(
        InputError, match=r"^near: shape: the batches do not broadcast \(rotation \(2,\), near \(3,\)\)"
    ):
        so3.log_near(np.stack([np.eye(3)] * 2), np.zeros((3, 3)))


@pytest.mark.parametrize("ragged", [[[1.0, 2.0], [3.0]], "text", None, [None, 1.0, 2.0]])
def test_what_is_no_array_of_numbers(ragged: Any) -> None:
    with pytest.raises(InputError, match=r"^omega: (shape: not an array|dtype)"):
        so3.exp(ragged)


@kernel(inputs={"matrix": ("n", "n"), "point": ("n-1",)}, outputs=(("n-1",), ()), sizes=(3, 4))
def _sized(matrix: Any, point: Any, moved: Any, trace: Any, _status: Any) -> None:
    trace[0] = 0.0
    for i in range(matrix.shape[0]):
        trace[0] += matrix[i, i]
    for i in range(point.shape[0]):
        moved[i] = 2.0 * point[i]


def test_named_sizes() -> None:
    for n in (3, 4):
        moved, trace = _sized(np.eye(n), np.ones((2, n - 1)))
        assert moved.tolist() == [[2.0] * (n - 1)] * 2
        assert trace.tolist() == [n, n]
    with pytest.raises(InputError, match=r"^matrix: shape \(2, 2\) where \(..., n, n\) is due, n one of \(3, 4\)"):
        _sized(np.eye(2), np.ones(1))
    with pytest.raises(InputError, match=r"^point: shape \(2,\) where \(..., 3\) is due"):
        _sized(np.eye(4), np.ones(2))


def test_a_kernel_compiles_where_no_cache_can_be_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numba.core.caching.CacheImpl, "_locator_classes", [])

    @kernel(inputs={"x": ()}, outputs=((),))
    def double(x: float, y: Any, _status: Any) -> None:
        y[0] = 2.0 * x

    assert double(3.0)[0] == 6.0


COUNTED = """
import importlib
from numba.core import event
with event.install_recorder("numba:run_pass") as recorder:
    {code}
print(len(recorder.buffer))
"""


def test_importing_compiles_nothing(tmp_path: Path) -> None:
    modules = ["affinecert", *(f"affinecert.fast.{family}" for family in {entry.family for entry in MAPS})]
    code = COUNTED.format(code=f"[importlib.import_module(name) for name in {modules}]")
    result = run(code, NUMBA_CACHE_DIR=str(tmp_path))
    assert result.stdout == "0\n", result.stderr
    assert not list(tmp_path.iterdir())


def test_a_kernel_is_compiled_once_and_then_read_from_disk(tmp_path: Path) -> None:
    code = COUNTED.format(code="importlib.import_module('affinecert.fast.scale').log(2.0)")
    counts = [run(code, NUMBA_CACHE_DIR=str(tmp_path)).stdout.strip() for _ in range(2)]
    assert int(counts[0]) > 0
    assert counts[1] == "0"


TOGETHER = """
import sys
from affinecert.fast import scale, so3
{before}
print("ready", flush=True)
sys.stdin.readline()
so3.log([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
"""


def test_processes_may_compile_at_the_same_time(tmp_path: Path) -> None:
    # One has a kernel more behind it, so that numba numbers the next one differently; files of both would not match.
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
    for _ in range(2):
        together = [
            subprocess.Popen(
                [sys.executable, "-c", TOGETHER.format(before=before)],
                env=environment,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
            )
            for before in ("", "scale.exp(1.0)")
        ]
        for process in together:
            assert process.stdout is not None
            assert process.stdout.readline() == "ready\n"
        for process in together:
            process.communicate("go\n")
        assert [process.returncode for process in together] == [0, 0]


@pytest.mark.parametrize("axis", [a for a in itertools.product((-1, 0, 1), repeat=3) if any(a)], ids=str)
def test_axes_with_equal_entries(axis: tuple[int, int, int]) -> None:
    # Here the four entries of a quaternion, among which the largest is chosen, are equal by twos, threes and fours.
    unit = np.array(axis) / math.sqrt(sum(x * x for x in axis))
    for angle in (1e-300, 1e-8, 1.0, math.pi / 2, 2 * math.pi / 3, 3.0):
        assert np.linalg.norm(so3.log(so3.exp(angle * unit)) - angle * unit) <= 1e-14 * angle
    vector = so3.log(2 * np.outer(unit, unit) - np.eye(3))
    assert np.linalg.norm(np.abs(vector) - math.pi * np.abs(unit)) <= 1e-14
    assert vector[np.flatnonzero(vector)[0]] > 0
