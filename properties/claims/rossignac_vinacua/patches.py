"""Section 7.3: patterns in two directions, SAM patches."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.definitions import inverse
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import FAILS, distance, mp
from affinecert.properties.claims.rossignac_vinacua.poses import controls, morph
from affinecert.reference._matrices import Array, Number, identity

_Corners = tuple[Array, Array, Array, Array]
_Patch = Callable[..., Array]


def _patch(a: Array, b: Array, c: Array, d: Array, s: Number, t: Number) -> Array:
    """A SAM of corresponding poses of the top row, A to B, and of the bottom row, C to D."""
    return morph(mp, morph(mp, a, b, s), morph(mp, c, d, s), t)


def _turned(a: Array, b: Array, c: Array, d: Array, s: Number, t: Number) -> Array:
    """The rows are SAMs of the first and last column."""
    return morph(mp, morph(mp, a, c, t), morph(mp, b, d, t), s)


def _bilinear(a: Array, b: Array, c: Array, d: Array, s: Number, t: Number) -> Array:
    mixed: Array = (1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * c + s * d)
    return mixed


def _carried(a: Array, b: Array, c: Array) -> Array:
    """SAM(F_C, F_A, 1, F_B): the image of F_C under the map from F_A to F_B."""
    image: Array = b @ inverse(mp, a) @ c
    return image


def _after(a: Array, b: Array, c: Array) -> Array:
    """The product of F_C and the pose SAM(F_A, 1, F_B)."""
    image: Array = b @ c
    return image


def _other_way(a: Array, b: Array, c: Array) -> Array:
    image: Array = a @ inverse(mp, c) @ b
    return image


def _unequal_steps(poses: list[Array]) -> Number:
    steps = [after @ inverse(mp, before) for before, after in itertools.pairwise(poses)]
    return max(distance(step, steps[0]) for step in steps[1:])


def _row(patch: _Patch, corners: tuple[Array, ...], t: Number) -> list[Array]:
    return [patch(*corners, mp.mpf(k) / 4, t) for k in range(4)]


def _column(patch: _Patch, corners: tuple[Array, ...], s: Number) -> list[Array]:
    return [patch(*corners, s, mp.mpf(k) / 4) for k in range(4)]


_INNER = (mp.mpf(1) / 4, mp.mpf(5) / 8)


def _columns(patch: _Patch, corners: _Corners) -> Number:
    return max(_unequal_steps(_column(patch, corners, s)) for s in (mp.zero, *_INNER, mp.one))


def _outer_rows(patch: _Patch, corners: _Corners) -> Number:
    return max(_unequal_steps(_row(patch, corners, t)) for t in (mp.zero, mp.one))


def _inner_rows(patch: _Patch, corners: _Corners) -> int:
    """Whether an inner row is steady."""
    return int(any(_unequal_steps(_row(patch, corners, t)) < FAILS for t in _INNER))


def _regular(fourth: Callable[[Array, Array, Array], Array], corners: _Corners) -> Number:
    """How far rows and columns are from steady with the fourth corner computed."""
    completed = (*corners[:3], fourth(*corners[:3]))
    rows = max(_unequal_steps(_row(_patch, completed, t)) for t in (*_INNER, mp.one))
    return max(rows, _columns(_patch, completed))


def _generic() -> list[_Corners]:
    corners = []
    for size in (2, 3):
        poses = controls(f"corners of {size}", 8, size)
        corners += [(poses[0], poses[1], poses[2], poses[3]), (poses[4], poses[5], poses[6], poses[7])]
    return corners


def _simple_too() -> list[_Corners]:
    unit = identity(mp, 3)
    turned, moved = affine([[0, -1], [1, 0]], [1, 0]), affine([[1, 0], [0, 1]], [0, 2])
    return [(unit, turned, moved, affine([[2, 0], [0, 1]], [0, 0])), *_generic()]


def _straight(start: Array, end: Array, t: Number) -> Array:
    found: Array = (1 - t) * start + t * end
    return found


def _block(last: Callable[[Array, Array, Number], Array]) -> Any:
    """A pose of a block, by SAMs of its corners in the first two directions, and ``last`` in the third."""

    def pose(corners: dict[tuple[int, int, int], Array], r: Number, s: Number, t: Number) -> Array:
        line = [[morph(mp, corners[0, j, k], corners[1, j, k], r) for k in (0, 1)] for j in (0, 1)]
        face = [morph(mp, line[0][k], line[1][k], s) for k in (0, 1)]
        return last(face[0], face[1], t)

    return pose


def _irregular_block(pose: Any, poses: list[Array]) -> Number:
    """How far the lines of a block in its three directions are from steady, its corners being M^i N^j P^k F."""
    first, second, third, start = poses
    powers = [[identity(mp, len(start)), each] for each in (first, second, third)]
    corners = {
        (i, j, k): powers[0][i] @ powers[1][j] @ powers[2][k] @ start for i, j, k in itertools.product((0, 1), repeat=3)
    }
    at = mp.mpf(3) / 8
    lines = (
        [pose(corners, x, at, at) for x in map(mp.mpf, (0, 0.25, 0.5, 0.75))],
        [pose(corners, at, x, at) for x in map(mp.mpf, (0, 0.25, 0.5, 0.75))],
        [pose(corners, at, at, x) for x in map(mp.mpf, (0, 0.25, 0.5, 0.75))],
    )
    return max(map(_unequal_steps, lines))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.7.3.patch_columns",
        place="section 7.3",
        statement="All columns of a SAM patch are SAMs.",
        verdict=Verdict.CONFIRMED,
        form=_patch,
        cases=_simple_too,
        deviation=_columns,
        copies=(Copy("SAMs along the rows instead", _turned), Copy("straight lines", _bilinear)),
    ),
    Claim(
        id="rossignac_vinacua.7.3.patch_outer_rows",
        place="section 7.3",
        statement="The first and the last row of a SAM patch are SAMs.",
        verdict=Verdict.CONFIRMED,
        form=_patch,
        cases=_simple_too,
        deviation=_outer_rows,
        copies=(Copy("straight lines", _bilinear),),
    ),
    Claim(
        id="rossignac_vinacua.7.3.patch_inner_rows",
        place="section 7.3",
        statement="The other rows of a SAM patch are usually not steady.",
        verdict=Verdict.CONFIRMED,
        form=_patch,
        cases=_generic,
        deviation=_inner_rows,
        copies=(Copy("SAMs along the rows", _turned),),
    ),
    Claim(
        id="rossignac_vinacua.7.3.patch_regular",
        place="section 7.3, figure 11",
        statement="With the fourth corner F_D = SAM(F_C, F_A, 1, F_B) rows and columns of a SAM patch are all regular.",
        printed="F_D = SAM(F_C, F_A, 1, F_B)",
        verdict=Verdict.CONFIRMED,
        form=_carried,
        cases=_simple_too,
        deviation=_regular,
        copies=(
            Copy("the pose SAM(F_A, 1, F_B) after F_C: F_B F_C", _after),
            Copy("F_A F_C⁻¹ F_B for F_B F_A⁻¹ F_C", _other_way),
        ),
        remark="SAM of four arguments carries F_X: F_D = F_B F_A⁻¹ F_C. F_C F_A⁻¹ F_B makes all regular, too.",
    ),
    Claim(
        id="rossignac_vinacua.7.3.patch_of_three",
        place="section 7.3",
        statement="SAMs make patterns in more than two directions too.",
        verdict=Verdict.CONFIRMED,
        form=_block(lambda start, end, t: morph(mp, start, end, t)),
        cases=lambda: [controls(f"block of {size}", 4, size) for size in (2, 3)],
        deviation=_irregular_block,
        copies=(Copy("straight lines in the third direction", _block(_straight)),),
        remark="All three directions are regular if the corners are Mⁱ Nʲ Pᵏ F.",
    ),
    Claim(
        id="rossignac_vinacua.7.3.averages_of_motions",
        place="section 7.3",
        statement="SAMs serve to average more than two poses with weights, and to average two steady motions.",
        verdict=Verdict.UNCHECKABLE,
        reason="no construction is given for weights in general, nor for motions",
    ),
)
