"""What the proofs of appendix A.1 are tried on: affine maps, their components (E, A, s), and tetrahedra.

A tetrahedron is as in section 3.4 the matrix (4, 4) of the homogeneous coordinates of its vertices, in columns.
"""

from __future__ import annotations

from itertools import islice

from affinecert.properties.claims import definitions
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity

CANONICAL: Array = exactly([[0, 1, 1, 0], [0, 0, 1, 0], [0, 0, 0, 1], [1, 1, 1, 1]])
"""The canonical tetrahedron (0,0,0), (1,0,0), (1,1,0), (0,0,1)."""

TIMES = (mp.mpf(1) / 2, mp.mpf(1) / 3, mp.mpf(3) / 4)
"""Times inside of an interpolation."""


def embedded(m: Context, linear: Array) -> Array:
    """The 3x3 matrix in the upper left block of I_4."""
    return homogeneous(m, linear, array([m.zero] * 3))


def scaling(m: Context, s: Number) -> Array:
    """S = diag(s, s, s, 1)."""
    return embedded(m, identity(m, 3) * s)


def shear(m: Context, a1: Number, a2: Number, a3: Number, a4: Number, a5: Number) -> Array:
    """The member of G_A with these parameters, (3, 3)."""
    return array([[m.one, a1, a3], [m.zero, a2, a4], [m.zero, m.zero, a5]])


def rigid(m: Context, omega: Array, d: Array) -> Array:
    """The rigid motion of the rotation vector omega and the translation d."""
    return homogeneous(m, so3.exp(m, omega), d)


def volume(tetrahedron: Array) -> Number:
    """Six times the signed volume: det[u_1 - u_0, u_2 - u_0, u_3 - u_0]."""
    return definitions.determinant((tetrahedron[:3, 1:] - tetrahedron[:3, :1]).T)


def tetrahedra(name: str, count: int) -> list[Array]:
    """The canonical tetrahedron, twice that, the unit one, and seeded ones, all oriented like it and not flat."""
    drawn = [*arrays(name, 8 * count, (3, 4), -2, 2)]
    simple = [CANONICAL[:3], CANONICAL[:3] * 2, exactly([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])]
    oriented = (solid for corners in (*simple, *drawn) if volume(solid := from_corners(corners)) >= 1)
    return list(islice(oriented, count))


def from_corners(corners: Array) -> Array:
    """The tetrahedron whose vertices are the columns of a (3, 4) matrix."""
    return array([*corners.tolist(), [mp.one] * 4])


def components(name: str, count: int) -> list[tuple[Array, Array, Number]]:
    """Components (E, A, s) of affine maps: none but a shear, a scaling, a rotation, a translation first, then seeded.

    E (4, 4) and A (3, 3); the rotations are by less than pi.
    """
    one, none = identity(mp, 4), identity(mp, 3)
    quarter = rigid(mp, exactly([0, 0, 1]) * (mp.pi / 2), exactly([1, 0, 0]))
    simple = [
        (one, shear(mp, *exactly([1, 1, 0, 0, 1])), mp.one),
        (one, none, mp.mpf(2)),
        (quarter, none, mp.one),
        (quarter, shear(mp, *exactly([1, 2, 0, 1, 3])), mp.mpf(2)),
    ]
    for k, row in enumerate(arrays(name, count, (12,), -1.5, 1.5)):
        a1, a2, a3, a4, a5 = row[6:11]
        parts = shear(mp, a1, abs(a2) + mp.mpf(1) / 2, a3, a4, abs(a5) + mp.mpf(1) / 2)
        simple.append((rigid(mp, row[:3], row[3:6]), parts, abs(row[11]) + (k + 1) / mp.mpf(2)))
    return simple[:count]


def composed(m: Context, rigid_motion: Array, sheared: Array, s: Number) -> Array:
    """T = A S E, equation 1."""
    product: Array = embedded(m, sheared) @ scaling(m, s) @ rigid_motion
    return product
