"""The certificate as one HTML page that needs nothing else: style, plots and all are inside."""

from __future__ import annotations

import re
from collections.abc import Mapping

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from affinecert.certificate import Certificate
from affinecert.reports import matrix, view
from affinecert.reports.plots import plots
from affinecert.scoring import Verdict

GLYPHS: Mapping[str, str] = {
    Verdict.OK: "●",
    Verdict.OTHER_BRANCH: "◆",
    Verdict.ABSENT: "·",
    Verdict.DEGRADED: "▲",
    Verdict.WRONG: "■",
    Verdict.NON_FINITE: "✖",
    Verdict.RAISED: "✚",
}
"""The markers of the plots, as characters."""


def anchor(*names: str) -> str:
    """A fragment identifier: letters, digits and hyphens, in the names' order; other characters by their number."""
    return "-".join(re.sub(r"[^A-Za-z0-9-]", lambda other: f"_{ord(other[0]):x}", name) for name in names)


def html(certificate: Certificate) -> str:
    """The certificate as an HTML document."""
    environment = Environment(
        loader=PackageLoader("affinecert.reports", "."),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=StrictUndefined,
    )
    environment.filters.update(figure=view.figure, error=view.error, tally=view.tally)
    maps = [
        (entry, tuple(zip(entry.results, map(Markup, plots(entry, certificate.arithmetic)), strict=True)))
        for entry in view.maps(certificate)
    ]
    template = environment.get_template("certificate.html.jinja")
    return template.render(
        certificate=certificate,
        view=view,
        matrix=matrix,
        maps=maps,
        meanings=view.MEANINGS,
        glyphs=GLYPHS,
        anchor=anchor,
    )
