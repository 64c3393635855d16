"""Section 5.3: what to do where there is no steady morph: a pose between, or samples of an unsteady morph."""

from __future__ import annotations

from functools import partial
from itertools import pairwise
from typing import Any

from affinecert.errors import InputError
from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import plane_rotation
from affinecert.properties.claims.precision import difference, distance, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.listings import (
    Motion,
    Poses,
    jump,
    local_velocity,
    ordinary_poses,
    regular_poses,
    steady,
)
from affinecert.properties.claims.rossignac_vinacua.reduction import exists
from affinecert.reference import morphs, sam, so3
from affinecert.reference._matrices import Array, Number, homogeneous, identity, scalar

HALF = mp.mpf(1) / 2


def _half_rotation(half: Array, stretch: Array) -> Array:
    """The pose between: half the rotation."""
    return half


def _half_stretch(half: Array, stretch: Array) -> Array:
    """Half of the way to the stretch, and no rotation."""
    mean: Array = (identity(mp, len(stretch)) + stretch) / 2
    return mean


def _bad_maps() -> list[tuple[Array, Array]]:
    """Half the rotation, and the stretch, of maps that have no real logarithm."""
    quarter = exactly([[0, -1], [1, 0]])
    plane = [[[1, 0], [0, 2]], [[2, 1], [1, 3]], [[1, 0], [0, 64]]]
    near = [(plane_rotation(mp.mpf(angle)), exactly([[9, 1], [1, 1]])) for angle in ("1.4", "-1.3")]
    axis = exactly([0.6, 0, 0.8])
    turn = so3.exp(mp, axis * mp.mpf("1.5"))
    return [*((quarter, exactly(each)) for each in plane), *near, (turn, exactly([[1, 0, 0], [0, 9, 1], [0, 1, 4]]))]


def _still_bad(between: Any, case: tuple[Array, Array]) -> int:
    """Whether a map has no real logarithm, and one of the two parts that a pose between makes of it has none either."""
    half, stretch = case
    whole = half @ half @ stretch
    if exists(whole):
        raise ValueError(f"{whole} has a real logarithm")
    pose = between(half, stretch)
    return int(not (exists(pose) and exists(whole @ definitions.inverse(mp, pose))))


def _poly_steady(poses: Poses, t: Number) -> Array:
    """The morph from F_A to F_B, and then that from F_B to F_C."""
    first, middle, last = poses
    return steady(first, 2 * t, middle) if t <= HALF else steady(middle, 2 * t - 1, last)


def _carried_steady(poses: Poses, t: Number) -> Array:
    """The second span started from F_A, and ended at F_C, in twice the time."""
    first, middle, last = poses
    return steady(first, 2 * t, middle) if t <= HALF else steady(first, t, last)


def _broken(motion: Any, poses: Poses) -> Number:
    """How far a motion is from the three poses, and from itself a little later than F_B."""
    try:
        missed = max(distance(motion(poses, k * HALF), poses[k]) for k in range(3))
        later = motion(poses, HALF + mp.mpf(10) ** -60)
    except InputError:  # no such morph
        return mp.inf
    return max(missed, distance(later, poses[1]))


def _without_jump(poses: Poses, _: None) -> int:
    return int(jump(lambda t: _poly_steady(poses, t), HALF) < mp.mpf(1) / 100)


def _whole(rows: Any) -> Array:
    return homogeneous(mp, exactly(rows), exactly([3, 1]))


def _bad_poses() -> list[Array]:
    return [_whole(each) for each in ([[-1, 0], [0, -2]], [[-1, 1], [0, -1]], [[-3, 0], [0, -0.5]])]


def _turned_one_way() -> list[Array]:
    return [_whole(each) for each in ([[-1, 0], [0, -2]], [[-1, -0.125], [0.25, -2]], [[-2, 0.25], [-0.125, -1]])]


def _turned_both_ways() -> list[Array]:
    return [_whole(each) for each in ([[-1, 1], [0, -1]], [[-3, 0], [0, -0.5]], [[-1, 0.25], [0, -2]])]


def _morphed(name: str, end: Array, t: Number) -> Array:
    return morphs.MORPHS[name](mp, identity(mp, len(end)), end, scalar(mp.mpf(t)))


def _unsteady(*names: str) -> Any:
    """The motions from the identity to a pose by these morphs, each () -> (3, 3)."""

    def motions(end: Array) -> list[Motion]:
        return [partial(_morphed, name, end) for name in names]

    return motions


def _samples(motion: Motion, count: int) -> list[Array]:
    return [motion(mp.mpf(k) / count) for k in range(count + 1)]


def _collapses(motions: Any, end: Array) -> int:
    """Whether there is a steady morph from the identity to a pose, or none between one in 16 samples and the next."""
    if exists(end[:-1, :-1]):
        raise ValueError(f"{end} has a real logarithm")
    for motion in motions(end):
        poses = _samples(motion, 16)
        if any(definitions.determinant(pose[:-1, :-1]) <= 0 for pose in poses):
            return 1
        if not all(exists(_ratio(one, other)[:-1, :-1]) for one, other in pairwise(poses)):
            return 1
    return 0


def _ratio(one: Array, other: Array) -> Array:
    ratio: Array = other @ definitions.inverse(mp, one)
    return ratio


def _kinked(end: Array) -> list[Motion]:
    """Two steady morphs by way of a quarter turn, which is shifted."""
    middle = exactly([[0, -1, 1], [1, 0, 1], [0, 0, 1]])
    poses = identity(mp, 3), middle, end
    return [lambda t: _poly_steady(poses, t)]


def _jumps(motions: Any, end: Array) -> Number:
    return max(jump(motion, mp.mpf(k) / 4) for motion in motions(end) for k in (1, 2, 3))


