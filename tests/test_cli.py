from __future__ import annotations

import json
import os
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

from affinecert import campaign, corpus, existence, hunt, reports
from affinecert.benchmarks import against
from affinecert.case import Case
from affinecert.catalogue import CATALOGUE
from affinecert.certificate import read
from affinecert.cli import main
from affinecert.errors import StoredFileError
from affinecert.tier import PROFILES

from . import certificates

ADAPTER = '''
"""Adapters for the tests of the command line."""
import numpy as np
from affinecert.subject import Subject

right = Subject("right", "1.0", {"scale.exp": np.exp})
straight = Subject(
    "straight", "1.0", {"morphs.linear": lambda b, c, t: (1 - t[:, None, None]) * b + t[:, None, None] * c}
)
wrong = Subject("wrong", "1.0", {"scale.exp": lambda x: np.exp(x) * (1 + 1e-10)})
nothing = Subject("nothing", "1.0", {})
'''


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working folder with an adapter in it, and a store of its own."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("AFFINECERT_CACHE", str(tmp_path / "cache"))
    monkeypatch.syspath_prepend(str(tmp_path))
    (tmp_path / "adapter_of_cli.py").write_text(ADAPTER, encoding="utf-8")
    return tmp_path


def run(*arguments: str) -> Result:
    result = CliRunner().invoke(main, arguments)
    # A traceback is never an answer.
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    return result


def certify(*arguments: str) -> Result:
    return run("certify", *arguments, "--profile", "quick", "--jobs", "1")


def test_help_is_quick_and_imports_nothing_heavy() -> None:
    code = (
        "import sys; from affinecert.cli import main; main(['--help'], standalone_mode=False);"
        "print(sorted({'numpy', 'numba', 'mpmath', 'rich', 'matplotlib', 'hypothesis'} & set(sys.modules)))"
    )
    shown = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True)
    assert shown.stderr == ""
    assert shown.stdout.splitlines()[-1] == "[]"
    for command in ("certify", "compare", "maps", "explain", "replay", "hunt", "bench", "sweep", "laws"):
        assert f"\n  {command} " in shown.stdout


def test_the_package_is_a_command() -> None:
    shown = subprocess.run(
        [sys.executable, "-m", "affinecert", "--version"], capture_output=True, text=True, check=True
    )
    assert shown.stdout.startswith("affinecert, version ")


def test_the_profiles_offered_are_those_there_are() -> None:
    (option,) = (parameter for parameter in main.commands["certify"].params if parameter.name == "profile")
    assert list(option.type.choices) == list(PROFILES)  # type: ignore[attr-defined]


def test_certify_passes_with_0_and_writes_three_files() -> None:
    result = certify("adapter_of_cli:right", "--map", "scale.*")
    assert result.exit_code == 0, result.output
    assert "right 1.0: passed" in result.stdout
    assert "maps not offered: scale.log" in result.stdout
    folder = Path("certificates/adapter_of_cli.right")
    assert sorted(path.name for path in folder.iterdir()) == ["certificate.html", "certificate.json", "certificate.md"]
    assert f"wrote {folder / 'certificate.json'}" in result.stdout
    assert read(folder / "certificate.json").absent == ("scale.log",)


