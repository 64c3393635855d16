"""The columns of the law matrix: laws that a morph may keep, as residuals of it between pairs of poses.

A residual is relative: rounding leaves some 1e-13 of it, a broken law much more than 1e-6 on simple poses. The very
same functions serve a subject in float64, on batches, and the reference in mpmath's numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce
from itertools import pairwise

import numpy as np

from affinecert.properties.matrix import domains
from affinecert.properties.matrix.algebra import (
    Mask,
    Poses,
    determinant,
    distance,
    inverse,
    linear,
    size,
    unlike_rotation,
)
from affinecert.properties.matrix.domains import REORDERINGS
from affinecert.properties.matrix.motion import Motion

Premise = Callable[[Poses, Poses], Mask]

EIGHTHS = tuple(k / 8 for k in range(9))
BEYOND = tuple(k / 2 for k in range(-4, 7))
INSIDE, ONCE = (0.25, 0.5), 0.25

UNIT = 2.0**-53


@dataclass(frozen=True)
class MorphLaw:
    """A law of morphs: its name, the head of its column, what it says, and where that comes from.

    ``residual`` gives a number for each pair. ``premise`` says of which pairs the law speaks. ``astride`` marks the law
    of continuity, which is tried on pairs of pairs about the places where branches change.
    """

    name: str
    head: str
    statement: str
    source: str
    residual: Callable[[Motion], Poses]
    premise: Premise = domains.ALL.holds
    astride: bool = False


def _worst(residuals: list[Poses]) -> Poses:
    """The largest residual of each pair."""
    return reduce(np.maximum, residuals)


def _endpoints(motion: Motion) -> Poses:
    return np.maximum(distance(motion.at(0.0), motion.start), distance(motion.at(1.0), motion.end))


def _steady(motion: Motion) -> Poses:
    return _differ([motion.at(t + 0.25) @ inverse(motion.at(t)) for t in (0.0, 0.25, 0.75)])


def _local(motion: Motion) -> Poses:
    return _differ([inverse(motion.at(t)) @ motion.at(t + 0.25) for t in (0.0, 0.25, 0.75)])


def _differ(steps: list[Poses]) -> Poses:
    first, *others = steps
    return _worst([distance(first, other) for other in others])


def _equal_volumes(start: Poses, end: Poses) -> Mask:
    return np.asarray(np.abs(determinant(end) / determinant(start) - 1) < domains.ROUNDING)


def _volume_kept(motion: Motion) -> Poses:
    volume = determinant(motion.start)
    return _worst([abs(determinant(motion.at(t)) / volume - 1) for t in (*INSIDE, 0.75)])


def _volume_monotone(motion: Motion) -> Poses:
    volumes = [determinant(motion.at(t)) for t in EIGHTHS]
    rises = [after - before for before, after in pairwise(volumes)]
    up, down = _worst(rises), _worst([-rise for rise in rises])
    largest = _worst([abs(volume) for volume in volumes])
    return np.asarray(np.maximum(np.minimum(up, down), 0 * up) / largest)


def _moved(motion: Motion, t: float) -> Poses:
    """The linear part of M_t B^-1."""
    return linear(motion.at(t)) @ linear(inverse(motion.start))


def _isometry_kept(motion: Motion) -> Poses:
    return _worst([unlike_rotation(_moved(motion, t)) for t in INSIDE])


def _similarity_kept(motion: Motion) -> Poses:
    return _worst([unlike_rotation(_moved(motion, t), scaled=True) for t in INSIDE])


def _reversible(motion: Motion) -> Poses:
    return distance(motion.at(ONCE), motion.between(motion.end, motion.start).at(1 - ONCE))


def _posed(size_: int, shift: float, *turns: tuple[int, int, float, float]) -> Poses:
    """Turns in coordinate planes (i, j, cosine, sine), one after the other, then a translation."""
    matrix = np.eye(size_ + 1)
    for i, j, cosine, sine in turns:
        turn = np.eye(size_ + 1)
        turn[i, i] = turn[j, j] = cosine
        turn[j, i], turn[i, j] = sine, -sine
        matrix = turn @ matrix
    matrix[:-1, -1] = [shift * (-1) ** k for k in range(size_)]
    return matrix


Group = Mapping[int, tuple[Poses, ...]]
"""Maps that a law is tried with, in the plane (2) and in space (3)."""

LEFT: Group = {
    2: (_posed(2, 1.0, (0, 1, 0.0, 1.0)), _posed(2, 1.0, (0, 1, 0.8, 0.6))),
    3: (_posed(3, 1.0, (1, 2, 0.0, 1.0)), _posed(3, 1.0, (0, 1, 0.8, 0.6), (1, 2, 0.8, 0.6))),
}
"""Rigid motions G: a quarter turn, and turns by arctan 3/4, each with a translation."""

RIGHT: Group = {
    2: (_posed(2, 0.5, (1, 0, 0.0, 1.0)), _posed(2, 0.5, (1, 0, 0.8, 0.6))),
    3: (_posed(3, 0.5, (2, 0, 0.0, 1.0)), _posed(3, 0.5, (2, 0, 0.8, 0.6), (0, 1, 0.8, 0.6))),
}
"""Rigid motions H, likewise."""

AFFINE: Group = {
    2: (np.array([[2.0, 1.0, 1.0], [1.0, 1.0, -1.0], [0.0, 0.0, 1.0]]),),
    3: (np.array([[2.0, 1.0, 0.0, 1.0], [1.0, 1.0, 1.0, -1.0], [0.0, -1.0, 1.0, 2.0], [0.0, 0.0, 0.0, 1.0]]),),
}
"""Affine maps G; of determinant 1 and 3."""


def _whole(matrix: Poses) -> bool:
    """Whether products of a matrix with simple poses are exact."""
    return bool((matrix * 2 == np.round(matrix * 2)).all())


def _carried(maps: Group, *, left: bool) -> Callable[[Motion], Poses]:
    """Whether a morph commutes with maps from the left or from the right, at one time.

    A map whose product with a pose is rounded may carry a turn by pi to the other side of pi: such pairs it is spared.
    """

    def residual(motion: Motion) -> Poses:
        def misfit(g: Poses) -> Poses:
            def carry(pose: Poses) -> Poses:
                return g @ pose if left else pose @ g

            other = motion.between(carry(motion.start), carry(motion.end))
            found = distance(other.at(ONCE), carry(motion.at(ONCE)))
            return found if _whole(g) else np.where(motion.clear, found, 0 * found)

        return _worst([misfit(g) for g in maps[motion.start.shape[-1] - 1]])

    return residual


def _vanishing(times: tuple[float, ...]) -> Callable[[Motion], Poses]:
    """Rounding over the least volume, relative to the smaller of the ends': as good as infinite where it vanishes."""

    def residual(motion: Motion) -> Poses:
        least = reduce(np.minimum, [_volume(motion.at(t)) for t in times])
        relative = least / np.minimum(determinant(motion.start), determinant(motion.end))
        return UNIT / np.maximum(relative, VANISHED)

    return residual


