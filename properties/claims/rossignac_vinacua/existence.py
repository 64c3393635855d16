"""Section 5.1: which affinities have a real logarithm."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np

from affinecert.errors import InputError
from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import plane_rotation, rotations
from affinecert.properties.claims.precision import distance, equals, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.jordan_blocks import (
    Block,
    has_real_logarithm,
    integer_matrix_has_real_logarithm,
    matrix_of,
    real_logarithm,
)
from affinecert.properties.claims.rossignac_vinacua.reduction import exists
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous, identity

Blocks = tuple[Block, ...]


def _structures() -> list[Blocks]:
    """Jordan structures of orientation-preserving maps of the plane and of space."""
    plane: list[Blocks] = [((1, 1), (2, 1)), ((2, 2),), ((-1, 1), (-1, 1)), ((-1, 1), (-2, 1)), ((-1, 2),)]
    space: list[Blocks] = [(*blocks, (3, 1)) for blocks in plane]
    return [*plane, *space, ((1, 1), (-1, 2)), ((1, 3),), ((1, 2), (1, 1))]


def _larger_structures() -> list[Blocks]:
    return [((-1, 2), (-1, 2)), ((-2, 2), (-2, 2), (1, 1)), ((-1, 3), (-1, 3))]


def _multiplicities(even: bool = True, equal: bool = True) -> Any:
    """Of every negative eigenvalue, the algebraic and the geometric multiplicity are equal and even."""

    def condition(blocks: Blocks) -> bool:
        negative = [block for block in blocks if block[0] < 0]
        algebraic = Counter[int]()
        for value, length in negative:
            algebraic[value] += length
        geometric = Counter(value for value, _ in negative)
        values = algebraic.keys()
        return (not even or all(algebraic[each] % 2 == 0 for each in values)) and (
            not equal or all(algebraic[each] == geometric[each] for each in values)
        )

    return condition


def _double_with_two_eigenvectors(eigenvectors: bool = True, double: bool = True) -> Any:
    def condition(blocks: Blocks) -> bool:
        negative = [block for block in blocks if block[0] < 0]
        if not negative:
            return True
        total = sum(length for _, length in negative)
        one_value = len({value for value, _ in negative}) == 1 if double else True
        return total == 2 and one_value and (len(negative) == 2 or not eigenvectors)

    return condition


def _wrong_condition(condition: Any, blocks: Blocks) -> int:
    """Whether a condition is not that of Culver's theorem, whose pairs of blocks are given their real logarithm."""
    for value, length in {block for block in blocks if block[0] < 0}:
        pair, generator = real_logarithm(value, length)
        if distance(definitions.exponential(mp, generator), pair) > mp.mpf(10) ** -50:
            raise ValueError(f"no logarithm of two blocks {value}, {length}")
    matrix = matrix_of(blocks)
    truth = has_real_logarithm(blocks)
    if truth is not integer_matrix_has_real_logarithm(matrix):
        raise ValueError(f"the matrix has not the blocks {blocks}")
    if len(matrix) <= 3 and truth is not sam.exists_exactly(np.array(matrix, dtype=float).tolist()):
        raise ValueError(f"the reference decides {blocks} otherwise")
    return int(condition(blocks) is not truth)


def _positive_diagonal(exponentiated: int = 1) -> Any:
    """P diag(log x) P^-1 as the logarithm of P diag(x) P^-1."""

    def logarithm(m: Context, basis: Array, values: Array) -> Array:
        logs = np.diag(np.array([m.log(each) for each in values], dtype=object)) * exponentiated
        found: Array = basis @ logs @ definitions.inverse(m, basis)
        return found

    return logarithm


def _diagonalised() -> list[tuple[Array, Array]]:
    bases = [exactly([[1, 0], [0, 1]]), exactly([[1, 1], [0, 1]]), exactly([[1, 1, 0], [0, 1, 2], [1, 0, 1]])]
    return [(bases[0], exactly([2, 3])), (bases[1], exactly([0.5, 4])), (bases[2], exactly([0.25, 1, 5]))]


def _no_logarithm_of(logarithm: Any, case: tuple[Array, Array]) -> Number:
    basis, values = case
    matrix = basis @ np.diag(values) @ definitions.inverse(mp, basis)
    return distance(definitions.exponential(mp, logarithm(mp, basis, values)), matrix)


def _has_logarithm(linear: Array, _: None) -> int:
    """Whether a map is no orientation-preserving one without a real logarithm."""
    return int(definitions.determinant(linear) <= 0 or exists(linear))


def _similarity(stretch: Number = 1) -> Any:
    def similarity(scale: Number, rotation: Array) -> Array:
        scaled: Array = scale * rotation
        scaled[0] = stretch * scaled[0]
        return scaled

    return similarity


def _similarities() -> list[tuple[Number, Array]]:
    half_turns = [exactly([[-1, 0], [0, -1]]), exactly([[-1, 0, 0], [0, -1, 0], [0, 0, 1]])]
    plane = [plane_rotation(mp.mpf(angle)) for angle in (1, -3)]
    turns = [*half_turns, *plane, *rotations("similarities", 4)]
    return [(mp.mpf(scale), turn) for scale, turn in zip((1, 2, 0.5, 3, 0.25, 1, 1.5, 0.125), turns, strict=True)]


def _no_logarithm(similarity: Any, case: tuple[Number, Array]) -> Number:
    linear = similarity(*case)
    try:
        generator = sam.log(mp, homogeneous(mp, linear, array([mp.zero] * len(linear))))
    except InputError:
        return mp.one
    return distance(definitions.exponential(mp, generator)[:-1, :-1], linear)


