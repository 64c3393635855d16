"""Kaji and Ochiai, A concise parametrisation of affine transformation: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.kaji_ochiai import (
    applications,
    drawbacks,
    float_accuracy,
    interpolation_polynomials,
    other_parametrisations,
    parametrisation,
    plane_example,
    precursors,
    rodrigues,
    subspaces,
    symmetric_functions,
)

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *plane_example.CLAIMS,
    *other_parametrisations.CLAIMS,
    *parametrisation.CLAIMS,
    *subspaces.CLAIMS,
    *rodrigues.CLAIMS,
    *symmetric_functions.CLAIMS,
    *float_accuracy.CLAIMS,
    *applications.CLAIMS,
    *precursors.CLAIMS,
    *drawbacks.CLAIMS,
    *interpolation_polynomials.CLAIMS,
)
