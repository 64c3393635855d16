"""Gallier, Allen-Blanchette and Leonardos, Motion Interpolation in SIM(3): its claims, in the order of the paper."""

from __future__ import annotations

from types import ModuleType

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
    splicing_conditions,
    splicing_matrices,
    splicing_three_points,
    spline_points,
    strategy_1,
    strategy_2,
    surjectivity,
)

CHAPTERS: tuple[ModuleType, ...] = (
    similarities,
    block_exponential,
    similarity_exponential,
    exponential_proof,
    invertibility_of_v,
    surjectivity,
    rotation_logarithms,
    half_turns,
    inverse_of_v,
    crossing_pi,
    minimal_length,
    strategy_1,
    logarithm_sequences,
    strategy_2,
    crossing_identity,
    spliced_motion,
    spline_points,
    examples,
    splicing_conditions,
    splicing_three_points,
    splicing_matrices,
    curve_length,
)
