"""Section 3.1: the steady motions between rigid poses."""

from __future__ import annotations

from typing import Any

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Loss, Verdict
from affinecert.properties.claims.draws import affine, plane_rotation, rotations
from affinecert.properties.claims.precision import HOLDS, equals, exactly, mp, size
from affinecert.properties.claims.rossignac_vinacua.pose_pairs import rigid_pairs, unlike_steady
from affinecert.properties.matrix.algebra import inverse
from affinecert.reference import morphs, sam, so3
from affinecert.reference._matrices import Array, Context, Number, array, dot, homogeneous, identity, norm, scalar


def orthonormal(linear: Array) -> bool:
    """Whether the columns are orthonormal."""
    return bool(size(linear.T @ linear - identity(mp, len(linear))) < HOLDS)


def _unit_columns(linear: Array) -> bool:
    return bool(size(np.diag(linear.T @ linear) - 1) < HOLDS)


def _misjudged(form: Any, linear: Array) -> Number:
    """Whether a test says other than that distances are kept, those of the corners of a cube or square."""
    corners = np.array(list(np.ndindex(*[2] * len(linear))), dtype=object)
    kept = all(
        abs(norm(mp, linear @ (p - q)) - norm(mp, p - q)) < HOLDS for i, p in enumerate(corners) for q in corners[:i]
    )
    return mp.mpf(form(linear) != kept)


def _linear_parts() -> list[Array]:
    plain = [[[0, -1], [1, 0]], [[2, 0], [0, 2]], [[1, 0.5], [0, 1]]]
    skew = exactly([[5, 3], [0, 4]]) / array([[5, 5], [5, 5]])
    return [*map(exactly, plain), skew, *rotations("isometries", 2)]


def _about_fixed_point(m: Context, affinity: Any, t: Number, column: bool = True) -> Array:
    """A^t for a rotation of the plane: by t a about q, A(q) = q, where (cos a, sin a) is the first column of L."""
    affinity = np.asarray(affinity, dtype=object)
    linear = affinity[:2, :2]
    cosine, sine = linear[:, 0] if column else linear[0]
    angle = t * m.atan2(sine, cosine)
    turn = array([[m.cos(angle), -m.sin(angle)], [m.sin(angle), m.cos(angle)]])
    centre = definitions.inverse(m, identity(m, 2) - linear) @ affinity[:2, 2]
    return homogeneous(m, turn, centre - turn @ centre)


def _power(m: Context, affinity: Array, t: Number) -> Array:
    return sam.power(m, affinity, scalar(t))


def _plane_turns() -> list[tuple[Array, Number]]:
    angles = (mp.pi / 2, mp.one, -mp.mpf(3), mp.mpf(0.0625))
    return [(homogeneous(mp, plane_rotation(angle), exactly([1, 2])), mp.mpf(0.25)) for angle in angles]


def screw_parts(m: Context, affinity: Array) -> tuple[Array, Array, Number, Number]:
    """Direction d and a point q of the axis, angle a and distance d of a screw."""
    vector = so3.log(m, affinity[:3, :3])
    angle = norm(m, vector)
    axis = vector / angle
    length = dot(m, axis, affinity[:3, 3])
    return axis, _point_of_axis(m, affinity, axis, length), angle, length


def _point_of_axis(m: Context, affinity: Array, axis: Array, length: Number) -> Array:
    """The point of the axis nearest to the origin: (I - L + d d^T) q = t - (d . t) d."""
    matrix = identity(m, 3) - affinity[:3, :3] + axis[:, None] * axis[None, :]
    point: Array = definitions.inverse(m, matrix) @ (affinity[:3, 3] - axis * length)
    return point


def _screw(m: Context, affinity: Array, t: Number, *, rate: int = 1, sense: int = 1) -> Array:
    axis, centre, angle, length = screw_parts(m, affinity)
    turn = so3.exp(m, axis * (sense * angle * t))
    return homogeneous(m, turn, centre - turn @ centre + axis * (length * t**rate))


def _screws() -> list[tuple[Array, Number]]:
    return [(end @ inverse(start), mp.mpf(0.25)) for start, end in rigid_pairs()]


def _eigenvector_and_fixed_point(m: Context, affinity: Array) -> tuple[Array, Array]:
    axis, *_ = screw_parts(m, affinity)
    return axis, definitions.inverse(m, identity(m, 3) - affinity[:3, :3]) @ affinity[:3, 3]


