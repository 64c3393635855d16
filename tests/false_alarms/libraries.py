"""Asking an installed library for one item, and what is said of its answer."""

from __future__ import annotations

import numpy as np
import pytest

from affinecert.case import Case
from affinecert.errors import SubjectError
from affinecert.judging import judge, truths_of
from affinecert.map import Array
from affinecert.scoring import Verdict
from affinecert.subject import Subject, load

ACQUITTED = {Verdict.OK, Verdict.OTHER_BRANCH}

HALF_TURNS = {
    "x": np.diag([1.0, -1.0, -1.0]),
    "y": np.diag([-1.0, 1.0, -1.0]),
    "z": np.diag([-1.0, -1.0, 1.0]),
    "x minus y": np.array([[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]),
    "minus x plus z": np.array([[0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]]),
}
"""Rotations by pi exactly: as rotation vectors they have two signs."""


def installed(name: str) -> Subject:
    """The subject of that name; where its library is missing, the test is skipped."""
    try:
        return load(name)
    except SubjectError as error:
        pytest.skip(str(error))


def verdict(name: str, map: str, *inputs: Array) -> str:
    """The verdict on what the subject of that name answers at one input."""
    case = Case(map, "given", tuple(np.asarray(item, dtype=np.float64) for item in inputs), 0.0, "false alarm")
    (found,) = judge(installed(name), [case], truths_of([case]))
    return found.verdict
