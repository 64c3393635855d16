"""Abstract and section 1: steadiness as the inverse of the average relative acceleration, and what is steady."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import HOLDS, distance, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import (
    QUARTER,
    Morph,
    Pair,
    at,
    general_pairs,
    steady,
    unit,
    unsteadiness,
)
from affinecert.properties.matrix.algebra import inverse
from affinecert.reference import morphs, sam, so3
from affinecert.reference._matrices import Array, Number, array, homogeneous, norm, scalar
from affinecert.reference.measures import average_relative_acceleration

STEPS = 4
"""Steps of the paths whose acceleration is measured: a motion is steady at any number of steps, or at none."""


def _corners(dimension: int) -> Array:
    """The corners of the standard simplex."""
    found: Array = (
        array(np.concatenate([np.zeros((1, dimension), dtype=int), np.eye(dimension, dtype=int)]).tolist()) * mp.one
    )
    return found


def _measure(poses: Array, points: Array) -> Number:
    return average_relative_acceleration(mp, poses, points)[()]


def _in_the_world(poses: Array, points: Array) -> Number:
    """The same of velocities in the global frame."""
    places = np.concatenate([points, np.full((len(points), 1), mp.one)], axis=1)
    velocities = [(after - before) @ places.T for before, after in pairwise(poses)]
    changes = [after - before for before, after in pairwise(velocities)]
    return sum(norm(mp, change.T.flat) for change in changes)


def _of_the_origin(poses: Array, points: Array) -> Number:
    """The same, averaged over the origin alone."""
    return _measure(poses, points[:1] * 0)


def _path(motion: Any, *inputs: Any) -> Array:
    return np.array([motion(*inputs, mp.mpf(k) / STEPS) for k in range(STEPS + 1)], dtype=object)


def _disagreement(form: Any, case: tuple[Morph, Pair]) -> Number:
    """Whether a measure vanishes where equation 1 does not hold, or the other way round."""
    morph, pair = case
    path = _path(lambda t: at(morph, pair, t))
    return mp.mpf((form(path, _corners(path.shape[-1] - 1)) < HOLDS) != (unsteadiness(morph, pair) < HOLDS))


def _measured() -> list[tuple[Morph, Pair]]:
    turned = unit(2), QUARTER
    grown = unit(2), affine([[1, -1], [1, 2]], [0, 0])
    pairs = [turned, grown, general_pairs(2)[0], general_pairs(3)[0]]
    return [(morph, pair) for pair in pairs for morph in (steady, morphs.linear, morphs.asap, morphs.lie)]


def _accelerated(form: Any, inputs: tuple[Any, ...]) -> Number:
    """The average relative acceleration of a motion ``form(*inputs, t)``."""
    path = _path(form, *inputs)
    return _measure(path, _corners(path.shape[-1] - 1))


def _turning(angle: Number, centre: Array, t: Number, *, rate: int = 1) -> Array:
    """The turn of the plane by t^rate angle about a centre."""
    cosine, sine = mp.cos(t**rate * angle), mp.sin(t**rate * angle)
    linear = array([[cosine, -sine], [sine, cosine]])
    return homogeneous(mp, linear, centre - linear @ centre)


def _rolling(angle: Number, centre: Array, t: Number) -> Array:
    """The same, while the centre moves at a constant velocity."""
    pose = _turning(angle, centre, t)
    pose[0, -1] += t
    return pose


def _screw(axis: Array, angle: Number, length: Number, t: Number, *, slide: Array | None = None) -> Array:
    """The screw by an angle and a length about a unit axis through (1, 0, 0); ``slide`` is its direction."""
    linear, centre = so3.exp(mp, axis * (angle * t)), exactly([1, 0, 0])
    direction = axis if slide is None else slide
    return homogeneous(mp, linear, centre - linear @ centre + direction * (length * t))


def _golden(angle: Number, t: Number, *, archimedes: bool = False) -> Array:
    """The spiral that grows by the golden ratio in every quarter turn; or as much in the whole, but evenly."""
    whole = mp.phi ** (2 * angle / mp.pi)
    pose = _turning(angle, exactly([0, 0]), t)
    pose[:-1] *= 1 + t * (whole - 1) if archimedes else whole**t
    return pose


def _irregularity(form: Morph, case: tuple[Pair, int]) -> Number:
    """How far consecutive ones of n + 1 sampled poses are from being related by A^(1/n)."""
    pair, n = case
    root = sam.power(mp, pair[1] @ inverse(pair[0]), scalar(mp.one / n))
    poses = [at(form, pair, mp.mpf(i) / n) for i in range(n + 1)]
    return max(distance(after, root @ before) for before, after in pairwise(poses))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.abstract.pattern",
        place="abstract and section 1",
        statement="The poses A^(i/n) B of a steady morph form a regular pattern: consecutive ones are related by the "
        "same affinity A^(1/n).",
        printed="A^(1/n) ∘ B",
        verdict=Verdict.CONFIRMED,
        form=steady,
        cases=lambda: [(pair, n) for n, d in ((2, 2), (5, 2), (3, 3)) for pair in general_pairs(d)[:2]],
        deviation=_irregularity,
        copies=(
            Copy("exp((1 - t) log B + t log C) for A^t B", morphs.alexa_2002),
            Copy("R^t S^t for (R S)^t", morphs.asap),
        ),
        remark="The abstract has A^(1/n) for A^(i/n) in the first place; section 1 has it right.",
    ),
    Claim(
        id="rossignac_vinacua.1.measure",
        place="section 1",
        statement="A motion is steady in the sense of equation 1 if and only if its average relative acceleration, "
        "that of velocities in the moving frame, is 0.",
        verdict=Verdict.CONFIRMED,
        form=_measure,
        cases=_measured,
        deviation=_disagreement,
        copies=(
            Copy("velocities in the global frame", _in_the_world),
            Copy("the average over one point, not over space", _of_the_origin),
        ),
        remark="The steadiness 1 / ARA of such a motion is infinite. Section 2.4 has an integral over space and time "
        "in place of the average of section 1, another number by a factor of the volume.",
    ),
    Claim(
        id="rossignac_vinacua.1.rotation",
        place="abstract and section 1",
        statement="Rotations at a constant angular velocity about a fixed centre have ARA = 0.",
        verdict=Verdict.CONFIRMED,
        form=_turning,
        cases=lambda: [(mp.pi / 2, exactly([0, 0])), (mp.mpf(5), exactly([2, -1]))],
        deviation=_accelerated,
        copies=(
            Copy("the angle grows as t²", lambda angle, centre, t: _turning(angle, centre, t, rate=2)),
            Copy("the centre moves at a constant velocity", _rolling),
        ),
    ),
    Claim(
        id="rossignac_vinacua.1.screw",
        place="abstract and section 1",
        statement="Screw motions, and translations at a constant velocity, have ARA = 0.",
        verdict=Verdict.CONFIRMED,
        form=_screw,
        cases=lambda: [
            (exactly([0, 0, 1]), mp.zero, mp.one),
            (exactly([0, 0, 1]), mp.pi / 2, mp.one),
            (exactly([2, 3, 6]) / 7, mp.mpf(4), -mp.mpf(2)),
        ],
        deviation=_accelerated,
        copies=(
            Copy("a slide next to the axis", lambda *args: _screw(*args, slide=args[0] + exactly([0, 0.125, 0]))),
            Copy("a length that grows as t²", lambda a, angle, length, t: _screw(a, angle, length * t, t)),
        ),
    ),
    Claim(
        id="rossignac_vinacua.1.golden_spiral",
        place="abstract and section 1",
        statement="The golden spiral, which grows by the golden ratio every quarter turn, has ARA = 0.",
        verdict=Verdict.CONFIRMED,
        form=_golden,
        cases=lambda: [(mp.pi / 2,), (2 * mp.pi,)],
        deviation=_accelerated,
        copies=(Copy("an even growth", lambda angle, t: _golden(angle, t, archimedes=True)),),
        remark="So has every logarithmic spiral.",
    ),
)
