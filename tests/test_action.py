"""The GitHub Action: its shell steps, run as a runner would run them, with pip left out."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from . import plain_yaml

ROOT = Path(__file__).parent.parent
ACTION: dict[str, Any] = plain_yaml.load((ROOT / "action.yml").read_text(encoding="utf-8"))
STEPS: list[dict[str, Any]] = ACTION["runs"]["steps"]

BASH = shutil.which("bash")

ADAPTER = """
import numpy as np
from affinecert import Subject

right = Subject("right", "1.0", {"scale.exp": np.exp})
wrong = Subject("wrong", "1.0", {"scale.exp": lambda x: np.exp(x) * (1 + 1e-10)})
"""

PYTHON = f"""#!{BASH}
if [ "$1 $2" = "-m pip" ]; then printf '%s\\n' "$@" > pip.txt; else exec {sys.executable} "$@"; fi
"""
COMMAND = f"""#!{BASH}
printf '%s\\n' "$@" > affinecert.txt
exec {sys.executable} -m affinecert "$@" --jobs 1
"""
FAKE = f"""#!{BASH}
printf '%s\\n' "$@" > affinecert.txt
"""


@dataclass
class Runner:
    """A folder to run the action's steps in, as far as a test needs one."""

    folder: Path
    inputs: dict[str, str]
    outputs: dict[str, dict[str, str]] = field(default_factory=dict)
    done: list[str] = field(default_factory=list)
    failed: bool = False

    def command(self, name: str, text: str) -> None:
        path = self.folder / "bin" / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
        path.chmod(0o755)

    def value(self, expression: re.Match[str]) -> str:
        kind, *names = expression[1].split(".")
        if kind == "inputs":
            return self.inputs[".".join(names)]
        step, outputs, name = names
        assert (kind, outputs) == ("steps", "outputs")
        return self.outputs[step][name]

    def run(self) -> None:
        inputs = {name: entry.get("default", "") for name, entry in ACTION["inputs"].items()} | self.inputs
        self.inputs = inputs
        for step in STEPS:
            if "run" in step and (not self.failed or "always()" in step.get("if", "")):
                self.step(step)

    def step(self, step: dict[str, Any]) -> None:
        written = self.folder / "output"
        written.write_text("", encoding="utf-8")
        words = {name: re.sub(r"\$\{\{ (\S+) \}\}", self.value, value) for name, value in step.get("env", {}).items()}
        environment = {
            **os.environ,
            **words,
            "PATH": f"{self.folder / 'bin'}{os.pathsep}{os.environ['PATH']}",
            "AFFINECERT_CACHE": str(self.folder / "cache"),
            "GITHUB_ACTION_PATH": str(ROOT),
            "GITHUB_OUTPUT": str(written),
            "GITHUB_STEP_SUMMARY": str(self.folder / "summary.md"),
            "RUNNER_OS": "Linux",
            "RUNNER_TEMP": str(self.folder / "temp"),
        }
        assert step["shell"] == "bash"
        command = [str(BASH), "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]]
        ended = subprocess.run(command, cwd=self.folder, env=environment, capture_output=True, text=True, check=False)
        self.failed |= ended.returncode != 0
        self.done.append(ended.stdout + ended.stderr)
        lines = written.read_text(encoding="utf-8").splitlines()
        self.outputs[step.get("id", "")] = dict(line.split("=", 1) for line in lines)

    def words(self, name: str) -> list[str]:
        return (self.folder / name).read_text(encoding="utf-8").splitlines()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    if BASH is None:
        pytest.skip("the action's steps are run by bash")
    (tmp_path / "adapter_of_action.py").write_text(ADAPTER, encoding="utf-8")
    return tmp_path


def runner(folder: Path, affinecert: str, **inputs: str) -> Runner:
    made = Runner(folder, inputs)
    made.command("python", PYTHON)
    made.command("affinecert", affinecert)
    made.run()
    return made


def test_findings_fail_after_the_certificate_and_the_summary_are_written(folder: Path) -> None:
    run = runner(folder, COMMAND, subject="adapter_of_action:wrong", profile="quick", maps="scale.*")
    assert run.failed
    summary = (folder / "summary.md").read_text(encoding="utf-8")
    certificates = Path(run.outputs["prepare"]["certificate"])
    # In the library's own folder, the next `pip install .` might take them for a second package.
    assert certificates.is_relative_to(folder / "temp")
    assert summary == (certificates / "certificate.md").read_text(encoding="utf-8")
    assert "degraded" in summary
    assert (folder / "cache" / "store.sqlite").exists()
    assert run.outputs["prepare"]["cache"] == str(folder / "cache")


def test_what_is_asked_for_reaches_affinecert_and_pip_in_whole_words(folder: Path) -> None:
    run = runner(
        folder,
        FAKE,
        subject="adapter_of_action:right",
        maps="so3.* $(touch injected)",
        baseline="a folder/base.json",
        install=". scipy",
    )
    assert not run.failed, run.done
    assert run.words("pip.txt") == ["-m", "pip", "install", "--disable-pip-version-check", str(ROOT), ".", "scipy"]
    assert run.words("affinecert.txt") == [
        "certify",
        "adapter_of_action:right",
        *("--map", "so3.* $(touch injected)"),
        *("--profile", "standard"),
        *("--out", str(folder / "temp" / "affinecert" / "adapter_of_action.right")),
        *("--baseline", "a folder/base.json"),
    ]
    assert not (folder / "injected").exists()
    assert not (folder / "summary.md").exists()


def test_without_a_baseline_none_is_asked_for(folder: Path) -> None:
    run = runner(folder, FAKE, subject="fast")
    assert not run.failed, run.done
    assert "--baseline" not in run.words("affinecert.txt")
    assert run.outputs["prepare"]["name"].startswith("fast-Linux-3.")


def uses(action: str) -> dict[str, str]:
    (step,) = (step for step in STEPS if step.get("uses", "").startswith(f"actions/{action}@"))
    found: dict[str, str] = step["with"]
    return found


def test_the_truths_are_restored_and_kept_whatever_the_outcome() -> None:
    assert uses("cache/restore")["path"] == uses("cache/save")["path"] == "${{ steps.prepare.outputs.cache }}"
    assert uses("cache/restore")["key"] == uses("cache/save")["key"]
    for line in uses("cache/restore")["restore-keys"].splitlines():
        assert uses("cache/save")["key"].startswith(line)
    assert uses("upload-artifact")["path"] == "${{ steps.prepare.outputs.certificate }}"
    certified = next(number for number, step in enumerate(STEPS) if step.get("id") == "certify")
    assert all("always()" in step["if"] for step in STEPS[certified + 1 :])
    assert not any("always()" in step.get("if", "") for step in STEPS[: certified + 1])


def test_inputs_reach_the_shell_through_the_environment_only() -> None:
    assert all("${{" not in step.get("run", "") for step in STEPS)
    used = set(re.findall(r"inputs\.([\w-]+)", (ROOT / "action.yml").read_text(encoding="utf-8")))
    assert used == set(ACTION["inputs"]) == {"subject", "maps", "profile", "baseline", "install", "python-version"}
    assert all(entry["description"] for entry in ACTION["inputs"].values())


@pytest.mark.parametrize("path", ["action.yml", ".github/workflows/ci.yml"])
def test_the_reader_of_these_tests_reads_what_yaml_says(path: str) -> None:
    yaml = pytest.importorskip("yaml", reason="PyYAML is not among what affinecert needs")
    text = (ROOT / path).read_text(encoding="utf-8")
    assert plain_yaml.load(text) == yaml.load(text, yaml.BaseLoader)
