"""Real shapes and motions to try things on: what ships in Panda3D's models, and glyphs of Matplotlib's font.

Panda3D is the extra ``examples``; its ``.egg`` files are read by its own reader, without a window.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import panda3d
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path as Outline
from matplotlib.textpath import TextPath
from numpy.typing import NDArray
from panda3d.core import Filename, LMatrix4d
from panda3d.egg import EggData, EggGroupNode, EggPolygon, EggXfmSAnim
from scipy.spatial import Delaunay

from affinecert.map import Array

MODELS = Path(panda3d.__file__).parent / "models"


class Surface(NamedTuple):
    """A surface of triangles in space: corners (faces, 3, 3)."""

    corners: Array


class Planar(NamedTuple):
    """A triangulated shape in the plane: vertices (vertices, 2) and triangles (faces, 3), positively oriented."""

    vertices: Array
    triangles: NDArray[np.int64]


def _nodes(name: str) -> Iterator[tuple[Any, str]]:
    """All nodes of a model's file, each with the name of the group that it stands in."""
    data = EggData()
    if not data.read(Filename.from_os_specific(str(MODELS / f"{name}.egg.pz"))):
        raise FileNotFoundError(MODELS / f"{name}.egg.pz")
    waiting: list[tuple[Any, str]] = [(data, "")]
    while waiting:
        node, group = waiting.pop(0)
        yield node, group
        if isinstance(node, EggGroupNode):
            waiting += [(child, node.get_name() or group) for child in node.get_children()]


def surface(name: str = "panda-model") -> Surface:
    """The surface of a model, its polygons cut into triangles; x to the right, y away, z up."""
    triangles = []
    for node, _ in _nodes(name):
        if isinstance(node, EggPolygon):
            points = [tuple(vertex.get_pos3()) for vertex in node.get_vertices()]
            triangles += [[points[0], *pair] for pair in pairwise(points[1:])]
    return Surface(np.array(triangles))


def keyframes(name: str, joint: str) -> Array:
    """The poses of a joint, frame by frame, (frames, 4, 4), of a model's animation."""
    for node, group in _nodes(name):
        if isinstance(node, EggXfmSAnim) and group == joint:
            poses, matrix = [], LMatrix4d()
            for frame in range(node.get_num_rows()):
                node.get_value(frame, matrix)
                # Panda3D's vectors are rows, ours columns.
                poses.append([[matrix.get_cell(column, row) for column in range(4)] for row in range(4)])
            return np.array(poses)
    raise LookupError(f"{name} has no joint {joint}")


def glyph(character: str, spacing: float) -> Planar:
    """A character of Matplotlib's own font, one unit wide, triangulated with about that distance between vertices."""
    path = TextPath((0, 0), character, size=100, prop=FontProperties(family="DejaVu Sans"))
    width = np.ptp(np.asarray(path.vertices)[:, 0])
    outlines = [_resampled(np.asarray(polygon) / width, spacing) for polygon in path.to_polygons()]
    boundary = np.concatenate(outlines)
    outline = Outline.make_compound_path(*map(Outline, outlines))
    low, high = boundary.min(axis=0), boundary.max(axis=0)
    rows = np.arange(low[1], high[1], spacing * np.sqrt(3) / 2)
    grid = np.concatenate(
        [
            np.column_stack([x := np.arange(low[0] + (k % 2) * spacing / 2, high[0], spacing), np.full(len(x), y)])
            for k, y in enumerate(rows)
        ]
    )
    # Grid points too near to the outline would make slivers.
    apart = np.min(np.linalg.norm(grid[:, None] - boundary[None], axis=-1), axis=1) > spacing / 2
    vertices = np.concatenate([boundary, grid[outline.contains_points(grid) & apart]])
    triangles = Delaunay(vertices).simplices.astype(np.int64)
    kept = triangles[outline.contains_points(vertices[triangles].mean(axis=1))]
    used, kept = np.unique(kept, return_inverse=True)
    triangles = kept.reshape(-1, 3)
    first, second, third = np.moveaxis(vertices[used][triangles], 1, 0)
    flat = np.cross(second - first, third - first)
    return Planar(vertices[used], np.where((flat < 0)[:, None], triangles[:, ::-1], triangles))


def _resampled(polygon: Array, spacing: float) -> Array:
    """A closed polygon's points, at equal distances along it."""
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(polygon, axis=0), axis=1))])
    count = max(round(lengths[-1] / spacing), 3)
    stations = np.linspace(0.0, lengths[-1], count, endpoint=False)
    return np.column_stack([np.interp(stations, lengths, polygon[:, axis]) for axis in (0, 1)])
