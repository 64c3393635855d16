"""The common wrapper of the compiled kernels: checks, broadcasting, output, refusals; compiling at the first call.

A kernel is a plain function of one item: it reads its inputs and writes its outputs and a status. Numba makes a NumPy
generalised ufunc of it, which loops over the batch. Neither knows dimensions that are constant or occur in an output
only, such as (6) -> (4, 4); so the outputs are allocated here and handed over as writable inputs.
"""

from __future__ import annotations

import getpass
import hashlib
import re
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
import numpy as np
from numpy.typing import ArrayLike, NDArray

from affinecert.errors import InputError

Array = NDArray[np.float64]
Shape = tuple[int | str, ...]
"""The shape of one item: sizes, and names of sizes such as ``"n"``, ``"n-1"`` and ``"keys"``."""

DIMENSIONS = ("n", "d")
"""The names of sizes of homogeneous and of linear matrices."""

F = TypeVar("F", bound=Callable[..., Any])


def compiled(function: F) -> F:
    """Compiles, when first called, a function that kernels call; it divides as IEEE 754 says, also by zero."""
    return cast(F, numba.njit(error_model="numpy")(function))


def _source_digest() -> str:
    digest = hashlib.sha256()
    for path in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(path.read_bytes())
    return digest.hexdigest()[:12]


SOURCES = _source_digest()
"""A digest of the sources of this folder, part of the name under which numba keeps a kernel on disk.

The kernel must not outlive what it calls; numba itself looks only at the file that holds the kernel. Taken at import,
as close as can be to when the sources are read.
"""


@contextmanager
def _one_process_at_a_time(name: str) -> Iterator[None]:
    """Holds a lock file while a kernel of that name is compiled or read from disk.

    Numba keeps a kernel and its ufunc loop in two files, and the loop calls the kernel by a name with a number that
    differs from process to process. Two processes that compile at once may leave files of one and the other, and
    whoever reads these crashes. There is no such lock on Windows, nor where no temporary file can be written.
    """
    try:
        import fcntl  # noqa: PLC0415 - not on Windows

        lock = (Path(tempfile.gettempdir()) / f"affinecert-{getpass.getuser()}-{name}.lock").open("a")
    except (ImportError, OSError, KeyError):
        yield
        return
    with lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def as_float64(name: str, value: ArrayLike) -> Array:
    """The argument as a float64 array; Python numbers and sequences of them are converted, other dtypes refused."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise InputError(name, f"shape: not an array ({error})") from error
    if array.dtype == np.float64:
        return array
    if array.dtype.kind in "iu" and not isinstance(value, (np.ndarray, np.generic)):
        return array.astype(np.float64)
    raise InputError(name, f"dtype {array.dtype} where float64 is due")


def resolve(spec: int | str, sizes: Mapping[str, int]) -> int | str:
    """A size of a shape as a number, or as it stands while its name is not settled."""
    if isinstance(spec, int):
        return spec
    name = re.split("[+-]", spec)[0]
    return sizes[name] + int(spec.removeprefix(name) or 0) if name in sizes else spec


def _symbol(shape: Shape) -> str:
    """The shape in the notation of NumPy's generalised ufunc signatures."""
    return "(" + ",".join(f"size_{spec}".replace("-", "_less_").replace("+", "_more_") for spec in shape) + ")"


def _first_false(good: NDArray[np.bool_]) -> tuple[int, ...]:
    return tuple(int(i) for i in np.unravel_index(int(np.argmin(good)), good.shape))


def _batch(name: str, shape: Shape, array: Array, sizes: dict[str, int], allowed: tuple[int, ...]) -> tuple[int, ...]:
    """The leading shape of an argument; settles the named sizes that it is the first to show."""
    count = len(shape)
    batch, item = array.shape[: max(array.ndim - count, 0)], array.shape[max(array.ndim - count, 0) :]
    for spec, size in zip(shape, item, strict=False):
        if isinstance(spec, str) and spec.isidentifier() and (size in allowed or spec not in DIMENSIONS):
            sizes.setdefault(spec, size)
    due = tuple(resolve(spec, sizes) for spec in shape)
    if item != due:
        told = ", ".join(["...", *map(str, due)])
        where = f", n one of {allowed}" if any(str(size).partition("-")[0] in DIMENSIONS for size in due) else ""
        raise InputError(name, f"shape {array.shape} where ({told}) is due{where}")
    return batch


