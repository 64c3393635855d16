"""Base against head: the verdict, the baseline file, the builds; timings themselves are never judged here."""

from __future__ import annotations

import json
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from affinecert.benchmarks import against
from affinecert.benchmarks.against import Comparison, Row, as_fast_as, compare, judge, rank_chance, render
from affinecert.benchmarks.baseline import read_baseline, write_baseline
from affinecert.benchmarks.builds import BuildError, commit, export, lay_out, packages, top
from affinecert.benchmarks.measuring import Measured
from affinecert.benchmarks.table import main as table_main
from affinecert.benchmarks.table import read as read_benchmarks
from affinecert.benchmarks.table import table
from affinecert.certificate import machine
from affinecert.errors import StoredFileError, UnknownNameError

ROOT = Path(__file__).parents[1]


def measured(center: float, spread: float = 0.05, scaled: float = 2.0, count: int = 20) -> Measured:
    """Samples spread evenly around a median."""
    steps = [center * (1 + spread * (2 * k / (count - 1) - 1)) for k in range(count)]
    return Measured("so3.exp", 100, tuple(steps), 2 * scaled, scaled, yardstick=1e-4)


@pytest.mark.parametrize(
    ("base", "head", "verdict"),
    [
        (measured(1.0), measured(1.0), "same"),
        (measured(1.0), measured(1.3), "slower"),
        (measured(1.3), measured(1.0), "faster"),
        (measured(1.0, 0.001), measured(1.05, 0.001), "same"),  # certain, but too little
        (measured(1.0, 0.9), measured(1.15, 0.9), "same"),  # much, but not certain
        (measured(1.0), measured(1.0, scaled=1e6), "same, less accurate"),
        (measured(1.0, scaled=0.1), measured(1.0, scaled=0.9), "same"),  # both round to the nearest or nearly
        (measured(1.3, scaled=2.0), measured(1.0, scaled=5.0), "faster, less accurate"),
    ],
)
def test_the_verdict_asks_the_ratio_and_the_ranks(base: Measured, head: Measured, verdict: str) -> None:
    row = judge(base, head)
    assert row.verdict == verdict
    assert row.ratio == pytest.approx(head.nanoseconds / base.nanoseconds)


def test_too_few_samples_are_no_evidence() -> None:
    assert judge(measured(1.0, count=3), measured(9.0, count=3)).verdict == "same"


def test_a_yardstick_tells_a_slower_machine_from_slower_code() -> None:
    base = measured(1.0)
    busy = replace(measured(2.0), yardstick=2e-4)
    assert judge(base, as_fast_as(base, busy)).verdict == "same"
    assert judge(base, as_fast_as(base, measured(2.0))).verdict == "slower"


def test_a_map_of_one_side_only_is_no_comparison() -> None:
    assert judge(None, measured(1.0)).verdict == "new"
    assert judge(measured(1.0), None).verdict == "gone"


def test_equal_samples_have_chance_one_and_distinct_ones_next_to_none() -> None:
    assert rank_chance([1.0] * 10, [1.0] * 10) == 1.0
    assert rank_chance([1.0, 1.1, 1.2] * 5, [2.0, 2.1, 2.2] * 5) < 1e-4


def comparison(*verdicts: str) -> Comparison:
    rows = tuple(Row("so3.exp", 1, measured(1.0), measured(1.0), 1.0, 1.0, verdict) for verdict in verdicts)
    return Comparison("main", "working tree", machine(), False, "", rows)


def test_slower_and_less_accurate_do_not_pass() -> None:
    assert comparison("same", "faster", "new", "gone", "recorded", "other machine").passed
    assert not comparison("same", "slower").passed
    assert not comparison("faster, less accurate").passed


def test_the_table_shows_time_and_error() -> None:
    text = render(comparison("same"))
    assert "| map | items | base, ns | head, ns |" in text
    assert "| so3.exp | 1 | 1e+07 | 1e+07 | 1 | 1 | 2 | 2 | same |" in text


def test_a_baseline_is_read_as_it_was_written(tmp_path: Path) -> None:
    path = tmp_path / "new" / "baseline.json"
    numbers = [measured(1.0), measured(2.0, scaled=float("inf"))]
    write_baseline(path, machine(), numbers)
    assert read_baseline(path) == (machine(), numbers)


@pytest.mark.parametrize("text", ["", "[]", '{"format": 99}', '{"format": 1, "machine": {}, "measured": []}'])
def test_a_broken_baseline_is_told(text: str, tmp_path: Path) -> None:
    path = tmp_path / "baseline.json"
    path.write_text(text)
    with pytest.raises(StoredFileError, match="cannot read the baseline"):
        compare(str(path), "so3.exp")


def test_the_numbers_of_another_machine_are_not_compared(tmp_path: Path) -> None:
    path = tmp_path / "baseline.json"
    write_baseline(path, replace(machine(), processor="abacus"), [measured(1e-9)])
    found = compare(str(path), "so3.exp")
    assert [row.verdict for row in found.rows] == ["other machine"]
    assert "numbers of another machine are not compared: processor abacus, now " in render(found)
    assert found.passed


