"""Certificates side by side: what stands in the table, and how it is told."""

from __future__ import annotations

import io
import json
import math
import re
import shlex
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from matplotlib.transforms import Bbox
from rich.console import Console

from affinecert import reports
from affinecert.case import to_hex
from affinecert.certificate import Certificate, Timing, parse
from affinecert.cli import main
from affinecert.compare import Comparison, compare
from affinecert.errors import StoredFileError
from affinecert.reports import compare as told
from affinecert.reports import speed, view
from affinecert.scoring import Verdict
from affinecert.snippet import fill
from affinecert.subject import Subject

from . import certificates
from .test_reports import Page

SNIPPET = "import numpy as np\nfrom mylib import log\nprint(f'{log(np.array({input0}))}')"


def library(name: str, scaled: float, verdict: Verdict = Verdict.OK, map_: str = "so3.log") -> Certificate:
    case = certificates.case_result(map_=map_, verdict=verdict, scaled=scaled)
    return certificates.certificate((certificates.regime_result(map_, "near-pi", [case]),), subject=name)


def shown() -> Comparison:
    """Sound and broken libraries, with hostile texts, a float32 one, and one that lacks a map."""
    failing = replace(certificates.failing(), snippets={"so3.log": SNIPPET, "sam.power": certificates.HOSTILE})
    single = replace(library("jaxlie32", 3.0), dtype="float32")
    return compare([certificates.passing(), failing, single, library(certificates.HOSTILE, 2.0)])


def test_rows_are_in_the_catalogue_s_order_and_cells_in_that_of_the_libraries() -> None:
    both = replace(
        library("one", 1.0),
        results=(*library("", 1.0, map_="sam.power").results, *library("", 2.0).results, *library("", 3.0).results),
    )
    found = compare([both, library("two", 5.0, Verdict.OK, "so3.exp")])
    assert [(row.map, row.regime) for row in found.rows] == [
        ("so3.exp", "near-pi"),
        ("so3.log", "near-pi"),
        ("sam.power", "near-pi"),
    ]
    assert [[cell and cell.worst.scaled for cell in row.cells] for row in found.rows] == [
        [None, 5.0],
        [3.0, None],
        [1.0, None],
    ]
    assert [each.libraries[0].name for each in told.maps(found)] == ["two", "one", "one"]
    assert [row.map for row in compare([both], ["so3.log"]).rows] == ["so3.log"]


def test_libraries_have_labels_of_their_own() -> None:
    same = library("one", 1.0)
    assert [each.label for each in compare([same, same, library("two", 1.0)]).libraries] == [
        "one 1.2.3",
        "one 1.2.3 (2)",
        "two 1.2.3",
    ]


def test_speeds_are_those_of_one_machine() -> None:
    here = library("one", 1.0)
    newer = replace(here, machine=replace(here.machine, python="3.13.0", packages={"numpy": "1.26.0"}))
    (found,) = compare([here, newer]).speeds
    assert [point.nanoseconds for point in found.points] == [51.25, 51.25]
    elsewhere = replace(here, machine=replace(here.machine, processor="Another processor"))
    apart = compare([here, elsewhere])
    assert apart.speeds == ()
    assert any("different machines" in note for note in apart.notes)
    assert "<svg" not in told.html(apart)
    assert "ns an item" not in told.markdown(apart)


def test_a_point_is_the_worst_over_all_regimes_other_branches_aside() -> None:
    cases = [
        certificates.case_result(scaled=1e15, verdict=Verdict.OTHER_BRANCH),
        certificates.case_result(scaled=2.5),
    ]
    result = certificates.regime_result("so3.log", "near-pi", cases)
    (found,) = compare([certificates.certificate((result,))]).speeds
    assert (found.points[0].scaled, found.points[0].verdict) == (2.5, "other-branch")


def test_notes_tell_what_keeps_numbers_apart() -> None:
    one = library("one", 1.0)
    assert compare([one, one]).notes == ()
    found = compare([one, replace(one, profile="thorough"), replace(one, affinecert="0.2.0", dtype="float32")])
    profiles, versions, units = sorted(found.notes, key=lambda note: ("u" not in note, note.count("2^"), note))
    assert "one 1.2.3 (2) thorough" in profiles + versions
    assert "one 1.2.3 (3) 0.2.0" in profiles + versions
    assert units == "Errors are in units of 2^-53; those of one 1.2.3 (3), in float32, in units of 2^-24."


def test_a_snippet_has_the_very_inputs_in_it() -> None:
    generator = np.random.default_rng(5)
    matrix = generator.standard_normal((3, 3)) * 10.0 ** generator.integers(-300, 300, (3, 3))
    inputs = [to_hex(matrix), to_hex(np.array(5e-324))]
    given: dict[str, Any] = {"np": np}
    exec(fill("a = np.array({input0})\nb = {input1}\nc = f'{b}{{}}'", inputs, "here"), given)
    assert given["a"].tobytes() == matrix.tobytes()
    assert (given["b"], given["c"]) == (5e-324, "5e-324{}")
    with pytest.raises(StoredFileError, match=r"here: the snippet asks for \{input2\}, of 2 inputs"):
        fill("{input2}", inputs, "here")


def test_a_certificate_keeps_the_subject_s_snippets_and_may_do_without() -> None:
    subject = Subject("mylib", "1", {}, snippets={"so3.log": SNIPPET})
    certificate = replace(certificates.passing(), snippets=subject.snippets)
    record = json.loads(reports.to_json(certificate))
    assert parse(record, "certificate.json").snippets == {"so3.log": SNIPPET}
    del record["snippets"]
    assert parse(record, "certificate.json").snippets == {}


