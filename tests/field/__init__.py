"""Bugs from the field: threads of public issue trackers, each with the formula it reports, faulty and repaired.

The inputs are in the corpus, under the name of the thread. Everything here is written anew from the descriptions.
"""

from importlib import import_module
from pkgutil import iter_modules

from .report import REPORTS, Report

__all__ = ["REPORTS", "Report"]

for module in iter_modules(__path__):
    if module.name != "__main__":
        import_module(f"{__name__}.{module.name}")
