"""Morphs: motions from an affine pose B to an affine pose C, by the ways in which people interpolate such poses.

Every morph takes ``start`` B and ``end`` C, homogeneous (..., n, n), n = 3 in the plane and 4 in space (some know one
of them only), and ``t`` (...), any number, and gives the pose at t, (..., n, n): exactly B at t = 0 and C at t = 1.
b and c are the translations of B and C, L_X is the linear part of a pose X, and L_X = R_X S_X are its polar factors, a
rotation and a symmetric positive definite stretch. Powers and logarithms are principal; where a rotation is by pi
exactly, in the plane its angle is pi and in space the first component of its vector that is not 0 is positive.
Everything is computed in double-double arithmetic and rounded once; entries may be between 1e-140 and 1e140 in size.

Each raises InputError for a wrong shape or dtype, numbers that are not finite, a last row other than 0 ... 0 1, a
determinant of a linear part that is not positive, and for what it says besides.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from numpy.typing import ArrayLike

from affinecert.fast import sam
from affinecert.fast._kernel import Array
from affinecert.fast._logarithmic_morphs import alexa_2002, lie, sim
from affinecert.fast._polar_morphs import arap, asap, polar_exponential, rarap, shoemake_duff, sumner_2005
from affinecert.fast._rigid_morphs import dual_quaternion_linear, sclerp
from affinecert.fast._spiral_morphs import log_spiral, three_spiral
from affinecert.fast._ways import affine_way

__all__ = [
    "MORPHS",
    "alexa_2002",
    "arap",
    "asap",
    "dual_quaternion_linear",
    "lie",
    "linear",
    "log_spiral",
    "polar_exponential",
    "rarap",
    "sclerp",
    "shoemake_duff",
    "sim",
    "sumner_2005",
    "three_spiral",
]


def linear(start: ArrayLike, end: ArrayLike, t: ArrayLike) -> Array:
    """The entries in straight lines: (1 - t) B + t C.

    >>> import numpy as np
    >>> linear(np.eye(3), np.diag([3.0, 5.0, 1.0]), 0.5)
    array([[2., 0., 0.],
           [0., 3., 0.],
           [0., 0., 1.]])
    """
    way = affine_way(start, end, t)
    return way.pose(way.stretched(way.first, way.last), way.translation)


MORPHS: Mapping[str, Callable[..., Array]] = MappingProxyType(
    {
        "linear": linear,
        "shoemake_duff": shoemake_duff,
        "arap": arap,
        "rarap": rarap,
        "asap": asap,
        "alexa_2002": alexa_2002,
        "sumner_2005": sumner_2005,
        "log_spiral": log_spiral,
        "three_spiral": three_spiral,
        "lie": lie,
        "polar_exponential": polar_exponential,
        "sim": sim,
        "sclerp": sclerp,
        "dual_quaternion_linear": dual_quaternion_linear,
        "sam": sam.morph,
    }
)
"""The morphs by name, the steady one with them."""