def checked(
    inputs: Mapping[str, Shape], arguments: Sequence[ArrayLike], allowed: tuple[int, ...] = ()
) -> tuple[list[Array], list[tuple[int, ...]], dict[str, int]]:
    """The arguments as float64 arrays, their batch shapes, and the sizes that were named.

    InputError for a wrong shape or dtype, a number that is not finite, and batches that do not broadcast. ``allowed``
    holds the values that n and d may take; any other name is a number of things.
    """
    arrays = [as_float64(name, value) for name, value in zip(inputs, arguments, strict=True)]
    sizes: dict[str, int] = {}
    batches = [
        _batch(name, shape, array, sizes, allowed) for (name, shape), array in zip(inputs.items(), arrays, strict=True)
    ]
    for name, batch, array in zip(inputs, batches, arrays, strict=True):
        finite = np.isfinite(array)
        if not finite.all():
            good = finite.all(axis=tuple(range(len(batch), array.ndim)))
            raise InputError(name, "not finite", _first_false(np.asarray(good)))
    try:
        np.broadcast_shapes(*batches)
    except ValueError as error:
        told = ", ".join(f"{name} {shape}" for name, shape in zip(inputs, batches, strict=True))
        raise InputError(list(inputs)[-1], f"shape: the batches do not broadcast ({told})") from error
    return arrays, batches, sizes


@dataclass(frozen=True)
class Kernel:
    """A function of single items, called on batches.

    ``core(*inputs, *outputs, status)`` gets array views of one item (a scalar input by value; a scalar output, and the
    status, as arrays of one entry). It writes every output, and ``status[0]``: 0, or k to refuse the item for
    ``refusals[k - 1]``, a pair (argument, reason). The status may be left alone where there are no refusals.
    ``sizes`` holds the values that n and d may take; any other name is a number of things.
    """

    core: Callable[..., None]
    inputs: Mapping[str, Shape]
    outputs: tuple[Shape, ...]
    refusals: tuple[tuple[str, str], ...] = ()
    sizes: tuple[int, ...] = ()

    @cached_property
    def gufunc(self) -> Callable[..., Any]:
        """The NumPy generalised ufunc, compiled now or read from numba's disk cache."""
        shapes = (*self.inputs.values(), *self.outputs)
        signature = ",".join(_symbol(shape) for shape in shapes) + "->()"
        # A scalar input comes by value, a scalar output as an array of one entry.
        views = [numba.float64[(slice(None),) * max(len(shape), 1)] for shape in shapes]
        types = [numba.float64 if shape == () else view for shape, view in zip(shapes, views, strict=True)]
        types = [*types[: len(self.inputs)], *views[len(self.inputs) :], numba.uint8[:]]
        written = tuple(range(len(self.inputs), len(shapes)))
        vectorise = partial(numba.guvectorize, [numba.void(*types)], signature, writable_args=written)
        # With the name that the module was imported by, which what is kept on disk imports again.
        self.core.__qualname__ = f"{self.core.__module__}.{self.core.__name__}_{SOURCES}".replace(".", "_")
        with _one_process_at_a_time(self.core.__qualname__):
            try:
                return vectorise(cache=True)(self.core)  # type: ignore[no-any-return]
            except RuntimeError:
                # Numba finds no folder where it may keep a cache, neither beside the source nor the user's own.
                return vectorise()(self.core)  # type: ignore[no-any-return]

    def __call__(self, *arguments: ArrayLike) -> tuple[Array, ...]:
        """The outputs for a batch; InputError for a wrong shape, dtype, a number not finite, or a refused item."""
        arrays, batches, sizes = checked(self.inputs, arguments, self.sizes)
        batch = np.broadcast_shapes(*batches)
        outputs = tuple(np.empty(batch + tuple(int(resolve(spec, sizes)) for spec in shape)) for shape in self.outputs)
        status = np.zeros(batch, dtype=np.uint8)
        # Overflow to infinity and underflow to zero are the rounded values of maps such as exp, not mistakes to tell.
        with np.errstate(all="ignore"):
            self.gufunc(*arrays, *outputs, out=status)
        if status.any():
            self._refuse(status, dict(zip(self.inputs, batches, strict=True)))
        return outputs

    def _refuse(self, status: NDArray[np.uint8], batches: Mapping[str, tuple[int, ...]]) -> None:
        index = _first_false(status == 0)
        name, reason = self.refusals[int(status[index]) - 1]
        # The index is told in the argument's own batch, which may be narrower than the broadcast one.
        own = batches[name]
        tail = index[len(index) - len(own) :]
        raise InputError(name, reason, tuple(i if size > 1 else 0 for i, size in zip(tail, own, strict=True)))


def kernel(
    inputs: Mapping[str, Shape],
    outputs: tuple[Shape, ...],
    refusals: tuple[tuple[str, str], ...] = (),
    sizes: tuple[int, ...] = (),
) -> Callable[[Callable[..., None]], Kernel]:
    """A decorator that makes a `Kernel` of its core function."""
    return lambda core: Kernel(core, inputs, outputs, refusals, sizes)
