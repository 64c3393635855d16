"""Where a steady morph exists, in the plane: rossignac_vinacua, figure 6, with what it means for a shape.

L = R(a) diag(1/s, s) turns by a and squeezes to s. Every point is decided by `affinecert.fast.sam.exists`; the border
of equation 4 and the trapezoid |a| < (1 + s) pi/2 are drawn over it. The bears are posed by L^(1/2): halfway, where
there is such a thing.
"""

from __future__ import annotations

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure

from affinecert.fast import sam
from affinecert.map import Array
from affinecert.reports.pictures.drawing import BLUE, GREEN, bear

ANGLES, SQUEEZES = 601, 301

SHOWN = [(a, s) for s in (0.32, 0.58, 0.85) for a in (-2.7, -1.8, -0.9, 0.0, 0.9, 1.8, 2.7)]
"""Where a bear stands."""

SIZE = 0.62


def affine(angle: Array, squeeze: Array) -> Array:
    """The affine maps (..., 3, 3) with linear part R(a) diag(1/s, s)."""
    cosine, sine = np.cos(angle), np.sin(angle)
    zero, one = np.zeros_like(angle * squeeze), np.ones_like(angle * squeeze)
    rows = [
        [cosine / squeeze, -sine * squeeze, zero],
        [sine / squeeze, cosine * squeeze, zero],
        [zero, zero, one],
    ]
    return np.stack([np.stack(np.broadcast_arrays(*row), axis=-1) for row in rows], axis=-2)


def draw() -> Figure:
    """The figure."""
    angles = np.linspace(-np.pi, np.pi, ANGLES)
    squeezes = np.linspace(0.0, 1.0, SQUEEZES + 1)[1:]
    exists = sam.exists(affine(angles[None, :], squeezes[:, None]))
    figure = Figure(figsize=(8.6, 4.4), layout="constrained")
    axes = figure.subplots()
    axes.pcolormesh(angles, squeezes, exists, cmap=ListedColormap(["#fecaca", "#f0fdf4"]), rasterized=True)
    axes.plot(np.arccos(-2 * squeezes / (squeezes**2 + 1)), squeezes, color=GREEN, label="|a| = arccos(−2s/(s² + 1))")
    axes.plot(-np.arccos(-2 * squeezes / (squeezes**2 + 1)), squeezes, color=GREEN)
    trapezoid = (1 + squeezes) * np.pi / 2
    axes.plot(trapezoid, squeezes, color=BLUE, linestyle="--", label="|a| = (1 + s) π/2")
    axes.plot(-trapezoid, squeezes, color=BLUE, linestyle="--")
    for angle, squeeze in SHOWN:
        whole = affine(np.array(angle), np.array(squeeze))
        if sam.exists(whole):
            pose = sam.power(whole, 0.5)
            shape = np.diag([SIZE, SIZE * 0.32, 1.0]) @ pose
            shape[:2, 2] = angle, squeeze - 0.05
            bear(axes, shape)
    axes.set(
        xlim=(-np.pi, np.pi),
        ylim=(0, 1),
        xlabel="angle a (radian)",
        ylabel="singular value s, the other is 1/s",
        title="Where A^t is real (green) for L = R(a) diag(1/s, s), decided exactly; bears stand halfway",
    )
    axes.legend(loc="lower left", framealpha=0.9, fontsize=8)
    return figure
