"""The hunt: for each map of a subject the input with the worst scaled error, shrunk and stored.

Every map is climbed from its regimes and from the corpus (`climb`), each input is judged (`trial`), and of each regime
with a finding the worst input is simplified (`shrink`). The climb is kept in a file every few seconds: a hunt that was
stopped goes on where it was, and the budget counts from its beginning.
"""

from __future__ import annotations

import hashlib
import math
import re
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from random import Random

from affinecert import catalogue, corpus
from affinecert.campaign import run_name
from affinecert.case import Case
from affinecert.climb import LARGEST, Arm, Candidate, Climber, Ground, build, choose, learn, propose
from affinecert.errors import SubjectError
from affinecert.judging import resolve
from affinecert.map import Map
from affinecert.scoring import Score
from affinecert.shrink import descend, shrink, total
from affinecert.store import Store, reference_version
from affinecert.subject import Subject
from affinecert.trail import Trail, load_trails, save_trails
from affinecert.trial import Trial, error, height

Progress = Callable[[int, float, str], None]
"""Told after each evaluation: how many there were, the worst scaled error so far, and the map and regime."""

CLIMBING = 0.8
"""The part of a budget that is spent on climbing; the rest is for shrinking, at a quarter of the evaluations."""

SAVING = 3.0
"""Seconds between two writes of the trail."""

SACRIFICE = math.log2(10)
"""What shrinking may give up of a catch: one decimal digit of the error."""

COORDINATE_VALUES = (0.0, 0.5, 0.25, 0.75)
"""Simple coordinates: the ends and the middle of a range, quarter turns of a direction's angles."""


@dataclass(frozen=True)
class Catch:
    """A bad input: the case as shrunk, its worst scaled and forward error over the blocks, in u, and its verdict.

    ``evaluations`` is the number of inputs tried on that map.
    """

    case: Case
    scaled: float
    forward: float
    verdict: str
    evaluations: int


def _silent(evaluations: int, worst: float, doing: str) -> None:
    """No progress is shown unless somebody asks for it."""


def hunt(
    subject: str | Subject = "fast",
    maps: str = "*",
    *,
    budget: float = 60.0,
    evaluations: int | None = None,
    seed: int = 0,
    out: Path | None = None,
    progress: Progress = _silent,
    store: Path | None = None,
) -> tuple[Catch, ...]:
    """The worst inputs of a subject: of each map it offers, in each regime with a finding, worst first within a map.

    A map without a finding gives its one worst input. Only inputs inside a map's domain count. ``budget`` is in
    seconds, for all maps together; ``evaluations``, of each map, takes its place, and then the same call has the same
    result. Both count from the beginning of the hunt with that seed, whose trail ``out`` keeps (``SUBJECT.hunt.json``)
    beside the catches (``SUBJECT.jsonl``, a corpus file). All is done in this process, where nothing can stop a subject
    that hangs. Raises UnknownNameError, SubjectError or StoredFileError.
    """
    loaded = resolve(subject)
    entries = [entry for entry in catalogue.matching(maps) if entry.name in loaded.maps]
    if not entries:
        raise SubjectError(
            f"{loaded.name} offers no map that matches {maps!r}; it has {', '.join(sorted(loaded.maps))}"
        )
    seconds = math.inf if evaluations is not None else CLIMBING * budget / len(entries)
    most = math.inf if evaluations is None else evaluations
    file = Path(out) / re.sub(r"[^\w.-]+", "-", loaded.name) if out is not None else None
    catches: list[Catch] = []
    done, worst = 0, 0.0

    def highest(trail: Trail) -> float:
        return max([worst, *(error(arm.worst.height) for arm in trail.arms if arm.worst is not None)])

    def told(trail: Trail, doing: str) -> None:
        progress(done + trail.evaluations, highest(trail), doing)

    with Store(store) as truths:
        for entry in entries:
            hunter = _Hunter(Trial(loaded, entry, truths), seed, file)
            trail = hunter.climb(seconds, most, told)
            catches += hunter.catches(trail)
            done += trail.evaluations
            worst = highest(trail)
    return tuple(catches)


def grounds(entry: Map) -> tuple[Ground, ...]:
    """The regimes of a map, and those that only its corpus knows, each with its stored cases."""
    regimes = {regime.name: regime for regime in entry.regimes}
    stored = [case for case in corpus.shipped() if case.map == entry.name]
    names = dict.fromkeys([*regimes, *(case.regime for case in stored)])
    return tuple(
        Ground(entry.name, name, regimes.get(name), tuple(case for case in stored if case.regime == name))
        for name in names
    )


