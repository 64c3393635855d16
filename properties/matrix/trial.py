"""The trial of a morph by the laws: one row of the matrix."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from mpmath import MPContext

from affinecert.case import to_hex
from affinecert.catalogue import find
from affinecert.certificate import MorphLawRecord
from affinecert.errors import InputError
from affinecert.map import Array
from affinecert.properties.matrix.algebra import Mask, determinant
from affinecert.properties.matrix.bank import Bank, bank
from affinecert.properties.matrix.domains import DOMAINS, NO_HALF_TURN, SHIFT, Domain
from affinecert.properties.matrix.laws import EXISTS, STEADINESS, MorphLaw
from affinecert.properties.matrix.morphs import Morph
from affinecert.properties.matrix.motion import Ask, Motion, exactly, reference, subject
from affinecert.properties.matrix.standard import unsteadiness
from affinecert.shrink import simpler

Pair = tuple[Array, Array]

HOLDS, FAILS = 1e-9, 1e-6
"""A residual up to the one is rounding, one from the other on a law broken; what lies between is unclear."""

ENOUGH = 4
"""Pairs of a domain that are needed to say that a law holds there."""

CANDIDATES = 8
"""Pairs, the simplest three and some of the others, on which the reference is asked to confirm that a law fails."""

ENDLESS = 1e100
"""A residual beyond it is told as infinite: something vanishes that rounding is measured against."""

PRECISION = 200
"""Bits of the reference: a residual that is rounding is far below `HOLDS` then, and one that is not stays."""

ROUNDS = 12
"""Times that a counterexample is replaced by a simpler one."""


@dataclass(frozen=True)
class _Field:
    """The pairs of one dimension, those of them that a morph takes and gives anything for, and its motion there."""

    bank: Bank
    taken: Mask
    given: Mask
    motion: Motion

    def residuals(self, law: MorphLaw) -> Array:
        """The residual for each pair of the bank; not a number where the law says nothing of it."""
        tried = self.taken if law is EXISTS else self.given
        result = np.full(len(tried), np.nan)
        if law is EXISTS:
            result[tried] = np.where(self.given[tried], 0.0, 1.0)
        else:
            result[tried] = _residual(law, self.motion)
        spoken_of = law.premise(self.bank.start, self.bank.end)
        return np.where(spoken_of & (law.astride | ~self.bank.astride), result, np.nan)


def _residual(law: MorphLaw, motion: Motion) -> Array:
    """The residuals of a motion in float64; not a number where there is no pose, or one without an inverse."""
    with np.errstate(all="ignore"):
        residual = np.asarray(law.residual(motion), dtype=np.float64)
    return np.where(residual > ENDLESS, np.inf, residual)


def _field(morph: Morph, ask: Ask, size: int) -> _Field:
    pairs = bank(size)
    taken = pairs.within[morph.domain.name]
    given = taken.copy()
    given[taken] = ~np.isnan(ask(pairs.start[taken], pairs.end[taken], 0.5)).any(axis=(-2, -1))
    clear = pairs.within[NO_HALF_TURN.name][given]
    beside = Motion(ask, pairs.next_start[given], pairs.next_end[given], clear)
    return _Field(pairs, taken, given, Motion(ask, pairs.start[given], pairs.end[given], clear, beside))


def _context() -> Any:
    ctx = MPContext()
    ctx.prec = PRECISION
    return ctx


@dataclass(frozen=True)
class Trial:
    """A morph of a subject, to be tried by laws; what it gives is asked once for all of them."""

    morph: Morph
    ask: Ask
    fields: tuple[_Field, ...]
    context: Any = field(default_factory=_context)
    references: dict[bytes, Motion] = field(default_factory=dict)

    def __call__(self, law: MorphLaw) -> MorphLawRecord:
        """What becomes of a law."""
        residuals = np.concatenate([each.residuals(law) for each in self.fields])
        spoken_of = ~np.isnan(residuals)
        if not spoken_of.any():
            return self._record(law, "void", note="it takes no pair of poses that the law speaks of")
        note = "" if law is EXISTS or self._always_given else "where it exists"
        worst = float(residuals[spoken_of].max())
        examples = int(spoken_of.sum())
        if worst <= HOLDS:
            confirmed = self._kept(law, self._witnesses(residuals, spoken_of))
            return self._record(law, "holds", residual=worst, examples=examples, confirmed=confirmed, note=note)
        if worst < FAILS:
            return self._record(law, "unclear", residual=worst, examples=examples, note=note)
        domains = self._kept_on(residuals)
        witnesses = (number for domain in domains for number in self._witnesses(residuals, self._within(domain)))
        pairs, residual, broken = self._counterexample(law, residuals)
        return self._record(
            law,
            "fails" if all(domain.trivial for domain in domains) else "partly",
            holds_on=tuple(domain.words for domain in domains),
            residual=residual,
            examples=examples,
            inputs=tuple(to_hex(array) for array in pairs),
            confirmed=broken and self._kept(law, witnesses),
            note=note,
        )

    def _record(self, law: MorphLaw, verdict: str, **known: Any) -> MorphLawRecord:
        value = unsteadiness(self.ask, self.morph.domain) if law is STEADINESS else None
        return MorphLawRecord(self.morph.name, law.name, verdict, self.morph.takes, value=value, **known)

    @cached_property
    def _always_given(self) -> bool:
        return all((each.given == each.taken).all() for each in self.fields)

    def _within(self, domain: Domain) -> Mask:
        """Which of all pairs belong to a domain."""
        return np.concatenate([each.bank.within[domain.name] for each in self.fields])

    def _kept_on(self, residuals: Array) -> list[Domain]:
        """The widest domains on which a law holds that does not hold everywhere; those of most pairs come first."""
        found: list[tuple[Mask, Domain]] = []
        for domain in DOMAINS:
            those = self._within(domain) & ~np.isnan(residuals)
            # Pairs that differ by a translation, which belong to most domains, say nothing of any other.
            telling = those & (domain.trivial | ~self._within(SHIFT))
            if telling.sum() < ENOUGH or residuals[those].max() > HOLDS:
                continue
            if not any((wider | ~those).all() for wider, _ in found):
                found.append((those, domain))
        ranked = [domain for _, domain in sorted(found, key=lambda each: -int(each[0].sum()))]
        return [domain for domain in ranked if not domain.trivial] or ranked

    def _pair(self, number: int) -> tuple[_Field, int]:
        """Where the pair of that number is."""
        for each in self.fields:
            if number < len(each.taken):
                return each, number
            number -= len(each.taken)
        raise IndexError(number)

    def _witnesses(self, residuals: Array, those: Mask) -> Iterator[int]:
        """A few pairs: the most complex one, which no coincidence helps, and the simplest with a turn by pi, if any."""
        tried = those & ~np.isnan(residuals)
        yield int(np.flatnonzero(tried)[-1])
        yield from map(int, np.flatnonzero(tried & ~self._within(NO_HALF_TURN))[:1])

    def _kept(self, law: MorphLaw, numbers: Iterable[int]) -> bool:
        """Whether the reference confirms that a law holds on pairs."""
        return all(self._confirmed(law, *self._arrays(law, number)) <= HOLDS for number in numbers)

    def _arrays(self, law: MorphLaw, number: int) -> tuple[Array, ...]:
        """The poses of a pair, with its neighbours if the law is about them."""
        where, place = self._pair(number)
        known = where.bank
        beside = (known.next_start[place], known.next_end[place]) if law.astride else ()
        return known.start[place], known.end[place], *beside

    def _counterexample(self, law: MorphLaw, residuals: Array) -> tuple[tuple[Array, ...], float, bool]:
        """The simplest pair found on which a law fails, its residual, and whether the reference confirms that."""
        order = np.flatnonzero(np.nan_to_num(residuals) >= FAILS)
        chosen = [*order[:3], *order[3 :: max(1, len(order) // (CANDIDATES - 3))]]
        for number in map(int, chosen):
            pairs = self._arrays(law, number)
            if self._confirmed(law, *pairs) >= FAILS:
                break
        else:
            number = int(order[0])
            return self._arrays(law, number), float(residuals[number]), False
        found, residual = pairs, float(residuals[number])
        if not law.astride:
            shrunk, smaller = self._shrunk(law, (pairs[0], pairs[1]), residual)
            if self._confirmed(law, *shrunk) >= FAILS:
                found, residual = shrunk, smaller
        return found, residual, True

    def _shrunk(self, law: MorphLaw, pair: Pair, residual: float) -> tuple[Pair, float]:
        """A simpler pair on which the law fails as clearly."""
        clear = min(1e-3, residual)
        for _ in range(ROUNDS):
            start, end = (np.array(poses) for poses in zip(pair, *simpler(pair), strict=True))
            for possible in (_is_pose, self.morph.domain.holds, law.premise):
                good = possible(start, end)
                start, end = start[good], end[good]
            values = _residual(law, Motion(self.ask, start, end, NO_HALF_TURN.holds(start, end)))
            worse = np.flatnonzero(np.nan_to_num(values) >= clear)
            worse = worse[worse > 0]
            if not len(worse):
                break
            pair, residual = (start[worse[0]], end[worse[0]]), float(values[worse[0]])
        return pair, residual

    def _confirmed(self, law: MorphLaw, *pairs: Array) -> float:
        """The residual of the reference; not a number where it refuses, but for the law of existence."""
        key = b"".join(array.tobytes() for array in pairs)
        if key not in self.references:
            exact = [exactly(self.context, array[None]) for array in pairs]
            clear = NO_HALF_TURN.holds(pairs[0][None], pairs[1][None])
            ask = reference(find(self.morph.map), self.context)
            beside = Motion(ask, exact[2], exact[3], clear) if exact[2:] else None
            self.references[key] = Motion(ask, exact[0], exact[1], clear, beside)
        try:
            return float(_residual(law, self.references[key])[0])
        except InputError:
            return 1.0 if law is EXISTS else np.nan


def _is_pose(start: Array, end: Array) -> Mask:
    """Which pairs are of affine poses."""
    last = np.eye(start.shape[-1])[-1]
    good = (start[:, -1] == last).all(axis=-1) & (end[:, -1] == last).all(axis=-1)
    return np.asarray(good & (determinant(start) > 0) & (determinant(end) > 0))


def trial(function: Callable[..., Any], morph: Morph) -> Trial:
    """The trial of a subject's function, which takes batches."""
    ask = subject(function)
    return Trial(morph, ask, tuple(_field(morph, ask, size) for size in morph.dimensions))
