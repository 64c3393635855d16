"""Sections 6.3.1 and 6.3.2: A^t is an isometry, or a similarity, if A is."""

from __future__ import annotations

from typing import Any

from affinecert.errors import InputError
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine, plane_rotation, rotations
from affinecert.properties.claims.precision import difference, exactly, mp
from affinecert.properties.claims.rossignac_vinacua.listings import power
from affinecert.properties.claims.rossignac_vinacua.motions_from_identity import TIMES, by, steady_motion
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Number, cross, homogeneous, identity


def _isometries() -> list[Array]:
    """Of the plane and of space: identity, translations, rotations, screws, half turns."""
    plane = [plane_rotation(mp.mpf(angle)) for angle in (1, -3)]
    space = [exactly([[0, 0, 1], [1, 0, 0], [0, 1, 0]]), *rotations("isometries", 3)]
    return [
        affine([[1, 0], [0, 1]], [0, 0]),
        affine([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [1, 2, 3]),
        affine([[-1, 0], [0, -1]], [3, 1]),
        affine([[-1, 0, 0], [0, -1, 0], [0, 0, 1]], [1, 1, 2]),
        *(homogeneous(mp, turn, exactly([2, -1])) for turn in plane),
        *(homogeneous(mp, turn, exactly([2, -1, 1])) for turn in space),
    ]


def _similarities() -> list[Array]:
    scales = [mp.mpf(each) for each in ("2", "0.5", "3", "1.25", "0.125", "4", "1.5", "0.75", "2", "0.25")]
    return [
        homogeneous(mp, scale * each[:-1, :-1], each[:-1, -1])
        for scale, each in zip(scales, _isometries(), strict=True)
    ]


def _gram(pose: Array) -> Array:
    gram: Array = pose[:-1, :-1].T @ pose[:-1, :-1]
    return gram


def _not_isometric(make: Any, end: Array) -> Number:
    motion = make(end)
    return max(difference(_gram(motion(t)), identity(mp, len(end) - 1)) for t in TIMES)


def _not_similar(make: Any, end: Array) -> Number:
    """How far L^T L is from a multiple of 1, relative to it."""
    motion = make(end)
    grams = [_gram(motion(t)) for t in TIMES]
    return max(difference(gram / gram[0, 0], identity(mp, len(gram))) for gram in grams)


def _screw(sign: int = 1) -> Any:
    """A point q of the axis and the shift d along it, from the angular velocity w and v: w x v / w², w (w.v) / w²."""

    def axis(w: Array, v: Array) -> tuple[Array, Array]:
        square = w @ w
        if not square:
            return v * mp.zero, v
        return sign * cross(w, v) / square, w * (w @ v) / square

    return axis


def _in_space(end: Array) -> Array:
    """The plane as the x-y plane of space."""
    if len(end) == 4:
        return end
    whole = identity(mp, 4)
    whole[:2, :2], whole[:2, 3] = end[:2, :2], end[:2, 2]
    return whole


def _no_screw(axis: Any, end: Array) -> Number:
    """How far A^t is from: rotation L^t about an axis that L fixes, and a shift t d along it."""
    end = _in_space(end)
    generator = sam.log(mp, end)
    w = exactly([generator[2, 1], generator[0, 2], generator[1, 0]])
    q, d = axis(w, generator[:-1, -1])
    gaps = [difference(end[:-1, :-1] @ d, d)]
    for t in TIMES:
        pose = power(end, t)
        about_the_axis = q + t * d - pose[:-1, :-1] @ q
        gaps.append(difference(pose[:-1, -1], about_the_axis))
    return max(gaps)


def _angle(exponent: int = 1) -> Any:
    def angle(whole: Number, t: Number) -> Number:
        return t**exponent * whole

    return angle


def _not_that_fast(angle: Any, end: Array) -> Number:
    """How far cosines of the angles of A^t are from those stated, the angle of A being in [0, pi]."""
    end = _in_space(end)

    def cosine(t: Number) -> Number:
        return (power(end, t)[:-1, :-1].trace() - 1) / 2

    whole = mp.acos(max(min(cosine(mp.one), mp.one), -mp.one))
    return max(abs(mp.cos(angle(whole, t)) - cosine(t)) for t in TIMES)


def _composition(centred: bool = True, constant_scaling: bool = False) -> Any:
    """R(t a) s^t about the fixed point; or about the origin, with a translation at constant speed."""

    def motion(end: Array, t: Number) -> Array:
        scale = mp.sqrt(_gram(end)[0, 0])
        rotation = power(homogeneous(mp, end[:-1, :-1] / scale, end[:-1, -1] * 0), t)[:-1, :-1]
        linear = rotation * ((1 + t * (scale - 1)) if constant_scaling else scale**t)
        if not centred:
            return homogeneous(mp, linear, t * end[:-1, -1])
        centre = sam.fixed_point(mp, end)
        return homogeneous(mp, linear, centre - linear @ centre)

    return motion


def _not_that_motion(motion: Any, end: Array) -> Number:
    try:
        return max(difference(motion(end, t), power(end, t)) for t in TIMES)
    except InputError:
        return mp.inf


def _scaled_similarities() -> list[Array]:
    """Those whose scale is not 1, so that they have a fixed point."""
    return _similarities()[2:]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.6.3.1.isometries",
        place="section 6.3.1",
        statement="If A is an isometry, so is A^t for all t.",
        verdict=Verdict.CONFIRMED,
        form=steady_motion,
        cases=_isometries,
        deviation=_not_isometric,
        copies=(Copy("the linear morph", by("linear")),),
        remark="At a half turn only with the skew logarithm; with others (rossignac_vinacua.6.1.half_turn) the way is "
        "along ellipses.",
    ),
    Claim(
        id="rossignac_vinacua.6.3.1.screws",
        place="section 6.3.1",
        statement="The steady motion of an isometry is the identity, a translation, or a rotation about an axis (in "
        "the plane, a point) with a translation along it at constant speed.",
        verdict=Verdict.CONFIRMED,
        form=_screw(),
        cases=_isometries,
        deviation=_no_screw,
        copies=(Copy("v × w for w × v", _screw(-1)),),
    ),
    Claim(
        id="rossignac_vinacua.6.3.1.constant_speed",
        place="section 6.3.1",
        statement="It rotates at constant speed: by t θ at the time t.",
        verdict=Verdict.CONFIRMED,
        form=_angle(),
        cases=_isometries,
        deviation=_not_that_fast,
        copies=(Copy("t² θ", _angle(2)),),
    ),
    Claim(
        id="rossignac_vinacua.6.3.2.similarities",
        place="section 6.3.2",
        statement="If A is a similarity, so is A^t for all t.",
        verdict=Verdict.CONFIRMED,
        form=steady_motion,
        cases=_similarities,
        deviation=_not_similar,
        copies=(Copy("the linear morph, in space", by("linear")),),
    ),
    Claim(
        id="rossignac_vinacua.6.3.2.composition",
        place="section 6.3.2",
        statement="The steady motion of a similarity of scale s ≠ 1 is a rotation at constant speed and the scaling "
        "s^t, both about its fixed point.",
        verdict=Verdict.CONFIRMED,
        form=_composition(),
        cases=_scaled_similarities,
        deviation=_not_that_motion,
        copies=(
            Copy("about the origin, with a translation at constant speed", _composition(centred=False)),
            Copy("the scaling 1 + t (s - 1)", _composition(constant_scaling=True)),
        ),
        remark="The text names a translation at constant speed as a third part. About the fixed point there is none, "
        "about other origins it has no constant speed.",
    ),
)
