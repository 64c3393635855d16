"""Classes of affine maps are linear subspaces of the twelve parameters: blends and splines of a class stay in it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from affinecert.catalogue import stretches, turns
from affinecert.catalogue.kaji_ochiai import parameters
from affinecert.draw import Draw
from affinecert.map import Array
from affinecert.properties.answer import Answer
from affinecert.properties.answers import Maps, ask
from affinecert.properties.inexact import Inexact, exact
from affinecert.properties.law import Law
from affinecert.properties.strategies import drawn
from affinecert.sampling import homogeneous, scalar, vector

NONE, UNIFORM, ANY = "none", "uniform", "any"
"""How a class may stretch."""

COUNT = 2
"""Poses that are blended, or interpolated."""


@dataclass(frozen=True)
class Subclass:
    """A class of affine maps, by what its members may do: move the origin, turn, stretch."""

    name: str
    moves: bool
    turns: bool
    stretch: str


SUBCLASSES = (
    Subclass("SE(3)", True, True, NONE),
    Subclass("SO(3)", False, True, NONE),
    Subclass("Sim+(3)", True, True, UNIFORM),
    Subclass("CO+(3)", False, True, UNIFORM),
    Subclass("GL+(3)", False, True, ANY),
    Subclass("Sym+(3)", False, False, ANY),
    Subclass("R^3", True, False, NONE),
    Subclass("R+", False, False, UNIFORM),
)
"""Those of section 3; a law's first input is the number of one."""


def _turn(draw: Draw, subclass: Subclass) -> turns.Turn:
    kinds = (turns.GENERIC, turns.NEAR_IDENTITY, turns.COORDINATE_AXIS, turns.NEAR_PI)
    return draw.choice(kinds).build(draw) if subclass.turns else turns.about(np.eye(3)[2], 0.0, 0.0)


def _translation(draw: Draw, subclass: Subclass) -> Array:
    return vector(draw) if subclass.moves else np.zeros(3)


def _member(draw: Draw, subclass: Subclass) -> Array:
    """An affine map of the class, its rotation rounded."""
    stretch = np.eye(3)
    if subclass.stretch == UNIFORM:
        stretch *= draw.exponent(-3, 3)
    elif subclass.stretch == ANY:
        stretch, _ = draw.choice((stretches.GENERIC, stretches.MEETING, stretches.NEAR_IDENTITY)).build(draw)
    return homogeneous(_turn(draw, subclass).matrix @ stretch, _translation(draw, subclass))


def _parameters_of_member(draw: Draw, subclass: Subclass) -> Array:
    """Parameters of the subspace of a class."""
    logarithm = np.zeros((3, 3))
    if subclass.stretch == UNIFORM:
        logarithm = draw.uniform(-5.0, 5.0) * np.eye(3)
    elif subclass.stretch == ANY:
        logarithm, _ = draw.choice(stretches.SYMMETRIC[:4]).build(draw)
    return parameters(_translation(draw, subclass), _turn(draw, subclass).vector, logarithm)


def _of_some_class(build: Callable[[Draw, Subclass], tuple[Array, ...]]) -> Callable[[Draw], tuple[Array, ...]]:
    """The number of a class, and what is drawn for it."""

    def inputs(draw: Draw) -> tuple[Array, ...]:
        number = draw.choice(range(len(SUBCLASSES)))
        return scalar(float(number)), *build(draw, SUBCLASSES[number])

    return inputs


def _members(draw: Draw, subclass: Subclass) -> Array:
    return np.stack([_member(draw, subclass) for _ in range(COUNT)])


def _blended(draw: Draw, subclass: Subclass) -> tuple[Array, ...]:
    return _members(draw, subclass), np.array([draw.uniform(-1.0, 2.0) for _ in range(COUNT)])


def _interpolated(draw: Draw, subclass: Subclass) -> tuple[Array, ...]:
    knots = np.cumsum([draw.uniform(0.5, 2.0) for _ in range(COUNT)])
    return _members(draw, subclass), knots, scalar(draw.uniform(0.0, 7.0))


def _like(matrix: Inexact, stretch: str) -> float:
    """How far a symmetric matrix is from those of such stretches: the unit matrix, a multiple of it, or any."""
    value, size = matrix.value, len(matrix.value)
    due = {NONE: exact(np.eye(size)), UNIFORM: exact(np.eye(size)) * (np.trace(value) / size), ANY: value.T}[stretch]
    return matrix.misfit(Inexact(due))


def _outside_class(pose: Answer, subclass: Subclass) -> float:
    """How far an affine map is from a class, over what its errors account for."""
    linear = pose.affine.linear
    # What turns is measured by its stretch, L^T L = S^2.
    distance = _like(linear.T @ linear if subclass.turns else linear, subclass.stretch)
    return distance if subclass.moves else max(distance, _nothing(pose.affine.translation))


def _outside_subspace(found: Answer, subclass: Subclass) -> float:
    """How far parameters are from the subspace of a class."""
    y = found["log_stretch"]
    indices = [0, 1, 2, 1, 3, 4, 2, 4, 5]
    logarithm = Inexact(y.value[indices].reshape(3, 3), 2 * y.error)
    distances = [_nothing(logarithm) if subclass.stretch == NONE else _like(logarithm, subclass.stretch)]
    if not subclass.moves:
        distances.append(_nothing(found["translation"]))
    if not subclass.turns:
        distances.append(_nothing(found["rotation_vector"]))
    return max(distances)


def _nothing(vector: Inexact) -> float:
    return vector.misfit(Inexact(0 * vector.value))


def _law(
    name: str,
    statement: str,
    build: Callable[[Draw, Subclass], tuple[Array, ...]],
    outside: Callable[[Answer, Subclass], float] = _outside_class,
) -> Law:
    needed = f"kaji_ochiai.{name}"

    def residual(maps: Maps, number: Array, *inputs: Array) -> float:
        return outside(ask(maps, needed, *inputs), SUBCLASSES[int(number)])

    return Law(
        name=f"subclasses.{name}",
        statement=statement,
        source="kaji_ochiai, sections 1 (V), 3, 5.1 and 5.4",
        domain=", ".join(subclass.name for subclass in SUBCLASSES) + ", to within the rounding of rotations",
        needs=(needed,),
        inputs=drawn(_of_some_class(build)),
        residual=residual,
    )


LAWS = (
    _law(
        "parametrise",
        "the parameters of a member are in the subspace of its class",
        lambda draw, subclass: (_member(draw, subclass),),
        _outside_subspace,
    ),
    _law(
        "realise",
        "phi takes the subspace of a class into the class",
        lambda draw, subclass: (_parameters_of_member(draw, subclass),),
    ),
    _law("blend", "a blend of members is one, whatever the weights", _blended),
    _law("interpolate", "the spline through members is in their class at every time", _interpolated),
)
