"""Section 3.3.2, (1), and figures 4 and 5: linear combinations of logarithms, as of Alexa (2002), and their example."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine, plane_rotation
from affinecert.properties.claims.precision import HOLDS, distance, exactly, mp, rounded, size
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import (
    QUARTER,
    Morph,
    Pair,
    at,
    general_pairs,
    steady,
    unit,
    unlike_steady,
)
from affinecert.properties.matrix.algebra import inverse
from affinecert.reference import morphs, sam
from affinecert.reference._matrices import Array, Number, array, homogeneous

_ROOT = 1 / mp.sqrt(2)

EXAMPLE: Pair = QUARTER, affine([[1, 0], [0, 1]], [6, 0])
"""B = Rotate(90 degrees) and C = Translate(6, 0)."""


def _turned(x: Number, y: Number, sense: int = 1) -> Array:
    """The printed matrix of an eighth of a turn, clockwise, with that translation."""
    eighth = array([[_ROOT, sense * _ROOT], [-sense * _ROOT, _ROOT]])
    return homogeneous(mp, eighth, array([mp.mpf(x), mp.mpf(y)]))


X_SAM = _turned(3, 3 * mp.sqrt(2) - 3)
X_ALEXA = _turned(6 * mp.sqrt(2) / mp.pi, -6 * (mp.sqrt(2) - 2) / mp.pi)


def _step(morph: Morph, pair: Pair) -> Array:
    """X = M(1/2) B^-1."""
    found: Array = at(morph, pair, 0.5) @ inverse(pair[0])
    return found


def _twice(form: Array, pair: Pair) -> Number:
    """How far a pose is from X X B, X the step of Alexa (2002)."""
    step = _step(morphs.alexa_2002, pair)
    return distance(form, step @ step @ pair[0])


def _from_identity() -> list[Pair]:
    return [(unit(2), QUARTER), *((unit(len(pair[0]) - 1), pair[1]) for d in (2, 3) for pair in general_pairs(d))]


def _turns(first: Number, last: Number) -> Pair:
    """Two turns about the same point."""
    there, back = affine([[1, 0], [0, 1]], [1, 2]), affine([[1, 0], [0, 1]], [-1, -2])
    poses = (homogeneous(mp, plane_rotation(angle), exactly([0, 0])) for angle in (first, last))
    first_turn, last_turn = (there @ pose @ back for pose in poses)
    return first_turn, last_turn


def _commuting() -> list[Pair]:
    """Powers of the same map, with turns that differ by less than pi."""
    least = mp.mpf(2) ** -20
    sheared = affine([[1, 2], [0, 1]], [0, 0]), affine([[1, -1], [0, 1]], [0, 0])
    return [(unit(2), QUARTER), sheared, _turns(mp.mpf(1), mp.mpf(2)), _turns(-mp.pi / 2 + least, mp.pi / 2 - least)]


def _commuting_far() -> list[Pair]:
    """The same, with turns that differ by more than pi."""
    least = mp.mpf(2) ** -20
    return [_turns(-mp.pi / 2 - least, mp.pi / 2 + least), _turns(-mp.mpf(2), mp.mpf(2))]


def _commute(pair: Pair) -> bool:
    return bool(size(pair[0] @ pair[1] - pair[1] @ pair[0]) < HOLDS)


def _difference_commutes(pair: Pair) -> bool:
    """Whether W = log C - log B commutes with [X, W], [X, [X, W]] and so on, X = log B."""
    x, last = (sam.log(mp, pose) for pose in pair)
    w = bracket = last - x
    for _ in range(6):
        bracket = x @ bracket - bracket @ x
        if size(w @ bracket - bracket @ w) > HOLDS:
            return False
    return True


def _misjudged(form: Any, pair: Pair) -> Number:
    return mp.mpf(form(pair) != (unlike_steady(morphs.alexa_2002, pair) < HOLDS))


def _pairs() -> list[Pair]:
    doubled = affine([[2, 0], [0, 2]], [0, 0]), affine([[2, 0], [0, 2]], [1, 0])
    return [(unit(2), QUARTER), doubled, EXAMPLE, *_commuting()[1:], *general_pairs(2), *general_pairs(3)]


def _rotation(angle: Number, centre: Any) -> Array:
    linear, place = plane_rotation(angle), exactly(centre)
    return homogeneous(mp, linear, place - linear @ place)


def _translation(length: Number) -> Array:
    return homogeneous(mp, exactly([[1, 0], [0, 1]]), array([length, mp.zero]))


def _example() -> list[Pair]:
    return [EXAMPLE]


def _unlike_step(morph: Morph) -> Any:
    """How far a matrix is from X = M(1/2) B^-1."""

    def deviation(form: Array, pair: Pair) -> Number:
        return distance(form, _step(morph, pair))

    return deviation


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.3.3.2.from_identity",
        place="section 3.3.2",
        statement="The combination e^((1 - t) log 1 + t log A) of Alexa (2002) is the e^(t log A) of equation 2.",
        verdict=Verdict.CONFIRMED,
        form=morphs.alexa_2002,
        cases=_from_identity,
        deviation=unlike_steady,
        copies=(
            Copy("logarithms of rotation and stretch apart", morphs.polar_exponential),
            Copy("(1 - t) 1 + t A", morphs.linear),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.identical",
        place="section 3.3.2, (1)",
        statement="When B and C commute, e^((1 - t) log B + t log C) is the steady morph.",
        printed="Notice that when B and C commute (for example if B = 1), the two solutions are identical",
        verdict=Verdict.BOUND,
        domain="B and C turn by angles, within (-π, π), that differ by less than π. If by more, the combination of the "
        "logarithms passes through 0 and the steady morph goes the shorter way",
        form=morphs.alexa_2002,
        cases=_commuting,
        outside=_commuting_far,
        deviation=unlike_steady,
        copies=(
            Copy("logarithms of rotation and stretch apart", morphs.polar_exponential),
            Copy("R^t S^t", morphs.asap),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.only_if_commuting",
        place="section 3.3.2, (1)",
        statement="It is not, and not steady, when B and C do not commute.",
        printed="not equivalent to the expression we use ... except in singular cases when B and C commute",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_commute,
        cases=_pairs,
        deviation=_misjudged,
        correction=Correction(
            statement="It is if W = log C - log B commutes with [X, W], [X, [X, W]], ..., X = log B: also where B and "
            "C have the same linear part and do not commute, as twice and twice plus a translation.",
            form=_difference_commutes,
        ),
        copies=(Copy("where the linear parts commute", lambda pair: _commute((pair[0][:-1, :-1], pair[1][:-1, :-1]))),),
        remark="In general position it is not, as said.",
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.X_SAM",
        place="section 3.3.2, (1)",
        statement="For B = Rotate(90°) and C = Translate(6, 0) the steady morph has X = A^(1/2) as printed.",
        printed="X_SAM = [ 1/√2 1/√2 3; -1/√2 1/√2 3√2 - 3 ]",
        verdict=Verdict.CONFIRMED,
        form=X_SAM,
        cases=_example,
        deviation=_unlike_step(steady),
        copies=(
            Copy("3 - 3√2 for 3√2 - 3", _turned(3, 3 - 3 * mp.sqrt(2))),
            Copy("the turn transposed", _turned(3, 3 * mp.sqrt(2) - 3, sense=-1)),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.X_SAM_squared",
        place="section 3.3.2, (1)",
        statement="X_SAM² B = C.",
        verdict=Verdict.CONFIRMED,
        form=X_SAM,
        cases=_example,
        deviation=lambda form, pair: distance(form @ form @ pair[0], pair[1]),
        copies=(Copy("X_Alexa for X_SAM", X_ALEXA),),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.X_Alexa",
        place="section 3.3.2, (1)",
        statement="There e^((log B + log C) / 2) B^-1 is as printed.",
        printed="X_Alexa = [ 1/√2 1/√2 6√2/π; -1/√2 1/√2 -6(√2 - 2)/π ]",
        verdict=Verdict.CONFIRMED,
        form=X_ALEXA,
        cases=_example,
        deviation=_unlike_step(morphs.alexa_2002),
        copies=(
            Copy("-6(√2 - 1)/π", _turned(6 * mp.sqrt(2) / mp.pi, -6 * (mp.sqrt(2) - 1) / mp.pi)),
            Copy("6√2 for 6√2/π", _turned(6 * mp.sqrt(2), -6 * (mp.sqrt(2) - 2) / mp.pi)),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.same_turn",
        place="section 3.3.2, (1)",
        statement="In this case both solutions turn the model by the same amount.",
        verdict=Verdict.CONFIRMED,
        form=morphs.alexa_2002,
        cases=lambda: [mp.mpf(t) for t in (0.5, 0.25, 0.875)],
        deviation=lambda form, t: distance(at(form, EXAMPLE, t)[:2, :2], at(steady, EXAMPLE, t)[:2, :2]),
        copies=(Copy("(1 - t) B + t C", morphs.linear),),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.X_Alexa_squared",
        place="section 3.3.2, (1)",
        statement="X_Alexa² B is a translation by 12√2/π in the x direction.",
        printed="X_Alexa² ∘ B is a translation by only 12√2/π",
        verdict=Verdict.CONFIRMED,
        form=_translation(12 * mp.sqrt(2) / mp.pi),
        cases=_example,
        deviation=_twice,
        copies=(Copy("6 for 12√2/π", _translation(mp.mpf(6))),),
    ),
    Claim(
        id="rossignac_vinacua.3.3.2.number",
        place="section 3.3.2, (1)",
        statement="12√2/π ≈ 5.402.",
        printed="5.402",
        verdict=Verdict.CONFIRMED,
        form="5.402",
        cases=lambda: [12 * mp.sqrt(2) / mp.pi],
        deviation=rounded,
        copies=(Copy("the last digit", "5.401"),),
    ),
    Claim(
        id="rossignac_vinacua.figure_4.rotation",
        place="section 3.3.2, figure 4",
        statement="The midway pose of the steady morph amounts to a rotation by -π/2 about the fixed point (3, -3).",
        printed="a rotation by -π/2 around the fixed point q = (3, -3)",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_rotation(-mp.pi / 2, [3, -3]),
        cases=_example,
        deviation=_unlike_step(steady),
        correction=Correction(
            statement="To one by -π/4: by -π/2 it is at the end.",
            form=_rotation(-mp.pi / 4, [3, -3]),
        ),
        copies=(
            Copy("about (3, 3)", _rotation(-mp.pi / 4, [3, 3])),
            Copy("by π/4", _rotation(mp.pi / 4, [3, -3])),
        ),
        remark="The fixed point is right.",
    ),
    Claim(
        id="rossignac_vinacua.figure_5.speed",
        place="section 3.3.2, figure 5",
        statement="The triangle of e^((1 - t) log B + t log C) moves and turns more slowly at the left and more "
        "quickly at the right.",
        verdict=Verdict.UNCHECKABLE,
        reason="the poses of the triangles are not given",
    ),
)
