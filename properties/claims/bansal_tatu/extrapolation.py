"""Sections 6.2 and 6.3, figures 5 and 6: beyond the ends, and between four affine maps."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations, pairwise
from typing import Any

from affinecert.properties.claims.bansal_tatu.interpolation import Path, lie, morph, sam_power
from affinecert.properties.claims.bansal_tatu.samples import QUARTER_TURN, REGULAR, at, maps, moved
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine, rotations
from affinecert.properties.claims.precision import distance, exactly, mp, size
from affinecert.reference import morphs
from affinecert.reference._matrices import Array, Number, norm

Patch = Callable[[tuple[Array, ...], Number, Number], Array]
"""The map at s and t between four."""

BEYOND = tuple(mp.mpf(k) / 4 for k in (-3, 1, 2, 5, 7))
"""Times of figure 5, from -0.75 to 1.75."""

SHEAR = exactly([[1, 1, 0], [0, 1, 0], [0, 0, 1]])
"""That of x by y."""


def _unlike_sam(path: Path, pose: Array) -> Number:
    return max(distance(path(pose, t), sam_power(pose, t)) for t in BEYOND)


def _along() -> list[Array]:
    """Shears with translations that they leave as they are."""
    slanted = exactly([[1, 1, -2], [0, 1, 0], [0, 0, 1]])
    stretched = exactly([[1, 2, 1], [0, 3, 1], [0, 0, 2]])
    return [
        affine(SHEAR, (1, 0, 0)),
        affine(SHEAR, (1, 0, 3)),
        affine(slanted, (3, 2, 1)),
        affine(stretched, (1, 0, 0)),
    ]


def _across() -> list[Array]:
    """Shears with translations that they change, by little or by much."""
    little = mp.mpf(1) / 1024
    return [
        affine(SHEAR, (0, 1, 0)),
        affine(SHEAR, (1, little, 0)),
        affine([[1, 0, 0], [0, 2, 0], [0, 0, 1]], (0, 1, 0)),
    ]


def _scaled_turns() -> list[Array]:
    """Rotation, scale and translation."""
    growths = (2, mp.mpf(1) / 2, 3)
    turned = [turn * growth for turn, growth in zip(rotations("scaled turns", 3, 3), growths, strict=True)]
    return [affine(2 * QUARTER_TURN, (1, 0, 0)), *(affine(each, (0, 1, -1)) for each in turned)]


def _not_only_the_translation(path: Path, pose: Array) -> Number:
    """How far the linear parts are from those of SAM; 1 if the translations are the same, too."""
    moves = [(path(pose, t), sam_power(pose, t)) for t in BEYOND]
    linear = max(distance(one[:3, :3], other[:3, :3]) for one, other in moves)
    shift = max(size(one[:3, 3] - other[:3, 3]) for one, other in moves)
    return max(linear, int(shift < mp.mpf(1) / 1000))


def _lengths(tetrahedron: Array) -> list[Number]:
    """The lengths of the edges."""
    return [norm(mp, tetrahedron[i] - tetrahedron[j]) for i, j in combinations(range(4), 2)]


def _other_lengths(path: Path, pose: Array) -> Number:
    """How far the lengths of the edges differ from those by SAM."""
    return max(
        distance(_lengths(moved(path(pose, t), REGULAR)), _lengths(moved(sam_power(pose, t), REGULAR))) for t in BEYOND
    )


def _sheared_turn(turn: Number, shear: Number) -> Array:
    """A rotation about z, a shear of x by y and a translation."""
    cosine, sine = mp.cos(turn), mp.sin(turn)
    turned = exactly([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
    return affine(exactly([[1, shear, 0], [0, 1, 0], [0, 0, 1]]) @ turned, (1, 1, 0))


def _irregular(path: Path, pose: Array, t: Number) -> Number:
    """By how much the longest edge of the moved regular tetrahedron is longer than the shortest, relatively."""
    lengths = _lengths(moved(path(pose, t), REGULAR))
    return max(lengths) / min(lengths) - 1


def _never_regular(path: Path, pose: Array) -> Number:
    """The least irregularity at times beyond 1: at quarters up to 4, and at the half turn of the eigenvalues."""
    times = [1 + mp.mpf(k) / 4 for k in range(1, 13)]
    cosine = (pose[0, 0] + pose[1, 1]) / 2
    if abs(cosine) < 1:
        times.append(mp.pi / mp.acos(cosine))
    return min(_irregular(path, pose, t) for t in times)


def _turning() -> list[Array]:
    wide = 2 * mp.pi / 3
    return [
        _sheared_turn(*each) for each in ((mp.pi / 2, mp.one / 2), (mp.pi / 2, -mp.one), (wide, mp.one), (wide, -1))
    ]


def _overtaken() -> list[Array]:
    """Shears so large that no eigenvalue turns any more."""
    return [
        _sheared_turn(mp.pi / 2, 2 + mp.mpf(1) / 8),
        _sheared_turn(mp.pi / 2, mp.mpf(4)),
        _sheared_turn(mp.zero, mp.one),
    ]


def _distortion(path: Path, pose: Array, t: Number) -> Number:
    """How far the linear part of determinant 1 is from a rotation: the sum of its squared singular values, less 3."""
    return norm(mp, path(pose, t)[:3, :3].flat) ** 2 - 3


def _not_more_irregular(path: Path, pose: Array) -> int:
    """Whether the distortion stops growing somewhere between t = 1 and t = 4."""
    found = [_distortion(path, pose, 1 + mp.mpf(k) / 4) for k in range(13)]
    return int(not all(before < after for before, after in pairwise(found)))


def _ratios() -> dict[str, str]:
    """The longest edge over the shortest, for a quarter turn and a shear by 1/2."""
    pose = _turning()[0]
    times = (mp.one, mp.mpf(3) / 2, mp.mpf(2), mp.mpf(5) / 2)
    return {
        f"longest edge over shortest at t = {float(t)}: SAM, proposed": ", ".join(
            f"{float(1 + _irregular(path, pose, t)):.3f}" for path in (sam_power, lie)
        )
        for t in times
    }


def _rows_first(name: str) -> Patch:
    """Between four maps, first from A to B and from C to D for s, then between these for t."""

    def patch(corners: tuple[Array, ...], s: Number, t: Number) -> Array:
        a, b, c, d = corners
        return _between(name, _between(name, a, b, s), _between(name, c, d, s), t)

    return patch


def _between(name: str, start: Array, end: Array, t: Number) -> Array:
    return morphs.MORPHS[name](mp, start, end, at(t))


def _gap(patch: Patch, corners: tuple[Array, ...], s: Number, t: Number) -> Number:
    """How far it is from that with rows and columns exchanged."""
    a, b, c, d = corners
    return distance(patch(corners, s, t), patch((a, c, b, d), t, s))


PLACES = tuple((s, t) for s in (mp.mpf(1) / 5, mp.mpf(6) / 5) for t in (mp.mpf(2) / 5, -mp.mpf(1) / 5))
"""Some of the times of figure 6."""


def _not_slightly(patch: Patch, corners: tuple[Array, ...]) -> int:
    """Whether the two orders make no difference, or one of a tenth of the map."""
    worst = max(_gap(patch, corners, s, t) for s, t in PLACES)
    return int(not mp.mpf(10) ** -6 < worst < mp.mpf(1) / 10)


def _corners() -> list[tuple[Array, ...]]:
    """Four maps that turn, shear and stretch by not too much."""
    one, tall = affine([[1, 0, 0], [0, 1, 0], [0, 0, 1]]), exactly([[1, 0, 0], [0, 1, 0], [0, 1, 2]])
    return [
        (one, affine(SHEAR, (4, 0, 0)), affine(QUARTER_TURN, (0, 4, 0)), affine(tall, (4, 4, 0))),
        (one, affine(2 * QUARTER_TURN, (4, 0, 0)), affine(SHEAR, (0, 4, 0)), maps()[4]),
    ]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.6.2.shear_and_translation",
        place="section 6.2, figure 5, centre",
        statement="If the map is a shear and a translation, SAM and the proposed approach give the same result.",
        verdict=Verdict.BOUND,
        domain="translations d that the shear leaves as they are, A d = d",
        form=lie,
        cases=_along,
        outside=_across,
        deviation=_unlike_sam,
        copies=(Copy("polar factors and logarithms", morph("polar_exponential")),),
        remark="E being the shift by d, and A = I + N, N² = 0: by SAM the origin goes to t d + t (t + 1) N d / 2, by "
        "the other to t d + t² N d.",
    ),
    Claim(
        id="bansal_tatu.6.2.translation_differs",
        place="section 6.2, figure 5, left",
        statement="If it is a rotation, a scale and a translation, the two differ in the translation alone.",
        verdict=Verdict.CONFIRMED,
        form=lie,
        cases=_scaled_turns,
        deviation=_not_only_the_translation,
        copies=(
            Copy("the steady morph itself", sam_power),
            Copy("(1 - t) I + t S for S^t", morph("shoemake_duff")),
        ),
    ),
    Claim(
        id="bansal_tatu.6.2.edge_lengths",
        place="section 6.2, figure 5, bottom row",
        statement="In these two cases the edges have the same lengths by both approaches.",
        verdict=Verdict.CONFIRMED,
        form=lie,
        cases=lambda: [*_along(), *_across(), *_scaled_turns()],
        deviation=_other_lengths,
        copies=(Copy("(1 - t) I + t S for S^t", morph("shoemake_duff")),),
    ),
    Claim(
        id="bansal_tatu.6.2.sam_regular_again",
        place="section 6.2, figure 5, right",
        statement="If a regular tetrahedron is rotated, translated and sheared, SAM reproduces a regular one at some "
        "t > 1.",
        verdict=Verdict.BOUND,
        domain="rotations by θ about z and shears k of x by y with |2 cos θ + k sin θ| < 2; t = π / arccos(cos θ + k "
        "sin θ / 2)",
        form=sam_power,
        cases=_turning,
        outside=_overtaken,
        deviation=_never_regular,
        copies=(Copy("the proposed interpolation", lie),),
        remark="The eigenvalues turn on the unit circle, so that the motion is periodic but for its translation.",
    ),
    Claim(
        id="bansal_tatu.6.2.more_irregular",
        place="section 6.2, figure 5, right",
        statement="Extrapolated, the proposed interpolation makes the tetrahedra more and more irregular.",
        verdict=Verdict.CONFIRMED,
        form=lie,
        cases=_turning,
        deviation=_not_more_irregular,
        copies=(Copy("the steady affine morph", sam_power),),
        numbers=_ratios,
        remark="By the singular values of T_t. The lengths of the edges, which figure 5 plots, go up and down, as the "
        "tetrahedron turns before it is sheared.",
    ),
    Claim(
        id="bansal_tatu.6.3.rows_and_columns",
        place="section 6.3, figure 6",
        statement="Interpolated by rows and then by columns, or by columns and then by rows, four maps give grids that "
        "differ slightly.",
        verdict=Verdict.CONFIRMED,
        form=_rows_first("lie"),
        cases=_corners,
        deviation=_not_slightly,
        copies=(Copy("entries in straight lines, for which the orders agree", _rows_first("linear")),),
        numbers=lambda: {
            f"largest relative difference, example {k}": max(_gap(_rows_first("lie"), each, s, t) for s, t in PLACES)
            for k, each in enumerate(_corners(), 1)
        },
        remark="Slightly: between 1e-6 and a tenth of the map. Their cuboids are not given.",
    ),
)
