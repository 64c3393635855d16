"""A steady affine motion exists exactly where Culver's condition says, which in the plane is a region one can draw."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import strategies as st
from mpmath import MPContext

from affinecert.map import Array
from affinecert.properties import special, strategies
from affinecert.properties.answers import Maps, ask
from affinecert.properties.culver import Negative, negative_eigenvalues
from affinecert.properties.inexact import exact
from affinecert.properties.law import Law


def _told(maps: Maps, matrix: Array) -> bool:
    return bool(ask(maps, "sam.exists", matrix).array)


def _culver(maps: Maps, matrix: Array) -> float:
    expected = negative_eigenvalues(exact(matrix[:-1, :-1])) is not Negative.PREVENTING
    return 0.0 if _told(maps, matrix) == expected else math.inf


def in_region(linear: Array) -> bool:
    """Whether |a| < arccos(-2 s / (s^2 + 1)), that is |a| < pi / 2 + 2 arctan s, or the matrix is -r I.

    L = r R(a) R(-c) diag(1/s, s) R(c) with 0 < s <= 1: a is the angle of the rotation nearest to L, and s^2 the ratio
    of the singular values. On the border itself L has a double eigenvalue -r, and a logarithm only if it is -r I.
    """
    ctx = MPContext()
    ctx.prec = 1000  # far more than the 106 bits by which an angle off the border can miss it, times their spread
    (a, b), (c, d) = ([ctx.mpf(float(entry)) for entry in row] for row in linear)
    total, gap = ctx.hypot(a + d, c - b), ctx.hypot(a - d, c + b)  # sum and difference of the singular values
    s = ctx.sqrt((total - gap) / (total + gap))
    room = ctx.acos(-2 * s / (s * s + 1)) - abs(ctx.atan2(c - b, a + d))
    return bool(room > ctx.ldexp(1, -300)) or bool(gap == 0)


def _region(maps: Maps, matrix: Array, eigenvalue: Array, axis: Array) -> float:
    linear = matrix[:2, :2]
    third = int(axis)
    inserted = np.insert(np.insert(linear, third, 0.0, axis=0), third, 0.0, axis=1)
    inserted[third, third] = eigenvalue
    spatial = np.eye(4)
    spatial[:3, :3] = inserted
    expected = in_region(linear)
    return 0.0 if _told(maps, matrix) == _told(maps, spatial) == expected else math.inf


LAWS = (
    Law(
        name="existence.culver",
        statement="a real logarithm exists iff each negative eigenvalue is double with two independent eigenvectors",
        source="rossignac_vinacua, section 5.1 (Culver 1966)",
        domain="det L > 0, of the plane and of space",
        needs=("sam.exists",),
        inputs=strategies.inputs("sam.exists"),
        residual=_culver,
    ),
    Law(
        name="existence.region",
        statement="r R(a) R(-c) diag(1/s, s) R(c), 0 < s <= 1, has one iff |a| < arccos(-2 s / (s^2 + 1)) = "
        "pi/2 + 2 arctan s, or it is -r I; in space likewise, beside a positive eigenvalue",
        source="rossignac_vinacua, section 5.2, equation 4",
        domain="det L > 0, of the plane; in space, blocks of a planar L and a positive number",
        needs=("sam.exists",),
        inputs=st.tuples(
            special.near_the_border(), strategies.scales(), st.sampled_from([0.0, 1.0, 2.0]).map(np.array)
        ),
        residual=_region,
    ),
)
