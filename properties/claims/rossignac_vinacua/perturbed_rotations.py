"""Rotations of space with all of their entries perturbed, and which have a logarithm: the experiment of section 5.2.

The axes are the vertices of an icosahedron that is twice subdivided, on the sphere: 162, on 81 axes. To all nine
entries of the rotation -p, 0 or p is added: 19683 patterns. The paper tells neither its steps of the angle and of p nor
what it does with perturbed matrices that reverse the orientation, which there are from p = 1/3 on (1 - p at all nine
places of the identity). Those are left out here, in favour of the printed bounds.

Three symmetries save work, exactly: the icosahedron is carried to itself by the 24 signed permutations of the axes that
are even or change signs only, and these carry patterns to patterns; the opposite axis turns back. So 9 axes and turns
one way are enough; the entry rossignac_vinacua.5.2.bound_120 counts both ways.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from itertools import combinations, product

import numpy as np
from numpy.typing import NDArray

from affinecert.errors import InputError
from affinecert.reference import sam

Floats = NDArray[np.float64]

BISECTIONS = 20

RANGES: Mapping[int, tuple[tuple[float, float], tuple[float, float]]] = {
    # From which angle, by steps of which, and from which p, by steps of which, the search is to be fine. Below 1/3 a
    # bad p begins where two negative eigenvalues meet; from there on bad p can be slivers next to a determinant of 0.
    30: ((0.0, 0.5), (1 / 3, 0.001)),
    45: ((30.0, 0.02), (1 / 3, 0.0001)),
    90: ((45.0, 0.1), (1 / 3, 0.0002)),
    120: ((90.0, 1.0), (0.25, 0.005)),
}
"""The ranges of rotations, by their last angle in degrees: the first of the paper's three is in two parts."""

BEYOND = 0.5
"""The largest p."""


@cache
def vertices() -> Floats:
    """The vertices of the icosahedron that is twice subdivided, as unit vectors."""
    golden = (1 + 5**0.5) / 2
    corners = [(0.0, one, other * golden) for one in (1, -1) for other in (1, -1)]
    points = [np.roll(corner, k) / np.hypot(1, golden) for corner in corners for k in range(3)]
    edge = 2 / np.hypot(1, golden)
    faces = [
        face
        for face in combinations(range(12), 3)
        if all(np.linalg.norm(points[i] - points[j]) < 1.01 * edge for i, j in combinations(face, 2))
    ]
    for _ in range(2):
        middles: dict[tuple[int, int], int] = {}
        smaller = []
        for face in faces:
            for i, j in combinations(sorted(face), 2):
                if (i, j) not in middles:
                    middles[i, j] = len(points)
                    middle = points[i] + points[j]
                    points.append(middle / np.linalg.norm(middle))
            a, b, c = sorted(face)
            ab, ac, bc = middles[a, b], middles[a, c], middles[b, c]
            smaller += [(a, ab, ac), (b, ab, bc), (c, ac, bc), (ab, ac, bc)]
        faces = smaller
    return np.array(points)


@cache
def orbits() -> tuple[tuple[int, int], ...]:
    """One axis of each set that the symmetries carry to one another, and the size of the set."""
    axes = vertices()
    images = [np.array(signs) * np.roll(axes, k, axis=1) for signs in product((1, -1), repeat=3) for k in range(3)]
    left, found = set(range(len(axes))), []
    while left:
        first = min(left)
        orbit = {int(np.argmin(np.abs(axes - image[first]).max(axis=1))) for image in images}
        found.append((first, len(orbit)))
        left -= orbit
    return tuple(found)


@cache
def all_patterns() -> tuple[Floats, Floats, Floats, Floats]:
    """All patterns (19683, 9), and their traces, sums of principal minors, determinants."""
    patterns = np.array(list(product((-1.0, 0.0, 1.0), repeat=9)))
    return patterns, *_invariants(patterns.reshape(-1, 3, 3))


def _invariants(matrices: Floats) -> tuple[Floats, Floats, Floats]:
    trace = np.trace(matrices, axis1=-2, axis2=-1)
    minors = np.trace(_adjugates(matrices), axis1=-2, axis2=-1)
    return trace, minors, np.einsum("...i,...i->...", matrices[..., 0, :], _adjugates(matrices)[..., :, 0])


def _adjugates(matrices: Floats) -> Floats:
    columns = np.moveaxis(matrices, -1, 0)
    rows = [np.cross(columns[1], columns[2]), np.cross(columns[2], columns[0]), np.cross(columns[0], columns[1])]
    return np.stack(rows, axis=-2)


