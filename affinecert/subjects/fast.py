"""The product's own implementation, `affinecert.fast`."""

from __future__ import annotations

import importlib
from importlib.metadata import version

from affinecert.catalogue import CATALOGUE
from affinecert.subject import Subject

subject = Subject(
    name="fast",
    version=version("affinecert"),
    maps={
        name: getattr(importlib.import_module(f"affinecert.fast.{entry.family}"), name.partition(".")[2])
        for name, entry in CATALOGUE.items()
    },
)
