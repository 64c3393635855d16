"""The snippets of our subjects: each is run, and prints what its adapter answers."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pytest

from affinecert.answering import answers
from affinecert.case import Case, generate, rounded, to_hex
from affinecert.catalogue import CATALOGUE
from affinecert.errors import SubjectError
from affinecert.scoring import announced
from affinecert.snippet import fill, printed
from affinecert.subject import Subject, load, named

OWN = sorted(name for name, entry in named().items() if entry.module.startswith("affinecert.subjects."))
WITHOUT = {"fast", "printed", "reference"}
"""Our own, which are no libraries of their own."""


def loaded(name: str) -> Subject:
    try:
        return load(name)
    except SubjectError as error:
        pytest.skip(str(error))


def cases(map_: str, dtype: str) -> list[Case]:
    """The first case of the first regime, and of those near a half turn or the identity."""
    entry = CATALOGUE[map_]
    chosen = [regime for k, regime in enumerate(entry.regimes) if k == 0 or regime.name in {"near-pi", "near-identity"}]
    found = [rounded(case, dtype) for regime in chosen for case in generate(entry, regime, 1)]
    return [case for case in found if case is not None]


@contextmanager
def hastily(name: str) -> Iterator[None]:
    """JAX, if it is the one, compiles without optimising, in a third of the time; the rest of the tests as before."""
    if not name.startswith("jaxlie"):
        yield
        return
    jax = importlib.import_module("jax")
    before = jax.config.read("jax_disable_most_optimizations")
    jax.config.update("jax_disable_most_optimizations", True)
    try:
        yield
    finally:
        jax.config.update("jax_disable_most_optimizations", before)
        jax.clear_caches()


@pytest.mark.parametrize("name", OWN)
def test_every_library_has_snippets_and_for_its_own_maps(name: str) -> None:
    subject = loaded(name)
    assert set(subject.snippets) <= set(subject.maps)
    assert bool(subject.snippets) != (name in WITHOUT)
    assert all(snippet.count("\n") < 4 for snippet in subject.snippets.values())


@pytest.mark.parametrize("name", sorted(set(OWN) - WITHOUT))
def test_a_snippet_prints_what_the_adapter_answers(name: str) -> None:
    subject = loaded(name)
    tolerance = 1e-12 * subject.arithmetic.unit / 2.0**-53
    tried = [(map_, case) for map_ in subject.snippets for case in cases(map_, subject.dtype)]
    with hastily(name):
        for map_, case in tried:
            # Two of a kind, for a library may have other code for a batch than for one item.
            answer = answers(subject, [case, case])[0]
            if announced(answer.complaint or "", subject.refusals):
                continue
            assert answer.outputs is not None, (map_, case.regime, answer.complaint)
            values = printed(fill(subject.snippets[map_], [to_hex(array) for array in case.inputs], map_))
            for value, output in zip(values if len(answer.outputs) > 1 else [values], answer.outputs, strict=True):
                assert np.shape(value) == output.shape, (map_, case.regime)
                np.testing.assert_allclose(
                    value, output, rtol=0, atol=tolerance * np.max(np.abs(output)), err_msg=f"{map_}, {case.regime}"
                )
