"""The campaign: from a subject's name to its certificate.

The catalogue's regimes and the corpus give cases; the store or the reference gives truths; the subject answers a whole
batch; scoring compares. Batches run on an executor, and each is kept in the store as it comes.
"""

from __future__ import annotations

import hashlib
import inspect
import math
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import asdict, dataclass, field
from datetime import UTC, datetime
from functools import partial
from importlib.metadata import version
from pathlib import Path
from typing import Any, Protocol

from pebble import ProcessExpired

from affinecert import catalogue
from affinecert.case import Case, from_record
from affinecert.certificate import (
    CaseResult,
    Certificate,
    LawRecord,
    MorphLawRecord,
    RegimeResult,
    case_result,
    machine,
    plain,
)
from affinecert.errors import UnknownNameError
from affinecert.executor import Executor, executor
from affinecert.judging import (
    judge,
    law_record,
    morph_laws,
    not_answered,
    obey,
    resolve,
    shown,
    time_map,
    truths_of,
)
from affinecert.law_matrix import lost
from affinecert.properties.check import LawResult
from affinecert.properties.laws import LAWS
from affinecert.properties.matrix.laws import LAWS as MORPH_LAWS
from affinecert.properties.matrix.morphs import MORPHS, Morph
from affinecert.store import Store, reference_version
from affinecert.subject import Subject
from affinecert.summary import summarise
from affinecert.tier import PROFILES, Profile, batches, select, taken
from affinecert.truths import Truth

CASE_SECONDS = 20.0
"""The default time limit of a case: it covers a library's import and a compiler's first run."""

LAW_CASES = 10
"""A law may take as long as so many cases: the slowest takes a tenth of that on the reference, at the default limit.

And so may a row of the law matrix."""

PATIENCE = 6
"""Calls of a map that may come to nothing before the rest is not asked: enough to find one bad case in a batch."""


class Progress(Protocol):
    """Told after each finished piece of work."""

    def __call__(self, done: int, total: int, doing: str) -> None:
        """So many pieces of so many are done; ``doing`` names the last."""


def _silent(done: int, total: int, doing: str) -> None:
    """No progress is shown unless somebody asks for it."""


def run_name(subject: Subject) -> str:
    """A digest of what decides a subject's answers: its name and version, and the sources of its functions.

    Those are all that lie in the folders of their modules, and the files that a function names itself, as ``sources``.
    """
    digest = hashlib.sha256(repr((subject.name, subject.version, version("affinecert"))).encode())
    modules = {inspect.unwrap(function).__module__ for function in subject.maps.values()}
    folders = {Path(found).parent for name in modules if (found := getattr(sys.modules.get(name), "__file__", None))}
    named = {source for function in subject.maps.values() for source in getattr(function, "sources", ())}
    for source in [*(path for folder in sorted(folders) for path in sorted(folder.glob("*.py"))), *sorted(named)]:
        digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


