"""Loading subjects, and asking good and bad ones."""

from __future__ import annotations

from functools import cache
from importlib.metadata import EntryPoint
from pathlib import Path

import numpy as np
import pytest

from affinecert import subject as subject_module
from affinecert.answering import answers
from affinecert.case import Case, generate
from affinecert.catalogue import CATALOGUE
from affinecert.errors import SubjectError, UnknownNameError
from affinecert.judging import judge, truths_of
from affinecert.scoring import Verdict
from affinecert.subject import GROUP, Subject, load, named
from affinecert.subjects.scipy import subject as scipy_subject
from affinecert.tier import batches

from .adapters import faulty

ADAPTERS = faulty.__name__.rpartition(".")[0]


@cache
def rotations() -> tuple[Case, ...]:
    (regime,) = (regime for regime in CATALOGUE["so3.exp"].regimes if regime.name == "generic")
    return tuple(generate(CATALOGUE["so3.exp"], regime, 4))


def verdicts(subject: Subject) -> list[tuple[str, str]]:
    return [(result.verdict, result.note) for result in judge(subject, rotations(), truths_of(rotations()))]


OWN = sorted(name for name, entry in named().items() if entry.module.startswith("affinecert.subjects."))


@pytest.mark.parametrize("name", OWN)
def test_our_subjects_are_loaded_by_name_and_offer_maps_of_the_catalogue(name: str) -> None:
    try:
        subject = load(name)
    except SubjectError as error:
        assert f"pip install 'affinecert[{named()[name].extras[0]}]' installs what it needs" in str(error)
        pytest.skip("its library is not installed")
    assert subject.name == name
    assert subject.version
    assert set(subject.maps) <= set(CATALOGUE)


def test_what_is_installed_goes_before_its_sources_in_the_working_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sources, installed = tmp_path / "sources", tmp_path / "installed"
    for folder, version in ((sources, "not built"), (installed, "built")):
        folder.mkdir()
        (folder / "a_library_with_sources.py").write_text(f"version = {version!r}", encoding="utf-8")
    adapter = "import a_library_with_sources as lib, affinecert\nsubject = affinecert.Subject('lib', lib.version, {})"
    (sources / "adapter_beside_sources.py").write_text(adapter, encoding="utf-8")
    monkeypatch.syspath_prepend(str(installed))
    monkeypatch.chdir(sources)
    assert load("adapter_beside_sources:subject").version == "built"


def test_other_packages_bring_their_subjects(monkeypatch: pytest.MonkeyPatch) -> None:
    theirs = EntryPoint("theirs", f"{ADAPTERS}.faulty:sound", GROUP)
    missing = EntryPoint("missing", f"{ADAPTERS}.unimportable:subject [rarity]", GROUP)
    monkeypatch.setattr(subject_module, "entry_points", lambda group: [theirs, missing])
    assert load("theirs").maps["so3.exp"] is not None
    with pytest.raises(SubjectError, match=r"a_library_that_nobody_has.*; pip install 'affinecert\[rarity\]'"):
        load("missing")
    with pytest.raises(UnknownNameError, match="did you mean theirs"):
        load("their")


@pytest.mark.parametrize("name", ["fast", "reference"])
def test_fast_and_reference_offer_every_map(name: str) -> None:
    assert set(load(name).maps) == set(CATALOGUE)


def test_a_subject_is_loaded_by_module_and_attribute() -> None:
    assert load(f"{ADAPTERS}.faulty:sound").maps["so3.exp"] is not None


