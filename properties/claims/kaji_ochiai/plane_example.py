"""Section 1: sums of maps, and the rotations of the plane as an example of a parametrisation."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import numbers, plane_rotation
from affinecert.properties.claims.precision import difference, equals, exactly, mp
from affinecert.reference._matrices import Array, Context, Number, array, identity

PLACE = "section 1, the rotations of the plane"


def _is_rotation(matrix: Array) -> bool:
    return not difference(matrix.T @ matrix, identity(mp, 3)) and definitions.determinant(matrix) == 1


def _is_regular(matrix: Array) -> bool:
    return bool(definitions.determinant(matrix) != 0)


def _sum_stays(addends: tuple[Array, Array], kind: Callable[[Array], bool]) -> bool:
    """Whether a sum of two maps of a kind is of that kind; and whether the addends are none, who are no example."""
    return kind(addends[0] + addends[1]) or not all(map(kind, addends))


def _quarter(power: int) -> Array:
    turn: Array = exactly([[0, -1, 0], [1, 0, 0], [0, 0, 1]] if power == 1 else [[-1, 0, 0], [0, -1, 0], [0, 0, 1]])
    return turn


def _rotation(sign: int) -> Any:
    def printed(m: Context, theta: Number) -> Array:
        return array([[m.cos(theta), -sign * m.sin(theta)], [sign * m.sin(theta), m.cos(theta)]])

    return printed


def _exponential(m: Context, theta: Number) -> Array:
    return definitions.exponential(m, array([[m.zero, -theta], [theta, m.zero]]))


def _reflection(m: Context, theta: Number) -> Array:
    return array([[m.cos(theta), m.sin(theta)], [m.sin(theta), -m.cos(theta)]])


def _not_multiplicative(phi: Any, case: tuple[Number, Number]) -> Number:
    a, b = case
    return difference(phi(mp, a) @ phi(mp, b), phi(mp, a + b))


def _angles() -> list[tuple[Number]]:
    return [(mp.mpf(angle),) for angle in (0, 1, -2, 4)] + [(mp.pi,)]


def _pairs() -> list[tuple[Number, Number]]:
    drawn = numbers("pairs of angles", 8, -7, 7)
    return [(mp.zero, mp.zero), (mp.one, mp.one), *zip(drawn[::2], drawn[1::2], strict=True)]


def _any_k(m: Context, a: Number, b: Number, k: int) -> Number:
    return m.atan(b / a) + k * m.pi if a else m.pi / 2 + k * m.pi


def _right_k(half_turn: int) -> Any:
    """The angle with whole turns 2 k pi only, and a half turn more where a is negative."""

    def angle(m: Context, a: Number, b: Number, k: int) -> Number:
        if not a:
            return b * m.pi / 2 + 2 * k * m.pi
        return m.atan(b / a) + (half_turn * m.pi if a < 0 else 0) + 2 * k * m.pi

    return angle


def _not_the_rotation(psi: Any, case: tuple[Number, Number, int]) -> Number:
    a, b, _ = case
    return difference(plane_rotation(psi(mp, *case)), array([[a, -b], [b, a]]))


def _unit_pairs() -> list[tuple[Number, Number, int]]:
    corners = [(1, 0), (0, 1), (0, -1), (-1, 0)]
    fifths = [(mp.mpf(3) / 5, mp.mpf(-4) / 5), (mp.mpf(-3) / 5, mp.mpf(4) / 5)]
    return [(mp.mpf(a), mp.mpf(b), k) for a, b in (*corners, *fifths) for k in (0, 1, -2)]


def _nearest(m: Context, rotation: Array, near: Number) -> Number:
    """The angle of a rotation that is nearest to a given one."""
    angle = m.atan2(rotation[1, 0], rotation[0, 0])
    return angle + 2 * m.pi * m.nint((near - angle) / (2 * m.pi))


def _once_round(m: Context, s: Number) -> Array:
    return plane_rotation(2 * m.pi * s)


def _there_and_back(m: Context, s: Number) -> Array:
    return plane_rotation(3 * m.sin(2 * m.pi * s))


def _returns(loop: Any, steps: int) -> Number:
    """How far the angle, continued along a loop, is from having grown by 2 pi: it then has no continuous inverse."""
    angle = start = _nearest(mp, loop(mp, mp.zero), mp.zero)
    for k in range(1, steps + 1):
        angle = _nearest(mp, loop(mp, mp.mpf(k) / steps), angle)
    return abs(angle - start - 2 * mp.pi)


def _principal(m: Context, rotation: Array, _: Number) -> Number:
    return m.atan2(rotation[1, 0], rotation[0, 0])


def _not_smooth(psi: Any, angle: Number) -> Number:
    """How far the angle of the rotation is from growing at rate 1 at a rotation, if it is asked for near there."""
    return abs(definitions.derivative(mp, lambda t: psi(mp, plane_rotation(t), angle), angle) - 1)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="kaji_ochiai.1.sums",
        place="section 1, first difficulty",
        statement="The sum of two regular maps need not be regular, nor that of two rotations a rotation.",
        verdict=Verdict.CONFIRMED,
        form=(exactly([[1, 0, 0], [0, 1, 0], [0, 0, 1]]), _quarter(2)),
        cases=lambda: [_is_regular, _is_rotation],
        deviation=lambda addends, kind: int(_sum_stays(addends, kind)),
        copies=(Copy("a quarter turn for the half turn", (identity(mp, 3), _quarter(1))),),
        remark="In space the sum of two rotations never is one: it doubles the axis of the relative rotation.",
    ),
    Claim(
        id="kaji_ochiai.1.plane.exponential",
        place=PLACE,
        statement="The exponential of θJ, J the quarter turn, is the rotation of the plane by θ.",
        printed="φ(θ) = exp(θJ) = (cos θ, -sin θ; sin θ, cos θ)",
        verdict=Verdict.CONFIRMED,
        form=_rotation(1),
        cases=_angles,
        deviation=equals(_exponential),
        copies=(Copy("signs of the sines exchanged", _rotation(-1)),),
    ),
    Claim(
        id="kaji_ochiai.1.plane.homomorphism",
        place=PLACE,
        statement="It takes sums of angles to products of rotations.",
        printed="φ is a group homomorphism",
        verdict=Verdict.CONFIRMED,
        form=_rotation(1),
        cases=_pairs,
        deviation=_not_multiplicative,
        copies=(Copy("reflections (cos θ, sin θ; sin θ, -cos θ) for rotations", _reflection),),
    ),
    Claim(
        id="kaji_ochiai.1.plane.inverse",
        place=PLACE + ", ψ",
        statement="Every value of ψ, for each integer k, is an angle of the rotation (a, -b; b, a).",
        printed="ψ = arctan(b/a) + kπ (a ≠ 0), π/2 + kπ (a = 0, b = ±1)",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_any_k,
        cases=_unit_pairs,
        deviation=_not_the_rotation,
        correction=Correction(
            statement="ψ = arctan(b/a) + 2kπ (a > 0), arctan(b/a) + (2k + 1)π (a < 0), bπ/2 + 2kπ (a = 0)",
            form=_right_k(1),
        ),
        copies=(Copy("no half turn for a < 0", _right_k(0)),),
        remark="Half of the values of k give the opposite rotation. Read charitably, k is to be chosen: "
        "atan2(b, a) + 2kπ does it.",
    ),
    Claim(
        id="kaji_ochiai.1.plane.no_global_inverse",
        place=PLACE,
        statement="ψ is not continuous on all rotations: continued once round, it has grown by 2π.",
        verdict=Verdict.CONFIRMED,
        form=_once_round,
        cases=lambda: [8, 25],
        deviation=_returns,
        copies=(Copy("a loop by 3 radians to both sides, not round", _there_and_back),),
    ),
    Claim(
        id="kaji_ochiai.1.plane.local_inverse",
        place=PLACE,
        statement="Round every rotation ψ is differentiable, if k is chosen by an angle nearby.",
        verdict=Verdict.CONFIRMED,
        form=_nearest,
        cases=lambda: [mp.zero, mp.one, -mp.pi / 2, mp.pi, 3 * mp.pi],
        deviation=_not_smooth,
        copies=(Copy("the principal value whatever is nearby", _principal),),
    ),
)
