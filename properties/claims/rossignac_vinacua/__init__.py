"""Rossignac and Vinacua, Steady Affine Motions and Morphs: its claims, in the order of the paper."""

from __future__ import annotations

from types import ModuleType

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

CHAPTERS: tuple[ModuleType, ...] = (
    steady_motions,
    affinities,
    steady_morph,
    steady_properties,
    steady_trajectories,
    comparison,
    rigid_interpolation,
    numeric_logarithms,
    rigid_blending,
    polar_factors,
    polar_morphs,
    exponential_interpolation,
    rigidity,
    overview,
)
