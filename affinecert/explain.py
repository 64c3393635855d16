"""One input of one map, explained: its truth, what each subject answers, and what is to be said of that."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Context, Decimal

import numpy as np

from affinecert import catalogue, truths
from affinecert.answering import answers
from affinecert.case import Case, rounded
from affinecert.inputs import read_inputs
from affinecert.judging import resolve, weigh
from affinecert.map import Array, Map
from affinecert.scoring import Answer, Score, Verdict
from affinecert.subject import Subject
from affinecert.truths import Truth

DIGITS = Context(prec=30)
"""Truths are told to thirty digits: the pair of floats that keeps them is good to 106 bits, nearly 32 digits."""


@dataclass(frozen=True)
class Reply:
    """What one subject answers, and its score; an absent map has neither outputs nor errors."""

    subject: str
    version: str
    answer: Answer
    score: Score


@dataclass(frozen=True)
class Explanation:
    """An input with its truth and the replies of the subjects asked."""

    map: Map
    inputs: tuple[Array, ...]
    truth: Truth
    replies: tuple[Reply, ...]


@dataclass(frozen=True)
class Entry:
    """One number of a truth: the output it belongs to, its index there, and its value to thirty digits."""

    output: int
    index: tuple[int, ...]
    digits: str


def explain(map: str, inputs: str, subjects: Sequence[str | Subject]) -> Explanation:
    """The explanation of a map at the inputs in a text (see `read_inputs`).

    Raises UnknownNameError for the map, InputError for the inputs, and UnknownNameError or SubjectError for a subject.
    An input of the right shape but outside the map's domain is explained: there a refusal is right.
    """
    entry = catalogue.find(map)
    arrays = read_inputs(entry, inputs)
    asked = [resolve(subject) for subject in subjects]
    truth = truths.compute(entry, arrays)
    case = Case(entry.name, "given", arrays, 0.0, "given")
    return Explanation(entry, arrays, truth, tuple(_reply(subject, entry, case, truth) for subject in asked))


def _reply(subject: Subject, entry: Map, case: Case, truth: Truth) -> Reply:
    if entry.name not in subject.maps:
        nothing = Answer(None, "the subject does not offer this map")
        return Reply(subject.name, subject.version, nothing, Score(Verdict.ABSENT, (), None, str(nothing.complaint)))
    taken = rounded(case, subject.dtype)
    if taken is None:
        nothing = Answer(None, f"the input is beyond {subject.dtype}")
        return Reply(subject.name, subject.version, nothing, Score(Verdict.ABSENT, (), None, str(nothing.complaint)))
    (answer,) = answers(subject, [taken])
    at = truth if taken.key == case.key else truths.compute(entry, taken.inputs)
    judged = weigh(entry, answer, at, subject)
    return Reply(subject.name, subject.version, answer, judged)


def entries(truth: Truth) -> tuple[Entry, ...]:
    """The entries of a truth, output by output, row by row."""
    return tuple(
        Entry(output, index, str(DIGITS.add(Decimal(float(high[index])), Decimal(float(low[index])))))
        for output, (high, low) in enumerate(zip(truth.high, truth.low, strict=True))
        for index in np.ndindex(high.shape)
    )
