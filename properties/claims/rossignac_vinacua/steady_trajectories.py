"""Sections 1 and 2.3, (6) to (8), and figure 3: velocities and paths of points, and how they change with the poses."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine, arrays, plane_rotation
from affinecert.properties.claims.precision import HOLDS, difference, distance, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import (
    QUARTER,
    Morph,
    Pair,
    at,
    general_pairs,
    steady,
    unit,
)
from affinecert.properties.matrix.algebra import inverse
from affinecert.reference import morphs, sam
from affinecert.reference._matrices import Array, Context, Number, array, dot, homogeneous, norm, scalar, tangent


def _rate(morph: Morph, pair: Pair, t: Number, order: int = 1) -> Array:
    """The derivative of the pose: the velocities, in the global frame, of the points that move with it."""
    rate: Array = definitions.derivative(mp, lambda s: at(morph, pair, s), t, order)
    return rate


def _of_places(morph: Morph, pair: Pair, t: Number) -> Array:
    """The velocities at places of the global frame, M' M^-1."""
    found: Array = _rate(morph, pair, t) @ inverse(at(morph, pair, t))
    return found


def _in_moving_frame(morph: Morph, pair: Pair, t: Number) -> Array:
    """The velocities of points in the moving frame, M^-1 M'."""
    found: Array = inverse(at(morph, pair, t)) @ _rate(morph, pair, t)
    return found


def _change(kind: Any, morph: Morph, pair: Pair) -> Number:
    """How much the velocities of a kind change with time."""
    return difference(kind(morph, pair, mp.mpf(0.25)), kind(morph, pair, mp.mpf(0.75)))


def _nonstationary(form: Morph, pair: Pair) -> Number:
    return max(_change(kind, form, pair) for kind in (_of_places, _in_moving_frame))


def _moving_pairs() -> list[Pair]:
    return [(unit(2), QUARTER), general_pairs(2)[0], general_pairs(3)[0]]


def _half_way(m: Context, start: Array, velocity: Array) -> Array:
    """The pose at 1/2 of the steady morph from B to B e^X."""
    return steady(m, start, start @ sam.exponential(m, velocity), scalar(m.mpf(0.5)))


def _local_velocities() -> list[tuple[Array, Array]]:
    drawn = arrays("local velocities", 3, (3, 4), -1, 1)
    velocities = [tangent(mp, each[:, :3], each[:, 3]) for each in drawn]
    return [(pair[0], velocity) for pair, velocity in zip(general_pairs(3), velocities, strict=True)]


def _steady_path(affinity: Array, point: Array, t: Number) -> Array:
    """The point A^t p."""
    path: Array = (sam.power(mp, affinity, scalar(t)) @ np.append(point, mp.one))[:-1]
    return path


def _straight_path(affinity: Array, point: Array, t: Number) -> Array:
    path: Array = point * (1 - t) + _steady_path(affinity, point, mp.one) * t
    return path


def _even_path(affinity: Array, point: Array, t: Number) -> Array:
    """A^t p with distances from the fixed point that grow evenly, as on the spiral of Archimedes."""
    centre, path = sam.fixed_point(mp, affinity), _steady_path(affinity, point, t)
    ends = [norm(mp, _steady_path(affinity, point, each) - centre) for each in (mp.zero, t, mp.one)]
    even: Array = centre + (path - centre) * ((ends[0] * (1 - t) + ends[2] * t) / ends[1])
    return even


def _unlike_spiral(form: Any, case: tuple[Array, Array]) -> Number:
    """How far a path is from a logarithmic spiral times an exponential.

    In a frame whose origin is the fixed point, and whose first two vectors are orthonormal, in equal times the distance
    from the third axis and the third coordinate grow by the same factors, and the direction turns by the same angle.
    """
    frame, core = case
    affinity = frame @ homogeneous(mp, core, exactly([0, 0, 0])) @ inverse(frame)
    start = (frame @ exactly([1, 0.5, 2, 1]))[:-1]
    path = [form(affinity, start, mp.mpf(k) / 4) for k in range(4)]
    seen = [(inverse(frame) @ np.append(each, mp.one))[:-1] for each in path]
    lengths, heights = [norm(mp, each[:2]) for each in seen], [each[2] for each in seen]
    turns = [dot(mp, a[:2], b[:2]) / norm(mp, a[:2]) / norm(mp, b[:2]) for a, b in pairwise(seen)]
    rates = turns, [b / a for a, b in pairwise(lengths)], [b / a for a, b in pairwise(heights)]
    return max(difference(array(each[:-1]), array(each[1:])) for each in rates)


