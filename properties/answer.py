"""What a subject gave, and how large an error each part of it may have."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from affinecert.catalogue.parts import LINEAR, TRANSLATION
from affinecert.map import Array
from affinecert.properties.inexact import CTX, Affine, Inexact, determinant, exact, norm, real
from affinecert.properties.law import BadAnswer

ROUNDINGS = 16 * 2.0**-53
"""What an entry that is due to be 0 or 1 may be off by: as much as a score allows, and no more than rounding."""


@dataclass(frozen=True)
class Answer:
    """An array of float64, and by name its parts: where each is, and the norm of the error that it may have."""

    array: Array
    parts: Mapping[str, tuple[Any, Any]]

    def __getitem__(self, part: str) -> Inexact:
        where, error = self.parts[part]
        return Inexact(exact(self.array[where]), error)

    @property
    def whole(self) -> Inexact:
        """The array with all of its parts together, a scalar as (1, 1)."""
        error = CTX.norm([error for _, error in self.parts.values()])
        return Inexact(exact(np.atleast_2d(self.array)), error)

    @property
    def affine(self) -> Affine:
        """The affine map that a homogeneous matrix stands for; BadAnswer if it does not end in 0 ... 0 1."""
        if not np.max(np.abs(self.array[-1] - np.eye(len(self.array))[-1])) <= ROUNDINGS:
            raise BadAnswer(f"the last row is {self.array[-1].tolist()}")
        linear = "rotation" if "rotation" in self.parts else "linear"
        return Affine(self[linear], self["translation"])


def rounded(value: Inexact, name: str) -> Answer:
    """An array of rationals as float64, to be an argument; the rounding is added to its error."""
    array = np.asarray(value.value, dtype=np.float64)
    return Answer(array, {name: (..., value.error + norm(exact(array) - value.value))})


def rounded_affine(value: Affine) -> Answer:
    """A homogeneous matrix as float64, likewise."""
    linear, translation = rounded(value.linear, "linear"), rounded(value.translation, "translation")
    matrix = np.eye(len(translation.array) + 1)
    matrix[LINEAR], matrix[TRANSLATION] = linear.array, translation.array
    errors = linear.parts["linear"][1], translation.parts["translation"][1]
    return Answer(matrix, {"linear": (LINEAR, errors[0]), "translation": (TRANSLATION, errors[1])})


def near_rotation(matrix: Array) -> Answer:
    """A matrix that stands for the nearest rotation, which is |R^T R - I| / 2 away, to first order."""
    value = exact(matrix)
    defect = norm(value.T @ value - exact(np.eye(len(matrix))))
    return Answer(matrix, {"rotation": (..., defect / 2)})


def near_similarity(pose: Array) -> Answer:
    """A homogeneous matrix whose linear part L stands for the multiple of a rotation with its determinant.

    That is |L^T L - s^2 I| / (2 s) away, to first order, s the cube root of the determinant.
    """
    value = exact(pose[LINEAR])
    scale = CTX.cbrt(real(determinant(value)))
    square = scale * scale
    gram = value.T @ value
    defect = CTX.norm([real(gram[i, j]) - (square if i == j else 0) for i, j in np.ndindex(3, 3)])
    return Answer(pose, {"linear": (LINEAR, defect / (2 * scale)), "translation": (TRANSLATION, CTX.zero)})


def near_rigid(pose: Array) -> Answer:
    """A homogeneous matrix whose linear part stands for the nearest rotation."""
    _, error = near_rotation(pose[LINEAR]).parts["rotation"]
    return Answer(pose, {"rotation": (LINEAR, error), "translation": (TRANSLATION, CTX.zero)})


def near_symmetric(matrix: Array, name: str) -> Answer:
    """A matrix that stands for its symmetric part, as the part of that name."""
    value = exact(matrix)
    return rounded(Inexact((value + value.T) / 2), name)