VANISHED = 2.0**-900
"""What stands for no volume: its residual, 2^847, is a number in every arithmetic."""


def _volume(pose: Poses) -> Poses:
    """The volumes; not a number where it is not 0, but so small next to the pose that rounding may have made it."""
    volume = determinant(pose)
    vague = (abs(volume) < domains.ROUNDING * size(linear(pose)) ** (pose.shape[-1] - 1)) & (volume != 0)
    return np.where(vague, np.nan, volume)


def _exists(motion: Motion) -> Poses:
    return np.where(np.isnan(motion.at(0.5).astype(np.float64)).any(axis=(-2, -1)), 1.0, 0.0)


def _continuous(motion: Motion) -> Poses:
    assert motion.beside is not None
    return distance(motion.at(ONCE), motion.beside.at(ONCE))


def _acceleration(motion: Motion) -> Poses:
    """The average relative acceleration over the vertices of the simplex, of four steps, relative to the velocities."""
    corners = np.concatenate([np.zeros((motion.start.shape[-1] - 1, 1)), np.eye(motion.start.shape[-1] - 1)], axis=1)
    points = np.concatenate([corners, np.ones((1, corners.shape[1]))])
    moved = [(inverse(motion.at(t)) @ motion.at(t + 0.25) @ points - points) * 4 for t in (0.0, 0.25, 0.5, 0.75)]
    changes = [
        size((after - before)[..., :, k : k + 1]) * 4 for before, after in pairwise(moved) for k in range(len(points))
    ]
    speed = _worst([size(velocity) for velocity in moved])
    return np.asarray(sum(changes[1:], changes[0]) / len(changes) / (1 + speed))


