"""Gallier, Allen-Blanchette and Leonardos, Motion Interpolation in SIM(3): its claims, in the order of the paper."""

from __future__ import annotations

from typing import Any

from affinecert.properties.claims.claim import Claim
from affinecert.properties.claims.gallier import (
    block_exponential,
    crossing_identity,
    crossing_pi,
    curve_length,
    examples,
    exponential_proof,
    half_turns,
    inverse_of_v,
    invertibility_of_v,
    logarithm_sequences,
    minimal_length,
    rotation_logarithms,
    similarities,
    similarity_exponential,
    spliced_motion,
    spline_points,
    strategy_1,
    strategy_2,
    surjectivity,
)

CLAIMS: tuple[Claim[Any, Any], ...] = (
    *similarities.CLAIMS,
    *block_exponential.CLAIMS,
    *similarity_exponential.CLAIMS,
    *exponential_proof.CLAIMS,
    *invertibility_of_v.CLAIMS,
    *surjectivity.CLAIMS,
    *rotation_logarithms.CLAIMS,
    *half_turns.CLAIMS,
    *inverse_of_v.CLAIMS,
    *crossing_pi.CLAIMS,
    *minimal_length.CLAIMS,
    *strategy_1.CLAIMS,
    *logarithm_sequences.CLAIMS,
    *strategy_2.CLAIMS,
    *crossing_identity.CLAIMS,
    *spliced_motion.CLAIMS,
    *spline_points.CLAIMS,
    *examples.CLAIMS,
    *curve_length.CLAIMS,
)
