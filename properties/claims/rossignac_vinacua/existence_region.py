"""Section 5.2, equation 4 and figure 6: the region of angles and singular values in which a steady morph exists."""

from __future__ import annotations

from itertools import combinations, pairwise
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Loss, Verdict
from affinecert.properties.claims.precision import exactly, mp
from affinecert.properties.claims.rossignac_vinacua.reduction import exists
from affinecert.reference._matrices import Array, Context, Number, array

Point = tuple[int, int, Number]
"""The direction (x, y) of the angle a, and the singular value s."""

TOUCHES = mp.mpf(10) ** -60
"""Angles nearer than that are the same."""


def _linear(point: Point) -> Array:
    """A multiple of R(a) diag(1/s, s), exact for dyadic s: the multiple has no part in what is asked."""
    x, y, s = point
    return array([[x * mp.one, -y * s**2], [y * mp.one, x * s**2]])


def _angle(point: Point) -> Number:
    x, y, _ = point
    return mp.atan2(y, x)


def _equation_4(numerator: int = -2, added: int = 1) -> Any:
    def bound(m: Context, s: Number) -> Number:
        return m.acos(numerator * s / (s**2 + added))

    return bound


def _bad(strict_below: Number = -2) -> Any:
    """trace(L) < -2 sqrt(d_L), for det L = 1."""

    def condition(a: Number, s: Number) -> bool:
        trace = (s + 1 / s) * mp.cos(a)
        d = trace**2 / 4 - 1
        # On the border of figure 6 d is 0 up to rounding.
        return bool(d > -TOUCHES and trace < strict_below * mp.sqrt(max(d, mp.zero)))

    return condition


def _points() -> list[Point]:
    """On both sides of the border and on it: (-4, 3) at s = 1/2 and (-15, 8) at 3/5 are, and so is the left half."""
    half, fifth, most = mp.mpf(1) / 2, mp.mpf(1) / 4, 1 - mp.mpf(2) ** -20
    on = [(-4, 3, half), (-4, -3, half), (-8, 15, fifth)]
    near = [(-4000001, 3000000, half), (-3999999, 3000000, half), (-4000001, -3000000, half)]
    plain: list[Point] = [(1, 0, half), (0, 1, fifth), (-1, 0, half), (-1, 1, fifth), (-1, 3, fifth), (-1, 1, mp.one)]
    return [*plain, *on, *near, (-1000, 1, mp.one), (-1000000, 1, most), (-1000000, -1, most), (-1, 0, most)]


def _half_turn() -> list[Point]:
    return [(-1, 0, mp.one)]


def _bound_is_wrong(bound: Any, point: Point) -> int:
    good = bound(mp, point[2]) - abs(_angle(point)) > TOUCHES
    return int(good is not exists(_linear(point)))


def _condition_is_wrong(condition: Any, point: Point) -> int:
    return int(condition(_angle(point), point[2]) is exists(_linear(point)))


def _squeezes() -> list[Number]:
    return [mp.mpf(k) / 16 for k in (1, 2, 4, 7, 9, 12, 14, 15, 16)]


def _border(s: Number) -> Number:
    """The angle at which the trace (s + 1/s) cos a reaches -2, the definition, by bisection."""
    low, high = mp.pi / 2, mp.pi
    for _ in range(240):
        middle = (low + high) / 2
        low, high = (middle, high) if (s + 1 / s) * mp.cos(middle) > -2 else (low, middle)
    return low


def _pairs() -> list[tuple[Number, Number]]:
    return list(combinations(_squeezes(), 2))


def _not_convex(border: Any, pair: tuple[Number, Number]) -> Number:
    """How far the middle of two points of the border lies outside."""
    one, other = pair
    return max((border(one) + border(other)) / 2 - border((one + other) / 2), mp.zero)


def _pairs_with_positive_products() -> list[tuple[Array, Array]]:
    plane = [[[1, 0], [0, 2]], [[3, 0], [0, 1]], [[0.25, -4], [4, 1]], [[1, 4], [-4, 0.25]], [[5, -2], [0, 0.5]]]
    space = [[[1, 3, 0], [-3, 1, 1], [0, -1, 2]], [[1, -3, 2], [3, 4, 1], [-2, 0, 1]]]
    return [pair for some in (plane, space) for pair in pairwise(map(exactly, some))]


def _pairs_that_turn() -> list[tuple[Array, Array]]:
    left, right = [[-1, -1], [2, -1]], [[-1, 2], [-1, -1]]
    in_space = [exactly([[*row, 0] for row in each] + [[0, 0, 1]]) for each in (left, right)]
    return [(exactly(left), exactly(right)), (in_space[0], in_space[1])]


def _bad_between(share: Number, pair: tuple[Array, Array]) -> int:
    """Whether there is no real logarithm between two maps that have one."""
    one, other = pair
    if not (exists(one) and exists(other)):
        raise ValueError("the ends are to be good")
    return int(not exists((1 - share) * one + share * other))


def _trapezoid(factor: Number = mp.one) -> Any:
    def side(s: Number) -> Number:
        return (1 + factor * s) * mp.pi / 2

    return side


def _outside_of_the_region(side: Any, s: Number) -> Number:
    """How far a side of the trapezoid is beyond the border."""
    return max(side(s) - _border(s) - TOUCHES, mp.zero)


def _ends(bottom: str = "1/2", top: str = "1") -> Any:
    def end(s: Number) -> Number:
        share = bottom if s == 0 else top
        numerator, _, denominator = share.partition("/")
        return mp.pi * mp.mpf(numerator) / mp.mpf(denominator or 1)

    return end


