"""Manifolds: how far an input that should be a rotation, or a multiple of one, is from being it.

Truth is of the nearest rotation. A subject may say instead that it takes a matrix as it is, under the key `AS_IT_IS`
of its policies. Then it answers for a matrix that is only known to be a rotation to within the input's own distance
from them, and is scored at that accuracy: what a perturbation of that size would do is added to the condition.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from affinecert.map import Array, Manifold, Map
from affinecert.scoring import length
from affinecert.subject import Subject
from affinecert.truths import Truth

AS_IT_IS = "off the manifold"
"""The key in `Subject.policies` of those that take matrices as they are."""

FREE_SCALE: Mapping[Manifold, bool] = MappingProxyType({"rotations": False, "similarities": True})
"""Whether the size of a linear part is free, by the manifold that an argument names."""


def distance(entry: Map, inputs: tuple[Array, ...]) -> float:
    """The largest distance of the inputs from the manifolds that the map's arguments name, relative to their norms.

    0 where an argument names none. To first order in it: |R^T R - I| / 2 for a matrix R, in the Frobenius norm, over
    |I|; for a similarity R is scaled to |R| = |I|.
    """
    return max(
        (
            _defect(linear, FREE_SCALE[argument.manifold])
            for argument, value in zip(entry.arguments, inputs, strict=True)
            if argument.manifold is not None
            for linear in value[..., :3, :3].reshape(-1, 3, 3)
        ),
        default=0.0,
    )


def _defect(linear: Array, free_scale: bool) -> float:
    size = math.sqrt(3.0)
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = linear * (size / length(linear)) if free_scale and length(linear) > 0 else linear
        defect = length(scaled.T @ scaled - np.eye(3)) / (2.0 * size)
    return defect if math.isfinite(defect) else 0.0


def slack(entry: Map, inputs: tuple[Array, ...], subject: Subject) -> float:
    """How many u the input may be off for the subject, at least 1: its distance, if the subject takes it as it is."""
    if AS_IT_IS not in subject.policies:
        return 1.0
    return max(1.0, distance(entry, inputs) / subject.arithmetic.unit)


def loosened(entry: Map, truth: Truth, slack: float, smallest: float) -> Truth:
    """The truth, with sensitivities to perturbations of ``slack`` u; sizes below ``smallest`` count as that.

    Where an error of |value| + sensitivity in u was allowed, times the map's bound, it is now ``slack`` times that.
    """
    if slack == 1.0 or truth.refusal is not None:
        return truth
    sizes = (max(length(truth.high[block.output][block.where]), smallest) for block in entry.blocks)
    return replace(
        truth,
        sensitivity=tuple(
            min(slack * k + (slack - 1.0) * size, sys.float_info.max)
            for k, size in zip(truth.sensitivity, sizes, strict=True)
        ),
    )
