"""Sections 1 and 2: what is said of the set of affine maps."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.samples import HALF_TURN, QUARTER_TURN, inverse, maps
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.reference._matrices import Array, Number, homogeneous, identity


def _transposed(pose: Array) -> Array:
    """The inverse, as that of a rigid motion."""
    turned = pose[:3, :3].T
    return homogeneous(mp, turned, -(turned @ pose[:3, 3]))


def _no_inverse(invert: Callable[[Array], Array], pose: Array) -> Number:
    """How far it is from an affine map that is the inverse on both sides."""
    back = invert(pose)
    unit = identity(mp, 4)
    return max(size(back[3] - exactly([0, 0, 0, 1])), difference(back @ pose, unit), difference(pose @ back, unit))


def _singular() -> list[Array]:
    return [affine([[1, 0, 0], [0, 1, 0], [0, 0, 0]]), affine([[1, 1, 0], [1, 1, 0], [0, 0, 1]], (1, 0, 0))]


def _still_a_map(pair: tuple[Array, Array], _: None) -> Number:
    """The volume of the mean of two maps, which is 0 if the mean is no invertible map."""
    one, other = pair
    return abs(definitions.determinant(((one + other) / 2)[:3, :3]))


def _bounded(sequence: Callable[[int], Array], k: int) -> int:
    """1 unless member k is an invertible map of an entry of size k or more."""
    pose = sequence(k)
    return int(not (definitions.determinant(pose[:3, :3]) > 0 and size(pose) >= k))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.1.group",
        place="section 1",
        statement="The matrices of affine maps form a Lie group: each has an inverse among them.",
        verdict=Verdict.BOUND,
        domain="invertible affine maps",
        form=inverse,
        cases=maps,
        outside=_singular,
        deviation=_no_inverse,
        copies=(Copy("the inverse of a rigid motion, with Lᵀ for L⁻¹", _transposed),),
    ),
    Claim(
        id="bansal_tatu.2.no_linear_space",
        place="section 2",
        statement="The affine maps form a manifold that is no linear space: the mean of two may be singular.",
        verdict=Verdict.CONFIRMED,
        form=(affine(identity(mp, 3)), affine(HALF_TURN)),
        cases=lambda: [None],
        deviation=_still_a_map,
        copies=(Copy("a quarter turn for a half turn", (affine(identity(mp, 3)), affine(QUARTER_TURN))),),
    ),
    Claim(
        id="bansal_tatu.2.not_compact",
        place="section 2",
        statement="The set of affine maps is not compact: the scalings by k, say, are not bounded.",
        verdict=Verdict.CONFIRMED,
        form=lambda k: affine(identity(mp, 3) * k),
        cases=lambda: [1, 10, 10**9],
        deviation=_bounded,
        copies=(Copy("powers of a turn", lambda k: affine(QUARTER_TURN if k % 2 else HALF_TURN)),),
    ),
)
