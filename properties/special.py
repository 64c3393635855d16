"""Strategies for maps with a property that a law is about: rigid, volume kept, one component, close to the border."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from affinecert.draw import Draw
from affinecert.map import Array
from affinecert.properties.strategies import drawn, poses, shears
from affinecert.sampling import homogeneous, quarter_turns, vector

CANONICAL = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
"""The canonical tetrahedron of bansal_tatu, section 3, a vertex a row."""

ROUNDED = 2.0**-50
"""|R^T R - I| of a rotation whose nine entries are rounded, each by 2^-53 or less, is below 2 sqrt(3) 3 / 2 of that."""


def is_rigid(pose: Array) -> bool:
    """Whether the linear part is a rotation up to the rounding of its entries."""
    linear = pose[:-1, :-1]
    return float(np.linalg.norm(linear.T @ linear - np.eye(len(linear)))) <= ROUNDED


def _planar_pose(draw: Draw) -> Array:
    gap = draw.choice((1.0, -1.0)) * draw.exponent(-17, 0.49)
    turn = draw.choice((1.0, -1.0))
    cosine, sine = turn * math.cos(gap), turn * math.sin(gap)
    return homogeneous(np.array([[cosine, -sine], [sine, cosine]]), vector(draw, -8, 8, 2))


def rigid_maps(dimension: int) -> SearchStrategy[Array]:
    """Rigid motions, homogeneous, to within the rounding of their entries; angles at any distance to 0 and pi."""
    return drawn(_planar_pose) if dimension == 2 else poses().filter(is_rigid)


def _elementary(draw: Draw, size: int) -> Array:
    """A shear by a small whole number along one axis, or a quarter turn in two of them; an integer matrix of det 1."""
    first, second = draw.choice([(i, j) for i in range(size) for j in range(size) if i != j])
    matrix = np.eye(size)
    if draw.choice((True, False)):
        matrix[first, second] = draw.choice((1.0, -1.0, 2.0, -2.0))
    else:
        matrix[[first, second]] = matrix[[second, first]] * np.array([[1.0], [-1.0]])
    return matrix


def _unimodular(draw: Draw, size: int) -> Array:
    matrix = np.eye(size)
    for _ in range(draw.choice(range(5))):
        matrix = matrix @ _elementary(draw, size)
    return matrix


def _volume_keeping(draw: Draw, size: int) -> Array:
    squeeze = np.ones(size)
    squeeze[0] = 2.0 ** draw.choice(range(-8, 9))
    squeeze[-1] /= squeeze[0]
    linear = _unimodular(draw, size) @ np.diag(squeeze) @ _unimodular(draw, size)
    return homogeneous(linear, vector(draw, -3, 3, size))


def volume_keeping_maps(dimension: int) -> SearchStrategy[Array]:
    """Affine maps, homogeneous, whose determinant is exactly 1: products of integer shears and of powers of two."""
    return drawn(lambda draw: _volume_keeping(draw, dimension))


def _frame(draw: Draw, size: int) -> Array:
    powers = 2.0 ** np.array([draw.choice(range(-3, 4)) for _ in range(size)])
    translation = np.array([float(draw.choice(range(-4, 5))) for _ in range(size)])
    return homogeneous(_unimodular(draw, size) @ np.diag(powers), translation)


def with_frame(arguments: SearchStrategy[tuple[Array, ...]]) -> SearchStrategy[tuple[Array, ...]]:
    """The arguments of a map, the first a homogeneous matrix, and a change of frame with few bits and det > 0."""
    return arguments.flatmap(lambda given: drawn(lambda draw: (*given, _frame(draw, len(given[0]) - 1))))


def with_quarter_turns(matrices: SearchStrategy[Array]) -> SearchStrategy[tuple[Array, ...]]:
    """A linear map, and two rotations of its size with entries 0 and +-1."""

    def turns(draw: Draw, matrix: Array) -> tuple[Array, ...]:
        options = quarter_turns(len(matrix))
        return matrix, draw.choice(options), draw.choice(options)

    return matrices.flatmap(lambda matrix: drawn(lambda draw: turns(draw, matrix)))


def _scaling(draw: Draw) -> float:
    return draw.choice((1.0, 2.0, 0.5)) * draw.exponent(-3, 3)


@st.composite
def one_component_maps(draw: st.DrawFn) -> Array:
    """Affine maps of space, homogeneous: a shear, a scaling, a rigid motion, or a shear times a scaling."""
    kind = draw(st.sampled_from(("A", "S", "E", "A S")))
    if kind == "E":
        return draw(rigid_maps(3))
    linear = draw(shears()) if "A" in kind else np.eye(3)
    scale = draw(drawn(_scaling)) if "S" in kind else 1.0
    return homogeneous(scale * linear, np.zeros(3))


def _near_the_border(draw: Draw) -> Array:
    """A map r R(a) R(-c) diag(1/s, s) R(c), |a| at any distance to pi/2 + 2 arctan s, within or beyond."""
    s = 1.0 - draw.exponent(-8, 0) if draw.choice((True, False)) else draw.exponent(-8, 0)
    angle = draw.choice((1.0, -1.0)) * (
        math.pi / 2 + 2 * math.atan(s) + draw.choice((1.0, -1.0)) * draw.exponent(-17, 0)
    )
    axis = draw.uniform(-math.pi, math.pi)
    stretch = _turn(-axis) @ np.diag([1 / max(s, 1e-8), max(s, 1e-8)]) @ _turn(axis)
    return homogeneous(_scaling(draw) * _turn(angle) @ stretch, np.zeros(2))


def _turn(angle: float) -> Array:
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([[cosine, -sine], [sine, cosine]])


def near_the_border() -> SearchStrategy[Array]:
    """Affine maps of the plane, homogeneous, at any distance to the border of those with a real logarithm."""
    return drawn(_near_the_border)
