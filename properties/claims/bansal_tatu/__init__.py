"""Bansal and Tatu, Affine Interpolation in a Lie Group Framework: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.bansal_tatu import (
    affine_group,
    alignment,
    blending,
    canonical_tetrahedron,
    decompositions,
    extrapolation,
    interpolated_tetrahedra,
    interpolation,
    lie_groups,
    orderings,
    other_representations,
    path_deviation,
    product_group,
    relative_acceleration,
    reordered_similarities,
    representation,
    rigid_exponential,
    smooth_curves,
    steadiness,
    steady_existence,
    uniqueness,
    volume,
)
from affinecert.properties.claims.claim import Claim

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *affine_group.CLAIMS,
    *decompositions.CLAIMS,
    *blending.CLAIMS,
    *other_representations.CLAIMS,
    *alignment.CLAIMS,
    *representation.CLAIMS,
    *lie_groups.CLAIMS,
    *product_group.CLAIMS,
    *uniqueness.CLAIMS,
    *interpolation.CLAIMS,
    *interpolated_tetrahedra.CLAIMS,
    *steadiness.CLAIMS,
    *volume.CLAIMS,
    *smooth_curves.CLAIMS,
    *canonical_tetrahedron.CLAIMS,
    *orderings.CLAIMS,
    *reordered_similarities.CLAIMS,
    *steady_existence.CLAIMS,
    *relative_acceleration.CLAIMS,
    *extrapolation.CLAIMS,
    *path_deviation.CLAIMS,
    *rigid_exponential.CLAIMS,
)