def test_html_is_whole_stands_alone_and_leads_to_every_input() -> None:
    found = shown()
    text = told.html(found)
    page = Page(text)
    assert page.open == []
    assert page.loads == []
    assert not {"img", "link"} & set(page.tags)
    assert "http:" not in text
    assert "https:" not in text
    assert len(page.ids) == len(set(page.ids))
    assert {link[1:] for link in page.links} <= set(page.ids)
    assert page.tags.count("svg") == len(found.speeds) == 2
    assert not re.search(r"(fill|stroke): ?#[0-9a-f]{6}", text)
    texts = set(map(str.strip, page.text))
    for row in found.rows:
        for cell in filter(None, row.cells):
            assert told.reproduce(cell) in texts
            assert view.hexadecimal(cell.worst.case["inputs"]) in texts
            assert cell.snippet.strip() in texts
    assert "print(f'{log(np.array([[" in text.replace("&#39;", "'")


def test_markdown_lets_no_text_out_of_its_cell_and_tells_every_finding() -> None:
    found = shown()
    text = told.markdown(found)
    outside = re.sub(r"^(```+).*?^\1$", "", text, flags=re.DOTALL | re.MULTILINE)
    outside = re.sub(r"(?<!`)(`+)(?!`).*?(?<!`)\1(?!`)", "", outside)
    assert "<img" not in outside
    for table in re.findall(r"(?:^\|.*\n)+", outside, flags=re.MULTILINE):
        assert len({len(re.findall(r"(?<!\\)\|", row)) for row in table.splitlines()}) == 1
    told_of = text.count("\naffinecert explain ")
    findings = [cell for row in found.rows for cell in row.cells if cell and cell.findings]
    assert told_of == len(findings) == 2
    assert all(f"\n{told.reproduce(cell)}\n" in text for cell in findings)
    for link in re.findall(r"\]\(#([^)]*)\)", text):
        assert f'<a id="{link}">' in text


def test_the_terminal_s_table_comes_in_parts_that_fit() -> None:
    found = compare([library(f"library_{number}", 10.0**number) for number in range(9)])
    for width in (60, 100, 200):
        stream = io.StringIO()
        told.show(found, Console(file=stream, width=width, highlight=False, markup=False))
        lines = stream.getvalue().splitlines()
        assert max(map(len, lines)) <= width
        heads = [
            word for line in lines if ":" not in line for word in line.split() if re.fullmatch(r"library_\d", word)
        ]
        assert heads == [f"library_{number}" for number in range(9)]
        assert sum(line.count("51.2") for line in lines) == 9
        assert "".join(lines).count("●") == 10
    told.show(shown(), Console(file=io.StringIO(), width=100))
    told.show(compare([certificates.certificate(())]), Console(file=io.StringIO(), width=100))


def test_labels_of_a_plot_stand_apart_inside_it() -> None:
    places = [(60.0 + number % 3, 100.0 + number % 2) for number in range(14)]
    labels = speed._labels(places, [f"library {number} 1.2.3" for number in range(14)])
    left, bottom, right, top = speed.AREA
    for number, box in enumerate(labels):
        assert left <= box.x0 < box.x1 <= right
        assert bottom <= box.y0 < box.y1 <= top
        for other in labels[:number]:
            common = Bbox.intersection(box, other)
            assert common is None or common.width * common.height == pytest.approx(0.0)


def test_a_plot_takes_infinite_errors_and_maps_without_a_bound() -> None:
    bad = library("one", math.inf, Verdict.RAISED)
    worst = replace(bad, timings=(Timing("so3.log", 10, 0.0),))
    (found,) = compare([bad, worst]).speeds
    for bound in (None, 0.0, 16.0):
        assert "one 1.2.3" in speed.plot(found, bound)


@pytest.fixture
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    reports.replace(tmp_path / "one.json", reports.to_json(library("one", 1.0)))
    (tmp_path / "two").mkdir()
    reports.replace(tmp_path / "two" / "certificate.json", reports.to_json(library("two", 1e9, Verdict.WRONG)))
    return tmp_path


def test_the_command_takes_files_and_folders(files: Path) -> None:
    result = CliRunner().invoke(main, ["compare", "one.json", "two", "--out", "out"])
    assert result.exit_code == 0, result.output
    assert "2.00 1.00 ●" in result.stdout
    assert "2e9 1e9 ■" in result.stdout
    assert sorted(path.name for path in (files / "out").iterdir()) == ["compare.html", "compare.md"]
    record = json.loads(CliRunner().invoke(main, ["compare", "one.json", "two", "--json"]).stdout)
    (row,) = record["rows"]
    words = shlex.split(row["cells"][1]["command"])
    assert words[:3] == ["affinecert", "explain", "so3.log"]
    assert words[-2:] == ["--subject", "two"]
    none = CliRunner().invoke(main, ["compare", "one.json", "--map", "se3.*", "--json"])
    assert json.loads(none.stdout)["rows"] == []


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "Missing argument 'CERT...'"),
        (("nowhere.json",), "Error: cannot read the certificate nowhere.json"),
        (("out",), "Error: cannot read the certificate out"),
        (("one.json", "--map", "so4.*"), "Error: no map is named 'so4.*'"),
        (("one.json", "--out", "one.json"), "'one.json' is a file"),
    ],
)
def test_bad_use_is_told_in_one_line_with_2(arguments: tuple[str, ...], message: str, files: Path) -> None:
    result = CliRunner().invoke(main, ["compare", *arguments])
    assert result.exit_code == 2
    assert message in result.stderr
    assert result.stdout == ""
