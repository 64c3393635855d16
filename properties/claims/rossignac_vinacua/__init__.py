"""Rossignac and Vinacua, Steady Affine Motions and Morphs: its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.rossignac_vinacua import (
    conclusions,
    cubic_bezier,
    linear_problem,
    patches,
    patterns,
    plane_algorithm,
    plane_cases,
    plane_exponential,
    plane_logarithm,
    plane_negative,
    plane_singular,
    predictions,
    space,
    space_singular,
    subdivision,
    sweeps,
    swept_region,
)

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *patterns.CLAIMS,
    *sweeps.CLAIMS,
    *swept_region.CLAIMS,
    *patches.CLAIMS,
    *cubic_bezier.CLAIMS,
    *predictions.CLAIMS,
    *subdivision.CLAIMS,
    *conclusions.CLAIMS,
    *linear_problem.CLAIMS,
    *plane_exponential.CLAIMS,
    *plane_logarithm.CLAIMS,
    *plane_cases.CLAIMS,
    *plane_negative.CLAIMS,
    *plane_singular.CLAIMS,
    *plane_algorithm.CLAIMS,
    *space.CLAIMS,
    *space_singular.CLAIMS,
)
