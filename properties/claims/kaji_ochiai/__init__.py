"""Kaji and Ochiai, A concise parametrisation of affine transformation: its claims, in the order of the paper."""

from __future__ import annotations

from types import ModuleType

from affinecert.properties.claims.kaji_ochiai import (
    blending,
    comparison,
    drawbacks,
    float_accuracy,
    interpolation_polynomials,
    lie_groups,
    matrix_functions,
    other_parametrisations,
    parametrisation,
    plane_example,
    polar_factors,
    precursors,
    rodrigues,
    round_trips,
    shape_blending,
    shifted_polynomials,
    smoothness,
    subspaces,
    symmetric_exponential,
    symmetric_logarithm,
    whole_turns,
)

CHAPTERS: tuple[ModuleType, ...] = (
    plane_example,
    other_parametrisations,
    parametrisation,
    polar_factors,
    smoothness,
    subspaces,
    rodrigues,
    symmetric_exponential,
    symmetric_logarithm,
    whole_turns,
    float_accuracy,
    round_trips,
    blending,
    shape_blending,
    precursors,
    lie_groups,
    drawbacks,
    comparison,
    matrix_functions,
    interpolation_polynomials,
    shifted_polynomials,
)
