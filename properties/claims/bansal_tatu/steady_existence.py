"""Sections 1, 2, 4 and 6.1, figure 4: where there is no steady affine morph, and what becomes of it next to there."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from affinecert.errors import InputError
from affinecert.properties.claims.bansal_tatu.interpolation import Path, lie, sam_power
from affinecert.properties.claims.bansal_tatu.samples import QUARTER_TURN
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import exactly, mp
from affinecert.reference._matrices import Array, Number, norm

Turn = tuple[Fraction, Fraction]
"""Cosine and sine of a turn about z."""

QUARTER, WIDE, NARROW, SMALL = (
    (Fraction(0), Fraction(1)),
    (Fraction(-3, 5), Fraction(4, 5)),
    (Fraction(3, 5), Fraction(4, 5)),
    (Fraction(12, 13), Fraction(5, 13)),
)


def _sheared(turn: Turn, shear: Fraction) -> Array:
    """The map that turns about z and then shears x by y."""
    cosine, sine = (mp.mpf(each.numerator) / each.denominator for each in turn)
    turned = exactly([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
    along = exactly([[1, mp.mpf(shear.numerator) / shear.denominator, 0], [0, 1, 0], [0, 0, 1]])
    return affine(along @ turned, (1, 0, 1))


def _border(turn: Turn) -> Fraction:
    """-2 cot(theta / 2)."""
    cosine, sine = turn
    return -2 * (1 + cosine) / sine


def _against() -> list[Array]:
    """Shears against the turn, beyond the border by a little or by much."""
    little = Fraction(1, 2**20)
    turns = (QUARTER, WIDE, NARROW, SMALL)
    near = [_sheared(turn, _border(turn) - little) for turn in turns]
    return [_sheared(QUARTER, Fraction(-2)), *near, *(_sheared(turn, _border(turn) * 10) for turn in turns)]


def _short_of_it() -> list[Array]:
    """Shears against the turn just short of the border, and large ones in the sense of the turn."""
    little = Fraction(1, 2**20)
    turns = (QUARTER, WIDE, NARROW, SMALL)
    near = [_sheared(turn, _border(turn) + little) for turn in turns]
    return near + [_sheared(turn, Fraction(100)) for turn in turns]


def _exists(path: Path, pose: Array) -> int:
    try:
        path(pose, mp.mpf(1) / 2)
    except InputError:
        return 0
    return 1


def _halfway(path: Path, shear: Number) -> Number:
    """The size of the linear part at t = 1/2, of a quarter turn after which x is sheared by y."""
    along = exactly([[1, shear, 0], [0, 1, 0], [0, 0, 1]])
    return norm(mp, path(affine(along @ QUARTER_TURN), mp.mpf(1) / 2)[:3, :3].flat)


def _not_much_worse(paths: tuple[Path, Path], end: Number) -> int:
    """Whether the half-way pose of the one path does not grow ten times as much, from a shear by -1 to that."""
    one, other = (_halfway(path, end) - _halfway(path, -mp.one) for path in paths)
    return int(not one > 10 * abs(other))


def _twelve() -> dict[str, str]:
    """The size of the half-way pose for twelve shears up to the border."""
    found = {}
    for k in range(12):
        shear = -2 * mp.mpf(k) / 11
        sizes = [f"{float(_halfway(sam_power, shear)):.3f}" if k < 11 else "none", f"{float(_halfway(lie, shear)):.3f}"]
        found[f"|T_1/2|, quarter turn, shear {float(shear):.3f}: SAM, proposed"] = ", ".join(sizes)
    return found


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.1.sam_fails",
        place="sections 1, 2, 4 and 6.1, figures 3 and 4",
        statement="The steady affine morph does not exist for a large shear together with a rotation.",
        verdict=Verdict.BOUND,
        domain="shears against the rotation: by k ≤ -2 cot(θ/2) of x by y after a turn by θ, 0 < θ < π",
        form=sam_power,
        cases=_against,
        outside=_short_of_it,
        deviation=_exists,
        copies=(Copy("the proposed interpolation", lie),),
        remark="However small the rotation is, a shear is too large for it; in the sense of the rotation none is.",
    ),
    Claim(
        id="bansal_tatu.figure_4.change",
        place="section 6.1, figure 4",
        statement="As the shear grows, the steady morph changes considerably before it ceases to exist, the proposed "
        "interpolation does not.",
        verdict=Verdict.CONFIRMED,
        form=(sam_power, lie),
        cases=lambda: [-2 + mp.mpf(1) / 2**k for k in (8, 16, 32)],
        deviation=_not_much_worse,
        copies=(Copy("the two exchanged", (lie, sam_power)),),
        numbers=_twelve,
        remark="Of det 1 the pose half way is (L + I) / sqrt(2 + tr L) in the plane, unbounded next to tr L = -2.",
    ),
    Claim(
        id="bansal_tatu.figure_3.similar",
        place="section 6.1, figure 3",
        statement="The proposed approach and SAM produce very similar and intuitive results in examples 1 to 4.",
        verdict=Verdict.UNCHECKABLE,
        reason="The triangles are not given, nor what is similar; the supplementary material is not at hand.",
    ),
)
