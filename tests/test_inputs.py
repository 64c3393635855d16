"""`affinecert.truth`: the value with its condition, and what is said of inputs that are none."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest

import affinecert


def test_the_truth_is_good_to_106_bits() -> None:
    found = affinecert.truth("scale.exp", 1.0)
    with mpmath.workprec(200):
        assert abs(mpmath.mpf(float(found.high[0])) + float(found.low[0]) - mpmath.e) < mpmath.mpf(2) ** -104
    assert found.sensitivity[0] == pytest.approx(np.e)


def test_outside_the_domain_there_is_a_reason_instead() -> None:
    found = affinecert.truth("sam.log", np.diag([-1.0, -2.0, 1.0]))
    assert found.refusal is not None
    assert found.refusal.startswith("no real logarithm")
    assert found.high == ()


@pytest.mark.parametrize(
    ("name", "inputs", "message"),
    [
        ("so3.lgo", ([1.0, 0.0, 0.0],), "no map is named 'so3.lgo'; did you mean so3.log"),
        ("so3.exp", ([1.0, 0.0],), r"omega: shape \(2,\) where \(3,\) is due"),
        ("so3.exp", ([1.0, np.nan, 0.0],), "omega: not finite"),
        ("so3.exp", (["a", "b", "c"],), "omega: not an array of numbers"),
        ("so3.exp", (), "inputs: 0 arguments where 1 are due"),
        ("so3.exp", ([1.0, 0.0, 0.0], 2.0), "inputs: 2 arguments where 1 are due"),
        ("sam.power", (np.eye(4), [1.0]), r"t: shape \(1,\) where \(\) is due"),
    ],
)
def test_what_is_no_input_is_told(name: str, inputs: tuple[Any, ...], message: str) -> None:
    with pytest.raises(affinecert.AffinecertError, match=message):
        affinecert.truth(name, *inputs)


def test_a_name_that_is_not_there_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'cretify'"):
        affinecert.cretify  # noqa: B018