class _Hunter:
    """The hunt on one map."""

    def __init__(self, trial: Trial, seed: int, file: Path | None) -> None:
        self.trial = trial
        self.seed = seed
        self.file = file
        self.name = f"{trial.entry.name}, seed {seed}"
        self.grounds = grounds(trial.entry)

    def climb(self, seconds: float, most: float, told: Callable[[Trail, str], None]) -> Trail:
        """Tries inputs until so many seconds or evaluations are spent, from where the kept trail ends."""
        trails = load_trails(self._trails) if self.file else {}
        run = self._run()
        trail = trails.get(self.name)
        if trail is None or trail.run != run:
            trail = Trail(run, 0, 0.0, tuple(Arm(ground.name) for ground in self.grounds))
        self.trial.warm_up()
        before, started = trail.seconds, time.monotonic()
        saved = started
        try:
            while trail.seconds < seconds and trail.evaluations < most:
                index = choose(trail.arms)
                if index is None:
                    break
                arms = (*trail.arms[:index], self._pull(trail, index), *trail.arms[index + 1 :])
                now = time.monotonic()
                trail = Trail(run, trail.evaluations + 1, before + now - started, arms)
                told(trail, f"{self.trial.entry.name} {arms[index].regime}")
                if self.file and now - saved > SAVING:
                    save_trails(self._trails, {**trails, self.name: trail})
                    saved = now
        finally:
            if self.file:
                save_trails(self._trails, {**trails, self.name: trail})
        return trail

    def _run(self) -> str:
        """A digest of what a climb depends on: if that has changed, there is no going on."""
        given = [(ground.name, [case.key for case in ground.stored]) for ground in self.grounds]
        parts = (run_name(self.trial.subject), reference_version(self.trial.entry), given)
        return hashlib.sha256(repr(parts).encode()).hexdigest()[:16]

    @property
    def _trails(self) -> Path:
        assert self.file is not None
        return self.file.with_name(self.file.name + ".hunt.json")

    def _pull(self, trail: Trail, index: int) -> Arm:
        """The arm after one more evaluation."""
        arm = trail.arms[index]
        candidate = propose(self.grounds[index], arm, Random(f"{self.name}, evaluation {trail.evaluations}"))
        floor = arm.incumbent.height if arm.incumbent is not None else -math.inf
        judged = self.trial(candidate.case, floor)
        return learn(arm, candidate, None if judged is None else height(judged), trail.evaluations)

    def catches(self, trail: Trail) -> list[Catch]:
        """The worst of each arm with a finding, or of all arms, shrunk and stored."""
        found: list[tuple[Climber, Ground, Score]] = []
        for arm, ground in zip(trail.arms, self.grounds, strict=True):
            if arm.worst is not None and (judged := self.trial(arm.worst.candidate.case)) is not None:
                found.append((arm.worst, ground, judged))
        found.sort(key=lambda item: -item[0].height)
        chosen = [item for item in found if item[2].verdict.is_finding] or found[:1]
        limit = round(trail.evaluations * (1 - CLIMBING) / CLIMBING) // max(len(chosen), 1)
        catches = [self._catch(*item, limit, trail.evaluations) for item in chosen]
        if self.file:
            for catch in catches:
                self.trial.keep(catch.case)
            corpus.append(self.file.with_name(self.file.name + ".jsonl"), [catch.case for catch in catches])
        return catches

    def _catch(self, climber: Climber, ground: Ground, judged: Score, limit: int, evaluations: int) -> Catch:
        """The catch of a climber: simplified in its regime's coordinates, then entry by entry."""
        floor = height(judged) - SACRIFICE

        def as_bad(case: Case) -> bool:
            again = self.trial(case, floor)
            return again is not None and again.verdict is judged.verdict and height(again) >= floor

        candidate = climber.candidate
        if judged.verdict.is_finding:
            if candidate.coordinates is not None:
                moves = [partial(_simpler_coordinate, ground, place) for place in range(candidate.used)]
                candidate, asked = descend(
                    candidate, moves, lambda one: total(one.case.inputs), lambda one: as_bad(one.case), limit // 2
                )
                limit -= asked
            case = candidate.case
            inputs = shrink(case.inputs, lambda inputs: as_bad(replace(case, inputs=inputs)), limit)
            candidate = replace(candidate, case=replace(case, inputs=inputs))
        provenance = f"hunt, {self.trial.subject.name}, seed {self.seed}, evaluation {climber.evaluation}"
        case = replace(candidate.case, provenance=provenance)
        final = self.trial(case) or judged
        return Catch(case, final.scaled, final.forward, str(final.verdict), evaluations)


def _simpler_coordinate(ground: Ground, place: int, candidate: Candidate) -> Iterator[Candidate]:
    """The candidate built anew with one coordinate made simple."""
    coordinates = candidate.coordinates or ()
    for value in (*COORDINATE_VALUES, *(round(coordinates[place], digits) for digits in (1, 2, 3))):
        yield build(ground, (*coordinates[:place], min(value, LARGEST), *coordinates[place + 1 :]))
