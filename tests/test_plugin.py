"""The pytest plugin, from projects that know nothing of this repository."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

from affinecert import single_regime
from affinecert.campaign import certify
from affinecert.catalogue import CATALOGUE
from affinecert.errors import StoredFileError
from affinecert.properties import plugin
from affinecert.properties.expectations import Expectation, Expectations, parse, read
from affinecert.properties.laws import LAWS
from affinecert.tier import PROFILES

pytest_plugins = "pytester"

ADAPTER = '''
"""Adapters for the tests of the plugin."""
import numpy as np
from affinecert import Subject


def exp(vector):
    """The exponential, but by its series to first order next to zero."""
    angle = np.linalg.norm(vector, axis=1)[:, None, None]
    x, y, z = vector.T
    zero = np.zeros_like(x)
    cross = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=1).reshape(-1, 3, 3)
    series = np.where(angle < 1e-3, 0.0, (1 - np.cos(angle)) / np.maximum(angle, 1e-3) ** 2)
    return np.eye(3) + np.sinc(angle / np.pi) * cross + series * cross @ cross


coarse = Subject("coarse", "1.0", {"so3.exp": exp, "so3.exq": exp})
scales = Subject("scales", "1.0", {"scale.exp": np.exp, "scale.log": np.log})
single = Subject("single", "1.0", {"scale.exp": np.exp}, dtype="float32")
nothing = Subject("nothing", "1.0", {"so3.exq": exp})
'''

PYARGS = ("--pyargs", "affinecert.properties", "--affinecert-profile", "quick", "-p", "no:cacheprovider")

REGIMES = [f"so3.exp[{regime.name}]" for regime in CATALOGUE["so3.exp"].regimes]
COARSE = ["so3.exp[near-identity]", "so3.exp[equal-components]"]
"""Where some vectors are short enough for the series, but not short enough."""


@pytest.fixture
def project(pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> pytest.Pytester:
    """A folder with an adapter in it, and a store of its own."""
    monkeypatch.setenv("AFFINECERT_CACHE", str(pytester.path / "cache"))
    pytester.makepyfile(adapter_of_plugin=ADAPTER)
    pytester.syspathinsert()
    return pytester


def run(project: pytest.Pytester, *arguments: str) -> pytest.RunResult:
    return project.runpytest_inprocess(*PYARGS, *arguments)


def collected(project: pytest.Pytester, *subjects: str) -> list[str]:
    given = [word for subject in subjects for word in ("--affinecert-subject", subject)]
    lines = run(project, "--collect-only", "--quiet", *given).stdout.lines
    return [line.partition("subject_tests.py::")[2] for line in lines if "subject_tests.py::" in line]


def test_a_scratch_project_outside_of_the_repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("AFFINECERT_CACHE", str(tmp_path / "cache"))
    (tmp_path / "mylib_adapter.py").write_text(ADAPTER, encoding="utf-8")
    (tmp_path / "pytest.ini").write_text("[pytest]\npython_files = check_*.py\nxfail_strict = true\n", encoding="utf-8")
    (tmp_path / "xfails.txt").write_text("so3.exp[*]  # mylib#12\nso3.exp[tiny]\nso3.log[near-pi]\n", encoding="utf-8")
    words = ["--affinecert-subject", "mylib_adapter:coarse", "--affinecert-xfails", "xfails.txt", "-k", "not law"]
    command = [sys.executable, "-m", "pytest", *PYARGS, *words, "--junitxml", "results.xml"]
    shown = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert shown.returncode == 0, shown.stdout + shown.stderr
    assert "xfails.txt:2: so3.exp[tiny]: passes\n" in shown.stdout
    assert "xfails.txt:3: so3.log[near-pi]: matches no test\n" in shown.stdout
    assert "xfails.txt:1" not in shown.stdout
    cases = {case.get("name"): case for case in ElementTree.parse(tmp_path / "results.xml").iter("testcase")}
    assert list(cases) == REGIMES
    assert {name for name, case in cases.items() if case.find("skipped") is not None} == set(COARSE)


def test_there_is_a_test_a_map_and_regime_and_a_law(project: pytest.Pytester) -> None:
    laws = [f"law[{law.name}]" for law in LAWS if set(law.needs) == {"so3.exp"}]
    assert collected(project, "adapter_of_plugin:coarse") == [*REGIMES, *laws]
    assert "law[one_parameter.so3.exp]" in laws


def test_the_tests_of_several_subjects_are_told_apart(project: pytest.Pytester) -> None:
    names = collected(project, "adapter_of_plugin:coarse", "adapter_of_plugin:scales")
    assert names[0] == f"adapter_of_plugin:coarse::{REGIMES[0]}"
    assert "adapter_of_plugin:scales::law[exp_log.scale.log]" in names


def test_laws_are_no_tests_of_a_subject_in_float32(project: pytest.Pytester) -> None:
    assert all(name.startswith("scale.exp[") for name in collected(project, "adapter_of_plugin:single"))
    run(project, "--affinecert-subject", "adapter_of_plugin:single", "-k", "generic").assert_outcomes(passed=1)


def test_a_failure_tells_the_worst_input_and_how_to_see_it(project: pytest.Pytester) -> None:
    result = run(project, "--affinecert-subject", "adapter_of_plugin:coarse", "-k", "near-identity")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(
        [
            "_* so3.exp[[]near-identity] _*",
            "* degraded*",
            "the worst is *: *",
            "scaled error * u, forward * u, condition *, angle *",
            "affinecert explain so3.exp '[[][[]*' --subject adapter_of_plugin:coarse",
            "FAILED *::so3.exp[[]near-identity] - *",
        ]
    )
    assert "Traceback" not in result.stdout.str()


def test_a_broken_law_tells_the_law_and_the_input(project: pytest.Pytester) -> None:
    result = run(project, "--affinecert-subject", "adapter_of_plugin:coarse", "-k", "law and one_parameter")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["a residual of *", "*exp*: *", "up to a residual of 16, but not at [[][[]*"])


def test_a_regime_is_judged_as_certify_judges_it(project: pytest.Pytester) -> None:
    spec = "adapter_of_plugin:coarse"
    rows = {row.regime: row for row in certify(spec, maps="so3.exp", profile="quick").results}
    assert set(rows) == set(single_regime.regimes("so3.exp"))
    for regime, row in rows.items():
        assert single_regime.certify_regime(spec, "so3.exp", regime, "quick") == row


LISTED = ("--affinecert-subject", "adapter_of_plugin:coarse", "-k", "so3.exp and not law", "--affinecert-xfails")


def test_what_is_listed_is_skipped_or_may_fail(project: pytest.Pytester) -> None:
    project.makefile(".txt", xfails="# known\n" + "\n".join(COARSE), skips="so3.exp[huge-*]  # nobody does that")
    result = run(project, *LISTED, "xfails.txt", "--affinecert-skips", "skips.txt", "-rs", "--affinecert-strict")
    result.assert_outcomes(xfailed=len(COARSE), skipped=1, passed=len(REGIMES) - len(COARSE) - 1)
    assert result.ret == pytest.ExitCode.OK
    result.stdout.fnmatch_lines(["SKIPPED * nobody does that"])
    result.stdout.no_fnmatch_line("*stale*")


@pytest.mark.parametrize("strict", [False, True])
def test_stale_lines_fail_only_if_strict(project: pytest.Pytester, strict: bool) -> None:
    project.makefile(".txt", xfails="\n".join([*COARSE, "so3.exp[tiny]", "so4.*"]))
    result = run(project, *LISTED, "xfails.txt", *(["--affinecert-strict"] if strict else []))
    assert result.ret == (pytest.ExitCode.TESTS_FAILED if strict else pytest.ExitCode.OK)
    assert result.parseoutcomes()["xpassed"] == 1
    result.stdout.fnmatch_lines(
        ["*= affinecert: stale expectations =*", "xfails.txt:3: so3.exp[[]tiny]: passes", "xfails.txt:4: so4.[*]: *"]
    )


def expectations(text: str) -> Expectations:
    return Expectations(xfails=parse(text, "x"))


def test_a_pattern_is_stale_when_all_of_its_tests_pass() -> None:
    names = ["so3.log[tiny]", "so3.log[near-pi]"]
    listed = expectations("so3.log[*]")
    assert listed.stale(names, {"so3.log[tiny]"}) == ()
    assert [why for _, why in listed.stale(names, set(names))] == ["all 2 pass"]
    spared = Expectations(skips=parse("*[near-pi]", "s"), xfails=listed.xfails)
    assert [why for _, why in spared.stale(names, {"so3.log[tiny]"})] == ["passes"]


@pytest.mark.parametrize(
    ("pattern", "name", "matches"),
    [
        ("so3.log[near-pi]", "so3.log[near-pi]", True),
        ("so3.log[near-pi]", "so3.logn", False),
        ("so3.log[*-pi]", "so3.log[near-pi]", True),
        ("so3.log*", "so3.log_near[tie]", True),
        ("so3.log[*]", "so3.log_near[tie]", False),
        ("*[near-pi]", "so3.log[near-pi]", True),
        ("law[isometry.sa?]", "law[isometry.sam]", True),
        ("so3.log[near-pi]", "my:subject::so3.log[near-pi]", True),
        ("my:subject::*", "my:subject::so3.log[near-pi]", True),
        ("other:subject::*", "my:subject::so3.log[near-pi]", False),
    ],
)
def test_brackets_stand_for_themselves(pattern: str, name: str, matches: bool) -> None:
    (line,) = parse(pattern, "x")
    assert line.matches(name) is matches


def test_a_line_may_tell_its_reason() -> None:
    assert parse("# all\n\n so3.exp[tiny] # mylib#12 \n", "x") == (Expectation("so3.exp[tiny]", "mylib#12", "x:3"),)


@pytest.mark.parametrize("line", ["so3.log [near-pi]", "so3.log[near-pi", "so3.lo[gx]*", "[near-pi]", "so3.log near"])
def test_a_line_that_is_no_id_is_told(line: str) -> None:
    with pytest.raises(StoredFileError, match=r"^x:2: '.*' is no id of a test: one a line is due"):
        parse(f"so3.exp[tiny]\n{line}\n", "x")


def test_a_file_of_bytes_is_told(tmp_path: Path) -> None:
    (tmp_path / "x").write_bytes(b"\xff\xfe")
    with pytest.raises(StoredFileError, match="cannot read the list of tests"):
        read(tmp_path / "x")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((*LISTED, "nowhere.txt"), "ERROR: cannot read the list of tests nowhere.txt: *"),
        ((*LISTED, "adapter_of_plugin.py"), "ERROR: adapter_of_plugin.py:1: '*' is no id of a test: *"),
        (("--affinecert-skips", "skips.txt"), "ERROR: --affinecert-skips needs an --affinecert-subject"),
        (("--affinecert-profile", "lazy"), "*invalid choice: 'lazy' (choose from *"),
    ],
)
def test_bad_use_is_told(project: pytest.Pytester, arguments: tuple[str, ...], message: str) -> None:
    result = run(project, *arguments)
    assert result.ret == pytest.ExitCode.USAGE_ERROR
    result.stderr.fnmatch_lines([message])


@pytest.mark.parametrize(
    ("subject", "message"),
    [
        ("fsat", "no subject is named 'fsat'; did you mean fast*"),
        ("adapter_of_plugin:missing", "*is not a Subject: adapter_of_plugin has no missing"),
        ("adapter_of_plugin:nothing", "adapter_of_plugin:nothing offers no map of the catalogue"),
    ],
)
def test_a_bad_subject_is_told(project: pytest.Pytester, subject: str, message: str) -> None:
    result = run(project, "--affinecert-subject", subject)
    assert result.ret == pytest.ExitCode.INTERRUPTED
    result.stdout.fnmatch_lines([message])
    assert "Traceback" not in result.stdout.str()


def test_the_profiles_offered_are_those_there_are() -> None:
    parser = pytest.Parser(_ispytest=True)
    plugin.pytest_addoption(parser)
    assert parser.parse([]).affinecert_profile in PROFILES
    for name in PROFILES:
        assert parser.parse(["--affinecert-profile", name]).affinecert_profile == name
