"""Rossignac and Vinacua, Steady Affine Motions and Morphs: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.rossignac_vinacua import (
    affinities,
    comparison,
    numeric_logarithms,
    rigid_interpolation,
    steady_morph,
    steady_motions,
    steady_properties,
    steady_trajectories,
)

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *steady_motions.CLAIMS,
    *affinities.CLAIMS,
    *steady_morph.CLAIMS,
    *steady_properties.CLAIMS,
    *steady_trajectories.CLAIMS,
    *comparison.CLAIMS,
    *rigid_interpolation.CLAIMS,
    *numeric_logarithms.CLAIMS,
)
