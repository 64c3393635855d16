"""The pytest option ``--affinecert-subject`` of ``pytest --pyargs affinecert.properties``; loaded in every pytest run.

It stands apart from the tests' conftest, as pytest reads that of a package too late for an option.
"""

from __future__ import annotations

import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    """Adds the option."""
    parser.addoption(
        "--affinecert-subject",
        action="append",
        metavar="SUBJECT",
        help="what affinecert's laws are tried on: a built-in subject or module:attribute; may be given repeatedly",
    )
