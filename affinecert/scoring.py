"""Scoring: one answer held against truth, block by block."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType

import numpy as np

from affinecert.arithmetic import FLOAT64, Arithmetic
from affinecert.magnitude import length, quotient
from affinecert.map import Array, Map
from affinecert.truths import Truth


class Verdict(StrEnum):
    """What is said of one answer, from best to worst."""

    OK = "ok"
    OTHER_BRANCH = "other-branch"
    ABSENT = "absent"
    DEGRADED = "degraded"
    WRONG = "wrong"
    NON_FINITE = "non-finite"
    RAISED = "raised"

    @property
    def is_finding(self) -> bool:
        """Whether the verdict makes a run fail."""
        return self in FINDINGS


NOTHING: Mapping[str, str] = MappingProxyType({})
"""The policies or refusals of a subject that documents none."""

FINDINGS = frozenset({Verdict.DEGRADED, Verdict.WRONG, Verdict.NON_FINITE, Verdict.RAISED})


@dataclass(frozen=True)
class BlockScore:
    """The errors of one output block, in units of u."""

    block: str
    forward: float
    scaled: float
    condition: float


@dataclass(frozen=True)
class Answer:
    """What a subject gave for one case: its outputs, or why there are none; ``broken`` if that is no refusal either."""

    outputs: tuple[Array, ...] | None
    complaint: str | None = None
    broken: bool = False


@dataclass(frozen=True)
class Score:
    """The verdict of one case, with its errors; ``backward`` is None where the map has no inverse to measure it by."""

    verdict: Verdict
    blocks: tuple[BlockScore, ...]
    backward: float | None
    note: str

    @property
    def forward(self) -> float:
        """The worst forward error over the blocks, in u."""
        return max((block.forward for block in self.blocks), default=0.0)

    @property
    def scaled(self) -> float:
        """The worst scaled error over the blocks, in u."""
        return max((block.scaled for block in self.blocks), default=0.0)


def block_score(
    name: str, answer: Array, high: Array, low: Array, sensitivity: float, arithmetic: Arithmetic = FLOAT64
) -> BlockScore:
    """The errors of one block: |f - truth| over u |truth|, and over u (|truth| + sensitivity).

    The sensitivity is the absolute change that relative perturbations of the inputs make, that is condition times
    |truth|; in this form the scaled error |f - truth| / (u |truth| (1 + condition)) stands at truth 0 as well.
    """
    with np.errstate(over="ignore", invalid="ignore", under="ignore"):
        # Where the value is beyond the arithmetic, the same infinity is its rounding: equal, though inf - inf is NaN.
        rounded = np.where(np.abs(high) > arithmetic.largest, np.copysign(np.inf, high), high)
        error = length(np.where(answer == rounded, np.where(np.isinf(rounded), 0.0, -low), (answer - high) - low))
    size = max(length(high), arithmetic.smallest_normal)
    # Divided by u last: u times a size near the smallest normal number would underflow.
    return BlockScore(
        block=name,
        forward=quotient(error, size) / arithmetic.unit,
        scaled=quotient(error, size + sensitivity) / arithmetic.unit,
        condition=quotient(sensitivity, size),
    )


COMPLEX = "complex where a real value is due"


def announced(complaint: str, refusals: Mapping[str, str]) -> str | None:
    """What a subject's documentation says of a complaint by which it refuses an input; None if it says nothing."""
    return next((why for words, why in refusals.items() if words in complaint), None)


def _well_formed(outputs: Sequence[Array], truth: Truth) -> str | None:
    if len(outputs) != len(truth.high):
        return f"{len(outputs)} outputs where {len(truth.high)} are due"
    for number, (output, due) in enumerate(zip(outputs, truth.high, strict=True)):
        if output.shape != due.shape:
            return f"output {number} has shape {output.shape} where {due.shape} is due"
    return None


def _fixed(entry: Map, outputs: Sequence[Array], truth: Truth, arithmetic: Arithmetic) -> Iterator[BlockScore]:
    """The errors of entries that no block tells of, such as a last row of 0 0 0 1, where they are not as they are due.

    Against the size of these entries; where all are due to be 0, of the whole output.
    """
    for number, (output, due) in enumerate(zip(outputs, truth.high, strict=True)):
        rest = np.ones(due.shape, dtype=np.bool_)
        for block in entry.blocks:
            if block.output == number:
                rest[block.where] = False
        if np.any(output[rest] != due[rest]):
            size = max(length(due[rest]) or length(due), arithmetic.smallest_normal)
            error = quotient(length(output[rest] - due[rest]), size) / arithmetic.unit
            yield BlockScore("fixed entries", error, error, 0.0)


def _complex(outputs: Sequence[Array]) -> bool:
    return any(map(np.iscomplexobj, outputs))


def _undecided(entry: Map, truth: Truth, arithmetic: Arithmetic) -> bool:
    """Whether a rounding of the input changes the whole value, as it does beside the border of a domain."""
    sizes = (length(truth.high[block.output][block.where]) for block in entry.blocks)
    return any(
        k * arithmetic.unit >= max(size, arithmetic.smallest_normal)
        for size, k in zip(sizes, truth.sensitivity, strict=True)
    )


