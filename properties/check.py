"""Trying a law on a subject's maps, for the certificate and for the test modules alike."""

from __future__ import annotations

import math
from collections.abc import Collection
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np
from hypothesis import HealthCheck, Phase, Verbosity, given, reject, seed, settings
from hypothesis.database import InMemoryExampleDatabase

from affinecert.case import to_hex
from affinecert.map import Array
from affinecert.properties.answers import Maps
from affinecert.properties.law import BadAnswer, Law, OutOfDomain

SHRINKS = 2
"""Inputs tried for each example, for being simpler than one that fails: a broken law costs thrice a kept one."""

BUFFER = 2**12
"""Random bytes that an example is drawn from: inputs of any map take a few hundred; too few would only reject it."""

ATTEMPTS = 10
"""Draws for each example; rejected ones lie outside of the law's domain."""

SETTINGS = settings(
    derandomize=False,  # for the seed to hold, and the database, in CI too
    deadline=None,  # the precision of a truth, and so its time, grows near singularities
    phases=(Phase.reuse, Phase.shrink),
    print_blob=False,
    report_multiple_bugs=False,
    suppress_health_check=list(HealthCheck),  # truths are slow, and domains are met by rejecting: both are known
    verbosity=Verbosity.quiet,
)


@dataclass(frozen=True)
class LawResult:
    """What became of one law: ``verdict`` is passed, failed or absent.

    ``worst`` is the greatest residual met. ``inputs``, as hexadecimal floats, are the shrunk counterexample where the
    law failed, else those with the worst residual. ``note`` tells what is wrong, ``examples`` how many were measured.
    """

    law: str
    verdict: str
    worst: float
    inputs: tuple[Any, ...]
    note: str
    examples: int

    @property
    def passed(self) -> bool:
        """Whether nothing speaks against the subject; a law whose maps are absent does not."""
        return self.verdict != "failed"


@dataclass(frozen=True)
class _Finding:
    residual: float
    inputs: tuple[Array, ...]
    note: str


class _Broken(Exception):
    """Tells Hypothesis that an input breaks the law."""


class _Spent(BaseException):
    """Stops Hypothesis, which catches exceptions and goes on shrinking, when no more inputs are to be tried."""


class _Trial:
    """One run of Hypothesis: it measures inputs, and remembers the worst of them and the last that broke the law."""

    def __init__(self, law: Law, maps: Maps, shrinks: int) -> None:
        self.law, self.maps, self.shrinks = law, maps, shrinks
        self.examples = 0
        self.worst = _Finding(-1.0, (), "")
        self.broken: dict[bytes, _Finding] = {}
        self.last: _Finding | None = None

    def __call__(self, inputs: tuple[Array, ...]) -> None:
        key = b"".join(repr(array.shape).encode() + array.tobytes() for array in inputs)
        if key not in self.broken:
            if self.broken:
                if not self.shrinks:
                    raise _Spent
                self.shrinks -= 1
            finding = measure(self.law, self.maps, inputs)
            self.examples += 1
            self.worst = max(self.worst, finding, key=lambda each: each.residual)
            if finding.residual <= self.law.bound:
                return
            self.broken[key] = finding
        self.last = self.broken[key]
        raise _Broken


def measure(law: Law, maps: Maps, inputs: tuple[Array, ...]) -> _Finding:
    """The residual of a law at an input; infinite, with a note, where the subject raises or its answer is none."""
    try:
        residual = float(law.residual(maps, *inputs))
    except OutOfDomain:
        reject()
    except BadAnswer as answer:
        return _Finding(math.inf, inputs, str(answer))
    if residual > law.bound:
        return _Finding(residual, inputs, f"a residual of {residual:.3g}")
    return _Finding(residual, inputs, "")


def check(law: Law, maps: Maps, examples: int = 50) -> LawResult:
    """Tries a law on so many examples, the same ones on every machine; a counterexample is shrunk.

    An exception inside the law's domain breaks it. If one of the maps that it needs is missing, or the subject refuses
    every example, as documented, the verdict is absent.
    """
    missing = [name for name in law.needs if name not in maps]
    if missing:
        return LawResult(law.name, "absent", 0.0, (), f"without {', '.join(missing)}", 0)
    trial = _Trial(law, maps, SHRINKS * examples)
    verdict = "failed" if _refuted(law, trial, examples) else "passed" if trial.examples else "absent"
    shown = trial.last or trial.worst
    return LawResult(
        law=law.name,
        verdict=verdict,
        worst=max(trial.worst.residual, 0.0),
        inputs=tuple(to_hex(array) for array in shown.inputs),
        note=shown.note if trial.examples else "the subject refuses every example, as documented",
        examples=trial.examples,
    )


def _refuted(law: Law, trial: _Trial, examples: int) -> bool:
    """Whether an example breaks the law; the trial then remembers the shrunk one last.

    Examples are drawn from seeded bytes, for Hypothesis' own generation draws on the constants of whatever modules are
    loaded; what fails is handed over by a database, and shrunk.
    """
    database = InMemoryExampleDatabase()
    probe = _probe(law, trial, database, SETTINGS.phases)
    generator = np.random.default_rng(list(law.name.encode()))
    try:
        for _ in range(ATTEMPTS * examples):
            probe.hypothesis.fuzz_one_input(generator.bytes(BUFFER))
            if trial.examples == examples:
                return False
    except _Broken:
        with suppress(Exception):  # whatever shrinking runs into, an unsteady subject say, the law is broken
            try:
                probe()
            except _Spent:  # the database holds the simplest input met
                with suppress(_Spent):
                    _probe(law, trial, database, (Phase.reuse,))()
        return True
    return False


def _probe(law: Law, trial: _Trial, database: InMemoryExampleDatabase, phases: Collection[Phase]) -> Any:
    """The trial as a test of Hypothesis, which knows it by its source in a database."""

    @settings(SETTINGS, database=database, phases=phases)  # above the seed, which takes a database away
    @seed(0)
    @given(law.inputs)
    def probe(inputs: tuple[Array, ...]) -> None:
        trial(inputs)

    return probe
