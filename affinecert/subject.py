"""A subject: an implementation under test."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any

from affinecert.arithmetic import ARITHMETICS, Arithmetic
from affinecert.errors import SubjectError, UnknownNameError

GROUP = "affinecert.subjects"
"""The group of entry points that names subjects: affinecert's own, and those of other packages."""

SCHEMES = {"exec": "affinecert.subjects.process"}
"""What a spec may begin with instead of a module, and the module whose ``load`` makes a Subject of the rest."""


@dataclass(frozen=True)
class Subject:
    """An implementation under test: a mapping from catalogue names to callables, and its conventions in words.

    Each callable gets the map's arguments as float64 arrays with one leading batch axis, in the catalogue's
    conventions, and returns one array or a tuple of arrays with the same leading axis. The adapter converts: a library
    that wants quaternions or row vectors gets them there. A refusal is an exception, or NaN. Maps that the library
    lacks are left out.

    ``policies`` acquits documented answers outside a map's domain, such as the orthogonalising of any matrix: by words
    of the reference's reason ("not a rotation"), what the library's documentation promises there instead. Under "off
    the manifold" it says that matrices are taken as they are, not for the nearest rotation, and has them scored so (or
    "off the manifold of symmetric matrices", if that holds for these alone: see `affinecert.manifold`).

    ``refusals`` acquits documented refusals inside the domain: by words of the library's own complaint, what its
    documentation announces. Such a case is absent, as if the map ended there.

    ``dtype`` is what it computes in, float64 or float32. A float32 subject gets float32 arrays, is held against the
    truths at these very numbers, and its errors are told in units of 2^-24.

    ``snippets`` say in Python how a map is called without affinecert, with nothing but the library and NumPy: by map,
    a few lines in which ``{input0}``, ``{input1}`` ... stand for the arguments of one item as nested lists.
    """

    name: str
    version: str
    maps: Mapping[str, Callable[..., Any]]
    conventions: Mapping[str, str] = field(default_factory=dict)
    policies: Mapping[str, str] = field(default_factory=dict)
    refusals: Mapping[str, str] = field(default_factory=dict)
    dtype: str = "float64"
    snippets: Mapping[str, str] = field(default_factory=dict)

    @property
    def words(self) -> Mapping[str, str]:
        """All that its certificate should tell of it: conventions, and what is documented where it has no value."""
        policies = {f"policy, {reason}": promised for reason, promised in self.policies.items()}
        return {**self.conventions, **policies, **{f"refusal, {said}": why for said, why in self.refusals.items()}}

    @property
    def arithmetic(self) -> Arithmetic:
        """The numbers that it computes in."""
        return ARITHMETICS[self.dtype]


def named() -> Mapping[str, EntryPoint]:
    """The subjects that have names: entry points ``module:attribute``, with the extra that installs what they need."""
    return {entry.name: entry for entry in entry_points(group=GROUP)}


def load(spec: str) -> Subject:
    """The subject of that name, or the one at ``module:attribute`` (the working folder is searched too).

    Or the one that a command line runs, ``exec:./my_subject --flag`` (see `affinecert.subjects.process`).

    Raises UnknownNameError or SubjectError.
    """
    scheme, _, rest = spec.partition(":")
    if scheme in SCHEMES and scheme != spec:
        loaded: Subject = importlib.import_module(SCHEMES[scheme]).load(rest)
        return loaded
    place, hint = spec, ""
    if ":" not in spec:
        known = named()
        if spec not in known:
            raise UnknownNameError("subject", spec, (*known, "module:attribute"))
        place = f"{known[spec].module}:{known[spec].attr}"
        hint = "".join(f"; pip install 'affinecert[{extra}]' installs what it needs" for extra in known[spec].extras)
    module_name, _, attribute = place.partition(":")
    here = str(Path.cwd())
    if here not in sys.path:
        # Last: what is installed goes before its own sources, which may lie here and lack what an installation builds.
        sys.path.append(here)
    try:
        module = importlib.import_module(module_name)
    except ImportError as error:
        raise SubjectError(f"cannot import the subject {spec!r}: {error}{hint}") from error
    except Exception as error:
        raise SubjectError(f"importing the subject {spec!r} raised {type(error).__name__}: {error}") from error
    subject = getattr(module, attribute, None)
    if not isinstance(subject, Subject):
        found = f"{attribute} is a {type(subject).__name__}" if hasattr(module, attribute) else f"no {attribute}"
        raise SubjectError(f"{spec!r} is not a Subject: {module_name} has {found}")
    if subject.dtype not in ARITHMETICS:
        raise SubjectError(f"{spec!r} has the dtype {subject.dtype!r}; known: {', '.join(ARITHMETICS)}")
    return subject