def _lost(entry: Map) -> tuple[BlockScore, ...]:
    return tuple(BlockScore(block.name, math.inf, math.inf, 0.0) for block in entry.blocks)


def _raised(entry: Map, answer: Answer, refusals: Mapping[str, str] = NOTHING) -> Score:
    """Inside the domain a complaint is a finding, unless the documentation announces it: then nothing is offered."""
    why = None if answer.broken else announced(answer.complaint or "", refusals)
    if why is not None:
        return Score(Verdict.ABSENT, (), None, f"refused ({answer.complaint}), as documented: {why}")
    return Score(Verdict.RAISED, _lost(entry), None, answer.complaint or "raised")


def _outside(entry: Map, answer: Answer, refusal: str, policies: Mapping[str, str]) -> Score:
    """Outside the domain a refusal is right, raised or told by NaN or by a complex number; a silent answer is not.

    Unless it is one that the subject's documentation promises. A breakdown is none.
    """
    if answer.broken:
        return _raised(entry, answer)
    if answer.outputs is None or not all(np.all(np.isfinite(o)) and np.isrealobj(o) for o in answer.outputs):
        return Score(Verdict.OK, (), None, f"rightly refused: {refusal}")
    for reason, policy in policies.items():
        if reason in refusal:
            return Score(Verdict.OK, (), None, f"outside the domain ({refusal}) a documented policy: {policy}")
    return Score(Verdict.WRONG, _lost(entry), None, f"a silent answer outside the domain: {refusal}")


def _unmeasured(
    entry: Map, answer: Answer, truth: Truth, refusals: Mapping[str, str], arithmetic: Arithmetic
) -> Score | None:
    """The verdict where there is nothing to measure: no outputs, misshapen ones, or not finite ones."""
    if answer.outputs is None:
        return _raised(entry, answer, refusals)
    lost = _lost(entry)
    complaint = _well_formed(answer.outputs, truth)
    if complaint is None and _complex(answer.outputs) and _undecided(entry, truth, arithmetic):
        return Score(Verdict.OK, (), None, "complex, as values are at inputs that rounding cannot tell from this one")
    if complaint is not None:
        return Score(Verdict.WRONG, lost, None, complaint)
    pairs = zip(answer.outputs, truth.high, strict=True)
    if any(np.any(~np.isfinite(output) & (np.abs(due) <= arithmetic.largest)) for output, due in pairs):
        return Score(Verdict.NON_FINITE, lost, None, "not finite where a number is due")
    return None


def score(
    entry: Map,
    answer: Answer,
    truth: Truth,
    backward: float | None = None,
    policies: Mapping[str, str] = NOTHING,
    refusals: Mapping[str, str] = NOTHING,
    arithmetic: Arithmetic = FLOAT64,
) -> Score:
    """The verdict of one answer.

    ``backward`` is how far the inverse map takes the answer from where it takes the truth, scaled, in u: an answer to a
    logarithm that is wrong forward but right backward is another branch. ``policies``, ``refusals`` and ``arithmetic``
    are the subject's.
    """
    if truth.refusal is not None:
        return _outside(entry, answer, truth.refusal, policies)
    unmeasured = _unmeasured(entry, answer, truth, refusals, arithmetic)
    if unmeasured is not None or answer.outputs is None:
        return unmeasured or Score(Verdict.RAISED, (), None, "raised")
    outputs = answer.outputs
    blocks = tuple(
        block_score(
            block.name,
            outputs[block.output][block.where],
            truth.high[block.output][block.where],
            truth.low[block.output][block.where],
            sensitivity,
            arithmetic,
        )
        for block, sensitivity in zip(entry.blocks, truth.sensitivity, strict=True)
    )
    blocks += tuple(_fixed(entry, outputs, truth, arithmetic))
    worst = max(block.scaled for block in blocks)
    if _complex(outputs):
        # An imaginary part is an error as any other, held against the real value; one of mere rounding is still a
        # fault, for a real number is due.
        verdict, note = _grade(worst, None, entry.bound, arithmetic)
        if verdict is Verdict.WRONG:
            return Score(verdict, _lost(entry), None, COMPLEX)
        return Score(Verdict.DEGRADED, blocks, None, f"{COMPLEX}, {note or 'by an imaginary part of rounding'}")
    # Only a map that jumps, a logarithm, has other branches; anything else is wrong even where its inverse forgives.
    verdict, note = _grade(worst, backward if entry.continuation else None, entry.bound, arithmetic)
    return Score(verdict, blocks, backward, note)


def _grade(scaled: float, backward: float | None, bound: float, arithmetic: Arithmetic) -> tuple[Verdict, str]:
    if scaled <= bound:
        return Verdict.OK, ""
    if scaled <= arithmetic.lost_half:
        return Verdict.DEGRADED, f"{math.log2(scaled / bound):.1f} bits beyond the bound"
    if backward is not None and backward <= bound:
        return Verdict.OTHER_BRANCH, "its exponential gives the input back"
    return Verdict.WRONG, "more than half of the digits are lost"
