"""The README's picture: one formula's error against the distance to where it fails, beside two that do not fail.

``python -m affinecert.reports.pictures logarithms_of_rotations`` judges so3.log anew and draws it.
"""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from affinecert.arithmetic import FLOAT64
from affinecert.campaign import certify

SUBJECTS: Mapping[str, tuple[str, str, str]] = {
    "printed": ("the textbook formula", "#c2410c", "s"),
    "scipy": ("scipy Rotation", "#7c3aed", "D"),
    "fast": ("affinecert.fast", "#047857", "o"),
}
"""What is drawn: label, colour, marker."""

REGIMES = (("near-identity", "angle"), ("near-pi", "π − angle"))

LOST = 1e18
"""Errors beyond this, in u, are drawn here, infinite ones too: an answer with no right digit has about 1e16."""

FLOOR = 1e-2
"""Below a hundredth of u an answer is simply the nearest float64; it is drawn there."""


def draw() -> Figure:
    """The figure: a panel a regime, scaled error against distance, both logarithmic."""
    certificates = {name: certify(name, maps="so3.log", profile="standard") for name in SUBJECTS}
    figure = Figure(figsize=(8.6, 3.4), layout="constrained")
    panels: list[Axes] = list(figure.subplots(1, len(REGIMES), sharey=True))
    for panel, (regime, distance) in zip(panels, REGIMES, strict=True):
        for name, (label, colour, marker) in SUBJECTS.items():
            result = next(r for r in certificates[name].results if (r.map, r.regime) == ("so3.log", regime))
            points = [(d, min(max(e, FLOOR), LOST)) for d, e, _ in result.points if d > 0]
            distances, errors = zip(*points, strict=True)
            panel.scatter(distances, errors, s=14, c=colour, marker=marker, label=label, linewidths=0)
        panel.axhline(FLOAT64.lost_half, color="#94a3b8", linewidth=0.8, linestyle=(0, (4, 3)))
        panel.set(xscale="log", yscale="log", xlabel=f"{distance} (radian)", title=f"log of a rotation, {regime}")
        panel.grid(color="#e2e8f0", linewidth=0.6)
        panel.set_axisbelow(True)
    panels[0].set_ylabel("scaled error, in units of 2⁻⁵³")
    panels[0].legend(loc="upper right", frameon=True)
    panels[1].annotate(
        "half of the digits lost",
        (panels[1].get_xlim()[0], FLOAT64.lost_half),
        (3, 3),
        textcoords="offset points",
        fontsize=8,
        color="#475569",
    )
    return figure
