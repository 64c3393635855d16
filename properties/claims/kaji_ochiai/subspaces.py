"""Section 3, condition (V): linear subspaces of the parameters that belong to classes of affine maps."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from affinecert.properties.claims.claim import Claim, Copy, Verdict
from affinecert.properties.claims.draws import arrays, rotations
from affinecert.properties.claims.precision import difference, exactly, mp, size
from affinecert.properties.laws.subclasses import ANY, NONE, SUBCLASSES, UNIFORM, Subclass
from affinecert.reference import kaji_ochiai
from affinecert.reference._matrices import Array, Number, homogeneous, identity

CLASSES = {subclass.name: subclass for subclass in SUBCLASSES}
"""The classes of section 3 by name."""


def members(subclass: Subclass, count: int) -> list[Array]:
    """So many maps of a class, not made by phi."""
    unit, zero = identity(mp, 3), exactly([0, 0, 0])
    found = []
    turns = rotations("turns of members", count)
    for turn, shift, factor in zip(
        turns,
        arrays("shifts of members", count, (3,), -2, 2),
        arrays("factors of members", count, (3, 3), -1, 1),
        strict=True,
    ):
        stretch = {NONE: unit, UNIFORM: unit * (1 + size(factor)), ANY: factor @ factor.T + unit / 4}[subclass.stretch]
        linear = turn @ stretch if subclass.turns else stretch
        found.append(homogeneous(mp, linear, shift if subclass.moves else zero))
    return found


def outside(affine: Array, subclass: Subclass) -> Number:
    """How far a map of positive determinant is from a class."""
    linear = affine[:3, :3]
    # What turns is measured by its stretch, L^T L = S^2.
    measured = linear.T @ linear if subclass.turns else linear
    mean = identity(mp, 3) * (measured.trace() / 3)
    due = {NONE: identity(mp, 3), UNIFORM: mean, ANY: measured.T}[subclass.stretch]
    return max(difference(measured, due), mp.zero if subclass.moves else size(affine[:3, 3]))


def _projected(parameters: Array, subclass: Subclass) -> Array:
    """The nearest parameters in the printed subspace of a class."""
    found = parameters.copy()
    if not subclass.moves:
        found[:3] = mp.zero
    if not subclass.turns:
        found[3:6] = mp.zero
    if subclass.stretch != ANY:
        mean = (found[6] + found[9] + found[11]) / 3 if subclass.stretch == UNIFORM else mp.zero
        found[6:] = exactly([1, 0, 0, 1, 0, 1]) * mean
    return found


def _mismatch(name: str) -> Any:
    """How far phi of a subspace leaves a class, and psi of members the subspace."""

    def deviation(space: Subclass, case: tuple[Array, Array]) -> Number:
        parameters, member = case
        realised = kaji_ochiai.realise(mp, _projected(parameters, space))
        found = kaji_ochiai.parametrise(mp, member)
        return max(outside(realised, CLASSES[name]), difference(_projected(found, space), found))

    return deviation


def _cases(name: str) -> Any:
    return lambda: list(zip(arrays("subspaces", 4, (12,), -2, 2), members(CLASSES[name], 4), strict=True))


def _claim(name: str, place: str, printed: str, change: str, **other: Any) -> Claim[Any, Any]:
    own = CLASSES[name]
    return Claim(
        id=f"kaji_ochiai.3.subspace.{place}",
        place="section 3, condition (V)",
        statement=f"φ takes this subspace onto {name}, and ψ takes {name} into it.",
        printed=f"V_{place} = {printed}",
        verdict=Verdict.CONFIRMED,
        form=own,
        cases=_cases(name),
        deviation=_mismatch(name),
        copies=(Copy(change, replace(own, **other)),),
    )


CLAIMS: tuple[Claim[Any, Any], ...] = (
    _claim("Sim+(3)", "Sim+(3)", "{(L, X, c I)}", "c = 0", stretch=NONE),
    _claim("GL+(3)", "GL+(3)", "{(I, X, Y)}", "Y = c I", stretch=UNIFORM),
    _claim("SE(3)", "SE(3)", "{(L, X, 0)}", "c I for 0", stretch=UNIFORM),
    _claim("CO+(3)", "CO+(3)", "{(I, X, c I)}", "any Y", stretch=ANY),
    _claim("Sym+(3)", "Sym+(3)", "{(I, 0, Y)}", "X for 0", turns=True),
    _claim("R^3", "R^3", "{(L, 0, 0)}", "I for L", moves=False),
    _claim("SO(3)", "SO(3)", "{(I, X, 0)}", "L for I", moves=True),
    _claim("R+", "R+", "{(I, 0, c I)}", "any Y", stretch=ANY),
)
