"""Subjects that compute in float32: their inputs are rounded first, and their errors told in units of 2^-24."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from affinecert import campaign, truths
from affinecert.arithmetic import FLOAT32, FLOAT64
from affinecert.case import Case, rounded
from affinecert.catalogue import CATALOGUE
from affinecert.certificate import dump, parse
from affinecert.errors import SubjectError
from affinecert.explain import explain
from affinecert.fast import so3
from affinecert.replay import replay
from affinecert.reports.html import html
from affinecert.reports.markdown import markdown
from affinecert.scoring import Answer, Verdict, block_score, score
from affinecert.subject import Subject, load
from affinecert.truths import Truth

Floats = NDArray[np.float32]
ENTRY = CATALOGUE["so3.exp"]
TURN = Case("so3.exp", "generic", (np.array([0.1, 0.2, 0.3]),), 0.0, "here")


def nearest(omega: Floats) -> Floats:
    assert omega.dtype == np.float32
    return so3.exp(omega.astype(np.float64)).astype(np.float32)


def off(units: float) -> Subject:
    return Subject(
        "off", "1", {"so3.exp": lambda omega: nearest(omega) * np.float32(1 + units * 2.0**-24)}, dtype="float32"
    )


good = Subject("good", "1", {"so3.exp": nearest}, dtype="float32")
strange = replace(good, dtype="float16")


def test_the_units() -> None:
    for arithmetic, dtype in ((FLOAT64, np.float64), (FLOAT32, np.float32)):
        numbers = np.finfo(dtype)
        assert arithmetic.dtype == np.dtype(dtype).name
        assert arithmetic.unit == numbers.eps / 2 == 2.0**-arithmetic.bits
        assert arithmetic.smallest_normal == numbers.smallest_normal
        assert arithmetic.largest == numbers.max
        assert arithmetic.lost_half == 2.0 ** (arithmetic.bits // 2)


def test_inputs_are_rounded_and_those_beyond_left_out() -> None:
    taken = rounded(TURN, "float32")
    assert taken is not None
    assert taken.inputs[0].dtype == np.float64
    assert (taken.inputs[0] == TURN.inputs[0].astype(np.float32)).all()
    assert taken.key != TURN.key
    assert rounded(TURN, "float64") is TURN
    assert rounded(replace(TURN, inputs=(np.array([1e39, 0.0, 0.0]),)), "float32") is None


@pytest.mark.parametrize(
    ("subject", "verdict"),
    [(good, Verdict.OK), (off(40), Verdict.DEGRADED), (off(2.0**17), Verdict.WRONG)],
    ids=["good", "40 units", "half of the bits"],
)
def test_errors_are_in_units_of_float32(subject: Subject, verdict: Verdict) -> None:
    (result,) = replay([TURN], subject)
    assert result.verdict == verdict
    (reply,) = explain("so3.exp", "[0.1, 0.2, 0.3]", [subject]).replies
    assert reply.score.verdict is verdict
    assert reply.score.scaled == result.scaled


def test_an_input_beyond_float32_cannot_be_asked() -> None:
    (reply,) = explain("so3.exp", "[1e39, 0, 0]", [good]).replies
    assert reply.score.verdict is Verdict.ABSENT
    assert reply.score.note == "the input is beyond float32"


def test_infinity_is_the_rounding_of_a_value_beyond() -> None:
    high = np.array([[1e39, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    truth = Truth((high,), (np.zeros((3, 3)),), (1.0,), None)
    answer = Answer((np.where(high > 1e38, np.inf, high),))
    assert score(ENTRY, answer, truth, arithmetic=FLOAT32).verdict is Verdict.OK
    assert score(ENTRY, answer, truth).verdict is Verdict.NON_FINITE
    assert score(ENTRY, Answer((-answer.outputs[0],)), truth, arithmetic=FLOAT32).verdict is Verdict.WRONG  # type: ignore[index]
    tiny = np.array([1e-47])
    assert block_score("b", np.zeros(1), tiny, np.zeros(1), 0.0, FLOAT32).scaled < 0.1


def test_a_certificate_tells_the_unit(tmp_path: Path) -> None:
    certificate = campaign.certify(good, maps="so3.exp", profile="quick", store=tmp_path / "store")
    assert certificate.passed
    assert certificate.dtype == "float32"
    assert not certificate.laws
    assert not certificate.morph_laws
    assert parse(dump(certificate), "here") == certificate
    assert "u = 2^-24;" in markdown(certificate)
    assert "u = 2<sup>−24</sup>, half the distance from 1 to the next float32" in html(certificate)


def test_a_dtype_that_nobody_scores_is_told() -> None:
    with pytest.raises(SubjectError, match=r"has the dtype 'float16'; known: float64, float32"):
        load(f"{__name__}:strange")


def test_truths_are_those_of_the_rounded_input() -> None:
    taken = rounded(TURN, "float32")
    assert taken is not None
    due = truths.compute(ENTRY, taken.inputs).high[0]
    ((answer,),) = [nearest(taken.inputs[0].astype(np.float32)[None])]
    assert np.abs(answer - due).max() <= 2.0**-25


def on_arc(start: Floats, end: Floats, t: Floats) -> Floats:
    """Slerp along the arc that the signs give, be it the longer one."""
    angle = np.arccos(np.sum(start * end, axis=-1))[:, None]
    t = t[:, None]
    return np.asarray((np.sin((1 - t) * angle) * start + np.sin(t * angle) * end) / np.sin(angle))


@pytest.mark.parametrize(("product", "verdict"), [(1e-9, Verdict.OTHER_BRANCH), (1e-3, Verdict.WRONG)])
def test_either_arc_between_quaternions_that_are_orthogonal_in_float32(product: float, verdict: Verdict) -> None:
    start, end = np.array([1.0, 0.0, 0.0, 0.0]), np.array([product, 0.0, 0.6, 0.8])
    end /= np.linalg.norm(end)
    tie = Case("quaternion.slerp", "given", (start, end, np.array(0.25)), 0.0, "given")
    longer = Subject("longer", "1", {"quaternion.slerp": lambda p, q, t: on_arc(p, -q, t)}, dtype="float32")
    (result,) = replay([tie], longer)
    assert result.verdict == verdict
