"""The length of the curve that a straight line of rotation vectors makes in SO(3), by Gauss and Legendre's quadrature.

With n the unit vector along the line c = p + s n, p its point nearest to the origin and rho = |p|, the length of
dexp_c n is, part along c and part across it,

    h(s)^2 = (s / theta)^2 + (rho / theta)^2 sinc(theta / 2)^2,    theta^2 = s^2 + rho^2,

and the length of the curve is the integral of h. h is analytic but at about +-2 i sin(rho / 2), if the line passes
beyond angle pi, and at places whose imaginary part is 7 or more: so panels are 4 long, and where the first are near,
the panels next to s = 0 reach from x to 3 x.
"""

from __future__ import annotations

import math

import numpy as np

from affinecert.fast._kernel import Array

NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)
"""Errs by 4.35^-32, or 3e-21, on these panels: Bernstein's ellipse is |z + sqrt(z^2 - 1)| at z = -2 + i at worst."""

WIDEST = 4.0

SHORTEST = 2.0**-30
"""Of the line's reach: a kink that is narrower than this changes the length by as little as its square."""

# 2 c_4(x), c_4 Stumpff's function: the terms 2 (-x)^j / (2j + 4)!, enough of them for x < 1.
SERIES = np.array([2.0 * (-1.0) ** j / math.factorial(2 * j + 4) for j in range(9)])


def curve_length(first: Array, second: Array) -> Array:
    """The lengths for rotation vectors (..., 3) of moderate length."""
    difference = second - first
    length = _norm(difference)
    direction = difference / np.where(length == 0.0, 1.0, length)[..., None]
    # From the end that is nearer to the origin the line is told better.
    forwards = _norm(first) <= _norm(second)
    near = np.where(forwards[..., None], first, second)
    low = np.sum(near * direction, axis=-1) - np.where(forwards, 0.0, length)
    rho = _norm(np.cross(near, direction))
    edges = _edges(low, low + length, rho)
    widths = np.diff(edges, axis=-1)
    panels = widths > 0.0
    s = edges[..., :-1][panels][:, None] + widths[panels][:, None] * ((1.0 + NODES) / 2.0)
    speed = _speed(s, np.broadcast_to(rho[..., None], panels.shape)[panels][:, None])
    parts = widths[panels] / 2.0 * np.sum(WEIGHTS * speed, axis=-1)
    item = np.broadcast_to(np.arange(length.size).reshape(*length.shape, 1), panels.shape)[panels]
    return np.asarray(np.bincount(item, parts, minlength=length.size), dtype=np.float64).reshape(length.shape)


def _norm(vector: Array) -> Array:
    """The Euclidean lengths, of tiny vectors too."""
    size = np.max(np.abs(vector), axis=-1)
    unit = np.where(size == 0.0, 1.0, size)
    return np.asarray(unit * np.sqrt(np.sum((vector / unit[..., None]) ** 2, axis=-1)))


def _edges(low: Array, high: Array, rho: Array) -> Array:
    """The panels' edges from low to high, ascending, (...) -> (..., edges); those out of reach fall on the ends."""
    nearest = np.where(rho > 3.0, 2.0 * np.abs(np.sin(rho / 2.0)), WIDEST)
    reach = np.maximum(np.abs(low), np.abs(high))
    sides = [np.zeros_like(low), np.maximum(nearest, SHORTEST * reach)]
    while (sides[-1] < reach).any():
        sides.append(np.minimum(3.0 * sides[-1], sides[-1] + WIDEST))
    right = np.stack(sides, axis=-1)
    inner = np.concatenate([-right[..., ::-1], right], axis=-1)
    return np.concatenate([low[..., None], np.clip(inner, low[..., None], high[..., None]), high[..., None]], axis=-1)


def _speed(s: Array, rho: Array) -> Array:
    """The function h. Near the origin, where its two parts are told badly, it is 1 - 2 c_4(theta^2) rho^2, squared."""
    theta = np.hypot(s, rho)
    square = np.minimum(theta, 1.0) ** 2
    central = 1.0 - rho * rho * np.polynomial.polynomial.polyval(square, SERIES)
    far = np.maximum(theta, 1.0)
    sinc = np.sin(far / 2.0) / (far / 2.0)
    return np.asarray(np.sqrt(np.where(theta < 1.0, central, (s / far) ** 2 + (rho / far * sinc) ** 2)))