def _gram(power: int = 2) -> Any:
    def expected(m: Context, linear: Array, s: Number) -> Array:
        scaled: Array = identity(m, len(linear)) * s**power
        return scaled

    return expected


def _gram_matrix(_: Context, linear: Array, s: Number) -> Array:
    product: Array = linear.T @ linear
    return product


def _half_turns() -> list[tuple[Array, Number]]:
    return [(exactly(matrix_of(((-s, 1), (-s, 1))).tolist()), mp.mpf(s)) for s in (1, 2, 5)]


def _half_turns_of_space() -> list[tuple[Array, Number]]:
    skewed = exactly([[-1, 0, 1], [0, -1, 0], [0, 0, 1]])
    return [(exactly([[-1, 0, 0], [0, -1, 0], [0, 0, 2]]), mp.one), (skewed, mp.one)]


def _nearby(epsilon: Number) -> Array:
    return array([[-mp.one, mp.zero], [mp.zero, -1 - epsilon]])


def _turned_a_little_less(epsilon: Number) -> Array:
    return array([[-mp.one, -epsilon], [epsilon, -mp.one]])


def _near_and_without(path: Any, epsilon: Number) -> int:
    linear = path(epsilon)
    near = size(linear + identity(mp, 2)) <= epsilon
    return int(not near or exists(linear))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.5.1.positive_diagonal",
        place="section 5.1",
        statement="A matrix that diagonalises into positive entries has a real logarithm (that of the entries).",
        verdict=Verdict.CONFIRMED,
        form=_positive_diagonal(),
        cases=_diagonalised,
        deviation=_no_logarithm_of,
        copies=(Copy("the negative of the logarithm", _positive_diagonal(-1)),),
    ),
    Claim(
        id="rossignac_vinacua.5.1.culver",
        place="section 5.1, Culver's characterisation",
        statement="log(L) is real if and only if of each negative eigenvalue of L the algebraic and the geometric "
        "multiplicity are equal and even.",
        verdict=Verdict.BOUND,
        domain="matrices of size 2 and 3. Culver's condition is that the Jordan blocks of each size come in pairs; "
        "in size 4 two blocks [[-1, 1], [0, -1]] have a real logarithm with multiplicities 4 and 2",
        form=_multiplicities(),
        cases=_structures,
        outside=_larger_structures,
        deviation=_wrong_condition,
        copies=(
            Copy("even alone, equal is dropped", _multiplicities(equal=False)),
            Copy("equal alone, even is dropped", _multiplicities(even=False)),
        ),
        remark="The homogeneous matrices of space are 4 by 4; there the eigenvalue 1 leaves room for two negative "
        "blocks of size 1 at most, and nothing changes.",
    ),
    Claim(
        id="rossignac_vinacua.5.1.dimensions_2_and_3",
        place="section 5.1",
        statement="In dimensions 2 and 3, for det L > 0: log(L) is real if and only if a negative eigenvalue, if there "
        "is one, is double with two linearly independent eigenvectors.",
        verdict=Verdict.CONFIRMED,
        form=_double_with_two_eigenvectors(),
        cases=_structures,
        deviation=_wrong_condition,
        copies=(
            Copy("one eigenvector is enough", _double_with_two_eigenvectors(eigenvectors=False)),
            Copy("the two may differ", _double_with_two_eigenvectors(double=False)),
        ),
    ),
    Claim(
        id="rossignac_vinacua.5.1.not_every_affinity",
        place="section 5.1, against Alexa et al. 2000",
        statement="There are orientation-preserving affinities without a real logarithm, such as diag(-1, -2).",
        verdict=Verdict.CONFIRMED,
        form=exactly([[-1, 0], [0, -2]]),
        cases=lambda: [None],
        deviation=_has_logarithm,
        copies=(
            Copy("diag(-1, -1), a half turn", exactly([[-1, 0], [0, -1]])),
            Copy("diag(-1, 2), which reverses the orientation", exactly([[-1, 0], [0, 2]])),
        ),
    ),
    Claim(
        id="rossignac_vinacua.5.1.similarities",
        place="section 5.1",
        statement="Every orientation-preserving similarity has a real logarithm.",
        verdict=Verdict.CONFIRMED,
        form=_similarity(),
        cases=_similarities,
        deviation=_no_logarithm,
        copies=(Copy("a sixteenth more in the first row", _similarity(mp.mpf(17) / 16)),),
    ),
    Claim(
        id="rossignac_vinacua.5.1.double_negative",
        place="section 5.1",
        statement="With a double negative eigenvalue -s that has two independent eigenvectors, L is a rotation by 180 "
        "degrees combined with a uniform scaling by s.",
        verdict=Verdict.BOUND,
        domain="the plane. In space only the plane of the eigenvectors is turned: diag(-1, -1, 2), or eigenvectors "
        "that are not orthogonal to it",
        form=_gram(),
        cases=_half_turns,
        outside=_half_turns_of_space,
        deviation=equals(_gram_matrix),
        copies=(Copy("a scaling by the root of s", _gram(1)),),
    ),
    Claim(
        id="rossignac_vinacua.5.1.arbitrarily_near",
        place="section 5.1",
        statement="Arbitrarily near to a half turn there are affinities without a real logarithm, with two distinct "
        "negative eigenvalues.",
        verdict=Verdict.CONFIRMED,
        form=_nearby,
        cases=lambda: [mp.mpf(2) ** -k for k in (1, 10, 50, 200)],
        deviation=_near_and_without,
        copies=(Copy("a little less than a half turn", _turned_a_little_less),),
    ),
)
