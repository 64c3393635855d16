"""The errors of a moved mesh of the plane against the homotopies of its triangles, as Hermitian forms."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from affinecert.fast import _homotopy
from affinecert.fast._homotopy import ONE, Factors, Growth, complex_product, conjugate, real_multiple
from affinecert.fast._kernel import Array
from affinecert.fast._mesh_gradient import gradient
from affinecert.fast._stages import run
from affinecert.fast._triangulation import Indices, coherent_turns
from affinecert.fast._wide import add, divide, subtract, times, widen
from affinecert.fast._wide_rotation import TWO_PI

Goal = tuple[Array, Array]
"""The linear maps z -> a z + b conj(z) of all triangles: a and b, complex numbers of pairs (faces, 2, 2)."""

GROWTHS: Mapping[str, Callable[[Factors, Array], Growth] | None] = MappingProxyType(
    {"linear": None, "polar": _homotopy.linear, "exponential": _homotopy.exponential}
)
"""How S grows in each homotopy; A^L does without S."""


# Errors of inner products of edges in pairs are below 2^-100 of the product of their lengths.
NEARLY_PI = 2.0**-96


@dataclass(frozen=True)
class Homotopies:
    """The maps A of the triangles from source to target, and how they grow."""

    whole: Goal
    factors: Factors
    grow: Callable[[Factors, Array], Growth] | None

    def at(self, t: Array, turned: bool = True) -> Goal:
        """A(t) for a pair t; if not ``turned``, but for a rotation from the left."""
        if self.grow is None:
            a, b = (real_multiple(number, t) for number in self.whole)
            return add(np.stack([subtract(ONE, t), np.zeros(2)]), a), b
        growth = self.grow(self.factors, t)
        if turned:
            return _homotopy.turned(self.factors, growth, t)
        unturned = np.stack([growth.scale, np.zeros_like(growth.scale)], axis=-2)
        return unturned, real_multiple(self.factors.slope, growth.ratio)


def homotopies(
    source: Array, target: Array, triangles: Indices, areas: tuple[Array, Array], name: str, coherent: bool
) -> Homotopies:
    """The homotopies of that name; ``areas`` are twice the signed areas in source and target, pairs (faces, 2).

    For edges e, g in the source and x, y in the target, a = (y e* - x g*) / (2 i D) and b = (x g - y e) / (2 i D).
    """
    (e, g), (x, y) = _edges(source, triangles), _edges(target, triangles)
    numerators = (
        subtract(complex_product(y, conjugate(e)), complex_product(x, conjugate(g))),
        subtract(complex_product(x, g), complex_product(y, e)),
    )
    doubled = 2.0 * areas[0][:, None, :]
    _settle_half_turns(numerators[0], areas[0], source, target, triangles)
    a, b = (divide(np.stack([n[:, 1], -n[:, 0]], axis=-2), doubled) for n in numerators)
    factors = _homotopy.factors(a, b, divide(areas[1], areas[0]))
    if coherent:
        turns = coherent_turns(factors.angle[:, 0], triangles)
        factors = factors._replace(angle=add(factors.angle, times(TWO_PI, turns)))
    return Homotopies((a, b), factors, GROWTHS[name])


def _settle_half_turns(numerators: Array, areas: Array, source: Array, target: Array, triangles: Indices) -> None:
    """Decides exactly to which side of pi triangles turn whose ``numerators`` 2 i D a are negative multiples of i D.

    The real part of (y e* - x g*) is a difference of inner products, mostly exact, and 0 for turns by pi.
    """
    real, imaginary = numerators[:, 0, 0], numerators[:, 1, 0]
    doubtful = (np.abs(real) <= NEARLY_PI * np.abs(imaginary)) & (real != 0.0) & (imaginary * areas[:, 0] < 0.0)
    for face in np.flatnonzero(doubtful):
        (e, g), (x, y) = (_exact_edges(shape[triangles[face]]) for shape in (source, target))
        exact = sum(p * q for p, q in zip(y, e, strict=True)) - sum(p * q for p, q in zip(x, g, strict=True))
        high = float(exact)
        numerators[face, 0] = high, float(exact - Fraction(high))


def _exact_edges(corners: Array) -> list[list[Fraction]]:
    first, *others = ([Fraction(x) for x in corner] for corner in corners.tolist())
    return [[x - y for x, y in zip(other, first, strict=True)] for other in others]


def _edges(vertices: Array, triangles: Indices) -> tuple[Array, Array]:
    """The edges from the first vertex of each triangle to the others."""
    first, second, third = (widen(vertices[triangles[:, k]]) for k in range(3))
    return subtract(second, first), subtract(third, first)


@dataclass(frozen=True)
class Errors:
    """The sum over triangles of w E^F + w' E, E being E^R or, ``by_points``, E^S.

    ``source`` (vertices, 2), ``triangles`` (faces, 3), and ``weights``, the pairs w and w' of each, (faces, 2, 2).
    """

    source: Array
    triangles: Indices
    weights: Array
    by_points: bool

    @property
    def directly(self) -> bool:
        """Whether E^F is in it."""
        return bool(self.weights[:, 0].any())

    @property
    def by_similarity(self) -> bool:
        """Whether E^R or E^S is in it."""
        return bool(self.weights[:, 1].any())

    @cached_property
    def numbers(self) -> Array:
        """The indices as float64."""
        return self.triangles.astype(np.float64)

    def slope(self, goal: Goal, moved: Array) -> Array:
        """Half the gradient, downwards, at the vertices ``moved``, pairs (vertices, 2, 2)."""
        return run(gradient, self.source, self.numbers, *goal, self.weights, np.array(float(self.by_points)), moved)[0]

    def blocks(self, goal: Goal) -> NDArray[np.complex128]:
        """The matrix of the errors between the vertices of each triangle, (faces, 3, 3), in float64.

        As `affinecert.fast._mesh_gradient` has it: coefficients of alpha' in v are those of beta' conjugated.
        """
        corners = self.source[self.triangles] @ np.array([1.0, 1j])
        e, g = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        beta = np.stack([e - g, g, -e], axis=-1)
        twice_area = (np.conj(e) * g).imag
        square = 2.0 * twice_area**2
        direct, similar = self.weights[:, 0, 0], self.weights[:, 1, 0]
        matrix = (direct / square)[:, None, None] * 2.0 * (np.conj(beta)[:, :, None] * beta[:, None, :]).real
        if self.by_similarity:
            a, b = (2.0 * twice_area * (number[..., 0] @ np.array([1.0, 1j])) for number in goal)
            # a' and b', both divided by -i.
            if self.by_points:
                size = sum(np.abs(a * edge + b * np.conj(edge)) ** 2 for edge in (e, g, g - e))
            else:
                size = square * (np.abs(a) ** 2 + np.abs(b) ** 2)
            spanned = a[:, None] * beta + b[:, None] * np.conj(beta)
            matrix = matrix + (similar / size)[:, None, None] * np.conj(spanned)[:, :, None] * spanned[:, None, :]
        return np.asarray(matrix, dtype=np.complex128)
