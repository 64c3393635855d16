"""All morphs side by side, for an affine pair of poses and for a rigid one.

In the affine pair the final pose is turned, sheared and stretched; in the rigid one it is only turned and moved. A
morph of space moves the plane z = 0. Where a morph does not take a pair, the picture says so.
"""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from affinecert.errors import InputError
from affinecert.fast.morphs import MORPHS
from affinecert.map import Array
from affinecert.reports.pictures.drawing import FUR, GREY, bear

TIMES = np.linspace(0.0, 1.0, 6)


def _pose(degrees: float, linear: Array, translation: tuple[float, float]) -> Array:
    angle = np.radians(degrees)
    pose = np.eye(3)
    pose[:2, :2] = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]) @ linear
    pose[:2, 2] = translation
    return pose


START = _pose(25.0, np.eye(2), (0.0, 0.0))
PAIRS = {
    "affine": (START, _pose(-80.0, np.array([[1.5, 0.5], [0.0, 0.6]]), (4.0, 0.3))),
    "rigid": (START, _pose(-85.0, np.eye(2), (4.0, 0.3))),
}

ACROSS = 2
"""Morphs in a row."""


def in_space(pose: Array) -> Array:
    """The pose of space that moves the plane z = 0 as a pose of the plane does."""
    place = [0, 1, 3]
    wide = np.eye(4)
    wide[np.ix_(place, place)] = pose
    return wide


def between(name: str, start: Array, end: Array) -> Array | None:
    """The poses of the plane at `TIMES`; None where the morph does not take the pair."""
    try:
        return MORPHS[name](start, end, TIMES)
    except InputError:
        pass
    try:
        moved = MORPHS[name](in_space(start), in_space(end), TIMES)
    except InputError:
        return None
    return moved[:, [0, 1, 3]][:, :, [0, 1, 3]]


def draw() -> Figure:
    """The figure."""
    rows = -(-len(MORPHS) // ACROSS)
    figure = Figure(figsize=(11.0, 1.7 * rows), layout="constrained")
    panels = figure.subplots(rows, ACROSS * len(PAIRS))
    for panel in panels.flat:
        panel.set(xlim=(-1.0, 5.0), ylim=(-0.9, 2.5), xticks=[], yticks=[], aspect="equal")
        panel.spines[:].set_visible(False)
    for place, name in enumerate(MORPHS):
        row, column = place % rows, place // rows * len(PAIRS)
        for panel, (kind, pair) in zip(panels[row, column:], PAIRS.items(), strict=False):
            panel.set_title(f"{name}, {kind} pair" if row == 0 else name, fontsize=8, loc="left")
            poses = between(name, *pair)
            if poses is None:
                panel.text(2.0, 0.4, f"does not take {kind} pairs", ha="center", color=GREY)
                continue
            for time, pose in zip(TIMES, poses, strict=True):
                ends = time in (0.0, 1.0)
                bear(panel, pose, FUR if ends else 0.85 * FUR + 0.12, 1.0 if ends else 0.85)
    return figure
