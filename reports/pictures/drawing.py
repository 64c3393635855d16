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

LIGHT = np.array([-0.35, 0.75, 0.55])


@cache
def _bear() -> Array:
    """The triangles of Panda3D's panda, (faces, 3, 3), seen from the side: y points up, z to the viewer.

    Its length is 1, the origin between its feet.
    """
    corners = surface("panda-model").corners[..., [1, 2, 0]]
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    middle = (low + high) / 2
    middle[1] = low[1]
    return np.asarray((corners - middle) / (high - low)[0])


def bear(axes: Axes, pose: Array, colour: Array = FUR, opacity: float = 1.0) -> None:
    """Draws the bear in a pose of the plane, (3, 3), or of space, (4, 4), far triangles first."""
    size = len(pose) - 1
    triangles = _bear().copy()
    triangles[..., :size] = triangles[..., :size] @ pose[:-1, :-1].T + pose[:-1, -1]
    triangles = triangles[np.argsort(triangles[..., 2].mean(axis=1))]
    # In the plane the light goes round with the bear: a turned picture stays the same picture.
    lit = triangles if size == 3 else _bear()[np.argsort(_bear()[..., 2].mean(axis=1))]
    normals = np.cross(lit[:, 1] - lit[:, 0], lit[:, 2] - lit[:, 0])
    lengths = np.maximum(np.linalg.norm(normals, axis=1), np.finfo(np.float64).tiny)
    brightness = 0.4 + 0.6 * np.clip(normals @ LIGHT / lengths, 0.0, 1.0)
    shades = np.column_stack([brightness[:, None] * colour, np.full(len(brightness), opacity)])
    seen = list(triangles[..., :2])
    axes.add_collection(PolyCollection(seen, facecolors=shades, edgecolors="none", rasterized=True))


def keep(draw: Callable[[], Figure], file: Path) -> None:
    """Draws a figure and writes it, the same bytes every time."""
    with mpl.rc_context({"font.size": 9, "svg.hashsalt": "affinecert", "svg.fonttype": "none"}):
        metadata = {"Date": None} if file.suffix == ".svg" else {"Software": None}
        draw().savefig(file, metadata=metadata, facecolor="white", dpi=110)
