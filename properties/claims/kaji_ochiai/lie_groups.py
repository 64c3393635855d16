"""Section 6: the exponential maps of Lie groups, and what has a logarithm."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.kaji_ochiai.polar_factors import polar
from affinecert.properties.claims.kaji_ochiai.subspaces import CLASSES, outside
from affinecert.properties.claims.kaji_ochiai.symmetric_exponential import exponential
from affinecert.properties.claims.kaji_ochiai.symmetric_logarithm import logarithm
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.properties.laws.subclasses import Subclass
from affinecert.reference._existence import Logarithm
from affinecert.reference._existence import logarithm as real_logarithm
from affinecert.reference._matrices import Array, Context, Number


def _integer_maps() -> list[Array]:
    """Integer matrices, some with negative eigenvalues, simple or double."""
    corners = [
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[-1, 0, 0], [0, -2, 0], [0, 0, 1]],
        [[-1, 1, 0], [0, -1, 0], [0, 0, 1]],
    ]
    drawn = (16 * each for each in arrays("roots", 8, (3, 3), -0.5, 0.5))
    found = [np.array(each, dtype=object) for each in corners]
    return found + [np.vectorize(int, otypes=[object])(each) for each in drawn]


def _power_without_logarithm(power: int, root: Array) -> int:
    """Whether an integer power of a regular map has positive determinant, and no real logarithm."""
    matrix = root
    for _ in range(power - 1):
        matrix = matrix @ root
    if definitions.determinant(matrix) <= 0:
        return 0
    return int(real_logarithm(matrix.tolist()) is Logarithm.NONE)


def _root_of_exponential(part: int) -> Any:
    return lambda m, x: definitions.exponential(m, x / part)


def _not_a_root(root: Any, case: tuple[Array]) -> Number:
    found = root(mp, *case)
    return difference(found @ found, definitions.exponential(mp, *case))


def _orthogonal(matrix: Array) -> Array:
    """A rational orthogonal matrix, as a multiple of it by an integer, from Cayley's transform of three integers."""
    a, b, c = matrix
    unit, skew = np.eye(3, dtype=int).astype(object), np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]], dtype=object)
    # (I + K)(I - K)^-1 with (I - K)^-1 = (I + K + v v^T) / (1 + |v|^2).
    return np.asarray((unit + skew) @ (unit + skew + np.outer(matrix, matrix).astype(object)))