@pytest.mark.parametrize(
    ("spec", "error", "message"),
    [
        ("sciPy", UnknownNameError, "no subject is named 'sciPy'; did you mean scipy"),
        ("fats", UnknownNameError, "did you mean fast"),
        ("nowhere:subject", SubjectError, "cannot import the subject 'nowhere:subject': No module named 'nowhere'"),
        (f"{ADAPTERS}.unimportable:subject", SubjectError, "No module named 'a_library_that_nobody_has'"),
        (f"{ADAPTERS}.exploding:subject", SubjectError, "raised RuntimeError: no licence"),
        (f"{ADAPTERS}.faulty:nothing", SubjectError, "has no nothing"),
        (f"{ADAPTERS}.faulty:no_subject", SubjectError, "no_subject is a dict"),
        (f"{ADAPTERS}.faulty:", SubjectError, "is not a Subject"),
    ],
)
def test_what_is_no_subject_is_told(spec: str, error: type[Exception], message: str) -> None:
    with pytest.raises(error) as caught:
        load(spec)
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("subject", "verdict", "note"),
    [
        (faulty.raises, Verdict.RAISED, "ValueError: no rotations today"),
        (faulty.none, Verdict.RAISED, "TypeError: an output of dtype object where numbers are due"),
        (faulty.words, Verdict.RAISED, "TypeError: an output of dtype <U10 where numbers are due"),
        (faulty.nan, Verdict.NON_FINITE, "not finite where a number is due"),
        (faulty.complex_numbers, Verdict.WRONG, "complex where a real value is due"),
        (faulty.flat, Verdict.WRONG, "output 0 has shape (9,) where (3, 3) is due"),
        (faulty.one_short, Verdict.RAISED, "ValueError: an output of shape (0, 3, 3) for a batch of 1"),
        (faulty.ragged, Verdict.WRONG, "output 0 has shape (1,) where (3, 3) is due"),
        (faulty.pair, Verdict.WRONG, "2 outputs where 1 are due"),
    ],
    ids=lambda value: value.name.lstrip("_") if isinstance(value, Subject) else "",
)
def test_bad_answers_get_their_verdict_and_say_why(subject: Subject, verdict: Verdict, note: str) -> None:
    assert verdicts(subject) == [(verdict, note)] * len(rotations())


@pytest.mark.parametrize(
    "subject",
    [
        faulty.sound,
        faulty.raises_on_batches,
        faulty.complex_without_imaginary_part,
        faulty.lists,
        faulty.scribbles,
    ],
    ids=lambda subject: subject.name.lstrip("_"),
)
def test_harmless_peculiarities_are_not_held_against_a_subject(subject: Subject) -> None:
    assert verdicts(subject) == [(Verdict.OK, "")] * len(rotations())


def test_a_subject_that_writes_into_its_inputs_spoils_no_case() -> None:
    before = [case.inputs[0].copy() for case in rotations()]
    answers(faulty.scribbles, rotations())
    np.testing.assert_array_equal([case.inputs[0] for case in rotations()], before)


def test_one_bad_item_does_not_spoil_the_batch() -> None:
    def moody(omega: faulty.Array) -> faulty.Array:
        if np.any(omega == rotations()[1].inputs[0]):
            raise ValueError("not this one")
        return faulty.rodrigues(omega)

    found = [verdict for verdict, _ in verdicts(Subject("moody", "0", {"so3.exp": moody}))]
    assert found == [Verdict.OK, Verdict.RAISED, Verdict.OK, Verdict.OK]


def test_a_long_complaint_is_cut() -> None:
    def talkative(omega: object) -> None:
        raise ValueError("x" * 100_000)

    (answer, *_) = answers(Subject("talkative", "0", {"so3.exp": talkative}), rotations())
    assert answer.complaint is not None
    assert len(answer.complaint) == 200


def regime_verdicts(subject: Subject, name: str, regime: str, count: int = 8) -> list[str]:
    entry = CATALOGUE[name]
    (chosen,) = (candidate for candidate in entry.regimes if candidate.name == regime)
    return [
        result.verdict
        for batch in batches(generate(entry, chosen, count))
        for result in judge(subject, batch, truths_of(batch))
    ]


@pytest.mark.parametrize(
    ("name", "regime"),
    [
        ("so3.exp", "generic"),
        ("so3.exp", "huge-angle"),
        ("so3.log", "near-identity"),
        ("so3.log", "near-pi"),
        ("so3.log", "at-pi"),
        ("se3.exp", "generic"),
        ("se3.log", "near-pi"),
        ("shear.log", "coalescing"),
        ("affine_lie.decompose", "generic"),
    ],
)
def test_scipy_is_acquitted_where_it_is_right(name: str, regime: str) -> None:
    assert set(regime_verdicts(scipy_subject, name, regime)) <= {Verdict.OK, Verdict.OTHER_BRANCH}


@pytest.mark.parametrize(
    ("name", "regime", "verdict"),
    [
        ("so3.log", "off-manifold", Verdict.DEGRADED),
        ("se3.exp", "near-identity", Verdict.DEGRADED),
        ("shear.exp", "tiny-next-to-huge", Verdict.WRONG),
    ],
)
def test_scipy_is_found_out_where_it_is_wrong(name: str, regime: str, verdict: Verdict) -> None:
    assert verdict in regime_verdicts(scipy_subject, name, regime)


@pytest.mark.parametrize("name", sorted(CATALOGUE))
def test_the_reference_rounded_has_no_finding(name: str) -> None:
    for regime in CATALOGUE[name].regimes[:4]:
        assert set(regime_verdicts(load("reference"), name, regime.name, 1)) == {Verdict.OK}
