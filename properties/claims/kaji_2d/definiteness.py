"""Section 4 and the appendix: which of the errors are positive definite, decided exactly for rational shapes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.kaji_2d.errors import frobenius, similarity
from affinecert.properties.claims.kaji_2d.plane import J, determinant, square, zero_or_one
from affinecert.properties.claims.kaji_2d.shapes import (
    FAN,
    STRIP,
    TRIANGLE,
    Constraint,
    Error,
    Mesh,
    drawn_goals,
    form_of,
    inertia,
    polarised,
    rational,
    total,
)
from affinecert.reference._matrices import Array

Shape = tuple[Mesh, Sequence[Array]]
"""A mesh, and the linear parts A_i that its triangles are to have."""


def _goals() -> list[Array]:
    return [rational([[1, 0], [0, 1]]), rational([[2, 0], [0, 1]]), rational([[0, -1], [1, 0]]), *drawn_goals("A", 5)]


def _gram(error: Error, a: Array) -> Array:
    """The matrix of the quadratic part of E(A, B) in the four entries of B."""
    return polarised(lambda entries: error(a, entries.reshape(2, 2)), 4)[0]


def _positive_definite(error: Error, a: Array) -> int:
    return zero_or_one(inertia(_gram(error, a)) != (4, 0, 0))


def _half_definite(error: Error, a: Array) -> int:
    """Whether it is anything but an orthogonal projection of rank 2 whose kernel is spanned by A and J A."""
    gram = _gram(error, a)
    kernel = [gram @ each.flatten() for each in (a, J @ a)]
    right = inertia(gram) == (2, 0, 2) and (gram @ gram == gram).all() and not any(each.any() for each in kernel)
    return zero_or_one(not right)


def _without_last(a: Array, b: Array) -> Any:
    return frobenius(a, b) - (a[1, 1] - b[1, 1]) ** 2


def _similarity_but(doubled: Fraction) -> Error:
    def error(a: Array, b: Array) -> Any:
        product = b @ a.T
        return square(b) - (square(product) + doubled * determinant(product)) / square(a)

    return error


def _shapes() -> list[Shape]:
    """Meshes with random goals, and with those of a piecewise affine map."""
    meshes = TRIANGLE, STRIP, FAN
    random = [(mesh, drawn_goals(mesh.name, len(mesh.triangles))) for mesh in meshes]
    return [*[(mesh, [rational([[1, 0], [0, 1]])] * len(mesh.triangles)) for mesh in meshes], *random]


def _held(*vertices: int) -> Constraint:
    """The sum of |v_i - u_i|² over some vertices, u_i = (1, 2)."""
    return lambda moved: sum(square(moved[i] - rational([1, 2])) for i in vertices)


def _global_gram(error: Error, shape: Shape, constraint: Constraint | None) -> Array:
    mesh, goals = shape
    return polarised(total(mesh, error, goals, constraint), 2 * len(mesh.vertices))[0]


def _freedoms(error: Error, shape: Shape, constraint: Constraint | None = None) -> int:
    """The dimension of the set of minimisers of a global error, that of the kernel of G; -1 if G is indefinite."""
    _, negative, zero = inertia(_global_gram(error, shape, constraint))
    return -1 if negative else zero


def _definite(constrained: Any, case: tuple[str, Shape]) -> int:
    """Whether the error of that name with its constraint is not positive definite."""
    name, shape = case
    error, constraint = constrained(name, shape[0])
    return zero_or_one(_freedoms(error, shape, constraint) != 0)


ERRORS: Mapping[str, Error] = {"E^F": frobenius, "E^R": similarity}


def _one_vertex(name: str, mesh: Mesh) -> tuple[Error, Constraint]:
    return ERRORS[name], _held(0)


def _two_vertices(name: str, mesh: Mesh) -> tuple[Error, Constraint]:
    return ERRORS[name], _held(0, len(mesh.vertices) - 1)


def _edge_vector(name: str, mesh: Mesh) -> tuple[Error, Constraint]:
    return ERRORS[name], lambda moved: square(moved[1] - moved[0])


def _in_both_errors() -> list[tuple[str, Shape]]:
    return [(name, shape) for name in ERRORS for shape in _shapes()]


def _in_translation_only() -> list[tuple[str, Shape]]:
    return [("E^F", shape) for shape in _shapes()] + [("E^R", _shapes()[-1])]


def _in_strips() -> list[tuple[str, Shape]]:
    return [("E^R", shape) for shape in _shapes()[:-1]]


def _two_freedoms(error: Error, shape: Shape) -> int:
    """Whether the minimisers are not just translates of one of them."""
    mesh, _ = shape
    gram = _global_gram(error, shape, None)
    shifts = [rational([*each] * len(mesh.vertices)) for each in ((1, 0), (0, 1))]
    return zero_or_one(_freedoms(error, shape) != 2 or any((gram @ shift).any() for shift in shifts))


def _constraint_definite(constraint: Any, count: int) -> int:
    gram = polarised(lambda x: constraint(x.reshape(-1, 2)), 2 * count)[0]
    return zero_or_one(inertia(gram) != (2 * count, 0, 0))


def _constraint_semidefinite(constraint: Any, count: int) -> int:
    gram = polarised(lambda x: constraint(x.reshape(-1, 2)), 2 * count)[0]
    return zero_or_one(inertia(gram)[1] != 0)


def _vertex_and_edge(name: str, mesh: Mesh) -> tuple[Error, Constraint]:
    return ERRORS[name], lambda moved: _held(0)(moved) + square(moved[1] - moved[0])


def _misses_the_source(error: Error, case: tuple[Any, Shape]) -> int:
    """Whether the source itself, at t = 0, is not the one minimiser under constraints that it meets."""
    constrained, (mesh, goals) = case
    _, unmoved = constrained("E^R", mesh)
    meets = rational([[1, 2]] * len(mesh.vertices))
    shifted = total(mesh, error, goals, lambda moved: unmoved(moved - mesh.vertices + meets))
    gram, u, c = polarised(shifted, mesh.vertices.size)
    flat = mesh.vertices.flatten()
    stationary = not (2 * (gram @ flat) + u).any() and form_of((gram, u, c), flat) == 0
    return zero_or_one(not stationary or inertia(gram)[1:] != (0, 0))


def _squares() -> Mapping[str, Any]:
    a = rational([[2, 1], [0, 1]])
    fan = _shapes()[-1]
    return {
        "squares of E^F, E^R in B (+, -, 0)": (inertia(_gram(frobenius, a)), inertia(_gram(similarity, a))),
        "freedoms of E^F and E^R, a strip": tuple(_freedoms(each, _shapes()[4]) for each in ERRORS.values()),
        "freedoms of E^F and E^R, a fan that does not close": tuple(_freedoms(each, fan) for each in ERRORS.values()),
    }


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_2d.4.E_F_definite",
        place="section 4, local error functions",
        statement="E^F is a positive definite quadratic function of the entries of B.",
        printed="E^F(A, B) = |A - B|²",
        verdict=Verdict.CONFIRMED,
        form=frobenius,
        cases=_goals,
        deviation=_positive_definite,
        copies=(Copy("the last of the four squares is left out", _without_last),),
        remark="Its quadratic part is; with the linear one it is least, 0, at B = A.",
    ),
    Claim(
        id="kaji_2d.appendix.E_R_definite",
        place="section 4, equation 4; appendix, closed form",
        statement="E^R is a positive definite quadratic form in the entries of B.",
        printed="This is positive definite quadratic with respect to the entries of B.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=similarity,
        cases=_goals,
        deviation=_positive_definite,
        correction=Correction(
            statement="It is positive semidefinite: the squared distance of B from the plane of the (x I + y J) A, "
            "where it is 0; two squares of four.",
            form=similarity,
            deviation=_half_definite,
        ),
        copies=(
            Copy("det(B Aᵀ) for 2 det(B Aᵀ)", _similarity_but(Fraction(1))),
            Copy("- for + before 2 det(B Aᵀ)", _similarity_but(Fraction(-2))),
            Copy("E^F for E^R", frobenius),
        ),
        numbers=_squares,
        remark="No error that is invariant under similarities can be definite; so G may be singular (see below).",
    ),
    Claim(
        id="kaji_2d.4.constraint_definite",
        place="section 4, constraint function",
        statement="The constraint function is positive definite in the vertices, such as that of Alexa et al., a "
        "square of the first vertex.",
        printed="a constraint function C : (R²)ⁿ → R≥0 which is also positive definite and quadratic",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_held(0),
        cases=lambda: [1, 2, 3],
        deviation=_constraint_definite,
        correction=Correction(
            statement="It is positive semidefinite, seeing only the vertices that it names.",
            form=_held(0),
            deviation=_constraint_semidefinite,
        ),
        copies=(Copy("minus the square", lambda moved: -_held(0)(moved)),),
    ),
    Claim(
        id="kaji_2d.4.translation_invariant",
        place="section 4, after E^F",
        statement="The global error of E^F is invariant under translations, and needs two-dimensional constraints for "
        "a unique minimiser, no more.",
        verdict=Verdict.CONFIRMED,
        form=frobenius,
        cases=_shapes,
        deviation=_two_freedoms,
        copies=(
            Copy("E^R for E^F", similarity),
            Copy("the last of the four squares is left out", _without_last),
        ),
        remark="For a mesh in one piece. The kernel of G is exactly the translations.",
    ),
    Claim(
        id="kaji_2d.4.can_be_made_unique",
        place="section 4, minimiser",
        statement="The minimiser may have positive dimension, but a constraint function can make it a single point.",
        verdict=Verdict.CONFIRMED,
        form=_two_vertices,
        cases=_in_both_errors,
        deviation=_definite,
        copies=(
            Copy("one vertex held instead of two", _one_vertex),
            Copy("one edge held instead of two vertices", _edge_vector),
        ),
        remark="Two vertices do for E^F and, generically, for E^R; which is free again if A_i(t) close up around every "
        "vertex and bring the two to one place.",
    ),
    Claim(
        id="kaji_2d.4.global_definite",
        place="section 4, minimiser; appendix, efficiency",
        statement="The global error, with a constraint function such as that of Alexa et al., is a positive definite "
        "quadratic form in the vertices.",
        verdict=Verdict.BOUND,
        domain="E^F; for E^R only if the A_i do not close up around some vertex, and then its minimiser is one point",
        form=_one_vertex,
        cases=_in_translation_only,
        outside=_in_strips,
        deviation=_definite,
        copies=(Copy("an edge for the vertex", _edge_vector),),
        remark="Where G is singular, -G⁻¹ u / 2 of the appendix does not exist.",
    ),
    Claim(
        id="kaji_2d.4.E_R_in_place_of_E_F",
        place="section 4, figures 4 and 5, captions",
        statement="E^R takes the place of E^F with the same input data: the source is the one minimiser at t = 0.",
        verdict=Verdict.BOUND,
        domain="constraints on two vertices, or on one and an edge; not the one vertex that is enough for E^F",
        form=similarity,
        cases=lambda: [(each, shape) for each in (_two_vertices, _vertex_and_edge) for shape in _shapes()[:3]],
        outside=lambda: [(_one_vertex, shape) for shape in _shapes()[:3]],
        deviation=_misses_the_source,
        copies=(
            Copy("3 det(B Aᵀ) for 2 det(B Aᵀ)", _similarity_but(Fraction(3))),
            Copy("det(B Aᵀ) for 2 det(B Aᵀ)", _similarity_but(Fraction(1))),
        ),
        remark="With one vertex all similar shapes are equally good at t = 0, and the point is best later. The loci of "
        "figure 2 are enough, if they are two.",
    ),
)
"""What is definite, and how many freedoms are left."""
