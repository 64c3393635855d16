"""What got worse against a baseline, what is noise, and how that is told."""

from __future__ import annotations

import io
import json
import math
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from rich.console import Console

from affinecert import campaign, judging, reports
from affinecert.certificate import Certificate, LawRecord, RegimeResult, read
from affinecert.cli import main
from affinecert.ratchet import Kind, Ratchet, ratchet
from affinecert.reports import ratchet as told
from affinecert.reports import view
from affinecert.reports.html import html
from affinecert.reports.markdown import markdown
from affinecert.scoring import Verdict
from affinecert.subject import Subject

from . import certificates
from .test_reports import Page

OK, OTHER, DEGRADED, WRONG = Verdict.OK, Verdict.OTHER_BRANCH, Verdict.DEGRADED, Verdict.WRONG


def regime(verdict: Verdict, scaled: float, map_: str = "so3.log", name: str = "near-pi") -> RegimeResult:
    result = certificates.case_result(map_=map_, regime=name, verdict=verdict, scaled=scaled)
    return certificates.regime_result(map_, name, [result])


def one(verdict: Verdict, scaled: float) -> Certificate:
    return certificates.certificate((regime(verdict, scaled),))


def of_laws(*laws: LawRecord) -> Certificate:
    return certificates.certificate((), laws)


@pytest.mark.parametrize(
    ("before", "now", "kind"),
    [
        ((OK, 0.1), (OK, 15.9), None),
        ((OK, 1.0), (OTHER, 1e15), Kind.CHANGED),
        ((OTHER, 1e15), (OK, 1.0), Kind.CHANGED),
        ((OK, 1.0), (DEGRADED, 17.0), Kind.WORSE),
        ((OTHER, 1e15), (WRONG, 1e15), Kind.WORSE),
        ((DEGRADED, 1e6), (WRONG, 1e8), Kind.WORSE),
        ((WRONG, 1e9), (Verdict.NON_FINITE, math.inf), Kind.WORSE),
        ((DEGRADED, 1e6), (OK, 1.0), Kind.BETTER),
        ((Verdict.RAISED, math.inf), (DEGRADED, 1e6), Kind.BETTER),
        ((DEGRADED, 100.0), (DEGRADED, 200.0), None),
        ((DEGRADED, 100.0), (DEGRADED, 201.0), Kind.WORSE),
        ((DEGRADED, 100.0), (DEGRADED, 50.0), None),
        ((DEGRADED, 100.0), (DEGRADED, 49.0), Kind.BETTER),
        ((WRONG, 1e16), (WRONG, 1e300), None),
        ((WRONG, 1e16), (WRONG, math.inf), Kind.WORSE),
        ((WRONG, math.inf), (WRONG, math.inf), None),
    ],
)
def test_a_regime_is_worse_by_verdict_or_by_more_than_the_factor(
    before: tuple[Verdict, float], now: tuple[Verdict, float], kind: Kind | None
) -> None:
    found = ratchet(one(*before), one(*now))
    assert [change.kind for change in found.regimes] == ([kind] if kind else [])
    assert found.passed == (kind is not Kind.WORSE)
    assert found.same == (kind is None)


@pytest.mark.parametrize("name", ["passing", "failing"])
def test_the_same_certificate_is_as_before(name: str) -> None:
    certificate: Certificate = getattr(certificates, name)()
    found = ratchet(certificate, certificate)
    assert found.passed
    assert (found.regimes, found.laws, found.differences, found.gone, found.come) == ((), (), (), 0, 0)
    assert found.same == sum(result.worst is not None for result in certificate.results)


def test_a_map_that_comes_or_goes() -> None:
    without = certificates.certificate((), absent=("so3.log",))
    sound, spoilt = one(OK, 1.0), one(WRONG, 1e9)
    mixed = certificates.certificate((regime(WRONG, 1e9), regime(OK, 1.0, name="generic")))

    def changes(before: Certificate, now: Certificate) -> list[tuple[str, str, str, str]]:
        return [(c.kind, c.regime, c.before, c.now) for c in ratchet(before, now).regimes]

    assert changes(without, sound) == [("better", "", "absent", "ok")]
    assert changes(without, mixed) == [("worse", "near-pi", "absent", "wrong")]
    assert changes(sound, without) == changes(mixed, without) == [("worse", "", "ok", "absent")]
    assert changes(spoilt, without) == [("better", "", "wrong", "absent")]


def test_what_the_baseline_does_not_know_is_new_and_what_was_not_asked_for_is_not_compared() -> None:
    small = one(OK, 1.0)
    more = certificates.certificate((*small.results, regime(WRONG, 1e9, "se3.log"), regime(OK, 1.0, "se3.exp")))
    found = ratchet(small, more)
    assert [(change.kind, change.map) for change in found.regimes] == [(Kind.NEW, "se3.log")]
    assert found.passed
    assert (found.same, found.come, found.gone) == (1, 2, 0)
    back = ratchet(more, replace(small, maps="so3.*", profile="thorough"))
    assert (back.regimes, back.same, back.come, back.gone) == ((), 1, 0, 2)
    assert told.notes(back) == (
        "profile: quick in the baseline, thorough now",
        "maps: * in the baseline, so3.* now",
        "2 regimes in the baseline only",
    )


@pytest.mark.parametrize(
    ("before", "now", "kind"),
    [
        ("passed", "failed", Kind.WORSE),
        ("absent", "failed", Kind.WORSE),
        ("failed", "passed", Kind.BETTER),
        ("failed", "absent", Kind.CHANGED),
        ("passed", "absent", Kind.CHANGED),
        ("failed", "failed", None),
        (None, "failed", Kind.NEW),
        (None, "passed", None),
    ],
)
def test_a_law_is_worse_only_if_newly_broken(before: str | None, now: str, kind: Kind | None) -> None:
    old = of_laws(*([certificates.law("steadiness", before)] if before else []))
    found = ratchet(old, of_laws(certificates.law("steadiness", now, worst=1e9)))
    assert [change.kind for change in found.laws] == ([kind] if kind else [])
    assert found.passed == (kind is not Kind.WORSE)


