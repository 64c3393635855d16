"""Appendix A.1.6: the proof of Lemma 4, that an isometry is interpolated by isometries."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.bansal_tatu.appendix_cases import TIMES, components, composed, shear
from affinecert.properties.claims.bansal_tatu.steadiness_proof import interpolated
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import arrays
from affinecert.properties.claims.precision import distance, exactly, mp
from affinecert.reference import affine_lie, so3
from affinecert.reference._groups import RIGID
from affinecert.reference._matrices import Array, Number, array, homogeneous, identity, norm

Points = tuple[Array, Array, Array]


def _motions() -> list[Array]:
    """A translation, a quarter turn about an axis that moves along it, and seeded rigid motions."""
    shift = homogeneous(mp, identity(mp, 3), exactly([1, 0, 0]))
    return [shift, *(e for e, _, _ in components("isometries", 9)[2:])]


def _times_scale(motion: Array) -> Array:
    return composed(mp, motion, identity(mp, 3), mp.mpf(17) / 16)


def _times_shear(motion: Array) -> Array:
    return composed(mp, motion, shear(mp, *exactly([0, 1, 0, 0.0625, 1])), mp.one)


def _not_rigid(change: Callable[[Array], Array], case: tuple[Array]) -> Number:
    """How far A and s are from trivial, and E from T."""
    motion = change(case[0])
    e, a, s = affine_lie.decompose(mp, motion)
    return distance((e, a, s[()]), (motion, identity(mp, 3), mp.one))


def _morph(motion: Array, t: Number) -> Array:
    return interpolated((motion, identity(mp, 3), mp.one), t)


def _linear(motion: Array, t: Number) -> Array:
    mixed: Array = identity(mp, 4) * (1 - t) + motion * t
    return mixed


def _stretched(form: Any, case: tuple[Array]) -> Number:
    """How far the linear parts are from rotations."""
    return max(distance(q @ q.T, identity(mp, 3)) for q in (form(*case, t)[:3, :3] for t in TIMES))


def _by_power(factor: Any) -> Any:
    """The linear part of T^t as the power of R by that many times its rotation vector."""
    return lambda motion, t: so3.exp(mp, so3.log(mp, motion[:3, :3]) * factor(t))


def _not_power(form: Any, case: tuple[Array]) -> Number:
    def whole(t: Number) -> Array:
        part: Array = RIGID.exp(mp, RIGID.log(mp, case[0]) * t)[:3, :3]
        return part

    return max(distance(form(case[0], t), whole(t)) for t in TIMES)


def _points() -> list[Points]:
    """T^t and two points: a translation and the origin twice first."""
    origin = exactly([0, 0, 0])
    drawn = arrays("points", 6, (2, 3), -2, 2)
    simple = (_motions()[0], origin, origin)
    return [simple, *((_morph(e, mp.one / 3), x, y) for e, (x, y) in zip(_motions()[1:7], drawn, strict=True))]


def _image(affine: Array, point: Array) -> Array:
    """T x, T as a map of space."""
    image: Array = (affine @ array([*point, mp.one]))[:3]
    return image


def _of_images(sign: int = -1, *, both: bool = True) -> Any:
    return lambda affine, x, y: _image(affine, x) + sign * (_image(affine, y) if both else y)


def _wrong_length(form: Any, case: Points) -> Number:
    affine, x, y = case
    return distance(norm(mp, form(affine, x, y)), norm(mp, x - y))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.A.1.6.rigid",
        place="appendix A.1.6",
        statement="An isometry that keeps the orientation has the components A = I and s = 1, and is E.",
        printed="T = E ∈ SE(3)",
        verdict=Verdict.CONFIRMED,
        form=lambda motion: motion,
        cases=lambda: [(motion,) for motion in _motions()],
        deviation=_not_rigid,
        copies=(
            Copy("T is scaled by 17/16 besides", _times_scale),
            Copy("T is sheared by α4 = 1/16 besides", _times_shear),
        ),
    ),
    Claim(
        id="bansal_tatu.A.1.6.power",
        place="appendix A.1.6",
        statement="The rotation of E^t is R^t.",
        verdict=Verdict.CONFIRMED,
        form=_by_power(lambda t: t),
        cases=lambda: [(motion,) for motion in _motions()],
        deviation=_not_power,
        copies=(Copy("t² for t", _by_power(lambda t: t * t)),),
        remark="d^t is a name only: the translation of E^t is V(t ω) V(ω)⁻¹ d times t, and t d only for R = I.",
    ),
    Claim(
        id="bansal_tatu.A.1.6.lengths",
        place="appendix A.1.6; Lemma 4",
        statement="An isometry T^t of space keeps the length of T^t (x - y), for points x and y.",
        printed="|T^t (x - y)| = |R^t (x - y)| = |x - y|",
        verdict=Verdict.REFUTED,
        fault=Fault.SLIP,
        form=lambda affine, x, y: _image(affine, x - y),
        cases=_points,
        deviation=_wrong_length,
        correction=Correction(
            statement="|T^t x - T^t y| = |R^t (x - y)| = |x - y|",
            form=_of_images(),
        ),
        copies=(Copy("T^t x + T^t y", _of_images(1)), Copy("T^t x - y", _of_images(both=False))),
        remark="As printed it is right only if T^t acts on x - y as on a difference, without its translation.",
    ),
    Claim(
        id="bansal_tatu.A.1.6.isometry",
        place="appendix A.1.6; Lemma 4",
        statement="If T is an isometry, so is T_t.",
        verdict=Verdict.CONFIRMED,
        form=_morph,
        cases=lambda: [(motion,) for motion in _motions()],
        deviation=_stretched,
        copies=(Copy("the entries in straight lines", _linear),),
    ),
)
