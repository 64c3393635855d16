"""Judging a batch: the subject's answers against the truths, with backward errors; the work of one process."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
from hypothesis.configuration import set_hypothesis_home_dir

from affinecert import truths
from affinecert.answering import answers, complaint
from affinecert.arithmetic import Arithmetic
from affinecert.case import Case, generate, to_hex, to_record
from affinecert.catalogue import CATALOGUE
from affinecert.certificate import CaseResult, LawRecord, MorphLawRecord, Timing
from affinecert.errors import InputError
from affinecert.manifold import distance, loosened, slack
from affinecert.map import Array, Map
from affinecert.properties.answers import singly
from affinecert.properties.check import LawResult, check
from affinecert.properties.law import Law
from affinecert.properties.laws import LAWS
from affinecert.properties.matrix.laws import LAWS as MORPH_LAWS
from affinecert.properties.matrix.morphs import MORPHS
from affinecert.properties.matrix.trial import trial
from affinecert.scoring import Answer, Score, Verdict, block_score, score
from affinecert.snippet import fill, printed
from affinecert.store import default_path
from affinecert.subject import Subject, load
from affinecert.truths import Truth

load_once = cache(load)


def resolve(subject: str | Subject) -> Subject:
    """The subject itself, or the one of that name, loaded once a process."""
    return subject if isinstance(subject, Subject) else load_once(subject)


def truths_of(cases: Sequence[Case]) -> list[Truth]:
    """The truths of cases, computed."""
    return [truths.compute(CATALOGUE[case.map], case.inputs) for case in cases]


def measured(answer: Answer, truth: Truth) -> bool:
    """Whether an answer can be taken through another map: real, finite, and of the truth's shapes."""
    if answer.outputs is None or truth.refusal is not None or len(answer.outputs) != len(truth.high):
        return False
    return all(
        not np.iscomplexobj(output) and output.shape == due.shape and bool(np.all(np.isfinite(output)))
        for output, due in zip(answer.outputs, truth.high, strict=True)
    )


def backward_error(
    entry: Map, answer: Answer, truth: Truth, arithmetic: Arithmetic, *, scaled: bool = False
) -> float | None:
    """How far the inverse map takes the answer from where it takes the truth, in u; None without an inverse.

    Relative to where it takes the truth, and if ``scaled``, over 1 + the inverse's condition there as well. Taken from
    where the truth goes, not from the input: an input off its manifold is no exponential at all.
    """
    if entry.inverse is None or answer.outputs is None or not measured(answer, truth):
        return None
    inverse = CATALOGUE[entry.inverse]
    exact = Truth(answer.outputs, tuple(np.zeros_like(output) for output in answer.outputs), (), None)
    try:
        due_high, due_low = truths.image(inverse, truth)
    except InputError:
        # The truth's float64 underflowed or overflowed to where the inverse does not exist.
        return None
    try:
        high, low = truths.image(inverse, exact)
        sensitivity = truths.compute(inverse, answer.outputs).sensitivity if scaled else (0.0,) * len(inverse.blocks)
    except InputError:
        return float("inf")
    return max(
        block_score(
            block.name,
            high[block.output][block.where] + 0.0,
            due_high[block.output][block.where] - low[block.output][block.where],
            due_low[block.output][block.where],
            allowed,
            arithmetic,
        ).scaled
        for block, allowed in zip(inverse.blocks, sensitivity, strict=True)
    )


def on_another_branch(
    entry: Map, inputs: tuple[Array, ...], answer: Answer, truth: Truth, judged: Score, subject: Subject
) -> Score:
    """The score of a wrong answer of a map that jumps, which may be right on another branch.

    By its inverse, where the map has one; else beside a jump, where a rounding of the input makes the choice.
    """
    arithmetic = subject.arithmetic
    if judged.verdict is not Verdict.WRONG or entry.continuation is None or not measured(answer, truth):
        return judged
    if entry.inverse is not None:
        if truths.principal(entry, inputs, answer.outputs or ()):
            return judged  # the inverse forgives a logarithm of next to nothing, which is inaccurate all the same
        backward = backward_error(entry, answer, truth, arithmetic, scaled=True)
        if backward is not None:
            backward /= slack(entry, inputs, subject)
        return score(entry, answer, truth, backward, arithmetic=arithmetic)
    reach = entry.bound * arithmetic.unit * slack(entry, inputs, subject)
    for other in truths.across(entry, inputs, truth, reach):
        if score(entry, answer, other, arithmetic=arithmetic).verdict is Verdict.OK:
            return replace(judged, verdict=Verdict.OTHER_BRANCH, note="the value beyond a jump within rounding")
    return judged


def as_taken(entry: Map, inputs: tuple[Array, ...], truth: Truth, subject: Subject) -> Truth:
    """The truth for a subject: where it takes matrices as they are, with the condition of an input that is one."""
    return loosened(entry, truth, slack(entry, inputs, subject), subject.arithmetic.smallest_normal)


def held_against(entry: Map, answer: Answer, truth: Truth, subject: Subject) -> Score:
    """The score of a subject's answer by its own words and arithmetic, other branches not looked for."""
    return score(
        entry,
        answer,
        truth,
        policies=subject.policies,
        refusals=subject.refusals,
        arithmetic=subject.arithmetic,
    )


