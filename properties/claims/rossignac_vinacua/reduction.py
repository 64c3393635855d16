"""Section 5.2: what the existence of a steady morph depends on, down to an angle and a singular value of the plane."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays, numbers, plane_rotation
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.jordan_blocks import (
    Block,
    integer_matrix_has_real_logarithm,
    matrix_of,
)
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Context, Number, array, homogeneous

BLOCKS: tuple[tuple[Block, ...], ...] = (
    ((-1, 1), (-2, 1)),
    ((-1, 1), (-1, 1)),
    ((-1, 2),),
    ((1, 1), (2, 1)),
    ((1, 1), (-1, 2)),
    ((1, 1), (-3, 1), (-3, 1)),
    ((2, 1), (-1, 1), (-4, 1)),
    ((1, 3),),
)
"""Jordan structures of maps with and without a real logarithm, with and without the eigenvalue 1."""


def exists(linear: Array) -> bool:
    """Whether a linear map has a real logarithm; not if its determinant is not positive."""
    if definitions.determinant(linear) <= 0:
        return False
    return sam.exists(mp, homogeneous(mp, linear, array([mp.zero] * len(linear))))


def _with_translation(linear: Any, translation: Any) -> Any:
    """The homogeneous matrix."""
    whole = np.full((len(linear) + 1, len(linear) + 1), 0, dtype=object)
    whole[:-1, :-1], whole[:-1, -1], whole[-1, -1] = linear, translation, 1
    return whole


def _with_shifted_diagonal(linear: Any, translation: Any) -> Any:
    """The same, with the translation added to the diagonal of the linear part too."""
    return _with_translation(linear + np.diag(translation), translation)


def _translations() -> list[tuple[Any, Any]]:
    linears = [matrix_of(blocks) for blocks in BLOCKS]
    return [(each, np.array([k + 1, -k, 2][: len(each)], dtype=object)) for k, each in enumerate(linears)]


def _translation_matters(moved: Any, case: tuple[Any, Any]) -> int:
    """Whether Culver's theorem says otherwise of the homogeneous matrix than of the linear part."""
    linear, translation = case
    return int(
        integer_matrix_has_real_logarithm(moved(linear, translation)) is not integer_matrix_has_real_logarithm(linear)
    )


def _integer_maps() -> list[Array]:
    return [exactly(matrix_of(blocks).tolist()) for blocks in BLOCKS]


def _matters(change: Callable[[Array], Array], linear: Array) -> int:
    return int(exists(change(linear)) is not exists(linear))


def _space_maps() -> list[Array]:
    drawn = [each for each in arrays("space", 40, (3, 3), -2, 2) if definitions.determinant(each) > 0]
    return [exactly(np.diag(each).tolist()) for each in ([1, 1, 1], [-1, -2, 3])] + drawn[:10]


def _positive(linear: Array) -> tuple[Number, Number]:
    """An interval of positive numbers that holds an eigenvalue: from 0 to a bound of all eigenvalues."""
    return mp.zero, 3 * size(linear) + 1


def _negative(linear: Array) -> tuple[Number, Number]:
    return -3 * size(linear) - 1, mp.zero


def _no_eigenvalue_between(interval: Any, linear: Array) -> int:
    """Whether the characteristic polynomial has one sign at both ends."""
    at = [definitions.determinant(end * exactly(np.eye(3).tolist()) - linear) for end in interval(linear)]
    return int(not at[0] * at[1] < 0)


def _rest(linear: Array) -> Array:
    """The restriction to the complement, where ``linear`` is [[good, *], [0, rest]]."""
    return linear[1:, 1:]


def _first(linear: Array) -> Array:
    return linear[:2, :2]