ROSSIGNAC, BANSAL = "rossignac_vinacua", "bansal_tatu"

EXISTS = MorphLaw("exists", "exists", "M(t) exists", f"{ROSSIGNAC}, section 5; {BANSAL}, section 4", _exists)

STEADINESS = MorphLaw(
    "ARA = 0",
    "ARA",
    "the average relative acceleration vanishes",
    f"{ROSSIGNAC}, sections 1 and 2.4",
    _acceleration,
)
"""Its cell tells the value between standard poses as well."""

LAWS = (
    MorphLaw("endpoints", "ends", "M(0) = B and M(1) = C", f"{ROSSIGNAC}, section 2.2", _endpoints),
    MorphLaw(
        "steady",
        "steady",
        "M(s + h) M(s)^-1 does not depend on s: M(t) = A^t B",
        f"{ROSSIGNAC}, equation 1",
        _steady,
    ),
    MorphLaw(
        "constant local velocity",
        "local v.",
        "M(s)^-1 M(s + h) does not depend on s",
        f"{ROSSIGNAC}, sections 2.3 (6) and 6.1",
        _local,
    ),
    MorphLaw(
        "volume kept",
        "vol kept",
        "if det B = det C, then det M(t) is the same",
        f"{ROSSIGNAC}, section 2.3 (4); {BANSAL}, Lemma 2",
        _volume_kept,
        _equal_volumes,
    ),
    MorphLaw(
        "volume monotone",
        "vol mono",
        "det M(t) only grows or only falls for t in [0, 1]",
        f"{ROSSIGNAC}, sections 2.3 (4) and 6.4; {BANSAL}, Lemma 3",
        _volume_monotone,
    ),
    MorphLaw(
        "isometry kept",
        "isometry",
        "if C B^-1 is rigid, so is M(t) B^-1",
        f"{ROSSIGNAC}, section 2.3 (5); {BANSAL}, Lemma 4",
        _isometry_kept,
        domains.RIGID.holds,
    ),
    MorphLaw(
        "similarity kept",
        "shape",
        "if C B^-1 is a similarity, so is M(t) B^-1",
        f"{ROSSIGNAC}, section 6.3",
        _similarity_kept,
        domains.SIMILAR.holds,
    ),
    MorphLaw(
        "reversible",
        "reverse",
        "the morph from C to B at 1 - t is that from B to C at t",
        f"{ROSSIGNAC}, section 2.3 (3); {BANSAL}, Lemma 5",
        _reversible,
    ),
    MorphLaw(
        "left invariant",
        "left",
        "M(G B, G C) = G M(B, C) for a rigid G",
        f"{ROSSIGNAC}, section 2.3 (2)",
        _carried(LEFT, left=True),
    ),
    MorphLaw(
        "right invariant",
        "right",
        "M(B H, C H) = M(B, C) H for a rigid H",
        f"{ROSSIGNAC}, section 2.2",
        _carried(RIGHT, left=False),
    ),
    MorphLaw(
        "affine invariant",
        "affine",
        "M(G B, G C) = G M(B, C) for an affine G",
        f"{ROSSIGNAC}, section 2.3 (2)",
        _carried(AFFINE, left=True),
    ),
    MorphLaw(
        "re-ordering invariant",
        "reorder",
        "M(B H, C H) = M(B, C) H for an even re-ordering H of the vertices of the simplex 0, e_1, ..., e_n",
        f"{BANSAL}, section 5.2",
        _carried(REORDERINGS, left=False),
    ),
    MorphLaw(
        "never degenerate in [0, 1]",
        "det>0",
        "det M(t) > 0 for t in [0, 1]",
        f"{ROSSIGNAC}, section 3.3.2",
        _vanishing(EIGHTHS),
    ),
    MorphLaw(
        "never degenerate in [-2, 3]",
        "beyond",
        "det M(t) > 0 for t in [-2, 3]",
        f"{BANSAL}, section 6.2",
        _vanishing(BEYOND),
    ),
    EXISTS,
    MorphLaw(
        "continuous",
        "contin.",
        "poses next to B and C, at 1e-12, have morphs next to M(t)",
        f"{ROSSIGNAC}, section 2.3 and figure 3",
        _continuous,
        astride=True,
    ),
    STEADINESS,
)
