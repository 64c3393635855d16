"""Sections 1 and 2.1: what affinities are, what they preserve, and how they are specified."""

from __future__ import annotations

from functools import reduce
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import difference, distance, equals, exactly, mp, size
from affinecert.reference._matrices import Array, Context, Number, array, dot, identity


def _image(m: Context, affinity: Array, point: Array) -> Array:
    """The image of a point, by homogeneous coordinates."""
    moved: Array = (affinity @ np.append(point, m.one))[:-1]
    return moved


def _projective(m: Context, affinity: Array, point: Array) -> Array:
    """The image under a projective map next to the affinity: points are divided by 1 + x / 64."""
    found: Array = _image(m, affinity, point) / (1 + point[0] / 64)
    return found


def _matrices(name: str, count: int) -> list[Array]:
    """Affinities of space."""
    return [affine(each[:, :3] + 3 * np.eye(3), each[:, 3]) for each in arrays(name, count, (3, 4), -2, 2)]


def _with_points(count: int) -> Any:
    """Affinities of space with so many points each."""

    def cases() -> list[tuple[Array, ...]]:
        points = arrays("points of affinities", 5, (count, 3), -2, 2)
        return [(matrix, *each) for matrix, each in zip(_matrices("affinities", 5), points, strict=True)]

    return cases


def _ratio_lost(form: Any, case: tuple[Array, ...]) -> Number:
    """How far the image of p + s (q - p) is from the point of the same ratio, for s inside and outside of pq."""
    affinity, p, q = case
    first, last = form(mp, affinity, p), form(mp, affinity, q)
    times = exactly([0.25, 2, -1])
    return max(difference(form(mp, affinity, p + (q - p) * s), first + (last - first) * s) for s in times)


def _angle_of_parallels(form: Any, case: tuple[Array, ...]) -> Number:
    """The squared sine of the angle between the images of two parallel lines."""
    affinity, p, q, shift = case
    a, b = (form(mp, affinity, q + each) - form(mp, affinity, p + each) for each in (0 * shift, shift))
    return 1 - dot(mp, a, b) ** 2 / (dot(mp, a, a) * dot(mp, b, b))


def _kept(form: Array, case: tuple[Array, Array]) -> Number:
    """1 if the matrix keeps the scalar product or the lengths of two vectors."""
    a, b = case
    kept = [dot(mp, form @ x, form @ y) == dot(mp, x, y) for x, y in ((a, b), (a, a), (b, b))]
    return mp.mpf(kept[0] or (kept[1] and kept[2]))


def _quadruple(m: Context, affinity: Array, vectors: bool = True) -> Array:
    """[i j k | t], from the images of the origin and of the points e_1, e_2, e_3."""
    origin = _image(m, affinity, array([m.zero] * 3))
    ends = [_image(m, affinity, each) for each in identity(m, 3)]
    return array([*(end - origin if vectors else end for end in ends), origin]).T


def _frame(points: Array, origin: int = 1) -> Array:
    """The pose [s0 s1, s0 s2, ... | s0] of points in rows; with ``origin`` 0 of the vectors s1, s2, ... instead."""
    return affine((points[1:] - origin * points[0]).T, points[0])


def _by_frames(m: Context, sources: Array, targets: Array) -> Array:
    found: Array = _frame(targets) @ definitions.inverse(m, _frame(sources))
    return found


def _misses(form: Any, case: tuple[Array, Array]) -> Number:
    """The largest distance of the images of points from where they should be."""
    sources, targets = case
    affinity = form(mp, sources, targets)
    return max(distance(_image(mp, affinity, s), f) for s, f in zip(sources, targets, strict=True))


def _point_pairs() -> list[tuple[Array, Array]]:
    simplex = np.concatenate([exactly([[0, 0, 0]]), identity(mp, 3)])
    drawn = [(a, b) for a, b in arrays("pairs of points", 4, (2, 4, 3), -2, 2)]
    return [(simplex, drawn[0][1]), *drawn[1:]]


def _linearly(points: Array) -> bool:
    return bool(definitions.determinant(points @ points.T) != 0)


def _affinely(points: Array) -> bool:
    return _linearly(points[1:] - points[0])


def _misjudged(form: Any, points: Array) -> Number:
    """Whether a test says other than that the equations f_i = A(s_i) have one solution whatever the f_i."""
    bordered = np.concatenate([points, np.ones((len(points), 1), dtype=int)], axis=1)
    return mp.mpf(form(points) != (definitions.determinant(bordered) != 0))