def _wrong_end(end: Any, s: Number) -> Number:
    """Of the limit at s = 0 the border at s has the distance 2 s, to the first order."""
    if s == 0:
        near = mp.mpf(2) ** -90
        return max(abs(_border(near) - end(s)) - 4 * near, mp.zero)
    return max(abs(_border(s) - end(s)) - mp.mpf(10) ** -30, mp.zero)


def _shares() -> dict[str, Any]:
    """Of the rectangle of figure 6."""
    whole = 2 * mp.pi
    region = mp.quad(lambda s: 2 * (mp.pi / 2 + 2 * mp.atan(s)), [0, 1])
    return {
        "share of figure 6 that is good": region / whole,
        "share of figure 6 in the trapezoid": (mp.pi + 2 * mp.pi) / 2 / whole,
    }


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.5.2.bad_trace",
        place="section 5.2",
        statement="Of the 2 by 2 matrices of determinant 1, the bad ones satisfy trace(L) < -2 sqrt(d_L), real d_L.",
        printed="trace(L) < -2 √d_L",
        verdict=Verdict.BOUND,
        domain="L is not -1, the point a = π, s = 1 of figure 6: a half turn, which satisfies it and has a logarithm",
        form=_bad(),
        cases=_points,
        outside=_half_turn,
        deviation=_condition_is_wrong,
        copies=(Copy("-3 √d_L for -2 √d_L", _bad(mp.mpf(-3))),),
    ),
    Claim(
        id="rossignac_vinacua.5.2.equation_4",
        place="section 5.2, equation 4",
        statement="For L = R(a) Y(1/s, s), |a| <= π, 0 < s <= 1, a real logarithm exists if and only if "
        "|a| < arccos(-2 s / (s² + 1)).",
        printed="|a| < cos⁻¹(-2s / (s² + 1))",
        verdict=Verdict.BOUND,
        domain="all but a = π, s = 1, a half turn, which has a logarithm; on the border with s < 1 there is none",
        form=_equation_4(),
        cases=_points,
        outside=_half_turn,
        deviation=_bound_is_wrong,
        copies=(
            Copy("-s for -2 s", _equation_4(numerator=-1)),
            Copy("s² + 2 for s² + 1", _equation_4(added=2)),
        ),
        remark="The same bound is π/2 + 2 arctan s, which loses nothing. The text derives it from the inequality of "
        "the bad configurations; it is that of the good ones.",
        losses=(
            Loss(
                where="what is left to π at s next to 1",
                formula=lambda m, s: m.pi - _equation_4()(m, s),
                truth=lambda m, s: m.pi / 2 - 2 * m.atan(s),
                at=(1 - 1e-8,),
                digits=16,
            ),
            Loss(
                where="the bound itself at s next to 1",
                formula=_equation_4(),
                truth=lambda m, s: m.pi / 2 + 2 * m.atan(s),
                at=(1 - 1e-8,),
                digits=8,
            ),
        ),
    ),
    Claim(
        id="rossignac_vinacua.figure_6.ends",
        place="figure 6",
        statement="The good region reaches from -π/2 to π/2 at the bottom (s = 0) and from -π to π at the top (s = 1).",
        verdict=Verdict.CONFIRMED,
        form=_ends(),
        cases=lambda: [mp.zero, mp.one],
        deviation=_wrong_end,
        copies=(Copy("2π/3 at the bottom", _ends(bottom="2/3")), Copy("3π/4 at the top", _ends(top="3/4"))),
        numbers=_shares,
    ),
    Claim(
        id="rossignac_vinacua.figure_6.convex",
        place="section 5.2 and figure 6",
        statement="The good region of figure 6 is convex, in the coordinates a and s.",
        verdict=Verdict.CONFIRMED,
        form=_border,
        cases=_pairs,
        deviation=_not_convex,
        copies=(Copy("|a| < π/2 + arcsin s", lambda s: mp.pi / 2 + mp.asin(s)),),
        remark="The border π/2 + 2 arctan s is concave in s. In the coordinates of the matrices the good set is not "
        "convex: see rossignac_vinacua.5.2.convex_set.",
    ),
    Claim(
        id="rossignac_vinacua.5.2.convex_set",
        place="section 5.2, and abstract",
        statement="The good affinities are a convex set: what is halfway between two of them is good.",
        verdict=Verdict.BOUND,
        domain="maps with x·Lx > 0 for all x, which turn every vector by less than 90 degrees: a convex set, all of it "
        "good. The set of all good maps is convex in the coordinates of figure 6 only",
        form=mp.mpf(1) / 2,
        cases=_pairs_with_positive_products,
        outside=_pairs_that_turn,
        deviation=_bad_between,
        copies=(Copy("as far again beyond the second map", mp.mpf(2)),),
        remark="The abstract has A^t exist for a convex and large subset of the affinities, section 5.2 says it of "
        "figure 6. Maps that turn to the left and to the right are good, and between them there are bad ones: a blend "
        "of good maps has to be checked.",
    ),
    Claim(
        id="rossignac_vinacua.figure_6.trapezoid",
        place="section 5.2 and figure 6",
        statement="The good region contains the trapezoid |a| < (1 + s) π/2.",
        printed="|a| < (1+s)π/2",
        verdict=Verdict.CONFIRMED,
        form=_trapezoid(),
        cases=lambda: _squeezes()[:-1],
        deviation=_outside_of_the_region,
        copies=(Copy("1 + 17/16 s for 1 + s", _trapezoid(mp.mpf(17) / 16)),),
        remark="Its corners (±π/2, 0) and (±π, 1) are on the border.",
    ),
)
