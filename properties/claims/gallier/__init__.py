"""Gallier, Allen-Blanchette and Leonardos, Motion Interpolation in SIM(3): its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.gallier import (
    crossing_pi,
    curve_length,
    exponential_proof,
    invertibility_of_v,
    rotation_logarithms,
    similarities,
    similarity_exponential,
    spliced_motion,
    strategies,
    strategy_2,
    surjectivity,
)

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *similarities.CLAIMS,
    *similarity_exponential.CLAIMS,
    *exponential_proof.CLAIMS,
    *invertibility_of_v.CLAIMS,
    *surjectivity.CLAIMS,
    *rotation_logarithms.CLAIMS,
    *crossing_pi.CLAIMS,
    *strategies.CLAIMS,
    *strategy_2.CLAIMS,
    *spliced_motion.CLAIMS,
    *curve_length.CLAIMS,
)
