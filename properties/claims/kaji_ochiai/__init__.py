"""Kaji and Ochiai, A concise parametrisation of affine transformation: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.kaji_ochiai import (
    blending,
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

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *plane_example.CLAIMS,
    *other_parametrisations.CLAIMS,
    *parametrisation.CLAIMS,
    *polar_factors.CLAIMS,
    *smoothness.CLAIMS,
    *subspaces.CLAIMS,
    *rodrigues.CLAIMS,
    *symmetric_exponential.CLAIMS,
    *symmetric_logarithm.CLAIMS,
    *whole_turns.CLAIMS,
    *float_accuracy.CLAIMS,
    *round_trips.CLAIMS,
    *blending.CLAIMS,
    *shape_blending.CLAIMS,
    *precursors.CLAIMS,
    *lie_groups.CLAIMS,
    *drawbacks.CLAIMS,
    *matrix_functions.CLAIMS,
    *interpolation_polynomials.CLAIMS,
    *shifted_polynomials.CLAIMS,
)
