"""The hunt's climber: which input to try next, given how bad those before were.

Each regime of a map is an arm of a bandit. An arm holds an incumbent, mutates it, and keeps the mutant if that is no
better behaved (an evolution strategy of one parent and one child, with restarts). Mutations move in the coordinates
that matter: the uniform numbers from which the regime builds its input, so that one of them is the exponent of the
distance to the singular set, others direction and size; and the last places of the input's entries. Every choice comes
from a generator seeded by the number of the evaluation, so that a hunt can stop anywhere and go on.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from random import Random

import numpy as np

from affinecert.case import Case
from affinecert.draw import UniformDraw
from affinecert.map import Regime

COORDINATES = 64
"""Uniform numbers in a coordinate vector: more than any regime draws. A longer draw is filled up pseudorandomly."""

PATIENCE = 40
"""Evaluations without a worse input after which an arm restarts elsewhere."""

HOPELESS = 8
"""Evaluations, all of them outside the map's domain, after which an arm is given up."""

MEMORY = 0.1
"""The weight of the last evaluation in an arm's rate of success: it remembers about 1 / MEMORY of them."""

CURIOSITY = 0.5
"""The weight of the bandit's term for arms that were seldom tried; with 0 an unlucky arm would never be tried again."""

LARGEST = 1 - 2.0**-53
"""The largest float64 below 1."""


@dataclass(frozen=True)
class Candidate:
    """An input to try: the case, and the coordinates it was built from, if it was; ``used`` of them were drawn."""

    case: Case
    coordinates: tuple[float, ...] | None = None
    used: int = 0


@dataclass(frozen=True)
class Climber:
    """A candidate and its height, log2 of the scaled error; ``evaluation`` is the number of the one that found it."""

    candidate: Candidate
    height: float
    evaluation: int


@dataclass(frozen=True)
class Arm:
    """What is known of one regime: the input being improved, the worst one, and how the evaluations fared."""

    regime: str
    incumbent: Climber | None = None
    worst: Climber | None = None
    pulls: int = 0
    stalled: int = 0
    rate: float = 1.0

    @property
    def is_over(self) -> bool:
        """Whether nothing worse can be found here: the error is infinite, or the regime lies outside the domain."""
        if self.worst is None:
            return self.pulls >= HOPELESS
        return self.worst.height == math.inf


@dataclass(frozen=True)
class Ground:
    """Where an arm hunts: the regime's builder, None for a regime of the corpus only, and the stored cases."""

    map: str
    name: str
    regime: Regime | None
    stored: tuple[Case, ...] = ()


def build(ground: Ground, coordinates: Sequence[float]) -> Candidate:
    """The candidate that the ground's regime makes of those coordinates."""
    assert ground.regime is not None
    used = 0

    def uniforms() -> Iterator[float]:
        nonlocal used
        for used, coordinate in enumerate(coordinates, start=1):  # noqa: B007 -- read outside
            yield coordinate
        yield from iter(Random(repr(coordinates)).random, None)

    point = ground.regime.build(UniformDraw(uniforms()))
    case = Case(ground.map, ground.name, point.inputs, point.distance, "")
    return Candidate(case, tuple(coordinates), used)


def choose(arms: Sequence[Arm]) -> int | None:
    """The arm to pull: one that has been improving, stands high, or was seldom tried; None if all are over."""
    open_arms = [index for index, arm in enumerate(arms) if not arm.is_over]
    if not open_arms:
        return None
    total = sum(arm.pulls for arm in arms)
    finite = [arm.worst.height for arm in arms if arm.worst is not None and math.isfinite(arm.worst.height)]
    highest = max(finite, default=0.0)

    def promise(index: int) -> float:
        arm = arms[index]
        if arm.pulls == 0:
            return math.inf
        standing = 2 ** (arm.worst.height - highest) if arm.worst is not None else 0.0
        return arm.rate + standing / 2 + CURIOSITY * math.sqrt(math.log(total) / arm.pulls)

    return max(open_arms, key=promise)


def propose(ground: Ground, arm: Arm, random: Random) -> Candidate:
    """The next candidate of an arm: first the stored cases, then a fresh one or a mutant of the incumbent."""
    if arm.pulls < len(ground.stored):
        return Candidate(ground.stored[arm.pulls])
    parent = arm.incumbent.candidate if arm.incumbent is not None else None
    if parent is None or random.random() < 0.1:
        if ground.regime is None:
            return shift(Candidate(random.choice(ground.stored)), random)
        return build(ground, [random.random() for _ in range(COORDINATES)])
    if parent.coordinates is None or random.random() < 0.4:
        return shift(parent, random)
    return build(ground, mutate(parent.coordinates, parent.used, random))


def mutate(coordinates: Sequence[float], used: int, random: Random) -> list[float]:
    """The coordinates with one or a few of those in use moved: by a step of any size, anywhere, or to an end."""
    mutant = list(coordinates)
    for _ in range(_few(random)):
        place = random.randrange(max(used, 1))
        kind = random.random()
        if kind < 0.7:
            moved = mutant[place] + random.gauss(0.0, 10.0 ** random.uniform(-4.0, -0.5))
            mutant[place] = min(max(moved, 0.0), LARGEST)
        elif kind < 0.9:
            mutant[place] = random.random()
        else:
            mutant[place] = random.choice((0.0, 0.5, LARGEST))
    return mutant


def shift(parent: Candidate, random: Random) -> Candidate:
    """The candidate with one or a few entries moved by some of their last places; zeros stay."""
    inputs = [array.copy() for array in parent.case.inputs]
    entries = [(array, place) for array in inputs for place in range(array.size) if array.flat[place] != 0]
    for array, place in random.sample(entries, min(_few(random), len(entries))):
        steps = random.choice((-1, 1)) * random.choice((1, 1, 1, 2, 4))
        array.flat[place] = _stepped(float(array.flat[place]), steps)
    return replace(parent, case=replace(parent.case, inputs=tuple(inputs), provenance=""))


def _few(random: Random) -> int:
    """One, or with falling probability more."""
    count = 1
    while random.random() < 0.4:
        count += 1
    return count


def _stepped(number: float, steps: int) -> float:
    """The float64 that many places further from zero (nearer, for negative steps)."""
    moved = float((np.float64(abs(number)).view(np.int64) + steps).view(np.float64))
    return math.copysign(moved, number) if 0 <= moved < math.inf else number


def learn(arm: Arm, candidate: Candidate, height: float | None, evaluation: int) -> Arm:
    """The arm after an evaluation; ``height`` is None for an input outside the domain or surely below the incumbent."""
    found = Climber(candidate, height, evaluation) if height is not None else None
    held = arm.incumbent
    better = found is not None and (held is None or found.height >= held.height)
    rises = found is not None and (held is None or found.height > held.height)
    record = found is not None and (arm.worst is None or found.height > arm.worst.height)
    stalled = 0 if rises else arm.stalled + 1
    return Arm(
        regime=arm.regime,
        incumbent=None if stalled >= PATIENCE else found if better else held,
        worst=found if record else arm.worst,
        pulls=arm.pulls + 1,
        stalled=0 if stalled >= PATIENCE else stalled,
        rate=(1 - MEMORY) * arm.rate + MEMORY * record,
    )
