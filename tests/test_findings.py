"""The findings in reports/findings hold: every snippet there prints what the text below it quotes."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[1] / "reports" / "findings"
BLOCK = re.compile(r"^```(python|cpp)\n(.*?)^```\n(?:\s*^```text\n(.*?)^```)?", re.MULTILINE | re.DOTALL)

EIGEN = [f"-I{place}" for place in ("/usr/include/eigen3", "/usr/local/include/eigen3") if Path(place).is_dir()]
"""Where else headers are: g++ looks in the folders of CPLUS_INCLUDE_PATH as well, for those of Sophus, say."""

# Runs the snippets of one file, each in a namespace of its own; what one printed before it raised is told too.
RUNNER = """
import contextlib, io, json, sys, traceback, warnings
warnings.simplefilter("ignore")
printed = []
for snippet in json.load(sys.stdin):
    with contextlib.redirect_stdout(io.StringIO()) as output:
        try:
            exec(compile(snippet, "snippet", "exec"), {"__name__": "snippet"})
        except BaseException:
            print(traceback.format_exc())
    printed.append(output.getvalue())
json.dump(printed, sys.stdout)
"""


@dataclass(frozen=True)
class Snippet:
    """One fenced block of Python or C++, and what the text below it says that it prints."""

    file: str
    number: int
    language: str
    code: str
    quoted: str


def snippets() -> list[Snippet]:
    found = []
    for path in sorted(FOLDER.glob("*.md")):
        blocks = BLOCK.findall(path.read_text(encoding="utf-8"))
        found += [Snippet(path.name, k, *block) for k, block in enumerate(blocks, 1)]
    return found


def missing(snippet: Snippet) -> set[str]:
    """The packages or headers that a snippet asks for and nobody has installed; or the compiler."""
    if snippet.language == "cpp":
        if shutil.which("g++") is None:
            return {"g++"}
        return {header for header in re.findall("#include <(.*)>", snippet.code) if not preprocessed(header)}
    names = set()
    for node in ast.walk(ast.parse(snippet.code)):
        if isinstance(node, ast.Import):
            names |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add((node.module or "").partition(".")[0])
    return {name for name in names if find_spec(name) is None}


def preprocessed(header: str) -> bool:
    """Whether g++ finds a header."""
    command = ["g++", *EIGEN, "-E", "-x", "c++", "-", "-o", os.devnull]
    asked = f"#if !__has_include(<{header}>)\n#error\n#endif"
    return subprocess.run(command, input=asked, text=True, capture_output=True, check=False).returncode == 0


def compiled(snippet: Snippet, folder: Path) -> str:
    """What a snippet in C++ prints; products and sums are not fused, as they are not in what is quoted."""
    source, program = folder / "snippet.cpp", folder / "snippet"
    source.write_text(snippet.code, encoding="utf-8")
    subprocess.run(["g++", "-O0", "-std=c++17", "-ffp-contract=off", *EIGEN, source, "-o", program], check=True)
    return subprocess.run(program, capture_output=True, text=True, check=True).stdout


@cache
def printed(file: str) -> dict[int, str]:
    """What the snippets of one file print, by their numbers, run in one process of their own."""
    here = [snippet for snippet in snippets() if snippet.file == file and not missing(snippet)]
    done = subprocess.run(
        [sys.executable, "-c", RUNNER],
        input=json.dumps([snippet.code for snippet in here]),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    # A library may print while it is imported, outside of the snippets' own output.
    outputs = json.loads(done.stdout.splitlines()[-1])
    return {snippet.number: output for snippet, output in zip(here, outputs, strict=True)}


def test_there_are_findings() -> None:
    assert snippets()


@pytest.mark.parametrize("snippet", snippets(), ids=lambda snippet: f"{Path(snippet.file).stem}-{snippet.number}")
def test_a_snippet_prints_what_is_quoted(snippet: Snippet, tmp_path: Path) -> None:
    assert snippet.quoted, f"{snippet.file}: no ```text block follows snippet {snippet.number}"
    absent = missing(snippet)
    if absent:
        pytest.skip(f"not installed: {', '.join(sorted(absent))}")
    told = compiled(snippet, tmp_path) if snippet.language == "cpp" else printed(snippet.file)[snippet.number]
    assert told.strip() == snippet.quoted.strip()


def test_the_index_tells_every_finding() -> None:
    index = (FOLDER / "README.md").read_text(encoding="utf-8")
    files = sorted(path for path in FOLDER.glob("*.md") if path.name != "README.md")
    acquitted = ("Not counted", "Acquitted", "Looked at", "Degraded")
    found = 0
    for path in files:
        assert f"]({path.name})" in index
        heads = re.findall(r"^## (?:\d+\. )?(.*)$", path.read_text(encoding="utf-8"), re.MULTILINE)
        defects = [head for head in heads if not head.startswith(acquitted)]
        assert [head for head in defects if head not in index] == []
        found += len(defects)
    told = f"{found} defects in released versions of {len(files)} libraries"
    assert told in index
    assert told in (FOLDER.parents[1] / "README.md").read_text(encoding="utf-8")
