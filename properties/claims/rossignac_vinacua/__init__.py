"""Rossignac and Vinacua, Steady Affine Motions and Morphs: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.rossignac_vinacua import (
    biarc,
    existence,
    existence_region,
    kept_properties,
    perturbation,
    reduction,
    uniqueness,
    velocity,
    volume,
    without_steady_morph,
)

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *existence.CLAIMS,
    *reduction.CLAIMS,
    *existence_region.CLAIMS,
    *perturbation.CLAIMS,
    *without_steady_morph.CLAIMS,
    *biarc.CLAIMS,
    *uniqueness.CLAIMS,
    *velocity.CLAIMS,
    *kept_properties.CLAIMS,
    *volume.CLAIMS,
)