@cache
def _adjugate_patterns() -> Floats:
    return _adjugates(all_patterns()[0].reshape(-1, 3, 3)).reshape(-1, 9)


def rotation_by(axis: Floats, degrees: float) -> Floats:
    """The rotation about a unit vector."""
    x, y, z = axis
    turn = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.radians(degrees)
    return np.asarray(np.eye(3) + np.sin(angle) * turn + (1 - np.cos(angle)) * turn @ turn)


def bad_patterns(rotation: Floats, sizes: Floats) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Patterns E, and at which p of ``sizes`` R + p E has a positive determinant and no real logarithm.

    The characteristic polynomial x^3 - c2 x^2 + c1 x - c0 of R + p E is a polynomial of p too: c2 = tr R + p tr E, and
    so on, with R^-1 = R^T. There are two negative eigenvalues if, with c0 > 0, c2 or c1 is negative and the
    discriminant positive: few patterns are to be looked at closer.
    """
    patterns, trace, minors, determinant = all_patterns()
    whole = np.trace(rotation)
    first, second = whole * trace - patterns @ rotation.T.ravel(), minors
    near = np.zeros(len(patterns), dtype=bool)
    for p in np.linspace(sizes[0], sizes[-1], min(4, len(sizes))):
        near |= (whole + p * trace < 0) | (whole + p * first + p * p * second < 0)
    chosen = np.flatnonzero(near)
    p = sizes[:, None]
    c2 = whole + p * trace[chosen]
    c1 = whole + p * first[chosen] + p * p * second[chosen]
    linear, square = patterns[chosen] @ rotation.ravel(), _adjugate_patterns()[chosen] @ rotation.T.ravel()
    c0 = 1 + p * linear + p * p * square + p**3 * determinant[chosen]
    discriminant = (c2 * c2 - 4 * c1) * c1 * c1 + (18 * c1 * c2 - 4 * c2**3 - 27 * c0) * c0
    return chosen, (c0 > 0) & ((c2 < 0) | (c1 < 0)) & (discriminant > 0)


def _first_bad(rotation: Floats, sizes: Floats) -> tuple[float, float, int] | None:
    """The last good and the first bad of ``sizes``, and a pattern that is bad there."""
    chosen, bad = bad_patterns(rotation, sizes)
    rows = np.flatnonzero(bad.any(axis=1))
    if not len(rows):
        return None
    row = int(rows[0])
    pattern = int(chosen[np.flatnonzero(bad[row])[0]])
    return float(sizes[max(row - 1, 0)]), float(sizes[row]), pattern


def perturbed(rotation: Floats, pattern: int, size: float) -> Floats:
    """R + p E."""
    return np.asarray(rotation + size * all_patterns()[0][pattern].reshape(3, 3))


@dataclass(frozen=True)
class Decided:
    """The least bad p that was found, and where: the angle, the axis, the pattern; a p below that is not bad there."""

    size: float
    below: float
    degrees: float
    axis: tuple[float, ...]
    pattern: int


def _refined(rotation: Floats, pattern: int, good: float, bad: float) -> tuple[float, float]:
    """By bisection, exactly decided."""
    for _ in range(BISECTIONS):
        middle = (good + bad) / 2
        good, bad = (good, middle) if is_bad(perturbed(rotation, pattern, middle)) else (middle, bad)
    return good, bad


def is_bad(matrix: Floats) -> bool:
    """Whether a matrix keeps the orientation and has no real logarithm, decided exactly."""
    try:
        return not sam.exists_exactly(matrix.tolist())
    except InputError:
        return False


@cache
def _least(last: int) -> Decided | None:
    """The least bad p of the rotations by angles from the end of the range before to this one, if there is any."""
    (start, step), (fine, by) = RANGES[last]
    sizes = np.concatenate([np.arange(0.05, fine, 0.025), np.arange(fine, BEYOND, by)])
    found: Decided | None = None
    for degrees in np.linspace(start, last, round((last - start) / step) + 1):
        for axis, _ in orbits():
            rotation = rotation_by(vertices()[axis], float(degrees))
            first = _first_bad(rotation, sizes)
            if first is not None:
                good, bad = _refined(rotation, first[2], first[0], first[1])
                found = Decided(bad, good, float(degrees), tuple(vertices()[axis].tolist()), first[2])
                sizes = sizes[sizes < bad]
    return found


def least_bad(last: int) -> Decided:
    """The least bad p of all rotations by up to so many degrees."""
    found = filter(None, (_least(each) for each in RANGES if each <= last))
    return min(found, key=lambda decided: decided.size)
