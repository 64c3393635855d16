"""Section 2: what is said of linear blending and of quaternions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.samples import HALF_TURN, TIMES, at, rigid_maps
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import HOLDS, difference, exactly, mp, size
from affinecert.reference import morphs, quaternion, so3
from affinecert.reference._matrices import Array, Context, Number, array, identity, norm

HALF = mp.mpf(1) / 2

Between = Callable[[Context, Array, Array, Array], Array]
"""A morph."""


def _rotations() -> list[Array]:
    return [pose[:3, :3] for pose in rigid_maps()]


def _collapsed(path: Between, pose: Array) -> Number:
    """The volume that is left half way."""
    return abs(definitions.determinant(path(mp, identity(mp, 4), pose, at(HALF))[:3, :3]))


def _a_rotation(path: Between, rotation: Array) -> int:
    """1 if the map half way is a rotation."""
    linear = path(mp, identity(mp, 4), affine(rotation), at(HALF))[:3, :3]
    return int(size(linear.T @ linear - identity(mp, 3)) < mp.mpf(1) / 1000)


def _conjugated(q: Array) -> Array:
    """The linear map x -> q x q* of a quaternion."""
    columns = [
        quaternion.product(quaternion.product(q, array([mp.zero, *axis])), quaternion.conjugate(q))[1:]
        for axis in identity(mp, 3)
    ]
    linear: Array = array([each.tolist() for each in columns]).T
    return linear


def _not_rigid(linear: Callable[[Array], Array], q: Array) -> Number:
    matrix = linear(q)
    return size(matrix.T @ matrix - identity(mp, 3))


def _units() -> list[Array]:
    return [exactly([1, 0, 0, 0]), exactly([HALF] * 4), *(each / norm(mp, each) for each in _quaternions())]


def _quaternions() -> list[Array]:
    return [each for each in arrays("quaternions", 4, (4,), -2, 2) if any(each)]


def _arc(p: Array, q: Array, t: Number) -> Array:
    """(sin((1 - t) a) p + sin(t a) q) / sin a, a the angle between p and q."""
    angle = mp.acos(p @ q)
    arc: Array = (p * mp.sin((1 - t) * angle) + q * mp.sin(t * angle)) / mp.sin(angle)
    return arc


def _chord(p: Array, q: Array, t: Number) -> Array:
    """The normalised chord, the approximation that is used."""
    mixed = p * (1 - t) + q * t
    chord: Array = mixed / norm(mp, mixed)
    return chord


def _off_arc(arc: Callable[..., Array], rotation: Array) -> Number:
    """How far the rotation on the way from I is from exp(t log R)."""
    t = TIMES[0]
    found = arc(exactly([1, 0, 0, 0]), quaternion.of_rotation(mp, rotation), t)
    return difference(quaternion.matrix(found), so3.exp(mp, so3.log(mp, rotation) * t))


def _reaches(arc: Callable[..., Array], rotation: Array) -> int:
    """1 if the formula, a finite one, is slerp."""
    return int(_off_arc(arc, rotation) < HOLDS)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.2.candy_wrapper",
        place="section 2, on linear blend skinning",
        statement="Linear blending produces candy-wrapper artefacts: a twist by π blended half and half is flat.",
        verdict=Verdict.CONFIRMED,
        form=morphs.linear,
        cases=lambda: [affine(HALF_TURN), affine([[1, 0, 0], [0, -1, 0], [0, 0, -1]], (1, 0, 0))],
        deviation=_collapsed,
        copies=(Copy("the proposed interpolation", morphs.lie), Copy("screw motions", morphs.sclerp)),
        remark="Of a twist by θ the cross-section shrinks to cos(θ/2)².",
    ),
    Claim(
        id="bansal_tatu.2.blended_rotations",
        place="section 2",
        statement="The linear blend of rotations need not be a rotation.",
        verdict=Verdict.CONFIRMED,
        form=morphs.linear,
        cases=_rotations,
        deviation=_a_rotation,
        copies=(Copy("the morph by polar decomposition", morphs.shoemake_duff),),
    ),
    Claim(
        id="bansal_tatu.2.slerp",
        place="section 2",
        statement="SLERP is iterative in nature.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_arc,
        cases=_rotations,
        deviation=_reaches,
        correction=Correction(
            statement="between two rotations it is the formula (sin((1 - t) a) p + sin(t a) q) / sin a, and exp(t log "
            "R); averages of more than two on the sphere are iterative",
            form=_arc,
            deviation=_off_arc,
        ),
        copies=(Copy("the normalised chord", _chord),),
    ),
    Claim(
        id="bansal_tatu.2.quaternions",
        place="section 2",
        statement="Quaternions can only capture rigid transformations.",
        verdict=Verdict.BOUND,
        domain="unit quaternions; x -> q x q* scales by |q|²",
        form=_conjugated,
        cases=_units,
        outside=lambda: [exactly([2, 0, 0, 0]), exactly([1, 1, 0, 0]), exactly([1, mp.mpf(1) / 32, 0, 0])],
        deviation=_not_rigid,
        copies=(Copy("x -> (q + 1/8) x (q + 1/8)*", lambda q: _conjugated(q + mp.mpf(1) / 8)),),
        remark="Rotations, that is; with translations it takes dual ones.",
    ),
)
