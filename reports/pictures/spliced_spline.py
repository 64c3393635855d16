"""A spliced spline against the one through the wrong logarithms: gallier, figures 5 to 7, on a character's keyframes.

The keys are every third frame of a joint of Panda3D's walking panda. Its rotation passes through pi, where the
principal logarithm jumps. Drawn are the way of a point that the joint carries, and the speed at which its frame turns:
through principal logarithms it swings round wildly, by `affinecert.fast.splines.motion` (figure 5) it does not, and by
`smooth_motion` its velocity has no jumps either.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d import Axes3D

from affinecert.fast import so3, splines
from affinecert.map import Array
from affinecert.reports.pictures.assets import keyframes
from affinecert.reports.pictures.drawing import BLUE, GREEN, GREY, RED

EVERY = 3

STEPS = 60
"""Times a span."""

Motion = Callable[[Array, Array], Array]

MOTIONS: tuple[tuple[str, Motion, Callable[[Array], Array], str], ...] = (
    ("principal logarithms, one spline", splines.principal_motion, lambda keys: np.arange(1.0 * len(keys)), RED),
    ("nearest logarithms, spliced", splines.motion, splines.key_times, BLUE),
    ("spliced, C² on the group", splines.smooth_motion, splines.key_times, GREEN),
)
"""What is drawn: label, motion, the times of the keys, colour."""


def draw() -> Figure:
    """The figure."""
    keys = keyframes("panda-walk", "null1")[::EVERY]
    keys[:, :3, 3] -= keys[:, :3, 3].mean(axis=0)
    numbers = np.linspace(0.0, len(keys) - 1.0, STEPS * (len(keys) - 1) + 1)
    figure = Figure(figsize=(9.6, 4.4), layout="constrained")
    left = figure.add_subplot(1, 2, 1, projection="3d")
    right = figure.add_subplot(1, 2, 2)
    assert isinstance(left, Axes3D)
    scale = np.ptp(keys[:, :3, 3])
    for label, motion, key_times, colour in MOTIONS:
        poses = motion(keys, np.interp(numbers, np.arange(len(keys)), key_times(keys)))
        way = poses[:, :3, 3] + scale * poses[:, :3, 0]
        left.plot(*way.T, color=colour, linewidth=1.4, label=label)
        steps = so3.log(np.swapaxes(poses[:-1, :3, :3], -1, -2) @ poses[1:, :3, :3])
        speed = np.degrees(np.linalg.norm(steps, axis=-1)) * STEPS
        right.plot((numbers[1:] + numbers[:-1]) / 2, speed, color=colour, linewidth=1.2, label=label)
    ends = keys[:, :3, 3] + scale * keys[:, :3, 0]
    left.scatter(*ends.T, color=GREY, s=14)
    left.set_title("the way of a point of the joint")
    right.set(xlabel="key", ylabel="degrees a key", title="how fast the joint turns")
    right.legend()
    right.grid(color="#e2e8f0", linewidth=0.6)
    return figure
