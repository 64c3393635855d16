"""The certificate in Markdown, short enough for a pull request."""

from __future__ import annotations

import re

from jinja2 import Environment, PackageLoader, StrictUndefined

from affinecert.certificate import Certificate
from affinecert.reports import view


def escape(text: str) -> str:
    """Text that Markdown shows as it is, in one line: nothing in it ends a table's cell or is taken for HTML."""
    line = " ".join(text.split()).replace("&", "&amp;").replace("<", "&lt;")
    return re.sub(r"([\\`*_\[\]|~])", r"\\\1", line)


def code(text: str) -> str:
    """Text as inline code, whatever backticks it holds; a bar would end a table's cell, so it is escaped."""
    longest = max(map(len, re.findall("`+", text)), default=0)
    fence = "`" * (longest + 1)
    line = " ".join(text.split()).replace("|", "\\|")
    return f"{fence} {line} {fence}" if longest else f"`{line}`"


def markdown(certificate: Certificate) -> str:
    """The certificate as a Markdown document."""
    environment = Environment(
        loader=PackageLoader("affinecert.reports", "."),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=StrictUndefined,
        autoescape=False,
    )
    environment.filters.update(escape=escape, code=code, figure=view.figure, error=view.error, tally=view.tally)
    return environment.get_template("certificate.md.jinja").render(certificate=certificate, view=view)