def _triangular() -> list[Array]:
    """[[good, *], [0, rest]], the good eigenvalue positive, also where it is an eigenvalue of the rest."""
    rests = [[[-1, 0], [0, -2]], [[-1, 0], [0, -1]], [[-1, 1], [0, -1]], [[0, -2], [1, 1]], [[3, 1], [0, 2]]]
    return [exactly([[3, k, 1], [0, *rest[0]], [0, *rest[1]]]) for k, rest in enumerate(rests)]


def _decided_otherwise(restriction: Any, triangular: Array) -> int:
    basis = exactly([[1, 0, 0], [2, 1, 0], [1, -1, 1]])
    whole = basis @ triangular @ definitions.inverse(mp, basis)
    return int(exists(restriction(triangular)) is not exists(array([[mp.nint(x) for x in row] for row in whole])))


def _construction(order: str = "R(a) R(-c) Y R(c)", power: int = 1) -> Any:
    """The printed product; ``power`` is that of s in the first entry of Y."""

    def product(m: Context, a: Number, s: Number, c: Number) -> Array:
        stretch = array([[1 / s**power, m.zero], [m.zero, s]])
        turn, back = plane_rotation(c), plane_rotation(-c)
        if order == "R(a) R(c) Y R(c)":
            back = turn
        made: Array = plane_rotation(a) @ back @ stretch @ turn
        return made

    return product


def _polar(linear: Array) -> tuple[Number, Number, Number]:
    """a, s <= 1 and c of a 2 by 2 matrix of determinant 1, by its polar decomposition and a principal axis."""
    gram = linear.T @ linear
    # The trace of the stretch is s + 1/s, for its square has determinant 1.
    total = mp.sqrt(gram.trace() + 2)
    stretch = (gram + exactly(np.eye(2).tolist())) / total
    rotation = linear @ definitions.inverse(mp, stretch)
    s = (total - mp.sqrt(total**2 - 4)) / 2
    # R(-c) diag(1/s, s) R(c) has the deviator (1/s - s)/2 (cos 2c, -sin 2c).
    c = mp.atan2(-2 * stretch[0, 1], stretch[0, 0] - stretch[1, 1]) / 2
    return mp.atan2(rotation[1, 0], rotation[0, 0]), s, c


def _unimodular() -> list[Array]:
    simple = [[[1, 0], [0, 1]], [[0, -1], [1, 0]], [[1, 1], [0, 1]], [[-2, 1], [1, -1]], [[0.25, 3], [0, 4]]]
    return [exactly(each) for each in simple]


def _not_made(product: Any, linear: Array) -> Number:
    return difference(product(mp, *_polar(linear)), linear)


def _parameters() -> list[tuple[Number, Number, Number]]:
    angles, squeezes = numbers("angles", 8, -3, 3), numbers("squeezes", 8, 0.0625, 1)
    return list(zip(angles, squeezes, numbers("axes", 8, -3, 3), strict=True))


def _other_singular_values(product: Any, case: tuple[Number, Number, Number]) -> Number:
    """How far the eigenvalues of L^T L, by their sum and product, are from s^-2 and s^2."""
    _, s, _ = case
    linear = product(mp, *case)
    gram = linear.T @ linear
    return max(abs(gram.trace() - s**2 - s**-2), abs(definitions.determinant(gram) - 1))


def _axis_matters(product: Any, case: tuple[Number, Number, Number]) -> Number:
    """How far c changes the characteristic polynomial."""
    a, s, c = case
    turned, plain = product(mp, a, s, c), product(mp, a, s, mp.zero)
    traces = abs(turned.trace() - plain.trace())
    return max(traces, abs(definitions.determinant(turned) - definitions.determinant(plain)))


def _reciprocal(s: Number) -> Number:
    return 1 / s


def _complement(s: Number) -> Number:
    return 2 - s


def _decided_otherwise_at(other: Any, case: tuple[Number, Number]) -> int:
    a, s = case
    product = _construction()
    return int(exists(product(mp, a, s, mp.zero)) is not exists(product(mp, a, other(s), mp.zero)))


