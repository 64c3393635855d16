"""Seeded defects: bugs that somebody could well write, one function each, injected through a Subject.

A defect is entered by the decorator `seeded`; the modules, one a family, are imported for that.
"""

from importlib import import_module
from pkgutil import iter_modules

from .defect import DEFECTS, Defect

__all__ = ["DEFECTS", "Defect"]

for module in iter_modules(__path__):
    import_module(f"{__name__}.{module.name}")