def _point_sets() -> list[Array]:
    sets = [[[0], [1]], [[1], [1]], [[0, 0], [1, 0], [0, 1]], [[1, 1], [2, 2], [3, 3]], [[1, 0], [0, 1], [-2, 5]]]
    return [array(each) for each in sets]


def _system(points: Array) -> Array:
    """The matrix of the equations f_i = A(s_i), coordinate by coordinate, for the coefficients of A, row by row."""
    count, n = points.shape
    columns = []
    for unknown in range(n * (n + 1)):
        matrix = array([[0] * (n + 1) for _ in range(n)])
        matrix.flat[unknown] = 1
        images = [matrix @ np.append(point, 1) for point in points]
        columns.append([images[i][c] for c in range(n) for i in range(count)])
    return array(columns).T


def _blocks(points: Array, turned: bool = False) -> Array:
    block = np.concatenate([points, np.ones((len(points), 1), dtype=int)], axis=1)
    many = np.eye(points.shape[1], dtype=int)
    return np.kron(block, many) if turned else np.kron(many, block)


def _least_determinant(form: Any, case: tuple[Array, Array, Array]) -> Number:
    """The determinant of the place on a path from det > 0 to det < 0 that bisection comes to."""
    low, high = mp.zero, mp.one
    for _ in range(mp.prec):
        middle = (low + high) / 2
        if definitions.determinant(form(*case, middle)) > 0:
            low = middle
        else:
            high = middle
    return abs(definitions.determinant(form(*case, low)))


def _bent(start: Array, end: Array, detour: Array, t: Number) -> Array:
    path: Array = start * (1 - t) + end * t + detour * (t * (1 - t))
    return path


def _mirrored() -> list[tuple[Array, Array, Array]]:
    mirror = exactly([[1, 0, 0], [0, 1, 0], [0, 0, -1]])
    return [(identity(mp, 3), mirror, each) for each in arrays("detours", 4, (3, 3), -2, 2)]


def _factors(m: Context, linear: Array, sign: int = -1) -> list[Array]:
    """A uniform scaling and shears whose product is a matrix of the plane with det > 0 and c != 0."""
    scale = m.sqrt(definitions.determinant(linear))
    (a, _), (c, d) = linear / scale
    upper = [array([[m.one, (x + sign) / c], [m.zero, m.one]]) for x in (a, d)]
    return [identity(m, 2) * scale, upper[0], array([[m.one, m.zero], [c, m.one]]), upper[1]]


def _not_composed(form: Any, case: tuple[Array]) -> Number:
    product = reduce(np.matmul, form(mp, *case))
    return distance(product, case[0])


