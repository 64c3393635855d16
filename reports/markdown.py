"""The certificate in Markdown, short enough for a pull request."""

from __future__ import annotations

import re
from collections.abc import Sequence

from affinecert.certificate import Certificate, MorphLawRecord
from affinecert.ratchet import Ratchet
from affinecert.reports import matrix, view
from affinecert.reports import ratchet as told
from affinecert.reports.templates import environment


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


def law_matrix(cells: Sequence[MorphLawRecord]) -> str:
    """The law matrix as a table, and a list of what its words mean."""
    heads = [escape(matrix.HEADS.get(name, name)) for name in matrix.columns(cells)]
    table = [
        f"| morph | {' | '.join(heads)} |",
        f"|:--|{':-:|' * len(heads)}",
        *(
            f"| {escape(row.morph)} | {' | '.join(escape(matrix.word(cell)) for cell in row.cells)} |"
            for row in matrix.rows(cells)
        ),
    ]
    legend = [f"- *{escape(name)}*: {escape(meaning)}." for name, meaning in matrix.legend(cells)]
    return "\n".join([*table, "", *legend])


def markdown(certificate: Certificate, ratchet: Ratchet | None = None) -> str:
    """The certificate as a Markdown document, with what changed against a baseline if there is one."""
    templates = environment(autoescape=False)
    templates.filters.update(escape=escape, code=code, figure=view.figure, error=view.error, tally=view.tally)
    return templates.get_template("certificate.md.jinja").render(
        certificate=certificate, ratchet=ratchet, told=told, view=view, law_matrix=law_matrix
    )
