"""Two builds of the project side by side, each in a process of its own."""

from __future__ import annotations

import io
import json
import os
import shutil
import subprocess
import sys
import tarfile
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from affinecert.benchmarks import worker
from affinecert.errors import AffinecertError
from affinecert.map import Array


class BuildError(AffinecertError):
    """A revision cannot be found, laid out or run."""


def git(root: Path, *arguments: str) -> bytes:
    """What a git command prints; BuildError with its complaint if it fails."""
    try:
        done = subprocess.run(["git", "-C", str(root), *arguments], capture_output=True, check=False)
    except OSError as error:
        raise BuildError(f"cannot run git: {error}") from error
    if done.returncode:
        raise BuildError(done.stderr.decode(errors="replace").strip() or f"git {arguments[0]} failed")
    return done.stdout


def top(folder: Path) -> Path:
    """The checkout of affinecert that holds a folder; BuildError if there is none."""
    root = Path(git(folder, "rev-parse", "--show-toplevel").decode().strip())
    project = root / "pyproject.toml"
    if not project.is_file() or packages(root).get("affinecert") is None:
        raise BuildError(f"{root} is not a checkout of affinecert: run this inside one to compare revisions")
    return root


def commit(root: Path, revision: str) -> str:
    """The commit that a revision names; BuildError if there is none."""
    try:
        return (
            git(root, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}").decode().strip()
        )
    except BuildError as error:
        raise BuildError(
            f"no revision is named {revision!r} in {root}; a baseline file's name ends in .json"
        ) from error


def export(root: Path, revision: str, target: Path) -> Path:
    """The files of a revision, written below ``target``."""
    with tarfile.open(fileobj=io.BytesIO(git(root, "archive", "--format=tar", revision))) as archive:
        # Pythons before 3.11.4 have no filters, and need none for what Git itself packs.
        archive.extraction_filter = getattr(tarfile, "data_filter", None)
        archive.extractall(target)
    return target


def packages(tree: Path) -> dict[str, str]:
    """The import packages of a source tree and their folders, as its pyproject.toml says."""
    try:
        project = tomllib.loads((tree / "pyproject.toml").read_text(encoding="utf-8"))
        found: dict[str, str] = project["tool"]["setuptools"]["package-dir"]
    except (OSError, ValueError, KeyError) as error:
        raise BuildError(f"{tree} is not a source tree of affinecert: {type(error).__name__}: {error}") from error
    return found


def lay_out(tree: Path, target: Path) -> Path:
    """The packages of a source tree, copied to where an installation would put them; compiled leftovers stay behind."""
    for package, folder in sorted(packages(tree).items()):
        place = target.joinpath(*package.split("."))
        leftovers = shutil.ignore_patterns("__pycache__")
        try:
            shutil.copytree(tree / folder, place, ignore=leftovers, dirs_exist_ok=True)
        except OSError as error:
            raise BuildError(f"cannot lay out {tree / folder}: {error}") from error
    return target


class Build:
    """A running build: ``path`` is where its packages lie, None for the one that is installed here."""

    def __init__(self, name: str, path: Path | None, scratch: Path) -> None:
        self.name = name
        self._path = path
        self._outputs = scratch / f"{name}.npz"
        self._complaints = scratch / f"{name}.log"
        environment = dict(os.environ) if path is None else {**os.environ, "PYTHONPATH": str(path)}
        # -P: the folder of the script holds modules of this build, not of the one under test.
        command = [sys.executable, "-P", str(worker.__file__)]
        with self._complaints.open("w", encoding="utf-8") as complaints:
            self._process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=complaints,
                text=True,
                env=environment,
                cwd=scratch,
            )

    def ready(self) -> None:
        """Waits until the package is imported, and makes sure that it is this build's."""
        package = Path(self._receive()["package"])
        if self._path is not None and not package.is_relative_to(self._path):
            raise BuildError(f"{self.name} imports {package}, not what lies in {self._path}")

    def _send(self, request: dict[str, Any]) -> None:
        assert self._process.stdin is not None
        try:
            print(json.dumps(request), file=self._process.stdin, flush=True)
        except OSError as error:
            raise self._lost() from error

    def _receive(self) -> dict[str, Any]:
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        if not line:
            raise self._lost()
        answer: dict[str, Any] = json.loads(line)
        return answer

    def _lost(self) -> BuildError:
        status = self._process.wait()
        complaints = self._complaints.read_text(encoding="utf-8").strip().splitlines()
        return BuildError(f"{self.name} died with status {status}: {complaints[-1] if complaints else 'no complaint'}")

    def start(self, name: str, inputs: Path) -> None:
        """Has the outputs of a map computed; `finish` waits for them, and so several builds compile at once."""
        self._send({"map": name, "inputs": str(inputs), "outputs": str(self._outputs)})

    def finish(self) -> tuple[Array, ...] | None:
        """The outputs asked for last; None if this build has none."""
        if "absent" in self._receive():
            return None
        return tuple(worker.load_inputs(str(self._outputs)))

    def seconds(self, name: str, inputs: Path, calls: int) -> float:
        """The seconds of that many calls."""
        self._send({"map": name, "inputs": str(inputs), "calls": calls})
        return float(self._receive()["seconds"])

    def yardstick(self, calls: int) -> float:
        """The seconds of that many calls of a computation that is the same in every build."""
        self._send({"yardstick": calls})
        return float(self._receive()["seconds"])

    def close(self) -> None:
        """Ends the process."""
        self._process.kill()
        self._process.communicate()


def save_inputs(path: Path, inputs: Sequence[Array]) -> Path:
    """Writes a batch to a file for the builds to read."""
    np.savez(path, *inputs)
    return path


@contextmanager
def running(paths: Mapping[str, Path | None], scratch: Path) -> Iterator[list[Build]]:
    """Builds by name, started together and ended together."""
    builds: list[Build] = []
    try:
        builds.extend(Build(name, path, scratch) for name, path in paths.items())
        for build in builds:
            build.ready()
        yield builds
    finally:
        for build in builds:
            build.close()