def test_certify_fails_with_1_and_tells_how_to_see_it() -> None:
    result = certify("adapter_of_cli:wrong", "--out", "out")
    assert result.exit_code == 1
    assert "degraded  scale.exp, generic: " in result.stdout
    (command, *_) = (
        line for line in result.stdout.splitlines() if line.startswith("  affinecert explain scale.exp '[")
    )
    assert command.endswith(" --subject adapter_of_cli:wrong")
    assert run(*shlex.split(command)[1:]).stdout.count("degraded") == 1
    assert "--subject adapter_of_cli:wrong" in Path("out/certificate.html").read_text(encoding="utf-8")
    assert "--subject adapter_of_cli:wrong" in Path("out/certificate.md").read_text(encoding="utf-8")
    replayed = run("replay", "out/certificate.json", "--subject", "adapter_of_cli:wrong")
    assert replayed.exit_code == 1
    assert run("replay", "out/certificate.json", "--subject", "adapter_of_cli:right").exit_code == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("certify", "fsat"), "Error: no subject is named 'fsat'; did you mean fast"),
        (
            ("certify", "nowhere:subject"),
            "Error: cannot import the subject 'nowhere:subject': No module named 'nowhere'",
        ),
        (("certify", "adapter_of_cli:missing"), "is not a Subject: adapter_of_cli has no missing"),
        (("certify", "adapter_of_cli:np"), "is not a Subject: adapter_of_cli has np is a module"),
        (("certify", "adapter_of_cli:nothing", "--jobs", "1"), "nothing offers no map that matches '*'"),
        (("certify", "adapter_of_cli:right", "--map", "so4.*"), "Error: no map is named 'so4.*'; did you mean so3."),
        (("certify", "--out", "adapter_of_cli.py"), "'adapter_of_cli.py' is a file"),
        (
            ("certify", "--out", "adapter_of_cli.py/folder"),
            "Error: cannot write adapter_of_cli.py/folder: Not a directory",
        ),
        (("certify", "--profile", "lazy"), "'lazy' is not one of 'quick', 'standard', 'thorough'"),
        (("certify", "--jobs", "0"), "0 is not in the range x>=1"),
        (("certify", "--jobs", "many"), "'many' is not a valid int"),
        (("certify", "--limit", "0"), "0.0 is not in the range x>0"),
        (("explain", "so3.lgo", "[0, 0, 0]"), "Error: no map is named 'so3.lgo'; did you mean so3.log"),
        (("explain", "so3.exp", "[0, 0"), "Error: INPUT: not JSON: "),
        (("explain", "so3.exp", "[0, 0]"), "Error: omega: shape (2,) where (3,) is due"),
        (("explain", "so3.exp", "[0, 0, 0]", "--subject", "nmupy"), "Error: no subject is named 'nmupy'"),
        (("explain", "so3.exp"), "Missing argument 'INPUT'"),
        (("replay", "nowhere.jsonl"), "Error: cannot read the corpus file nowhere.jsonl"),
        (("replay", "nowhere.json"), "Error: cannot read the certificate nowhere.json"),
        (("replay", "adapter_of_cli.py"), "Error: adapter_of_cli.py:2: not JSON"),
        (("hunt", "fsat"), "Error: no subject is named 'fsat'"),
        (("hunt", "--budget", "-1"), "-1.0 is not in the range x>0"),
        (("hunt", "--out", "adapter_of_cli.py/folder"), "Error: cannot write adapter_of_cli.py/folder"),
        (("bench",), "Missing option '--against'"),
        (("sweep", "--count", "0"), "0 is not in the range x>=1"),
        (("laws", "fsat"), "Error: no subject is named 'fsat'"),
        (("laws", "--morph", "linaer"), "Error: no morph is named 'linaer'; did you mean linear"),
        (("laws", "--law", "stready"), "Error: no law of morphs is named 'stready'; did you mean steady"),
        (("prove",), "No such command 'prove'"),
    ],
)
def test_bad_use_is_told_in_one_line_with_2(arguments: tuple[str, ...], message: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert message in result.stderr
    assert result.stdout == ""
    assert not Path("certificates").exists()
    assert len([line for line in result.stderr.splitlines() if line.startswith("Error: ")]) == 1


def test_a_corrupt_certificate_or_corpus_is_told_with_2() -> None:
    Path("certificate.json").write_text('{"format": 7}', encoding="utf-8")
    result = run("replay", "certificate.json")
    assert result.exit_code == 2
    assert "Error: certificate.json: not a certificate of format 2" in result.stderr
    Path("cases.jsonl").write_text('{"map": "so3.exp"}\n', encoding="utf-8")
    result = run("replay", "cases.jsonl")
    assert result.exit_code == 2
    assert "Error: cases.jsonl:1: not a case: " in result.stderr


def test_a_corrupt_store_is_told_with_2(tmp_path: Path) -> None:
    (tmp_path / "cache").mkdir()
    (tmp_path / "cache" / "store.sqlite").write_text("this is no database, however long one reads it", encoding="utf-8")
    result = certify("adapter_of_cli:right", "--map", "scale.exp")
    assert result.exit_code == 2
    assert "store.sqlite cannot be used: file is not a database; delete it to start afresh" in result.stderr


def test_the_folder_is_tried_before_the_work_begins(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*arguments: object, **options: object) -> None:
        pytest.fail("the work began")

    monkeypatch.setattr(campaign, "certify", never)
    assert certify("--out", "adapter_of_cli.py/folder").exit_code == 2


def test_a_disk_that_fills_up_is_told_with_2(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*arguments: object) -> None:
        raise StoredFileError("cannot write out/certificate.json: No space left on device")

    monkeypatch.setattr(campaign, "certify", lambda *arguments, **options: certificates.passing())
    monkeypatch.setattr(reports, "write", full)
    result = certify("--out", "out")
    assert result.exit_code == 2
    # What was found out is told all the same.
    assert "fast 1.2.3: passed" in result.stdout
    assert "Error: cannot write out/certificate.json: No space left on device" in result.stderr


def test_ctrl_c_says_what_is_kept_and_exits_with_130(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*arguments: object, **options: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(campaign, "certify", interrupted)
    result = certify("adapter_of_cli:right")
    assert result.exit_code == 130
    assert "stopped: finished cases are kept; the same command, without --fresh, goes on from them" in result.stderr
    monkeypatch.setattr(hunt, "hunt", interrupted)
    result = run("hunt", "adapter_of_cli:right")
    assert result.exit_code == 130
    assert "stopped: the trail is kept; the same command goes on from it" in result.stderr
    monkeypatch.setattr(existence, "sweep", interrupted)
    result = run("sweep")
    assert result.exit_code == 130
    assert result.stderr.splitlines()[-1] == "stopped"


# As ``python -m affinecert``, but for what a shell hands on to what it runs in the background: that Ctrl-C is ignored.
HEEDING = """
import runpy, signal
signal.signal(signal.SIGINT, signal.default_int_handler)
runpy.run_module("affinecert", run_name="__main__", alter_sys=True)
"""


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize("jobs", ["1", "2"])
def test_a_real_ctrl_c_ends_a_run_at_once(jobs: str, tmp_path: Path) -> None:
    command = [sys.executable, "-c", HEEDING, "certify", "reference", "--map", "sam.*", "--jobs", jobs]
    store = tmp_path / "cache" / "store.sqlite"
    deadline = time.monotonic() + 60
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, process_group=0
    ) as process:
        while not store.exists() and time.monotonic() < deadline:
            time.sleep(0.1)
        time.sleep(1)
        os.killpg(process.pid, signal.SIGINT)
        try:
            stdout, stderr = process.communicate(timeout=10)
        except subprocess.TimeoutExpired:
            # Python drops an interrupt that comes while a callback of its own runs; whoever sees that presses again.
            os.killpg(process.pid, signal.SIGINT)
            stdout, stderr = process.communicate(timeout=20)
    assert process.returncode == 130
    assert stdout == ""
    assert stderr.splitlines()[-1].startswith("stopped: finished cases are kept")
    assert "Traceback" not in stderr


def test_maps_lists_the_catalogue() -> None:
    result = run("maps")
    assert result.exit_code == 0
    assert max(map(len, result.stdout.splitlines())) <= 100
    listed = json.loads(run("maps", "--json").stdout)
    assert [entry["name"] for entry in listed] == list(CATALOGUE)
    for entry in CATALOGUE.values():
        assert f"{entry.name}(" in result.stdout
        assert all(regime.name in result.stdout for regime in entry.regimes)


def test_explain_asks_fast_and_the_others() -> None:
    result = run("explain", "scale.exp", "0.5", "--subject", "adapter_of_cli:wrong", "--subject", "fast")
    assert result.exit_code == 0, result.output
    assert "1.64872127070012814684865078781" in result.stdout
    verdicts = {line.split()[0]: line.split()[-1] for line in result.stdout.splitlines() if " 0.50 " in line}
    assert verdicts == {"fast": "ok", "wrong": "degraded"}


def test_replay_of_a_corpus_gives_1_for_findings() -> None:
    corpus.append(Path("cases.jsonl"), [Case("scale.exp", "generic", (np.array(0.5),), 0.5, "by hand")])
    result = run("replay", "cases.jsonl", "--subject", "adapter_of_cli:wrong")
    assert result.exit_code == 1
    assert "1 finding in 1 case" in result.stdout
    result = run("replay", "cases.jsonl")
    assert result.exit_code == 0
    assert "no finding in 1 case" in result.stdout


def test_hunt_tells_its_catch() -> None:
    result = run("hunt", "adapter_of_cli:wrong", "--evaluations", "20", "--out", "catches")
    assert result.exit_code == 1, result.output
    assert "degraded  scale.exp, " in result.stdout
    assert "--subject adapter_of_cli:wrong" in result.stdout
    (caught,) = Path("catches").glob("*.jsonl")
    assert run("replay", str(caught), "--subject", "adapter_of_cli:wrong").exit_code == 1


def test_sweep_tells_the_outcome(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = existence.Sweep(20, 7, (((1.0, 2.0), (3.0, 4.5)),))
    monkeypatch.setattr(existence, "sweep", lambda *arguments: wrong)
    result = run("sweep", "--count", "20")
    assert result.exit_code == 1
    assert "20 matrices, of which 7 have a real logarithm: 1 decided wrongly" in result.stdout
    assert '[["0x1.0000000000000p+0", "0x1.0000000000000p+1"]' in result.stdout
    monkeypatch.setattr(existence, "sweep", lambda *arguments: existence.Sweep(20, 7, ()))
    assert run("sweep", "--count", "20").exit_code == 0


def test_laws_are_told_as_a_matrix_in_full_and_for_other_programs() -> None:
    asked = ("laws", "adapter_of_cli:straight", "--jobs", "1", "--law", "[sv]*")
    table = run(*asked, "--morph", "lin*")
    assert table.exit_code == 0
    assert "linear  steady: fails; on " in table.stdout
    assert "B = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]" in table.stdout
    two = run(*asked, "--morph", "[al]*")
    assert two.exit_code == 0
    lines = [line.split() for line in two.stdout.splitlines()]
    assert ["linear", "no", "no", "no", "plane"] in lines
    assert ["arap", "·", "·", "·", "·"] in lines
    records = json.loads(run(*asked, "--json").stdout)
    assert {record["verdict"] for record in records if record["morph"] == "linear"} == {"fails", "partly"}
    assert "| linear | no | no | no | plane |" in run(*asked, "--markdown").stdout


def test_bench_tells_the_comparison(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = (
        against.Row("so3.exp", 1, None, None, 1.5, 1e-4, "slower"),
        against.Row("so3.log", 10_000, None, None, None, None, "new"),
    )
    slower = against.Comparison("HEAD (abc)", "working tree", certificates.MACHINE, False, "a note", rows)
    monkeypatch.setattr(against, "compare", lambda *arguments, **options: slower)
    result = run("bench", "--against", "HEAD")
    assert result.exit_code == 1
    assert "a note" in result.stdout
    assert "slower" in result.stdout
    same = against.Comparison("HEAD (abc)", "working tree", certificates.MACHINE, False, "", rows[1:])
    monkeypatch.setattr(against, "compare", lambda *arguments, **options: same)
    assert run("bench", "--against", "HEAD").exit_code == 0


def test_a_screen_that_knows_ascii_only_gets_escapes() -> None:
    environment = os.environ | {"PYTHONIOENCODING": "ascii", "TERM": "dumb"}
    command = [sys.executable, "-m", "affinecert", "certify", "adapter_of_cli:right", "--map", "scale.exp"]
    shown = subprocess.run(
        [*command, "--profile", "quick", "--jobs", "1"], env=environment, capture_output=True, text=True, check=False
    )
    assert shown.returncode == 0, shown.stderr
    assert shown.stdout.isascii()
    assert "Traceback" not in shown.stderr
