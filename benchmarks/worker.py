"""A process that times one build of the project: it answers one JSON request a line until its input ends.

It runs as a script, so that the code under test may be any revision: of that it needs no more than
`affinecert.subject.load("fast")`. It first tells where that was imported from. A request names a map and a file of
inputs; with a file for the outputs it has them written there, with a number of calls it has these timed. Or it asks for
that many calls of a yardstick.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np


def load_inputs(path: str) -> list[Any]:
    """The arrays of a file, in their order."""
    with np.load(path) as file:
        return [file[name] for name in file.files]


def answer(maps: Any, request: dict[str, Any]) -> dict[str, Any]:
    """The answer to one request."""
    if "yardstick" in request:
        return {"seconds": timed(yardstick, [], request["yardstick"])}
    function: Callable[..., Any] | None = maps.get(request["map"])
    if function is None:
        return {"absent": f"no map {request['map']}"}
    inputs = load_inputs(request["inputs"])
    if "calls" in request:
        return {"seconds": timed(function, inputs, request["calls"])}
    try:
        result = function(*inputs)
    except Exception as error:
        return {"absent": f"{type(error).__name__}: {error}"}
    np.savez(request["outputs"], *(result if isinstance(result, tuple) else (result,)))
    return {}


def yardstick() -> Any:
    """A computation that no change of the project touches, of about a tenth of a millisecond."""
    return np.sin(np.linspace(0.0, 1.0, 10_000)).sum()


def timed(function: Callable[..., Any], inputs: Sequence[Any], calls: int) -> float:
    """The seconds of that many calls, after one that warms the caches up."""
    function(*inputs)
    started = time.perf_counter()
    for _ in range(calls):
        function(*inputs)
    return time.perf_counter() - started


def main() -> None:
    """Serves requests."""
    import affinecert  # noqa: PLC0415 -- the build under test
    from affinecert.subject import load  # noqa: PLC0415

    maps = load("fast").maps
    print(json.dumps({"package": affinecert.__file__}), flush=True)
    for line in sys.stdin:
        print(json.dumps(answer(maps, json.loads(line))), flush=True)


if __name__ == "__main__":
    main()
