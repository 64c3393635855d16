"""Sequences of similarities by what is difficult in going through them: where the rotation passes through pi.

Between poses the rotation is to go the short way. By the rotation vectors of the poses it does, except where it passes
through pi: there the vector jumps to the other side, or leaves the ball of radius pi.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from affinecert.catalogue import turns
from affinecert.catalogue.turns import Turn
from affinecert.draw import Draw
from affinecert.map import Array
from affinecert.sampling import half_turns, homogeneous, signed, vector


@dataclass(frozen=True)
class Journey:
    """Poses (keys, 4, 4), the distance to what makes them difficult, and a time up to which the motion takes place.

    A motion takes the time 1 from pose to pose, or 2 (`affinecert.reference.splines.key_times`).
    """

    poses: Array
    distance: float
    duration: float


@dataclass(frozen=True)
class Journeys:
    """What a regime draws its poses from; ``name`` and ``distance`` become the regime's."""

    name: str
    distance: str
    build: Callable[[Draw], Journey]
    share: float = 0.2


NO_TURN = Turn(np.zeros(3), np.zeros(3), np.eye(3), 0.0)


def _scale(draw: Draw) -> float:
    return draw.choice((1.0, draw.uniform(0.5, 2.0)))


def _placed(draw: Draw, rotation: Array, low: float = -2, high: float = 2) -> Array:
    return homogeneous(_scale(draw) * rotation, vector(draw, low, high))


def _journey(draw: Draw, rotations: Sequence[Turn], distance: float) -> Journey:
    return _of(np.stack([_placed(draw, turn.matrix) for turn in rotations]), distance)


def _of(poses: Array, distance: float) -> Journey:
    return Journey(poses, distance, float(len(poses) - 1))


def _any(draw: Draw) -> Turn:
    angle = draw.uniform(0.0, math.pi)
    return turns.about(draw.direction(3), angle, angle)


def _none(_: Draw) -> Turn:
    return NO_TURN


def _generic(count: int) -> Callable[[Draw], Journey]:
    def build(draw: Draw) -> Journey:
        rotations = [_any(draw) for _ in range(count)]
        return _journey(draw, rotations, max(turn.distance for turn in rotations))

    return build


def _wobbling(draw: Draw, axis: Array, wobble: float) -> Array:
    """A unit vector at a distance of about ``wobble`` from the axis."""
    tilted = axis + wobble * draw.direction(3)
    return np.asarray(tilted / np.linalg.norm(tilted))


def _through_pi(draw: Draw) -> Journey:
    """On the first way through pi, about axes that hardly differ; it is a segment of its own, and takes the time 2."""
    axis, wobble = draw.direction(3), draw.choice((0.0, draw.exponent(-16, -0.5)))
    angles = [a + draw.uniform(-0.1, 0.1) for a in draw.choice(((2.0, 4.0, 5.0), (3.0, 3.5, 2.5), (-2.0, 2.0, 2.5)))]
    journey = _journey(draw, [turns.about(_wobbling(draw, axis, wobble), a, wobble) for a in angles], wobble)
    return replace(journey, duration=4.0)


def _round_and_round(draw: Draw) -> Journey:
    axis, wobble = draw.direction(3), draw.exponent(-3, -0.5)
    step = draw.choice((1.0, -1.0)) * draw.uniform(1.9, 2.3)
    return _journey(draw, [turns.about(_wobbling(draw, axis, wobble), step * k, wobble) for k in range(8)], wobble)


def _near_pi(draw: Draw) -> Journey:
    """The middle pose turned by nearly pi, from either side, between two that are not."""
    axis, gap = draw.direction(3), signed(draw, -15, -1)
    ends = [turns.about(_wobbling(draw, axis, 0.3), draw.uniform(*angles), gap) for angles in ((1.5, 2.5), (3.5, 4.5))]
    journey = _journey(draw, [ends[0], turns.short_of_pi(axis, gap, gap), ends[1]], abs(gap))
    return journey if gap > 0.0 else replace(journey, duration=4.0)


def _near_two_pi(draw: Draw) -> Journey:
    """Nearly a half turn, then nearly none about the opposite axis: the short way leads to an angle of nearly 2 pi."""
    axis, gap = draw.direction(3), draw.exponent(-12, -1)
    # The rotation vector next to 2 pi is the nearer one, for pi - gap/4 > pi - gap.
    before, behind = turns.short_of_pi(axis, gap / 4, gap), turns.about(axis, -gap, gap)
    return replace(_journey(draw, [before, behind, _any(draw)], gap), duration=4.0)


