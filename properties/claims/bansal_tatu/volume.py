"""Lemmas 2 and 3 and what else is said of the volume on the way, and beyond both ends."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from affinecert.properties.claims import definitions
from affinecert.properties.claims.bansal_tatu.interpolation import Path, lie, morph, sam_power
from affinecert.properties.claims.bansal_tatu.samples import TIMES, maps, rigid_maps
from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import affine, arrays
from affinecert.properties.claims.precision import mp, size
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Number, homogeneous, identity

SQUEEZE = affine([[4, 0, 0], [0, mp.mpf(1) / 4, 0], [0, 0, 1]])
"""A stretch that keeps volume."""

GROWTH = affine([[4, 0, 0], [0, mp.mpf(3) / 8, 0], [0, 0, 1]])
"""A stretch that makes volume grow by half."""


def _volume(pose: Array) -> Number:
    return definitions.determinant(pose[:3, :3])


def _keeping() -> list[Array]:
    """Affine maps of determinant 1: products of a lower and an upper triangular matrix of units, and a squeeze."""
    drawn = []
    for lower, upper in zip(arrays("lower", 4, (3, 4), -2, 2), arrays("upper", 4, (3, 3), -2, 2), strict=True):
        left, right = identity(mp, 3), identity(mp, 3)
        for i, j in ((1, 0), (2, 0), (2, 1)):
            left[i, j], right[j, i] = lower[i, j], upper[j, i]
        drawn.append(homogeneous(mp, left @ right, lower[:, 3]))
    return [affine([[1, 1, 0], [0, 1, 0], [0, 0, 1]]), rigid_maps()[1], SQUEEZE, *drawn]


def _not_kept(path: Path, pose: Array) -> Number:
    return max(abs(_volume(path(pose, t)) - 1) for t in TIMES)


def _changing() -> list[Array]:
    """Affine maps of determinants below and above 1."""
    grown = [GROWTH, affine([[-1, 0, 0], [0, -2, 0], [0, 0, 1]]), *maps()]
    return [pose for pose in grown if abs(_volume(pose) - 1) > mp.mpf(1) / 1000]


def _not_monotone(path: Path, pose: Array) -> Number:
    """How far the volume goes the wrong way between eighths of the time."""
    volumes = [_volume(path(pose, mp.mpf(k) / 8)) for k in range(9)]
    sign = 1 if _volume(pose) > 1 else -1
    return max(0, *((before - after) * sign for before, after in pairwise(volumes)))


def _collapsing(path: Path, pose: Array) -> int:
    """Whether the volume vanishes somewhere from -2 to 3."""
    return int(min(_volume(path(pose, mp.mpf(k) / 2)) for k in range(-4, 7)) <= 0)


def _existing(poses: list[Array]) -> list[Array]:
    return [pose for pose in poses if sam.exists(mp, pose)]


def _turned(path: Path, pose: Array) -> Number:
    linears = [path(pose, t)[:3, :3] for t in TIMES]
    return max(size(linear.T @ linear - identity(mp, 3)) for linear in linears)


def _kept_by_both(path: Path, pose: Array) -> Number:
    """The violation of whichever of the two is asked for: volume, and if T is rigid, lengths."""
    rigid = size(pose[:3, :3].T @ pose[:3, :3] - identity(mp, 3)) < mp.mpf(10) ** -60
    return max(_not_kept(path, pose), _turned(path, pose) if rigid else 0)


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.lemma_2",
        place="section 4, Lemma 2",
        statement="If det T = 1, then det T_t = 1.",
        printed="det(T_t) = 1, 0 ≤ t ≤ 1",
        verdict=Verdict.CONFIRMED,
        form=lie,
        cases=_keeping,
        deviation=_not_kept,
        copies=(
            Copy("polar factors, the stretch in straight lines", morph("shoemake_duff")),
            Copy("entries in straight lines", morph("linear")),
        ),
    ),
    Claim(
        id="bansal_tatu.lemma_3",
        place="section 4, Lemma 3",
        statement="If det T > 1 the volume grows all along, if det T < 1 it falls.",
        verdict=Verdict.CONFIRMED,
        form=lie,
        cases=_changing,
        deviation=_not_monotone,
        copies=(
            Copy("polar factors, the stretch in straight lines", morph("shoemake_duff")),
            Copy("entries in straight lines", morph("linear")),
        ),
    ),
    Claim(
        id="bansal_tatu.6.2.beyond",
        place="section 6.2",
        statement="T_t can be taken for t outside of [0, 1]: it stays an orientation-preserving map.",
        verdict=Verdict.CONFIRMED,
        form=lie,
        cases=lambda: [*_keeping(), *_changing()],
        deviation=_collapsing,
        copies=(Copy("polar factors, the stretch in straight lines", morph("shoemake_duff")),),
    ),
    Claim(
        id="bansal_tatu.2.sam_preserves",
        place="section 2, on Rossignac and Vinacua",
        statement="Steady affine morphs keep isometry and volume.",
        verdict=Verdict.CONFIRMED,
        form=sam_power,
        cases=lambda: _existing([*rigid_maps(), *_keeping()]),
        deviation=_kept_by_both,
        copies=(
            Copy("polar factors, the stretch in straight lines", morph("shoemake_duff")),
            Copy("entries in straight lines", morph("linear")),
        ),
    ),
)
