"""Kaji et al., Mathematical Analysis on Affine Maps for 2D Shape Interpolation: its claims, in order."""

from __future__ import annotations

from types import ModuleType

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

CHAPTERS: tuple[ModuleType, ...] = (
    affine_maps,
    homotopies,
    degeneration,
    non_degeneracy,
    wishes,
    definiteness,
    minimisers,
    points,
    figures,
    constraints,
    improvements,
    prospects,
    singular_values,
    errors,
    quadratic_form,
)
