"""Kaji et al., Mathematical Analysis on Affine Maps for 2D Shape Interpolation: its claims, in order."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.kaji_2d import (
    affine_maps,
    constraints,
    definiteness,
    degeneration,
    errors,
    figures,
    homotopies,
    improvements,
    minimisers,
    non_degeneracy,
    points,
    prospects,
    quadratic_form,
    singular_values,
    wishes,
)

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *affine_maps.CLAIMS,
    *homotopies.CLAIMS,
    *degeneration.CLAIMS,
    *non_degeneracy.CLAIMS,
    *wishes.CLAIMS,
    *definiteness.CLAIMS,
    *minimisers.CLAIMS,
    *points.CLAIMS,
    *figures.CLAIMS,
    *constraints.CLAIMS,
    *improvements.CLAIMS,
    *prospects.CLAIMS,
    *singular_values.CLAIMS,
    *errors.CLAIMS,
    *quadratic_form.CLAIMS,
)