def _axis_and_its_point(m: Context, affinity: Array) -> tuple[Array, Array]:
    axis, centre, _, _ = screw_parts(m, affinity)
    return axis, centre


def beside_axis(form: Any, affinity: Array) -> Number:
    """How far L d is from d, and A(q) - q from a multiple of d."""
    axis, centre = form(mp, affinity)
    linear, translation = affinity[:3, :3], affinity[:3, 3]
    shift = linear @ centre + translation - centre
    return max(size(linear @ axis - axis), size(shift - axis * dot(mp, axis, shift)))


def _rigid_motions() -> list[Array]:
    return [affine([[0, -1, 0], [1, 0, 0], [0, 0, 1]], [0, 0, 1]), *(each for each, _ in _screws())]


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="rossignac_vinacua.3.1.orthonormal",
        place="section 3.1",
        statement="A is an isometry if and only if the columns of L are orthonormal.",
        verdict=Verdict.CONFIRMED,
        form=orthonormal,
        cases=_linear_parts,
        deviation=_misjudged,
        copies=(Copy("columns of length 1", _unit_columns),),
    ),
    Claim(
        id="rossignac_vinacua.3.1.plane",
        place="section 3.1",
        statement="In the plane the steady morph of an isometry with L ≠ I is the rotation by t a about the point q "
        "with A(q) = q, where (cos a, sin a) is the first column of L.",
        verdict=Verdict.CONFIRMED,
        form=_about_fixed_point,
        cases=_plane_turns,
        deviation=equals(_power),
        copies=(Copy("the first row for the first column", lambda m, a, t: _about_fixed_point(m, a, t, column=False)),),
        losses=(
            Loss(
                where="the translation half way, for angle 1e-8: the centre is 1e8 away",
                formula=lambda m, a, t: _about_fixed_point(m, a, t)[:2, 2],
                truth=lambda m, a, t: _power(m, a, t)[:2, 2],
                at=([[1.0, -1e-8, 1.0], [1e-8, 1.0, 0.0], [0.0, 0.0, 1.0]], 0.5),
                digits=7,
            ),
        ),
        remark="For small angles the translation is better found without q, by sin(t a / 2) / sin(a / 2).",
    ),
    Claim(
        id="rossignac_vinacua.3.1.screw",
        place="section 3.1",
        statement="In space it is the screw by the angle t a about the axis through q along d, and by t d along it.",
        verdict=Verdict.CONFIRMED,
        form=_screw,
        cases=_screws,
        deviation=equals(_power),
        copies=(
            Copy("a slide by t² d", lambda m, a, t: _screw(m, a, t, rate=2)),
            Copy("the angle -t a", lambda m, a, t: _screw(m, a, t, sense=-1)),
        ),
    ),
    Claim(
        id="rossignac_vinacua.3.1.sclerp",
        place="section 3.1",
        statement="Screw linear interpolation (ScLERP) of rigid poses is the steady morph.",
        verdict=Verdict.CONFIRMED,
        form=morphs.sclerp,
        cases=rigid_pairs,
        deviation=unlike_steady,
        copies=(
            Copy("dual quaternion linear blending", morphs.dual_quaternion_linear),
            Copy("e^((1 - t) log B + t log C)", morphs.alexa_2002),
        ),
        remark="Less than half a turn apart; there the two may go different ways round.",
    ),
    Claim(
        id="rossignac_vinacua.3.1.fixed_point",
        place="section 3.1",
        statement="For a rigid motion of space, the axis of the screw has the direction of the eigenvector of L and "
        "passes through q, the fixed point of A.",
        printed="d as the eigenvector of the unique real eigenvalue of L and q as the fixed point of A",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=_eigenvector_and_fixed_point,
        cases=_rigid_motions,
        deviation=beside_axis,
        correction=Correction(
            statement="A has no fixed point if it slides, else a whole axis of them: q solves "
            "(I - L + d dᵀ) q = t - (d · t) d.",
            form=_axis_and_its_point,
        ),
        copies=(
            Copy(
                "the part of t across the axis for q",
                lambda m, a: (screw_parts(m, a)[0], a[:3, 3] - screw_parts(m, a)[0] * screw_parts(m, a)[3]),
            ),
        ),
        remark="I - L is singular for every rotation of space. At half a turn the real eigenvalue is not unique "
        "either: -1 is another, double.",
    ),
)