def weigh(entry: Map, inputs: tuple[Array, ...], answer: Answer, truth: Truth, subject: Subject) -> Score:
    """The score of a subject's answer, with its backward error, which may show that it is right on another branch."""
    due = as_taken(entry, inputs, truth, subject)
    judged = on_another_branch(entry, inputs, answer, due, held_against(entry, answer, due, subject), subject)
    if truth.refusal is None and (due is not truth or judged.verdict in {Verdict.DEGRADED, Verdict.WRONG}):
        off = distance(entry, inputs)
        if off > entry.bound * subject.arithmetic.unit:
            told = "the input itself is" if due is truth else "taken as it is, the input being"
            judged = replace(judged, note="; ".join(filter(None, (judged.note, f"{told} {off:.1e} off the manifold"))))
    return replace(judged, backward=backward_error(entry, answer, truth, subject.arithmetic))


def result(case: Case, judged: Score) -> CaseResult:
    """The record of one judged case; the block is the one with the worst scaled error."""
    worst = max(judged.blocks, key=lambda block: block.scaled, default=None)
    return CaseResult(
        verdict=str(judged.verdict),
        note=judged.note,
        block=worst.block if worst else "",
        forward=judged.forward,
        scaled=judged.scaled,
        condition=worst.condition if worst else 0.0,
        backward=judged.backward,
        case=to_record(case),
    )


def judge(subject: str | Subject, cases: Sequence[Case], known: Sequence[Truth]) -> list[CaseResult]:
    """The results of cases of one map and one shape."""
    entry = CATALOGUE[cases[0].map]
    asked = resolve(subject)
    return [
        result(case, weigh(entry, case.inputs, answer, truth, asked))
        for case, answer, truth in zip(cases, answers(asked, cases), known, strict=True)
    ]


def shown(subject: str | Subject, case: Case, truth: Truth) -> str:
    """The verdict on what the subject's snippet prints at a case: that without affinecert the library does the same."""
    asked = resolve(subject)
    entry = CATALOGUE[case.map]
    snippet = fill(asked.snippets[case.map], [to_hex(array) for array in case.inputs], f"{asked.name}, {case.map}")
    try:
        values = printed(snippet)
        outputs = values if len(entry.outputs) > 1 else [values]
        answer = Answer(tuple(np.asarray(output) for output in outputs))
    except Exception as error:
        answer = Answer(None, complaint(error))
    return str(weigh(entry, case.inputs, answer, truth, asked).verdict)


def not_answered(case: Case, complaint: str) -> CaseResult:
    """The record of a case whose call never came back."""
    lost = Score(Verdict.RAISED, (), None, complaint)
    record = result(case, lost)
    return CaseResult(**{**record.__dict__, "forward": float("inf"), "scaled": float("inf")})


def obey(subject: str | Subject, name: str, examples: int) -> LawRecord:
    """The record of one law, tried on that many examples."""
    # Hypothesis keeps notes while it shrinks: in the cache, not in the folder that somebody happens to stand in.
    set_hypothesis_home_dir(default_path().parent / "hypothesis")
    tried = check(_law(name), singly(resolve(subject)), examples)
    return law_record(tried)


def law_record(tried: LawResult) -> LawRecord:
    """What became of a law, with the law's own words."""
    law = _law(tried.law)
    return LawRecord(
        name=law.name,
        statement=law.statement,
        source=law.source,
        domain=law.domain,
        verdict=tried.verdict,
        worst=tried.worst,
        bound=law.bound,
        examples=tried.examples,
        inputs=tried.inputs,
        note=tried.note,
    )


def _law(name: str) -> Law:
    return next(law for law in LAWS if law.name == name)


def morph_laws(subject: str | Subject, name: str, laws: Sequence[str]) -> tuple[MorphLawRecord, ...]:
    """A row of the law matrix: what becomes of those laws on the morph of that name."""
    morph = next(morph for morph in MORPHS if morph.name == name)
    function = resolve(subject).maps.get(morph.map)
    if function is None:
        return tuple(MorphLawRecord(name, law, "absent", morph.takes) for law in laws)
    tried = trial(function, morph)
    return tuple(tried(law) for law in MORPH_LAWS if law.name in laws)


ROUND_SECONDS = 0.02
"""A timing round lasts at least so long, thousands of times a clock's tick."""


def time_map(subject: str | Subject, name: str, batch: int = 10_000, rounds: int = 3) -> Timing | None:
    """The best time per item of a map on its first regime, repeated to the batch size; None if the subject refuses."""
    entry, asked = CATALOGUE[name], resolve(subject)
    function = asked.maps[name]
    cases = list(generate(entry, entry.regimes[0], 32))
    columns = [np.stack(arrays).astype(asked.dtype) for arrays in zip(*(case.inputs for case in cases), strict=True)]
    size, best = 1, float("inf")
    try:
        while True:
            inputs = [np.resize(column, (size, *column.shape[1:])) for column in columns]
            function(*inputs)
            started = time.perf_counter()
            function(*inputs)
            elapsed = time.perf_counter() - started
            if elapsed > ROUND_SECONDS or size >= batch:
                break
            size = min(size * 10, batch)
        for _ in range(rounds):
            started = time.perf_counter()
            function(*inputs)
            best = min(best, time.perf_counter() - started)
    except Exception:
        return None
    return Timing(name, size, best / size * 1e9)