@dataclass
class _Campaign:
    """The state of one run; its methods start work and handle what comes back."""

    subject: str | Subject
    run: str
    store: Store
    submit: Executor
    progress: Progress
    limit: float
    results: dict[str, CaseResult] = field(default_factory=dict)
    laws: dict[str, LawRecord] = field(default_factory=dict)
    rows: dict[str, tuple[MorphLawRecord, ...]] = field(default_factory=dict)
    pending: dict[Future[Any], Callable[[Future[Any]], None]] = field(default_factory=dict)
    asked: dict[str, list[Future[Any]]] = field(default_factory=lambda: defaultdict(list))
    lost: Counter[str] = field(default_factory=Counter)
    reason: dict[str, str] = field(default_factory=dict)
    done: int = 0
    total: int = 0

    def told(self, pieces: int, doing: str) -> None:
        self.done += pieces
        self.progress(self.done, self.total, doing)

    def later(self, future: Future[Any], handle: Callable[[Future[Any]], None]) -> None:
        self.pending[future] = handle

    def drain(self) -> None:
        """Handles futures as they finish; a handler may add new ones."""
        while self.pending:
            finished, _ = wait(self.pending, timeout=1.0, return_when=FIRST_COMPLETED)
            for future in finished:
                self.pending.pop(future)(future)

    def begin(self, batch: tuple[Case, ...]) -> None:
        """Looks the truths of a batch up, or has them computed first."""
        entry = catalogue.find(batch[0].map)
        reference = reference_version(entry)
        held = self.store.truths(reference, [case.key for case in batch])
        missing = [case for case in batch if case.key not in held]
        if not missing:
            self.told(len(batch), f"{entry.name}, truths looked up")
            self.ask(batch, held)
            return

        def arrived(future: Future[Any]) -> None:
            fresh = dict(zip([case.key for case in missing], future.result(), strict=True))
            self.store.keep_truths(reference, fresh)
            self.told(len(batch), f"{entry.name}, truths computed")
            self.ask(batch, held | fresh)

        self.later(self.submit(truths_of, missing), arrived)

    def ask(self, batch: tuple[Case, ...], held: Mapping[str, Truth]) -> None:
        """Has a batch judged; one that takes too long, or kills its process, is asked again in halves."""
        name = batch[0].map

        def arrived(future: Future[Any]) -> None:
            complaint = _why_lost(future, self.limit)
            if complaint is None:
                self.judged(batch, future.result())
                return
            if not future.cancelled():
                self.lost[name] += 1
                self.reason[name] = complaint
            if len(batch) == 1 and not future.cancelled():
                self.judged(batch, [not_answered(batch[0], complaint)])
                return
            middle = max(len(batch) // 2, 1)
            for half in filter(None, (batch[:middle], batch[middle:])):
                self.ask(half, held)

        if self.lost[name] >= PATIENCE:
            for future in self.asked.pop(name, []):
                future.cancel()
            complaint = f"not asked, as {PATIENCE} calls came to nothing: {self.reason[name]}"
            self.judged(batch, [not_answered(case, complaint) for case in batch])
            return
        known = [held[case.key] for case in batch]
        future = self.submit(judge, self.subject, batch, known, timeout=self.limit)
        self.asked[name].append(future)
        self.later(future, arrived)

    def judged(self, batch: tuple[Case, ...], results: Sequence[CaseResult]) -> None:
        fresh = dict(zip([case.key for case in batch], results, strict=True))
        self.results |= fresh
        self.store.keep_verdicts(self.run, {key: plain(asdict(result)) for key, result in fresh.items()})
        self.told(len(batch), f"{batch[0].map} {batch[0].regime}")

    def schedule_laws(self, chosen: Sequence[str], profile: Profile) -> list[str]:
        """Starts the laws that speak of chosen maps only; their names, in order."""
        limit = LAW_CASES * self.limit

        def arrived(name: str, future: Future[Any]) -> None:
            complaint = _why_lost(future, limit)
            failed = LawResult(name, "failed", math.inf, (), complaint or "", 0)
            self.laws[name] = law_record(failed) if complaint else future.result()
            self.told(1, f"law {name}")

        names = [law.name for law in LAWS if set(law.needs) <= set(chosen)]
        for name in names:
            self.later(self.submit(obey, self.subject, name, profile.examples, timeout=limit), partial(arrived, name))
        self.total += len(names)
        return names

    def schedule_morphs(self, offered: Sequence[str]) -> list[str]:
        """Starts the rows of the law matrix of the morphs among the maps offered; their names, in order."""
        limit = LAW_CASES * self.limit
        chosen = [morph for morph in MORPHS if morph.map in offered]

        def arrived(morph: Morph, future: Future[Any]) -> None:
            complaint = _why_lost(future, limit)
            self.rows[morph.name] = lost(morph, MORPH_LAWS, complaint) if complaint else future.result()
            self.told(1, f"laws of {morph.name}")

        for morph in chosen:
            call = self.submit(morph_laws, self.subject, morph.name, [law.name for law in MORPH_LAWS], timeout=limit)
            self.later(call, partial(arrived, morph))
        self.total += len(chosen)
        return [morph.name for morph in chosen]

    def go_on(self, cases: Sequence[Case], finished: Mapping[str, Any]) -> None:
        """Starts the cases that an interrupted run has not finished."""
        self.results = {case.key: case_result(finished[case.key]) for case in cases if case.key in finished}
        # A case counts twice, once for its truth and once for its verdict.
        self.total += 2 * len(cases)
        if self.results:
            self.told(2 * len(self.results), f"going on from {len(self.results)} finished cases")
        for batch in batches(case for case in cases if case.key not in self.results):
            self.begin(batch)


def _with_shown(state: _Campaign, snippets: Mapping[str, str], results: Sequence[RegimeResult]) -> list[RegimeResult]:
    """The results, each gravest finding with what its snippet shows, where the subject has one."""
    asked: dict[int, Future[str]] = {}
    for number, result in enumerate(results):
        if result.findings and result.map in snippets:
            case = from_record(result.findings[0].case, result.map)
            (truth,) = state.store.truths(reference_version(catalogue.find(case.map)), [case.key]).values()
            asked[number] = state.submit(shown, state.subject, case, truth, timeout=state.limit)
    wait(asked.values())
    verdicts = {number: "" if _why_lost(future, state.limit) else future.result() for number, future in asked.items()}
    return [result.showing(verdicts.get(number, "")) for number, result in enumerate(results)]


def _why_lost(future: Future[Any], limit: float) -> str | None:
    """Why a call came to nothing: it hung, or its process died. Errors of our own are raised."""
    if future.cancelled():
        return "withdrawn"
    error = future.exception()
    if error is None:
        return None
    if isinstance(error, TimeoutError):
        return f"no answer within {limit:g} s"
    if isinstance(error, ProcessExpired):
        return f"the process died: {error}"
    raise error


def certify(
    subject: str | Subject = "fast",
    *,
    maps: str = "*",
    profile: str = "standard",
    jobs: int = 1,
    store: Path | None = None,
    fresh: bool = False,
    limit: float = CASE_SECONDS,
    progress: Progress = _silent,
) -> Certificate:
    """The certificate of a subject: a built-in name, ``module:attribute``, or a Subject.

    With more than one job the work is done in that many processes, and a case that gives no answer within ``limit``
    seconds is stopped and counts as raised; with one, in this process, where nothing can stop it. A Subject given as an
    object must be picklable for more than one job. Laws are tried on subjects that compute in float64. A run that was
    interrupted is gone on with, unless ``fresh``. Raises UnknownNameError, SubjectError or StoredFileError.
    """
    if profile not in PROFILES:
        raise UnknownNameError("profile", profile, PROFILES)
    started = time.perf_counter()
    entries = catalogue.matching(maps)
    loaded = resolve(subject)
    offered = [entry for entry in entries if entry.name in loaded.maps]
    cases = list(taken(select(offered, PROFILES[profile]), loaded.dtype))
    run, exact = run_name(loaded), loaded.dtype == "float64"
    with Store(store) as kept, executor(jobs) as submit:
        if fresh:
            kept.forget(run)
        state = _Campaign(subject, run, kept, submit, progress, limit)
        # What a law allows an answer to err by is told in float64's unit.
        laws = state.schedule_laws([entry.name for entry in entries], PROFILES[profile]) if exact else []
        rows = state.schedule_morphs([entry.name for entry in offered]) if exact else []
        state.go_on(cases, kept.verdicts(run))
        state.drain()
        results = _with_shown(state, loaded.snippets, summarise(cases, state.results))
        timings = [submit(time_map, subject, entry.name, timeout=limit * 2) for entry in offered]
        wait(timings)
        kept.forget(run)
    return Certificate(
        subject=loaded.name,
        subject_version=loaded.version,
        spec=subject if isinstance(subject, str) else "MODULE:ATTRIBUTE",
        conventions=loaded.words,
        dtype=loaded.dtype,
        affinecert=version("affinecert"),
        profile=profile,
        maps=maps,
        created=datetime.now(UTC).isoformat(timespec="seconds"),
        seconds=time.perf_counter() - started,
        machine=machine(),
        results=tuple(results),
        laws=tuple(state.laws[name] for name in laws),
        timings=tuple(future.result() for future in timings if future.exception() is None and future.result()),
        absent=tuple(entry.name for entry in entries if entry.name not in loaded.maps),
        morph_laws=tuple(cell for name in rows for cell in state.rows[name]),
        snippets=dict(loaded.snippets),
    )