def _linear_parts() -> list[tuple[Array]]:
    return [(exactly(each),) for each in ([[0, -1], [1, 0]], [[2, 1], [1, 1]], [[1, 0], [3, 0.5]], [[-1, 2], [-3, 1]])]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.1.composition",
        place="section 1",
        statement="Affine motions transform space by translations, rotations, uniform scalings and shears: "
        "no other maps are needed to compose any affinity of the plane with det L > 0.",
        verdict=Verdict.CONFIRMED,
        form=_factors,
        cases=_linear_parts,
        deviation=_not_composed,
        copies=(Copy("shears by (a + 1) / c and (d + 1) / c", lambda m, linear: _factors(m, linear, 1)),),
        remark="A uniform scaling and three shears do; where c = 0 a shear first makes it another. Non-uniform "
        "scalings are products of shears, as those generate SL(n).",
    ),
    Claim(
        id="rossignac_vinacua.2.1.ratios",
        place="section 2.1",
        statement="An affinity preserves ratios along a line, and so collinearity and convexity.",
        verdict=Verdict.CONFIRMED,
        form=_image,
        cases=_with_points(2),
        deviation=_ratio_lost,
        copies=(Copy("a projective map, which keeps lines and convexity only", _projective),),
    ),
    Claim(
        id="rossignac_vinacua.2.1.parallels",
        place="section 2.1",
        statement="An affinity takes parallel lines to parallel lines.",
        verdict=Verdict.CONFIRMED,
        form=_image,
        cases=_with_points(3),
        deviation=_angle_of_parallels,
        copies=(Copy("a projective map", _projective),),
    ),
    Claim(
        id="rossignac_vinacua.2.1.angles",
        place="section 2.1",
        statement="In general an affinity preserves neither angles nor distances.",
        verdict=Verdict.CONFIRMED,
        form=exactly([[1, 1], [0, 1]]),
        cases=lambda: [(exactly([1, 0]), exactly([0, 1])), (exactly([1, 1]), exactly([1, -1]))],
        deviation=_kept,
        copies=(Copy("a quarter turn for the shear", exactly([[0, -1], [1, 0]])),),
    ),
    Claim(
        id="rossignac_vinacua.2.1.quadruple",
        place="section 2.1",
        statement="A(p) = t + x i + y j + z k = L(op) + t, where i, j, k are the images of the vectors of the basis, "
        "and t is that of the origin: [i j k | t] is the matrix of A.",
        verdict=Verdict.CONFIRMED,
        form=_quadruple,
        cases=lambda: [(each,) for each in _matrices("quadruples", 4)],
        deviation=equals(lambda _, affinity: affinity[:-1]),
        copies=(Copy("the images of the points e_1, e_2, e_3", lambda m, a: _quadruple(m, a, vectors=False)),),
    ),
    Claim(
        id="rossignac_vinacua.2.1.difference",
        place="section 2.1",
        statement="The affinity that transforms B(F) into C(F) is A = C B^-1.",
        printed="A = C ∘ B^-1",
        verdict=Verdict.CONFIRMED,
        form=lambda m, b, c: c @ definitions.inverse(m, b),
        cases=lambda: list(zip(_matrices("first", 4), _matrices("second", 4), strict=True)),
        deviation=lambda form, case: distance(form(mp, *case) @ case[0], case[1]),
        copies=(Copy("B^-1 C for C B^-1", lambda m, b, c: definitions.inverse(m, b) @ c),),
    ),
    Claim(
        id="rossignac_vinacua.2.1.point_pairs",
        place="section 2.1",
        statement="The affinity that takes the points s_i to f_i is C B^-1, B and C the frames of these points.",
        printed="B = [s0s1 s0s2 s0s3 | s0], A = C ∘ B^-1",
        verdict=Verdict.CONFIRMED,
        form=_by_frames,
        cases=_point_pairs,
        deviation=_misses,
        copies=(
            Copy("B^-1 C for C B^-1", lambda m, s, f: definitions.inverse(m, _frame(s)) @ _frame(f)),
            Copy("[s1 s2 s3 | s0] for B", lambda m, s, f: _frame(f) @ definitions.inverse(m, _frame(s, origin=0))),
        ),
        remark="The prime of the second index in the printed s0s1' means nothing.",
    ),
    Claim(
        id="rossignac_vinacua.2.1.independence",
        place="section 2.1",
        statement="n + 1 pairs of points specify an affinity of n-space if the s_i, and the f_i, are linearly "
        "independent.",
        printed="both {s_i} and {f_i} are linearly independent sets",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_linearly,
        cases=_point_sets,
        deviation=_misjudged,
        correction=Correction(
            statement="They do if the points are affinely independent: the differences s_i - s_0 are linearly so.",
            form=_affinely,
        ),
        copies=(Copy("s_1, ..., s_n linearly independent", lambda points: _linearly(points[1:])),),
        remark="n + 1 vectors of n-space are never linearly independent: a test so written refuses every input.",
    ),
    Claim(
        id="rossignac_vinacua.2.1.decouples",
        place="section 2.1",
        statement="The n (n + 1) equations f_i = A(s_i) decouple into n blocks of n + 1 rows and columns, all with "
        "the same matrix, so that only that is to be inverted.",
        verdict=Verdict.CONFIRMED,
        form=_blocks,
        cases=_point_sets,
        deviation=lambda form, points: size(form(points) - _system(points)),
        copies=(Copy("n + 1 blocks of n rows and columns", lambda points: _blocks(points, turned=True)),),
    ),
    Claim(
        id="rossignac_vinacua.2.1.singular_on_the_way",
        place="section 2.1",
        statement="Any continuous path from an orientation-preserving affinity to one that is not contains a singular "
        "transformation; so no steady motion leads there.",
        verdict=Verdict.CONFIRMED,
        form=_bent,
        cases=_mirrored,
        deviation=_least_determinant,
        copies=(Copy("a path with a jump", lambda start, end, detour, t: _bent(start, end, detour, round(t))),),
    ),
)
