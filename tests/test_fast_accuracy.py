"""What `fast` promises: a scaled error for every map in every regime, and a forward error where angles are moderate."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from affinecert.answering import answers
from affinecert.catalogue import CATALOGUE
from affinecert.judging import resolve, truths_of
from affinecert.map import Map
from affinecert.scoring import BlockScore, Verdict, score
from affinecert.tier import PROFILES, batches, select

FORWARD: Mapping[str, float] = {
    "so3.exp": 6.0,
    "se3.exp": 6.0,
    "sim3.exp": 6.0,
    "so3.log": 4.0,
    "se3.log": 4.0,
    "sim3.log": 8.0,
    "sim3.condition": 4.0,
}
"""The forward error promised where the condition is below 10, in u."""


@pytest.mark.parametrize("entry", CATALOGUE.values(), ids=CATALOGUE)
def test_every_regime_keeps_the_promised_error(entry: Map) -> None:
    worst: dict[str, float] = {}
    forward: list[BlockScore] = []
    for batch in batches(select([entry], PROFILES["quick"])):
        for case, answer, truth in zip(batch, answers(resolve("fast"), batch), truths_of(batch), strict=True):
            judged = score(entry, answer, truth)
            assert judged.verdict is Verdict.OK, (case.regime, judged)
            worst[case.regime] = max(worst.get(case.regime, 0.0), judged.scaled)
            forward += [block for block in judged.blocks if block.condition < 10.0]
    assert {regime: scaled for regime, scaled in worst.items() if scaled > entry.accuracy} == {}
    limit = FORWARD.get(entry.name)
    assert limit is None or max(block.forward for block in forward) <= limit
