"""Bansal and Tatu, Affine Interpolation in a Lie Group Framework: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

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
from affinecert.properties.claims.claim import Claim

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *shear_group.CLAIMS,
    *tetrahedron_maps.CLAIMS,
    *tetrahedron_alignment.CLAIMS,
    *component_uniqueness.CLAIMS,
    *steadiness_proof.CLAIMS,
    *volume_proofs.CLAIMS,
    *isometry_proof.CLAIMS,
    *reversibility_proof.CLAIMS,
    *canonical_tetrahedron_components.CLAIMS,
    *canonical_tetrahedron_proof.CLAIMS,
    *rigid_exponential.CLAIMS,
    *rigid_logarithm.CLAIMS,
    *shear_exponential.CLAIMS,
    *shear_logarithm.CLAIMS,
    *scale_maps.CLAIMS,
    *appendix_figures.CLAIMS,
)