def _core(plane: Any, along: float) -> Array:
    """The linear map of a plane and of an axis."""
    (a, b), (c, d) = plane
    found: Array = exactly([[a, b, 0], [c, d, 0], [0, 0, along]])
    return found


_SLANTED = affine([[0, -1, 1], [1, 0, 2], [0, 0, 1]], [1, 0, 2])
_ORTHOGONAL = homogeneous(mp, exactly([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3, exactly([0, 3, 1]))


def _spirals() -> list[tuple[Array, Array]]:
    """Maps that are similarities of a plane."""
    return [(unit(3), _core([[0, -2], [2, 0]], 3)), (_SLANTED, _core([[1, 1], [-1, 1]], 0.5))]


def _no_spirals() -> list[tuple[Array, Array]]:
    """An elliptic turn in the plane, and three real eigenvalues."""
    return [(unit(3), _core([[1, -1.25], [1, 1]], 3)), (unit(3), _core([[2, 0], [0, 4]], 3))]


def _similarities() -> list[tuple[Array, Array]]:
    """Similarities that are no isometries."""
    return [(unit(3), _core([[0, -2], [2, 0]], 2)), (_ORTHOGONAL, _core([[-0.375, 0.5], [-0.5, -0.375]], 0.625))]


def _inflected(form: Morph, pair: Pair) -> Number:
    """The lesser of the curvatures to the left and to the right, as products of velocity and acceleration."""
    worst = mp.zero
    rates = [(_rate(form, pair, mp.mpf(k) / 8), _rate(form, pair, mp.mpf(k) / 8, 2)) for k in range(9)]
    for corner in exactly([[0, 0, 1], [1, 0, 1], [0, 1, 1]]):
        bends = [u[0] * v[1] - u[1] * v[0] for u, v in ((first @ corner, second @ corner) for first, second in rates)]
        worst = max(worst, min(max(bends), max(-bend for bend in bends)))
    return worst


def _jump(form: Morph, pair: Pair) -> Number:
    """Whether turning C a little to either side makes much of a difference half way."""
    start, end = pair
    little = mp.mpf(10) ** -30
    sides = [homogeneous(mp, plane_rotation(each), exactly([0, 0])) @ end for each in (little, -little)]
    return mp.mpf(difference(*(at(form, (start, side), 0.5) for side in sides)) > mp.mpf(10) ** -25)


def _anticlockwise(m: Context, start: Array, end: Array, t: Array) -> Array:
    """The steady morph, but by an angle from 0 to 2 pi where B = I and C is a similarity about the origin."""
    log = sam.log(m, end @ inverse(start))
    if log[1, 0] < 0 and abs(log[1, 0] + log[0, 1]) < HOLDS:
        log = log + 2 * m.pi * tangent(m, exactly([[0, -1], [1, 0]]), exactly([0, 0]))
    found: Array = sam.exponential(m, log * t[()]) @ start
    return found


def _turned_pairs() -> list[Pair]:
    ends = [homogeneous(mp, 2 * plane_rotation(angle), exactly([0, 0])) for angle in (mp.zero, mp.one, -mp.mpf(3.125))]
    return [*((unit(2), end) for end in ends), *general_pairs(2)]


def _half_turns() -> list[Pair]:
    return [(unit(2), affine([[-1, 0], [0, -1]], [0, 0])), (unit(2), affine([[-2, 0], [0, -2]], [1, 0]))]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.1.similarity",
        place="section 1",
        statement="When A is a similarity of space, the steady morph is a logarithmic spiral motion in the plane times "
        "an exponential scaling in the third dimension.",
        verdict=Verdict.CONFIRMED,
        form=_steady_path,
        cases=_similarities,
        deviation=_unlike_spiral,
        copies=(
            Copy("the straight path", _straight_path),
            Copy("the spiral of Archimedes for the logarithmic one", _even_path),
        ),
        remark="Of scale other than 1: of isometries, which the sentence treats first, the third dimension is a slide.",
    ),
    Claim(
        id="rossignac_vinacua.2.3.6.field",
        place="abstract and section 2.3, (6)",
        statement="The velocity field of a steady morph is stationary both in the global and in the moving frame.",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=_moving_pairs,
        deviation=_nonstationary,
        copies=(
            Copy("R^t S^t for (R S)^t", morphs.asap),
            Copy("exp((1 - t) log B + t log C)", morphs.alexa_2002),
        ),
    ),
    Claim(
        id="rossignac_vinacua.2.3.6.every_point",
        place="section 2.3, (6)",
        statement="During a steady morph the velocity of every point remains constant in the global frame.",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=_rate,
        cases=_moving_pairs,
        deviation=lambda form, pair: _change(form, steady, pair),
        correction=Correction(
            statement="It does at every place of the global frame; of a point that moves along, in the moving frame.",
            form=_of_places,
        ),
        copies=(Copy("of every point, in the frame of B", lambda f, p, t: inverse(p[0]) @ _rate(f, p, t)),),
        remark="The abstract says it right: a turning point's own velocity turns.",
    ),
    Claim(
        id="rossignac_vinacua.2.3.6.only",
        place="section 2.3, (6)",
        statement="Steady morphs are the only motions with constant velocities in the moving frame: M' = M X gives "
        "B e^(tX), which is the steady morph from B to B e^X.",
        verdict=Verdict.CONFIRMED,
        form=lambda m, start, velocity: start @ sam.exponential(m, velocity / 2),
        cases=_local_velocities,
        deviation=lambda form, case: distance(form(mp, *case), _half_way(mp, *case)),
        copies=(Copy("e^(tX) B for B e^(tX)", lambda m, start, x: sam.exponential(m, x / 2) @ start),),
    ),
    Claim(
        id="rossignac_vinacua.2.3.7.spiral",
        place="section 2.3, (7)",
        statement="The path of a point in a steady morph of space combines a logarithmic spiral in a plane with an "
        "exponential scaling in a direction transversal to it.",
        verdict=Verdict.BOUND,
        domain="L is a similarity of the plane and has an eigenvalue other than 1 across it. With a complex pair in "
        "general the path in the plane is an affine image of such a spiral, which cuts its rays at changing angles; "
        "with three real eigenvalues it is no spiral",
        form=_steady_path,
        cases=_spirals,
        outside=_no_spirals,
        deviation=_unlike_spiral,
        copies=(
            Copy("the straight path", _straight_path),
            Copy("the spiral of Archimedes for the logarithmic one", _even_path),
        ),
        remark="Collision tests that were made for spirals must first map the plane.",
    ),
    Claim(
        id="rossignac_vinacua.2.3.8.inflections",
        place="section 2.3, (8)",
        statement="Points travel without inflections (in the plane).",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=lambda: [(unit(2), QUARTER), *general_pairs(2, 4)],
        deviation=_inflected,
        copies=(
            Copy("exp((1 - t) log B + t log C)", morphs.alexa_2002),
            Copy("R^t ((1 - t) I + t S)", morphs.rarap),
        ),
        remark="Velocity and acceleration span the area det(X p, X² p) e^(t tr X), of one sign for all t. That motions "
        "without inflections are visually pleasing is for others to judge.",
    ),
    Claim(
        id="rossignac_vinacua.figure_3.smooth",
        place="section 2.3, figure 3",
        statement="The steady morph changes smoothly as the user changes the poses.",
        verdict=Verdict.BOUND,
        domain="while no half turn is passed: there it jumps from one way round to the other, and next to it, for "
        "C B^-1 with two unequal negative eigenvalues, it does not exist",
        form=steady,
        cases=_turned_pairs,
        outside=_half_turns,
        deviation=_jump,
        copies=(Copy("angles from 0 to 2π", _anticlockwise),),
    ),
)
