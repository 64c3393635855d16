"""Appendix, efficiency: the global error as a quadratic form in the vertices, and its minimiser in closed form."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.kaji_2d.errors import frobenius, similarity
from affinecert.properties.claims.kaji_2d.minimisers import Task, goals, held, meshes, straight, targets, tasks
from affinecert.properties.claims.kaji_2d.plane import determinant, square, zero_or_one
from affinecert.properties.claims.kaji_2d.shapes import (
    FAN,
    SQUARE,
    STRIP,
    TRIANGLE,
    Error,
    Mesh,
    areas,
    drawn_goals,
    form_of,
    inertia,
    polarised,
    rational,
    total,
)
from affinecert.properties.claims.precision import distance, exactly, mp, size
from affinecert.reference import mesh2
from affinecert.reference._matrices import Array, Context, Number, array, scalar


def _rational_tasks() -> list[tuple[Mesh, list[Array], Array]]:
    """A mesh, goals and coordinates, all rational."""
    return [
        (mesh, drawn_goals(mesh.name, len(mesh.triangles)), rational(range(-3, 2 * len(mesh.vertices) - 3)))
        for mesh in (TRIANGLE, SQUARE, STRIP, FAN)
    ]


def _not_quadratic(error: Error, case: tuple[Mesh, list[Array], Array]) -> Number:
    """How far the global error is from vᵀ G v + vᵀ u + c, with symmetric G, at some v."""
    mesh, of_triangles, v = case
    function = total(mesh, error, of_triangles)
    return abs(form_of(polarised(function, len(v)), v) - function(v))


def _gradient(formula: Any, case: tuple[Mesh, list[Array], Array]) -> Number:
    """How far a formula is from the slopes of the global error, which differences give exactly."""
    mesh, of_triangles, v = case
    function = total(mesh, frobenius, of_triangles)
    g, u, _ = polarised(function, len(v))
    units = [array([Fraction(i == k) for i in range(len(v))]) for k in range(len(v))]
    slopes = array([(function(v + unit) - function(v - unit)) / 2 for unit in units])
    return size(formula(g, u, v) - slopes)


def _not_least(error: Error, case: tuple[Mesh, list[Array], Array]) -> int:
    """Whether a point where the gradient vanishes, here the source at t = 0, fails to be a minimiser."""
    mesh, of_triangles, _ = case
    identities = [rational([[1, 0], [0, 1]]) for _ in of_triangles]
    g, u, _ = polarised(total(mesh, error, identities, held((0, mesh.vertices[0]))), mesh.vertices.size)
    stationary = not (2 * (g @ mesh.vertices.flatten()) + u).any()
    return zero_or_one(not stationary or inertia(g)[1])


def _indefinite(a: Array, b: Array) -> Number:
    return similarity(a, b) - square(a - b) / 3


def _solved(formula: Any, task: Task) -> Number:
    """How far a formula for the minimiser is from that of the reference, which weights with areas."""
    mesh, target, t = task
    triangles = array([list(each) for each in mesh.triangles])
    truth = mesh2.frobenius(mp, mesh.vertices, target, triangles, scalar(t))
    constraint = held((0, straight(mesh.vertices[0], target[0], t)))
    g, u, _ = polarised(total(mesh, frobenius, goals(mesh, target, t), constraint, areas(mesh)), target.size, mp.one)
    found = formula(array((mp.matrix(g.tolist()) ** -1).tolist()), u)
    return distance(found.reshape(-1, 2), truth)


def _of_one_triangle(m: Context, source: Array, a: Array) -> Array:
    """The second and third vertex of a triangle whose linear part is to be A, by -G⁻¹ u / 2."""
    function = total(Mesh(source, ((0, 1, 2),), "thin"), frobenius, [a], held((0, source[0] * 0)))
    g, u, _ = polarised(function, 6, m.one)
    found: Array = (definitions.inverse(m, g) @ u / -2).reshape(3, 2)[1:]
    return found


def _matrices_at_two_times(assembled: Any, case: tuple[Error, Mesh, Array]) -> Number:
    """How much the matrix G changes from t = 1/4 to t = 1/2."""
    error, mesh, target = case
    first, second = (assembled(error, mesh, goals(mesh, target, mp.mpf(t))) for t in (0.25, 0.5))
    return distance(first, second)


def _matrix(error: Error, mesh: Mesh, of_triangles: list[Array]) -> Array:
    return polarised(total(mesh, error, of_triangles), mesh.vertices.size, mp.one)[0]


def _matrix_of_moving_areas(error: Error, mesh: Mesh, of_triangles: list[Array]) -> Array:
    weights = [area * determinant(a) for area, a in zip(areas(mesh), of_triangles, strict=True)]
    return polarised(total(mesh, error, of_triangles, None, weights), mesh.vertices.size, mp.one)[0]


def _constant_matrices() -> list[tuple[Error, Mesh, Array]]:
    """E^F; and E^R where every A_i is a similarity."""
    similar = [(similarity, mesh, (exactly([[1, -2], [2, 1]]) @ mesh.vertices.T).T) for mesh in meshes()]
    return [*[(frobenius, mesh, target) for mesh in meshes()[1:] for target in targets(mesh, 1)], *similar]


def _changing_matrices() -> list[tuple[Error, Mesh, Array]]:
    triangle = meshes()[0]
    stretched = triangle.vertices @ exactly([[4, 0], [0, 1]])
    slightly = triangle.vertices @ exactly([[1 + 2**-10, 0], [0, 1]])
    drawn = [(similarity, mesh, target) for mesh in meshes()[1:] for target in targets(mesh, 1)]
    return [(similarity, triangle, stretched), (similarity, triangle, slightly), *drawn]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.4.stationary",
        place="section 4, minimiser",
        statement="The minimisers are the points where the gradient vanishes.",
        verdict=Verdict.CONFIRMED,
        form=similarity,
        cases=_rational_tasks,
        deviation=_not_least,
        copies=(Copy("a third of E^F taken away", _indefinite),),
        remark="The reason given, that the error is definite, is too much: semidefinite is enough.",
    ),
    Claim(
        id="kaji_2d.appendix.quadratic",
        place="appendix, efficiency",
        statement="The global error is a quadratic function of the coordinates of the vertices, with a symmetric G.",
        printed="E(v) = vᵀ G v + vᵀ u + c",
        verdict=Verdict.CONFIRMED,
        form=similarity,
        cases=_rational_tasks,
        deviation=_not_quadratic,
        copies=(
            Copy("the squared norm of the product for that of B", lambda a, b: similarity(a, b @ b)),
            Copy("the squared difference of determinants", lambda a, b: (determinant(a) - determinant(b)) ** 2),
        ),
        remark="With v as n complex numbers, G is (n × n) and Hermitian.",
    ),
    Claim(
        id="kaji_2d.appendix.gradient",
        place="appendix, efficiency",
        statement="The gradient of the quadratic form.",
        printed="∂E/∂v = 2 G v + u",
        verdict=Verdict.CONFIRMED,
        form=lambda g, u, v: 2 * (g @ v) + u,
        cases=_rational_tasks,
        deviation=_gradient,
        copies=(
            Copy("G for 2 G", lambda g, u, v: g @ v + u),
            Copy("2 u for u", lambda g, u, v: 2 * (g @ v + u)),
        ),
    ),
    Claim(
        id="kaji_2d.appendix.minimiser",
        place="appendix, efficiency",
        statement="The minimiser in closed form.",
        printed="v(t) = -G⁻¹ u(t) / 2",
        verdict=Verdict.CONFIRMED,
        form=lambda g, u: -(g @ u) / 2,
        cases=lambda: tasks(0.375, 1.25)[::2],
        deviation=_solved,
        copies=(
            Copy("+ for -", lambda g, u: g @ u / 2),
            Copy("1 for 1/2", lambda g, u: -(g @ u)),
        ),
        losses=(
            Loss(
                where="E^F of a triangle of height 1e-4: the normal equations square the condition",
                formula=_of_one_triangle,
                truth=lambda m, source, a: (a @ (source - source[0]).T).T[1:],
                at=([[0.0, 0.0], [1.0, 0.0], [0.3, 1e-4]], [[1.1, -0.7], [0.6, 0.9]]),
                digits=8,
            ),
        ),
        remark="If G is regular, unlike that of E^R with one vertex constrained. Factor it rather than invert it.",
    ),
    Claim(
        id="kaji_2d.appendix.time_independent",
        place="appendix, efficiency",
        statement="G does not depend on the time: G⁻¹ is computed once for all frames.",
        printed="Note that G is time-independent and we need to compute G⁻¹ just once for all frames",
        verdict=Verdict.BOUND,
        domain="E^F; E^R only where every A_i is a similarity, as A_i(t) stands in its G",
        form=_matrix,
        cases=_constant_matrices,
        outside=_changing_matrices,
        deviation=_matrices_at_two_times,
        copies=(Copy("areas at the time t as weights", _matrix_of_moving_areas),),
        remark="For E^R, E^S and the balanced error the matrix has to be factored at each time.",
    ),
    Claim(
        id="kaji_2d.appendix.efficient",
        place="appendix, efficiency",
        statement="Finding the minimiser is efficient enough.",
        verdict=Verdict.UNCHECKABLE,
        reason="No time, no size of a mesh and no machine are given; and what is said of it holds for E^F only.",
    ),
)
"""The quadratic form."""