def _stretched(matrix: Array) -> Array:
    """A map of GL+(3), which is connected and not compact: a rotation after a stretch."""
    return np.asarray(_orthogonal(matrix) @ np.array([[9, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=object))


def _lacks_logarithm(member: Any, case: tuple[Array, int]) -> int:
    numbers, sign = case
    matrix = member(numbers) * sign
    if definitions.determinant(matrix) < 0:  # a logarithm makes the determinant exp of its trace
        return 1
    return int(real_logarithm(matrix.tolist()) is Logarithm.NONE)


def _integers(*signs: int) -> list[tuple[Array, int]]:
    triples = ([0, 0, 0], [1, 0, 0], [1, -2, 3], [9, 1, 2], [0, 40, 1])
    return [(np.array(each, dtype=object), sign) for each in triples for sign in signs]


def _algebra(extra: int) -> Any:
    """An element of the Lie algebra of a class; with an extra symmetric generator if told."""

    def element(numbers: Array, subclass: Subclass) -> Array:
        x = numbers[3:6] if subclass.turns else numbers[3:6] * 0
        scale = numbers[6] if subclass.stretch != "none" else numbers[6] * 0
        shift = numbers[:3] if subclass.moves else numbers[:3] * 0
        matrix = np.full((4, 4), mp.zero, dtype=object)
        matrix[:3, :3] = [[scale, -x[2], x[1]], [x[2], scale, -x[0]], [-x[1], x[0], scale]]
        matrix[:3, 3] = shift
        matrix[0, 1] += extra
        matrix[1, 0] += extra
        return matrix

    return element


def _exponential_leaves(algebra: Any, case: tuple[str, Array]) -> Number:
    name, numbers = case
    return outside(definitions.exponential(mp, algebra(numbers, CLASSES[name])), CLASSES[name])


def _subgroups() -> list[tuple[str, Array]]:
    return list(
        zip(("SO(3)", "R^3", "R+", "CO+(3)", "SE(3)", "Sim+(3)"), arrays("algebra", 6, (7,), -1, 1), strict=True)
    )


def _by_closed_forms(half: int) -> Any:
    """The polar factors by equations 7 and 6 only."""

    def factors(m: Context, linear: Array) -> tuple[Array, Array]:
        log_stretch = logarithm(half=half)(m, linear)
        rotation: Array = linear @ exponential()(m, -log_stretch)
        return rotation, exponential()(m, log_stretch)

    return factors


def _linears() -> list[tuple[Array]]:
    corners = [exactly([[2, 1, 0], [0, 1, 0], [0, 0, 1]]), exactly([[-1, 0, 0], [0, -2, 0], [0, 0, 1]])]
    drawn = [each for each in arrays("polar", 8, (3, 3), -2, 2) if definitions.determinant(each) > 0]
    return [(each,) for each in corners + drawn]


def _lie_elements() -> list[tuple[Array]]:
    return [(each,) for each in arrays("Lie elements", 4, (3, 3), -2, 2)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.6.compact_surjective",
        place="section 6, Lie algebras",
        statement="If a group is compact, its exponential map is surjective.",
        printed="When G is compact, this is surjective",
        verdict=Verdict.BOUND,
        domain="compact and connected, as SO(3); of O(3), compact too, it misses all reflections",
        form=_orthogonal,
        cases=lambda: _integers(1),
        outside=lambda: _integers(-1),
        deviation=_lacks_logarithm,
        copies=(Copy("a stretch after the rotations: GL+(3), connected and not compact", _stretched),),
    ),
    Claim(
        id="kaji_ochiai.6.subgroups",
        place="section 6, Lie algebras",
        statement="The exponential of the subalgebra of a subgroup stays in the subgroup: condition (V).",
        verdict=Verdict.CONFIRMED,
        form=_algebra(0),
        cases=_subgroups,
        deviation=_exponential_leaves,
        copies=(Copy("one symmetric generator besides", _algebra(1)),),
    ),
    Claim(
        id="kaji_ochiai.6.squares.if",
        place="section 6, the image of the exponential map",
        statement="A = B² of a regular real B has a real logarithm.",
        printed="A is in the image of the exponential map if and only if A = B² for some B",
        verdict=Verdict.CONFIRMED,
        form=2,
        cases=_integer_maps,
        deviation=_power_without_logarithm,
        copies=(Copy("B³ for B²", 3), Copy("B for B²", 1)),
    ),
    Claim(
        id="kaji_ochiai.6.squares.only_if",
        place="section 6, the image of the exponential map",
        statement="What has a logarithm X is a square, of exp(X/2).",
        verdict=Verdict.CONFIRMED,
        form=_root_of_exponential(2),
        cases=_lie_elements,
        deviation=_not_a_root,
        copies=(Copy("exp(X/3)", _root_of_exponential(3)),),
    ),
    Claim(
        id="kaji_ochiai.6.not_so_many",
        place="section 6, the image of the exponential map",
        statement="Maps without a logarithm are not so many.",
        verdict=Verdict.UNCHECKABLE,
        reason="How many are few is not said, nor among which maps.",
        remark="Of 3 by 3 matrices with independent normal entries and positive determinant 34 % have none, by "
        "200 000 drawn: whoever meets general maps has to provide for them.",
    ),
    Claim(
        id="kaji_ochiai.6.polar_by_closed_forms",
        place="section 6, the relation to the polar decomposition",
        statement="The closed forms give the polar decomposition, R = Â exp(-log S), S = exp(log S).",
        printed="the above relation provides an alternative method to compute the polar decomposition",
        verdict=Verdict.CONFIRMED,
        form=_by_closed_forms(2),
        cases=_linears,
        deviation=equals(polar),
        copies=(Copy("log(ᵗÂÂ) for its half", _by_closed_forms(1)),),
        remark="In float64 for well conditioned maps only, and not for similarities: see section 4.4.",
    ),
)
