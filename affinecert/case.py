"""A case: one input, bits exact, with the regime it belongs to and where it comes from."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from affinecert.draw import UniformDraw
from affinecert.errors import StoredFileError
from affinecert.map import Array, Map, Regime


@dataclass(frozen=True)
class Case:
    """One input of one map. ``distance`` is to the regime's singular set; ``provenance`` says who made the case."""

    map: str
    regime: str
    inputs: tuple[Array, ...]
    distance: float
    provenance: str

    @cached_property
    def key(self) -> str:
        """A digest of the map's name and the bits of the inputs."""
        digest = hashlib.sha256(self.map.encode())
        for array in self.inputs:
            digest.update(repr(array.shape).encode())
            digest.update(np.ascontiguousarray(array, dtype="<f8").tobytes())
        return digest.hexdigest()


def rounded(case: Case, dtype: str) -> Case | None:
    """The case whose inputs are rounded to a dtype, None if one is beyond it; of float64 the case itself."""
    if dtype == "float64":
        return case
    with np.errstate(over="ignore"):
        inputs = tuple(array.astype(dtype).astype(np.float64) for array in case.inputs)
    return replace(case, inputs=inputs) if all(np.all(np.isfinite(array)) for array in inputs) else None


def generate(entry: Map, regime: Regime, count: int, seed: int = 0) -> Iterator[Case]:
    """The first ``count`` cases of a regime; the same ones on every machine and in every run with that seed."""
    for index in range(count):
        name = f"{entry.name}/{regime.name}/{seed}/{index}"
        words = np.frombuffer(hashlib.sha256(name.encode()).digest(), dtype="<u4")
        generator = np.random.Generator(np.random.PCG64([int(word) for word in words]))
        point = regime.build(UniformDraw(iter(generator.random, None)))
        yield Case(entry.name, regime.name, point.inputs, point.distance, f"regime, seed {seed}, number {index}")


def to_hex(array: Array) -> Any:
    """Nested lists of hexadecimal floats: exact, and readable in a diff."""
    if array.ndim == 0:
        return float(array).hex()
    return [to_hex(row) for row in array]


def from_hex(value: Any) -> Array:
    """The inverse of `to_hex`; numbers and decimal strings are taken too."""
    if isinstance(value, list):
        return np.array([from_hex(row) for row in value], dtype=np.float64)
    if isinstance(value, str):
        return np.array(float.fromhex(value) if "0x" in value.lower() else float(value), dtype=np.float64)
    return np.array(float(value), dtype=np.float64)


def to_record(case: Case) -> dict[str, Any]:
    """The case as plain JSON values."""
    return {
        "map": case.map,
        "regime": case.regime,
        "inputs": [to_hex(array) for array in case.inputs],
        "distance": case.distance.hex(),
        "provenance": case.provenance,
    }


def from_record(record: Any, where: str) -> Case:
    """The case of a JSON record; ``where`` names the file and line for the error."""
    try:
        return Case(
            map=str(record["map"]),
            regime=str(record["regime"]),
            inputs=tuple(from_hex(value) for value in record["inputs"]),
            distance=float.fromhex(record["distance"]),
            provenance=str(record["provenance"]),
        )
    except (KeyError, TypeError, ValueError, IndexError) as error:
        raise StoredFileError(f"{where}: not a case: {type(error).__name__}: {error}") from error


def dump_line(case: Case) -> str:
    """The case as one line of a corpus file."""
    return json.dumps(to_record(case), ensure_ascii=False)