def hostile() -> tuple[Certificate, Ratchet]:
    """A comparison with every kind of change, and with texts that want out of their cells."""
    before = certificates.certificate(
        (regime(OK, 1.0), regime(WRONG, 1e9, name="generic"), regime(OK, 1.0, name=certificates.HOSTILE)),
        (certificates.law("steadiness"), certificates.law("isometry", "failed")),
        "scipy",
    )
    now = replace(certificates.failing(), laws=(*certificates.failing().laws, certificates.law(certificates.HOSTILE)))
    extra = regime(DEGRADED, 40.0, name=certificates.HOSTILE)
    now = replace(now, results=(*now.results, extra), absent=("se3.exp",))
    before = replace(before, results=(*before.results, regime(OK, 1.0, "se3.exp")))
    return now, ratchet(before, now)


def test_documents_and_terminal_tell_every_change() -> None:
    certificate, found = hostile()
    assert found.count(Kind.WORSE) > 2
    page, text = html(certificate, found), markdown(certificate, found)
    stream = io.StringIO()
    told.show(found, certificate, Console(file=stream, width=100, highlight=False, markup=False), Path("base.json"))
    shown = stream.getvalue()
    for document in (page, text, shown):
        assert told.outcome(found) in document.replace(told.outcome(found).capitalize(), told.outcome(found))
        assert "<img" not in document or document is shown
    for change in found.regimes:
        assert told.sentence(change) in text
        assert told.sentence(change) in page
        if change.worst and change.kind is Kind.WORSE:
            assert view.reproduce(certificate, change.worst) in shown
    parts = Page(page)
    assert parts.open == []
    assert {link[1:] for link in parts.links} <= set(parts.ids)
    rows = [line for line in text.splitlines() if line.startswith(("| worse |", "| better |", "| new |"))]
    assert len(rows) == sum(found.count(kind) for kind in (Kind.WORSE, Kind.BETTER, Kind.NEW))
    assert "Against the baseline" not in html(certificate)
    assert "Against the baseline" not in markdown(certificate)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working folder in which a campaign takes no time: it gives the certificate that the test sets."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(judging, "load_once", lambda name: Subject("scipy", "1", {"so3.log": abs}))
    return tmp_path


def run(monkeypatch: pytest.MonkeyPatch, certificate: Certificate, *options: str) -> Result:
    monkeypatch.setattr(campaign, "certify", lambda *arguments, **keywords: certificate)
    result = CliRunner().invoke(main, ["certify", "scipy", "--out", "out", *options])
    assert result.exception is None or isinstance(result.exception, SystemExit), result.exception
    return result


def test_the_command_records_passes_and_fails(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    bad = replace(one(DEGRADED, 100.0), subject="scipy")
    first = run(monkeypatch, bad, "--baseline", "kept/base.json")
    assert first.exit_code == 0, first.output
    assert "no baseline yet: recorded in kept/base.json" in first.stdout
    assert read(folder / "kept" / "base.json") == bad
    again = run(monkeypatch, bad, "--baseline", "kept/base.json")
    assert again.exit_code == 0
    assert "against the baseline: nothing changed, 1 regime as before" in again.stdout
    worse = run(monkeypatch, replace(one(WRONG, 1e9), subject="scipy"), "--baseline", "kept/base.json")
    assert worse.exit_code == 1
    assert "worse  so3.log, near-pi: degraded 100 u, now wrong 1e9 u" in worse.stdout
    assert "Against the baseline" in (folder / "out" / "certificate.html").read_text(encoding="utf-8")
    better = run(monkeypatch, replace(one(DEGRADED, 20.0), subject="scipy"), "--baseline", "kept/base.json")
    assert better.exit_code == 0
    assert "better  so3.log, near-pi: degraded 100 u, now degraded 20.0 u" in better.stdout
    # The ratchet is moved by hand: what is better is told, and the baseline stays.
    assert read(folder / "kept" / "base.json") == bad
    assert run(monkeypatch, bad).exit_code == 1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("no JSON", "Error: cannot read the certificate base.json: "),
        ("[]", "Error: base.json: not a certificate of format 2: "),
        ("{}", "Error: base.json: not a certificate of format 2: "),
        (json.dumps(json.loads(reports.to_json(certificates.passing())) | {"format": 1}), "format: 2 was expected"),
        (reports.to_json(certificates.passing()), "Error: base.json: a baseline of fast, where one of scipy is due"),
        (
            reports.to_json(replace(certificates.passing(), subject="scipy", dtype="float32")),
            "Error: base.json: a baseline in float32, where scipy computes in float64",
        ),
    ],
)
def test_a_bad_baseline_is_told_before_the_work(
    text: str, message: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "base.json").write_text(text, encoding="utf-8")
    result = run(monkeypatch, certificates.passing(), "--baseline", "base.json")
    assert result.exit_code == 2
    assert message in result.stderr
    assert not (folder / "out" / "certificate.json").exists()
    assert (folder / "base.json").read_text(encoding="utf-8") == text


def test_a_baseline_that_the_certificate_would_overwrite_is_refused(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    result = run(monkeypatch, certificates.passing(), "--baseline", "out/certificate.json")
    assert result.exit_code == 2
    assert "would overwrite the baseline out/certificate.json" in result.stderr
