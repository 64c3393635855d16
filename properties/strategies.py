"""Hypothesis strategies for the inputs of affine interpolation, dense where code goes wrong; public.

Every regime of the catalogue is a strategy (`regime`, `inputs`), since a regime is a function of a `Draw` and
`HypothesisDraw` is one that Hypothesis can shrink. Distances to singular sets are drawn by their exponent. A strategy
of several arguments gives a tuple of float64 arrays, one that is named after a thing gives that thing.

    from hypothesis import given
    from affinecert.properties import strategies

    @given(strategies.poses())
    def test_my_logarithm(pose): ...
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from affinecert.catalogue import find
from affinecert.errors import UnknownNameError
from affinecert.map import Array

T = TypeVar("T")

DIGITS = (0, 1, 3, 15)
"""How many decimals a drawn number has: shrinking drops to the fewest; 15 fill the mantissa of a float64."""


class HypothesisDraw:
    """A `Draw` whose numbers come from Hypothesis; what it draws shrinks to what is easily read."""

    def __init__(self, draw: st.DrawFn) -> None:
        self._draw = draw

    def uniform(self, low: float, high: float) -> float:
        """A number in [low, high], a decimal of few digits; it shrinks to the roundest and smallest."""
        digits = self._draw(st.sampled_from(DIGITS))
        step = 10.0**-digits
        first, last = math.ceil(low / step), math.floor(high / step)
        if first > last:
            fraction = self._draw(st.integers(0, 10**15)) / 10**15
            return low + (high - low) * fraction
        number = float(f"{self._draw(st.integers(first, last))}e-{digits}")
        return min(max(number, low), high)

    def exponent(self, low: float, high: float) -> float:
        """A positive number from 10**low to 10**high; it shrinks to the power of ten nearest to 1."""
        first, last = math.ceil(low), math.floor(high)
        if first > last:
            return float(10.0 ** self.uniform(low, high))
        power = self._draw(st.integers(first, last))
        digits = self._draw(st.sampled_from(DIGITS))
        leading = 10**digits + self._draw(st.integers(0, 9 * 10**digits - 1))
        number = float(f"{leading}e{power - digits}")
        return number if number <= 10.0**high else float(f"1e{power}")

    def choice(self, options: Sequence[T]) -> T:
        """One of the options; it shrinks to the first."""
        return self._draw(st.sampled_from(options))

    def direction(self, size: int) -> Array:
        """A unit vector (size,); it shrinks to the first coordinate axis."""
        if self._draw(st.integers(0, 2)) == 0:
            axis = np.eye(size)[self._draw(st.integers(0, size - 1))]
            return np.asarray(-axis if self._draw(st.booleans()) else axis)
        vector = np.array([self.uniform(-1.0, 1.0) for _ in range(size)])
        length = float(np.linalg.norm(vector))
        return np.asarray(np.eye(size)[0] if length == 0.0 else vector / length)


def regime(map_name: str, regime_name: str) -> SearchStrategy[tuple[Array, ...]]:
    """Inputs of a map out of one of its regimes; UnknownNameError if there is no such map or regime."""
    found = {each.name: each for each in find(map_name).regimes}
    if regime_name not in found:
        raise UnknownNameError(f"regime of {map_name}", regime_name, found)
    build = found[regime_name].build
    return drawn(lambda draw: build(draw).inputs)


def inputs(map_name: str) -> SearchStrategy[tuple[Array, ...]]:
    """Inputs of a map out of any of its regimes."""
    return st.one_of([regime(map_name, each.name) for each in find(map_name).regimes])


def drawn(build: Callable[[HypothesisDraw], T]) -> SearchStrategy[T]:
    """The strategy of what ``build`` makes from a draw."""
    strategy: SearchStrategy[T] = _built(build)
    return strategy


@st.composite
def _built(draw: st.DrawFn, build: Callable[[HypothesisDraw], Any]) -> Any:
    # Once for all: Hypothesis reads the source of whatever is made composite, half a second for that of the laws.
    return build(HypothesisDraw(draw))


def _first(map_name: str) -> SearchStrategy[Array]:
    return inputs(map_name).map(lambda arguments: arguments[0])


def rotation_vectors() -> SearchStrategy[Array]:
    """Rotation vectors (3,): angles at any distance to 0 and to multiples of pi, and large ones."""
    return _first("so3.exp")


def rotations() -> SearchStrategy[Array]:
    """Rotation matrices (3, 3), off the manifold by their rounding, at any distance to angles 0 and pi."""
    return _first("so3.log")


def twists() -> SearchStrategy[Array]:
    """Twists (6,) = (omega, v)."""
    return _first("se3.exp")


def poses() -> SearchStrategy[Array]:
    """Rigid poses (4, 4), rotation part as in `rotations`."""
    return _first("se3.log")


def tangents() -> SearchStrategy[Array]:
    """Elements (7,) = (omega, v, lambda) of sim(3), angle and growth at any distance to 0 and to each other."""
    return _first("sim3.exp")


def similarities() -> SearchStrategy[Array]:
    """Similarities (4, 4), angle and growth as in `tangents`; off the manifold by rounding, or by up to 1e-7."""
    return _first("sim3.log")


def shear_twists() -> SearchStrategy[Array]:
    """Elements (5,) of the Lie algebra of G_A, eigenvalues at any distance to each other and to 0."""
    return _first("shear.exp")


def shears() -> SearchStrategy[Array]:
    """Elements (3, 3) of G_A, eigenvalues at any distance to each other and to 1."""
    return _first("shear.log")


def symmetric_matrices() -> SearchStrategy[Array]:
    """Symmetric matrices (3, 3), eigenvalues at any distance to each other and to 0."""
    return _first("sym3.exp")


def stretches() -> SearchStrategy[Array]:
    """Symmetric positive definite matrices (3, 3), eigenvalues at any distance and in any ratio to each other."""
    return _first("sym3.log")


def linear_maps() -> SearchStrategy[Array]:
    """Linear maps (2, 2) and (3, 3) of positive determinant, singular values at any distance to each other and to 0."""
    return _first("polar.decompose")


def scales() -> SearchStrategy[Array]:
    """Positive scale factors, 0-d."""
    return _first("scale.log")


def log_scales() -> SearchStrategy[Array]:
    """Logarithms of scale factors, 0-d."""
    return _first("scale.exp")


def tetrahedra() -> SearchStrategy[Array]:
    """Tetrahedra (4, 3), a vertex a row, oriented as the canonical one, at any distance to being flat."""
    return _first("affine_lie.represent")


def affine_maps(dimension: int | None = None) -> SearchStrategy[Array]:
    """Affine maps, homogeneous, of the plane (2), of space (3) or of either; some of them without a real logarithm.

    Their eigenvalues are at any distance to each other, to 1 and to the negative axis; in space some are near rigid
    ones, thin, or of rows of very different sizes.
    """
    steady = _first("sam.log")
    if dimension is None:
        return steady
    of_dimension = steady.filter(lambda matrix: len(matrix) == dimension + 1)
    return of_dimension if dimension == 2 else _first("affine_lie.decompose") | of_dimension


def _time(draw: HypothesisDraw) -> Array:
    kind = draw.choice(("inside", "outside", "near an end"))
    if kind == "inside":
        return np.array(draw.uniform(0.0, 1.0))
    if kind == "outside":
        return np.array(draw.uniform(-2.0, 3.0))
    end, away = draw.choice((0.0, 1.0)), draw.exponent(-17, -1)
    return np.array(end + draw.choice((away, -away)))


def times() -> SearchStrategy[Array]:
    """Times, 0-d: in [0, 1], at any distance to its ends, and outside, where interpolation extrapolates."""
    return drawn(_time)


def inner_times() -> SearchStrategy[Array]:
    """Times, 0-d, in [0, 1]."""
    return times().map(lambda time: np.clip(time, 0.0, 1.0))