def _grid() -> list[tuple[Number, Number]]:
    return [(mp.mpf(a), mp.mpf(s)) for s in ("0.25", "0.5", "0.75", "0.9375") for a in (0, 1, 2, -2, 2.5, -2.75, 3)]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.5.2.translation",
        place="section 5.2",
        statement="The translation has no part in whether a steady morph exists.",
        verdict=Verdict.CONFIRMED,
        form=_with_translation,
        cases=_translations,
        deviation=_translation_matters,
        copies=(Copy("the translation is added to the diagonal too", _with_shifted_diagonal),),
        remark="Culver's condition on the homogeneous matrix itself, by ranks: its other eigenvalue is 1.",
    ),
    Claim(
        id="rossignac_vinacua.5.2.uniform_scaling",
        place="section 5.2",
        statement="A uniform scaling (by a positive factor) does not change whether a steady morph exists.",
        verdict=Verdict.CONFIRMED,
        form=lambda linear: linear * 3,
        cases=_integer_maps,
        deviation=_matters,
        copies=(Copy("scaling by -1, which keeps the orientation of the plane", lambda linear: -linear),),
    ),
    Claim(
        id="rossignac_vinacua.5.2.positive_eigenvalue",
        place="section 5.2",
        statement="A 3 by 3 matrix of positive determinant has a positive eigenvalue: not all real ones are negative.",
        verdict=Verdict.CONFIRMED,
        form=_positive,
        cases=_space_maps,
        deviation=_no_eigenvalue_between,
        copies=(Copy("a negative one", _negative),),
    ),
    Claim(
        id="rossignac_vinacua.5.2.restriction",
        place="section 5.2",
        statement="Whether L of space has a real logarithm is decided by its restriction to the generalised "
        "eigenvectors that remain when a positive eigenvalue is split off.",
        verdict=Verdict.CONFIRMED,
        form=_rest,
        cases=_triangular,
        deviation=_decided_otherwise,
        copies=(Copy("the restriction that keeps the positive eigenvalue", _first),),
    ),
    Claim(
        id="rossignac_vinacua.5.2.construction",
        place="section 5.2",
        statement="Every 2 by 2 matrix of determinant 1 is R(a) R(-c) Y(1/s, s) R(c).",
        printed="R(a) * R(-c) * Y(1/s, s) * R(c)",
        verdict=Verdict.CONFIRMED,
        form=_construction(),
        cases=_unimodular,
        deviation=_not_made,
        copies=(Copy("R(c) for R(-c)", _construction("R(a) R(c) Y R(c)")),),
    ),
    Claim(
        id="rossignac_vinacua.5.2.singular_values",
        place="section 5.2",
        statement="s and 1/s are the singular values of R(a) R(-c) Y(1/s, s) R(c).",
        verdict=Verdict.CONFIRMED,
        form=_construction(),
        cases=_parameters,
        deviation=_other_singular_values,
        copies=(Copy("Y(1/s², s)", _construction(power=2)),),
    ),
    Claim(
        id="rossignac_vinacua.5.2.angle_c",
        place="section 5.2",
        statement="The angle c has no part in whether a real logarithm exists: trace and determinant do not depend on "
        "it, and R(a) diag(1/s, s) is a multiple of 1 only where it is so for all c.",
        verdict=Verdict.CONFIRMED,
        form=_construction(),
        cases=_parameters,
        deviation=_axis_matters,
        copies=(Copy("R(c) for R(-c)", _construction("R(a) R(c) Y R(c)")),),
    ),
    Claim(
        id="rossignac_vinacua.5.2.range_of_s",
        place="section 5.2",
        statement="It suffices to study 0 < s <= 1: at s and at 1/s the answer is the same.",
        verdict=Verdict.CONFIRMED,
        form=_reciprocal,
        cases=_grid,
        deviation=_decided_otherwise_at,
        copies=(Copy("2 - s for 1/s", _complement),),
    ),
)
