"""Sections 2 to 4: the affine map of a triangle to another (equation 1), and of a mesh, by its triangles."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_2d.plane import determinant, edges, inverse, zero_or_one
from affinecert.properties.claims.kaji_2d.shapes import FAN, SQUARE, STRIP, Mesh, inertia, rational
from affinecert.properties.claims.precision import difference, distance, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, array

Pair = tuple[Array, Array]
"""The three vertices of a triangle and of its image, as rows."""


def _columns(triangle: Array) -> Array:
    """The homogeneous columns of equation 1."""
    return array([*triangle.T, [1, 1, 1]])


def _map(m: Context, source: Array, target: Array) -> Array:
    """Equation 1."""
    mapping: Array = _columns(target) @ definitions.inverse(m, _columns(source))
    return mapping


def _reversed(m: Context, source: Array, target: Array) -> Array:
    product: Array = definitions.inverse(m, _columns(source)) @ _columns(target)
    return product


def _of_rows(m: Context, source: Array, target: Array) -> Array:
    product: Array = _columns(target).T @ definitions.inverse(m, _columns(source).T)
    return product


def _exchanged(m: Context, source: Array, target: Array) -> Array:
    return _map(m, source, target[[0, 2, 1]])


def _drawn_triangles(name: str, sign: int) -> list[Array]:
    drawn = arrays(name, 24, (3, 2), -3, 3)
    return [each for each in drawn if determinant(edges(each)) * sign > 0][:6]


def _pairs() -> list[Pair]:
    """Triangles of one orientation, the first one almost without area."""
    thin = exactly([[0, 0], [1, 0], [2, 2**-20]])
    simple = [exactly([[0, 0], [1, 0], [0, 1]]), exactly([[0, 0], [0, 1], [1, 0]])]
    sources = [*simple, *_drawn_triangles("source", 1), *_drawn_triangles("source", -1)]
    targets = [*simple, *_drawn_triangles("target", 1), *_drawn_triangles("target", -1)]
    return [*zip(sources, targets, strict=True), (simple[0], thin), (thin, simple[0])]


def _turned_over() -> list[Pair]:
    """Triangles of different orientations, the first one almost without area."""
    over = exactly([[0, 0], [1, 0], [2, -(2**-20)]])
    sources, targets = _drawn_triangles("source", 1), _drawn_triangles("target", -1)
    return [(exactly([[0, 0], [1, 0], [0, 1]]), over), *zip(sources, targets, strict=True)]


def _misses(formula: Any, pair: Pair) -> Number:
    source, target = pair
    return distance(formula(mp, source, target) @ _columns(source), _columns(target))


def _last_row(formula: Any, pair: Pair) -> Number:
    return difference(formula(mp, *pair)[2], exactly([0, 0, 1]))


def _turns_over(formula: Any, pair: Pair) -> int:
    return zero_or_one(determinant(formula(mp, *pair)[:2, :2]) <= 0)


def _unknowns(points: Any, triangle: Array) -> int:
    """How many of the six entries of an affine map its values at three points leave open."""
    equations = [row for x, y in points(triangle) for row in ([x, y, 1, 0, 0, 0], [0, 0, 0, x, y, 1])]
    matrix = array(equations)
    return inertia(matrix.T @ matrix)[2]


def _linear(m: Context, source: Array, moved: Array) -> Array:
    return _map(m, source, moved)[:2, :2]


def _backwards(m: Context, source: Array, moved: Array) -> Array:
    return _map(m, moved, source)[:2, :2]


def _of_two_vertices(m: Context, source: Array, moved: Array) -> Array:
    # Vertices 2 and 3, moved so that their columns are independent.
    columns: Array = moved[1:].T @ inverse(source[1:].T + array([[0, 0], [0, 100]]))
    return columns


def _sees_translation(formula: Any, pair: Pair) -> Number:
    """The change of the linear part if the image is moved by (5, -3)."""
    source, target = pair
    return distance(formula(mp, source, target + array([5, -3])), formula(mp, source, target))


def _superposes(formula: Any, case: tuple[Array, Array, Array]) -> Number:
    """Whether B of a combination of two shapes is that combination of their B."""
    source, first, second = case
    due = 2 * formula(mp, source, first) - 3 * formula(mp, source, second)
    return distance(formula(mp, source, 2 * first - 3 * second), due)


def _triples() -> list[tuple[Array, Array, Array]]:
    return [(a, b, c) for (a, b), (c, _) in zip(_pairs(), reversed(_pairs()), strict=True)]


def _tears(formula: Any, case: tuple[Mesh, Array]) -> Number:
    """How far the maps of the triangles are from taking their vertices, and middles of edges, to those moved."""
    mesh, moved = case
    vertices = exactly(mesh.vertices.astype(float).tolist())
    gap = mp.zero
    for triple in mesh.triangles:
        mapping = formula(mp, vertices[[*triple]], moved[[*triple]])
        for i, k in zip(triple, (*triple[1:], triple[0]), strict=True):
            for j in (i, k):
                before, after = ((shape[i] + shape[j]) / 2 for shape in (vertices, moved))
                gap = max(gap, distance(mapping @ array([*before, 1]), array([*after, 1])))
    return gap


def _moved_meshes() -> list[tuple[Mesh, Array]]:
    return [
        (mesh, moved) for mesh in (SQUARE, STRIP, FAN) for moved in arrays(mesh.name, 2, (len(mesh.vertices), 2), -4, 4)
    ]


def _with_linear_part(changed: Any) -> Any:
    """The map whose linear part is changed so, its translation being that of equation 1."""

    def mapping(m: Context, source: Array, target: Array) -> Array:
        found = _map(m, source, target)
        found[:2, :2] = changed(found[:2, :2])
        return found

    return mapping


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.2.orientation",
        place="section 2; section 3, after equation 1",
        statement="The linear part A_i of the map between two corresponding triangles has a positive determinant.",
        printed="the linear part A_i of Â_i (i.e., A_i ∈ GL⁺(2))",
        verdict=Verdict.BOUND,
        domain="triangles of one orientation, as section 3 assumes; compatible triangulations may have others",
        form=_map,
        cases=_pairs,
        outside=_turned_over,
        deviation=_turns_over,
        copies=(Copy("two vertices of the image exchanged", _exchanged),),
        remark="It is the quotient of the signed areas. Where it is not positive, A^P and A^E do not exist.",
    ),
    Claim(
        id="kaji_2d.equation_1.maps",
        place="equation 1",
        statement="The matrix takes the vertices of a triangle to those of another, in this order.",
        printed="Â = (x'₁ x'₂ x'₃; y'₁ y'₂ y'₃; 1 1 1) (x₁ x₂ x₃; y₁ y₂ y₃; 1 1 1)⁻¹",
        verdict=Verdict.CONFIRMED,
        form=_map,
        cases=_pairs,
        deviation=_misses,
        copies=(
            Copy("the factors in the other order", _reversed),
            Copy("two vertices of the image exchanged", _exchanged),
        ),
    ),
    Claim(
        id="kaji_2d.equation_1.last_row",
        place="after equation 1",
        statement="It has the form of an affine map: its last row is 0 0 1.",
        verdict=Verdict.CONFIRMED,
        form=_map,
        cases=_pairs,
        deviation=_last_row,
        copies=(
            Copy("the factors in the other order", _reversed),
            Copy("both factors transposed", _of_rows),
        ),
        losses=(
            Loss(
                where="the linear part, for a triangle of size 1 a million away from the origin",
                formula=_linear,
                truth=lambda m, source, moved: edges(moved) @ inverse(edges(source)),
                at=([[1e6, 1e6], [1e6 + 1, 1e6], [1e6, 1e6 + 0.7]], [[0.1, 0.2], [1.3, 0.4], [0.2, 1.5]]),
                digits=6,
            ),
        ),
        remark="The paper writes a_(2,1) for the entry of row 1 and column 2: the indices are column and row.",
    ),
    Claim(
        id="kaji_2d.3.unique",
        place="section 3, before equation 1",
        statement="There is only one affine map that takes a triangle to another: no entry is left open.",
        verdict=Verdict.CONFIRMED,
        form=lambda triangle: triangle,
        cases=lambda: [
            rational(each)
            for each in (
                [[0, 0], [1, 0], [0, 1]],
                [[1, 2], [3, -1], [-2, 5]],
                [[0, 0], [1, 0], [2, Fraction(1, 10**6)]],
            )
        ],
        deviation=_unknowns,
        copies=(
            Copy(
                "the middle of an edge for a vertex",
                lambda triangle: [triangle[0], triangle[1], (triangle[0] + triangle[1]) / 2],
            ),
        ),
        remark="Decided exactly. A triangle without area leaves two entries open.",
    ),
    Claim(
        id="kaji_2d.3.translation_part",
        place="section 3, after equation 1",
        statement="The translation can be neglected: the linear parts, all that the errors see, do not change if the "
        "image is moved.",
        verdict=Verdict.CONFIRMED,
        form=_linear,
        cases=_pairs,
        deviation=_sees_translation,
        copies=(Copy("columns of two vertices for those of two edges", _of_two_vertices),),
    ),
    Claim(
        id="kaji_2d.4.linear_in_vertices",
        place="section 4, the observation",
        statement="The entries of the linear part are linear in the vertices of the image.",
        verdict=Verdict.CONFIRMED,
        form=_linear,
        cases=_triples,
        deviation=_superposes,
        copies=(Copy("the map from the image back to the source", _backwards),),
    ),
    Claim(
        id="kaji_2d.4.equivalent",
        place="section 4, first condition and the observation",
        statement="Images v of the vertices determine a piecewise affine map which is consistent on the edges, and "
        "takes the vertices to v again: to give one is to give the other.",
        verdict=Verdict.CONFIRMED,
        form=_map,
        cases=_moved_meshes,
        deviation=_tears,
        copies=(
            Copy("linear parts transposed", _with_linear_part(lambda b: b.T)),
            Copy(
                "linear parts of determinant 1 instead", _with_linear_part(lambda b: b / mp.sqrt(abs(determinant(b))))
            ),
        ),
    ),
)
"""Equation 1."""
