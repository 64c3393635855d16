"""How far the order of its vertices changes a tetrahedron's path: bansal_tatu, figure 9.

The source is a regular tetrahedron in the unit sphere. The target has its third and fourth vertex moved: along circles
on the sphere in orthogonal planes (above), along lines parallel to x and to y (below). Drawn are the maximum and the
median of the path deviation u over the pairs of the twelve orderings, `affinecert.fast.measures.path_deviation`. On
the right a bear is carried halfway by each of the orderings, for the target marked.
"""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from affinecert.errors import InputError
from affinecert.fast import affine_lie, measures
from affinecert.map import Array
from affinecert.reports.pictures.drawing import RED, bear

REACH, STEPS = 0.8, 25
MARKED = 0.7
"""Both moves of the target that the bear is shown for."""

TIMES = np.linspace(0.0, 1.0, 11)

SOURCE = np.array([[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]]) / np.sqrt(3)
"""A regular tetrahedron in the unit sphere, positively oriented."""


def _turned(vertex: Array, axis: int, angles: Array) -> Array:
    """A vertex turned about a coordinate axis, (..., 3)."""
    first, second = [k for k in range(3) if k != axis]
    moved = np.broadcast_to(vertex, (*angles.shape, 3)).copy()
    moved[..., first] = np.cos(angles) * vertex[first] - np.sin(angles) * vertex[second]
    moved[..., second] = np.sin(angles) * vertex[first] + np.cos(angles) * vertex[second]
    return moved


def along_circles(first: Array, second: Array) -> Array:
    """The tetrahedra with the third vertex turned about x and the fourth about y."""
    return _moved(_turned(SOURCE[2], 0, first), _turned(SOURCE[3], 1, second))


def along_lines(first: Array, second: Array) -> Array:
    """The tetrahedra with the third vertex moved along x and the fourth along y."""
    return _moved(SOURCE[2] + first[..., None] * np.eye(3)[0], SOURCE[3] + second[..., None] * np.eye(3)[1])


def _moved(third: Array, fourth: Array) -> Array:
    target = np.broadcast_to(SOURCE, (*third.shape[:-1], 4, 3)).copy()
    target[..., 2, :], target[..., 3, :] = third, fourth
    return target


def deviations(target: Array) -> Array:
    """The maximum and the median of u for each target, (..., 2); NaN where it is degenerate."""
    found = np.full((*target.shape[:-2], 2), np.nan)
    for index in np.ndindex(target.shape[:-2]):
        try:
            found[index] = measures.path_deviation(SOURCE, target[index], TIMES)
        except InputError:
            continue
    return found


def halfway(target: Array) -> Array:
    """The affine maps that take the source halfway to a target, by each of the orderings, (12, 4, 4)."""
    moved = affine_lie.interpolate_orderings(SOURCE, target, 0.5)
    bordered = np.concatenate([moved, np.ones((*moved.shape[:-1], 1))], axis=-1)
    return np.swapaxes(np.linalg.solve(np.column_stack([SOURCE, np.ones(4)]), bordered), -1, -2)


def draw() -> Figure:
    """The figure."""
    figure = Figure(figsize=(11.0, 6.2), layout="constrained")
    panels = figure.subplots(2, 3, width_ratios=(1, 1, 0.8))
    for row, (make, unit) in zip(panels, ((along_circles, "angle"), (along_lines, "shift")), strict=True):
        moves = np.linspace(-REACH, REACH, STEPS)
        found = deviations(make(*np.meshgrid(moves, moves, indexing="ij")))
        for column, (panel, name) in enumerate(zip(row, ("maximum", "median"), strict=False)):
            image = panel.pcolormesh(moves, moves, found[..., column].T, cmap="viridis", rasterized=True)
            figure.colorbar(image, ax=panel)
            panel.plot(MARKED, MARKED, "x", color=RED)
            panel.set(
                title=f"{name} of u over the orderings", xlabel=f"{unit} of vertex 3", ylabel=f"{unit} of vertex 4"
            )
        for pose in halfway(make(np.array(MARKED), np.array(MARKED))):
            bear(row[2], pose, opacity=0.15)
        row[2].set(xlim=(-0.7, 0.7), ylim=(-0.6, 0.8), xticks=[], yticks=[], aspect="equal")
        row[2].set_title("halfway, by the twelve orderings")
    return figure
