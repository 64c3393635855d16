"""Section 7.1: regular patterns, the samples of a steady motion, and roots of an affine map."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.definitions import inverse
from affinecert.properties.claims.draws import affine, plane_rotation
from affinecert.properties.claims.precision import distance, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.poses import affines, controls, morph, power
from affinecert.reference import morphs
from affinecert.reference._matrices import Array, Context, Number, array, identity, scalar

_Morph = Callable[[Context, Array, Array, Number], Array]


def _other(name: str) -> _Morph:
    def moved(m: Context, start: Array, end: Array, t: Number) -> Array:
        return morphs.MORPHS[name](m, start, end, scalar(t))

    return moved


def _pairs() -> list[tuple[Array, Array]]:
    unit = identity(mp, 3)
    quarter = affine([[0, -1], [1, 0]], [1, 0])
    pairs = [(unit, affine([[1, 0], [0, 1]], [1, 0])), (unit, quarter), (unit, affine([[2, 0], [0, 1]], [0, 1]))]
    for size in (2, 3):
        poses = controls(f"patterns of {size}", 4, size)
        pairs += [(poses[0], poses[1]), (poses[2], poses[3])]
    return pairs


def _unequal_steps(moved: _Morph, case: tuple[Array, Array]) -> Number:
    """How far the maps from each of five poses to the next are from the first of them."""
    poses = [moved(mp, *case, mp.mpf(k) / 3) for k in range(5)]
    steps = [after @ inverse(mp, before) for before, after in itertools.pairwise(poses)]
    return max(distance(step, steps[0]) for step in steps[1:])


def _root(extra: int = 0) -> Any:
    def root(m: Context, matrix: Array, count: int) -> Array:
        return power(m, matrix, m.one / (count + extra))

    return root


def _straight_root(m: Context, matrix: Array, count: int) -> Array:
    found: Array = identity(m, len(matrix)) + (matrix - identity(m, len(matrix))) / count
    return found


def _is_no_root(form: Any, case: tuple[Array, int]) -> Number:
    """The distance of M^n from A."""
    matrix, count = case
    step = form(mp, matrix, count)
    return distance(np.linalg.matrix_power(step, count), matrix)


def _ends() -> list[tuple[Array, int]]:
    return [(affine([[0, -1], [1, 0]], [1, 0]), 2)] + [
        (each, count) for each, count in zip([*affines("ends", 4), *affines("ends", 3, 3)], range(2, 9), strict=True)
    ]


def _turning(angle: Number, growth: int = 1) -> Array:
    return affine((growth * plane_rotation(angle)).tolist(), [1, 2])


def _recovered(form: Any, case: tuple[Array, int]) -> Number:
    """How far the root of M^n is from M."""
    step, count = case
    return distance(form(mp, np.linalg.matrix_power(step, count), count), step)


def _below_a_half_turn() -> list[tuple[Array, int]]:
    nearly = 1 - mp.mpf(2) ** -20
    return [(_turning(nearly * mp.pi / count, growth), count) for count in (2, 3, 7) for growth in (1, 2)]


def _beyond_a_half_turn() -> list[tuple[Array, int]]:
    more = 1 + mp.mpf(2) ** -20
    return [(_turning(more * mp.pi / count, growth), count) for count in (2, 3, 7) for growth in (1, 2)]


def _tangents(rank: int) -> list[Array]:
    """The first ``rank`` of a basis of all changes of a map of the plane."""
    basis = []
    for row in range(2):
        for column in range(3):
            change = np.zeros((3, 3), dtype=object)
            change[row, column] = 1
            basis.append(change)
    return basis[:rank]


def _undetermined(count: int, case: tuple[Any, int]) -> int:
    """Whether so many variables are other than what M^n(F_0) takes: the rank of its derivative by M, exactly."""
    rows, repetitions = case
    step = np.array([[*map(Fraction, row)] for row in [*rows, [0, 0, 1]]], dtype=object)
    powers = [np.linalg.matrix_power(step, k) for k in range(repetitions)]
    changes = [
        sum(powers[k] @ change @ powers[repetitions - 1 - k] for k in range(repetitions)) for change in _tangents(6)
    ]
    return int(_rank([list(change[:2].flat) for change in changes]) != count)


def _rank(rows: list[list[Fraction]]) -> int:
    left, rank = [list(row) for row in rows], 0
    for column in range(len(rows[0])):
        pivot = next((row for row in left if row[column]), None)
        if pivot is None:
            continue
        rank += 1
        left = [[x - row[column] / pivot[column] * p for x, p in zip(row, pivot, strict=True)] for row in left]
    return rank


def _vertices(pose: Array) -> Array:
    """The triangle that a pose makes of 0, e_1, e_2, vertices in columns."""
    vertices: Array = pose @ exactly([[0, 1, 0], [0, 0, 1], [1, 1, 1]])
    return vertices


def _end_of(first: Array, count: int) -> Array:
    """The triangle M^n(F_0), where F_0 is 0, e_1, e_2 and F_1 = M(F_0) has the vertices ``first``, in columns."""
    step = first @ inverse(mp, exactly([[0, 1, 0], [0, 0, 1], [1, 1, 1]]))
    return _vertices(np.linalg.matrix_power(step, count))


def _dragged(first: Array, by: Number) -> Array:
    """The triangle with its second vertex moved to the right."""
    moved = first.copy()
    moved[0, 1] = moved[0, 1] + by
    return moved


def _other_vertices_stay(count: Callable[[int], int], case: tuple[Array, int]) -> int:
    """Whether dragging one vertex of F_1 leaves both other vertices of F_n where they are."""
    first, repetitions = case
    change = _end_of(_dragged(first, mp.one / 8), count(repetitions)) - _end_of(first, count(repetitions))
    return int(distance(change[:, [0, 2]], array([[0, 0]] * 3)) < mp.mpf(10) ** -30)


def _in_proportion(count: Callable[[int], int], case: tuple[Array, int]) -> int:
    """Whether F_n changes in proportion to the drag."""
    first, repetitions = case
    near, far = (
        _end_of(_dragged(first, by), count(repetitions)) - _end_of(first, count(repetitions))
        for by in (mp.one / 8, mp.one / 4)
    )
    return int(distance(far, 2 * near) < mp.mpf(10) ** -30)


def _designs() -> list[tuple[Array, int]]:
    return [(_vertices(each), count) for each, count in zip(affines("designs", 5), (2, 3, 4, 5, 8), strict=True)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.7.1.constant_step",
        place="section 7.1",
        statement="Samples of a SAM at constant time steps make a regular pattern: one affinity maps each to the next.",
        printed="F_k = A^(kΔ)(F_0), A^((k+1)Δ) = A^Δ ∘ A^(kΔ)",
        verdict=Verdict.CONFIRMED,
        form=morph,
        cases=_pairs,
        deviation=_unequal_steps,
        copies=(
            Copy("poses in straight lines", _other("linear")),
            Copy("rARAP", _other("rarap")),
            Copy("Alexa's blend of logarithms", _other("alexa_2002")),
        ),
    ),
    Claim(
        id="rossignac_vinacua.7.1.root",
        place="section 7.1",
        statement="M = A^(1/n) is an n-th root of A: n steps of it lead from the first pose to the last.",
        printed="M = A^(1/n), F_n = Mⁿ(F_0)",
        verdict=Verdict.CONFIRMED,
        form=_root(),
        cases=_ends,
        deviation=_is_no_root,
        copies=(
            Copy("the root of order n + 1", _root(1)),
            Copy("the n-th part of the way in a straight line", _straight_root),
        ),
    ),
    Claim(
        id="rossignac_vinacua.7.1.reverse",
        place="section 7.1",
        statement="EAR computes M from the repetition count n and the cumulative affinity A = Mⁿ.",
        printed="M = A^(1/n) for A = Mⁿ",
        verdict=Verdict.BOUND,
        domain="M turns by less than π/n; beyond that the principal root of Mⁿ is another root than M",
        form=_root(),
        cases=_below_a_half_turn,
        outside=_beyond_a_half_turn,
        deviation=_recovered,
        copies=(Copy("the root of order n + 1", _root(1)),),
        remark="A pattern of more than half a turn in all, such as a full circle, needs the step itself, or its turns.",
    ),
    Claim(
        id="rossignac_vinacua.7.1.six_variables",
        place="section 7.1",
        statement="In the plane a designer without roots has to guess six variables, the coefficients of M.",
        printed="6",
        verdict=Verdict.CONFIRMED,
        form=6,
        cases=lambda: [([[1, 0, 0], [0, 1, 0]], 2), ([[2, 1, 3], [0, 1, 1]], 3), ([[0, -1, 1], [2, 1, 0]], 4)],
        deviation=_undetermined,
        copies=(Copy("four, as of a similarity", 4), Copy("nine, of a homogeneous matrix", 9)),
    ),
    Claim(
        id="rossignac_vinacua.7.1.no_separation",
        place="section 7.1",
        statement="Dragging one vertex of F_1 = M(F_0) moves the other vertices of Mⁿ(F_0) as well, for n > 1.",
        verdict=Verdict.CONFIRMED,
        form=lambda count: count,
        cases=_designs,
        deviation=_other_vertices_stay,
        copies=(Copy("a pattern of one step", lambda count: 1),),
    ),
    Claim(
        id="rossignac_vinacua.7.1.not_linear",
        place="section 7.1",
        statement="As a vertex of F_1 = M(F_0) is dragged, Mⁿ(F_0), n > 1, does not change in proportion.",
        verdict=Verdict.CONFIRMED,
        form=lambda count: count,
        cases=_designs,
        deviation=_in_proportion,
        copies=(Copy("a pattern of one step", lambda count: 1),),
    ),
    Claim(
        id="rossignac_vinacua.7.1.impossible_by_hand",
        place="section 7.1",
        statement="Without EAR it is nearly impossible for a designer to find F_1 such that Mⁿ(F_0) is a given pose.",
        verdict=Verdict.UNCHECKABLE,
        reason="a statement on what people manage by trial and error; no study is given",
    ),
)
