"""What `affinecert init` writes: an adapter that works as soon as a line is uncommented, and a workflow."""

from __future__ import annotations

import ast
import re
import runpy
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

from affinecert.campaign import certify
from affinecert.catalogue import CATALOGUE
from affinecert.cli import main
from affinecert.errors import InputError, StoredFileError
from affinecert.reports.adoption import WIDTH, adopt, rendered

from . import plain_yaml

MYLIB = '''
"""Some library: two maps of a single item each."""
import numpy as np

def scale_exp(log_scale):
    return np.exp(log_scale)

def affine_lie_decompose(affine):
    return affine, np.eye(3), np.float64(1)
'''


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working folder with a library in it, and a store of its own."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("AFFINECERT_CACHE", str(tmp_path / "cache"))
    monkeypatch.syspath_prepend(str(tmp_path))
    (tmp_path / "library_to_adopt.py").write_text(MYLIB, encoding="utf-8")
    return tmp_path


def run(*arguments: str) -> Result:
    result = CliRunner().invoke(main, arguments)
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    return result


def uncommented(text: str, *names: str) -> str:
    for name in names:
        (lines,) = re.findall(rf'^        # "{name}": each\((?:.*?)\),$\n', text, re.MULTILINE | re.DOTALL)
        text = text.replace(lines, re.sub("^ *# ", "        ", lines, flags=re.MULTILINE))
    return text


def test_the_adapter_works_as_soon_as_a_line_is_uncommented() -> None:
    told = run("init", "library_to_adopt")
    assert told.exit_code == 0
    adapter = Path("affinecert_library_to_adopt.py")
    assert f"wrote {adapter}: uncomment the maps" in told.stdout
    adapter.write_text(uncommented(adapter.read_text(encoding="utf-8"), "scale.exp"), encoding="utf-8")
    assert "then: affinecert certify affinecert_library_to_adopt:subject\n" in told.stdout
    certificate = certify("affinecert_library_to_adopt:subject", profile="quick")
    assert certificate.subject == "library_to_adopt"
    assert {result.map for result in certificate.results} == {"scale.exp"}
    assert certificate.passed


def test_every_map_of_the_catalogue_waits_there() -> None:
    (adapter,) = (text for path, text in rendered("library_to_adopt").items() if path.suffix == ".py")
    tree = ast.parse(uncommented(adapter, *CATALOGUE))
    (maps,) = (
        word.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        for word in node.keywords
        if word.arg == "maps"
    )
    assert isinstance(maps, ast.Dict)
    assert [ast.literal_eval(key) for key in maps.keys if key] == list(CATALOGUE)
    for entry, value in zip(CATALOGUE.values(), maps.values, strict=True):
        assert isinstance(value, ast.Call)
        (function,) = value.args
        assert isinstance(function, ast.Lambda)
        assert [argument.arg for argument in function.args.args] == [argument.name for argument in entry.arguments]
    assert "#   twist (6,) -> (4, 4)\n" in adapter
    assert "#   affine (n, n), t () -> (n, n)\n" in adapter
    assert "#   linear (d, d) -> (d, d), (d, d)\n" in adapter


@pytest.mark.parametrize("library", ["mylib", "a_library_of_a_rather_long_name"])
def test_no_line_is_too_long(library: str) -> None:
    (adapter, *_) = rendered(library).values()
    assert [line for line in adapter.splitlines() if len(line) > WIDTH] == []


def test_nothing_is_offered_before_a_line_is_uncommented() -> None:
    assert run("init", "numpy").exit_code == 0
    assert runpy.run_path("affinecert_numpy.py")["subject"].maps == {}
    certified = run("certify", "affinecert_numpy:subject")
    assert certified.exit_code == 2
    assert "offers no map" in certified.output


def test_functions_of_single_items_are_asked_one_by_one() -> None:
    (adapter, *_) = rendered("library_to_adopt").values()
    path = Path("filled_in.py")
    path.write_text(uncommented(adapter, "scale.exp", "affine_lie.decompose"), encoding="utf-8")
    maps = runpy.run_path(str(path))["subject"].maps
    assert maps["scale.exp"](np.zeros(3)).tolist() == [1.0, 1.0, 1.0]
    shapes = [output.shape for output in maps["affine_lie.decompose"](np.zeros((2, 4, 4)))]
    assert shapes == [(2, 4, 4), (2, 3, 3), (2,)]


ACTION = Path(__file__).parent.parent / "action.yml"


def test_the_workflow_asks_the_action_for_what_it_takes() -> None:
    (text,) = (text for path, text in rendered("mylib").items() if path.suffix == ".yml")
    (job,) = plain_yaml.load(text)["jobs"].values()
    (step,) = (step for step in job["steps"] if "affinecert" in step["uses"])
    assert step["with"] == {"subject": "affinecert_mylib:subject", "install": "."}
    inputs = plain_yaml.load(ACTION.read_text(encoding="utf-8"))["inputs"]
    offered = {line.split("#")[1].split(":")[0].strip() for line in text.splitlines() if line.strip().startswith("# ")}
    assert {"maps", "profile", "baseline"} < offered
    assert set(step["with"]) | {"maps", "profile", "baseline"} <= set(inputs)


@pytest.mark.parametrize("there", ["affinecert_mylib.py", ".github/workflows/affinecert.yml"])
def test_nothing_is_overwritten(there: str, tmp_path: Path) -> None:
    path = tmp_path / there
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("mine", encoding="utf-8")
    with pytest.raises(StoredFileError, match="is there already; it is not overwritten, and nothing is written"):
        adopt("mylib", tmp_path)
    assert path.read_text(encoding="utf-8") == "mine"
    assert len([file for file in tmp_path.rglob("*affinecert*") if file.is_file()]) == 1


@pytest.mark.parametrize(
    ("name", "hint"),
    [("my-lib", "; my_lib could be one"), ("my.lib", "; my_lib could be one"), ("class", ""), ("2d", ""), ("", "")],
)
def test_a_name_that_cannot_be_imported_is_told(name: str, hint: str) -> None:
    with pytest.raises(InputError) as told:
        rendered(name)
    assert str(told.value) == f"MYLIB: {name!r} is no name that Python can import{hint}"
    assert run("init", name).exit_code == 2
    assert not Path(".github").exists()
