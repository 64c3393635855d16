"""The ledger: every statement of the five papers that can be checked, and what its check says of it.

A folder a paper, a file an idea, in the order of the paper. ``affinecert claims`` runs the checks.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any

from affinecert.properties.claims import bansal_tatu, gallier, kaji_2d, kaji_ochiai, rossignac_vinacua
from affinecert.properties.claims.claim import Claim


@dataclass(frozen=True)
class Paper:
    """A paper: who wrote it, its title, where it appeared, and the modules that hold its claims."""

    title: str
    chapters: tuple[ModuleType, ...]

    @property
    def claims(self) -> tuple[Claim[Any, Any], ...]:
        """All its claims, in the paper's order."""
        return tuple(claim for chapter in self.chapters for claim in chapter.CLAIMS)


PAPERS: Mapping[str, Paper] = {
    "rossignac_vinacua": Paper(
        "J. Rossignac, Á. Vinacua, Steady Affine Motions and Morphs, ACM Transactions on Graphics 30(5), 2011",
        rossignac_vinacua.CHAPTERS,
    ),
    "kaji_2d": Paper(
        "S. Kaji, S. Hirose, S. Sakata, Y. Mizoguchi, K. Anjyo, "
        "Mathematical Analysis on Affine Maps for 2D Shape Interpolation, SCA 2012",
        kaji_2d.CHAPTERS,
    ),
    "gallier": Paper(
        "J. Gallier, C. Allen-Blanchette, S. Leonardos, Motion Interpolation in SIM(3)",
        gallier.CHAPTERS,
    ),
    "kaji_ochiai": Paper(
        "S. Kaji, H. Ochiai, A concise parametrisation of affine transformation",
        kaji_ochiai.CHAPTERS,
    ),
    "bansal_tatu": Paper(
        "S. Bansal, A. Tatu, Affine Interpolation in a Lie Group Framework, ACM Transactions on Graphics 38(4), 2019",
        bansal_tatu.CHAPTERS,
    ),
}
"""The papers by their short names, the oldest first."""

LEDGER: Mapping[str, Claim[Any, Any]] = {claim.id: claim for paper in PAPERS.values() for claim in paper.claims}
"""All claims by their ids."""

if len(LEDGER) != sum(len(paper.claims) for paper in PAPERS.values()):
    raise ValueError("two claims have one id")
