"""What the pictures share: colours, the bear, and how a figure is kept."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

from affinecert.map import Array
from affinecert.reports.pictures.assets import surface

FUR = np.array([0.78, 0.56, 0.36])
RED, GREEN, BLUE, GREY = "#c2410c", "#047857", "#1d4ed8", "#64748b"

LIGHT = np.array([0.55, -0.35, 0.75])


@cache
def _bear() -> tuple[Array, Array]:
    """Triangles of Panda3D's panda seen from the side, far ones first, (faces, 3, 2), and their brightness (faces,).

    Its length is 1, the origin between its feet.
    """
    corners = surface("panda-model").corners
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    order = np.argsort(corners[:, :, 0].mean(axis=1))
    lengths = np.maximum(np.linalg.norm(normals, axis=1), np.finfo(np.float64).tiny)
    brightness = 0.4 + 0.6 * np.clip(normals @ LIGHT / lengths, 0.0, 1.0)
    seen = corners[order][:, :, [1, 2]]
    width = np.ptp(seen[..., 0])
    middle = np.array([(seen[..., 0].min() + seen[..., 0].max()) / 2, 0.0])
    return (seen - middle) / width, brightness[order]


def bear(axes: Axes, pose: Array, colour: Array = FUR, opacity: float = 1.0) -> None:
    """Draws the bear in a pose of the plane, (3, 3)."""
    triangles, brightness = _bear()
    moved = triangles @ pose[:2, :2].T + pose[:2, 2]
    shades = np.column_stack([brightness[:, None] * colour, np.full(len(brightness), opacity)])
    axes.add_collection(PolyCollection(list(moved), facecolors=shades, edgecolors="none", rasterized=True))


def keep(draw: Callable[[], Figure], file: Path) -> None:
    """Draws a figure and writes it, the same bytes every time."""
    with mpl.rc_context({"font.size": 9, "svg.hashsalt": "affinecert", "svg.fonttype": "none"}):
        metadata = {"Date": None} if file.suffix == ".svg" else {"Software": None}
        draw().savefig(file, metadata=metadata, facecolor="white", dpi=110)
