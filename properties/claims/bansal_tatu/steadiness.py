"""Lemma 1, and what else is said of where a motion is steady."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from affinecert.properties.claims.bansal_tatu.interpolation import (
    Path,
    lie,
    morph,
    multiplied,
    powers,
    sam_power,
    straight_shear,
)
from affinecert.properties.claims.bansal_tatu.samples import QUARTER_TURN, TIMES, maps, rigid_maps, scaling
from affinecert.properties.claims.claim import Claim, Copy, Correction, Fault, Verdict
from affinecert.properties.claims.draws import affine
from affinecert.properties.claims.precision import distance, exactly, mp, size
from affinecert.reference import sam
from affinecert.reference._matrices import Array, Number


def _no_group(path: Path, pose: Array) -> Number:
    """How far T_2t is from T_t T_t."""
    return max(distance(path(pose, 2 * t), path(pose, t) @ path(pose, t)) for t in TIMES)


def _unsteady(path: Path, pose: Array) -> Number:
    """How far T_t is from T^t."""
    return max(distance(path(pose, t), sam_power(pose, t)) for t in TIMES)


def _of_lemma_1() -> list[Array]:
    matrix = exactly([[1, 1, -1], [0, 2, 1], [0, 0, 3]])
    return [
        scaling(mp.mpf(2)),
        *rigid_maps(),
        affine([[1, 1, 0], [0, 1, 1], [0, 0, 1]]),
        affine(matrix),
        affine(2 * matrix),
    ]


def _beyond_lemma_1() -> list[Array]:
    """Maps that are none of those of Lemma 1."""
    return [
        affine(exactly([[1, 1, 0], [0, 1, 0], [0, 0, 1]]) @ QUARTER_TURN),
        affine(2 * QUARTER_TURN),
        affine(QUARTER_TURN @ exactly([[1, 0, 0], [0, 1, 0], [0, 0, 2]])),
        affine(QUARTER_TURN @ exactly([[1, 0, 0], [0, 1, 0], [0, 0, 2]]), (1, 0, 0)),
        *(pose for pose in maps()[4:]),
    ]


def _steady_after_all(path: Path, pose: Array) -> int:
    return int(_no_group(path, pose) < mp.mpf(10) ** -50)


def _commute(scaled: bool = True) -> Callable[[Array], bool]:
    def condition(pose: Array) -> bool:
        whole, scale, rigid = powers(pose, mp.one)
        upper = whole @ scale if scaled else whole
        return bool(size(upper @ rigid - rigid @ upper) < mp.mpf(10) ** -50)

    return condition


def _misjudged(condition: Callable[[Array], bool], pose: Array) -> int:
    return int(condition(pose) != bool(_steady_after_all(lie, pose)))


CLAIMS: tuple[Claim[Any, Any], ...] = (
    Claim(
        id="bansal_tatu.lemma_1",
        place="section 4, Lemma 1",
        statement="Of a map that is A, S or E alone, or A S, the interpolation is steady.",
        printed="T_t = T^t",
        verdict=Verdict.CONFIRMED,
        form=lie,
        cases=_of_lemma_1,
        deviation=_unsteady,
        copies=(
            Copy("the morph by polar decomposition and logarithms", morph("polar_exponential")),
            Copy("(1 - t) I + t A for A^t", lambda pose, t: multiplied(straight_shear(pose, t))),
        ),
    ),
    Claim(
        id="bansal_tatu.6.1.only_lemma_1",
        place="section 6.1",
        statement="The interpolation is steady in no other cases than those of Lemma 1.",
        verdict=Verdict.REFUTED,
        fault=Fault.MATHEMATICAL,
        form=lie,
        cases=_beyond_lemma_1,
        deviation=_steady_after_all,
        correction=Correction(
            statement="it is steady where A S and E commute (E turning by less than π), as a scaling and a turn about "
            "the origin do",
            form=_commute(),
            cases=lambda: [*_beyond_lemma_1(), *maps()],
            deviation=_misjudged,
        ),
        copies=(Copy("where A and E commute", _commute(scaled=False)),),
    ),
    Claim(
        id="bansal_tatu.4.sam_is_steady",
        place="section 4",
        statement="The interpolation of Rossignac and Vinacua is steady wherever it exists.",
        printed="T_t = T^t",
        verdict=Verdict.CONFIRMED,
        form=morph("sam"),
        cases=lambda: [pose for pose in maps() if sam.exists(mp, pose)],
        deviation=_no_group,
        copies=(Copy("the proposed interpolation", lie),),
    ),
)
