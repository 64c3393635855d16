"""Bansal and Tatu, Affine Interpolation in a Lie Group Framework: its claims, in the order of the paper."""

from __future__ import annotations

from types import ModuleType

from affinecert.properties.claims.bansal_tatu import (
    appendix_figures,
    canonical_tetrahedron_components,
    canonical_tetrahedron_proof,
    component_uniqueness,
    isometry_proof,
    reversibility_proof,
    rigid_exponential,
    rigid_logarithm,
    scale_maps,
    shear_exponential,
    shear_group,
    shear_logarithm,
    steadiness_proof,
    tetrahedron_alignment,
    tetrahedron_maps,
    volume_proofs,
)

CHAPTERS: tuple[ModuleType, ...] = (
    shear_group,
    tetrahedron_maps,
    tetrahedron_alignment,
    component_uniqueness,
    steadiness_proof,
    volume_proofs,
    isometry_proof,
    reversibility_proof,
    canonical_tetrahedron_components,
    canonical_tetrahedron_proof,
    rigid_exponential,
    rigid_logarithm,
    shear_exponential,
    shear_logarithm,
    scale_maps,
    appendix_figures,
)
