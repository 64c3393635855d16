"""Section 2.3, (1) to (5): uniqueness, invariance, volumes and isometries."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine, plane_rotation, rotations
from affinecert.properties.claims.precision import exactly, mp
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import (
    Morph,
    Pair,
    at,
    general_pairs,
    law,
    rigid_pairs,
    steady,
    unit,
)
from affinecert.properties.matrix.algebra import inverse
from affinecert.reference import morphs, sam, so3
from affinecert.reference._matrices import Array, Context, Number, dot, homogeneous, identity, norm, scalar


def _all_pairs() -> list[Pair]:
    return [*general_pairs(2), *general_pairs(3)]


def _half_turns() -> list[Pair]:
    """Pairs of poses with half a turn between them."""
    return [
        (unit(2), affine([[-1, 0], [0, -1]], [0, 0])),
        (affine([[1, 1], [0, 1]], [0, 0]), affine([[-2, -2], [0, -2]], [1, 0])),
        (unit(3), affine([[-1, 0, 0], [0, 1, 0], [0, 0, -1]], [0, 0, 1])),
    ]


def _another(form: Number, turn: Array) -> Number:
    """How many steady motions to a turn by less than ``form`` there are, besides the first."""
    angle = mp.atan2(turn[1, 0], turn[0, 0])
    return mp.mpf(sum(abs(angle + 2 * mp.pi * k) < form for k in range(-3, 4)) - 1)


def _turns() -> list[Array]:
    return [exactly([[0, -1], [1, 0]]), plane_rotation(mp.mpf(-3)), plane_rotation(mp.mpf(1) / 8)]


def _content(vectors: Array) -> Number:
    """The length of a vector, the area of a parallelogram, or the volume of a box, edges in columns."""
    return mp.sqrt(definitions.determinant(vectors.T @ vectors))


def _strayed(form: Morph, case: tuple[Pair, Array]) -> Number:
    """By how much a content leaves the order of its values at the ends: the lesser of all rises and all falls."""
    pair, edges = case
    contents = [_content(at(form, pair, mp.mpf(k) / 8)[:-1, :-1] @ edges) for k in range(9)]
    steps = [after - before for before, after in pairwise(contents)]
    return max(min(max(*steps, 0), max(*(-step for step in steps), 0)), 0)


def _whole() -> list[tuple[Pair, Array]]:
    pairs = [(unit(2), affine([[0, -1], [1, 0]], [1, 0])), (unit(2), affine([[2, 1], [1, 1]], [1, 0])), *_all_pairs()]
    return [(pair, unit(len(pair[0]) - 2)) for pair in pairs]


def _parts() -> list[tuple[Pair, Array]]:
    """A face and an edge of a body, and an edge of a figure, in stretches that keep the volume."""
    stretch, figure = affine([[2, 0, 0], [0, 2, 0], [0, 0, 0.25]], [0, 0, 0]), affine([[2, 0], [0, 0.5]], [0, 0])
    return [
        ((unit(3), stretch), exactly([[1, 0], [0, 1], [0, 4]])),
        ((unit(3), stretch), exactly([[1], [0], [4]])),
        ((unit(2), figure), exactly([[1], [2]])),
    ]


def _unlike_volume(form: Morph, pair: Pair) -> Number:
    """How far det M(t) is from det B where det C is the same."""
    volume = definitions.determinant(pair[0][:-1, :-1])
    return max(abs(definitions.determinant(at(form, pair, t)[:-1, :-1]) / volume - 1) for t in (0.25, 0.5))


def _of_one_volume() -> list[Pair]:
    """Pairs of poses between which the volume is kept."""
    maps = [affine([[1, 1], [-1, 0]], [1, 2]), affine([[2, 1], [1, 1]], [0, 0])]
    solid = affine([[2, 1, 0], [1, 1, 1], [0, 0, 1]], [1, 0, 0])
    starts = [general_pairs(2)[1][0], unit(2), general_pairs(3)[1][0]]
    return [(start, step @ start) for start, step in zip(starts, [*maps, solid], strict=True)]


def _rigid_steps() -> list[Pair]:
    """Pairs B, C of which C B^-1 is rigid, and B is not."""
    moves = [homogeneous(mp, turn, exactly([1, 0, 2])) for turn in rotations("rigid steps", 3)]
    starts = [unit(3), *(pair[0] for pair in general_pairs(3)[1:])]
    return [(start, move @ start) for start, move in zip(starts, moves, strict=True)]


def _similar_steps() -> list[Pair]:
    """Pairs B, C of which C B^-1 is a similarity, and B is not."""
    scales = [affine([[k, 0, 0], [0, k, 0], [0, 0, k]], [0, 1, 0]) for k in (2, 0.5)]
    return [(start, scale @ end) for scale, (start, end) in zip(scales, _rigid_steps()[1:], strict=True)]


def _screw_of(form: Morph, pair: Pair, t: Number) -> tuple[Array, Number]:
    """The rotation vector of M(t) B^-1 and its translation along its axis."""
    motion = at(form, pair, t) @ inverse(pair[0])
    vector = so3.log(mp, motion[:-1, :-1])
    axis = vector / norm(mp, vector)
    return vector, dot(mp, axis, motion[:-1, -1])


def _roundabout(form: Morph, pair: Pair) -> Number:
    """By how much the angles of the steps of a morph, in all, exceed the angle between the poses."""
    poses = [at(form, pair, mp.mpf(k) / 8) for k in range(9)]
    steps = [norm(mp, so3.log(mp, (after @ inverse(before))[:3, :3])) for before, after in pairwise(poses)]
    return abs(sum(steps) - norm(mp, _screw_of(form, pair, 1)[0]))


def _uneven(form: Morph, pair: Pair) -> Number:
    """How far angle and translation along the axis are from growing evenly."""
    (quarter, quarter_way), (half, half_way) = (_screw_of(form, pair, t) for t in (0.25, 0.5))
    return max(*(abs(each) for each in 2 * quarter - half), abs(2 * quarter_way - half_way))


def _longer_way(m: Context, start: Array, end: Array, t: Array) -> Array:
    """The steady motion between rigid poses that turns the other way round."""
    step = end @ inverse(start)
    vector = so3.log(m, step[:3, :3])
    turned = homogeneous(m, so3.exp(m, -vector / norm(m, vector) * (2 * m.pi * t[()])), 0 * vector)
    axis = homogeneous(m, identity(m, 3), _foot(m, step, vector))
    found: Array = sam.power(m, step, t) @ axis @ turned @ inverse(axis) @ start
    return found


def _foot(m: Context, step: Array, vector: Array) -> Array:
    """A point on the axis of a screw."""
    axis = vector / norm(m, vector)
    across = step[:3, 3] - axis * dot(m, axis, step[:3, 3])
    projector = axis[:, None] * axis[None, :]
    foot: Array = definitions.inverse(m, identity(m, 3) - step[:3, :3] + projector) @ across
    return foot


_NO_HALF_TURN = "no half turn between B and C: there are two of equal right, and what chooses between them by A alone "

CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.2.3.1.unique",
        place="section 2.3, (1)",
        statement="The steady motion between two poses is unique, if half turns are excluded and motions that rotate "
        "by more than 360 degrees discarded.",
        printed="discarding SAMs that rotate by more than 360 degrees and excluding 180 degrees turns",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=2 * mp.pi,
        cases=_turns,
        deviation=_another,
        correction=Correction(
            statement="It is, if motions that rotate by 180 degrees or more are discarded: of those that rotate by "
            "less than 360 there are two, one each way round.",
            form=+mp.pi,
        ),
        copies=(Copy("by less than 190 degrees", mp.pi * 19 / 18),),
    ),
    Claim(
        id="rossignac_vinacua.2.3.2.affine_invariant",
        place="section 2.3, (2)",
        statement="The steady morph is affine-invariant: that from G B to G C is G times that from B to C.",
        verdict=Verdict.BOUND,
        domain=_NO_HALF_TURN + "is not invariant",
        form=steady,
        cases=_all_pairs,
        outside=lambda: _half_turns()[:2],
        deviation=law("affine invariant"),
        copies=(
            Copy("R^t S^t for (R S)^t", morphs.asap),
            Copy("R^t ((1 - t) I + t S)", morphs.rarap),
            Copy("the rotation, scale and shear of a frame each by itself", morphs.lie),
        ),
    ),
    Claim(
        id="rossignac_vinacua.2.3.3.reversible",
        place="section 2.3, (3)",
        statement="The steady morph is reversible: swapping the poses gives the reverse motion.",
        verdict=Verdict.BOUND,
        domain=_NO_HALF_TURN + "is not reversed, as A = A^-1 may be",
        form=steady,
        cases=_all_pairs,
        outside=_half_turns,
        deviation=law("reversible"),
        copies=(Copy("A^(t²) for A^t", lambda m, b, c, t: steady(m, b, c, scalar(t[()] ** 2))),),
    ),
    Claim(
        id="rossignac_vinacua.2.3.4.monotone",
        place="section 2.3, (4)",
        statement="Integral measures (volumes, area) evolve monotonically during a steady morph.",
        verdict=Verdict.BOUND,
        domain="measures of full dimension: area in the plane, volume in space. The area of a surface in space, or the "
        "length of a curve, may fall and rise again",
        form=steady,
        cases=_whole,
        outside=_parts,
        deviation=_strayed,
        copies=(
            Copy("(1 - t) B + t C", morphs.linear),
            Copy("R^t ((1 - t) I + t S), area grows between equal ones", morphs.rarap),
        ),
    ),
    Claim(
        id="rossignac_vinacua.2.3.4.kept",
        place="abstract and section 2.3, (4)",
        statement="A steady morph preserves volume, in the plane area, if A does.",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=_of_one_volume,
        deviation=_unlike_volume,
        copies=(
            Copy("(1 - t) B + t C", morphs.linear),
            Copy("R^t ((1 - t) I + t S)", morphs.rarap),
            Copy("a spiral and the rest in a straight line", morphs.log_spiral),
        ),
        remark="R^t S^t and exp((1 - t) log B + t log C) preserve it too, as their determinants are powers.",
    ),
    Claim(
        id="rossignac_vinacua.abstract.similarities",
        place="abstract",
        statement="A steady morph preserves similarities: if A is one, so is M(t) B^-1, whatever B.",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=_similar_steps,
        deviation=law("similarity kept"),
        copies=(
            Copy("exp((1 - t) log B + t log C)", morphs.alexa_2002),
            Copy("(1 - t) B + t C", morphs.linear),
        ),
    ),
    Claim(
        id="rossignac_vinacua.2.3.5.rigid",
        place="abstract and section 2.3, (5)",
        statement="A steady morph preserves rigidity: if A is an isometry, so is M(t) B^-1, whatever B.",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=_rigid_steps,
        deviation=law("isometry kept"),
        copies=(
            Copy("exp((1 - t) log B + t log C)", morphs.alexa_2002),
            Copy("(1 - t) B + t C", morphs.linear),
        ),
    ),
    Claim(
        id="rossignac_vinacua.2.3.5.shortest",
        place="section 2.3, (5)",
        statement="Between rigid poses it turns by the smallest angle there is.",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=rigid_pairs,
        deviation=_roundabout,
        copies=(Copy("the screw that turns the other way round", _longer_way),),
    ),
    Claim(
        id="rossignac_vinacua.2.3.5.constant_speed",
        place="section 2.3, (5)",
        statement="Between rigid poses angle and translation along the axis grow evenly.",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=rigid_pairs,
        deviation=_uneven,
        copies=(
            Copy("dual quaternion linear blending", morphs.dual_quaternion_linear),
            Copy("exp((1 - t) log B + t log C)", morphs.alexa_2002),
        ),
    ),
)
