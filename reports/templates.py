"""The templates of the documents, and how they are filled in."""

from __future__ import annotations

from jinja2 import Environment, PackageLoader, StrictUndefined


def environment(*, autoescape: bool) -> Environment:
    """Where the templates are found; with ``autoescape`` texts are escaped as HTML."""
    return Environment(
        loader=PackageLoader("affinecert.reports", "."),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=StrictUndefined,
        autoescape=autoescape,
    )
