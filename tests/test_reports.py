from __future__ import annotations

import errno
import io
import json
import math
import os
import re
import shlex
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from affinecert import reports
from affinecert.catalogue import CATALOGUE
from affinecert.certificate import Certificate, MorphLawRecord, dump, parse, read
from affinecert.errors import StoredFileError
from affinecert.inputs import read_inputs
from affinecert.properties.matrix.laws import LAWS
from affinecert.properties.matrix.morphs import MORPHS
from affinecert.reports import matrix, progress, terminal, view
from affinecert.reports.html import html
from affinecert.reports.markdown import escape, law_matrix, markdown
from affinecert.reports.plots import Scale
from affinecert.scoring import Verdict

from . import certificates

ALL = {
    "passing": certificates.passing(),
    "failing": certificates.failing(),
    "large": certificates.large(maps=6, regimes=4, cases=8, spoilt=0.5),
    "empty": certificates.certificate(()),
}
each = pytest.mark.parametrize("certificate", ALL.values(), ids=ALL)


class Page(HTMLParser):
    """What a browser would do with a page: the elements it makes, what it would load, and the text it shows."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.ids: list[str] = []
        self.links: list[str] = []
        self.loads: list[str] = []
        self.text: list[str] = []
        self.open: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        if tag not in {"meta", "br", "img", "link", "input"}:
            self.open.append(tag)
        for name, value in attrs:
            if name == "id":
                self.ids.append(value or "")
            elif name in {"href", "xlink:href"}:
                self.links.append(value or "")
            elif name in {"src", "srcset", "data", "action", "onerror", "onload", "onclick"}:
                self.loads.append(f"{tag} {name}={value}")

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open, f"</{tag}> closes nothing"
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text.append(data)


@each
def test_json_fits_the_schema_and_is_read_back_as_it_was(certificate: Certificate, tmp_path: Path) -> None:
    text = reports.to_json(certificate)
    assert parse(json.loads(text), "certificate.json") == certificate
    assert json.loads(text) == json.loads(json.dumps(dump(certificate)))
    path, *_ = reports.write(certificate, tmp_path)
    assert read(path).passed == certificate.passed


def test_json_has_a_line_for_each_regime_and_law() -> None:
    lines = reports.to_json(ALL["failing"]).splitlines()
    assert sum('"regime": "near-pi", "distance"' in line for line in lines) == 1
    assert sum('"name": "steadiness"' in line for line in lines) == 1


@each
def test_markdown_names_every_map_regime_finding_and_law(certificate: Certificate) -> None:
    text = markdown(certificate)
    for result in certificate.results:
        assert f"`{result.map}`" in text
    for finding in view.findings(certificate):
        row = rf"\| `{finding.case['map']}` \| .* \| {finding.verdict} \| {re.escape(view.figure(finding.scaled))} \|"
        assert re.search(row, text)
    for finding in view.gravest(view.findings(certificate), "map"):
        assert view.reproduce(certificate, finding) in text
    for law in certificate.laws:
        assert f"| {law.name} | {law.verdict} |" in text
    for gap in view.absent(certificate):
        assert f"`{gap.name}`{f' ({gap.remark})' if gap.remark else ''}" in text
    for cells in matrix.rows(certificate.morph_laws):
        assert f"| {cells.morph} | {' | '.join(escape(matrix.word(cell)) for cell in cells.cells)} |" in text


def test_markdown_lets_no_text_out_of_its_cell() -> None:
    text = markdown(ALL["failing"])
    assert "<img" not in text
    for table in re.findall(r"(?:^\|.*\n)+", text, flags=re.MULTILINE):
        assert len({len(re.findall(r"(?<!\\)\|", row)) for row in table.splitlines()}) == 1


@each
def test_html_is_whole_and_stands_alone(certificate: Certificate) -> None:
    text = html(certificate)
    page = Page(text)
    assert page.open == []
    assert page.loads == []
    assert "img" not in page.tags
    assert "link" not in page.tags
    assert page.tags.count("script") == 1
    assert "http:" not in text
    assert "https:" not in text
    assert all(link.startswith("#") for link in page.links)
    assert len(page.ids) == len(set(page.ids))
    assert {link[1:] for link in page.links} <= set(page.ids)
    # A colour or a marker of Matplotlib's own would not follow the page into the dark.
    assert not re.search(r"(fill|stroke): ?#[0-9a-f]{6}", text)


@each
def test_html_names_every_map_regime_finding_and_law(certificate: Certificate) -> None:
    page = Page(html(certificate))
    shown = set(map(str.strip, page.text))
    assert page.tags.count("svg") == page.tags.count("figure") == len(certificate.results)
    for result in certificate.results:
        assert result.map in shown
        assert result.regime.strip() in shown
    for finding in view.findings(certificate):
        assert view.reproduce(certificate, finding) in shown
        assert view.hexadecimal(finding.case["inputs"]) in shown
    for law in certificate.laws:
        assert law.name in shown
    for gap in view.absent(certificate):
        assert gap.name in shown
        assert not gap.remark or any(text.startswith(f"({gap.remark})") for text in shown)
    for cell in certificate.morph_laws:
        assert {cell.morph, cell.law, matrix.word(cell)} <= shown
    for cell in matrix.counterexamples(certificate.morph_laws):
        assert matrix.sentence(cell).split() in [text.split() for text in shown]
        assert any(matrix.named_poses(cell)[0][1] in text for text in shown)


def test_html_gives_the_worst_input_of_a_regime_without_findings() -> None:
    certificate = ALL["passing"]
    worst = certificate.results[0].worst
    assert worst is not None
    shown = set(map(str.strip, Page(html(certificate)).text))
    assert view.reproduce(certificate, worst) in shown
    assert view.hexadecimal(worst.case["inputs"]) in shown


def test_html_is_the_same_for_the_same_certificate() -> None:
    assert html(ALL["failing"]) == html(ALL["failing"])


def test_plots_need_neither_a_display_nor_a_home_and_say_nothing(tmp_path: Path) -> None:
    code = "from tests.certificates import failing; from affinecert.reports.html import html; html(failing())"
    (tmp_path / "file").touch()
    environment = {key: value for key, value in os.environ.items() if key not in {"DISPLAY", "WAYLAND_DISPLAY"}}
    environment |= {"HOME": str(tmp_path / "file"), "XDG_CACHE_HOME": str(tmp_path / "file")}
    environment |= {"MPLCONFIGDIR": str(tmp_path / "file" / "none"), "PYTHONPATH": str(Path(__file__).parents[1])}
    run = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], env=environment, capture_output=True, text=True, check=False
    )
    assert (run.returncode, run.stdout, run.stderr) == (0, "", "")


@pytest.mark.parametrize(
    ("scale", "value", "place"),
    [
        (Scale(-4, 0), 1e-2, -2.0),
        (Scale(-4, 0), 1e-9, -4.0),
        (Scale(-4, 0), 0.0, -4.0),
        (Scale(-10, 0, zero=True), 0.0, -10.9),
        (Scale(-10, 0, infinity=True), math.inf, 0.9),
    ],
)
def test_scale_places_every_number(scale: Scale, value: float, place: float) -> None:
    assert scale.place(value) == pytest.approx(place)
    low, high = scale.limits
    assert low < scale.place(value) < high


def test_scale_has_few_ticks_with_places_for_0_and_infinity() -> None:
    places, labels = Scale(-324, 308, zero=True, infinity=True).ticks
    assert places == sorted(places)
    assert labels[0] == "0"
    assert labels[-1] == "∞"
    assert "1" in labels
    assert len(labels) <= 7
    assert Scale(-16, 0).ticks[1] == ["10⁻¹⁶", "10⁻¹²", "10⁻⁸", "10⁻⁴", "1"]


def printed(certificate: Certificate, **options: object) -> str:
    stream = io.StringIO()
    terminal.show(certificate, Console(file=stream, width=100, highlight=False, markup=False, **options))  # type: ignore[arg-type]
    return stream.getvalue()


@each
def test_terminal_fits_100_columns_but_for_commands_to_copy(certificate: Certificate) -> None:
    text = printed(certificate)
    assert "\x1b" not in text
    for line in text.splitlines():
        assert len(line) <= 100 or line.startswith("  affinecert explain ")
    for result in certificate.results:
        assert f"\n{result.map} " in text
    for finding in view.gravest(view.findings(certificate), "map", "regime")[: terminal.SHOWN]:
        assert f"  {view.reproduce(certificate, finding)}\n" in text
    assert view.outcome(certificate) in text


def test_terminal_colours_verdicts_where_it_may(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert "\x1b[31m" in printed(ALL["failing"], force_terminal=True, color_system="standard")
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b[31m" not in printed(ALL["failing"], force_terminal=True)


def test_terminal_says_how_many_findings_it_leaves_out() -> None:
    names = [f"regime-{number}" for number in range(terminal.SHOWN + 3)]
    bad = [certificates.case_result(regime=name, scaled=1e9, verdict=Verdict.WRONG) for name in names]
    results = tuple(certificates.regime_result("so3.log", name, [case]) for name, case in zip(names, bad, strict=True))
    assert "and in 3 more regimes" in printed(certificates.certificate(results))


@pytest.mark.parametrize(
    ("missing", "there", "told"),
    [
        ("", "so3.exp", ""),
        ("so3.exp so3.log se3.exp se3.log", "", "so3 (2), se3 (2)"),
        ("mesh3.blend", "so3.exp", "mesh3.blend"),
        ("scale.log", "scale.exp", "scale.log"),
        ("sam.log sam.exists", "sam.power sam.morph", "sam.log, sam.exists"),
        ("sam.log sam.exists sam.morph", "sam.power sam.power", "sam (all but power)"),
        ("sim3.log sam.log sim3.exp sim3.log_next", "sim3.a sim3.b", "sim3 (all but a, b), sam.log"),
        ("exp_log.so3.exp exp_log.so3.log", "exp_log.sam.log", "exp_log (all but sam.log)"),
        ("so3.exp so3.log", "so31.exp", "so3 (2)"),
        ("odd nameless.", "odd", "odd, nameless."),
    ],
)
def test_what_is_missing_is_told_by_family(missing: str, there: str, told: str) -> None:
    assert ", ".join(map(str, view.by_family(missing.split(), there.split()))) == told


def test_a_subject_of_few_maps_is_told_in_few_words() -> None:
    names = [name for name in CATALOGUE if name not in {"so3.exp", "morphs.sclerp"}]
    rows = tuple(certificates.regime_result(name, "generic", []) for name in ("so3.exp", "morphs.sclerp"))
    gaps = view.absent(certificates.certificate(rows, absent=tuple(names)))
    told = [str(gap) for gap in gaps]
    assert {"so3 (all but exp)", "scale (2)", "polar.decompose", "mesh2 (6)", "morphs (all but sclerp)"} <= set(told)
    assert len(", ".join(told)) < 300
    # Whoever knows the catalogue can tell each missing map from these words.
    families = [gap.name for gap in gaps if gap.remark]
    assert all((name.split(".")[0] in families) != (name in told) for name in names)


def test_maps_and_laws_that_are_not_offered_are_told_by_family_everywhere() -> None:
    failing = ALL["failing"]
    assert "\nmaps not offered: shear (2)\n" in printed(failing)
    assert "\nlaws of maps not offered: isometry\n" in printed(failing)
    assert "\nNot offered: `shear` (2).\n" in markdown(failing)
    assert "Not offered by the subject: shear (2)." in "".join(Page(html(failing)).text)


def test_a_cell_of_the_law_matrix_is_a_word() -> None:
    words = [matrix.word(cell) for cell in certificates.morph_laws()]
    assert words == ["yes", "0", "no", "3.75", f"{certificates.HOSTILE}!", "?", "–", "·"]


def test_the_law_matrix_breaks_no_finding() -> None:
    results = ALL["passing"].results
    assert certificates.certificate(results, cells=certificates.morph_laws()).passed


def test_the_law_matrix_in_parts_that_fit_the_screen() -> None:
    cells = [
        MorphLawRecord(morph.name, law.name, "holds", morph.takes, confirmed=True) for morph in MORPHS for law in LAWS
    ]
    for width in (60, 100, 200):
        stream = io.StringIO()
        matrix.show(cells, Console(file=stream, width=width, highlight=False, markup=False))
        lines = stream.getvalue().splitlines()
        assert max(map(len, lines)) <= width
        heads = " ".join(line for line in lines if line.startswith(" " * 20))
        assert heads.split() == " ".join(law.head for law in LAWS).split()
        for morph in MORPHS:
            (count,) = {sum(line.split().count("yes") for line in lines if line.startswith(f"{morph.name} "))}
            assert count == len(LAWS)
    table = law_matrix(cells).splitlines()[: len(MORPHS) + 2]
    assert {line.count("|") for line in table} == {len(LAWS) + 2}


def test_progress_is_a_bar_in_a_terminal() -> None:
    stream = io.StringIO()
    console = Console(file=stream, force_terminal=True, width=100, _environ={"TERM": "xterm"})
    with progress.shown(console) as update:
        update(0.25, "so3.log [near-pi]")
        update(None, "nobody knows how long")
        update(1.0, "done")
    assert "100%" in stream.getvalue()
    assert "left" in stream.getvalue()


@pytest.mark.parametrize("options", [{}, {"force_terminal": True, "_environ": {"TERM": "dumb"}}])
def test_progress_is_a_line_now_and_then_elsewhere(monkeypatch: pytest.MonkeyPatch, options: dict[str, Any]) -> None:
    clock = iter([0.0, 1.0, 11.0, 12.0, 25.0])
    monkeypatch.setattr(progress, "monotonic", lambda: next(clock))
    stream = io.StringIO()
    with progress.shown(Console(file=stream, width=100, **options)) as update:
        update(0.1, "too early")
        update(0.5, "so3.log [near-pi]")
        update(0.6, "too early")
        update(None, "so3.exp")
    assert stream.getvalue() == "50%, 11 s: so3.log [near-pi]\n25 s: so3.exp\n"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (None, "–"),
        (math.nan, "–"),
        (math.inf, "∞"),
        (0.0, "0"),
        (0.5, "0.50"),
        (12.34, "12.3"),
        (1234.5, "1234"),
        (1e-9, "1e-9"),
        (2.5e16, "2.5e16"),
        (5e-324, "4.9e-324"),
    ],
)
def test_figure(value: float | None, text: str) -> None:
    assert view.figure(value) == text


def test_findings_are_told_gravest_first() -> None:
    assert [finding.verdict for finding in view.findings(ALL["failing"])] == [
        "raised",
        "non-finite",
        "wrong",
        "degraded",
    ]
    assert view.total(ALL["failing"]) == 4
    assert view.outcome(ALL["failing"]) == "4 findings in 2 regimes of 4, 1 law broken"
    assert view.outcome(ALL["passing"]) == "passed"


def test_the_command_of_a_case_gives_its_very_bits() -> None:
    generator = np.random.default_rng(7)
    inputs = (generator.standard_normal((4, 4)) * 10.0 ** generator.integers(-300, 300, (4, 4)), np.float64(5e-324))
    result = certificates.case_result(map_="sam.power", inputs=inputs)
    words = shlex.split(view.reproduce(ALL["failing"], result))
    assert words[:3] == ["affinecert", "explain", "sam.power"]
    assert words[4:] == ["--subject", "scipy"]
    back = read_inputs(CATALOGUE["sam.power"], words[3])
    assert [array.tobytes() for array in back] == [np.asarray(array).tobytes() for array in inputs]


def test_write_makes_the_folder_and_three_files(tmp_path: Path) -> None:
    paths = reports.write(ALL["failing"], tmp_path / "a" / "b")
    assert [path.name for path in paths] == ["certificate.json", "certificate.md", "certificate.html"]
    assert sorted(path.name for path in (tmp_path / "a" / "b").iterdir()) == sorted(path.name for path in paths)
    assert read(paths[0]).results[0] == ALL["failing"].results[0]


def test_a_folder_that_cannot_be_is_told_by_name(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    folder = tmp_path / "file" / "certificates"
    with pytest.raises(StoredFileError, match=rf"cannot write {re.escape(str(folder))}: Not a directory"):
        reports.prepare(folder)
    with pytest.raises(StoredFileError, match=re.escape(str(folder))):
        reports.write(ALL["passing"], folder)


def test_a_full_disk_is_told_and_leaves_the_old_certificate(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = reports.write(ALL["passing"], tmp_path)[0].read_bytes()
    whole = Path.write_text

    def half(path: Path, text: str, **options: str) -> int:
        whole(path, text[: len(text) // 2], encoding="utf-8", errors=options["errors"])
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(Path, "write_text", half)
    with pytest.raises(StoredFileError, match=r"certificate\.json: No space left on device"):
        reports.write(ALL["failing"], tmp_path)
    assert (tmp_path / "certificate.json").read_bytes() == before
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".html", ".json", ".md"]
