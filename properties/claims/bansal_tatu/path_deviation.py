"""Section 6.5 and figure 9: how far the orderings of the vertices lead apart, the more the target is sheared.

The tetrahedron is regular, in the unit sphere, its first face parallel to the xy plane and its first edge to the x
axis. In case 1 its third vertex goes along the circle of the first face, the fourth along the great circle in the plane
y = 0, each by an angle; in case 2 the third goes along x, the fourth along y, as the caption says.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import pairwise
from typing import Any

from affinecert.properties.claims.bansal_tatu.samples import CANONICAL, inverse
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.precision import mp, size
from affinecert.reference import affine_lie, measures, so3
from affinecert.reference._matrices import Array, Number, array, identity, norm

Move = Callable[[Number, Number], Array]
"""The target, of the moves of its third and its fourth vertex."""
Spot = tuple[str, int, int]
"""A case, and the moves in fifths."""

_HALF, _LOW = mp.sqrt(mp.mpf(2) / 3), mp.sqrt(2) / 3
SOURCE: Array = array(
    [
        [-_HALF, -_LOW, -mp.one / 3],
        [_HALF, -_LOW, -mp.one / 3],
        [mp.zero, 2 * _LOW, -mp.one / 3],
        [mp.zero, mp.zero, mp.one],
    ]
)
"""The regular tetrahedron."""


def _turned(vertex: Array, axis: int, angle: Number) -> Array:
    turned: Array = so3.exp(mp, identity(mp, 3)[axis] * angle) @ vertex
    return turned


def _along_circles(third: Number, fourth: Number) -> Array:
    target = SOURCE.copy()
    target[2], target[3] = _turned(SOURCE[2], 2, third), _turned(SOURCE[3], 1, fourth)
    return target


def _along_lines(third: Number, fourth: Number) -> Array:
    target = SOURCE.copy()
    target[2, 0] += third
    target[3, 1] += fourth
    return target


def _out_of_the_face(third: Number, fourth: Number) -> Array:
    target = SOURCE.copy()
    target[2], target[3] = _turned(SOURCE[2], 0, third), _turned(SOURCE[3], 1, fourth)
    return target


MOVES: dict[str, Move] = {"circles": _along_circles, "lines": _along_lines}


def _target(spot: Spot) -> Array:
    name, third, fourth = spot
    return MOVES[name](mp.mpf(third) / 5, mp.mpf(fourth) / 5)


QUARTERS = (1, 2, 3)
"""The times, in quarters, at which the paths are compared."""


@cache
def _deviation(spot: Spot, quarters: tuple[int, ...] = QUARTERS) -> tuple[Number, Number]:
    """The maximum and the median of u over the pairs of orderings."""
    most, median = measures.path_deviation(mp, SOURCE, _target(spot), array([mp.mpf(k) / 4 for k in quarters]))
    return most, median


def _shear(spot: Spot) -> Number:
    """|A_p^-1 A_q - I|."""
    p, q = (affine_lie.represent(mp, each, CANONICAL)[1] for each in (SOURCE, _target(spot)))
    return norm(mp, (inverse(p) @ q - identity(mp, 3)).flat)


def _turn(spot: Spot) -> Number:
    """|E_p^-1 E_q - I|."""
    p, q = (affine_lie.represent(mp, each, CANONICAL)[0] for each in (SOURCE, _target(spot)))
    return norm(mp, (inverse(p) @ q - identity(mp, 4)).flat)


RAYS = tuple((name, *way) for name in MOVES for way in ((1, 0), (0, 1), (1, 1), (1, -1)))
"""Ways outward from the centre of the plot."""


def _along(ray: Spot) -> list[Spot]:
    name, third, fourth = ray
    return [(name, third * k, fourth * k) for k in (1, 2, 4)]


def _not_growing(quarters: tuple[int, ...], ray: Spot) -> int:
    """Whether maximum or median fails to grow along a ray."""
    found = [_deviation(spot, quarters) for spot in _along(ray)]
    return int(not all(before[i] < after[i] for before, after in pairwise(found) for i in (0, 1)))


def _misordered(amount: Callable[[Spot], Number], spots: tuple[Spot, Spot]) -> int:
    """Whether of two targets that of the higher amount does not have the higher maximum of u."""
    one, other = spots
    return int((amount(one) < amount(other)) != (_deviation(one)[0] < _deviation(other)[0]))


def _on_rays() -> list[tuple[Spot, Spot]]:
    return [pair for ray in RAYS for pair in pairwise(_along(ray))]


def _beside_rays() -> list[tuple[Spot, Spot]]:
    return [*_on_rays()[:3], (("lines", 1, -1), ("lines", 1, 1)), (("circles", 3, -3), ("circles", 2, 2))]


def _not_shear_alone(move: Move, moves: tuple[Number, Number]) -> Number:
    """How far E and s of source and target differ."""
    p, q = (affine_lie.represent(mp, each, CANONICAL) for each in (SOURCE, move(*moves)))
    return max(size(p[0] - q[0]), abs(p[2][()] - q[2][()]))


def _table() -> dict[str, str]:
    """Maximum and median of u where both vertices move by as much."""
    found = {}
    for name in MOVES:
        for k in (1, 2, 4):
            most, median = (float(each) for each in _deviation((name, k, k)))
            found[f"{name}, both moves {k / 5}"] = f"{most:.4f}, {median:.4f}"
    return found


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.figure_9.shear_alone",
        place="figure 9, caption",
        statement="The deformations change the shear component directly: E and s of source and target are the same.",
        verdict=Verdict.CONFIRMED,
        form=_along_circles,
        cases=lambda: [(mp.mpf(k) / 4, -mp.mpf(m) / 2) for k, m in ((1, 0), (0, 1), (2, -1), (-3, 1))],
        deviation=_not_shear_alone,
        copies=(Copy("the third vertex along the circle about the x axis", _out_of_the_face),),
        remark="In the given order of the vertices; in the others E and s change, too.",
    ),
    Claim(
        id="bansal_tatu.figure_9.lines",
        place="section 6.5 and figure 9, case 2",
        statement="The third and fourth vertex move along the lines x = constant and y = constant (text), along the x "
        "and the y axis (caption).",
        verdict=Verdict.UNCHECKABLE,
        reason="Text and caption contradict each other, and how the tetrahedron lies is not told.",
    ),
    Claim(
        id="bansal_tatu.figure_9.growth",
        place="sections 5.2.2 and 6.5, figure 9",
        statement="As the shear grows, away from the centre of the plots, maximum and median of u over the orderings "
        "grow.",
        printed="u = max_t ‖T_t^O₁ - T_t^O₂‖_F",
        verdict=Verdict.CONFIRMED,
        form=QUARTERS,
        cases=lambda: RAYS,
        deviation=_not_growing,
        copies=(Copy("compared at the end, t = 1, alone", (4,)),),
        numbers=_table,
        remark="Nearly with the square of the moves. The values of the figure are not legible.",
    ),
    Claim(
        id="bansal_tatu.6.5.higher_shear",
        place="section 6.5, end",
        statement="The higher the shear component of the map, the higher the difference between the paths.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_shear,
        cases=_beside_rays,
        deviation=_misordered,
        correction=Correction(
            statement="so it is along each ray of the figure, not between deformations of different kinds",
            form=_shear,
            cases=_on_rays,
            deviation=_misordered,
        ),
        copies=(Copy("|E_p⁻¹E_q - I| for |A_p⁻¹A_q - I|", _turn),),
    ),
)
