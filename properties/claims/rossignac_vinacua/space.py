"""Appendix A.6: the powers of affine maps of space, by one real eigenvalue and a plane."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.errors import InputError
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.definitions import determinant, eigenvalues, exponential, inverse
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import distance, equals, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.plane_logarithm import logarithm
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, array, cross, homogeneous, identity


def _rotating(size_of: int, case: int) -> int:
    """Whether one of twelve matrices has no real eigenvalue."""
    drawn = arrays(f"real eigenvalue {case}", 12, (size_of, size_of), -2, 2)
    gaps = [min(abs(mp.im(value)) for value in eigenvalues(mp, each)) for each in drawn]
    return int(max(gaps) > mp.mpf(10) ** -30)


def null(matrix: Array) -> Array:
    """A vector that is orthogonal to all rows of a matrix of rank 2 or 1."""
    products = [cross(matrix[i], matrix[j]) for i, j in ((0, 1), (0, 2), (1, 2))]
    longest: Array = max(products, key=size)
    if size(longest) > mp.mpf(10) ** -40:
        return longest
    row: Array = max(matrix, key=size)
    return cross(row, identity(mp, 3)[int(np.argmin([abs(each) for each in row]))])


def _split(*, scaled: bool = True, orthogonal: bool = False) -> Any:
    """Log L as log λ along an eigenvector and the logarithm in the invariant plane of the others."""

    def printed(m: Context, linear: Array, value: Number) -> Array:
        moving = linear - value * identity(m, 3)
        along, normal = null(moving), null(moving.T)
        normal = along if orthogonal else normal  # the plane is orthogonal to the left eigenvector
        first = null(array([normal.tolist()] * 3))
        basis = np.stack([along, first, cross(normal, first)], axis=1)
        inside = inverse(m, basis) @ linear @ basis
        found = inside * 0
        found[0, 0] = m.log(value) if scaled else value - 1
        found[1:, 1:] = logarithm(m, inside[1:, 1:])
        whole: Array = basis @ found @ inverse(m, basis)
        return whole

    return printed


def _whole_logarithm(m: Context, linear: Array) -> Array:
    found: Array = sam.log(m, homogeneous(m, linear, array([m.zero] * 3)))[:3, :3]
    return found


def _not_split(form: Any, case: tuple[Array, Number]) -> Number:
    """How far from the logarithm; infinite where the plane has none, or is none."""
    try:
        return distance(form(mp, *case), _whole_logarithm(mp, case[0]))
    except InputError:
        return mp.inf


def turned(block: Any, name: str = "") -> Array:
    """A block in another basis, of determinant 1 and integers, so that it stays exact; in its own for no name."""
    lower, upper = identity(mp, 3), identity(mp, 3)
    if name:
        for k, (i, j) in enumerate(((0, 1), (0, 2), (1, 2))):
            lower[j, i], upper[i, j] = mp.mpf((len(name) + k) % 3 - 1), mp.mpf(1 - (2 * len(name) + k) % 3)
    basis = lower @ upper
    found: Array = basis @ exactly(block) @ inverse(mp, basis)
    return found


def _to_split() -> list[tuple[Array, Number]]:
    blocks: list[tuple[Any, Any]] = [
        ([[2, 0, 0], [0, 3, 0], [0, 0, 4]], 2),
        ([[2, 0, 0], [0, 0, -1], [0, 1, 0]], 2),
        ([[3, 0, 0], [0, 2, 1], [0, 0, 2]], 3),
        ([[0.5, 0, 0], [0, -1, -2], [0, 1, -1]], 0.5),
        ([[2, 0, 0], [0, 2 + 2.0**-20, 1], [0, 0, 2 + 2.0**-20]], 2),
    ]
    return [(turned(block, "basis"[: k + 1]), mp.mpf(value)) for k, (block, value) in enumerate(blocks)]


def _not_to_split() -> list[tuple[Array, Number]]:
    jordan = [[2, 1, 0], [0, 2, 1], [0, 0, 2]]
    half_turn = [[3, 0, 0], [0, -2, 0], [0, 0, -2]]
    return [
        (exactly(jordan), mp.mpf(2)),
        (turned(jordan, "basis"), mp.mpf(2)),
        (exactly(half_turn), mp.mpf(-2)),
        (exactly([[2, 1, 0], [0, 2, 0], [0, 0, 3]]), mp.mpf(2)),
    ]


def _one(linear: Array) -> bool:
    return not determinant(linear - identity(mp, 3))


def _one_or_jordan(index: int) -> Any:
    """1 is an eigenvalue, or N = L - trace / 3 is nilpotent of the index, with N^(index - 1) ≠ 0."""

    def needs_care(linear: Array) -> bool:
        nilpotent = linear - linear.trace() / 3 * identity(mp, 3)
        powers = [np.linalg.matrix_power(nilpotent, k) for k in (index - 1, index)]
        return _one(linear) or bool(size(powers[0]) and not size(powers[1]))

    return needs_care


def _misjudged(form: Callable[[Array], bool], linear: Array) -> int:
    """Whether no case is told for a matrix that has no eigenvector with an invariant plane beside it.

    Those are the matrices of a single Jordan block: a plane that is invariant under it is in the image of L - λ, as is
    the eigenvector. Also whether one is told where neither is so nor 1 an eigenvalue.
    """
    nilpotent = linear - linear.trace() / 3 * identity(mp, 3)
    single = bool(size(nilpotent @ nilpotent)) and not size(nilpotent @ nilpotent @ nilpotent)
    return int(form(linear) != (single or _one(linear)))


def _blocks() -> list[Array]:
    kinds = [[2, 0, 0], [0, 3, 0], [0, 0, 4]], [[1, 0, 0], [0, 3, 0], [0, 0, 4]], [[2, 1, 0], [0, 2, 0], [0, 0, 2]]
    jordan = [[2, 1, 0], [0, 2, 1], [0, 0, 2]], [[1, 1, 0], [0, 1, 1], [0, 0, 1]]
    return [exactly(each) for each in (*kinds, *jordan)]


def _cardano(m: Context, c: Array, sign: int = 1) -> list[Number]:
    """The eigenvalues, by the roots of the characteristic cubic."""
    mean = c.trace() / 3
    shifted = c - mean * identity(m, 3)
    p, q = -(shifted @ shifted).trace() / 2, -determinant(shifted)
    root = m.sqrt(m.mpc(q * q / 4 + p * p * p / 27))
    sums = [-q / 2 + root, -q / 2 - root]
    u = m.power(max(sums, key=abs), m.one / 3)
    third = m.mpc(-0.5, m.sqrt(m.mpf(3)) / 2)
    return [mean + u * third**k - sign * p / (3 * u * third**k) for k in range(3)]


def _sylvester(sign: int = 1, *, at: float = 1) -> Any:
    """The sum of e^λ_i times the products of (C - λ_j) / (λ_i - λ_j), j other than i."""

    def printed(m: Context, c: Array) -> Array:
        values = _cardano(m, c, sign)
        total = 0 * identity(m, 3)
        for i, value in enumerate(values):
            term = m.exp(at * value) * identity(m, 3)
            for other in (*values[:i], *values[i + 1 :]):
                term = term @ (c - other * identity(m, 3)) / (value - other)
            total = total + term
        return array([[m.re(each) for each in row] for row in total])

    return printed


def _cubic_matrices() -> list[tuple[Array]]:
    simple = [[1, 0, 0], [0, 2, 0], [0, 0, 4]], [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    return [(exactly(each),) for each in simple] + [(each,) for each in arrays("cubic", 5, (3, 3), -1, 1)]


def _in_reach(form: Callable[[Array], bool], case: tuple[Array]) -> int:
    """Whether a closed form by the roots of the cubic gives the exponential although none is told to be in reach."""
    (c,) = case
    return int(form(c) != bool(distance(_sylvester()(mp, c), exponential(mp, c)) < mp.mpf(10) ** -40))


def _well_conditioned(linear: Any, least: Number) -> Number:
    """What the condition number of the unit eigenvectors, as far as two of them tell it, falls short of ``least``."""
    _, vectors = mp.eig(mp.matrix(linear))
    columns = [array([vectors[i, k] for i in range(3)]) for k in range(3)]
    units = [each / mp.sqrt(each @ each) for each in columns]
    cosine = max(abs(a @ b) for a, b in itertools.combinations(units, 2))
    return max(1 - mp.sqrt((1 + cosine) / (1 - cosine)) / least, mp.zero)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.A.6.real_eigenvalue",
        place="appendix A.6",
        statement="In three dimensions L has at least one real eigenvalue.",
        printed="3",
        verdict=Verdict.CONFIRMED,
        form=3,
        cases=lambda: [0, 1],
        deviation=_rotating,
        copies=(Copy("in two dimensions", 2), Copy("in four dimensions", 4)),
    ),
    Claim(
        id="rossignac_vinacua.A.6.split",
        place="appendix A.6",
        statement="The problem splits into a scaling along an eigenvector of a real eigenvalue of L, and a SAM of the "
        "plane of the other, possibly generalised, eigenvectors.",
        verdict=Verdict.BOUND,
        domain="the eigenvalue is positive, and its eigenvector not in the image of L - λ (no Jordan block of its own)",
        form=_split(),
        cases=_to_split,
        outside=_not_to_split,
        deviation=_not_split,
        copies=(
            Copy("the plane orthogonal to the eigenvector", _split(orthogonal=True)),
            Copy("λ - 1 for log λ", _split(scaled=False)),
        ),
        remark="Generalised eigenvectors of λ itself span no invariant plane beside its eigenvector. Section 4 has it "
        "that a positive eigenvalue exists and is to be taken.",
    ),
    Claim(
        id="rossignac_vinacua.A.6.only_one",
        place="appendix A.6",
        statement="With that the problem is solved but for the singular cases where some eigenvalue is 1.",
        printed="all that really needs to be carefully discussed are the singular cases where some eigenvalue is one",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_one,
        cases=_blocks,
        deviation=_misjudged,
        correction=Correction(
            statement="A triple eigenvalue with a single eigenvector is a case of its own as well.",
            form=_one_or_jordan(3),
        ),
        copies=(Copy("a triple eigenvalue with two eigenvectors", _one_or_jordan(2)),),
        remark="For L = λ + N, N³ = 0, log L = log λ + N/λ - N²/(2 λ²).",
    ),
    Claim(
        id="rossignac_vinacua.A.6.closed_form",
        place="appendix A.6",
        statement="In 3D a closed form of the exponential by the algebraic expressions of the eigenvalues appears "
        "beyond reach.",
        printed="appears beyond reach",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=lambda c: False,
        cases=_cubic_matrices,
        deviation=_in_reach,
        correction=Correction(
            statement="With Cardano's roots λ_i of the cubic, e^C = sum of e^λ_i times the products of "
            "(C - λ_j) / (λ_i - λ_j), as long as they differ.",
            form=_sylvester(),
            deviation=equals(exponential),
        ),
        copies=(
            Copy("u + p / (3 u) for Cardano's root u - p / (3 u)", _sylvester(-1)),
            Copy("e^(2λ)", _sylvester(at=2)),
        ),
        losses=(
            Loss(
                where="eigenvalues 0, 1e-5 and 2e-5",
                formula=_sylvester(),
                truth=exponential,
                at=([[0.0, 1.0, 1.0], [0.0, 1e-5, 1.0], [0.0, 0.0, 2e-5]],),
                digits=9,
            ),
        ),
        remark="Kaji and Ochiai print such forms for symmetric matrices. Where eigenvalues meet, they lose all.",
    ),
    Claim(
        id="rossignac_vinacua.A.6.ill_conditioned",
        place="appendix A.6",
        statement="As L need not be symmetric, its eigenvectors need not be orthogonal; their matrix can have a "
        "condition number of 1e15.",
        printed="10¹⁵",
        verdict=Verdict.CONFIRMED,
        form=[[1, 1, 0], [0, 1 + 2.0**-50, 0], [0, 0, 2]],
        cases=lambda: [mp.mpf(10) ** 15],
        deviation=_well_conditioned,
        copies=(Copy("a symmetric matrix", [[1, 1, 0], [1, 1 + 2.0**-50, 0], [0, 0, 4]]),),
    ),
    Claim(
        id="rossignac_vinacua.A.6.condition_1e15",
        place="appendix A.6",
        statement="The reference implementation computes a solution even for condition numbers of the order of 1e15.",
        verdict=Verdict.UNCHECKABLE,
        reason="neither that implementation nor its input is given, nor how accurate the solution was",
    ),
)
