"""The conditions (I) to (V) of section 1 and the properties of table 2, tried on a parametrisation."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache, partial
from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.kaji_ochiai import charts
from affinecert.properties.claims.kaji_ochiai.charts import PARAMETRISATIONS, Parametrisation
from affinecert.properties.claims.kaji_ochiai.drawbacks import FACTORS
from affinecert.properties.claims.kaji_ochiai.subspaces import CLASSES, members, outside
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.properties.laws.subclasses import Subclass
from affinecert.reference import so3
from affinecert.reference._matrices import Array, Number, array, homogeneous, identity

SAME = mp.mpf(10) ** -40
"""What differs by less is the same: twenty digits more than singular values here need to be told from 0."""

STEP = mp.mpf(10) ** -25


def _linear_parts(group: Subclass) -> list[Any]:
    """The identity, half turns, the quarter turn about y (gimbal lock); of Aff+(3) also maps with stretches."""
    turns: list[Any] = [
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[1, 0, 0], [0, -1, 0], [0, 0, -1]],
        [[0, 1, 0], [1, 0, 0], [0, 0, -1]],
        [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
    ]
    if group.stretch == charts.ROTATIONS.stretch:
        return [*turns, *(each.tolist() for each in rotations("compared", 2))]
    stretched = [
        [[-1, 0, 0], [0, -2, 0], [0, 0, 1]],
        [[0, 0, 1], [0, 2, 0], [-3, 0, 0]],
        [[1, 3, 0], [0, 1, 0], [0, 0, 1]],
        [[2, -1, 0.5], [1, 1, -0.5], [0, 0.25, 1.5]],
    ]
    return [turns[0], stretched[0], turns[2], *stretched[1:]]


@cache
def _elements(group: Subclass) -> tuple[Array, ...]:
    """Elements of a group, by which all its parametrisations are tried."""
    linears = [exactly(each) for each in _linear_parts(group)]
    shifts = arrays("compared shifts", len(linears), (3,), -2, 2) if group.moves else [charts.ORIGIN] * len(linears)
    return tuple(homogeneous(mp, linear, shift) for linear, shift in zip(linears, shifts, strict=True))


def _is_member(found: Array, group: Subclass) -> bool:
    """Whether a homogeneous matrix is one of a group, or of a class of maps."""
    return bool(outside(found, group) < SAME and definitions.determinant(found[:3, :3]) > SAME)


def _lands(own: Parametrisation, parameters: Array) -> bool:
    """Whether phi has a value, and that in the group."""
    try:
        return _is_member(own.phi(mp, parameters), own.group)
    except ZeroDivisionError:
        return False


def _parameters(own: Parametrisation) -> list[Array]:
    return [found for each in _elements(own.group) if (found := own.psi(mp, each)) is not None]


def _differential(function: Callable[[Array], Array], at: Array) -> Array:
    """The partial derivatives of a function of several numbers, a row each, to 45 digits."""
    steps = identity(mp, len(at)) * STEP
    return array([((function(at + step) - function(at - step)) / (2 * STEP)).reshape(-1) for step in steps])


def _rank(rows: Array) -> int:
    """The number of rows that are left by elimination with the greatest pivots."""
    rows, rank = rows.copy(), 0
    while rows.size and size(rows) > mp.mpf(10) ** -20:
        row, column = np.unravel_index(np.argmax(np.abs(rows)), rows.shape)
        pivot = rows[row]
        rest = np.delete(rows, row, axis=0)
        rows, rank = rest - np.outer(rest[:, column] / pivot[column], pivot), rank + 1
    return rank


@cache
def _ranks(name: str) -> tuple[tuple[int, int] | None, ...]:
    """At each element the dimension of the parameters, and the rank of the differential of phi; None without psi."""
    own = PARAMETRISATIONS[name]
    found: list[tuple[int, int] | None] = []
    for element in _elements(own.group):
        at = own.psi(mp, element)
        if at is None or difference(own.phi(mp, at), element) > SAME:
            found.append(None)
            continue
        bound = _differential(own.constraint, at)
        both = np.concatenate([_differential(lambda p: own.phi(mp, p), at), bound], axis=1)
        constraints = _rank(bound)
        # On the tangents of the constraint, its kernel, phi has the rank by which it adds to it.
        found.append((own.count - constraints, _rank(both) - constraints))
    return tuple(found)


def dimensions(own: Parametrisation) -> tuple[int, int]:
    """The dimensions of the parameters and of the group, as far as they reach it."""
    ranks = [each for each in _ranks(own.name) if each is not None]
    return max(space for space, _ in ranks), max(rank for _, rank in ranks)


def _euclidean(own: Parametrisation) -> bool:
    """(I): sums and multiples of parameters are parameters, of maps of the group."""
    given = _parameters(own)
    sums = [p * factor for p in given for factor in (0, -1, 2)] + [p + q for p in given for q in given]
    return all(_lands(own, each) for each in sums)


def _differentiable(own: Parametrisation) -> bool:
    """(II): phi grows by its differential in every direction, up to what is small of second order."""
    h = mp.mpf(10) ** -12
    for at, direction in zip(_parameters(own)[:3], arrays("directions", 3, (own.count,), -1, 1), strict=True):
        rate = (direction @ _differential(lambda p: own.phi(mp, p), at)).reshape(4, 4)
        growths = [own.phi(mp, at + direction * step) - own.phi(mp, at) - rate * step for step in (h, -h)]
        if size(growths) > 1000 * h**2:
            return False
    return True


def _surjective(own: Parametrisation) -> bool:
    """(III): every element of the group has a parameter where the differential of phi has full rank.

    Without full rank no inverse is differentiable there: the differential of phi psi is that of the identity. Euler
    angles are tried at one parameter only, for the rank depends on the angle in the middle, which the rotation tells.
    """
    freedom = dimensions(own)[1]
    return all(each is not None and each[1] == freedom for each in _ranks(own.name))


def _same_dimension(own: Parametrisation) -> bool:
    """(IV): the parameters have the dimension of the group."""
    space, group = dimensions(own)
    return space == group


def _within(group: Subclass) -> Iterator[tuple[list[Array], Callable[[Array], bool]]]:
    """Members of the classes in a group and whether a matrix is one; of the rotations, those about a slanted axis."""
    if group == charts.ROTATIONS:
        axis = exactly([1, 2, 2])
        turns = [homogeneous(mp, so3.exp(mp, axis * angle), charts.ORIGIN) for angle in exactly([0.25, 0.5, 0.875])]
        yield turns, lambda found: size(found[:3, :3] @ axis - axis) < SAME
        return
    for own in (CLASSES["SO(3)"], CLASSES["R^3"]) if group == charts.MOTIONS else CLASSES.values():
        yield members(own, 3), partial(_is_member, group=own)


def _subclasses(own: Parametrisation) -> bool:
    """(V): phi takes the linear subspace that is spanned by parameters of members of a class into the class.

    The origin, of which (I) tells, is not tried. Whether phi reaches all of the class is told by (III).
    """
    for given, is_member in _within(own.group):
        spanning = [found for each in given if (found := own.psi(mp, each)) is not None]
        for weights in exactly([[1, 1, 1], [2, -1, 0.5], [-3, 0.5, 1]]):
            found = own.phi(mp, weights[: len(spanning)] @ array(spanning))
            if not (_is_member(found, own.group) and is_member(found)):
                return False
    return True


def _extrapolates(own: Parametrisation) -> bool:
    """Joins of two parameters, with weights 1 - t and t for any t, are of maps of the group."""
    given = _parameters(own)
    joined = [own.between(mp, p, q, t) for p, q in pairwise(given) for t in exactly([0.5, -2, 3])]
    return all(_lands(own, each) for each in joined)


def _associative(own: Parametrisation) -> bool:
    """The a-multiple of the b-multiple is the ab-multiple; multiples join the identity to a map, with weight a.

    For a turn by 3/4 after, in Aff+(3), a stretch, and for b-multiples that are in the group.
    """
    turn = so3.exp(mp, exactly([0.25, 0.5, 0.5]))
    linear = turn @ exactly([[3, 0, 0], [0, 3, 0], [0, 0, 1]]) if own.group == charts.AFFINE else turn
    psi: Callable[..., Any] = own.psi  # what is tried has parameters
    unit = psi(mp, identity(mp, 4))

    def multiple(factor: Number, affine: Array) -> Array:
        return own.phi(mp, own.between(mp, unit, psi(mp, affine), factor))

    given = homogeneous(mp, linear, exactly([1, 0, 2]) if own.group.moves else charts.ORIGIN)
    inner = [(a, b, multiple(b, given)) for a, b in FACTORS]
    tried = [each for each in inner if _is_member(each[2], own.group)]
    return all(difference(multiple(a, found), multiple(a * b, given)) < SAME for a, b, found in tried)


def _tells_whole_turns(own: Parametrisation) -> bool:
    """Section 4.3: the identity and whole turns about x and y are three parameters (of one map)."""
    x, y = exactly([1, 0, 0]), exactly([0, 1, 0])
    ends = [own.turn(mp, x, mp.zero), own.turn(mp, x, 2 * mp.pi), own.turn(mp, y, 2 * mp.pi)]
    apart = min(difference(ends[j], ends[k]) for j, k in ((0, 1), (0, 2), (1, 2)))
    return bool(apart > 1 and max(difference(own.phi(mp, end), identity(mp, 4)) for end in ends) < SAME)


COLUMNS: Mapping[str, Callable[[Parametrisation], bool]] = {
    "(I) Euclidean": _euclidean,
    "(II) differentiable": _differentiable,
    "(III) surjective with a local inverse": _surjective,
    "(IV) same dimension": _same_dimension,
    "(V) subclasses": _subclasses,
    "extrapolation": _extrapolates,
    "associativity": _associative,
    "large rotation": _tells_whole_turns,
}
"""The properties, and whether a parametrisation has them by their definitions."""
