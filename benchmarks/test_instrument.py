"""The instrument itself: how many truths, verdicts and hunted inputs a second."""

from __future__ import annotations

from pathlib import Path

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from affinecert.benchmarks.workload import tier, truths
from affinecert.catalogue import CATALOGUE
from affinecert.hunt import hunt
from affinecert.judging import judge, truths_of
from affinecert.subject import load

HUNTED = 50
"""Evaluations of a timed hunt."""


@pytest.mark.parametrize("name", sorted(CATALOGUE))
def test_truths(benchmark: BenchmarkFixture, name: str) -> None:
    """Truths of one case of every regime, computed."""
    cases = [group[0] for group in tier(CATALOGUE[name])]
    benchmark.group = "truths"
    benchmark.extra_info.update(map=name, size=len(cases), implementation="truth")
    benchmark.pedantic(truths_of, (cases,), rounds=2)


@pytest.mark.parametrize("name", sorted(CATALOGUE))
def test_verdicts(benchmark: BenchmarkFixture, name: str) -> None:
    """Verdicts on a batch, its truths known."""
    group = tier(CATALOGUE[name])[0]
    known = [truths(name)[case.key] for case in group]
    subject = load("fast")
    benchmark.group = "verdicts"
    benchmark.extra_info.update(map=name, size=len(group), implementation="verdict")
    benchmark.pedantic(judge, (subject, group, known), rounds=2, warmup_rounds=1)


@pytest.mark.parametrize("name", ["so3.log", "se3.exp", "shear.log"])
def test_hunt(benchmark: BenchmarkFixture, name: str, tmp_path: Path) -> None:
    """Inputs tried by a hunt, shrinking included."""
    benchmark.group = "hunts"
    benchmark.extra_info.update(map=name, size=HUNTED, implementation="hunt")
    settings = {"evaluations": HUNTED, "store": tmp_path / "store.sqlite"}
    benchmark.pedantic(hunt, ("printed", name), settings, rounds=1)
