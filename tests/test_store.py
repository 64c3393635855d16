"""The files that affinecert keeps: the store and the corpus, whole, damaged, and out of reach."""

from __future__ import annotations

import sqlite3
from pathlib import Path

import numpy as np
import pytest

from affinecert import corpus
from affinecert.case import Case, dump_line
from affinecert.catalogue import CATALOGUE, find, matching
from affinecert.errors import StoredFileError, UnknownNameError
from affinecert.store import Store, default_path
from affinecert.truths import Truth

TRUTH = Truth(
    high=(np.array([[0.1, -0.0], [5e-324, np.inf]]), np.array(1e308)),
    low=(np.array([[1e-18, 0.0], [0.0, 0.0]]), np.array(-1e291)),
    sensitivity=(1 / 3, 0.0),
    refusal=None,
)
REFUSAL = Truth((), (), (), "no real logarithm")


def same(one: Truth, two: Truth) -> bool:
    """Equal to the last bit, signs of zero included."""
    arrays = zip((*one.high, *one.low), (*two.high, *two.low), strict=True)
    return (one.sensitivity, one.refusal) == (two.sensitivity, two.refusal) and all(
        x.shape == y.shape and x.tobytes() == y.tobytes() for x, y in arrays
    )


def test_truths_come_back_to_the_last_bit(tmp_path: Path) -> None:
    with Store(tmp_path / "store.sqlite") as store:
        store.keep_truths("v1", {"a": TRUTH, "b": REFUSAL})
    with Store(tmp_path / "store.sqlite") as store:
        held = store.truths("v1", ["a", "b", "c"])
    assert set(held) == {"a", "b"}
    assert same(held["a"], TRUTH)
    assert same(held["b"], REFUSAL)


def test_truths_of_another_reference_are_not_used(tmp_path: Path) -> None:
    with Store(tmp_path / "store.sqlite") as store:
        store.keep_truths("v1", {"a": TRUTH})
        assert store.truths("v2", ["a"]) == {}


def test_verdicts_are_kept_until_the_run_is_forgotten(tmp_path: Path) -> None:
    with Store(tmp_path / "store.sqlite") as store:
        store.keep_verdicts("run", {"a": {"verdict": "ok"}})
        store.keep_verdicts("run", {"b": {"verdict": "wrong"}})
        store.keep_verdicts("other", {"c": {"verdict": "ok"}})
    with Store(tmp_path / "store.sqlite") as store:
        assert store.verdicts("run") == {"a": {"verdict": "ok"}, "b": {"verdict": "wrong"}}
        store.forget("run")
        assert store.verdicts("run") == {}
        assert set(store.verdicts("other")) == {"c"}


def test_the_folder_is_made_and_may_be_chosen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("AFFINECERT_CACHE", str(tmp_path / "deep" / "down"))
    with Store() as store:
        assert store.path == default_path() == tmp_path / "deep" / "down" / "store.sqlite"
        assert store.path.exists()


def test_a_file_that_is_no_store_is_told_with_a_remedy(tmp_path: Path) -> None:
    path = tmp_path / "store.sqlite"
    path.write_text("something else altogether, and long enough to be taken for a header of a database")
    with pytest.raises(StoredFileError, match="file is not a database; delete it to start afresh") as caught:
        Store(path)
    assert str(path) in str(caught.value)


def test_a_store_with_other_tables_is_told(tmp_path: Path) -> None:
    path = tmp_path / "store.sqlite"
    with sqlite3.connect(path) as connection:
        connection.execute("create table truths (something text)")
    connection.close()
    with Store(path) as store, pytest.raises(StoredFileError, match="no such column"):
        store.truths("v1", ["a"])


@pytest.mark.parametrize("value", ["{", "{}", '{"high": 1, "low": [], "sensitivity": [], "refusal": null}', "[]"])
def test_a_damaged_record_is_told_with_a_remedy(tmp_path: Path, value: str) -> None:
    path = tmp_path / "store.sqlite"
    with Store(path) as store:
        store.keep_truths("v1", {"a": TRUTH})
    with sqlite3.connect(path) as connection:
        connection.execute("update truths set value = ?", (value,))
    connection.close()
    with Store(path) as store, pytest.raises(StoredFileError, match=r"cannot be read.*delete it to start afresh"):
        store.truths("v1", ["a"])


