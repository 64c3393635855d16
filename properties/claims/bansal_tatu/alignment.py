"""Section 3 and figure 1: the steps that bring a tetrahedron onto the canonical one."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.samples import (
    inverse,
    mirrored,
    tetrahedra,
    tetrahedron_pairs,
)
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.precision import equals, exactly, mp, size
from affinecert.reference._matrices import Array, Context, Number, array, cross, identity, norm


def alignment(first: int = 1, second: int = 2, sign: int = 1) -> Any:
    """The rotation that brings edge (u_0, u_first) to the x axis and face (u_0, u_first, u_second) to the xy plane."""

    def rotation(vertices: Array) -> Array:
        one, other = vertices[first] - vertices[0], vertices[second] - vertices[0]
        x, normal = one / norm(mp, one), cross(one, other) * sign
        z = normal / norm(mp, normal)
        return array([x, cross(z, x), z])

    return rotation


def shear_to_canonical(w2: Array, w3: Array, second: tuple[int, int, int] = (1, 1, 0)) -> Array:
    """The matrix with e_1 -> e_1, w_2 -> (1, 1, 0), w_3 -> (0, 0, 1)."""
    images = array([exactly([1, 0, 0]), exactly(second), exactly([0, 0, 1])]).T
    result: Array = images @ inverse(array([exactly([1, 0, 0]), w2, w3]).T)
    return result


def _misaligned(rotation: Any, vertices: Array) -> Number:
    """How far it is from a rotation that does what step (1) says of u_1 and u_2."""
    turn = rotation(vertices)
    _, one, other, _ = ((vertices - vertices[0]) @ turn.T).copy()
    wrong = [size(turn @ turn.T - identity(mp, 3)), abs(definitions.determinant(turn) - 1)]
    return max(*wrong, size(one[1:]), abs(other[2]), -min(one[0], 0), -min(other[1], 0))


def _below(rotation: Any, vertices: Array) -> Number:
    """1 if u_3 is not above the xy plane."""
    height = (rotation(vertices) @ (vertices[3] - vertices[0]))[2]
    return 0 if height > mp.mpf(10) ** -30 else 1


def _off_origin(translation: Any, vertices: Array) -> Number:
    rotation = alignment()(vertices)
    return size(rotation @ vertices[0] + translation(rotation, vertices[0]))


def _edge_length_off(scale: Any, vertices: Array) -> Number:
    first = alignment()(vertices) @ (vertices[1] - vertices[0])
    return size(first * scale(norm(mp, first)) - exactly([1, 0, 0]))


def _edges_aligned(vertices: Array) -> tuple[Array, Array]:
    """The w_2 and w_3 of step (3)."""
    aligned = (vertices[1:] - vertices[0]) @ alignment()(vertices).T / norm(mp, vertices[1] - vertices[0])
    return aligned[1], aligned[2]


def _no_shear(shear: Any, vertices: Array) -> Number:
    """How far it is from an element of G_A that does what step (3) says."""
    w2, w3 = _edges_aligned(vertices)
    found = shear(w2, w3)
    images = (found @ exactly([1, 0, 0]), found @ w2, found @ w3)
    due = ((1, 0, 0), (1, 1, 0), (0, 0, 1))
    wrong = [size(image - exactly(each)) for image, each in zip(images, due, strict=True)]
    return max(*wrong, size(found[[1, 2, 2], [0, 0, 1]]), -min(found[1, 1], found[2, 2], 0))


def _intrinsic(matrix: Array) -> bool:
    """Whether A is invertible, A e_1 = e_1, the xy plane is invariant, and A_22 and A_33 are positive."""
    fixed = all(matrix[:, 0] == exactly([1, 0, 0])) and matrix[2, 1] == 0
    return bool(fixed and definitions.determinant(matrix) != 0 and matrix[1, 1] > 0 and matrix[2, 2] > 0)


def _pattern(*, strict: bool, lower: bool = True) -> Any:
    """Whether a matrix is one of those in the braces of the second display."""

    def member(matrix: Array) -> bool:
        zeros = [matrix[1, 0], matrix[2, 0], *([matrix[2, 1]] if lower else [])]
        least = min(matrix[1, 1], matrix[2, 2])
        return bool(matrix[0, 0] == 1 and not any(zeros) and (least > 0 if strict else least >= 0))

    return member


def _linear_maps() -> list[Array]:
    rows = (
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[1, 0, 0], [0, 0, 0], [0, 0, 1]],
        [[1, 0, 0], [0, 1, 0], [0, 0, 0]],
        [[1, 0, 0], [0, -1, 0], [0, 0, 1]],
        [[2, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[1, 0, 0], [1, 1, 0], [0, 0, 1]],
        [[1, 0, 0], [0, 1, 0], [0, 1, 1]],
        [[1, -2, 3], [0, 2, -1], [0, 0, 3]],
    )
    return [exactly(each) for each in rows]


def _sign_of_homogeneous(m: Context, vertices: Array) -> Number:
    bordered = np.concatenate([vertices.T, np.full((1, 4), m.one, dtype=object)])
    return m.sign(definitions.determinant(bordered))


def _same_orientation(sign: Any) -> Any:
    def product(m: Context, source: Array, target: Array) -> Number:
        return sign(m, source) * sign(m, target)

    return product


def _orientation(m: Context, source: Array, target: Array) -> Number:
    """The sign of the determinant of the affine map from one to the other."""
    linear = definitions.inverse(m, source[1:] - source[0]) @ (target[1:] - target[0])
    return m.sign(definitions.determinant(linear))


def _oriented_pairs() -> list[tuple[Array, Array]]:
    pairs = [(source, target + 3) for source, target in tetrahedron_pairs()]
    return pairs + [(source, mirrored(target)) for source, target in pairs[:3]]


FAR = [[1e4 + x, 2e4 + y, 3e4 + z] for x, y, z in ((0.1, 0.2, 0.3), (1.2, 0.3, 0.5), (1.3, 1.2, 0.6), (0.7, 0.1, 1.3))]
"""A tetrahedron of edges about 1, some 1e4 from the origin."""

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.3.same_orientation",
        place="section 3, footnote 3",
        statement="Two tetrahedra have the same orientation, that is the affine map between them keeps orientation, if "
        "the determinants of their homogeneous vertices have the same sign.",
        printed="sign(det P) = sign(det Q), P = [p̃₀ p̃₁ p̃₂ p̃₃]",
        verdict=Verdict.CONFIRMED,
        form=_same_orientation(_sign_of_homogeneous),
        cases=_oriented_pairs,
        deviation=equals(_orientation),
        copies=(
            Copy(
                "the vertices u₁, u₂, u₃ alone",
                _same_orientation(lambda m, vertices: m.sign(definitions.determinant(vertices[1:]))),
            ),
        ),
        losses=(
            Loss(
                where="the determinant of a tetrahedron of size 1, 1e4 from the origin",
                formula=lambda m, vertices: definitions.determinant(
                    np.concatenate([vertices.T, np.full((1, 4), m.one, dtype=object)])
                ),
                truth=lambda m, vertices: -definitions.determinant(vertices[1:] - vertices[0]),
                at=(FAR,),
                digits=8,
            ),
        ),
        remark="With the 1 last, the canonical tetrahedron has det P = -1. Use det[u₁ - u₀, u₂ - u₀, u₃ - u₀].",
    ),
    Claim(
        id="bansal_tatu.3.step_1.rotation",
        place="section 3, step (1)",
        statement="A rotation brings edge (u₀, u₁) to the positive x axis and the face (u₀, u₁, u₂) to the xy plane, "
        "with u₂ on the side of positive y.",
        verdict=Verdict.CONFIRMED,
        form=alignment(),
        cases=tetrahedra,
        deviation=_misaligned,
        copies=(
            Copy("the normal (u₂ - u₀) x (u₁ - u₀)", alignment(sign=-1)),
            Copy("edge (u₀, u₂) first", alignment(2, 1)),
        ),
    ),
    Claim(
        id="bansal_tatu.3.step_1.fourth_vertex",
        place="section 3, step (1)",
        statement="Of a non-degenerate tetrahedron of the canonical one's orientation, the rotation brings u₃ to a "
        "point of positive z.",
        verdict=Verdict.CONFIRMED,
        form=alignment(),
        cases=tetrahedra,
        deviation=_below,
        copies=(
            Copy("the face (u₀, u₂, u₁)", alignment(2, 1)),
            Copy("the face (u₀, u₁, u₃)", alignment(1, 3)),
        ),
    ),
    Claim(
        id="bansal_tatu.3.step_1.translation",
        place="section 3, step (1)",
        statement="The translation d of E brings R u₀ to the origin: d = -R u₀.",
        verdict=Verdict.CONFIRMED,
        form=lambda rotation, vertex: -(rotation @ vertex),
        cases=tetrahedra,
        deviation=_off_origin,
        copies=(Copy("d = -u₀", lambda rotation, vertex: -vertex),),
    ),
    Claim(
        id="bansal_tatu.3.step_2.scale",
        place="section 3, step (2)",
        statement="Scaled by s = 1 / |v₁|, the first edge ends in (1, 0, 0).",
        printed="s = 1 / ‖v₁‖",
        verdict=Verdict.CONFIRMED,
        form=lambda length: 1 / length,
        cases=tetrahedra,
        deviation=_edge_length_off,
        copies=(
            Copy("s = |v₁|", lambda length: length),
            Copy("s = 1 / |v₁|²", lambda length: 1 / length**2),
        ),
    ),
    Claim(
        id="bansal_tatu.3.step_3.shear",
        place="section 3, step (3), and figure 1",
        statement="An element of G_A, which leaves the x axis unchanged, maps w₂ to (1, 1, 0) and w₃ to (0, 0, 1).",
        verdict=Verdict.CONFIRMED,
        form=shear_to_canonical,
        cases=tetrahedra,
        deviation=_no_shear,
        copies=(Copy("w₂ to (0, 1, 0)", lambda w2, w3: shear_to_canonical(w2, w3, (0, 1, 0))),),
    ),
    Claim(
        id="bansal_tatu.3.G_A",
        place="section 3, definition of G_A",
        statement="The invertible A with A e₁ = e₁, the xy plane invariant and A₂₂, A₃₃ > 0 are the matrices of rows "
        "(1, α₁, α₃), (0, α₂, α₄), (0, 0, α₅) with α₂, α₅ ≥ 0.",
        printed="α_i ∈ ℝ, i = 1, …, 5, α₂, α₅ ≥ 0",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_pattern(strict=False),
        cases=_linear_maps,
        deviation=lambda member, matrix: int(member(matrix) != _intrinsic(matrix)),
        correction=Correction(statement="α₂, α₅ > 0, as appendix A.1.1 has it", form=_pattern(strict=True)),
        copies=(Copy("the entry below α₄ free", _pattern(strict=True, lower=False)),),
    ),
)
