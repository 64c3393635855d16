"""Measuring builds of the project against each other: they take turns, so that what slows one slows all."""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from affinecert.benchmarks.builds import Build, BuildError, save_inputs
from affinecert.benchmarks.workload import Accuracy, accuracy, batch
from affinecert.catalogue import CATALOGUE
from affinecert.map import Array, Map
from affinecert.subject import Subject

TURNS = 10
"""Turns of base, head, head, base: 20 samples each, of which no rank test of 1 % is starved."""

SAMPLE = 5e-3
"""Seconds a sample lasts at least, a hundred times what a context switch takes."""

YARDSTICK_CALLS = 20
"""Calls of the yardstick in a turn: a few milliseconds, as long as a sample."""

Progress = Callable[[int, int, str], None]
"""Told after each map and size: so many of so many are done, and which was the last."""


@dataclass(frozen=True)
class Measured:
    """One build on one map and batch size: samples of the seconds per call, and its worst errors in u.

    ``yardstick`` is the median of the seconds that a fixed computation took in between.
    """

    map: str
    size: int
    seconds: tuple[float, ...]
    forward: float
    scaled: float
    yardstick: float

    @property
    def nanoseconds(self) -> float:
        """The median time per item."""
        return statistics.median(self.seconds) / self.size * 1e9


def measure(
    builds: Sequence[Build],
    entries: Sequence[Map],
    sizes: Sequence[int],
    turns: int,
    *,
    scratch: Path,
    progress: Progress,
) -> Iterator[tuple[Measured | None, ...]]:
    """For each map and size what each build takes; the builds take turns, forth and back."""
    total = len(entries) * len(sizes)
    for number, entry in enumerate(entries):
        exact: dict[Build, Accuracy | None] = {}
        for place, size in enumerate(sizes):
            inputs = save_inputs(scratch / "inputs.npz", batch(entry, size))
            present = [
                build for build, outputs in zip(builds, _ask(builds, entry.name, inputs), strict=True) if outputs
            ]
            if place == 0:
                exact = {build: accuracy(_as_subject(build, scratch), entry.name) for build in present}
            samples, yardstick = _take_turns(present, entry.name, inputs, turns)
            yield tuple(
                Measured(entry.name, size, tuple(samples[build]), worst.forward, worst.scaled, yardstick)
                if (worst := exact.get(build)) is not None
                else None
                for build in builds
            )
            progress(number * len(sizes) + place + 1, total, f"{entry.name}, {size} items")


def _ask(builds: Sequence[Build], name: str, inputs: Path) -> list[tuple[Array, ...] | None]:
    """The outputs of every build; all are asked before any is waited for, for the first call compiles."""
    for build in builds:
        build.start(name, inputs)
    return [build.finish() for build in builds]


def _take_turns(builds: Sequence[Build], name: str, inputs: Path, turns: int) -> tuple[dict[Build, list[float]], float]:
    """Samples of the seconds per call of each build, and the median of the yardstick between them."""
    samples: dict[Build, list[float]] = {build: [] for build in builds}
    if not builds:
        return samples, math.nan
    calls = max(1, math.ceil(SAMPLE / max(builds[0].seconds(name, inputs, 3) / 3, 1e-9)))
    yardstick = []
    for _ in range(turns):
        yardstick.append(builds[0].yardstick(YARDSTICK_CALLS) / YARDSTICK_CALLS)
        for build in (*builds, *reversed(builds)):
            samples[build].append(build.seconds(name, inputs, calls) / calls)
    return samples, statistics.median(yardstick)


def _as_subject(build: Build, scratch: Path) -> Subject:
    """The build as a subject, so that it is judged like any other: each call goes to its process."""

    def asked(name: str) -> Callable[..., tuple[Array, ...]]:
        def call(*inputs: Array) -> tuple[Array, ...]:
            build.start(name, save_inputs(scratch / "asked.npz", inputs))
            outputs = build.finish()
            if outputs is None:
                raise BuildError(f"{build.name} refused")
            return outputs

        return call

    return Subject(build.name, "", {name: asked(name) for name in CATALOGUE})
