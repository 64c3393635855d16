"""The parametrisations that the paper compares, as maps of numbers: phi, psi, and how parameters are joined."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from affinecert.properties.claims import definitions
from affinecert.properties.claims.kaji_ochiai.other_parametrisations import euler, turned
from affinecert.properties.claims.kaji_ochiai.parametrisation import symmetric
from affinecert.properties.claims.kaji_ochiai.precursors import motion_of_dual
from affinecert.properties.claims.kaji_ochiai.subspaces import CLASSES
from affinecert.properties.claims.precision import exactly
from affinecert.properties.laws.subclasses import ANY, Subclass
from affinecert.reference import kaji_ochiai, polar, quaternion, sam, so3
from affinecert.reference._matrices import Array, Context, Number, array, cross_matrix, homogeneous, scalar, tangent

ROTATIONS, MOTIONS, AFFINE = CLASSES["SO(3)"], CLASSES["SE(3)"], Subclass("Aff+(3)", True, True, ANY)

ORIGIN = exactly([0, 0, 0])

UNIT_STRETCH = exactly([1, 0, 0, 1, 0, 1])


def _straight(m: Context, first: Array, last: Array, t: Number) -> Array:
    between: Array = first * (1 - t) + last * t
    return between


def _free(parameters: Array) -> Array:
    return array([])


@dataclass(frozen=True)
class Parametrisation:
    """A map phi of tuples of ``count`` numbers to homogeneous matrices of a group.

    ``psi`` is an inverse of it on all of the group, None where a matrix has no parameter. The parameters are the tuples
    where the ``constraint`` is 0; all of them, or an open set of them, unless there is one. ``turn`` is the parameter
    of a turn about the x or y axis by any angle, continued from that of the identity. ``between`` joins two parameters.
    """

    name: str
    group: Subclass
    count: int
    phi: Callable[[Context, Array], Array]
    psi: Callable[[Context, Array], Array | None]
    turn: Callable[[Context, Array, Number], Array]
    constraint: Callable[[Array], Array] = _free
    between: Callable[[Context, Array, Array, Number], Array] = _straight


def _euler_angles(m: Context, affine: Array) -> Array:
    """Euler angles about z, y, x of a rotation; the last is 0 at the gimbal lock."""
    r = affine[:3, :3]
    cosine = m.sqrt(r[0, 0] ** 2 + r[1, 0] ** 2)
    locked = cosine < m.mpf(10) ** -40
    first = m.atan2(-r[0, 1], r[1, 1]) if locked else m.atan2(r[1, 0], r[0, 0])
    return array([first, m.atan2(-r[2, 0], cosine), m.zero if locked else m.atan2(r[2, 1], r[2, 2])])


def _quaternion(m: Context, affine: Array) -> Array:
    return quaternion.of_rotation(m, affine[:3, :3])


def _quaternion_turn(m: Context, axis: Array, angle: Number) -> Array:
    return array([m.cos(angle / 2), *(axis * m.sin(angle / 2))])


def _dual(m: Context, affine: Array) -> Array:
    """The unit dual quaternion q + e t q / 2, eight numbers."""
    q = _quaternion(m, affine)
    return np.concatenate([q, quaternion.product(array([m.zero, *affine[:3, 3]]), q) / 2])


def _dual_turn(m: Context, axis: Array, angle: Number) -> Array:
    return np.concatenate([_quaternion_turn(m, axis, angle), exactly([0, 0, 0, 0])])


def _of_unit_dual(m: Context, parameters: Array) -> Array:
    q, r = parameters[:4], parameters[4:]
    return homogeneous(m, quaternion.matrix(q), 2 * quaternion.product(r, quaternion.conjugate(q))[1:])


def _blended_duals(m: Context, first: Array, last: Array, t: Number) -> Array:
    """Dual quaternion linear blending: the sum, with signs alike, normalised."""
    sign = 1 if first[:4] @ last[:4] >= 0 else -1
    return _dual(m, motion_of_dual(_straight(m, first, last * sign, t)))


def _unit_norm(q: Array) -> Array:
    return array([q @ q - 1])


def _moved(turns: Parametrisation) -> Parametrisation:
    """The rigid motions by parameters of the rotation, and three of the translation."""
    n = turns.count

    def psi(m: Context, affine: Array) -> Array | None:
        own = turns.psi(m, affine)
        return None if own is None else np.concatenate([own, affine[:3, 3]])

    return Parametrisation(
        f"{turns.name}, translation",
        MOTIONS,
        n + 3,
        lambda m, p: homogeneous(m, turns.phi(m, p[:n])[:3, :3], p[n:]),
        psi,
        lambda m, axis, angle: np.concatenate([turns.turn(m, axis, angle), ORIGIN]),
        lambda p: turns.constraint(p[:n]),
        lambda m, p, q, t: np.concatenate([turns.between(m, p[:n], q[:n], t), _straight(m, p[n:], q[n:], t)]),
    )


def _stretched(motions: Parametrisation, name: str) -> Parametrisation:
    """The affine maps by parameters of the rigid motion, and the upper half of the stretch before it as a matrix."""
    n = motions.count

    def psi(m: Context, affine: Array) -> Array | None:
        turn, stretch = polar.decompose(m, affine[:3, :3])
        own = motions.psi(m, homogeneous(m, turn, affine[:3, 3]))
        return None if own is None else np.concatenate([own, stretch[kaji_ochiai.UPPER]])

    return Parametrisation(
        name,
        AFFINE,
        n + 6,
        lambda m, p: np.asarray(motions.phi(m, p[:n]) @ homogeneous(m, symmetric(p[n:]), ORIGIN)),
        psi,
        lambda m, axis, angle: np.concatenate([motions.turn(m, axis, angle), UNIT_STRETCH]),
        lambda p: motions.constraint(p[:n]),
        lambda m, p, q, t: np.concatenate([motions.between(m, p[:n], q[:n], t), _straight(m, p[n:], q[n:], t)]),
    )


def _lie_algebra(m: Context, affine: Array) -> Array | None:
    return sam.log(m, affine)[:3].reshape(-1) if sam.exists(m, affine) else None


def _lie_turn(m: Context, axis: Array, angle: Number) -> Array:
    return tangent(m, cross_matrix(m, axis * angle), ORIGIN)[:3].reshape(-1)


MATRICES = Parametrisation(
    "matrices",
    AFFINE,
    12,
    lambda m, p: np.concatenate([p.reshape(3, 4), exactly([[0, 0, 0, 1]])]),
    lambda m, affine: affine[:3].reshape(-1),
    lambda m, axis, angle: homogeneous(m, so3.exp(m, axis * angle), ORIGIN)[:3].reshape(-1),
)

EULER = Parametrisation(
    "Euler angles",
    ROTATIONS,
    3,
    lambda m, p: homogeneous(m, euler(m, p), ORIGIN),
    _euler_angles,
    lambda m, axis, angle: axis[::-1] * angle,
)

QUATERNIONS = Parametrisation(
    "invertible quaternions",
    ROTATIONS,
    4,
    lambda m, p: homogeneous(m, turned(p), ORIGIN),
    _quaternion,
    _quaternion_turn,
)

UNIT_QUATERNIONS = Parametrisation(
    "unit quaternions",
    ROTATIONS,
    4,
    lambda m, p: homogeneous(m, quaternion.matrix(p), ORIGIN),
    _quaternion,
    _quaternion_turn,
    _unit_norm,
    lambda m, p, q, t: quaternion.slerp(m, p, q, scalar(t)),
)

DUAL_QUATERNIONS = Parametrisation(
    "invertible dual quaternions",
    MOTIONS,
    8,
    lambda m, p: motion_of_dual(p),
    _dual,
    _dual_turn,
)

UNIT_DUAL_QUATERNIONS = Parametrisation(
    "unit dual quaternions",
    MOTIONS,
    8,
    _of_unit_dual,
    _dual,
    _dual_turn,
    lambda p: array([p[:4] @ p[:4] - 1, p[:4] @ p[4:]]),
    _blended_duals,
)

ROTATION_VECTORS = Parametrisation(
    "Lie algebra of the rotations",
    ROTATIONS,
    3,
    lambda m, p: homogeneous(m, so3.exp(m, p), ORIGIN),
    lambda m, affine: so3.log(m, affine[:3, :3]),
    lambda m, axis, angle: axis * angle,
)

SHOEMAKE = _stretched(_moved(UNIT_QUATERNIONS), "polar factors by unit quaternions and matrices")

POLAR_DUAL = _stretched(UNIT_DUAL_QUATERNIONS, "polar factors by unit dual quaternions and matrices")

POLAR_GRASSIA = _stretched(_moved(ROTATION_VECTORS), "polar factors by rotation vectors and matrices")

ALEXA = Parametrisation(
    "Lie algebra of the affine maps",
    AFFINE,
    12,
    lambda m, p: definitions.exponential(m, tangent(m, p.reshape(3, 4)[:, :3], p.reshape(3, 4)[:, 3])),
    _lie_algebra,
    _lie_turn,
)

OWN = Parametrisation(
    "the paper's",
    AFFINE,
    12,
    kaji_ochiai.realise,
    kaji_ochiai.parametrise,
    lambda m, axis, angle: np.concatenate([ORIGIN, axis * angle, exactly([0] * 6)]),
)

PARAMETRISATIONS = {
    each.name: each
    for each in (
        MATRICES,
        EULER,
        QUATERNIONS,
        UNIT_QUATERNIONS,
        DUAL_QUATERNIONS,
        UNIT_DUAL_QUATERNIONS,
        ROTATION_VECTORS,
        SHOEMAKE,
        POLAR_DUAL,
        POLAR_GRASSIA,
        ALEXA,
        OWN,
    )
}
"""The rows of the comparison, by name."""