def test_no_baseline_yet_is_recorded_and_the_next_time_compared(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("AFFINECERT_CACHE", str(tmp_path))
    path = tmp_path / "baseline.json"
    first = compare(str(path), "scale.exp", sizes=[1], turns=2)
    assert first.recorded
    assert first.passed
    assert [row.verdict for row in first.rows] == ["recorded"]
    again = compare(str(path), "scale.exp", sizes=[1], turns=2)
    assert not again.recorded
    assert again.rows[0].base == first.rows[0].head
    assert again.rows[0].ratio is not None


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A checkout of the sources as they are, committed."""
    folder = tmp_path_factory.mktemp("checkout")
    lean = shutil.ignore_patterns("__pycache__")
    for name in ("affinecert", *(folder for folder in packages(ROOT).values() if (ROOT / folder).parent == ROOT)):
        shutil.copytree(ROOT / name, folder / name, ignore=lean, dirs_exist_ok=True)
    shutil.copy(ROOT / "pyproject.toml", folder)
    identity = ["-c", "user.name=Test", "-c", "user.email=test@example.org"]
    for command in (["init", "--quiet"], ["add", "."], [*identity, "commit", "--quiet", "--message", "First"]):
        subprocess.run(["git", *command], cwd=folder, check=True, capture_output=True)
    return folder


def test_a_revision_is_built_and_compared(checkout: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("AFFINECERT_CACHE", str(tmp_path))
    told: list[tuple[int, int, str]] = []
    found = compare(
        "HEAD", "scale.exp", sizes=[1, 10], turns=2, folder=checkout, progress=lambda *now: told.append(now)
    )
    assert [(row.map, row.size) for row in found.rows] == [("scale.exp", 1), ("scale.exp", 10)]
    assert all(row.base and row.head and row.base.scaled == row.head.scaled for row in found.rows)
    assert found.base == f"HEAD ({commit(checkout, 'HEAD')[:12]})"
    assert told == [(1, 2, "scale.exp, 1 items"), (2, 2, "scale.exp, 10 items")]


def test_a_build_that_cannot_be_imported_is_told(
    checkout: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("AFFINECERT_CACHE", str(tmp_path))

    def broken(tree: Path, target: Path) -> Path:
        laid = lay_out(tree, target)
        (laid / "affinecert" / "subject.py").write_text("raise RuntimeError('broken')\n")
        return laid

    monkeypatch.setattr(against, "lay_out", broken)
    with pytest.raises(BuildError, match="base died with status 1: RuntimeError: broken"):
        compare("HEAD", "scale.exp", sizes=[1], turns=2, folder=checkout)


def test_the_layout_is_that_of_an_installation(checkout: Path, tmp_path: Path) -> None:
    lay_out(export(checkout, "HEAD", tmp_path / "tree"), tmp_path / "laid")
    assert (tmp_path / "laid" / "affinecert" / "reference" / "so3.py").is_file()
    assert [path.name for path in (tmp_path / "laid").iterdir()] == ["affinecert"]


def test_an_unknown_revision_is_told(checkout: Path) -> None:
    with pytest.raises(BuildError, match="no revision is named 'nonsense'"):
        compare("nonsense", "so3.exp", folder=checkout)


def test_an_unknown_map_is_told(checkout: Path) -> None:
    with pytest.raises(UnknownNameError, match=r"so3\.exq"):
        compare("HEAD", "so3.exq", folder=checkout)


def test_a_folder_that_is_no_checkout_is_told(tmp_path: Path) -> None:
    with pytest.raises(BuildError, match="not a git repository"):
        top(tmp_path)
    subprocess.run(["git", "init", "--quiet"], cwd=tmp_path, check=True)
    with pytest.raises(BuildError, match="is not a"):
        top(tmp_path)


def benchmark(implementation: str, seconds: float, **info: str) -> dict[str, object]:
    extra = {"map": "so3.exp", "size": 100, "implementation": implementation, **info}
    return {"extra_info": extra, "stats": {"median": seconds}}


def test_the_benchmarks_table_shows_times_beside_errors(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "benchmark.json"
    fast = benchmark("fast", 4e-6, worst_forward="2.5", worst_scaled="inf")
    path.write_text(json.dumps({"benchmarks": [fast, benchmark("copy", 1e-6)]}))
    lines = table(read_benchmarks(path)).splitlines()
    assert lines[2] == "| so3.exp | 100 | copy | 10 | 1 |  |  |"
    assert lines[3] == "| so3.exp | 100 | fast | 40 | 4 | 2.5 | inf |"
    assert table_main([str(path)]) == 0
    assert capsys.readouterr().out.splitlines() == lines


def test_the_benchmarks_table_tells_what_it_cannot_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert table_main([]) == 2
    assert table_main([str(tmp_path / "none.json")]) == 2
    assert "cannot read the benchmarks" in capsys.readouterr().err