def _half_turns(draw: Draw) -> Journey:
    """Rotations by pi exactly, whose rotation vectors have two signs: all ties are met here."""
    exact = [Turn(np.zeros(3), np.zeros(3), matrix, 1.0) for matrix in half_turns()]
    rotations = [draw.choice(exact) for _ in range(3)]
    rotations[draw.choice(range(3))] = draw.choice((_any(draw), NO_TURN))
    return _journey(draw, rotations, 1.0)


def _close(draw: Draw) -> Journey:
    """Each pose next to the one before."""
    step = draw.exponent(-15, -1)
    poses = [_placed(draw, _any(draw).matrix)]
    for _ in range(2):
        turn = turns.about(draw.direction(3), step, step)
        poses.append(poses[-1] @ homogeneous((1 + step) * turn.matrix, step * draw.direction(3)))
    return _of(np.stack(poses), step)


def _near_identity(draw: Draw) -> Journey:
    size = draw.exponent(-15, -1)
    rotations = [turns.about(draw.direction(3), size * draw.uniform(0.0, 1.0), size) for _ in range(3)]
    poses = [homogeneous((1 + signed(draw, -16, -1)) * turn.matrix, vector(draw)) for turn in rotations]
    return _of(np.stack(poses), size)


def _equal(draw: Draw) -> Journey:
    """Two poses, the same one or in turns."""
    rotations = [draw.choice((_any, _none))(draw) for _ in range(2)]
    poses = np.stack([_placed(draw, turn.matrix) for turn in rotations])
    return _of(poses[list(draw.choice(((0, 0, 1), (0, 1, 1), (0, 0, 0), (0, 1, 0))))], 1.0)


def _large_scales(draw: Draw) -> Journey:
    # V^-1 may divide by one scale and V multiply with another, and a spline overshoots: 1e100 is met on the way.
    size = draw.exponent(1, 30)
    scales = [size ** draw.uniform(-1.0, 1.0) for _ in range(3)]
    return _of(np.stack([homogeneous(s * _any(draw).matrix, vector(draw, -30, 30)) for s in scales]), size)


def _off_manifold(draw: Draw) -> Journey:
    # A similarity may be off by 1e-6 in the Frobenius norm of its rotation's Gram matrix, about twice the noise.
    noise = draw.exponent(-16, -7)
    poses = np.stack([_placed(draw, _any(draw).matrix) for _ in range(3)])
    poses[:, :3, :3] += noise * np.stack([draw.direction(9).reshape(3, 3) / 2 for _ in range(3)])
    return _of(poses, noise)


def _outside(draw: Draw) -> Journey:
    """One of the poses stretched, reflected or projective."""
    journey = _generic(3)(draw)
    error = draw.exponent(-5, 1)
    pose = journey.poses[draw.choice(range(3))]
    kind = draw.choice(("stretched", "reflected", "projective"))
    if kind == "projective":
        pose[3, draw.choice(range(3))] += error
    else:
        pose[:3, draw.choice(range(3))] *= 1 + error if kind == "stretched" else -1.0
    return _of(journey.poses, error)


GENERIC = Journeys("generic", "largest angle", _generic(4), share=0.3)
THROUGH_PI = Journeys("through-pi", "distance of the axes", _through_pi, share=0.3)

CROSSINGS = (
    GENERIC,
    THROUGH_PI,
    Journeys("round-and-round", "distance of the axes", _round_and_round, share=0.05),
    Journeys("near-pi", "|pi - angle|", _near_pi),
    Journeys("near-2pi", "2 pi - angle", _near_two_pi),
    Journeys("half-turns", "none", _half_turns),
    Journeys("off-manifold", "distance from the similarities", _off_manifold),
)
"""Poses between which the rotation may pass through pi."""

JOURNEYS = (
    *CROSSINGS,
    Journeys("two-keys", "largest angle", _generic(2)),
    Journeys("close-keys", "size of the steps", _close),
    Journeys("near-identity", "largest angle", _near_identity),
    Journeys("equal-keys", "none", _equal),
    Journeys("large-scales", "scale", _large_scales),
)

OUTSIDE = Journeys("outside", "stretch, or error of the last row", _outside)
