"""Section 3.3: SE(3), G_A, G_S and their product, the group of tetrahedra."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.samples import embedded, inverse, rigid_maps
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import difference, equals, exactly, mp, size
from affinecert.reference import se3, shear
from affinecert.reference._matrices import Array, Context, Number, cross_matrix, identity, tangent

Basis = Mapping[str, Sequence[Array]]
"""For each group a basis of its Lie algebra."""


def unit_matrix(size_: int, row: int, column: int) -> Array:
    """The square matrix with a single 1."""
    matrix = np.full((size_, size_), mp.zero, dtype=object)
    matrix[row, column] = mp.one
    return matrix


BASIS: Basis = {
    "SE(3)": (
        *(tangent(mp, cross_matrix(mp, axis), exactly([0, 0, 0])) for axis in identity(mp, 3)),
        *(unit_matrix(4, row, 3) for row in range(3)),
    ),
    "G_A": tuple(unit_matrix(3, *place) for place in ((0, 1), (1, 1), (0, 2), (1, 2), (2, 2))),
    "G_S": (identity(mp, 1),),
}
"""The Lie algebras as printed in section 3.3, G_S as 1x1 matrices."""

DIMENSIONS = {"SE(3)": 6, "G_A": 5, "G_S": 1}

Element = tuple[Array, Array, Array]
"""E, A and s, the last 1x1."""


def off_group(group: str, matrix: Array) -> Number:
    """How far a matrix is from an element of a group."""
    if group == "SO(3)":
        return max(size(matrix.T @ matrix - identity(mp, 3)), abs(definitions.determinant(matrix) - 1))
    if group == "SE(3)":
        return max(off_group("SO(3)", matrix[:3, :3]), size(matrix[3] - exactly([0, 0, 0, 1])))
    if group == "G_A":
        wrong = size(matrix[:, 0] - exactly([1, 0, 0])), abs(matrix[2, 1])
        return max(*wrong, -min(matrix[1, 1], matrix[2, 2], 0))
    return -min(matrix[0, 0], 0)


def group_logarithm(group: str, element: Array) -> Array:
    """The logarithm of an element of SE(3), G_A or G_S, as a matrix."""
    if group == "SE(3)":
        twist = se3.log(mp, element)
        return tangent(mp, cross_matrix(mp, twist[:3]), twist[3:])
    if group == "G_A":
        return shear.matrix(mp, shear.log(mp, element), mp.zero)
    result: Array = exactly([[mp.log(element[0, 0])]])
    return result


def _span(basis: Sequence[Array], matrices: Sequence[Array]) -> int:
    """By how much the rank of a basis grows with more matrices."""
    rows = [np.array(each.astype(float)).ravel() for each in basis]
    more = [np.array(each.astype(float)).ravel() for each in matrices]
    return int(np.linalg.matrix_rank(np.array(rows + more)) - np.linalg.matrix_rank(np.array(rows)))


def _no_algebra(bases: Basis, group: str) -> Number:
    """How far a basis is from one of the Lie algebra of a group: dimension, brackets, exponentials."""
    basis = bases[group]
    wrong: Number = abs(DIMENSIONS[group] - _span([basis[0] * 0], basis))
    wrong += _span(basis, [x @ y - y @ x for x in basis for y in basis])
    mixture = sum((each * (k - 2) / (k + 1) for k, each in enumerate(basis)), start=basis[0])
    return max(wrong, *(off_group(group, definitions.exponential(mp, mixture * t)) for t in (1, -2)))


def _in_space(group: str, matrix: Array) -> Array:
    """An element of a Lie algebra as the derivative of 4x4 matrices."""
    if group == "SE(3)":
        return matrix
    linear = matrix if group == "G_A" else identity(mp, 3) * matrix[0, 0]
    result: Array = embedded(linear) - unit_matrix(4, 3, 3)
    return result


def _twelve(bases: Basis, _: None) -> int:
    """How much the derivatives of A S E at the identity fall short of the twelve dimensions of affine maps."""
    derivatives = [_in_space(group, each) for group, basis in bases.items() for each in basis]
    return abs(12 - _span([derivatives[0] * 0], derivatives)) + abs(12 - len(derivatives))


def _changed(group: str, basis: Sequence[Array]) -> Basis:
    return {**BASIS, group: tuple(basis)}


def _product(one: Element, other: Element) -> Element:
    return one[0] @ other[0], one[1] @ other[1], one[2] @ other[2]


def _sum_of_shears(one: Element, other: Element) -> Element:
    return one[0] @ other[0], one[1] + other[1] - identity(mp, 3), one[2] @ other[2]


def _crossed(one: Element, other: Element) -> Element:
    return one[0] @ other[0], one[1] @ other[1].T, one[2] @ other[2]


def _no_group(product: Any, elements: tuple[Element, Element]) -> Number:
    """How far a product is from one of a group: closed, with inverses on both sides."""
    one, other = elements
    back: Element = (inverse(one[0]), inverse(one[1]), inverse(one[2]))
    results = product(one, other), product(other, one), back
    wrong = [off_group(group, part) for each in results for group, part in zip(BASIS, each, strict=True)]
    neutral = tuple(identity(mp, len(part)) for part in one)
    return max(*wrong, difference(product(one, back), neutral), difference(product(back, one), neutral))


def _pairs_of_elements() -> list[tuple[Element, Element]]:
    shears = [shear.exp(mp, alpha) for alpha in arrays("shears", 4, (5,), -2, 2)]
    triples: list[Element] = [
        (pose, each, exactly([[k + 1]])) for k, (pose, each) in enumerate(zip(rigid_maps(), shears, strict=False))
    ]
    return list(pairwise(triples))


def _blocks(m: Context, *blocks: Array) -> Array:
    """The block diagonal matrix."""
    count = sum(map(len, blocks))
    matrix, start = np.full((count, count), m.zero, dtype=object), 0
    for block in blocks:
        matrix[start : start + len(block), start : start + len(block)] = block
        start += len(block)
    return matrix


def _concatenated(third: int = 1) -> Any:
    """The exponentials of SE(3), of G_A and of G_S, one beside the other."""

    def exponential(m: Context, twist: Array, alpha: Array, sigma: Array) -> Array:
        return _blocks(m, se3.exp(m, twist), shear.exp(m, alpha), exactly([[m.exp(third * sigma[0, 0])]]))

    return exponential


def _of_product(m: Context, twist: Array, alpha: Array, sigma: Array) -> Array:
    """The exponential in the group of block diagonal matrices, by its series."""
    rigid = tangent(m, cross_matrix(m, twist[:3]), twist[3:])
    return definitions.exponential(m, _blocks(m, rigid, shear.matrix(m, alpha, m.zero), sigma))


def _tangents_of_product() -> list[tuple[Array, Array, Array]]:
    twists, alphas = arrays("twists", 4, (6,), -2, 2), arrays("alphas", 4, (5,), -2, 2)
    return [(*both, exactly([[k - 2]])) for k, both in enumerate(zip(twists, alphas, strict=True), 1)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.3.1.direct_product",
        place="sections 3.1 and 3.3",
        statement="SE(3), G_A, G_S are groups, and so is their product, with (E₁, A₁, s₁)(E₂, A₂, s₂) = (E₁E₂, A₁A₂, "
        "s₁s₂).",
        printed="(E₁, A₁, s₁)·(E₂, A₂, s₂) = (E₁E₂, A₁A₂, s₁s₂)",
        verdict=Verdict.CONFIRMED,
        form=_product,
        cases=_pairs_of_elements,
        deviation=_no_group,
        copies=(Copy("A₁A₂ᵀ for A₁A₂", _crossed), Copy("A₁ + A₂ - I for A₁A₂", _sum_of_shears)),
    ),
    Claim(
        id="bansal_tatu.3.3.lie_algebras",
        place="section 3.3",
        statement="The Lie algebras of SE(3), G_A and G_S are those printed, of dimensions 6, 5 and 1.",
        verdict=Verdict.CONFIRMED,
        form=BASIS,
        cases=lambda: ["SE(3)", "G_A", "G_S"],
        deviation=_no_algebra,
        copies=(
            Copy("α₅ = 0 in 𝔤_A", _changed("G_A", BASIS["G_A"][:4])),
            Copy("α₅ at the place below α₄'s row", _changed("G_A", (*BASIS["G_A"][:4], unit_matrix(3, 2, 0)))),
            Copy("Ω = Ωᵀ in one entry", _changed("SE(3)", (*BASIS["SE(3)"][1:], abs(BASIS["SE(3)"][0])))),
        ),
    ),
    Claim(
        id="bansal_tatu.3.3.dimension",
        place="section 3.3",
        statement="M = SE(3) x G_A x G_S has dimension 12, that of the affine maps: at the identity A S E has rank 12.",
        verdict=Verdict.CONFIRMED,
        form=BASIS,
        cases=lambda: [None],
        deviation=_twelve,
        copies=(Copy("no scale", _changed("G_S", (exactly([[0]]),))),),
    ),
    Claim(
        id="bansal_tatu.3.3.exponential",
        place="section 3.3",
        statement="The exponential of the product M is those of its factors, one beside the other.",
        verdict=Verdict.CONFIRMED,
        form=_concatenated(),
        cases=_tangents_of_product,
        deviation=equals(_of_product),
        copies=(Copy("exp(3 σ), the growth of the volume, for exp(σ)", _concatenated(3)),),
        remark="It is not that of the 4x4 matrices that A S E makes of its elements: (E, A, s) -> A S E is no "
        "homomorphism.",
    ),
)
