"""A triangulated shape interpolated by two energies: kaji_2d, figures 2 to 5.

The shape is an arrow of Matplotlib's font. Above, it rolls up into a spiral, whose triangles turn by up to one and a
half turns: E^F takes every angle modulo 2 pi, E^R finds the turns by itself. Below, it is bent with its tip led
along a curve: E^F pays for every turn that the curve asks for with shrinking, E^R does not.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from affinecert.fast import mesh2
from affinecert.map import Array
from affinecert.reports.pictures.assets import Planar, glyph
from affinecert.reports.pictures.drawing import BLUE, RED

TIMES = np.linspace(0.0, 1.0, 6)
SPACING = 0.02
ENERGIES: Mapping[mesh2.Energy, str] = {"frobenius": "E^F", "similarity": "E^R"}


def arrow() -> Planar:
    """The arrow ⟶, one unit long, lying along the x axis from the origin."""
    shape = glyph("\N{LONG RIGHTWARDS ARROW}", SPACING)
    low, high = shape.vertices.min(axis=0), shape.vertices.max(axis=0)
    return shape._replace(vertices=shape.vertices - [low[0], (low[1] + high[1]) / 2])


def rolled(vertices: Array, turns: float = 1.5) -> Array:
    """The points along a spiral, which at the arrow's tip has made so many turns."""
    stations = np.linspace(0.0, 1.2, 2001)
    # The curvature falls to 0 along the arrow, so that the rings lie inside one another and its head stays whole.
    heading = 2 * np.pi * turns * (2 * stations - stations**2)
    step = stations[1] - stations[0]
    spine = np.concatenate([[[0.0, 0.0]], np.cumsum(np.column_stack([np.cos(heading), np.sin(heading)]), axis=0)[:-1]])
    spine *= step
    along = [np.interp(vertices[:, 0], stations, column) for column in (*spine.T, heading)]
    normal = np.column_stack([-np.sin(along[2]), np.cos(along[2])])
    return np.asarray(np.column_stack(along[:2]) + vertices[:, 1:] * normal)


def _strip(panel: Axes, shape: Planar, frames: Array, colour: str) -> None:
    for place, frame in enumerate(frames):
        x, y = (frame - frame.mean(axis=0)).T
        panel.triplot(x + 1.15 * place, y, shape.triangles, color=colour, linewidth=0.4, rasterized=True)
    panel.set(xticks=[], yticks=[], aspect="equal")
    panel.spines[:].set_visible(False)


def _led(start: Array, end: Array) -> Callable[[float], Array]:
    """A path from one point to another that loops on its way."""
    aside = np.array([-(end - start)[1], (end - start)[0]])
    return lambda t: start + t * (end - start) + 0.8 * np.sin(2 * np.pi * t) * aside


def draw() -> Figure:
    """The figure."""
    shape = arrow()
    spiral = rolled(shape.vertices)
    bent = rolled(shape.vertices, 0.4)
    tip, tail = int(np.argmax(shape.vertices[:, 0])), int(np.argmin(shape.vertices[:, 0]))
    constraints = [
        mesh2.Locus(tip, _led(shape.vertices[tip], bent[tip]), 10.0),
        mesh2.Locus(tail, _led(shape.vertices[tail], bent[tail]), 10.0),
    ]
    figure = Figure(figsize=(9.0, 6.6), layout="constrained")
    panels = figure.subplots(4, 1)
    for panel, (energy, symbol) in zip(panels, ENERGIES.items(), strict=False):
        frames = mesh2.interpolate(shape.vertices, spiral, shape.triangles, TIMES, energy=energy)
        _strip(panel, shape, frames, RED if energy == "frobenius" else BLUE)
        panel.set_ylabel(f"{symbol}, to a spiral", rotation=0, ha="right", va="center")
    for panel, (energy, symbol) in zip(panels[2:], ENERGIES.items(), strict=True):
        frames = mesh2.interpolate(shape.vertices, bent, shape.triangles, TIMES, energy=energy, constraints=constraints)
        _strip(panel, shape, frames, RED if energy == "frobenius" else BLUE)
        panel.set_ylabel(f"{symbol}, both ends led", rotation=0, ha="right", va="center")
    return figure
