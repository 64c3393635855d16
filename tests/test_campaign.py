"""The campaign: what is judged, what a misbehaving subject comes to, and what an interrupted run keeps."""

from __future__ import annotations

from pathlib import Path

import pytest

from affinecert.campaign import certify
from affinecert.case import to_hex
from affinecert.catalogue import CATALOGUE
from affinecert.certificate import CaseResult, Certificate
from affinecert.errors import SubjectError, UnknownNameError
from affinecert.law_matrix import law_matrix
from affinecert.tier import PROFILES, select
from tests.adapters import faulty


def judged(certificate: Certificate) -> list[CaseResult]:
    return [finding for result in certificate.results for finding in result.findings]


def verdicts(certificate: Certificate) -> set[str]:
    return {verdict for result in certificate.results for verdict in result.verdicts}


def test_the_standard_profile_judges_five_thousand_cases() -> None:
    assert len(list(select(CATALOGUE.values(), PROFILES["standard"]))) >= 5000


def test_the_tier_is_the_same_every_time_and_has_no_case_twice() -> None:
    entries = [CATALOGUE["so3.log"], CATALOGUE["sam.exists"]]
    keys = [case.key for case in select(entries, PROFILES["quick"])]
    assert keys == [case.key for case in select(entries, PROFILES["quick"])]
    assert len(set(keys)) == len(keys)


def test_profiles_only_add_cases() -> None:
    entries = [CATALOGUE["se3.exp"]]
    quick, standard = ({case.key for case in select(entries, PROFILES[name])} for name in ("quick", "standard"))
    assert quick < standard


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_good_subject_passes(jobs: int, tmp_path: Path) -> None:
    certificate = certify(
        "tests.adapters.faulty:lists", maps="so3.exp", profile="quick", jobs=jobs, store=tmp_path / "store.sqlite"
    )
    generic = next(result for result in certificate.results if result.regime == "generic")
    assert generic.passed
    assert certificate.absent == ()
    assert certificate.timings[0].map == "so3.exp"


def test_a_subject_that_always_hangs_is_given_up(tmp_path: Path) -> None:
    certificate = certify(
        "tests.adapters.faulty:hangs", maps="so3.exp", profile="quick", jobs=2, store=tmp_path / "store", limit=0.2
    )
    assert verdicts(certificate) == {"raised"}
    notes = {finding.note for finding in judged(certificate)}
    assert notes == {"not asked, as 6 calls came to nothing: no answer within 0.2 s"}


def test_the_one_case_that_hangs_is_found(tmp_path: Path) -> None:
    certificate = certify(
        "tests.adapters.faulty:hangs_on_one", maps="so3.exp", profile="quick", jobs=2, store=tmp_path / "store", limit=2
    )
    hung = [finding for finding in judged(certificate) if finding.verdict == "raised"]
    assert [finding.note for finding in hung] == ["no answer within 2 s"]
    assert hung[0].case["inputs"] == [to_hex(faulty.FATAL)]


def test_a_subject_that_kills_its_process_is_given_up(tmp_path: Path) -> None:
    certificate = certify(
        "tests.adapters.faulty:dies", maps="so3.exp", profile="quick", jobs=2, store=tmp_path / "store"
    )
    assert verdicts(certificate) == {"raised"}
    assert all("the process died" in finding.note for finding in judged(certificate))


class _Interrupted:
    """Presses Ctrl-C after so many pieces of work."""

    def __init__(self, after: int) -> None:
        self.after = after

    def __call__(self, done: int, total: int, doing: str) -> None:
        if done >= self.after:
            raise KeyboardInterrupt


class _Heard:
    """Writes down what it is told."""

    def __init__(self) -> None:
        self.told: list[tuple[int, int, str]] = []

    def __call__(self, done: int, total: int, doing: str) -> None:
        self.told.append((done, total, doing))


@pytest.fixture(scope="module")
def unbroken(tmp_path_factory: pytest.TempPathFactory) -> Certificate:
    """The certificate of a run that nothing interrupts."""
    store = tmp_path_factory.mktemp("unbroken") / "store.sqlite"
    return certify("tests.adapters.faulty:lists", maps="so3.exp", profile="quick", store=store)


@pytest.mark.parametrize("jobs", [1, 2])
def test_an_interrupted_run_keeps_what_is_finished_and_goes_on_from_it(
    jobs: int, unbroken: Certificate, tmp_path: Path
) -> None:
    store = tmp_path / "store.sqlite"
    good = "tests.adapters.faulty:lists"
    with pytest.raises(KeyboardInterrupt):
        certify(good, maps="so3.exp", profile="quick", jobs=jobs, store=store, progress=_Interrupted(130))
    heard = _Heard()
    resumed = certify(good, maps="so3.exp", profile="quick", jobs=jobs, store=store, progress=heard)
    assert "going on from" in heard.told[0][2]
    assert heard.told[-1][0] == heard.told[-1][1]
    assert resumed.results == unbroken.results


def test_a_finished_run_leaves_nothing_to_go_on_from(tmp_path: Path) -> None:
    heard = _Heard()
    for _ in range(2):
        heard = _Heard()
        certify(faulty.lists, maps="so3.exp", profile="quick", store=tmp_path / "store.sqlite", progress=heard)
    assert not any("going on from" in doing for _, _, doing in heard.told)
    assert any("looked up" in doing for _, _, doing in heard.told)
    assert not any("computed" in doing for _, _, doing in heard.told)


def test_maps_that_are_not_offered_are_absent_not_failures(tmp_path: Path) -> None:
    certificate = certify(faulty.lists, maps="so3.*", profile="quick", store=tmp_path / "store.sqlite")
    assert set(certificate.absent) == {"so3.log", "so3.log_near"}
    assert all(law.verdict != "failed" for law in certificate.laws)


def test_the_law_matrix_of_the_morphs_that_are_chosen_and_offered(tmp_path: Path) -> None:
    store = tmp_path / "store.sqlite"
    certificate = certify(faulty.straight, maps="morphs.*", profile="quick", store=store)
    assert {cell.morph for cell in certificate.morph_laws} == {"linear"}
    assert {"holds", "partly", "fails"} == {cell.verdict for cell in certificate.morph_laws}
    assert not any(result.findings for result in certificate.results if result.regime == "equal-2d")
    assert certify(faulty.lists, maps="so3.exp", profile="quick", store=store).morph_laws == ()


@pytest.mark.parametrize(("subject", "complaint"), [("still", "no answer within 1 s"), ("exits", "the process died")])
def test_a_row_of_the_law_matrix_that_comes_to_nothing_is_unclear(subject: str, complaint: str) -> None:
    cells = law_matrix(f"tests.adapters.faulty:{subject}", morph="linear", jobs=2, limit=1)
    assert {cell.verdict for cell in cells} == {"unclear"}
    assert all(complaint in cell.note for cell in cells)


def test_unknown_names_are_told_with_their_neighbours(tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="no subject is named 'fsat'; did you mean fast"):
        certify("fsat")
    with pytest.raises(UnknownNameError, match=r"no map is named 'so3\.lgo'; did you mean so3\.log"):
        certify(faulty.lists, maps="so3.lgo")
    with pytest.raises(UnknownNameError, match="no profile is named 'quik'; did you mean quick"):
        certify(faulty.lists, profile="quik")
    with pytest.raises(SubjectError, match="has no subjekt"):
        certify("tests.adapters.faulty:subjekt")
