"""The ledger of claims, run: the chapters of the papers on an executor, their findings as they come."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import Future, as_completed
from typing import Any

from pebble import ProcessExpired

from affinecert.errors import UnknownNameError
from affinecert.executor import executor
from affinecert.properties.claims import LEDGER, PAPERS
from affinecert.properties.claims.claim import Claim, Verdict
from affinecert.properties.claims.finding import Finding, judge

CHAPTER_SECONDS = 300.0
"""Time limit of a chapter, with two jobs or more: twenty times what the slowest takes."""


def find(name: str) -> Claim[Any, Any]:
    """The claim of that id. Raises UnknownNameError."""
    if name not in LEDGER:
        raise UnknownNameError("claim", name, LEDGER)
    return LEDGER[name]


def chosen(paper: str | None = None, verdict: str | None = None) -> tuple[Claim[Any, Any], ...]:
    """The claims of a paper, or of all, with a verdict, or any. Raises UnknownNameError."""
    for kind, name, known in (("paper", paper, PAPERS), ("verdict", verdict, [str(each) for each in Verdict])):
        if name is not None and name not in known:
            raise UnknownNameError(kind, name, known)
    return tuple(
        claim for claim in LEDGER.values() if paper in {None, claim.paper} and verdict in {None, str(claim.verdict)}
    )


def judged(names: Sequence[str]) -> list[Finding]:
    """The findings of claims, by their ids; the work of one process."""
    return [judge(LEDGER[name]) for name in names]


def run(
    claims: Sequence[Claim[Any, Any]], *, jobs: int = 1, limit: float = CHAPTER_SECONDS
) -> Iterator[tuple[Finding, ...]]:
    """The findings of claims, a chapter at a time, as they are done: claims of one chapter share their experiments.

    With more than one job, in that many processes; a chapter that takes longer than ``limit`` seconds is given up.
    """
    names = {claim.id for claim in claims}
    chapters = [
        [claim.id for claim in chapter.CLAIMS if claim.id in names]
        for paper in PAPERS.values()
        for chapter in paper.chapters
    ]
    with executor(jobs) as submit:
        started = ((submit(judged, each, timeout=limit), each) for each in chapters if each)
        if jobs == 1:  # a call is done when it has started
            for future, each in started:
                yield _findings(future, each, limit)
            return
        pending = dict(started)
        for future in as_completed(pending):
            yield _findings(future, pending[future], limit)


def _findings(future: Future[Any], names: Sequence[str], limit: float) -> tuple[Finding, ...]:
    try:
        return tuple(future.result())
    except TimeoutError:
        complaint = f"no answer within {limit:g} s"
    except ProcessExpired as error:
        complaint = f"the process died: {error}"
    return tuple(Finding(name, "failed", complaints=(complaint,)) for name in names)
