"""Morphs by polar factors, those of both poses or those of the way between them: see `affinecert.fast.morphs`."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from affinecert.fast import _turns
from affinecert.fast import _wide as wide
from affinecert.fast._kernel import Array
from affinecert.fast._ways import Way, affine_way, mixed
from affinecert.fast._wide_polar import polar
from affinecert.fast._wide_symmetric import symmetric_exponential, symmetric_logarithm, symmetric_power


def shoemake_duff(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """R_B (R_B^T R_C)^t ((1 - t) S_B + t S_C); the translation in a straight line.

    Shoemake and Duff, Matrix animation and polar decomposition (1992).
    """
    way = affine_way(start, end, t)
    (first, first_stretch), (last, last_stretch) = polar(way.first), polar(way.last)
    turned = wide.product(first, _turns.power(wide.product(wide.transposed(first), last), way.t))
    return way.pose(wide.product(turned, way.stretched(first_stretch, last_stretch)), way.translation)


def arap(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """R^t ((1 - t) I + t S) L_B, where R S = L_C L_B^-1; the origin moves in a straight line.

    Alexa, Cohen-Or and Levin, As-rigid-as-possible shape interpolation (2000): the origin is the first vertex of the
    standard simplex, which stands for theirs.
    """
    way = affine_way(start, end, t)
    return way.pose(_rigid_as_possible(way), way.translation)


def rarap(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The linear part of `arap`; the barycentre of the standard simplex 0, e_1, ..., e_n moves in a straight line.

    Rossignac and Vinacua, section 2.4 (b).
    """
    way = affine_way(start, end, t)
    return way.about_barycentre(_rigid_as_possible(way))


def asap(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """R^t S^t L_B, where R S = L_C L_B^-1; the barycentre of the standard simplex moves in a straight line.

    Rossignac and Vinacua, section 3.3.2; Kaji and others, equation 3, for the linear part.
    """
    way = affine_way(start, end, t)
    rotation, stretch = polar(wide.right_quotient(way.last, way.first))
    grown = wide.product(symmetric_power(stretch, way.t), way.first)
    return way.about_barycentre(wide.product(_turns.power(rotation, way.t), grown))


def sumner_2005(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """exp((1 - t) log R_B + t log R_C) ((1 - t) S_B + t S_C); the translation in a straight line.

    Sumner, Zwicker, Gotsman and Popovic, Mesh-based inverse kinematics (2005).
    """
    way = affine_way(start, end, t)
    (first, first_stretch), (last, last_stretch) = polar(way.first), polar(way.last)
    stretch = way.stretched(first_stretch, last_stretch)
    return way.pose(wide.product(_mixed_turns(way, first, last), stretch), way.translation)


def polar_exponential(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """exp((1 - t) log R_B + t log R_C) exp((1 - t) log S_B + t log S_C); the translation in a straight line.

    Kaji and Ochiai, equation 9, for two poses. In the plane log R is the angle.
    """
    way = affine_way(start, end, t)
    (first, first_stretch), (last, last_stretch) = polar(way.first), polar(way.last)
    logs = symmetric_logarithm(first_stretch), symmetric_logarithm(last_stretch)
    stretch = symmetric_exponential(way.stretched(*logs))
    return way.pose(wide.product(_mixed_turns(way, first, last), stretch), way.translation)


def _rigid_as_possible(way: Way) -> Array:
    """The linear part of `arap`."""
    rotation, stretch = polar(wide.right_quotient(way.last, way.first))
    grown = way.stretched(wide.widen(np.eye(stretch.shape[-2])), stretch)
    return wide.product(_turns.power(rotation, way.t), wide.product(grown, way.first))


def _mixed_turns(way: Way, first: Array, last: Array) -> Array:
    """The rotation exp((1 - t) log R_B + t log R_C)."""
    return _turns.exponential(mixed(_turns.logarithm(first), _turns.logarithm(last), way.t[..., None]))
