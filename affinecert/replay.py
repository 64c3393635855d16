"""Replaying: the cases of a corpus file, or the worst inputs of a certificate, judged again."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from affinecert import catalogue, certificate, corpus
from affinecert.case import Case, from_record, rounded
from affinecert.certificate import CaseResult
from affinecert.errors import InputError, StoredFileError
from affinecert.inputs import check_shapes
from affinecert.judging import judge, truths_of
from affinecert.subject import Subject
from affinecert.tier import batches


def load(path: Path) -> tuple[Case, ...]:
    """The cases of a corpus file, or of a certificate (``.json``): of each map and regime its findings and its worst.

    Each stands once. Raises StoredFileError where the file cannot be read or holds no cases, UnknownNameError where one
    is of a map that the catalogue lacks.
    """
    cases = _of_certificate(path) if path.suffix == ".json" else corpus.read(path)
    for case in cases:
        try:
            check_shapes(catalogue.find(case.map), case.inputs)
        except InputError as error:
            raise StoredFileError(f"{path}: a case of {case.map} that does not fit it: {error}") from error
    return tuple({case.key: case for case in cases}.values())


def _of_certificate(path: Path) -> tuple[Case, ...]:
    results = certificate.read(path).results
    told = [(*result.findings, *([result.worst] if result.worst else [])) for result in results]
    return tuple(from_record(item.case, str(path)) for items in told for item in items)


def replay(cases: Sequence[Case], subject: Subject) -> tuple[CaseResult, ...]:
    """The results of the cases whose map the subject offers, in order, rounded to the numbers that it computes in."""
    taken = (rounded(case, subject.dtype) for case in cases if case.map in subject.maps)
    offered = [case for case in taken if case is not None]
    results = {
        case.key: result
        for batch in batches(offered)
        for case, result in zip(batch, judge(subject, batch, truths_of(batch)), strict=True)
    }
    return tuple(results[case.key] for case in offered)
