"""Manifolds: how far an input that should be a rotation, say, is from being one, and what that excuses.

Truth is of the nearest element. A subject may say in its policies instead that it takes a matrix as it is, under "off
the manifold", or "off the manifold of rotations" if that holds for these alone. Then it answers for a matrix that is
known to be a rotation only to within its own distance from them, and is scored at that accuracy: what a perturbation of
that size would do is added to the condition.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from affinecert.magnitude import length, quotient
from affinecert.map import Argument, Array, Manifold, Map
from affinecert.subject import Subject
from affinecert.truths import Truth


def _from_rotations(matrix: Array) -> float:
    """|R^T R - I| / 2 over |I|, of the 3x3 matrix R in the corner: its distance, to first order in it."""
    linear = matrix[:3, :3]
    return length(linear.T @ linear - np.eye(3)) / (2.0 * math.sqrt(3.0))


def _from_similarities(matrix: Array) -> float:
    """The distance from the rotations of the 3x3 matrix in the corner, scaled to |R| = |I|."""
    linear = matrix[:3, :3]
    return _from_rotations(linear * quotient(math.sqrt(3.0), length(linear)))


def _from_symmetric(matrix: Array) -> float:
    """|A - A^T| / 2 over |A|."""
    return quotient(length((matrix - matrix.T) / 2), length(matrix))


DISTANCES: Mapping[Manifold, Callable[[Array], float]] = MappingProxyType(
    {
        "rotations": _from_rotations,
        "similarities": _from_similarities,
        "symmetric matrices": _from_symmetric,
    }
)
"""How far a matrix is from a manifold, relative to its norm."""


def off(argument: Argument) -> str:
    """What policies say it of: "off the manifold of rotations"; nothing where an argument names no manifold."""
    return f"off the manifold of {argument.manifold}" if argument.manifold else ""


def distance(entry: Map, inputs: tuple[Array, ...], policies: Mapping[str, str] | None = None) -> float:
    """The largest distance of the inputs from the manifolds of the map's arguments; 0 where they name none.

    If policies are given, of those arguments alone that are taken as they are.
    """
    with np.errstate(all="ignore"):
        return max(
            (
                found
                for argument, value in zip(entry.arguments, inputs, strict=True)
                if argument.manifold and (policies is None or any(words in off(argument) for words in policies))
                for matrix in value.reshape(-1, *value.shape[-2:])
                if math.isfinite(found := DISTANCES[argument.manifold](matrix))
            ),
            default=0.0,
        )


def slack(entry: Map, inputs: tuple[Array, ...], subject: Subject) -> float:
    """How many u the input may be off for the subject, at least 1: its distance, where it is taken as it is."""
    return max(1.0, distance(entry, inputs, subject.policies) / subject.arithmetic.unit)


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
