"""Section 2: what is said of polar, singular value and QR decompositions, and of morphs by them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from affinecert.properties.claims.bansal_tatu.interpolation import Path, lie, morph
from affinecert.properties.claims.bansal_tatu.samples import QUARTER_TURN, TIMES, at, maps, rigid_maps
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import difference, distance, exactly, mp, size
from affinecert.reference import morphs, polar
from affinecert.reference._alignment import align_edges
from affinecert.reference._matrices import Array, Number, array, identity

Rotation = Callable[[Array], Array]
"""The rotation that a decomposition finds in a linear map."""


def _polar(linear: Array) -> Array:
    rotation, _ = polar.decompose(mp, linear)
    return rotation


def _qr(linear: Array) -> Array:
    """Q of L = Q R, R of positive diagonal."""
    rotation, _ = align_edges(mp, linear.T)
    return rotation.T


def _singular(linear: Array) -> Array:
    """U of L = U D V^T."""
    u, _, _ = mp.svd_r(mp.matrix(linear.tolist()))
    return array(u.tolist())


def _no_polar(decompose: Callable[[Array], tuple[Array, Array]], linear: Array) -> Number:
    """How far the factors are from a rotation and a symmetric positive definite matrix whose product is L."""
    rotation, stretch = decompose(linear)
    wrong = max(size(rotation.T @ rotation - identity(mp, 3)), size(stretch - stretch.T))
    smallest = min(mp.eigsy(mp.matrix(stretch.tolist()), eigvals_only=True))
    return max(wrong, distance(rotation @ stretch, linear), -min(smallest, 0))


def _linears() -> list[Array]:
    return [pose[:3, :3] for pose in maps()]


TINY = mp.mpf(10) ** -20


def _nudges() -> list[tuple[Array, Array]]:
    """A linear map, and small changes of it: two at the identity that stretch along other axes."""
    upright, slanted = exactly([[1, 0, 0], [0, -1, 0], [0, 0, 0]]), exactly([[0, 1, 0], [1, 0, 0], [0, 0, 0]])
    return [(identity(mp, 3), upright), (identity(mp, 3) + upright * TINY, slanted - upright)]


def _sensitive(rotation: Rotation, case: tuple[Array, Array]) -> Number:
    """By how much the rotation changes more than twice as much as the map."""
    linear, change = case
    moved = difference(rotation(linear + change * TINY), rotation(linear))
    return max(moved / (size(change) * TINY) - 2, 0)


def _stretches() -> list[Array]:
    return [exactly([[2, 1, 0], [1, 2, 0], [0, 0, 1]]), exactly([[3, 1, 1], [1, 2, 0], [1, 0, 2]])]


def _unturned(rotation: Rotation, stretch: Array) -> int:
    """1 if it finds no rotation in a stretch along orthogonal axes."""
    return int(size(rotation(stretch) - identity(mp, 3)) < mp.mpf(1) / 1000)


def _shears() -> list[Array]:
    rows = [[1, 1, 0], [0, 1, 0], [0, 0, 1]], [[1, -2, 1], [0, 1, 0], [0, 0, 1]], [[1, 3, 0], [0, 1, 2], [0, 0, 1]]
    return [affine(each) for each in rows]


def _sheared_on_the_way(path: Path, pose: Array) -> int:
    """1 if the maps on the way from I to a shear are shears: upper triangular with ones on the diagonal."""
    linear = path(pose, TIMES[0])[:3, :3]
    below = max(abs(linear[i, j]) for i, j in ((1, 0), (2, 0), (2, 1)))
    return int(max(below, size(np.diagonal(linear) - mp.one)) < mp.mpf(1) / 1000)


def _unlike_alexa(path: Any, case: tuple[Array, Array]) -> Number:
    """How far a morph from B to C is from that of Alexa, Cohen-Or and Levin."""
    start, end = case
    t = at(TIMES[0])
    return distance(path(mp, start, end, t), morphs.arap(mp, start, end, t))


def _from_rotations() -> list[tuple[Array, Array]]:
    starts = (affine(identity(mp, 3)), affine(QUARTER_TURN, (1, 0, 0)), *rigid_maps()[2:4])
    return list(zip(starts, (maps()[4], maps()[3], *maps()[5:7]), strict=True))


def _from_stretches() -> list[tuple[Array, Array]]:
    return [(affine([[2, 0, 0], [0, 1, 0], [0, 0, 1]]), maps()[3]), (maps()[3], maps()[4])]


def _separate(path: Any, pose: Array) -> Number:
    """How far from a straight line the morph from I moves the origin: whether the linear part bends its way."""
    t = TIMES[0]
    moved = path(mp, identity(mp, 4), pose, at(t))
    return size(moved[:3, 3] - pose[:3, 3] * t)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.2.polar",
        place="section 2, on Shoemake",
        statement="The linear part of T is Q S, Q a rotation and S symmetric positive definite.",
        printed="T = Q S",
        verdict=Verdict.CONFIRMED,
        form=lambda linear: polar.decompose(mp, linear),
        cases=_linears,
        deviation=_no_polar,
        copies=(Copy("Q of QR for Q", lambda linear: (_qr(linear), _qr(linear).T @ linear)),),
        remark="Of a linear map that preserves orientation.",
    ),
    Claim(
        id="bansal_tatu.2.svd_is_sensitive",
        place="section 2",
        statement="The rotation of the polar decomposition is stable; the singular value decomposition is sensitive to "
        "small perturbations.",
        verdict=Verdict.CONFIRMED,
        form=_polar,
        cases=_nudges,
        deviation=_sensitive,
        copies=(Copy("U of the singular value decomposition", _singular),),
        remark="Near to equal singular values, that is. The polar rotation in turn is sensitive near to det = 0.",
    ),
    Claim(
        id="bansal_tatu.2.qr_is_stable",
        place="section 2",
        statement="The QR decomposition is stable under small perturbations.",
        verdict=Verdict.CONFIRMED,
        form=_qr,
        cases=_nudges,
        deviation=_sensitive,
        copies=(Copy("U of the singular value decomposition", _singular),),
    ),
    Claim(
        id="bansal_tatu.2.qr_turns",
        place="section 2",
        statement="The QR decomposition produces unintuitive rotations: it finds one in a mere stretch.",
        verdict=Verdict.CONFIRMED,
        form=_qr,
        cases=_stretches,
        deviation=_unturned,
        copies=(Copy("the polar decomposition", _polar),),
        remark="So does the proposed T = A S E, an RQ decomposition of the linear part.",
    ),
    Claim(
        id="bansal_tatu.2.polar_and_shear",
        place="section 2",
        statement="Polar decomposition cannot handle shear directly: on the way to a shear the maps are none.",
        verdict=Verdict.CONFIRMED,
        form=morph("shoemake_duff"),
        cases=_shears,
        deviation=_sheared_on_the_way,
        copies=(Copy("the proposed interpolation", lie),),
    ),
    Claim(
        id="bansal_tatu.2.alexa_2000",
        place="section 2, and one row for both in figure 3",
        statement="The morphs of Shoemake (1992) and of Alexa, Cohen-Or and Levin (2000) are the same.",
        verdict=Verdict.BOUND,
        domain="from a rigid pose, as from I; between others the stretches are composed differently",
        form=morphs.shoemake_duff,
        cases=_from_rotations,
        outside=_from_stretches,
        deviation=_unlike_alexa,
        copies=(Copy("S^t for (1 - t) I + t S", morphs.polar_exponential),),
    ),
    Claim(
        id="bansal_tatu.2.translation_apart",
        place="section 2",
        statement="Shoemake (1992) treats the translation apart from the linear part: it goes straight.",
        verdict=Verdict.CONFIRMED,
        form=morphs.shoemake_duff,
        cases=maps,
        deviation=_separate,
        copies=(Copy("the proposed interpolation", morphs.lie),),
    ),
)
