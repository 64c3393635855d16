"""One evaluation of the hunt."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from affinecert.case import Case
from affinecert.catalogue import CATALOGUE
from affinecert.map import Array
from affinecert.scoring import Verdict
from affinecert.store import Store
from affinecert.subject import Subject
from affinecert.trial import Trial


@pytest.mark.parametrize(("scale", "verdict"), [(1 + 1e-9, Verdict.DEGRADED), (2.0, Verdict.WRONG)])
def test_a_complex_answer_is_measured_by_the_condition(scale: float, verdict: Verdict, tmp_path: Path) -> None:
    # Relative to the logarithm the imaginary part is 1e-7; beside 1 the condition of the logarithm is 1e9.
    def log(scales: Array) -> Array:
        return np.asarray(np.log(scales) * (1 + 1e-7j))

    case = Case("scale.log", "given", (np.array(scale),), 0.0, "given")
    with Store(tmp_path / "store.sqlite") as store:
        judged = Trial(Subject("complex", "1", {"scale.log": log}), CATALOGUE["scale.log"], store)(case)
    assert judged is not None
    assert judged.verdict is verdict
    assert np.isfinite(judged.scaled) == (verdict is Verdict.DEGRADED)
