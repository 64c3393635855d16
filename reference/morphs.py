"""Morphs: motions from an affine pose B to an affine pose C, by the ways in which people interpolate such poses.

Every morph takes ``start`` B and ``end`` C, homogeneous (n, n), n = 3 in the plane and 4 in space (some know one of
them only), and ``t``, any real number, and gives the pose at t: B at 0 and C at 1. b and c are the translations of B
and C, L_X is the linear part of a pose X, and L_X = R_X S_X are its polar factors, a rotation and a symmetric positive
definite stretch. Powers and logarithms are principal; where a rotation is by pi exactly, in the plane its angle is pi
and in space the first non-zero component of its vector is positive. Given ``near``, of the values on the branches on
both sides of pi the one nearest to it is taken: so a morph is continued through pi. Each raises InputError if a last
row is not 0 ... 0 1 or the determinant of a linear part is not positive, and for what it says besides.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from affinecert.reference import _ways, sam
from affinecert.reference._branches import continued
from affinecert.reference._logarithmic_morphs import alexa_2002, lie, sim
from affinecert.reference._matrices import Array, Context
from affinecert.reference._polar_morphs import arap, asap, polar_exponential, rarap, shoemake_duff, sumner_2005
from affinecert.reference._rigid_morphs import dual_quaternion_linear, sclerp
from affinecert.reference._spiral_morphs import log_spiral, three_spiral

__all__ = [
    "CONTINUATIONS",
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


def linear(ctx: Context, start: Array, end: Array, t: Array) -> Array:
    """The entries in straight lines: (1 - t) B + t C."""
    with _ways.affine(ctx, start, end, t):
        return _ways.mixed(start, end, t)


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

CONTINUATIONS: Mapping[str, Callable[..., Array]] = MappingProxyType(
    {name: continued(morph) for name, morph in MORPHS.items() if name not in {"linear", "sam"}}
)
"""The morphs that are continued, as maps of the value that they are to stay near, and of their inputs."""
