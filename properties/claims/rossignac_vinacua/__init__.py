"""Rossignac and Vinacua, Steady Affine Motions and Morphs: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.rossignac_vinacua import (
    affinities,
    comparison,
    exponential_interpolation,
    numeric_logarithms,
    overview,
    polar_factors,
    polar_morphs,
    rigid_blending,
    rigid_interpolation,
    rigidity,
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
    *rigid_blending.CLAIMS,
    *polar_factors.CLAIMS,
    *polar_morphs.CLAIMS,
    *exponential_interpolation.CLAIMS,
    *rigidity.CLAIMS,
    *overview.CLAIMS,
)
