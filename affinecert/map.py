"""The vocabulary of the catalogue: Map, and what it is made of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from affinecert.draw import Draw

Array = NDArray[np.float64]

Manifold = Literal["rotations", "similarities", "symmetric matrices"]
"""What a matrix, or its linear part, should be in; a similarity is a positive multiple of a rotation."""


@dataclass(frozen=True)
class Group:
    """Entries of an argument that one perturbation moves together, relative to their norm; or each alone, to itself.

    The condition number of a map is taken against these: ``"norm"`` perturbs the entries at ``where`` as one vector by
    a fraction of its length, ``"entries"`` each entry by a fraction of itself.
    """

    where: Any
    mode: Literal["norm", "entries"] = "norm"


@dataclass(frozen=True)
class Argument:
    """One input of a map.

    A size ``"n"`` in ``shape`` is 3 in the plane and 4 in space (homogeneous matrices), ``"d"`` 2 and 3 (linear ones);
    any other name is a number of things, and may differ from input to input. All cases of a regime have one shape.
    ``manifold`` names the one that the nearest element of counts, where that is so.
    """

    name: str
    shape: tuple[int | str, ...]
    groups: tuple[Group, ...]
    units: str = ""
    manifold: Manifold | None = field(default=None, repr=False)  # truths, stored by what is shown, do not hang on it


@dataclass(frozen=True)
class Block:
    """A part of an output that is scored on its own: entries ``where`` of output number ``output``."""

    name: str
    output: int
    where: Any


@dataclass(frozen=True)
class Point:
    """What a regime builds: the inputs of one case, and its distance to the regime's singular set."""

    inputs: tuple[Array, ...]
    distance: float


@dataclass(frozen=True)
class Regime:
    """A named part of a map's domain; ``build`` makes one input from a `Draw`.

    ``distance`` says what `Point.distance` measures ("angle", "pi - angle", "gap of eigenvalues").
    """

    name: str
    build: Callable[[Draw], Point]
    distance: str
    share: float = 1.0


@dataclass(frozen=True)
class Map:
    """One mathematical function, ``family.name``.

    ``reference(ctx, *inputs)`` takes an mpmath context and object arrays of its mpf, and returns one object array or a
    tuple of them; it raises InputError outside the domain. ``continuation(ctx, base, *inputs)`` is the determination
    nearest to the value ``base`` (given for the logarithms, which jump: their condition is that of the branch).
    ``inverse`` names the map that undoes it, for the backward error and the verdict other-branch. ``accuracy`` is the
    scaled error that `fast` keeps; ``bound`` the one up to which a verdict is ok. ``cost`` is the time of one
    reference evaluation relative to so3.exp. ``remark`` is what a reader of the map's errors should know: how its
    condition is taken where that is not plain, and where `fast` is less accurate and why.
    """

    name: str
    definition: str
    source: str
    domain: str
    arguments: tuple[Argument, ...]
    outputs: tuple[tuple[int | str, ...], ...]
    blocks: tuple[Block, ...]
    regimes: tuple[Regime, ...]
    reference: Callable[..., Any]
    continuation: Callable[..., Any] | None = None
    inverse: str | None = None
    exact: bool = False
    accuracy: float = 4.0
    bound: float = 16.0
    cost: float = 1.0
    remark: str = ""

    @property
    def family(self) -> str:
        """The part of the name before the dot: the module in `reference` and in `fast`."""
        return self.name.partition(".")[0]
