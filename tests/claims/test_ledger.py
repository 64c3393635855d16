"""The ledger as a whole: run on an executor, told, published."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from affinecert import ledger
from affinecert.cli import main
from affinecert.errors import UnknownNameError
from affinecert.properties.claims import LEDGER, PAPERS
from affinecert.properties.claims.claim import Verdict
from affinecert.properties.claims.finding import Finding, judge
from affinecert.reports import claims as told
from tests.claims.entries import PUBLISHED, published

NAME = "bansal_tatu.A.2.1.V"
CHAPTER = next(chapter for chapter in PAPERS["bansal_tatu"].chapters if LEDGER[NAME] in chapter.CLAIMS)


def asked(*words: str) -> Any:
    return CliRunner().invoke(main, ["claims", *words])


def test_every_paper_has_its_claims_and_ids_begin_with_it() -> None:
    for name, paper in PAPERS.items():
        assert len(paper.claims) >= 20
        assert {claim.paper for claim in paper.claims} == {name}
    assert len(LEDGER) >= 200


def test_every_verdict_occurs_and_places_are_told() -> None:
    assert {claim.verdict for claim in LEDGER.values()} == set(Verdict)
    assert [claim.id for claim in LEDGER.values() if not (claim.place and claim.statement)] == []


@pytest.mark.parametrize("jobs", [1, 2])
def test_findings_come_a_chapter_at_a_time(jobs: int) -> None:
    chosen = [LEDGER[name] for name in LEDGER if LEDGER[name] in CHAPTER.CLAIMS]
    (findings,) = ledger.run(chosen, jobs=jobs)
    assert [finding.claim for finding in findings] == [claim.id for claim in chosen]
    assert all(finding.complaints == () for finding in findings)


def test_a_chapter_that_takes_too_long_is_given_up() -> None:
    ((finding,),) = ledger.run([LEDGER[NAME]], jobs=2, limit=0.001)
    assert finding == Finding(NAME, "failed", complaints=("no answer within 0.001 s",))


def test_claims_are_chosen_by_paper_and_verdict() -> None:
    chosen = ledger.chosen("gallier", "refuted")
    assert chosen
    assert all(claim.paper == "gallier" and claim.verdict is Verdict.REFUTED for claim in chosen)
    with pytest.raises(UnknownNameError, match="no paper is named 'galier'; did you mean gallier"):
        ledger.chosen("galier")
    with pytest.raises(UnknownNameError, match="no verdict is named 'refutd'; did you mean refuted"):
        ledger.chosen(verdict="refutd")
    with pytest.raises(UnknownNameError, match=r"no claim is named .* did you mean bansal_tatu"):
        ledger.find("bansal_tatu.A.2.1.Vx")


def test_the_command_explains_one_claim() -> None:
    result = asked(NAME)
    assert result.exit_code == 0
    for text in ("printed", "refuted: a slip of the pen", "counterexample", "true is", f'claim = LEDGER["{NAME}"]'):
        assert text in result.stdout


def test_what_is_told_replays_the_counterexample() -> None:
    entry = told.Entry(LEDGER[NAME], judge(LEDGER[NAME]))
    *given, asked_for = told.replay(entry)
    names: dict[str, Any] = {}
    exec("\n".join(given), names)
    assert float(eval(asked_for, names)) == entry.finding.deviation


def test_the_command_gives_json_and_writes_the_documents(tmp_path: Path) -> None:
    result = asked(NAME, "--json", "--out", str(tmp_path))
    assert result.exit_code == 0
    assert json.loads((tmp_path / "ledger.json").read_text(encoding="utf-8"))[0]["id"] == NAME
    assert '"verdict": "refuted"' in result.stdout
    assert sorted(path.name for path in tmp_path.iterdir()) == ["errata.md", "ledger.html", "ledger.json", "ledger.md"]


def test_an_entry_that_does_not_stand_is_a_finding(monkeypatch: pytest.MonkeyPatch) -> None:
    complaint = Finding(NAME, "confirmed", complaints=("refuted is stated",))
    monkeypatch.setattr(ledger, "judge", lambda claim: complaint)
    result = asked("--paper", "bansal_tatu", "--verdict", "refuted", "--jobs", "1")
    assert result.exit_code == 1
    assert f"{NAME}: refuted is stated" in result.stdout


def test_ctrl_c_shows_what_was_found(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(claims: Any, **options: Any) -> Any:
        yield (judge(LEDGER[NAME]),)
        raise KeyboardInterrupt

    monkeypatch.setattr(ledger, "run", interrupted)
    result = asked()
    assert result.exit_code == 130
    assert "1 claim: 1 refuted" in result.stdout


def test_the_published_ledger_has_every_claim() -> None:
    assert list(published()) == list(LEDGER)


def test_the_published_errata_name_every_refuted_and_domain_bound_claim() -> None:
    errata = (PUBLISHED / "errata.md").read_text(encoding="utf-8")
    for claim in LEDGER.values():
        assert (f"`{claim.id}`" in errata) == (claim.verdict in {Verdict.REFUTED, Verdict.BOUND}), claim.id


def test_the_readme_says_how_many_claims_there_are() -> None:
    readme = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    findings = [Finding(claim.id, claim.verdict) for claim in LEDGER.values()]
    assert told.tally(told.entries(LEDGER.values(), findings)) in " ".join(readme.split())
