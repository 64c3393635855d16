"""The ledger: every statement of the five papers that can be checked, and what its check says of it.

A folder a paper, a file an idea, in the order of the paper. ``affinecert claims`` runs the checks.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from affinecert.properties.claims import bansal_tatu, gallier, kaji_2d, kaji_ochiai, rossignac_vinacua
from affinecert.properties.claims.claim import Claim

PAPERS: Mapping[str, tuple[str, tuple[Claim[Any, Any], ...]]] = {
    "rossignac_vinacua": (
        "J. Rossignac, A. Vinacua, Steady Affine Motions and Morphs, ACM TOG 2011",
        rossignac_vinacua.CLAIMS,
    ),
    "kaji_2d": (
        "S. Kaji, S. Hirose, S. Sakata, Y. Mizoguchi, K. Anjyo, "
        "Mathematical Analysis on Affine Maps for 2D Shape Interpolation, SCA 2012",
        kaji_2d.CLAIMS,
    ),
    "gallier": (
        "J. Gallier, C. Allen-Blanchette, S. Leonardos, Motion Interpolation in SIM(3)",
        gallier.CLAIMS,
    ),
    "kaji_ochiai": (
        "S. Kaji, H. Ochiai, A concise parametrisation of affine transformation",
        kaji_ochiai.CLAIMS,
    ),
    "bansal_tatu": (
        "S. Bansal, A. Tatu, Affine Interpolation in a Lie Group Framework, ACM TOG 38(4), 2019",
        bansal_tatu.CLAIMS,
    ),
}
"""The papers by their short names, with their claims."""

LEDGER: Mapping[str, Claim[Any, Any]] = {claim.id: claim for _, claims in PAPERS.values() for claim in claims}
"""All claims by their ids."""