def test_a_store_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StoredFileError, match=r"cannot be used: .*AFFINECERT_CACHE"):
        Store(tmp_path / "file" / "store.sqlite")
    with pytest.raises(StoredFileError, match=r"cannot be used"):
        Store(tmp_path)


CASE = Case("so3.exp", "tiny", (np.array([5e-324, -0.0, 1e308]),), 5e-324, "the smallest: θ² is 0")


def test_a_corpus_file_grows_without_repetition_and_comes_back(tmp_path: Path) -> None:
    path = tmp_path / "folder" / "so3.jsonl"
    other = Case("scale.exp", "huge", (np.array(700.0),), 700.0, "here")
    corpus.append(path, [CASE])
    corpus.append(path, [CASE, other])
    held = corpus.read(path)
    assert [case.key for case in held] == [CASE.key, other.key]
    assert held[0].inputs[0].tobytes() == CASE.inputs[0].tobytes()
    assert (held[0].regime, held[0].distance, held[0].provenance) == (CASE.regime, CASE.distance, CASE.provenance)
    assert held[1].inputs[0].shape == ()


def test_comments_and_empty_lines_are_passed_over() -> None:
    assert len(corpus.parse(f"# why\n\n{dump_line(CASE)}\n", "here")) == 1


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("{", "so3.jsonl:2: not JSON"),
        ("[]", "so3.jsonl:2: not a case"),
        ('{"map": "so3.exp"}', "so3.jsonl:2: not a case: KeyError: 'regime'"),
        (dump_line(CASE).replace("0x0.0000000000001p-1022", "0xyz"), "so3.jsonl:2: not a case: ValueError"),
        (dump_line(CASE).replace('"0x0.0000000000001p-1022", ', "[], ", 1), "so3.jsonl:2: not a case: ValueError"),
    ],
)
def test_a_damaged_line_is_told_with_its_number(tmp_path: Path, line: str, message: str) -> None:
    path = tmp_path / "so3.jsonl"
    path.write_text(f"# a comment\n{line}\n", encoding="utf-8")
    with pytest.raises(StoredFileError) as caught:
        corpus.read(path)
    assert message in str(caught.value)


def test_a_corpus_out_of_reach_is_told(tmp_path: Path) -> None:
    with pytest.raises(StoredFileError, match="cannot read the corpus file"):
        corpus.read(tmp_path / "nowhere.jsonl")
    (tmp_path / "file").write_text("")
    with pytest.raises(StoredFileError, match="cannot write the corpus file"):
        corpus.append(tmp_path / "file" / "so3.jsonl", [CASE])
    (tmp_path / "bytes.jsonl").write_bytes(b"\xff\xfe")
    with pytest.raises(StoredFileError, match="cannot read the corpus file"):
        corpus.read(tmp_path / "bytes.jsonl")


def test_the_shipped_corpus_fits_the_catalogue() -> None:
    cases = corpus.shipped()
    assert len(cases) >= 60
    assert len({case.key for case in cases}) == len(cases)
    for case in cases:
        entry = find(case.map)
        assert case.regime in {regime.name for regime in entry.regimes}, case.provenance
        assert len(case.inputs) == len(entry.arguments)
        for argument, array in zip(entry.arguments, case.inputs, strict=True):
            assert array.ndim == len(argument.shape), case.provenance
            assert array.dtype == np.float64
        assert case.provenance
    assert {case.map for case in cases} == set(CATALOGUE)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("so3.lgo", "no map is named 'so3.lgo'; did you mean so3.log"),
        ("SE3.exp", "se3.exp"),
        ("interpolate", "affine_lie.interpolate"),
        ("%", "no map is named '%'; known: affine_lie.compose"),
    ],
)
def test_unknown_maps_are_offered_the_nearest_names(name: str, message: str) -> None:
    for look_up in (find, matching):
        with pytest.raises(UnknownNameError) as caught:
            look_up(name)
        assert message in str(caught.value)
    assert isinstance(caught.value, LookupError)


def test_a_pattern_takes_the_maps_that_it_fits() -> None:
    assert [entry.name for entry in matching("so3.*")] == ["so3.exp", "so3.log", "so3.log_near"]
    assert len(matching("*")) == len(CATALOGUE)