def _regular(end: Array) -> list[Motion]:
    """A steady motion, wherever it leads."""
    return [lambda t: sam.power(mp, regular_poses()[1], scalar(t))]


def _steady_motion(motions: Any, end: Array) -> int:
    """Whether the velocity of one of the motions in the moving frame is the same at 1/4 and 3/4."""
    quarters = ([local_velocity(motion, mp.mpf(k) / 4) for k in (1, 3)] for motion in motions(end))
    return int(any(difference(one, other) < mp.mpf(10) ** -9 for one, other in quarters))


def _largest_jumps(motion: Motion) -> list[Number]:
    """The largest jump of the velocity field of the steady morphs between 4, 8, 16 and 32 spans' samples."""
    found = []
    for count in (4, 8, 16, 32):
        fields = [sam.log(mp, _ratio(*pair)) * count for pair in pairwise(_samples(motion, count))]
        found.append(max(size(other - one) for one, other in pairwise(fields)))
    return found


def _not_decreasing(motions: Any, end: Array) -> int:
    return int(
        any(later >= 3 * earlier / 4 for motion in motions(end) for earlier, later in pairwise(_largest_jumps(motion)))
    )


def _table() -> dict[str, Any]:
    """Of the first bad pose."""
    names = ("rarap", "asap", "three_spiral")
    motions = zip(names, _unsteady(*names)(_bad_poses()[0]), strict=True)
    return {f"jumps of {name} with 4, 8, 16, 32 spans": _largest_jumps(motion) for name, motion in motions}


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.5.3.pose_between",
        place="section 5.3",
        statement="Where there is no steady morph from F_A to F_C, a pose F_B can be inserted so that there are two: "
        "half the rotation of F_C F_A⁻¹ always will do.",
        verdict=Verdict.CONFIRMED,
        form=_half_rotation,
        cases=_bad_maps,
        deviation=_still_bad,
        copies=(Copy("half the stretch", _half_stretch),),
        remark="The paper leaves F_B to the designer. If R S is the polar decomposition, R^½ turns by 90 degrees at "
        "most, and R^½ S has no negative eigenvalue, for x·Rx >= 0.",
    ),
    Claim(
        id="rossignac_vinacua.5.3.poly_steady",
        place="section 5.3",
        statement="The steady morphs from F_A to F_B and from F_B to F_C, one after the other, are a continuous motion "
        "through the three poses, also where F_A and F_C have none.",
        verdict=Verdict.CONFIRMED,
        form=_poly_steady,
        cases=ordinary_poses,
        deviation=_broken,
        copies=(Copy("the morph from F_A to F_C for the second one", _carried_steady),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.poly_steady_velocity",
        place="section 5.3 and figure 7 (b)",
        statement="The velocity of such a motion jumps at F_B, typically.",
        verdict=Verdict.CONFIRMED,
        form=ordinary_poses()[0],
        cases=lambda: [None],
        deviation=_without_jump,
        copies=(Copy("three poses of one steady motion", regular_poses()),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.polar_morphs",
        place="section 5.3",
        statement="In the plane rARAP and ASAP give poses to be inserted where there is no steady morph: there are "
        "steady morphs between uniform samples.",
        verdict=Verdict.CONFIRMED,
        form=_unsteady("rarap", "asap"),
        cases=_bad_poses,
        deviation=_collapses,
        copies=(Copy("the linear morph", _unsteady("linear")),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.three_spirals",
        place="section 5.3",
        statement="In the plane the TSB (three spirals) gives poses to be inserted where there is no steady morph.",
        verdict=Verdict.BOUND,
        domain="the three sides of the triangle are turned the same way. A map without a logarithm turns vectors by "
        "nearly 180 degrees, some this way and some that way: if it does so to sides, the triangle is turned inside "
        "out on the way, by [[-1, 1], [0, -1]] for one",
        form=_unsteady("three_spiral"),
        cases=_turned_one_way,
        outside=_turned_both_ways,
        deviation=_collapses,
        copies=(Copy("the linear morph", _unsteady("linear")),),
        remark="It depends on the triangle too; use rARAP or ASAP.",
    ),
    Claim(
        id="rossignac_vinacua.5.3.unsteady_smooth",
        place="section 5.3",
        statement="rARAP, ASAP and TSB are smooth.",
        verdict=Verdict.CONFIRMED,
        form=_unsteady("rarap", "asap", "three_spiral"),
        cases=_bad_poses,
        deviation=_jumps,
        copies=(Copy("two steady morphs", _kinked),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.unsteady",
        place="section 5.3",
        statement="rARAP, ASAP and TSB are not steady.",
        verdict=Verdict.CONFIRMED,
        form=_unsteady("rarap", "asap", "three_spiral"),
        cases=_bad_poses,
        deviation=_steady_motion,
        copies=(Copy("a power of a map", _regular),),
    ),
    Claim(
        id="rossignac_vinacua.5.3.samples",
        place="section 5.3",
        statement="The discontinuities of velocity at the samples of an unsteady morph, joined by steady ones, "
        "decrease as the number of samples grows.",
        verdict=Verdict.CONFIRMED,
        form=_unsteady("rarap", "asap"),
        cases=_bad_poses,
        deviation=_not_decreasing,
        copies=(Copy("two steady morphs, whose kink remains", _kinked),),
        numbers=_table,
        remark="They halve as the number doubles.",
    ),
    Claim(
        id="rossignac_vinacua.5.3.figure_7",
        place="figure 7",
        statement="The initial configuration of figure 7 has no steady morph, and its bi-arc passes through F_B.",
        verdict=Verdict.UNCHECKABLE,
        reason="The poses are given as a picture only; rossignac_vinacua.5.3.biarc_interpolates and others check what "
        "it shows on poses of our own.",
    ),
)
