"""The examples in docstrings, run under the names that users import."""

from __future__ import annotations

import doctest
import importlib
import pkgutil

import pytest

import affinecert
from affinecert.catalogue import CATALOGUE
from affinecert.properties import claims

FAMILIES = tuple(dict.fromkeys(entry.family for entry in CATALOGUE.values()))

MODULES = [found.name for found in pkgutil.iter_modules(affinecert.__path__, "affinecert.") if not found.ispkg]
CLAIMS = [found.name for found in pkgutil.walk_packages(claims.__path__, f"{claims.__name__}.") if not found.ispkg]


@pytest.mark.parametrize("name", [*MODULES, *CLAIMS, *(f"affinecert.fast.{family}" for family in FAMILIES)])
def test_examples_are_true(name: str) -> None:
    assert doctest.testmod(importlib.import_module(name)).failed == 0


def test_there_are_examples_in_every_family() -> None:
    finder = doctest.DocTestFinder()
    for family in FAMILIES:
        found = finder.find(importlib.import_module(f"affinecert.fast.{family}"))
        assert any(test.examples for test in found), family
