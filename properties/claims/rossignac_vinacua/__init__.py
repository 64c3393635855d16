"""Rossignac and Vinacua, Steady Affine Motions and Morphs: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.rossignac_vinacua import (
    bezier,
    biarc,
    constant_velocity,
    existence,
    existence_region,
    kept_properties,
    kept_volume,
    perturbation,
    reduction,
    trace_criterion,
    uniqueness,
    velocity,
    volume,
    without_steady_morph,
)

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *existence.CLAIMS,
    *trace_criterion.CLAIMS,
    *reduction.CLAIMS,
    *existence_region.CLAIMS,
    *perturbation.CLAIMS,
    *without_steady_morph.CLAIMS,
    *bezier.CLAIMS,
    *biarc.CLAIMS,
    *constant_velocity.CLAIMS,
    *uniqueness.CLAIMS,
    *velocity.CLAIMS,
    *kept_properties.CLAIMS,
    *kept_volume.CLAIMS,
    *volume.CLAIMS,
)
